// File ▸ Export Timelapse…: films of every kind, mistakes, and a film that is stopped.
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/timelapse_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/look/section.h"
#include "tests/app/file_dialogs.h"
#include "tests/app/selecting.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

using namespace suffuse;

class TestTimelapseDialog : public QObject {
    Q_OBJECT

    static void fill(Editor &editor)
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = 80;
        painting->canvas.height = 60;
        for (const int i : {1, 2}) {
            auto stroke = std::make_shared<Stroke>(*line(StrokeId(i), {10, 20.0 * i}, {70, 20.0 * i}));
            for (Segment &segment : stroke->segments)
                segment.colour = {1, 0, 0, 1};
            painting->strokes.push_back(std::move(stroke));
        }
        editor.document().reset(painting);
    }
    QStringList files() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
    void clear()
    {
        for (const QString &name : files())
            QDir(m_folder.path()).remove(name);
    }

private slots:
    void initTestCase() { qputenv("SUFFUSE_SETTINGS", QDir(m_settings.path()).filePath("settings.ini").toLocal8Bit()); }

    void init() { settings::store().clear(); }

    /// Who makes a film twice says once what it is to be.
    void theLastFilmIsRemembered()
    {
        Editor editor;
        fill(editor);
        {
            TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
            dialog.show();
            dialog.path()->setText(m_folder.filePath("f.png"));
            dialog.fps()->setValue(5);
            dialog.length()->setValue(0.4);
            dialog.idle()->setValue(3);
            dialog.widthBox()->setValue(40);
            dialog.exportButton()->click();
            QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
            QCOMPARE(dialog.result(), int(QDialog::Accepted));
            clear();
        }
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        QVERIFY(dialog.path()->text().endsWith(".png"));
        QCOMPARE(dialog.fps()->value(), 5.0);
        QCOMPARE(dialog.length()->value(), 0.4);
        QCOMPARE(dialog.idle()->value(), 3.0);
        QCOMPARE(dialog.widthBox()->value(), 40);
        QCOMPARE(dialog.heightBox()->value(), 30);
        dialog.fps()->setValue(7); // a film that is not made leaves nothing behind
        dialog.reject();
        QCOMPARE(TimelapseDialog(editor, Rect::of(0, 0, 40, 30)).fps()->value(), 5.0);
    }

    /// The decimal sign of another language is one here, as in all other fields.
    void numbersAreReadInEveryLanguage()
    {
        const QLocale before;
        for (const QLocale::Language language : {QLocale::English, QLocale::German}) {
            QLocale::setDefault(language);
            Editor editor;
            fill(editor);
            TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
            dialog.show();
            for (const char *typed : {"12.5", "12,5", "12,5 frames/s", "25/2"}) {
                dialog.fps()->setValue(30);
                dialog.fps()->setFocus();
                dialog.fps()->selectAll();
                QTest::keyClicks(dialog.fps(), typed);
                QTest::keyClick(dialog.fps(), Qt::Key_Tab);
                QCOMPARE(dialog.fps()->value(), 12.5);
            }
            dialog.fps()->selectAll();
            QTest::keyClicks(dialog.fps(), "many");
            QTest::keyClick(dialog.fps(), Qt::Key_Tab);
            QCOMPARE(dialog.fps()->value(), 12.5);
        }
        QLocale::setDefault(before);
    }

    /// A name with an ending of no film is refused when it is typed, not only when the film is to be made.
    void anEndingOfNoFilmIsRefusedAtOnce()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        const auto typeName = [&](const char *name) {
            dialog.path()->setFocus();
            dialog.path()->selectAll();
            QTest::keyClicks(dialog.path(), m_folder.filePath(name));
            QTest::keyClick(dialog.path(), Qt::Key_Tab);
        };
        for (const char *name : {"film.gif", "film", "film%04d.gif"}) {
            typeName(name);
            QVERIFY2(dialog.hint()->text().startsWith(QString("“%1” has no ending").arg(name)),
                     qPrintable(dialog.hint()->text()));
            QVERIFY(dialog.hint()->text().contains("webm") && dialog.hint()->text().contains("png"));
            QCOMPARE(dialog.hint()->text().count("webp"), 1);
        }
        for (const char *name : {"film.webm", "film.PNG", "film%04d.jpg", "film.webp"}) {
            typeName(name);
            QCOMPARE(dialog.hint()->text(), QString());
        }
        dialog.path()->setText(m_folder.filePath("film.gif"));
        dialog.exportButton()->click();
        QVERIFY(dialog.hint()->text().startsWith("“film.gif” has no ending"));
        QVERIFY(!dialog.isExporting());
    }

    void browsingAppendsTheEnding()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        QPushButton *browse = nullptr;
        for (auto *button : dialog.findChildren<QPushButton *>())
            if (button->text().remove('&').startsWith("Browse"))
                browse = button;
        QVERIFY(browse);
        dialog.path()->setText(m_folder.filePath("film.webp"));
        int answered = 0;
        for (const auto &[name, wanted] :
             {std::pair("film v1.0", "film v1.0.webp"), {"22.11.2026", "22.11.2026.webp"}, {"f.png", "f.png"}}) {
            whenAskedForFile(&dialog, answered, m_folder.filePath(name));
            browse->click();
            QCOMPARE(dialog.path()->text(), m_folder.filePath(wanted));
        }
        QCOMPARE(answered, 3);
    }

    void makesFilms_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("expected");
        QTest::newRow("WebP") << "film.webp" << QStringList{"film.webp"};
        QTest::newRow("frames") << "f.png" << QStringList{"f0001.png", "f0002.png", "f0003.png", "f0004.png"};
        QTest::newRow("numbered") << "%d.pfm" << QStringList{"1.pfm", "2.pfm", "3.pfm", "4.pfm"};
    }

    void makesFilms()
    {
        QFETCH(QString, name);
        QFETCH(QStringList, expected);
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        QCOMPARE(dialog.widthBox()->value(), 80);
        QCOMPARE(dialog.heightBox()->value(), 60);
        dialog.path()->setText(m_folder.filePath(name));
        dialog.fps()->setValue(4);
        dialog.length()->setValue(1);
        QVERIFY2(dialog.progressText()->text().startsWith("4 frames"), qPrintable(dialog.progressText()->text()));
        QCOMPARE(dialog.loops()->isEnabled(), name.endsWith("webp"));
        dialog.exportButton()->click();
        QVERIFY(dialog.isExporting());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QCOMPARE(files(), expected);
        if (name.endsWith("png")) {
            const QImage last(m_folder.filePath("f0004.png"));
            QCOMPARE(last.size(), QSize(80, 60));
            QVERIFY(last.pixel(40, 20) != last.pixel(0, 59));
        }
        clear();
    }

    void rateIsThatOfTheCommandLine()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 80, 60));
        QCOMPARE(dialog.fps()->value(), FilmOptions{}.fps);
    }

    /// Pictures are not proposed to lie among the frames of a film, nor the other way round.
    void filmsHaveAFolderOfTheirOwn()
    {
        Editor editor;
        fill(editor);
        QTemporaryDir films;
        settings::store().setValue("filmFolder", films.path());
        TimelapseDialog film(editor, Rect::of(0, 0, 40, 30));
        ExportDialog picture(editor, Rect::of(0, 0, 40, 30));
        QVERIFY(film.path()->text().startsWith(films.path()));
        QVERIFY(!picture.path()->text().startsWith(films.path()));
        settings::store().remove("filmFolder");
    }

    void areasSetTheSize()
    {
        Editor editor;
        fill(editor);
        editor.document().setSelection({{1}, {}});
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 10));
        using enum AreaRow::Choice;
        QCOMPARE(dialog.area()->box()->count(), 5);
        dialog.area()->choose(Shown);
        QCOMPARE(dialog.heightBox()->value(), dialog.widthBox()->value() / 4);
        dialog.widthBox()->setValue(400);
        QCOMPARE(dialog.heightBox()->value(), 100);
        dialog.area()->choose(Selected);
        QVERIFY(dialog.widthBox()->value() > dialog.heightBox()->value());
        dialog.area()->numbers()[3]->setValue(1000);
        QCOMPARE(dialog.area()->choice(), Numbers);
        QVERIFY(dialog.widthBox()->value() < dialog.heightBox()->value());
    }

    void filmsTheArea()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        const double numbers[] = {20, 10, 40, 20};
        for (std::size_t i = 0; i < 4; ++i)
            dialog.area()->numbers()[i]->setValue(numbers[i]);
        dialog.widthBox()->setValue(40);
        QCOMPARE(dialog.heightBox()->value(), 20);
        dialog.path()->setText(m_folder.filePath("f.png"));
        dialog.fps()->setValue(2);
        dialog.length()->setValue(1);
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const QImage last(m_folder.filePath("f0002.png"));
        QCOMPARE(last.size(), QSize(40, 20));
        QVERIFY(last.pixel(20, 10) != last.pixel(20, 19)); // a stroke lies across its middle
        clear();
    }

    void mistakesAreShown()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        for (const auto &[name, transparent, says] :
             {std::tuple{"film.txt", false, "has no ending"}, std::tuple{"film%d%d.png", false, "Frames are numbered"},
              std::tuple{"film.mp4", true, "WebM"}, std::tuple{"f.jpg", true, "JPEG"}}) {
            dialog.path()->setText(m_folder.filePath(name));
            dialog.transparent()->setChecked(transparent);
            dialog.exportButton()->click();
            QVERIFY(!dialog.isExporting());
            QVERIFY2(dialog.hint()->text().contains(says), qPrintable(dialog.hint()->text()));
        }
        dialog.transparent()->setChecked(false);
        dialog.path()->setText(m_folder.filePath("nowhere/film.webp"));
        QCOMPARE(dialog.hint()->text(), QString());
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        QVERIFY2(dialog.hint()->text().contains("nowhere"), qPrintable(dialog.hint()->text()));
        QCOMPARE(files(), QStringList());
    }

    void cancelLeavesNothing()
    {
        Editor editor;
        fill(editor);
        TimelapseDialog dialog(editor, Rect::of(0, 0, 40, 30));
        dialog.show();
        dialog.path()->setText(m_folder.filePath("film.webp"));
        dialog.length()->setValue(3600);
        dialog.exportButton()->click();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.progressText()->text().contains("Frame "), waitMs);
        dialog.reject(); // stops the work, the dialog stays
        QVERIFY(dialog.isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isExporting(), waitMs);
        QCOMPARE(files(), QStringList());
        QVERIFY(dialog.exportButton()->isEnabled());
        dialog.reject();
        QVERIFY(!dialog.isVisible());
    }

private:
    QTemporaryDir m_folder, m_settings;
};

QTEST_MAIN(TestTimelapseDialog)
#include "test_timelapse_dialog.moc"

// The welcome page: when it comes, what it offers, and what a choice does. And the card of a lesson in the window.
#include "app/dialogs/sheet_presets.h"
#include "app/dialogs/welcome/welcome_dialog.h"
#include "app/session/files/samples.h"
#include "app/session/settings/greeting.h"
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/window/welcome/lesson_card.h"
#include "app/window/welcome/welcoming.h"
#include "model/formats/files.h"
#include "tests/app/session.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTranslator>

using namespace suffuse;

namespace {

Welcoming &welcomingOf(Session &s)
{
    return *s.window.findChild<Welcoming *>();
}

WelcomeDialog *pageOf(const Session &s)
{
    return s.window.findChild<WelcomeDialog *>();
}

QListWidgetItem *rowOf(const QListWidget &list, const QString &text)
{
    for (int i = 0; i < list.count(); ++i)
        if (list.item(i)->text().startsWith(text))
            return list.item(i);
    return nullptr;
}

} // namespace

class TestWelcome : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// Only where nothing was begun, and where people want it.
    void greetsOnce()
    {
        Session s;
        QVERIFY(!pageOf(s)); // A window by itself greets nobody.
        s.window.greet();
        QVERIFY(pageOf(s) && pageOf(s)->isVisible());
        QVERIFY(!pageOf(s)->isModal());
        pageOf(s)->atStart()->setChecked(false);
        QVERIFY(!settings::welcomes());
        pageOf(s)->reject();
        QTRY_VERIFY(!pageOf(s));
        s.window.greet();
        QVERIFY(!pageOf(s));
        settings::setWelcomes(true);
        s.paintLine({100, 100}, {300, 120});
        s.window.greet();
        QVERIFY(!pageOf(s));
        s.use(Command::Welcome); // Asked for, it comes.
        QVERIFY(pageOf(s));
        QVERIFY(pageOf(s)->atStart()->isChecked());
    }

    void aSheetIsTaken()
    {
        Session s;
        s.use(Command::Welcome);
        QListWidget &sheets = *pageOf(s)->sheets();
        QListWidgetItem *a4 = rowOf(sheets, "A4\n");
        QVERIFY(a4 && a4->text().contains("297 × 210 mm") && a4->text().contains("11.7 × 8.3 in"));
        QListWidgetItem *heading = sheets.item(0);
        emit sheets.itemClicked(heading); // no sheet
        QVERIFY(pageOf(s)->isVisible());
        emit sheets.itemClicked(a4);
        QCOMPARE(s.painting().canvas.width, 1754.0);
        QCOMPARE(s.painting().canvas.height, 1240.0);
        QCOMPARE(s.editor().extras().resolution, 150.0);
        QTRY_VERIFY(!pageOf(s));
        s.use(Command::Welcome);
        emit pageOf(s)->sheets()->itemActivated(rowOf(*pageOf(s)->sheets(), "Night"));
        QVERIFY(s.painting().canvas.background.blue > 0.9f);
        QCOMPARE(s.editor().extras().resolution, 0.0);
        for (const SheetPreset &preset : sheetPresets())
            QVERIFY2(!preset.name.isEmpty() && preset.canvas.width > 0 && preset.canvas.height > 0,
                     qPrintable(preset.name));
    }

    void paintingsHaveTheirPictures()
    {
        const QStringList samples = sampleFiles();
        QVERIFY(samples.size() > 3);
        const QString recent = m_folder.filePath("kept.suffuse");
        {
            Session painted;
            painted.paintLine({100, 100}, {900, 600});
            QVERIFY(painted.window.saveTo(recent));
        }
        settings::addRecentFile(recent);
        Session s;
        s.use(Command::Welcome);
        QListWidget &list = *pageOf(s)->paintings();
        QListWidgetItem *row = rowOf(list, "kept");
        QListWidgetItem *sample = rowOf(list, sampleTitle(samples.back()));
        QVERIFY(row && sample);
        const QImage kept = keptPreview(recent);
        QVERIFY(!kept.isNull() && std::max(kept.width(), kept.height()) <= 256);
        for (const QListWidgetItem *item : {row, sample}) // the sample's is drawn
            QTRY_VERIFY_WITH_TIMEOUT(item->icon().pixmap(84, 60).toImage().pixelColor(42, 30).alpha() > 0, waitMs);
        emit list.itemClicked(row);
        QCOMPARE(s.editor().filePath(), recent);
    }

    /// Files of samples have English names, and so have the papers of printers; people read neither.
    void samplesAndPapersHaveNamesInEachLanguage()
    {
        QStringList english;
        const auto titles = [] {
            QStringList all;
            for (const QString &sample : sampleFiles())
                all << sampleTitle(sample);
            for (const char *paper : {"Letter", "Legal", "Tabloid"})
                all << paperTitle(QLatin1String(paper));
            return all;
        };
        english = titles();
        for (const QString &sample : sampleFiles())
            QVERIFY2(sampleTitle(sample) != QFileInfo(sample).completeBaseName(), qPrintable(sample));
        QCOMPARE(paperTitle("A4"), QString("A4"));
        for (const QString &code : translationCodes()) {
            if (code == "en")
                continue;
            QTranslator words;
            QVERIFY2(words.load(":/i18n/suffuse_" + code + ".qm"), qPrintable(code));
            QCoreApplication::installTranslator(&words);
            const QStringList translated = titles();
            QCoreApplication::removeTranslator(&words);
            for (qsizetype i = 0; i < english.size(); ++i)
                QVERIFY2(translated[i] != english[i], qPrintable(code + ": " + english[i]));
        }
    }

    /// What came with the program is not replaced by saving, and is not what one worked on last.
    void aSampleOpensUntitled()
    {
        const QStringList recent = settings::recentFiles();
        const QString sample = sampleFiles().front();
        Session s;
        QVERIFY(s.window.openFile(sample));
        QVERIFY(!s.editor().document().painting()->strokes.empty());
        QVERIFY(s.editor().filePath().isEmpty());
        QVERIFY(s.window.windowTitle().contains(sampleTitle(sample)));
        QCOMPARE(settings::recentFiles(), recent);
    }

    void previewsOfOtherFilesAreNone()
    {
        const QString path = m_folder.filePath("none.suffuse");
        for (const QByteArray &bytes : {QByteArray(), QByteArray("\x89SUFFUSE\r\n\x1a\n"), QByteArray(5000, 'x'),
                                        QByteArray("\x89SUFFUSE\r\n\x1a\nprev\xff\xff\xff\xff")}) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(bytes) == bytes.size());
            file.close();
            QVERIFY(keptPreview(path).isNull());
        }
        QVERIFY(keptPreview(m_folder.path()).isNull());
        QVERIFY(keptPreview("/dev/zero").isNull());
        QVERIFY(keptPreview(m_folder.filePath("missing")).isNull());
    }

    /// It points at where the step is done, goes on by what is painted, and goes when it is left.
    void aLessonIsDoneInTheWindow()
    {
        Session s;
        Welcoming &welcoming = welcomingOf(s);
        welcoming.begin(LessonKind::Change);
        QVERIFY(welcoming.card() && welcoming.card()->isVisible());
        QCOMPARE(welcoming.card()->target(), &s.canvas());
        const QString first = welcoming.card()->text()->text();
        s.paintLine({100, 100}, {400, 160});
        QTRY_VERIFY(welcoming.card()->text()->text() != first);
        if (s.selection().strokes.empty()) {
            s.use(Command::Select);
            s.dry();
            s.click({250, 130});
        }
        auto *colours = s.window.findChild<QDockWidget *>("colourDock");
        QTRY_COMPARE(welcoming.card()->target(), colours);
        QVERIFY(s.window.rect().contains(welcoming.card()->geometry()));
        QVERIFY(!welcoming.card()->geometry().intersects(QRect(colours->mapTo(&s.window, QPoint()), colours->size())));
        welcoming.card()->leave()->click();
        QTRY_VERIFY(!welcoming.card());
        welcoming.begin(LessonKind::Layers);
        s.editor().newPainting(Editor::usualCanvas()); // Another painting is no lesson.
        QVERIFY(!welcoming.card());
    }

    /// Whoever has begun a painting of his own practises on another sheet.
    void aLessonLeavesOnesOwnPaintingAlone()
    {
        Session s;
        const auto choose = [&](int number) {
            s.use(Command::Welcome);
            const QString title = titleOf(lessonKinds[number]);
            for (QPushButton *button : pageOf(s)->findChildren<QPushButton *>())
                if (button->text().remove('&') == title)
                    return button->click();
            QFAIL(qPrintable(title));
        };
        const auto others = [&] {
            QList<MainWindow *> found;
            for (QWidget *widget : QApplication::topLevelWidgets())
                if (auto *window = qobject_cast<MainWindow *>(widget); window && window != &s.window)
                    found.append(window);
            return found;
        };
        choose(0);
        QVERIFY(welcomingOf(s).card()); // Nothing was begun: here.
        QVERIFY(others().isEmpty());
        s.paintLine({100, 100}, {400, 160});
        const PaintingPtr own = s.editor().document().snapshot();
        choose(1);
        QCOMPARE(others().size(), 1);
        MainWindow &practice = *others().front();
        QVERIFY(practice.isVisible() && practice.findChild<Welcoming *>()->card());
        QVERIFY(practice.editor().document().painting()->strokes.empty());
        QVERIFY(practice.editor().filePath().isEmpty());
        QCOMPARE(*s.editor().document().painting(), *own);
        delete &practice;
    }

    /// A double click on a window that the first click closes paints nothing in the window below.
    void aSecondClickOnWhatWasClosedIsNone()
    {
        Session s;
        s.use(Command::Brush);
        const auto send = [](QWidget &widget, QEvent::Type type, QPoint at, Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, widget.mapToGlobal(at), Qt::LeftButton, buttons, {});
            QApplication::sendEvent(&widget, &event);
        };
        const auto clickTwice = [&](QWidget &first) {
            send(first, QEvent::MouseButtonPress, {20, 20}, Qt::LeftButton);
            send(first, QEvent::MouseButtonRelease, {20, 20}, {});
            send(s.canvas(), QEvent::MouseButtonDblClick, s.at({300, 200}), Qt::LeftButton);
            send(s.canvas(), QEvent::MouseButtonRelease, s.at({300, 200}), {});
        };
        clickTwice(s.canvas());
        const std::size_t painted = s.painting().strokes.size();
        QVERIFY(painted > 0); // whoever dabs quickly paints each time
        {
            QDialog page(&s.window);
            page.show();
            clickTwice(page);
        }
        QCOMPARE(s.painting().strokes.size(), painted);
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, s.at({300, 200}));
        QCOMPARE(s.painting().strokes.size(), painted + 1);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWelcome)
#include "test_welcome.moc"

// What an export keeps: presets, and File ▸ Export Again.
#include "app/dialogs/export/export_dialog.h"
#include "app/dialogs/export/preset_row.h"
#include "app/dialogs/export/print_rows.h"
#include "app/window/main_window.h"
#include "tests/app/panel_bench.h"
#include "tests/files.h"

#include <QComboBox>
#include <QJsonArray>
#include <QJsonObject>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>

#include <cmath>

using namespace suffuse;

namespace {

const Rect shown = Rect::of(40, 80, 100, 50);

} // namespace

class TestKeptExports : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder->filePath("settings.ini").toUtf8());
    }

    void settingsAreReadWithCare()
    {
        ExportSettings settings;
        settings.path = "/a/b.png";
        settings.numbers = Rect::of(1, 2, 3, 4);
        QVERIFY(ExportSettings::fromJson(settings.toJson()) == settings);
        QVERIFY(!ExportSettings::fromJson({}));
        for (const auto &[key, value] :
             std::initializer_list<std::pair<const char *, QJsonValue>>{{"path", "a.doc"},
                                                                        {"quality", 101},
                                                                        {"dpi", 0},
                                                                        {"area", 9},
                                                                        {"moment", -1},
                                                                        {"width", 0},
                                                                        {"scale", -1.0},
                                                                        {"numbers", QJsonArray{0, 0, 0, 0}}}) {
            QJsonObject object = settings.toJson();
            object[key] = value;
            QVERIFY2(!ExportSettings::fromJson(object), key);
        }
        for (int i = 0; i < 60; ++i)
            exports::remember(QStringLiteral("/paintings/%1.suffuse").arg(i), settings);
        int kept = 0;
        for (int i = 0; i < 60; ++i)
            kept += exports::lastOf(QStringLiteral("/paintings/%1.suffuse").arg(i)).has_value();
        QCOMPARE(kept, 50);
    }

    void presets()
    {
        Bench bench;
        ExportDialog dialog(bench.editor, shown);
        dialog.show();
        QVERIFY(!dialog.presets()->removeButton()->isEnabled());
        dialog.path()->setText(m_folder->filePath("a.jpg"));
        dialog.quality()->setValue(71);
        dialog.widthBox()->setValue(500);
        dialog.print()->dpiBox()->setValue(96);
        dialog.presets()->saveAs("Web/ü");
        QCOMPARE(dialog.presets()->box()->currentText(), QString("Web/ü"));
        dialog.path()->setText(m_folder->filePath("b.png"));
        dialog.widthBox()->setValue(2000);
        dialog.presets()->saveAs("Large");

        ExportDialog next(bench.editor, shown);
        QComboBox &box = *next.presets()->box();
        QCOMPARE(box.count(), 2);
        QCOMPARE(box.currentIndex(), -1);
        next.path()->setText(m_folder->filePath("v1.0 sky.png"));
        box.setCurrentIndex(box.findText("Web/ü"));
        emit box.activated(box.currentIndex());
        QCOMPARE(next.path()->text(), m_folder->filePath("v1.0 sky.jpg"));
        QCOMPARE(next.quality()->value(), 71);
        QCOMPARE(next.widthBox()->value(), 500);
        QCOMPARE(next.print()->dpi(), 96.0);
        QVERIFY(next.presets()->removeButton()->isEnabled());
        next.presets()->removeButton()->click();
        QCOMPARE(exports::presets(), QStringList("Large"));
        QCOMPARE(box.count(), 1);
    }

    /// A dialog that comes up with what a preset made shows that preset.
    void presetOfTheLastExport()
    {
        Bench bench;
        QVERIFY(savePainting(*bench.editor.document().painting(), m_folder->filePath("again.suffuse")));
        QVERIFY(bench.editor.open(m_folder->filePath("again.suffuse")));
        ExportDialog dialog(bench.editor, shown);
        dialog.path()->setText(m_folder->filePath("a.jpg"));
        dialog.quality()->setValue(71);
        dialog.widthBox()->setValue(500);
        dialog.presets()->saveAs("Web");
        dialog.path()->setText(m_folder->filePath("a.png"));
        dialog.widthBox()->setValue(800);
        dialog.presets()->saveAs("Large");
        const QString file = bench.editor.filePath();
        exports::remember(file, *exports::preset("Web"));

        ExportDialog next(bench.editor, shown);
        QCOMPARE(next.widthBox()->value(), 500);
        QCOMPARE(next.presets()->box()->currentText(), QString("Web"));
        QVERIFY(next.presets()->removeButton()->isEnabled());
        ExportSettings other = *exports::preset("Web");
        other.quality = 70;
        exports::remember(file, other);
        ExportDialog last(bench.editor, shown);
        QCOMPARE(last.quality()->value(), 70);
        QCOMPARE(last.presets()->box()->currentIndex(), -1);
    }

    void exportAgain()
    {
        MainWindow window;
        window.show();
        auto painting = std::make_shared<Painting>();
        painting->strokes.push_back(makeStroke(1, 4, 10));
        window.editor().document().reset(painting);
        const QString picture = m_folder->filePath("again.png");
        const auto inDialog = [&](const std::function<void(ExportDialog &)> &work, Command command) {
            bool done = false;
            QTimer::singleShot(0, &window, [&] {
                auto *dialog = qobject_cast<ExportDialog *>(QApplication::activeModalWidget());
                if (!dialog)
                    return;
                work(*dialog);
                done = true;
            });
            window.action(command).trigger();
            return done;
        };
        // Nothing was exported yet: it asks.
        QVERIFY(inDialog(
            [&](ExportDialog &dialog) {
                dialog.path()->setText(picture);
                dialog.widthBox()->setValue(80);
                dialog.exportButton()->click();
            },
            Command::ExportAgain));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(picture), 20000);
        QVERIFY(window.statusBar()->currentMessage().contains("again.png"));
        window.statusBar()->clearMessage();
        const QByteArray before = bytesOf(picture);
        auto more = std::make_shared<Painting>(*painting);
        more->canvas.background = {1, 0, 0, 1};
        window.editor().document().reset(more);
        window.action(Command::ExportAgain).trigger();
        QVERIFY(!QApplication::activeModalWidget());
        QTRY_VERIFY_WITH_TIMEOUT(window.statusBar()->currentMessage().contains("again.png") &&
                                     window.action(Command::ExportAgain).isEnabled(),
                                 20000);
        const QByteArray after = bytesOf(picture);
        QVERIFY(after != before);
        QCOMPARE(after.mid(16, 8), before.mid(16, 8)); // of the same size
        QVERIFY(inDialog(                              // and the dialog begins with it
            [&](ExportDialog &dialog) {
                QCOMPARE(dialog.path()->text(), picture);
                QCOMPARE(dialog.widthBox()->value(), 80);
                dialog.reject();
            },
            Command::Export));
    }

    /// As it was exported last, in whatever session that was.
    void exportAgainAfterOpening()
    {
        Painting painting;
        painting.strokes.push_back(makeStroke(1, 4, 10));
        const QString file = m_folder->filePath("a.suffuse"), picture = m_folder->filePath("of a.png");
        QVERIFY(savePainting(painting, file));
        ExportSettings settings;
        settings.path = picture;
        settings.scale = 64 / painting.canvas.width;
        settings.numbers = painting.canvas.area();
        exports::remember(file, settings);
        MainWindow window;
        window.show();
        QVERIFY(window.openFile(file));
        bool isAsked = false;
        QTimer::singleShot(0, &window, [&] {
            if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
                isAsked = true;
                dialog->reject();
            }
        });
        window.action(Command::ExportAgain).trigger();
        QVERIFY(!isAsked);
        QTRY_VERIFY_WITH_TIMEOUT(window.statusBar()->currentMessage().contains("of a.png") &&
                                     window.action(Command::ExportAgain).isEnabled(),
                                 20000);
        QCOMPARE(QImage(picture).width(), 64);
    }

    void namedAreasAreLookedUpAnew()
    {
        Bench bench;
        ExportSettings settings;
        settings.path = "/a/b.png";
        settings.area = AreaRow::Choice::Selected;
        settings.scale = 2;
        const Result<ExportOrder> nothing = exportOrder(settings, bench.editor, shown);
        QVERIFY(!nothing);
        QVERIFY2(nothing.error().contains("selected"), qPrintable(nothing.error()));
        bench.select({2});
        const Result<ExportOrder> order = exportOrder(settings, bench.editor, shown);
        QVERIFY(order);
        QCOMPARE(order->width, int(std::round(2 * order->area.width())));
        QCOMPARE(order->height, heightForWidth(order->area, order->width));
        settings.scale = 1e6;
        QVERIFY(!exportOrder(settings, bench.editor, shown)); // the limit holds here, too
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(TestKeptExports)
#include "test_kept_exports.moc"

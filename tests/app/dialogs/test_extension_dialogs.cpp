// Extensions in the window: the menu, the dialog that their manifests describe, one step, and the manager.
#include "app/dialogs/extensions/extension_dialog.h"
#include "app/dialogs/extensions/extension_fields.h"
#include "app/dialogs/extensions/manage_extensions_dialog.h"
#include "app/session/extensions/extension_library.h"
#include "app/session/settings/settings.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/decimal_box.h"
#include "app/window/palette_entries.h"
#include "tests/app/session.h"
#include "tests/session/extensions/extension_folder.h"

#include <QCheckBox>
#include <QComboBox>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

using namespace suffuse;

namespace {

/// Gives all strokes the density that the field says.
const QByteArray densifying =
    "sed 's/\"density\": *[0-9.]*/\"density\": '$SUFFUSE_VALUE_density'/g' \"$SUFFUSE_PAINTING\" > "
    "\"$SUFFUSE_RESULT\"\necho 'say: All of it is denser.' >&2\n";
const QByteArray densityField = R"(, "menu": ["Tests"], "fields": [
 {"type": "number", "id": "density", "label": "Density", "unit": "units", "least": 1, "most": 50, "default": 5, "decimals": 1}])";
const QByteArray everyField = R"(, "fields": [
 {"type": "number", "id": "gap", "label": "Gap", "unit": "mm", "least": 0.5, "most": 50, "default": 4.25, "decimals": 1, "tip": "Between"},
 {"type": "whole", "id": "count", "label": "Count", "least": 1, "most": 9, "default": 3},
 {"type": "choice", "id": "kind", "label": "Kind", "default": "b",
  "choices": [{"id": "a", "label": "First"}, {"id": "b", "label": "Second"}]},
 {"type": "switch", "id": "on", "label": "On", "default": true},
 {"type": "text", "id": "words", "label": "Words", "default": "hello"},
 {"type": "colour", "id": "paint", "label": "Paint", "default": [0, 0.5, 1, 1]},
 {"type": "file", "id": "target", "label": "File", "mode": "save", "endings": ["txt"]}])";

QAction *entry(Session &s, const QString &id)
{
    for (const QMenu *menu : s.window.menuBar()->findChildren<QMenu *>())
        for (QAction *action : menu->actions())
            if (action->objectName() == "extension." + id)
                return action;
    return nullptr;
}

/// Does something with the dialog that is open, when it is.
void withDialog(Session &s, const std::function<void(ExtensionDialog &)> &use)
{
    QTimer::singleShot(0, &s.window, [use] {
        if (auto *dialog = qobject_cast<ExtensionDialog *>(QApplication::activeModalWidget()))
            use(*dialog);
    });
}

} // namespace

class TestExtensionDialogs : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        writeExtension(ownExtensionsFolder(), "denser", densifying, densityField);
        writeExtension(ownExtensionsFolder(), "every", "exit 0", everyField);
        writeExtension(ownExtensionsFolder(), "failing", "echo 'error: No paint is left.' >&2; exit 1");
        writeExtension(ownExtensionsFolder(), "hanging",
                       "echo 'progress: 0.25 waiting' >&2; while :; do sleep 1000; done");
        put(writeExtension(ownExtensionsFolder(), "broken", "exit 0") + "/manifest.json", R"({"format": "other"})");
        ExtensionLibrary::instance().reload();
    }

    /// In the submenus that their manifests name, and in the palette under the same.
    void theMenuAndThePaletteHaveThem()
    {
        Session s;
        for (const char *id : {"jitter", "hatch", "kaleidoscope", "recolour-palette", "contact-sheet", "denser"}) {
            const QAction *action = entry(s, id);
            QVERIFY2(action, id);
            const auto entries = s.window.paletteEntries();
            const auto found = std::ranges::find(entries, "extension." + QString(id), &PaletteEntry::id);
            QVERIFY2(found != entries.end(), id);
            QVERIFY2(found->title.startsWith("Extensions ▸ "), qPrintable(found->title));
        }
        const auto entries = s.window.paletteEntries();
        const auto hatch = std::ranges::find(entries, QString("extension.hatch"), &PaletteEntry::id);
        QCOMPARE(hatch->title, "Extensions ▸ Areas ▸ Hatch an Area");
        QVERIFY(paletteRank(*hatch, "hatch"));
        QVERIFY(!entry(s, "broken"));
    }

    void theDialogHasTheFields()
    {
        Session s;
        ExtensionDialog dialog(s.editor(), *ExtensionLibrary::instance().usable("every"), &s.window);
        const ExtensionFields &fields = dialog.fields();
        auto *gap = qobject_cast<DecimalBox *>(fields.field("gap"));
        auto *count = qobject_cast<WholeBox *>(fields.field("count"));
        auto *kind = qobject_cast<QComboBox *>(fields.field("kind"));
        auto *on = qobject_cast<QCheckBox *>(fields.field("on"));
        auto *words = qobject_cast<QLineEdit *>(fields.field("words"));
        auto *paint = qobject_cast<ColourRows *>(fields.field("paint"));
        auto *target = qobject_cast<QLineEdit *>(fields.field("target"));
        QVERIFY(gap && count && kind && on && words && paint && target);
        QCOMPARE(gap->minimum(), 0.5);
        QCOMPARE(gap->maximum(), 50.0);
        QCOMPARE(gap->suffix(), " mm");
        QCOMPARE(gap->toolTip(), "Between");
        QCOMPARE(gap->accessibleName(), "Gap");
        QCOMPARE(kind->currentText(), "Second");
        QCOMPARE(fields.values()["gap"], QJsonValue(4.25)); // it shows one decimal, and keeps what it was
        QCOMPARE(fields.values()["paint"], QJsonValue(QJsonArray{0.0, 0.5, 1.0, 1.0}));
        gap->setValue(7.5);
        count->setValue(9);
        kind->setCurrentIndex(0);
        on->setChecked(false);
        words->setText("other");
        emit paint->edited(ColourRows::Red, 0.25, nullptr);
        const QString path = m_folder.filePath("out.txt");
        target->setText(path);
        const QJsonObject expected{{"gap", 7.5},    {"count", 9},       {"kind", "a"},
                                   {"on", false},   {"words", "other"}, {"paint", QJsonArray{0.25, 0.5, 1.0, 1.0}},
                                   {"target", path}};
        QCOMPARE(fields.values(), expected);
    }

    /// A file that must be chosen is asked for, and nothing runs.
    void aMissingFileIsAskedFor()
    {
        Session s;
        ExtensionDialog dialog(s.editor(), *ExtensionLibrary::instance().usable("every"), &s.window);
        dialog.run();
        QVERIFY(!dialog.isRunning());
        QCOMPARE(dialog.hint()->text(), "File: choose a file");
        qobject_cast<QLineEdit *>(dialog.fields().field("target"))->setText("x.txt");
        QVERIFY(dialog.hint()->text().isEmpty());
    }

    /// By the menu, with a value, as one step that is named after it; then once more without asking; and undone.
    void runningItIsOneStep()
    {
        Session s;
        s.paintLine({100, 100}, {300, 140});
        s.dry();
        const QByteArray hash = hashOf(s.painting());
        const int steps = s.editor().undoStack().count();
        const auto density = [&] { return s.painting().strokes.front()->segments.front().density; };
        QVERIFY(!ExtensionLibrary::instance().last().isEmpty() ||
                !s.window.action(Command::RepeatExtension).isEnabled());
        withDialog(s, [](ExtensionDialog &dialog) {
            qobject_cast<DecimalBox *>(dialog.fields().field("density"))->setValue(12.5);
            dialog.runButton()->click();
        });
        entry(s, "denser")->trigger();
        QCOMPARE(density(), 12.5f);
        QCOMPARE(s.editor().undoStack().count(), steps + 1);
        QCOMPARE(s.editor().undoText(), "Test denser");
        QVERIFY(ExtensionLibrary::instance().lastRun("denser").startsWith("It went well."));
        s.use(Command::Undo);
        QCOMPARE(hashOf(s.painting()), hash);
        QVERIFY(s.window.action(Command::RepeatExtension).isEnabled());
        s.use(Command::RepeatExtension); // the value was kept
        QCOMPARE(density(), 12.5f);
        QCOMPARE(s.editor().undoStack().count(), steps + 1);
        withDialog(s, [](ExtensionDialog &dialog) {
            QCOMPARE(qobject_cast<DecimalBox *>(dialog.fields().field("density"))->value(), 12.5);
            dialog.reject();
        });
        entry(s, "denser")->trigger();
    }

    /// What went wrong is said, the dialog stays, and the painting is as it was.
    void whatGoesWrongIsSaid()
    {
        Session s;
        s.paintLine({100, 100}, {300, 140});
        s.dry();
        const QByteArray hash = hashOf(s.painting());
        ExtensionDialog dialog(s.editor(), *ExtensionLibrary::instance().usable("failing"), &s.window);
        dialog.show();
        dialog.run();
        QVERIFY(dialog.isRunning() && !dialog.runButton()->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(!dialog.isRunning(), waitMs);
        QCOMPARE(dialog.hint()->text(), "Test failing: No paint is left.");
        QVERIFY(dialog.isVisible() && dialog.runButton()->isEnabled());
        QCOMPARE(hashOf(s.painting()), hash);

        // The first Cancel stops one that hangs.
        ExtensionDialog hanging(s.editor(), *ExtensionLibrary::instance().usable("hanging"), &s.window);
        hanging.show();
        hanging.run();
        QTRY_COMPARE_WITH_TIMEOUT(hanging.progress()->value(), 250, waitMs);
        hanging.reject();
        QTRY_VERIFY_WITH_TIMEOUT(!hanging.isRunning(), waitMs);
        QVERIFY(hanging.isVisible() && hanging.hint()->text().contains("stopped"));
        QCOMPARE(hashOf(s.painting()), hash);
        hanging.reject();
        QVERIFY(!hanging.isVisible());
    }

    void theManagerListsThem()
    {
        Session s;
        ExtensionOutcome outcome;
        outcome.error = "Test failing: No paint is left.";
        ExtensionLibrary::instance().noteRun(*ExtensionLibrary::instance().usable("failing"), outcome);
        ManageExtensionsDialog dialog(&s.window);
        const auto itemOf = [&](const QString &name) {
            return dialog.list()->findItems(name, Qt::MatchExactly).value(0);
        };
        QTreeWidgetItem *broken = itemOf("broken"), *denser = itemOf("Test denser"), *failing = itemOf("Test failing");
        QVERIFY(broken && denser && failing && itemOf("Hatch an Area"));
        dialog.list()->setCurrentItem(broken);
        QVERIFY2(dialog.details()->toPlainText().contains("manifest.json: format: “other” is not “suffuse-extension”"),
                 qPrintable(dialog.details()->toPlainText()));
        dialog.list()->setCurrentItem(failing);
        QVERIFY(dialog.details()->toPlainText().contains("No paint is left."));
        QVERIFY(entry(s, "denser"));
        denser->setCheckState(0, Qt::Unchecked);
        QVERIFY(!entry(s, "denser") && !ExtensionLibrary::instance().usable("denser"));
        denser->setCheckState(0, Qt::Checked);
        QVERIFY(entry(s, "denser"));
        put(ownExtensionsFolder() + "/broken/manifest.json",
            bytesOf(ownExtensionsFolder() + "/failing/manifest.json").replace("\"failing\"", "\"mended\""));
        dialog.readAgain();
        QVERIFY(!itemOf("broken") && entry(s, "mended"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestExtensionDialogs)
#include "test_extension_dialogs.moc"

// What is typed into fields of docks and dialogs, and when it counts.
#include "app/panels/colour/colour_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/window/hands_on_widgets.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>

using namespace suffuse;

namespace {

/// Shows a dialog, which is not deleted when it closes, and waits until it has the keyboard.
bool open(QDialog &dialog)
{
    dialog.setAttribute(Qt::WA_DeleteOnClose, false);
    dialog.show();
    return QTest::qWaitFor([&dialog] { return QApplication::activeWindow() == &dialog; });
}

/// The fields of a dialog that take a text as a whole. Those of spin boxes and of paths do not.
QList<QLineEdit *> entriesOf(QDialog &dialog)
{
    QList<QLineEdit *> fields;
    for (QLineEdit *field : dialog.findChildren<QLineEdit *>())
        if (field->isVisible() && field->isEnabled() &&
            (qobject_cast<NumberField *>(field) || field->accessibleName() == "Hex"))
            fields << field;
    return fields;
}

void enterInto(QLineEdit &field, const QString &text)
{
    field.setFocus();
    QTest::qWait(1); // numbers are selected once they have the focus
    field.selectAll();
    QTest::keyClicks(&field, text);
}

} // namespace

class TestTyping : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
    }

    void init() { window_layout::reset(); }

    /// A number that goes with what was selected leaves the keyboard to the canvas, not to whatever field comes next.
    void whatGoesGivesTheKeyboardBack()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush();
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField &number = *fieldCalled(*inspector, "Diffusion D");
        number.setFocus();
        QTRY_VERIFY(number.hasFocus());
        s.editor().document().setSelection({});
        s.editor().laterChanges().flush();
        QTRY_VERIFY(!number.isVisible());
        QTRY_VERIFY(s.canvas().hasFocus());
    }

    /// As a tester typed it: a number, Tab, another number.
    void tabGoesFromNumberToNumber()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush(); // it shows what is selected
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        QVERIFY(field);
        const Brush brush = s.editor().brush();
        field->setFocus();
        QCoreApplication::processEvents(); // it selects what it holds
        for (int i = 0; i < 3; ++i) {
            QTest::keyClicks(QApplication::focusWidget(), "85");
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QVERIFY2(qobject_cast<NumberField *>(QApplication::focusWidget()),
                     QApplication::focusWidget()->metaObject()->className());
            QCoreApplication::processEvents();
        }
        QVERIFY(field != QApplication::focusWidget());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_3);
        QCOMPARE(static_cast<QLineEdit *>(QApplication::focusWidget())->text(), QString("3"));
        QCOMPARE(s.editor().brush(), brush);
        QVERIFY(!s.window.action(Command::HideDocks).isChecked());
        QCOMPARE(s.stroke().segments[0].colour.red, 0.85f);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(s.canvas().hasFocus());
    }

    /// Saving takes what is typed so far; who types on goes on where they were.
    void savingLeavesTheCaret()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush();
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        field->setFocus();
        QCoreApplication::processEvents();
        QTest::keyClicks(field, "5");
        EntryField::takeTypedIn(s.window); // as saving does
        s.editor().laterChanges().flush();
        QCOMPARE(s.stroke().segments[0].colour.red, 0.05f);
        QTest::keyClicks(field, "1");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(s.stroke().segments[0].colour.red, 0.51f);
    }

    void escInANumberTakesBackWhatWasTyped()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush(); // it shows what is selected
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        field->setFocus();
        const QString before = field->text();
        const int steps = s.steps();
        QTest::keyClicks(field, "12");
        QTest::keyClick(field, Qt::Key_Escape);
        QCOMPARE(field->text(), before);
        QCOMPARE(s.steps(), steps);
        QVERIFY(s.canvas().hasFocus());
    }

    void aRefusedColourKeepsTheKeyboard()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.window.findChild<QDockWidget *>("colourDock")->raise();
        EntryField *hex = s.window.findChild<ColourPanel *>()->hex();
        const QString before = hex->text();
        const Tool *tool = s.canvas().tool();
        for (int time = 0; time < 2; ++time) {
            hex->setFocus();
            hex->selectAll();
            QTest::keyClicks(hex, "zz9");
            QTest::keyClick(hex, Qt::Key_Return);
            QVERIFY(hex->hasFocus());
            QCOMPARE(hex->text(), before);
            QCOMPARE(hex->selectedText(), before);
        }
        QTest::keyClicks(hex, "e1");
        QCOMPARE(s.canvas().tool(), tool);
        hex->selectAll();
        QTest::keyClicks(hex, "#336699");
        QTest::keyClick(hex, Qt::Key_Return);
        QCOMPARE(hex->text(), QString("#336699"));
        QVERIFY(s.canvas().hasFocus());
    }

    /// What cannot be taken is to be typed again: the keys that mend it are not the canvas'.
    void aRefusedNumberKeepsTheKeyboard()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush();
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        field->setFocus();
        const QString before = field->text();
        QTest::keyClicks(field, "abc");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(field->hasFocus());
        QCOMPARE(field->text(), before);
        QTest::keyClick(field, Qt::Key_Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QTest::keyClicks(field, "51");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(s.stroke().segments[0].colour.red, 0.51f);
        QVERIFY(s.canvas().hasFocus());
    }

    /// Whatever field of a dock or a bar it is: the key that gives up decides nothing.
    void escInAFieldTakesBackWhatWasTyped()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        QList<QLineEdit *> fields;
        for (QDockWidget *dock : s.window.findChildren<QDockWidget *>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            s.editor().laterChanges().flush();
            for (QLineEdit *field : dock->findChildren<QLineEdit *>())
                if (field->isVisible() && field->isEnabled() && field->placeholderText() != "Search") {
                    const PaintingPtr before = s.editor().document().snapshot();
                    const Brush brush = s.editor().brush();
                    const double speed = s.window.playback().speed();
                    const int steps = s.steps();
                    const QString text = field->text();
                    enterInto(*field, field->accessibleName() == "Hex" ? "#00ff01" : "0.7");
                    QVERIFY(field->isModified());
                    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
                    const QString name = field->accessibleName() + field->parentWidget()->accessibleName();
                    QVERIFY2(s.canvas().hasFocus(), qPrintable(name));
                    QVERIFY2(s.editor().document().snapshot() == before && s.steps() == steps, qPrintable(name));
                    QVERIFY2(s.editor().brush() == brush && s.window.playback().speed() == speed, qPrintable(name));
                    QVERIFY2(field->text() == text, qPrintable(name + ": " + field->text()));
                    fields << field;
                }
        }
        const auto has = [&fields](const QString &name) {
            return std::ranges::any_of(fields, [&](const QLineEdit *field) { return field->accessibleName() == name; });
        };
        QVERIFY(has("Hex") && has("Name") && has("Diffusion D")); // and the speed, whose name is that of its box
        QVERIFY2(fields.size() > 20, qPrintable(QString::number(fields.size())));
    }

    /// In a dialog it takes back the text alone, and the dialog stays.
    void escInAFieldOfADialog()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QStringList tried;
        for (const DialogMaker &maker : allDialogs())
            for (qsizetype i = 0, count = 1; i < count; ++i) {
                const PaintingPtr before = s.editor().document().snapshot();
                const int steps = s.steps();
                const std::unique_ptr<QDialog> dialog = maker.make(s.window);
                QVERIFY(open(*dialog));
                const QList<QLineEdit *> fields = entriesOf(*dialog);
                count = fields.size();
                if (fields.isEmpty())
                    break;
                const PaintingPtr shown = s.editor().document().snapshot();
                QLineEdit *field = fields[i];
                const QString text = field->text(), name = QString(maker.name) + ": " + field->accessibleName();
                enterInto(*field, field->accessibleName() == "Hex" ? "#00ff01" : "0.7");
                QTest::keyClick(field, Qt::Key_Escape);
                QVERIFY2(dialog->isVisible() && field->hasFocus(), qPrintable(name));
                QVERIFY2(field->text() == text && s.editor().document().snapshot() == shown, qPrintable(name));
                QTest::keyClick(field, Qt::Key_Escape);
                QVERIFY2(!dialog->isVisible(), qPrintable(name));
                QVERIFY2(s.painting() == *before && s.steps() == steps, qPrintable(name));
                tried << name;
            }
        QVERIFY2(tried.contains("recolour: Hex") && tried.contains("vary: Hue") && tried.contains("reshape: Values") &&
                     tried.contains("along: Start") && tried.size() > 15,
                 qPrintable(tried.join(", ")));
    }

    /// Return decides, too: at once where nothing shows before, and after the number where it is seen what it does.
    void returnInAFieldOfADialog()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const QStringList showAtOnce{"along", "reshape", "vary", "recolour", "fit"};
        QStringList tried;
        for (const DialogMaker &maker : allDialogs())
            for (qsizetype i = 0, count = 1; i < count; ++i) {
                const std::unique_ptr<QDialog> dialog = maker.make(s.window);
                QVERIFY(open(*dialog));
                const QList<QLineEdit *> fields = entriesOf(*dialog);
                count = fields.size();
                if (fields.isEmpty())
                    break;
                QLineEdit *field = fields[i];
                const QString name = QString(maker.name) + ": " + field->accessibleName();
                enterInto(*field, "nonsense");
                QTest::keyClick(field, Qt::Key_Return);
                QVERIFY2(dialog->isVisible() && field->text() != "nonsense", qPrintable(name));
                enterInto(*field, field->accessibleName() == "Hex" ? "#00ff01" : "1");
                QTest::keyClick(field, Qt::Key_Return);
                tried << name;
                if (const auto *extension = qobject_cast<const ExtensionDialog *>(dialog.get())) {
                    // It works, and goes when its program has ended, or says what it lacks.
                    QVERIFY2(extension->isRunning() || !extension->hint()->text().isEmpty(), qPrintable(name));
                    QVERIFY2(!field->isModified(), qPrintable(name));
                    continue;
                }
                const bool isTools =
                    std::ranges::none_of(dialog->findChildren<QPushButton *>(), &QPushButton::isDefault);
                QVERIFY2(dialog->isVisible() == (isTools || showAtOnce.contains(maker.name)), qPrintable(name));
                QVERIFY2(!field->isModified(), qPrintable(name));
                QTest::keyClick(field, Qt::Key_Return);
                QVERIFY2(dialog->isVisible() == isTools && (dialog->result() == QDialog::Accepted) != isTools,
                         qPrintable(name));
                dialog->reject();
            }
        QVERIFY2(tried.contains("recolour: Hex") && tried.contains("vary: Hue") && tried.contains("reshape: Values") &&
                     tried.contains("along: Start") && tried.contains("new: Width"),
                 qPrintable(tried.join(", ")));
    }

    /// Return presses the button that has the keyboard, not the one that Return presses elsewhere.
    void returnPressesTheButtonInFocus()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QStringList tried;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            QVERIFY(open(*dialog));
            for (QAbstractButton *button : dialog->findChildren<QAbstractButton *>()) {
                const bool isPressed = qobject_cast<QPushButton *>(button) || qobject_cast<QToolButton *>(button);
                if (!isPressed || !button->isVisible() || !button->isEnabled() ||
                    !(button->focusPolicy() & Qt::TabFocus))
                    continue;
                const QString text = button->text().isEmpty() ? button->accessibleName() : button->text();
                const QString name = QString(maker.name) + ": " + QString(text).remove('&');
                button->disconnect(SIGNAL(clicked(bool))); // it is not tried what it does
                const QSignalSpy clicks(button, &QAbstractButton::clicked);
                for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
                    button->setFocus(Qt::TabFocusReason);
                    QTest::keyClick(button, key);
                }
                QVERIFY2(clicks.count() == 2 && dialog->isVisible(), qPrintable(name));
                tried << name;
            }
            dialog->reject();
        }
        for (const char *name :
             {"export: Browse…", "export: Save…", "vary: Roll Again", "along: Constant", "brush: Close"})
            QVERIFY2(tried.contains(name), qPrintable(QString(name) + " – " + tried.join(", ")));
    }

    /// What has been typed counts before a tool, a tab or a shortcut does anything, though these take no keyboard.
    void whatWasTypedCountsFirst()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        const StrokeId id = s.painting().strokes.front()->id;
        s.editor().document().setSelection({{id}, {}});
        auto *inspector = s.window.findChild<InspectorPanel *>();
        s.window.findChild<QDockWidget *>("inspectorDock")->raise();
        NumberField *density = inspector->segmentSection()->density()->number();
        const auto typeOnly = [&](const QString &text) {
            density->setFocus();
            density->selectAll();
            QTest::keyClicks(density, text);
        };
        const auto now = [&] { return s.painting().find(id)->segments.front().density; };
        const int steps = s.editor().undoStack().count();
        typeOnly("12");
        QVERIFY(now() != 12);
        auto *tools = s.window.findChild<QToolBar *>("tools");
        QTest::mouseClick(tools->widgetForAction(&s.window.action(Command::Brush)), Qt::LeftButton);
        QCOMPARE(now(), 12.0f);
        QCOMPARE(s.editor().undoStack().count(), steps + 1);
        s.use(Command::Select);
        s.editor().document().setSelection({{id}, {}});
        s.window.findChild<QDockWidget *>("inspectorDock")->raise();
        typeOnly("14");
        QTest::keyClick(density, Qt::Key_D, Qt::ControlModifier); // duplicates what the number has made
        QCOMPARE(now(), 14.0f);
        QCOMPARE(s.painting().strokes.back()->segments.front().density, 14.0f);
        QVERIFY(s.painting().strokes.back()->id != id);

        // It is asked about before the window closes.
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return SaveAnswer::Cancel;
        };
        setMessageHooks(hooks);
        const auto back = qScopeGuard([] { setMessageHooks({}); });
        s.editor().document().setSelection({{id}, {}});
        QTemporaryDir folder;
        QVERIFY(s.window.saveTo(folder.filePath("a.suffuse")));
        QVERIFY(!s.window.isWindowModified());
        typeOnly("16");
        QVERIFY(!s.window.close());
        QCOMPARE(asked, 1);
        QCOMPARE(now(), 16.0f);
    }

    /// Who has left a field by a click on a tool or on another dock's tab types to the canvas from then on.
    void aClickElsewhereEndsTyping()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        s.editor().document().setSelection({{s.painting().strokes.front()->id}, {}});
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        s.window.tabifyDockWidget(inspector, strokes);
        inspector->raise();
        QTRY_VERIFY(!inspector->visibleRegion().isEmpty());
        NumberField *field = s.window.findChild<InspectorPanel *>()->segmentSection()->granulation()->number();
        const auto begin = [&] {
            inspector->raise();
            field->setFocus();
            return field->hasFocus();
        };
        QVERIFY(begin());
        auto *tools = s.window.findChild<QToolBar *>("tools");
        QTest::mouseClick(tools->widgetForAction(&s.window.action(Command::Eraser)), Qt::LeftButton);
        QTRY_VERIFY(s.canvas().hasFocus());
        QVERIFY(begin());
        for (QTabBar *bar : s.window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
            for (int i = 0; i < bar->count(); ++i)
                if (bar->tabText(i) == strokes->windowTitle())
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
        QTRY_VERIFY(s.canvas().hasFocus());
        QTRY_VERIFY(!strokes->visibleRegion().isEmpty());
    }

    /// A double click is the start of another number, not of its digits before the point. A third one changes nothing.
    void aDoubleClickSelectsTheWholeNumber()
    {
        QWidget window;
        NumberField field(&window);
        field.setRange(0, 1000);
        field.setValue(70.9);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        const QPoint at(8, field.height() / 2);
        QTest::mouseClick(&field, Qt::LeftButton, {}, at);
        QTest::mouseDClick(&field, Qt::LeftButton, {}, at);
        QCOMPARE(field.selectedText(), field.text());
        QTest::keyClicks(&field, "12");
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(field.value().value(), 12.0);
        QTest::mouseDClick(&field, Qt::LeftButton, {}, at);
        QTest::mouseClick(&field, Qt::LeftButton, {}, at);
        QCOMPARE(field.selectedText(), field.text());
    }

    /// What is typed as soon as a dialog is there goes into a field.
    void dialogsBeginInAField()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            QVERIFY(QTest::qWaitForWindowActive(dialog.get()));
            QCoreApplication::processEvents();
            const QWidget *focus = dialog->focusWidget();
            const bool any = QString(maker.name) != "about" && QString(maker.name) != "along";
            const bool isField =
                qobject_cast<const QLineEdit *>(focus) || qobject_cast<const QAbstractSpinBox *>(focus) ||
                qobject_cast<const QComboBox *>(focus) || qobject_cast<const QAbstractItemView *>(focus);
            QVERIFY2(isField || !any,
                     qPrintable(QString(maker.name) + ' ' + (focus ? focus->metaObject()->className() : "")));
            if (const auto *path = qobject_cast<const QLineEdit *>(focus); path && path->accessibleName() == "File")
                QCOMPARE(path->selectedText(), QFileInfo(path->text()).completeBaseName());
            else
                QVERIFY(QString(maker.name) != "export" && QString(maker.name) != "timelapse");
            dialog->reject();
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestTyping)
#include "test_typing.moc"

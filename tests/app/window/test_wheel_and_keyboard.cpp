// What the wheel and the keys reach: nothing is altered that was not meant.
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/all_dialogs.h"

#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcutEvent>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

using namespace suffuse;

namespace {

constexpr Command tools[] = {Command::Brush,      Command::Select, Command::Segments, Command::Knife,
                             Command::Redraw,     Command::Push,   Command::Eraser,   Command::AttributeBrush,
                             Command::Eyedropper, Command::Pan};

/// What a hand can set in a widget, as a text.
QString valueOf(const QWidget *widget)
{
    if (const auto *box = qobject_cast<const QAbstractSpinBox *>(widget))
        return box->text();
    if (const auto *combo = qobject_cast<const QComboBox *>(widget))
        return QString::number(combo->currentIndex()) + combo->currentText();
    if (const auto *slider = qobject_cast<const QAbstractSlider *>(widget))
        return qobject_cast<const QScrollBar *>(widget) ? QString() : QString::number(slider->value());
    if (const auto *bar = qobject_cast<const QTabBar *>(widget))
        return QString::number(bar->currentIndex());
    if (const auto *field = qobject_cast<const QLineEdit *>(widget))
        return field->text();
    return {};
}

QStringList valuesIn(const QWidget &root)
{
    QStringList values;
    for (const QWidget *widget : root.findChildren<QWidget *>())
        values << valueOf(widget);
    return values;
}

/// As a hand does: what a widget does not take goes on to its parent. (Qt lets events that a program sends stay.)
void turnWheel(QWidget &widget, int delta)
{
    for (QWidget *w = &widget; w; w = w->isWindow() ? nullptr : w->parentWidget()) {
        const QPointF at = w->rect().center();
        QWheelEvent wheel(at, w->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(w, &wheel);
        if (wheel.isAccepted())
            break;
    }
}

/// The scroll bar that a wheel over the widget ought to move; none: null.
QScrollBar *barAround(const QWidget *widget)
{
    for (const QWidget *w = widget->parentWidget(); w && !w->isWindow(); w = w->parentWidget())
        if (const auto *area = qobject_cast<const QScrollArea *>(w))
            if (QScrollBar *bar = area->verticalScrollBar(); bar->maximum() > bar->minimum())
                return bar;
    return nullptr;
}

/// Without the canvas and its children.
QList<QWidget *> widgetsOf(QWidget &root, const QWidget &canvas)
{
    QList<QWidget *> widgets = root.findChildren<QWidget *>();
    widgets.removeIf([&](QWidget *w) { return w == &canvas || canvas.isAncestorOf(w); });
    return widgets;
}

/// Turns it over every widget that has no focus, back and forth; says what was altered, and counts what scrolled.
QStringList wheelOverAll(WaveSession &s, QWidget &root, int &scrolled)
{
    QStringList altered;
    for (QWidget *widget : widgetsOf(root, s.canvas())) {
        if (widget->hasFocus() || widget->parentWidget()->hasFocus() || widget->inherits("QMenuBar"))
            continue;
        if (widget->focusPolicy() == Qt::WheelFocus && widget->testAttribute(Qt::WA_WState_Polished))
            altered << QString("%1 gets the focus").arg(widget->accessibleName());
        for (const int delta : {-120, 240}) {
            const QStringList values = valuesIn(root);
            const PaintingPtr painting = s.editor().document().snapshot();
            const Brush brush = s.editor().brush();
            QScrollBar *bar = valueOf(widget).isEmpty() ? nullptr : barAround(widget);
            if (bar)
                bar->setValue((bar->minimum() + bar->maximum()) / 2);
            const int before = bar ? bar->value() : 0;
            turnWheel(*widget, delta);
            if (values != valuesIn(root) || painting != s.editor().document().snapshot() || brush != s.editor().brush())
                altered
                    << QString("%1 %2 %3").arg(widget->metaObject()->className(), widget->accessibleName()).arg(delta);
            if (bar && bar->value() == before && bar->maximum() > bar->minimum() + 1) {
                altered << QString("%1 %2 does not scroll")
                               .arg(widget->metaObject()->className(), widget->accessibleName());
            }
            scrolled += bar != nullptr;
        }
    }
    return altered;
}

/// Panels, and what in them can have the keyboard.
QList<QWidget *> panelsOf(MainWindow &window)
{
    QList<QWidget *> panels;
    for (auto *dock : window.findChildren<QDockWidget *>())
        panels << dock;
    for (auto *bar : window.findChildren<QToolBar *>())
        panels << bar;
    return panels;
}

QList<QWidget *> focusableIn(QWidget &panel)
{
    QList<QWidget *> widgets = panel.findChildren<QWidget *>();
    widgets.removeIf([&](QWidget *w) {
        return !(w->focusPolicy() & Qt::StrongFocus) || w->focusProxy() || w->window() != panel.window();
    });
    return widgets;
}

bool isTaken(QWidget &widget, QKeyCombination keys)
{
    QKeyEvent event(QEvent::ShortcutOverride, keys.key(), keys.keyboardModifiers());
    event.ignore();
    QCoreApplication::sendEvent(&widget, &event);
    return event.isAccepted();
}

NumberField *fieldCalled(QWidget &root, const QString &name)
{
    for (auto *field : root.findChildren<NumberField *>())
        if (field->accessibleName() == name && field->isVisible())
            return field;
    return nullptr;
}

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

class TestWheelAndKeyboard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void init() { window_layout::reset(); }

    void noWindowsWidgetWithoutFocusTakesTheWheel()
    {
        WaveSession s;
        s.window.resize(1100, 560); // so that panels have something to scroll
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (auto *dock : s.window.findChildren<QDockWidget *>())
            dock->show();
        int scrolled = 0;
        for (const Command tool : tools) {
            s.use(tool);
            s.canvas().setFocus();
            QCoreApplication::processEvents();
            const QStringList altered = wheelOverAll(s, s.window, scrolled);
            QVERIFY2(altered.isEmpty(), qPrintable(altered.join('\n')));
            if (tool == Command::Select) // and the painting's own values
                s.editor().document().setSelection({});
        }
        QVERIFY2(scrolled > 40, qPrintable(QString::number(scrolled)));
    }

    void noDialogsWidgetWithoutFocusTakesTheWheel()
    {
        WaveSession s;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->show();
            QCoreApplication::processEvents();
            for (auto *tabs : dialog->findChildren<QTabWidget *>())
                for (int page = tabs->count(); page-- > 0;)
                    tabs->setCurrentIndex(page); // polishes what is on it
            int scrolled = 0;
            const QStringList altered = wheelOverAll(s, *dialog, scrolled);
            QVERIFY2(altered.isEmpty(), qPrintable(QString(maker.name) + ": " + altered.join('\n')));
            dialog->reject();
        }
    }

    /// It is not the wheel that is forbidden.
    void whatHasTheFocusTakesTheWheel()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush(); // it shows what is selected
        QTRY_VERIFY(fieldCalled(*inspector, "Diffusion D"));
        NumberField *field = fieldCalled(*inspector, "Red");
        QVERIFY(field);
        field->setFocus();
        const int before = s.steps();
        turnWheel(*field, -120);
        QCOMPARE(s.steps(), before + 1);
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

    /// Every key that is a command by itself, in every place of every panel.
    void noSingleKeyReachesTheCanvas()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QList<QKeyCombination> typed, commands;
        for (const QAction *action : s.window.findChild<Commands *>()->all())
            for (const QKeySequence &keys : action->shortcuts()) {
                const bool held = keys[0].keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier);
                const bool function = keys[0].key() >= Qt::Key_F1 && keys[0].key() <= Qt::Key_F35;
                if (!held && (!function || keys[0].key() == Qt::Key_F2))
                    typed << keys[0];
                else if (held || function)
                    commands << keys[0];
            }
        QVERIFY(typed.size() > 40 && commands.size() > 20);
        int places = 0;
        for (QWidget *panel : panelsOf(s.window))
            for (QWidget *widget : focusableIn(*panel)) {
                widget->setFocus(); // where it can have it
                QSet<QKeySequence> own;
                for (QWidget *w = widget; w; w = w == panel ? nullptr : w->parentWidget())
                    for (const QAction *action : w->actions())
                        for (const QKeySequence &keys : action->shortcuts())
                            own << keys;
                const bool shift = std::ranges::any_of(
                    own, [](const QKeySequence &k) { return k[0].keyboardModifiers() == Qt::ShiftModifier; });
                const bool isTimeline = widget->inherits("suffuse::TimelineView");
                for (const QKeyCombination keys : typed) {
                    // Of those with Shift Qt's table decides there; see keysWithShiftAreFoundByQt.
                    if (own.contains(QKeySequence(keys)) || (shift && keys.keyboardModifiers() == Qt::ShiftModifier))
                        continue;
                    const bool passes = isTimeline && keys.key() >= Qt::Key_A && keys.key() <= Qt::Key_Z;
                    QVERIFY2(isTaken(*widget, keys) != passes,
                             qPrintable(panel->objectName() + ' ' + widget->accessibleName() + ' ' +
                                        QKeySequence(keys).toString()));
                }
                ++places;
            }
        QVERIFY2(places > 60, qPrintable(QString::number(places)));
        QVERIFY(!isTaken(s.canvas(), QKeyCombination(Qt::Key_3)));
        QVERIFY(!isTaken(s.window, QKeyCombination(Qt::Key_3)));
        // With Ctrl they work everywhere, but where a field has a use for them.
        auto *tree = s.window.findChild<QDockWidget *>("strokesDock")->findChild<QTreeView *>();
        QVERIFY(!isTaken(*tree, Qt::CTRL | Qt::Key_D));
        QVERIFY(!isTaken(*tree, Qt::Key_F6));
    }

    /// The timeline keeps the keyboard after a click, but it has no use for letters.
    void lettersGoFromTheTimelineToTheTools()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        QWidget *timeline = nullptr;
        for (QWidget *widget : focusableIn(*s.window.findChild<QDockWidget *>("timelineDock")))
            timeline = widget->inherits("suffuse::TimelineView") ? widget : timeline;
        QVERIFY(timeline);
        QTest::mouseClick(static_cast<QAbstractScrollArea *>(timeline)->viewport(), Qt::LeftButton, {}, {40, 8});
        QCoreApplication::processEvents();
        QVERIFY(timeline->hasFocus());
        const QKeySequence brush = s.window.action(Command::Brush).shortcut();
        QTest::keyClick(timeline, brush[0].key(), brush[0].keyboardModifiers());
        QVERIFY(s.window.action(Command::Brush).isChecked());
        const Brush inHand = s.editor().brush();
        QTest::keyClick(timeline, Qt::Key_4); // a number is not a letter
        QCOMPARE(s.editor().brush(), inHand);
    }

    /// What is about a panel's own things goes on working there.
    void panelsKeepTheirOwnKeys()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        strokes->raise();
        auto *tree = strokes->findChild<QTreeView *>();
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Delete);
        QVERIFY(s.painting().strokes.empty());
        s.editor().undoStack().undo();
        auto *search = strokes->findChild<QLineEdit *>(); // but here it deletes letters
        search->setFocus();
        search->setText("a");
        search->setCursorPosition(0);
        QTest::keyClick(search, Qt::Key_Delete);
        QCOMPARE(search->text(), QString());
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        auto *timeline = s.window.findChild<QDockWidget *>("timelineDock");
        for (QWidget *widget : focusableIn(*timeline))
            if (widget->inherits("QAbstractScrollArea")) {
                widget->setFocus();
                QTest::keyClick(widget, Qt::Key_P);
                QVERIFY(s.window.playback().isPlaying());
                s.window.playback().pause();
            }
    }

    void escGivesTheKeyboardBack()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        int places = 0;
        for (QWidget *panel : panelsOf(s.window))
            for (QWidget *widget : focusableIn(*panel)) {
                if (auto *dock = qobject_cast<QDockWidget *>(panel))
                    dock->raise();
                widget->setFocus();
                if (!widget->hasFocus())
                    continue; // hidden or disabled now
                QTest::keyClick(widget, Qt::Key_Escape);
                QVERIFY2(s.canvas().hasFocus(), qPrintable(panel->objectName() + ' ' + widget->accessibleName() + ' ' +
                                                           widget->metaObject()->className()));
                ++places;
                if (!qobject_cast<NumberField *>(widget))
                    continue;
                widget->setFocus();
                QTest::keyClick(widget, Qt::Key_Return);
                QVERIFY(s.canvas().hasFocus());
            }
        QVERIFY2(places > 25, qPrintable(QString::number(places)));
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
        const QStringList showAtOnce{"along", "reshape", "vary", "recolour"};
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
                const bool isTools =
                    std::ranges::none_of(dialog->findChildren<QPushButton *>(), &QPushButton::isDefault);
                QVERIFY2(dialog->isVisible() == (isTools || showAtOnce.contains(maker.name)), qPrintable(name));
                QVERIFY2(!field->isModified(), qPrintable(name));
                QTest::keyClick(field, Qt::Key_Return);
                QVERIFY2(dialog->isVisible() == isTools && (dialog->result() == QDialog::Accepted) != isTools,
                         qPrintable(name));
                dialog->reject();
                tried << name;
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

    void f6WalksAllPanels()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const auto whereIs = [&s](QWidget *widget) -> QWidget * {
            for (; widget; widget = widget->parentWidget())
                if (widget == &s.canvas() || qobject_cast<QDockWidget *>(widget) || qobject_cast<QToolBar *>(widget))
                    return widget;
            return nullptr;
        };
        QList<QWidget *> there, back;
        do {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
            QVERIFY(QApplication::focusWidget()->isVisible());
            there << whereIs(QApplication::focusWidget());
            QVERIFY(there.size() < 20);
        } while (there.last() != &s.canvas());
        for (QWidget *panel : panelsOf(s.window))
            QCOMPARE(there.count(panel), panel->isVisible() ? 1 : 0);
        do {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
            back << whereIs(QApplication::focusWidget());
            QVERIFY(back.size() < 20);
        } while (back.last() != &s.canvas());
        std::reverse(back.begin(), back.end() - 1);
        QCOMPARE(back, there);
    }

    /// Who only walks through the docks finds them as they stood; what is used there stays in front.
    void f6LeavesTabsAsTheyStood()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *history = s.window.findChild<QDockWidget *>("historyDock");
        auto *colour = s.window.findChild<QDockWidget *>("colourDock");
        s.window.tabifyDockWidget(colour, history);
        history->show();
        colour->raise();
        const auto isInFront = [](const QDockWidget *dock) { return !dock->visibleRegion().isEmpty(); };
        QTRY_VERIFY(isInFront(colour) && !isInFront(history));
        const auto walkTo = [&](QWidget *goal) {
            s.canvas().setFocus();
            for (int i = 0; i < 20; ++i) {
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
                if (goal->isAncestorOf(QApplication::focusWidget()) || QApplication::focusWidget() == goal)
                    return true;
            }
            return false;
        };
        QVERIFY(walkTo(history));
        QTRY_VERIFY(isInFront(history));
        QVERIFY(s.window.statusBar()->currentMessage().contains(history->windowTitle()));
        QVERIFY(walkTo(&s.canvas()));
        QTRY_VERIFY(isInFront(colour));
        QVERIFY(walkTo(history));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QVERIFY(walkTo(&s.canvas()));
        QTRY_VERIFY(isInFront(history));
    }

    /// It is seen where the keyboard is, until the mouse goes on.
    void f6ShowsWhereItIs()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.canvas().setFocus();
        const QImage before = s.window.grab().toImage();
        QTest::keyClick(&s.canvas(), Qt::Key_F6);
        const auto edge = [&s] {
            QWidget *panel = QApplication::focusWidget();
            while (!qobject_cast<QDockWidget *>(panel) && !qobject_cast<QToolBar *>(panel))
                panel = panel->parentWidget();
            const QPoint at = panel->mapTo(&s.window, QPoint(1, panel->height() / 2));
            return s.window.grab().toImage().pixelColor(at * s.window.devicePixelRatioF());
        };
        QCOMPARE(edge(), s.window.palette().color(QPalette::Highlight));
        QWidget *focus = QApplication::focusWidget();
        QTest::mousePress(&s.canvas(), Qt::MiddleButton, {}, QPoint(20, 20));
        QTest::mouseRelease(&s.canvas(), Qt::MiddleButton, {}, QPoint(20, 20));
        focus->setFocus();
        QVERIFY(edge() != s.window.palette().color(QPalette::Highlight));
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

    /// A double click is the start of another number, not of its digits before the point.
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
    }

    /// A click on what cannot be typed into leaves the keyboard to the canvas.
    void clicksGiveTheKeyboardBack()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        int buttons = 0, fields = 0;
        for (QWidget *panel : panelsOf(s.window)) {
            if (auto *dock = qobject_cast<QDockWidget *>(panel))
                dock->raise();
            QCoreApplication::processEvents();
            for (QWidget *widget : panel->findChildren<QWidget *>()) {
                const bool isField = qobject_cast<QLineEdit *>(widget) || qobject_cast<QAbstractSpinBox *>(widget) ||
                                     qobject_cast<QAbstractItemView *>(widget);
                const bool plain = qobject_cast<QAbstractSlider *>(widget) || widget->inherits("suffuse::SwatchGrid") ||
                                   widget->inherits("suffuse::BrushGrid") || // a brush is what the hand goes on with
                                   widget->inherits("suffuse::ColourWheel") || qobject_cast<QCheckBox *>(widget);
                if (!(isField || plain) || !(widget->focusPolicy() & Qt::StrongFocus) || !widget->isVisible())
                    continue;
                widget->setFocus(Qt::MouseFocusReason); // as the press does
                if (!widget->hasFocus())
                    continue;
                auto *area = qobject_cast<QAbstractScrollArea *>(widget);
                QTest::mouseRelease(area ? area->viewport() : widget, Qt::LeftButton, {}, QPoint(1, 1));
                QCoreApplication::processEvents();
                QVERIFY2(s.canvas().hasFocus() == plain,
                         qPrintable(panel->objectName() + ' ' + widget->metaObject()->className()));
                (plain ? buttons : fields) += 1;
            }
        }
        QVERIFY2(buttons > 5 && fields > 5, qPrintable(QString("%1 %2").arg(buttons).arg(fields)));
    }

    /// What Shift makes of a key is another one on each keyboard: > on some, : on others.
    void keysWithShiftAreFoundByQt()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *timeline = s.window.findChild<QDockWidget *>("timelineDock");
        QWidget *view = nullptr;
        for (QWidget *widget : focusableIn(*timeline))
            if (widget->inherits("suffuse::TimelineView"))
                view = widget;
        QVERIFY(view);
        view->setFocus();
        for (const Qt::Key key : {Qt::Key_Greater, Qt::Key_Less, Qt::Key_Colon, Qt::Key_Semicolon, Qt::Key_Period})
            QVERIFY(!isTaken(*view, Qt::SHIFT | key));
        // Of what Qt finds then, the panel's own goes through, and of the canvas' the letters alone.
        const auto isStopped = [&s](Command command) {
            QAction &action = s.window.action(command);
            QShortcutEvent event(action.shortcut(), 0, true); // ambiguous: the action says so and does nothing
            return s.window.findChild<KeyboardFocus *>()->eventFilter(&action, &event);
        };
        QVERIFY(!isStopped(Command::ToEnd));
        QVERIFY(!isStopped(Command::ToStart));
        QVERIFY(isStopped(Command::Favourite1));
        QVERIFY(!isStopped(Command::Brush));
        QVERIFY(!isStopped(Command::Save));
        s.canvas().setFocus();
        QVERIFY(!isStopped(Command::Brush));
    }

    /// A letter chooses nothing in a list, and it is said where the keyboard is.
    void lettersChooseNothingInLists()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *brushes = s.window.findChild<QDockWidget *>("brushesDock");
        brushes->raise();
        QCoreApplication::processEvents();
        auto *list = brushes->findChild<QListWidget *>();
        list->setFocus();
        QVERIFY(list->hasFocus());
        const Brush before = s.editor().brush();
        for (const char key : {'n', 'b', 'f', 'p'})
            QTest::keyClick(list, key);
        QCOMPARE(s.editor().brush(), before);
        QCOMPARE(s.window.statusBar()->currentMessage(),
                 QString("The Brushes dock has the keyboard; Esc gives it back to the canvas."));
        s.window.statusBar()->clearMessage();
        QTest::keyClick(list, 'b'); // once
        QCOMPARE(s.window.statusBar()->currentMessage(), QString());
        QTest::keyClick(list, Qt::Key_Escape);
        QVERIFY(s.canvas().hasFocus());
        auto *search = brushes->findChild<QLineEdit *>();
        search->setFocus();
        QTest::keyClick(search, 'b');
        QCOMPARE(search->text(), QString("b"));
        QCOMPARE(s.window.statusBar()->currentMessage(), QString());
    }

    void f6ReturnsToWhereItWas()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *inspector = s.window.findChild<QDockWidget *>("inspectorDock");
        inspector->raise();
        s.editor().laterChanges().flush();
        QTRY_VERIFY(fieldCalled(*inspector, "Red"));
        NumberField *field = fieldCalled(*inspector, "Red");
        field->setFocus();
        QTest::keyClick(field, Qt::Key_F6);
        QVERIFY(!field->hasFocus());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, Qt::ShiftModifier);
        QVERIFY(field->hasFocus());
    }

    void downGoesFromTheSearchToTheList()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        strokes->raise();
        s.editor().document().setSelection({});
        QCoreApplication::processEvents();
        auto *tree = strokes->findChild<QTreeView *>();
        auto *search = strokes->findChild<QLineEdit *>();
        search->setFocus();
        QTest::keyClick(search, Qt::Key_Down);
        QVERIFY(tree->hasFocus());
        QVERIFY(tree->selectionModel()->isSelected(tree->currentIndex()));
        QCOMPARE(s.selection().strokes.size(), std::size_t(1));
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Down, Qt::Key_Up}) { // framed, not selected
            s.editor().document().setSelection({});
            s.editor().laterChanges().flush();
            QVERIFY(!tree->selectionModel()->hasSelection());
            QTest::keyClick(tree, key);
            QCOMPARE(s.selection().strokes.size(), std::size_t(1));
            QVERIFY(tree->selectionModel()->isSelected(tree->currentIndex()));
        }
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

QTEST_MAIN(TestWheelAndKeyboard)
#include "test_wheel_and_keyboard.moc"

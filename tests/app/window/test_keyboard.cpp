// Who has the keyboard, and what the keys reach: nothing is altered that was not meant.
#include "app/panels/strokes/strokes_panel.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/window/hands_on_widgets.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcutEvent>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

using namespace suffuse;

namespace {

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

bool isInFront(const QDockWidget *dock)
{
    return !dock->visibleRegion().isEmpty();
}

/// Puts the History dock behind the Colour dock. Returns both, that in front first.
std::pair<QDockWidget *, QDockWidget *> colourBeforeHistory(MainWindow &window)
{
    auto *history = window.findChild<QDockWidget *>("historyDock");
    auto *colour = window.findChild<QDockWidget *>("colourDock");
    window.tabifyDockWidget(colour, history);
    history->show();
    colour->raise();
    return {colour, history};
}

bool isTaken(QWidget &widget, QKeyCombination keys)
{
    QKeyEvent event(QEvent::ShortcutOverride, keys.key(), keys.keyboardModifiers());
    event.ignore();
    QCoreApplication::sendEvent(&widget, &event);
    return event.isAccepted();
}

} // namespace

class TestKeyboard : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
    }

    void init() { window_layout::reset(); }

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
                const bool isStrokes = widget->inherits("suffuse::StrokesView");
                for (const QKeyCombination keys : typed) {
                    // Of those with Shift Qt's table decides there; see keysWithShiftAreFoundByQt.
                    if (own.contains(QKeySequence(keys)) || (shift && keys.keyboardModifiers() == Qt::ShiftModifier))
                        continue;
                    const bool isLetter = keys.key() >= Qt::Key_A && keys.key() <= Qt::Key_Z;
                    const bool isKeyOfTools = isLetter || (keys.key() >= Qt::Key_0 && keys.key() <= Qt::Key_9) ||
                                              keys.key() == Qt::Key_BracketLeft || keys.key() == Qt::Key_BracketRight;
                    const bool passes = isTimeline ? isLetter : isStrokes && isKeyOfTools;
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

    /// Who goes from place to place by the keyboard sees where they are.
    void whatHasTheKeyboardShowsIt()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.window.setAttribute(Qt::WA_KeyboardFocusChange); // as F6 does
        int places = 0;
        for (auto *dock : s.window.findChildren<QDockWidget *>()) {
            dock->raise();
            QCoreApplication::processEvents();
            for (QWidget *widget : focusableIn(*dock)) {
                if (!widget->isVisible() || !widget->isEnabled() || !(widget->focusPolicy() & Qt::TabFocus) ||
                    qobject_cast<QLabel *>(widget)) // to be copied by the mouse
                    continue;
                s.canvas().setFocus();
                const QImage without = widget->grab().toImage();
                widget->setFocus(Qt::TabFocusReason);
                QVERIFY2(widget->hasFocus(), qPrintable(widget->accessibleName()));
                QVERIFY2(widget->grab().toImage() != without,
                         qPrintable(dock->objectName() + ' ' + widget->metaObject()->className() + ' ' +
                                    widget->accessibleName()));
                ++places;
            }
        }
        QVERIFY2(places > 40, qPrintable(QString::number(places)));
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
        for (QWidget *widget : focusableIn(*s.window.findChild<QDockWidget *>("timelineDock")))
            if (widget->inherits("suffuse::TimelineView")) {
                widget->setFocus();
                QTest::keyClick(widget, Qt::Key_Delete); // The bar is the selected stroke.
            }
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

    /// In the row of a tool the keyboard goes to the first field, also where only a button could have it before.
    void f6GoesToTheFirstField()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        auto *bar = s.window.findChild<QToolBar *>("toolOptions");
        const auto goalFor = [&](const Selection &selection) -> QWidget * {
            s.editor().document().setSelection(selection);
            s.editor().laterChanges().flush();
            QCoreApplication::processEvents(); // the row follows a little later
            s.canvas().setFocus();
            for (int i = 0; i < 20; ++i) {
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
                if (bar->isAncestorOf(QApplication::focusWidget()))
                    return QApplication::focusWidget();
            }
            return nullptr;
        };
        QVERIFY(!qobject_cast<QLineEdit *>(goalFor({}))); // no field can be used
        for (int times = 0; times < 2; ++times) {
            auto *field = qobject_cast<QLineEdit *>(goalFor({{s.id}, {}}));
            QVERIFY(field);
            for (QLineEdit *other : bar->findChildren<QLineEdit *>())
                QVERIFY(!other->isVisible() || !other->isEnabled() ||
                        other->mapTo(bar, QPoint()).x() >= field->mapTo(bar, QPoint()).x());
            QVERIFY(!qobject_cast<QLineEdit *>(goalFor({})));
        }
    }

    /// Who only walks through the docks finds them as they stood; what is used there stays in front.
    void f6LeavesTabsAsTheyStood()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const auto docks = colourBeforeHistory(s.window);
        QDockWidget *const colour = docks.first, *const history = docks.second;
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

    /// Each place with tabs for itself, whichever dock is in front there.
    void aRoundOfF6LeavesTabsAsTheyStood()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const auto docks = colourBeforeHistory(s.window);
        for (const QString name : {"brushesDock", "inspectorDock", "strokesDock"})
            for (const Qt::KeyboardModifiers back : {Qt::NoModifier, Qt::ShiftModifier}) {
                auto *shown = s.window.findChild<QDockWidget *>(name);
                QVERIFY(!s.window.tabifiedDockWidgets(shown).isEmpty());
                shown->raise();
                QTRY_VERIFY(isInFront(shown) && isInFront(docks.first));
                s.canvas().setFocus();
                bool wasBehind = false;
                for (int i = 0; i < 20; ++i) {
                    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, back);
                    wasBehind = wasBehind || !isInFront(shown);
                    if (QApplication::focusWidget() == &s.canvas())
                        break;
                }
                QCOMPARE(QApplication::focusWidget(), &s.canvas());
                QVERIFY(wasBehind);
                QTRY_VERIFY2(isInFront(shown), qPrintable(name));
                QTRY_VERIFY(isInFront(docks.first));
            }
    }

    /// What lies behind another dock cannot be seen, so Tab does not go there; where it goes it says so.
    void tabPassesHiddenDocksBy()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        const auto docks = colourBeforeHistory(s.window);
        QDockWidget *const colour = docks.first, *const history = docks.second;
        QTRY_VERIFY(isInFront(colour) && !isInFront(history));
        const auto panelOf = [](QWidget *widget) -> QWidget * {
            while (widget && !qobject_cast<QDockWidget *>(widget) && !qobject_cast<QToolBar *>(widget))
                widget = widget->parentWidget();
            return widget;
        };
        int crossed = 0;
        for (QWidget *start : panelsOf(s.window)) {
            if (start == history || !start->isVisible() || focusableIn(*start).isEmpty())
                continue;
            for (const Qt::Key key : {Qt::Key_Tab, Qt::Key_Backtab}) {
                focusableIn(*start).front()->setFocus();
                // On the canvas Tab is a key of the tool.
                for (int i = 0; i < 60 && QApplication::focusWidget() != &s.canvas(); ++i) {
                    QWidget *before = panelOf(QApplication::focusWidget());
                    QTest::keyClick(QApplication::focusWidget(), key);
                    QWidget *panel = panelOf(QApplication::focusWidget());
                    QVERIFY(panel != history);
                    if (!panel || panel == before)
                        continue;
                    ++crossed;
                    QVERIFY2(s.window.statusBar()->currentMessage().contains(panel->windowTitle()),
                             qPrintable(panel->objectName() + ": " + s.window.statusBar()->currentMessage()));
                }
            }
        }
        QVERIFY2(crossed > 2, qPrintable(QString::number(crossed)));
    }

    /// Names are given one after the other without the mouse: Return ends one, and Down goes to the next row.
    void aListInWhichNamesAreGivenKeepsTheKeyboard()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto &view = *s.window.findChild<StrokesPanel *>()->view();
        const int steps = s.editor().undoStack().count();
        view.setFocus();
        view.setCurrentIndex(view.model()->index(0, 0));
        QTest::keyClick(&view, Qt::Key_F2);
        QLineEdit *field = nullptr;
        QTRY_VERIFY((field = view.viewport()->findChild<QLineEdit *>()));
        QTest::keyClicks(field, "first");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(!view.viewport()->findChild<QLineEdit *>());
        QTRY_VERIFY(view.hasFocus());
        QCOMPARE(s.editor().undoStack().count(), steps + 1);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QCOMPARE(s.editor().undoStack().count(), steps + 1); // the list's row, not the painting
        QTest::keyClick(&view, Qt::Key_Return);              // with nothing to end it gives the keyboard back
        QTRY_VERIFY(s.canvas().hasFocus());
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
        QCOMPARE(edge(), focusFrame());
        QWidget *focus = QApplication::focusWidget();
        QTest::mousePress(&s.canvas(), Qt::MiddleButton, {}, QPoint(20, 20));
        QTest::mouseRelease(&s.canvas(), Qt::MiddleButton, {}, QPoint(20, 20));
        focus->setFocus();
        QVERIFY(edge() != focusFrame());
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

    /// A list that a click has opened gives the keyboard back when it closes, by whatever means. Who has gone to a
    /// field by the keyboard stays there.
    void listsGiveTheKeyboardBack()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        int lists = 0;
        for (QComboBox *combo : s.window.findChildren<QComboBox *>()) {
            const bool inRow = combo->isVisible() && combo->mapTo(&s.window, QPoint()).y() < 100; // over the canvas
            if (!inRow || combo->isEditable())
                continue;
            ++lists;
            for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape})
                for (const bool byMouse : {true, false}) {
                    combo->setFocus(Qt::MouseFocusReason);
                    if (byMouse)
                        QTest::mousePress(combo, Qt::LeftButton);
                    else
                        QTest::keyClick(combo, Qt::Key_Down, Qt::AltModifier);
                    QTRY_VERIFY(QApplication::activePopupWidget());
                    QWidget *popup = QApplication::activePopupWidget();
                    QTest::keyClick(popup->focusWidget() ? popup->focusWidget() : popup, key);
                    QTRY_VERIFY(!QApplication::activePopupWidget());
                    if (byMouse)
                        QTRY_VERIFY(s.canvas().hasFocus());
                    else
                        QVERIFY(combo->hasFocus() || combo->isAncestorOf(QApplication::focusWidget()));
                }
        }
        QVERIFY2(lists > 1, qPrintable(QString::number(lists)));
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

    /// Shift+Tab leads from the first field of a tool's row to the canvas, which is said as it is of a dock.
    void goingBackToTheCanvasIsSaid()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        QCoreApplication::processEvents();
        auto *focus = s.window.findChild<KeyboardFocus *>();
        s.canvas().setFocus();
        for (int i = 0; i < 20 && !qobject_cast<NumberField *>(QApplication::focusWidget()); ++i)
            focus->walk(true);
        auto *first = qobject_cast<NumberField *>(QApplication::focusWidget());
        QVERIFY(first);
        for (int i = 0; i < 40 && !s.canvas().hasFocus(); ++i)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab, Qt::ShiftModifier);
        QVERIFY(s.canvas().hasFocus());
        QCOMPARE(s.window.statusBar()->currentMessage(), QString("The canvas has the keyboard."));
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

    /// While a list that drops down is closed, a letter may have been meant for the canvas. Once it is open, it
    /// chooses.
    void lettersChooseInAnOpenList()
    {
        Session s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.paintLine({200, 150}, {400, 150});
        s.use(Command::SelectAll);
        s.editor().push(groupSelection(s.editor().document(), "group"), "group");
        auto *dock = s.window.findChild<QDockWidget *>("inspectorDock");
        dock->show();
        dock->raise();
        s.editor().laterChanges().flush();
        QApplication::processEvents();
        QComboBox *modes = nullptr;
        for (QComboBox *combo : dock->findChildren<QComboBox *>())
            if (combo->findText("Multiply") >= 0 && combo->isVisible())
                modes = combo;
        QVERIFY(modes);
        const auto mode = [&] { return s.painting().groups.front().blend; };
        modes->setFocus();
        QTest::keyClick(modes, 'm');
        QCOMPARE(mode(), BlendMode::Normal);
        QVERIFY(!s.window.statusBar()->currentMessage().isEmpty());
        QTest::keyClick(modes, Qt::Key_Space);
        QTRY_VERIFY(modes->view()->isVisible());
        QTest::keyClick(modes->view(), 'm');
        QTest::keyClick(modes->view(), Qt::Key_Return);
        QTRY_COMPARE(mode(), BlendMode::Multiply);
    }

    void returnTakesTheToolOfItsButton()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        QAction &eraser = s.window.action(Command::Eraser);
        QToolButton *button = nullptr;
        for (QToolButton *one : s.window.findChildren<QToolButton *>())
            if (one->defaultAction() == &eraser && one->isVisible())
                button = one;
        QVERIFY(button);
        button->setFocus(Qt::TabFocusReason);
        QVERIFY(button->hasFocus());
        QTest::keyClick(button, Qt::Key_Return);
        QVERIFY(eraser.isChecked());
        QVERIFY(s.canvas().hasFocus());
    }

    /// Qt would take the keyboard to the next panel, whose arrows do something else: those of the timeline change the
    /// moment, for example.
    void arrowsStayInThePanel()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        int buttons = 0;
        for (QToolBar *bar : s.window.findChildren<QToolBar *>())
            for (QToolButton *button : bar->findChildren<QToolButton *>()) {
                if (!button->isVisible() || !button->isEnabled() || !(button->focusPolicy() & Qt::TabFocus))
                    continue;
                ++buttons;
                for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Left, Qt::Key_Down, Qt::Key_Right}) {
                    button->setFocus(Qt::TabFocusReason);
                    QTest::keyClick(button, key);
                    QVERIFY2(bar->isAncestorOf(QApplication::focusWidget()), qPrintable(button->text()));
                }
            }
        QVERIFY(buttons > 10);
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

    /// Delete and undo in the list: the row that comes back is the one from which the arrow keys go on, and the status
    /// bar goes on to say who has the keyboard, not what a drag on the canvas does.
    /// The canvas takes the keyboard where the pointer comes to it, but not where a menu closes above which it rests.
    void aMenuThatClosesLeavesTheKeyboard()
    {
        Session s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        auto *panel = s.window.findChild<StrokesPanel *>();
        auto *dock = s.window.findChild<QDockWidget *>("strokesDock");
        dock->show();
        dock->raise();
        const auto enter = [&](QPoint at) {
            const QPoint global = s.canvas().mapToGlobal(at);
            QCursor::setPos(global);
            QEnterEvent event(at, at, global);
            QCoreApplication::sendEvent(&s.canvas(), &event);
        };
        const auto leave = [&] {
            QEvent event(QEvent::Leave);
            QCoreApplication::sendEvent(&s.canvas(), &event);
        };
        enter({100, 100});
        panel->view()->setFocus();
        leave(); // as where a menu opens
        enter({100, 100});
        QVERIFY(panel->view()->hasFocus());
        leave();
        enter({150, 100});
        QVERIFY(s.canvas().hasFocus());
    }

    /// The menu of the row with the frame, wherever in the list that is: a group's has mode and opacity.
    void theMenuOfARowIsReachedByKeys()
    {
        Session s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        for (double y : {150.0, 200.0, 250.0})
            s.paintLine({200, y}, {400, y});
        s.editor().document().setSelection({{1}, {}});
        s.editor().push(groupSelection(s.editor().document(), "low"), "group");
        s.editor().document().setSelection({});
        s.editor().laterChanges().flush();
        auto *panel = s.window.findChild<StrokesPanel *>();
        auto *dock = s.window.findChild<QDockWidget *>("strokesDock");
        dock->show();
        dock->raise();
        panel->view()->setFocus();
        panel->view()->setCurrentIndex(panel->view()->model()->index(2, 0));
        QApplication::processEvents();
        const auto inMenu = [&](const std::function<void(QWidget &)> &act) {
            bool any = false;
            QTimer::singleShot(0, &s.window, [&] {
                if (QWidget *menu = QApplication::activePopupWidget()) {
                    any = true;
                    act(*menu);
                }
                while (QWidget *left = QApplication::activePopupWidget())
                    left->close();
            });
            s.use(Command::CanvasMenu);
            s.window.activateWindow(); // not every platform goes back from a menu by itself
            return any && QTest::qWaitForWindowActive(&s.window);
        };
        const auto group = [&] { return s.painting().groups.front(); };
        QVERIFY(inMenu([](QWidget &menu) { QTest::keyClick(&menu, Qt::Key_H); }));
        QVERIFY(!group().visible);
        QTest::keyClick(panel->view(), Qt::Key_Down);
        QTest::keyClick(panel->view(), Qt::Key_F2);
        auto *name = qobject_cast<QLineEdit *>(QApplication::focusWidget());
        QVERIFY(name && panel->view()->isAncestorOf(name));
        QTest::keyClicks(name, "apple");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(group().name, QString("apple"));
        QVERIFY(panel->view()->hasFocus());
        QVERIFY(inMenu([](QWidget &menu) { QTest::keyClick(&menu, Qt::Key_O); }));
        QVERIFY(group().visible);
        QVERIFY(inMenu([](QWidget &menu) {
            QTest::keyClick(&menu, Qt::Key_M);
            QWidget *modes = QApplication::activePopupWidget();
            QVERIFY(modes && modes != &menu);
            QTest::keyClick(modes, Qt::Key_Down);
            QTest::keyClick(modes, Qt::Key_Return);
        }));
        QVERIFY(group().blend != BlendMode::Normal);
        QVERIFY(panel->view()->hasFocus());
        QVERIFY(inMenu([](QWidget &menu) { QTest::keyClick(&menu, Qt::Key_P); }));
        auto *field = qobject_cast<QLineEdit *>(QApplication::focusWidget());
        QVERIFY(field && panel->view()->isAncestorOf(field));
        QTest::keyClicks(field, "50");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(group().opacity, 0.5f);
        QTRY_VERIFY(panel->view()->hasFocus());
        QVERIFY(inMenu([](QWidget &menu) { QTest::keyClick(&menu, Qt::Key_P); }));
        QTest::keyClicks(QApplication::focusWidget(), "20");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(panel->view()->hasFocus());
        QCOMPARE(group().opacity, 0.5f);
        QTest::keyClick(panel->view(), Qt::Key_Up);
        QCOMPARE(panel->view()->currentIndex().row(), 1);
        QTest::keyClick(panel->view(), Qt::Key_Escape);
        QVERIFY(s.canvas().hasFocus());
    }

    void theListGoesOnFromWhatAnUndoSelects()
    {
        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        std::vector<StrokeId> ids{s.id}; // bottom to top
        for (const double y : {350.0, 400.0, 450.0, 500.0})
            ids.push_back(s.addWave(200, y, false));
        auto *strokes = s.window.findChild<QDockWidget *>("strokesDock");
        auto *panel = strokes->findChild<StrokesPanel *>();
        QTreeView *tree = panel->view();
        const auto *hint = s.window.statusBar()->findChild<QLabel *>("hint");
        QVERIFY(hint);
        const QString ofTool = hint->text();
        s.canvas().setFocus();
        for (int i = 0; i < 20 && !strokes->isAncestorOf(QApplication::focusWidget()); ++i)
            s.window.findChild<KeyboardFocus *>()->walk(true);
        QVERIFY(strokes->isAncestorOf(QApplication::focusWidget()));
        tree->setFocus();
        QTest::keyClick(tree, Qt::Key_Home);
        QTest::keyClick(tree, Qt::Key_Down);
        QCOMPARE(s.selection().strokes, std::set{ids[3]});
        QTest::keyClick(tree, Qt::Key_Delete);
        QVERIFY(!s.painting().find(ids[3]));
        QTest::keyClick(tree, Qt::Key_Z, Qt::ControlModifier);
        QCoreApplication::processEvents();
        QVERIFY(tree->hasFocus());
        QCOMPARE(s.selection().strokes, std::set{ids[3]});
        QCOMPARE(tree->currentIndex().siblingAtColumn(0), panel->viewIndexOf(ids[3]));
        const QString said = "The Strokes dock has the keyboard; Esc gives it back to the canvas.";
        QCOMPARE(hint->text(), said);
        QTest::keyClick(tree, Qt::Key_Down);
        QCOMPARE(s.selection().strokes, std::set{ids[2]});
        // What is selected besides the row leaves it as it is.
        s.editor().document().setSelection({{ids.begin(), ids.end()}, {}});
        s.editor().laterChanges().flush();
        QCOMPARE(tree->currentIndex().siblingAtColumn(0), panel->viewIndexOf(ids[2]));
        QTest::keyClick(tree, Qt::Key_Escape);
        QVERIFY(s.canvas().hasFocus());
        QCOMPARE(hint->text(), ofTool);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestKeyboard)
#include "test_keyboard.moc"

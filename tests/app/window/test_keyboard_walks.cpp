// The way through the window without the mouse: F6 and Tab from panel to panel, arrows through rows, and the way back.
#include "app/panels/strokes/strokes_panel.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/window/hands_on_widgets.h"
#include "undo/layers/group_edits.h"

#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QTreeView>

#include <functional>

using namespace suffuse;

namespace {

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

} // namespace

class TestKeyboardWalks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
    }

    void init() { window_layout::reset(); }

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

    /// Delete and undo in the list: the row that comes back is the one from which the arrow keys go on, and the status
    /// bar goes on to say who has the keyboard, not what a drag on the canvas does.
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

QTEST_MAIN(TestKeyboardWalks)
#include "test_keyboard_walks.moc"

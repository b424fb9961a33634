// Who has the keyboard, and what the keys reach: nothing is altered that was not meant.
#include "app/panels/strokes/strokes_panel.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/window_layout.h"
#include "tests/app/window/hands_on_widgets.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QShortcutEvent>
#include <QStatusBar>
#include <QTabBar>
#include <QToolButton>
#include <QTreeView>

using namespace suffuse;

namespace {

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
                for (const QKeyCombination keys : typed) {
                    // Of those with Shift Qt's table decides there; see keysWithShiftAreFoundByQt.
                    if (own.contains(QKeySequence(keys)) || (shift && keys.keyboardModifiers() == Qt::ShiftModifier))
                        continue;
                    QVERIFY2(isTaken(*widget, keys), qPrintable(panel->objectName() + ' ' + widget->accessibleName() +
                                                                ' ' + QKeySequence(keys).toString()));
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

    /// Whoever has the keyboard has all of it: letters that are typed in the timeline or among the strokes take no
    /// tool, and the status bar says why.
    void lettersStayInThePanel_data()
    {
        QTest::addColumn<QString>("dock");
        QTest::addColumn<QByteArray>("view");
        QTest::newRow("Timeline") << "timelineDock" << QByteArray("suffuse::TimelineView");
        QTest::newRow("Strokes") << "strokesDock" << QByteArray("suffuse::StrokesView");
    }
    void lettersStayInThePanel()
    {
        QFETCH(QString, dock);
        QFETCH(QByteArray, view);

        WaveSession s;
        QVERIFY(QTest::qWaitForWindowActive(&s.window));
        s.use(Command::Select);
        auto *panel = s.window.findChild<QDockWidget *>(dock);
        panel->raise();
        QWidget *typed = nullptr;
        for (QWidget *widget : focusableIn(*panel))
            typed = widget->inherits(view.constData()) ? widget : typed;
        QVERIFY(typed);
        QTest::mouseClick(static_cast<QAbstractScrollArea *>(typed)->viewport(), Qt::LeftButton, {}, {40, 8});
        QCoreApplication::processEvents();
        QVERIFY(typed->hasFocus());
        s.window.statusBar()->clearMessage();
        const Brush inHand = s.editor().brush();
        const QKeySequence brush = s.window.action(Command::Brush).shortcut();
        QTest::keyClick(typed, brush[0].key(), brush[0].keyboardModifiers());
        QTest::keyClick(typed, Qt::Key_4);
        QVERIFY(s.window.action(Command::Select).isChecked());
        QCOMPARE(s.editor().brush(), inHand);
        QCOMPARE(s.window.statusBar()->currentMessage(),
                 QString("The %1 dock has the keyboard; Esc gives it back to the canvas.").arg(panel->windowTitle()));
        QTest::keyClick(typed, Qt::Key_Escape);
        QTest::keyClick(&s.canvas(), brush[0].key(), brush[0].keyboardModifiers());
        QVERIFY(s.window.action(Command::Brush).isChecked());
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
        int tabs = 0;
        for (auto *bar : s.window.findChildren<QTabBar *>(Qt::FindDirectChildrenOnly)) { // of docks over each other
            bar->setFocus();
            if (!bar->hasFocus())
                continue;
            QTest::keyClick(bar, Qt::Key_Escape);
            QVERIFY(s.canvas().hasFocus());
            ++tabs;
        }
        QVERIFY(tabs > 0);
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
        // Of what Qt finds then, the panel's own goes through, and of the canvas' none.
        const auto isStopped = [&s](Command command) {
            QAction &action = s.window.action(command);
            QShortcutEvent event(action.shortcut(), 0, true); // ambiguous: the action says so and does nothing
            return s.window.findChild<KeyboardFocus *>()->eventFilter(&action, &event);
        };
        QVERIFY(!isStopped(Command::ToEnd));
        QVERIFY(!isStopped(Command::ToStart));
        QVERIFY(isStopped(Command::Favourite1));
        QVERIFY(isStopped(Command::Brush));
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

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestKeyboard)
#include "test_keyboard.moc"

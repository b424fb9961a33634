// A hand without sense: it presses, drags, types and clicks whatever the window has, the same for the same seed.
#pragma once

#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "tests/app/session.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QMimeData>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>

#include <random>

namespace suffuse {

class Monkey {
public:
    Monkey(Session &session, unsigned seed)
        : m_session(session), m_random(seed), m_tip(device(QPointingDevice::PointerType::Pen)),
          m_eraser(device(QPointingDevice::PointerType::Eraser))
    {
        for (const Deed &deed : deeds())
            m_weights += deed.weight;
        // Whatever waits for an answer gets one.
        m_answers.setInterval(10);
        QObject::connect(&m_answers, &QTimer::timeout, [this] {
            if (QWidget *popup = QApplication::activePopupWidget())
                popup->close();
            else if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget()))
                oneIn(2) ? dialog->accept() : dialog->reject();
        });
        m_answers.start();
    }

    /// One event or action at random. With the pointer down mostly a drag, but whatever else now and then.
    void act()
    {
        const bool drags = (m_down || m_pen) && !oneIn(6);
        const Deed deed = drags ? Deed{0, "drag", oneIn(5) ? &Monkey::lift : &Monkey::move} : anyDeed();
        m_detail.clear();
        if (m_loud)
            qInfo("%s …", deed.name);
        (this->*deed.act)();
        if (m_loud)
            qInfo("    %s", qPrintable(m_detail));
        m_trail << QString::fromLatin1(deed.name) + ' ' + m_detail;
        if (m_trail.size() > 30)
            m_trail.removeFirst();
        QCoreApplication::processEvents();
    }

    /// Lifts the pointer, gives up what is in hand and closes what is open.
    void letGo()
    {
        lift();
        m_session.canvas().tool()->cancel();
        for (AlongDialog *dialog : m_session.window.findChildren<AlongDialog *>())
            dialog->close();
        m_session.editor().clock().setManual(true);
        QCoreApplication::processEvents();
    }

    /// What it did last, for whoever looks for a mistake.
    QString trail() const { return m_trail.join('\n'); }

    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

private:
    struct Deed {
        int weight;
        const char *name;
        void (Monkey::*act)();
    };
    static const std::vector<Deed> &deeds()
    {
        static const std::vector<Deed> all{
            {70, "press", &Monkey::press},
            {40, "hover", &Monkey::move},
            {25, "pen", &Monkey::penDown},
            {15, "click", &Monkey::click},
            {12, "double click", &Monkey::doubleClick},
            {30, "tool", &Monkey::chooseTool},
            {40, "key", &Monkey::key},
            {8, "wheel", &Monkey::wheel},
            {60, "command", &Monkey::command},
            {20, "undo", &Monkey::undoOrRedo},
            {4, "history", &Monkey::history},
            {30, "field", &Monkey::field},
            {15, "slider", &Monkey::slider},
            {6, "button", &Monkey::button},
            {6, "choice", &Monkey::choice},
            {8, "row", &Monkey::strokesRow},
            {10, "drop", &Monkey::dropRows},
            {4, "search", &Monkey::search},
            {25, "select", &Monkey::select},
            {5, "curves", &Monkey::pasteCurves},
            {15, "time", &Monkey::time},
            {15, "along", &Monkey::along},
            {8, "home", &Monkey::home},
        };
        return all;
    }

    Deed anyDeed()
    {
        int at = below(m_weights);
        for (const Deed &deed : deeds())
            if ((at -= deed.weight) < 0)
                return deed;
        return deeds().front();
    }

    static QPointingDevice *device(QPointingDevice::PointerType type)
    {
        return new QPointingDevice("monkey", 11, QInputDevice::DeviceType::Stylus, type,
                                   QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1,
                                   QString(), QPointingDeviceUniqueId(), QCoreApplication::instance());
    }

    bool oneIn(int n) { return below(n) == 0; }
    CanvasWidget &canvas() { return m_session.canvas(); }
    const Painting &painting() { return m_session.painting(); }

    Qt::KeyboardModifiers modifiers()
    {
        Qt::KeyboardModifiers result;
        if (oneIn(2))
            return result;
        result.setFlag(Qt::ShiftModifier, oneIn(3));
        result.setFlag(Qt::ControlModifier, oneIn(3));
        result.setFlag(Qt::AltModifier, oneIn(4));
        return result;
    }

    /// On a node, a curve or a handle, or anywhere on the canvas; logical pixels.
    QPointF somewhere()
    {
        if (oneIn(4) || painting().strokes.empty())
            return {real(0, canvas().width()), real(0, canvas().height())};
        const Stroke &stroke = *painting().strokes[std::size_t(below(int(painting().strokes.size())))];
        const Cubic curve = stroke.cubicOf(stroke.segments[std::size_t(below(int(stroke.segments.size())))]);
        const Point p = oneIn(2) ? curve.p[std::size_t(below(4))] : curve.at(real(0, 1));
        return QPointF(m_session.at(p));
    }

    void mouse(QEvent::Type type, Qt::KeyboardModifiers with)
    {
        const bool move = type == QEvent::MouseMove;
        const bool down = move ? m_down : type != QEvent::MouseButtonRelease;
        QMouseEvent event(type, m_at, canvas().mapToGlobal(m_at), move ? Qt::NoButton : m_button,
                          down ? Qt::MouseButtons(m_button) : Qt::NoButton, with);
        QCoreApplication::sendEvent(&canvas(), &event);
        m_detail = QStringLiteral("%1, %2, modifiers %3").arg(m_at.x()).arg(m_at.y()).arg(with.toInt(), 0, 16);
    }

    void pen(QEvent::Type type)
    {
        QTabletEvent event(type, m_pen, m_at, canvas().mapToGlobal(m_at), real(0, 1), 0, 0, 0, 0, 0, modifiers(),
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&canvas(), &event);
        if (type == QEvent::TabletRelease)
            m_pen = nullptr;
    }

    void press()
    {
        if (m_pen)
            return;
        m_at = somewhere();
        if (!m_down)
            m_button = oneIn(12) ? Qt::MiddleButton : oneIn(12) ? Qt::RightButton : Qt::LeftButton;
        m_down = true;
        mouse(QEvent::MouseButtonPress, modifiers());
    }
    void move()
    {
        m_session.advance(interval / 2);
        m_at = oneIn(6) ? somewhere() : m_at + QPointF(real(-30, 30), real(-30, 30));
        m_pen ? pen(QEvent::TabletMove) : mouse(QEvent::MouseMove, modifiers());
    }
    void release()
    {
        if (m_down)
            mouse(QEvent::MouseButtonRelease, modifiers());
        m_down = false;
    }
    void penDown()
    {
        if (m_down || m_pen)
            return;
        m_at = somewhere();
        m_pen = oneIn(3) ? m_eraser : m_tip;
        pen(QEvent::TabletPress);
    }
    void lift() { m_pen ? pen(QEvent::TabletRelease) : release(); }
    void click()
    {
        release();
        press();
        release();
    }
    void doubleClick()
    {
        click();
        if (m_pen)
            return;
        m_down = true;
        mouse(QEvent::MouseButtonDblClick, modifiers());
        if (oneIn(2))
            release();
    }

    void chooseTool()
    {
        m_session.use(Command(int(Command::Brush) + below(int(Command::Pan) - int(Command::Brush) + 1)));
        m_detail = QString::fromLatin1(canvas().tool()->metaObject()->className());
    }

    void key()
    {
        static constexpr Qt::Key keys[] = {Qt::Key_Left,  Qt::Key_Right,  Qt::Key_Up,          Qt::Key_Down,
                                           Qt::Key_Tab,   Qt::Key_Escape, Qt::Key_Delete,      Qt::Key_Backspace,
                                           Qt::Key_Space, Qt::Key_R,      Qt::Key_BracketLeft, Qt::Key_BracketRight,
                                           Qt::Key_Enter, Qt::Key_Escape, Qt::Key_Home,        Qt::Key_PageUp};
        const Qt::Key key = keys[std::size_t(below(int(std::size(keys))))];
        const Qt::KeyboardModifiers with = modifiers();
        m_detail = QStringLiteral("%1 %2").arg(int(key), 0, 16).arg(with.toInt(), 0, 16);
        QTest::keyClick(&canvas(), key, with);
    }
    void wheel()
    {
        QWheelEvent event(m_at, canvas().mapToGlobal(m_at), {}, {0, oneIn(2) ? 120 : -120}, Qt::NoButton, modifiers(),
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    void home()
    {
        m_session.use(Command::Fit);
        if (oneIn(2))
            m_session.use(Command::ResetRotation);
    }

    /// Whatever opens a window or ends this one is left out; by custom such an action ends in dots.
    void command()
    {
        using enum Command;
        const Command which = Command(below(int(About) + 1));
        QAction &action = m_session.window.action(which);
        const bool asks = action.text().endsWith(QStringLiteral("…")) && which != RenameStrokes && which != GridStep;
        if (asks || !action.isEnabled() || which == Save || which == Close || which == Quit || which == FullScreen)
            return;
        m_detail = action.objectName();
        action.trigger();
    }
    void undoOrRedo() { m_session.use(oneIn(3) ? Command::Redo : Command::Undo); }
    /// As a click into the list of steps does.
    void history()
    {
        QUndoStack &stack = m_session.editor().undoStack();
        const int to = std::clamp(stack.index() + below(9) - 4, 0, stack.count());
        m_detail = QString::number(to);
        stack.setIndex(to);
    }

    /// In a dock or in the row over the canvas; null where there is none in reach.
    template <typename T>
    T *any(const std::function<bool(const T &)> &wanted)
    {
        QList<T *> found;
        for (T *widget : m_session.window.findChildren<T *>())
            if (widget->isEnabled() && widget->isVisible() && wanted(*widget))
                found << widget;
        return found.isEmpty() ? nullptr : found[below(int(found.size()))];
    }
    void field()
    {
        auto *line = any<NumberField>([](const NumberField &) { return true; });
        if (!line)
            return;
        static const char *const texts[] = {"5",   "0.3", "12*1.5", "*1.2", "+2", "-=3",
                                            "100", "1e9", "x",      "0",    "45", "/3"};
        line->setFocus();
        line->setText(QString::fromLatin1(texts[below(int(std::size(texts)))]));
        m_detail = line->accessibleName() + ' ' + line->text();
        QTest::keyClick(line, oneIn(4) ? Qt::Key_Up : Qt::Key_Return);
    }
    void slider()
    {
        auto *slider = any<QSlider>([](const QSlider &) { return true; });
        if (!slider)
            return;
        m_detail = slider->accessibleName();
        const auto place = [&] { return QPoint(below(std::max(1, slider->width())), slider->height() / 2); };
        QTest::mousePress(slider, Qt::LeftButton, {}, place());
        for (int i = below(4); i > 0; --i)
            QTest::mouseMove(slider, place());
        if (oneIn(6))
            m_session.use(Command::Undo);
        QTest::mouseRelease(slider, Qt::LeftButton, {}, place());
    }
    /// None of the title bars' and none that asks.
    void button()
    {
        auto *button = any<QAbstractButton>([](const QAbstractButton &b) {
            const auto *tool = qobject_cast<const QToolButton *>(&b);
            return !b.text().endsWith(QStringLiteral("…")) && !b.objectName().startsWith("qt_") &&
                   !(tool && (tool->menu() || tool->defaultAction()));
        });
        if (!button)
            return;
        m_detail = button->accessibleName() + ' ' + button->text() + ' ' + button->toolTip();
        button->click();
    }
    void choice()
    {
        if (auto *combo = any<QComboBox>([](const QComboBox &) { return true; }))
            QTest::keyClick(combo, oneIn(2) ? Qt::Key_Down : Qt::Key_Up);
    }

    StrokesPanel &strokes() { return *m_session.window.findChild<StrokesPanel *>(); }
    QModelIndex anyRow()
    {
        StrokesModel &model = *strokes().model();
        QModelIndex at;
        for (int depth = 0; depth < 3; ++depth) {
            const int rows = model.rowCount(at);
            if (rows == 0 || (depth > 0 && oneIn(2)))
                break;
            at = model.index(below(rows), 0, at);
        }
        return at;
    }
    void strokesRow()
    {
        StrokesModel &model = *strokes().model();
        const QModelIndex row = anyRow();
        if (!row.isValid())
            return;
        const int what = below(3);
        m_detail = QString::number(what);
        if (what == 0)
            model.toggle(row.siblingAtColumn(oneIn(2) ? StrokesModel::EyeColumn : StrokesModel::LockColumn));
        else if (what == 1)
            model.setData(row, QString::number(below(100)), Qt::EditRole);
        else if (QTreeView *view = strokes().view(); view->model()->rowCount() > 0)
            view->setCurrentIndex(view->model()->index(below(view->model()->rowCount()), 0));
    }
    void dropRows()
    {
        StrokesModel &model = *strokes().model();
        QModelIndexList rows;
        for (int i = below(3); i >= 0; --i)
            if (const QModelIndex row = anyRow(); row.isValid())
                rows << row;
        if (rows.isEmpty())
            return;
        const std::unique_ptr<QMimeData> data(model.mimeData(rows));
        const QModelIndex onto = oneIn(2) ? anyRow() : QModelIndex();
        const int at = below(model.rowCount(onto) + 1);
        if (data && model.canDropMimeData(data.get(), Qt::MoveAction, at, 0, onto))
            model.dropMimeData(data.get(), Qt::MoveAction, at, 0, onto);
    }
    void search() { strokes().search()->setText(oneIn(2) ? QString() : QString::number(below(10))); }

    void select()
    {
        Selection selection;
        for (int i = below(4); i > 0 && !painting().strokes.empty(); --i) {
            const Stroke &stroke = *painting().strokes[std::size_t(below(int(painting().strokes.size())))];
            selection.strokes.insert(stroke.id);
            if (oneIn(2))
                selection.segments.insert({stroke.id, below(int(stroke.segments.size()))});
        }
        m_session.editor().document().setSelection(selection);
    }
    void pasteCurves()
    {
        QGuiApplication::clipboard()->setText(
            QStringLiteral("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"M 0 0 C %1 0 0 %2 90 90 L 200 %1\" "
                           "stroke=\"#%3\" fill=\"none\"/></svg>")
                .arg(below(300))
                .arg(below(300))
                .arg(below(0xffffff), 6, 16, QLatin1Char('0')));
        m_session.use(oneIn(2) ? Command::Paste : Command::PasteInPlace);
    }
    void time()
    {
        Editor &editor = m_session.editor();
        switch (below(4)) {
        case 0:
            return m_session.advance(Microseconds(real(0, 2e6)));
        case 1:
            return editor.clock().setTime(painting().end());
        case 2:
            return editor.clock().setTime(Microseconds(real(-1e5, 1.2) * double(painting().end())));
        default:
            return editor.clock().setManual(!editor.clock().isManual());
        }
    }
    /// The dialog "Along the Stroke", which is open while other things go on.
    void along()
    {
        auto *panel = m_session.window.findChild<InspectorPanel *>();
        AlongDialog *dialog = panel->along();
        if (!dialog)
            return panel->alongButton()->click();
        const int what = below(6);
        m_detail = QString::number(what);
        if (what == 0)
            dialog->choose(curveQuantities[std::size_t(below(int(std::size(curveQuantities))))]);
        else if (what == 1)
            dialog->choose(AlongDialog::Shape(below(3)));
        else if (what == 2)
            oneIn(2) ? dialog->accept() : dialog->reject();
        else
            QTest::mouseClick(dialog->curve(), Qt::LeftButton, {},
                              QPoint(below(dialog->curve()->width()), below(dialog->curve()->height())));
    }

    Session &m_session;
    std::mt19937 m_random;
    QTimer m_answers;
    QPointingDevice *m_tip, *m_eraser;
    int m_weights = 0;
    bool m_down = false;
    Qt::MouseButton m_button = Qt::LeftButton;
    const QPointingDevice *m_pen = nullptr; ///< that is down
    QPointF m_at;
    QStringList m_trail;
    QString m_detail;
    bool m_loud = qEnvironmentVariableIsSet("SUFFUSE_MONKEY_TRACE");
};

} // namespace suffuse

// A hand without sense: it presses, drags, types and clicks whatever the window has, the same for the same seed.
#pragma once

#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/tools/text/font_box.h"
#include "app/tools/tool_options.h"
#include "tests/app/random_controls.h"
#include "tests/app/session.h"

#include <QClipboard>
#include <QMap>
#include <QMenu>
#include <QMimeData>
#include <QRegularExpression>
#include <QTreeView>
#include <QWheelEvent>

#include <random>

namespace suffuse {

class Monkey {
public:
    Monkey(Session &session, unsigned seed)
        : m_session(session), m_random(seed),
          m_controls(m_random, [](const QAction &action) { return mayRun(action); }),
          m_tip(device(QPointingDevice::PointerType::Pen)), m_eraser(device(QPointingDevice::PointerType::Eraser))
    {
        for (const Deed &deed : deeds())
            m_weights += deed.weight;
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
        count(QStringLiteral("event: ") + QLatin1String(deed.name));
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

    /// Counts something by its name; numbers in it do not matter.
    void count(QString what)
    {
        static const QRegularExpression numbers(QStringLiteral("[0-9]+"));
        ++m_counts[what.replace(numbers, QStringLiteral("n"))];
    }
    /// How often what was done: events, commands, tools that were pressed, and whatever the caller has counted.
    QString counts() const
    {
        QString all;
        for (auto it = m_counts.begin(); it != m_counts.end(); ++it)
            all += QStringLiteral("%1 %2\n").arg(it.value(), 6).arg(it.key());
        return all;
    }

    int below(int n) { return m_controls.below(n); }
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
            {30, "option", &Monkey::option},
            {20, "poke", &Monkey::poke},
            {12, "type", &Monkey::type},
            {8, "row", &Monkey::strokesRow},
            {10, "menu of a row", &Monkey::rowMenu},
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

    bool oneIn(int n) { return m_controls.oneIn(n); }
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

    /// What is in use, with what was chosen for it.
    void countTool()
    {
        QString tool = QString::fromLatin1(canvas().tool()->metaObject()->className()).remove("suffuse::");
        if (const QWidget *row = canvas().tool()->options())
            if (const auto *first = row->findChild<QComboBox *>(); first && !qobject_cast<const FontBox *>(first))
                tool += ", " + first->currentText();
        count(QStringLiteral("tool: ") + tool);
    }
    void press()
    {
        if (m_pen)
            return;
        m_at = somewhere();
        if (!m_down)
            m_button = oneIn(12) ? Qt::MiddleButton : oneIn(12) ? Qt::RightButton : Qt::LeftButton;
        m_down = true;
        countTool();
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
        countTool();
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
        if (m_session.window.action(Command::HideDocks).isChecked())
            m_session.use(Command::HideDocks);
        if (oneIn(2))
            m_session.use(Command::ResetRotation);
    }

    /// Whatever opens a window or ends this one is left out. By custom such an action ends in dots; those that ask how
    /// paint is to be changed are not left out.
    static bool mayRun(const QAction &action)
    {
        static const QSet<QString> asking{"rename",   "gridStep", "rewet", "recolourArtwork",
                                          "simplify", "vary",     "offset"};
        static const QSet<QString> ending{"save", "close", "quit", "fullScreen"};
        const QString name = action.objectName();
        return !ending.contains(name) && (asking.contains(name) || !action.text().endsWith(QStringLiteral("…")));
    }
    void command()
    {
        QAction &action = m_session.window.action(Command(below(int(Command::About) + 1)));
        if (!mayRun(action) || !action.isEnabled())
            return;
        m_detail = action.objectName();
        count(QStringLiteral("command: ") + m_detail);
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

    void field() { m_detail = m_controls.field(m_session.window); }
    void slider()
    {
        m_detail = m_controls.slider(m_session.window, [this] { m_session.use(Command::Undo); });
    }
    void button() { m_detail = m_controls.button(m_session.window); }
    void choice() { m_detail = m_controls.choice(m_session.window); }
    /// In the row over the canvas.
    void option() { m_detail = m_controls.control(*m_session.window.findChild<ToolOptionsBar *>()); }
    void poke()
    {
        m_detail = m_controls.poke(m_session.window);
        count(QStringLiteral("poke: ") + m_detail);
    }
    /// Letters where a text is in hand; anywhere else they would be commands' keys.
    void type()
    {
        static const QStringList texts{"a", "Suf", "fuse", " ", "gj", QStringLiteral("Ä")};
        if (!canvas().tool()->takesText()) {
            m_session.use(Command::Text);
            click();
        }
        if (!canvas().tool()->takesText())
            return;
        m_detail = texts[below(int(texts.size()))];
        count(QStringLiteral("typed"));
        if (oneIn(5)) { // through an input method
            QInputMethodEvent composed(oneIn(2) ? m_detail : QString(), {});
            composed.setCommitString(oneIn(2) ? QString() : m_detail);
            QCoreApplication::sendEvent(&canvas(), &composed);
        } else if (oneIn(5)) {
            QTest::keyClick(&canvas(), Qt::Key_Return);
        } else {
            QTest::keyClicks(&canvas(), m_detail);
        }
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
    /// Modes and opacity of groups, above all.
    void rowMenu()
    {
        QAbstractItemModel &model = *strokes().view()->model();
        if (model.rowCount() == 0)
            return;
        QModelIndex row = model.index(below(model.rowCount()), 0);
        if (const int rows = model.rowCount(row); rows > 0 && oneIn(4))
            row = model.index(below(rows), 0, row);
        QMenu menu;
        strokes().makeMenu(menu, row);
        m_detail = m_controls.choose(menu);
        count(QStringLiteral("row: ") + m_detail);
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
        if (oneIn(4) && !painting().groups.empty()) {
            const GroupId group = painting().groups[std::size_t(below(int(painting().groups.size())))].id;
            for (const StrokePtr &stroke : painting().strokes)
                if (stroke->group == group)
                    selection.strokes.insert(stroke->id);
            return m_session.editor().document().setSelection(selection);
        }
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
    RandomControls m_controls;
    QPointingDevice *m_tip, *m_eraser;
    int m_weights = 0;
    bool m_down = false;
    Qt::MouseButton m_button = Qt::LeftButton;
    const QPointingDevice *m_pen = nullptr; ///< that is down
    QPointF m_at;
    QStringList m_trail;
    QMap<QString, int> m_counts;
    QString m_detail;
    bool m_loud = qEnvironmentVariableIsSet("SUFFUSE_MONKEY_TRACE");
};

} // namespace suffuse

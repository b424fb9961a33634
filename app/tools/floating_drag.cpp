#include "app/tools/floating_drag.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"

#include <QCoreApplication>
#include <QEvent>
#include <QScopedValueRollback>

namespace suffuse {

namespace {

/// What the map makes of the strokes is what it makes of their picture.
bool mapsPicture(const Affine &map, SpreadRule rule)
{
    constexpr double tiny = 1e-9;
    return rule == SpreadRule::Scales || (map.isSimilarity() && std::abs(std::abs(map.determinant()) - 1) < tiny);
}

} // namespace

FloatingDrag::FloatingDrag(CanvasWidget &canvas, QObject *parent)
    : QObject(parent), m_canvas(canvas), m_drag(canvas.editor())
{
    Editor &editor = canvas.editor();
    connect(&editor.document(), &Document::changed, this, &FloatingDrag::follow);
    connect(&editor, &Editor::dragEnded, this, &FloatingDrag::rest);
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &FloatingDrag::settle);
    connect(&canvas, &CanvasWidget::viewChanged, this, &FloatingDrag::settle);
}

void FloatingDrag::prepare(const std::set<StrokeId> &strokes)
{
    m_liftedAt = m_map = {};
    m_canvas.lift(strokes);
}

void FloatingDrag::show(const Affine &map, SpreadRule rule)
{
    m_map = map;
    m_rule = rule;
    if (!m_canvas.isLifted() || !mapsPicture(map, rule)) {
        setPending(false);
        push();
        m_canvas.updateSelection();
        return;
    }
    setPending(true);
    m_canvas.showFloating(map * m_liftedAt.inverse().value_or(Affine()));
}

/// Returns whether it was.
bool FloatingDrag::setPending(bool pending)
{
    if (pending && !m_pending)
        qApp->installEventFilter(this);
    else if (m_pending && !pending)
        qApp->removeEventFilter(this);
    return std::exchange(m_pending, pending);
}

void FloatingDrag::push()
{
    const QScopedValueRollback pushing(m_pushing, true);
    m_drag.show([this](const Stroke &stroke) { return transformed(stroke, m_map, m_rule); });
}

void FloatingDrag::settle()
{
    if (!setPending(false))
        return;
    const bool floats = m_canvas.isLifted();
    push();
    if (floats)
        m_canvas.settleFloating();
}

/// Strokes that have left the picture are lifted anew.
void FloatingDrag::rest()
{
    settle();
    const Affine since = m_map * m_liftedAt.inverse().value_or(Affine());
    if (!isActive() || (m_canvas.isLifted() && m_canvas.coversFloating(since)))
        return;
    m_liftedAt = m_map;
    m_canvas.lift(m_drag.strokes());
}

void FloatingDrag::follow(const Change &)
{
    if (m_pushing)
        return;
    m_canvas.endLift(); // something else was done
    if (m_pending)
        QMetaObject::invokeMethod(this, &FloatingDrag::settle, Qt::QueuedConnection);
}

bool FloatingDrag::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress ||
        event->type() == QEvent::MouseButtonPress)
        settle(); // it may mean the document
    return QObject::eventFilter(watched, event);
}

void FloatingDrag::giveUp()
{
    m_map = {};
    setPending(false);
    const QScopedValueRollback pushing(m_pushing, true);
    m_drag.giveUp();
    m_canvas.endLift();
}

void FloatingDrag::end()
{
    settle();
    m_drag.end();
    m_canvas.endLift();
}

} // namespace suffuse

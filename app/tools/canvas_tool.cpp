#include "app/tools/canvas_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/editor.h"
#include "app/widgets/habits/at_next_change.h"

#include <QKeyEvent>

#include <utility>

namespace suffuse {

namespace {

std::optional<Point> directionOfArrow(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return Point{-1, 0};
    case Qt::Key_Right:
        return Point{1, 0};
    case Qt::Key_Up:
        return Point{0, -1};
    case Qt::Key_Down:
        return Point{0, 1};
    default:
        return {};
    }
}

} // namespace

CanvasTool::CanvasTool(CanvasWidget &canvas, QObject *parent)
    : Tool(parent), m_canvas(canvas), m_editor(canvas.editor())
{}

void CanvasTool::say(const QString &text)
{
    if (std::exchange(m_said, text) == text)
        return;
    emit hintChanged();
    if (!text.isEmpty())
        atNextChange(m_editor.document(), this, [this] { say({}); });
}

std::optional<Point> CanvasTool::nudgeOf(const QKeyEvent &event) const
{
    const std::optional<Point> direction = directionOfArrow(event.key());
    if (!direction)
        return {};
    // Only the view's rotation and mirroring are taken, since differences of places that are far away are rounded.
    View turned;
    turned.rotation = m_canvas.view().rotation;
    turned.mirrored = m_canvas.view().mirrored;
    const Point unit = turned.toCanvas(*direction);
    // Rounding makes quarter turns exact.
    const auto exact = [](double share) { return std::round(share * 1e12) / 1e12; };
    const double step = (event.modifiers() & Qt::ShiftModifier ? 10 : 1) *
                        (event.modifiers() & Qt::AltModifier ? m_canvas.view().px() : 1);
    return step * Point{exact(unit.x), exact(unit.y)};
}

} // namespace suffuse

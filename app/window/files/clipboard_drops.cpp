#include "app/window/files/clipboard_drops.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/files/clipboard.h"
#include "app/session/selecting/pick.h"
#include "model/colour/colour_shift.h"
#include "undo/colour_edits.h"

#include <QDropEvent>

namespace suffuse {

namespace {

constexpr double dropSlack = 3; ///< logical pixels around the pointer in which hairlines are found

std::optional<SegmentRef> strokeAt(CanvasWidget &canvas, Point point)
{
    const double tolerance = dropSlack * canvas.devicePixelRatioF() / canvas.view().scale;
    return pickTopmost(*canvas.editor().document().painting(), canvas.editor().clock().time(), point, tolerance);
}

/// Colours the stroke or, if it is selected, all that is selected. Each segment keeps its opacity.
void dropColour(Editor &editor, StrokeId id, const Colour &colour)
{
    const Document &document = editor.document();
    const Selection &selection = document.selection();
    const ColourParts parts =
        partsToColour(*document.painting(), selection.strokes.contains(id) ? selection : Selection{{id}, {}});
    editor.push(recolour(document, parts, [&](const Colour &each) { return withOpacity(colour, each.opacity); }),
                CanvasDrops::tr("Drop colour"));
}

bool isOurs(const QMimeData &data)
{
    return data.hasColor() || data.hasFormat(clipboard::strokesMime) || data.hasFormat("image/svg+xml");
}

} // namespace

CanvasDrops::CanvasDrops(CanvasWidget &canvas) : QObject(&canvas), m_canvas(canvas)
{
    canvas.setAcceptDrops(true);
    canvas.installEventFilter(this);
}

bool CanvasDrops::eventFilter(QObject *watched, QEvent *event)
{
    const bool enters = event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove;
    if (watched != &m_canvas || (!enters && event->type() != QEvent::Drop))
        return QObject::eventFilter(watched, event);
    auto *drop = static_cast<QDropEvent *>(event);
    const QMimeData &data = *drop->mimeData();
    const double dpr = m_canvas.devicePixelRatioF();
    const Point point = m_canvas.view().toCanvas({drop->position().x() * dpr, drop->position().y() * dpr});
    // The window opens files that are dropped anywhere on it.
    const bool ours = isOurs(data) && !data.hasUrls();
    const std::optional<SegmentRef> hit =
        ours && data.hasColor() && event->type() != QEvent::DragEnter ? strokeAt(m_canvas, point) : std::nullopt;
    const bool possible = ours && (!data.hasColor() || event->type() == QEvent::DragEnter || hit);
    if (!possible) {
        event->ignore();
        return ours;
    }
    drop->setDropAction(Qt::CopyAction);
    drop->accept();
    if (event->type() != QEvent::Drop)
        return true;
    if (hit)
        dropColour(m_canvas.editor(), hit->stroke, colourOf(data).value_or(Colour{}));
    else if (const QString problem = clipboard::paste(m_canvas.editor(), data, point); !problem.isEmpty())
        emit leftOut(problem);
    return true;
}

} // namespace suffuse

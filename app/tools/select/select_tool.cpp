#include "app/tools/select/select_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/selecting/seen_selection.h"
#include "app/session/selecting/stroke_words.h"
#include "app/session/settings/settings.h"
#include "app/tools/select/select_hints.h"
#include "app/tools/select/transform_bar.h"
#include "app/widgets/numbers/length_units.h"
#include "undo/text_edits.h"
#include "undo/transform_edits.h"

#include <QKeyEvent>
#include <QPainter>

namespace suffuse {

namespace {

using Kind = TransformHandle::Kind;

constexpr double smallEm = 30; ///< logical pixels: letters below this are hard to hit

bool takesAway(const PointerEvent &event)
{
    return event.modifiers & Qt::ShiftModifier && event.modifiers & Qt::ControlModifier;
}

} // namespace

SelectTool::SelectTool(CanvasWidget &canvas, Commands &commands, QObject *parent)
    : SelectionTool(canvas, parent), m_commands(commands)
{
    connect(&m_editor.document(), &Document::changed, this, &SelectTool::followDocument);
    connect(&canvas, &CanvasWidget::begunChanged, this, [this] {
        m_stale = true;
        m_hovered.reset();
    });
}

void SelectTool::followDocument(const Change &change)
{
    m_stale = true;
    if (change.reset || selection().strokes != m_handled) {
        m_handled = selection().strokes;
        m_handles.setMode(TransformHandles::Mode::Scale);
        m_handles.resetCentre();
        m_hovered.reset();
    }
}

const TransformHandles &SelectTool::handles() const
{
    if (m_stale && !isBusy()) {
        m_handles.setBox(m_canvas.selectedCurves());
        m_stale = false;
    }
    return m_handles;
}

void SelectTool::pressed(const PointerEvent &event)
{
    m_touch.reset();
    m_handle = event.modifiers & Qt::AltModifier
                   ? std::nullopt
                   : handles().at(event.pixel, m_canvas.view(), m_canvas.devicePixelRatioF());
    m_hit = m_handle ? std::nullopt : pickPaintOrText(event);
    const bool plain = !(event.modifiers & (Qt::ShiftModifier | Qt::AltModifier));
    m_selectedByPress = m_hit && plain && !selection().strokes.contains(m_hit->stroke);
    if (m_selectedByPress) {
        const bool within = event.modifiers & Qt::ControlModifier; // The click means a stroke within its group.
        select(Selection{within ? std::set<StrokeId>{m_hit->stroke} : groupedWith(m_hit->stroke), {}});
    }
    if (isMoving(event) || (m_handle && m_handle->kind != Kind::Centre))
        m_canvas.lifted().lift(m_canvas.selection().strokes);
}

/// What a click on a stroke means.
std::set<StrokeId> SelectTool::groupedWith(StrokeId stroke) const
{
    return withGroup(*m_editor.layer().reached(), stroke, m_editor.layer().reachedGroup());
}

/// The paint under the pointer or, where none lies above it, a small text in whose line the pointer is.
std::optional<SegmentRef> SelectTool::pickPaintOrText(const PointerEvent &event)
{
    const std::optional<SegmentRef> paint = pick(event);
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const std::optional<SegmentRef> text =
        pickSmallText(painting, m_editor.clock().time(), m_canvas.view(), smallEm * m_canvas.devicePixelRatioF(),
                      event.point, tolerance(), m_layout);
    if (!text || !paint)
        return text ? text : paint;
    const bool isLetter = painting.find(paint->stroke)->group == painting.find(text->stroke)->group;
    const bool isAbove = painting.indexOf(paint->stroke) > painting.indexOf(text->stroke);
    return isLetter || isAbove ? paint : text;
}

bool SelectTool::isMoving(const PointerEvent &event) const
{
    return m_hit && !(event.modifiers & (Qt::ShiftModifier | Qt::AltModifier)) &&
           selection().strokes.contains(m_hit->stroke);
}

void SelectTool::release(const PointerEvent &event)
{
    SelectionTool::release(event);
    if (!selection().isEmpty())
        settings::setHasSelected();
    m_canvas.lifted().endLift(); // The press was only a click, so nothing floats any more.
}

void SelectTool::cancel()
{
    SelectionTool::cancel();
    m_canvas.lifted().endLift();
}

void SelectTool::clicked(const PointerEvent &event)
{
    say({});
    const std::optional<TransformHandle> handle = std::exchange(m_handle, std::nullopt);
    const bool centre = handle && handle->kind == Kind::Centre;
    const bool resets = centre && event.modifiers & Qt::ShiftModifier;
    if (resets)
        m_handles.resetCentre();
    else if (centre)
        m_hit = pickPaintOrText(event); // The handle only lies over the paint that was meant.
    if (resets || (handle && !centre)) {
        // A click on a handle does nothing without a drag.
    } else if (event.modifiers & Qt::AltModifier) {
        clickedBelow(event);
    } else if (m_hit) {
        clickedStroke(event);
    } else if (!(event.modifiers & Qt::ShiftModifier)) {
        select({});
    }
}

void SelectTool::clickedStroke(const PointerEvent &event)
{
    const bool turned = std::exchange(m_turnedByClick, false);
    if (event.modifiers & Qt::ShiftModifier) {
        const std::set<StrokeId> meant =
            event.modifiers & Qt::ControlModifier ? std::set<StrokeId>{m_hit->stroke} : groupedWith(m_hit->stroke);
        select(toggled(selection(), m_hit->stroke, meant));
    } else if (start().doubleClick) {
        if (turned)
            m_handles.setMode(TransformHandles::Mode::Scale);
        const Painting &painting = *m_editor.document().painting();
        const StrokePtr letter = painting.find(m_hit->stroke);
        if (const GroupId text = letter ? textAround(painting, *letter) : 0) {
            emit textAsked(event, text);
            return;
        }
        select(Selection{{m_hit->stroke}, {}}); // of a group the one
        emit valuesAsked(event, *m_hit);
    } else if (event.modifiers & Qt::ControlModifier) {
        select(Selection{{m_hit->stroke}, {}});
    } else if (!selection().segments.empty()) {
        select(Selection{selection().strokes, {}}); // The frame is round whole strokes, and so are the next commands.
    } else if (!m_selectedByPress) {
        const bool scales = m_handles.mode() == TransformHandles::Mode::Scale;
        m_handles.setMode(scales ? TransformHandles::Mode::Turn : TransformHandles::Mode::Scale);
        m_turnedByClick = scales;
    }
}

void SelectTool::clickedBelow(const PointerEvent &event)
{
    const std::vector<SegmentRef> hits =
        pickAll(*m_editor.layer().reached(), m_editor.clock().time(), event.point, tolerance());
    if (hits.empty())
        return;
    const std::size_t next = nextBelow(hits, selection());
    Selection chosen;
    if (event.modifiers & Qt::ShiftModifier)
        chosen = selection();
    if (event.modifiers & Qt::ControlModifier)
        chosen.strokes.insert(hits[next].stroke);
    else
        chosen.strokes.merge(groupedWith(hits[next].stroke));
    select(std::move(chosen));
    say(tr("Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.")
            .arg(next + 1)
            .arg(hits.size()));
}

BandShape SelectTool::bandShape(const PointerEvent &event) const
{
    if (event.modifiers & Qt::AltModifier || m_commands[Command::TouchPath].isChecked())
        return BandShape::Touch;
    return m_commands[Command::Lasso].isChecked() ? BandShape::Lasso : BandShape::Rectangle;
}

void SelectTool::banded(const Rect &band, const PointerEvent &event)
{
    combine(strokesWithin(*m_editor.layer().reached(), m_editor.clock().time(), m_canvas.view(), band), GroupShare::All,
            event);
}

void SelectTool::tracing(Point point, BandShape shape)
{
    if (shape != BandShape::Touch)
        return;
    if (m_touch)
        m_touch->goOn(point);
    else
        m_touch.emplace(m_editor.layer().reached(), m_editor.clock().time(), tolerance(), point);
}

void SelectTool::traced(const std::vector<Point> &path, BandShape shape, const PointerEvent &event)
{
    const std::optional<PathTouch> touch = std::exchange(m_touch, std::nullopt);
    if (shape == BandShape::Touch && touch)
        combine(touch->touched(), GroupShare::Any, event);
    else
        combine(strokesWithin(*m_editor.layer().reached(), m_editor.clock().time(), path), GroupShare::All, event);
}

void SelectTool::combine(std::set<StrokeId> found, GroupShare share, const PointerEvent &event)
{
    const bool away = takesAway(event) || takesAway(start());
    if (away || !((event.modifiers | start().modifiers) & Qt::ControlModifier)) // which means strokes within groups
        found = withWholeGroups(*m_editor.layer().reached(), m_editor.clock().time(), found, selection().strokes, share,
                                m_editor.layer().reachedGroup());
    if (away)
        return select(without(selection(), found));
    Selection chosen;
    if ((event.modifiers | start().modifiers) & Qt::ShiftModifier)
        chosen = selection();
    chosen.strokes.merge(found);
    select(std::move(chosen));
}

bool SelectTool::beginDrag(const PointerEvent &event)
{
    m_map = {};
    m_turnedByClick = false;
    const bool moves = isMoving(event);
    if (!m_handle && !moves)
        return false;
    const QString name = !m_handle                       ? tr("Move")
                         : m_handle->kind == Kind::Scale ? tr("Scale")
                         : m_handle->kind == Kind::Skew  ? tr("Skew")
                                                         : tr("Rotate");
    m_dragged = m_canvas.selection().strokes;
    m_gesture = m_editor.begin(name);
    m_gesture.take(m_dragged);
    m_snap.begin(*m_editor.document().painting(), m_canvas.aids(), m_editor.aids().guides(), m_canvas.selection(),
                 moves                                        ? TransformSnap::What::Strokes
                 : m_handle && m_handle->kind == Kind::Centre ? TransformSnap::What::Centre
                                                              : TransformSnap::What::Handle,
                 start().point);
    if (m_gesture.strokes().empty())
        m_gesture.giveUp();
    return m_gesture.isOpen();
}

void SelectTool::drag(const PointerEvent &event)
{
    if (m_canvas.selection().strokes != m_dragged)
        return; // A command has selected something else, copies for example, and the drag ended where it was.
    if (m_handle)
        dragHandle(event);
    else
        dragSelection(event);
}

void SelectTool::dragSelection(const PointerEvent &event)
{
    const View &view = m_canvas.view();
    Point by = event.point - start().point;
    m_snap.clear();
    if (event.modifiers & Qt::ControlModifier) { // The drag goes along one axis of the screen, as in Inkscape.
        const Point pixels = event.pixel - start().pixel;
        const Point kept = std::abs(pixels.x) > std::abs(pixels.y) ? Point{pixels.x, 0} : Point{0, pixels.y};
        by = view.toCanvas(start().pixel + kept) - start().point;
    } else if (!(event.modifiers & Qt::ShiftModifier)) { // With Shift the drag goes freely.
        by = m_snap.move(by, view, m_canvas.devicePixelRatioF());
    }
    show(Affine::translation(by));
    say(m_gesture.isRefused() ? TransformBar::refusal() : SelectHints::ofMove(by));
}

void SelectTool::dragHandle(const PointerEvent &event)
{
    const View &view = m_canvas.view();
    Point to = event.point;
    const bool ctrl = event.modifiers & Qt::ControlModifier;
    const bool snaps = m_handle->kind == Kind::Centre || (m_handle->kind == Kind::Scale && !ctrl);
    m_snap.clear();
    if (snaps) { // What snaps is the corner of the box, not the handle beside it.
        const Point beside = m_handle->kind == Kind::Centre ? Point{} : start().point - m_handles.anchor(*m_handle);
        to = m_snap.point(to - beside, view, m_canvas.devicePixelRatioF()) + beside;
    }
    if (m_handle->kind == Kind::Centre) {
        m_handles.setCentre(to);
        m_canvas.updateOverlay();
        return;
    }
    const Affine map = m_handles.map(*m_handle, start().point, to, event.modifiers);
    if (map.inverse())
        show(map);
    const double angle = std::atan2(m_map.c, m_map.a);
    say(m_gesture.isRefused()            ? TransformBar::refusal()
        : m_handle->kind == Kind::Scale  ? SelectHints::ofScale(m_map)
        : m_handle->kind == Kind::Rotate ? SelectHints::ofTurn(angle)
                                         : SelectHints::ofSkew(m_map));
    if (m_handle->kind == Kind::Rotate)
        showTurn(angle, event.pixel);
}

void SelectTool::show(const Affine &map)
{
    m_map = map;
    const SpreadRule rule = m_commands[Command::ScaleSpread].isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
    m_gesture.floatBy(map, rule);
    if (!m_canvas.lifted().isAhead())
        m_canvas.updateSelection();
}

void SelectTool::endDrag(bool cancelled)
{
    const bool centre = m_handle && m_handle->kind == Kind::Centre;
    const Point about = m_map(m_handles.centre());
    const bool ownCentre = length(m_handles.centre() - m_handles.box().centre()) > 1e-9 * m_handles.box().width();
    if (!cancelled)
        m_editor.settle(); // What floats is refused when it is put into the document.
    const bool isRefused = !cancelled && m_gesture.isRefused();
    if (cancelled)
        m_gesture.giveUp();
    else
        m_gesture.commit();
    if (isRefused)
        emit m_commands.said(TransformBar::refusal(), 8000);
    m_stale = true;
    handles();
    if (!cancelled && !isRefused && !centre && ownCentre)
        m_handles.setCentre(about); // The centre stays where it was on the strokes.
    m_handle.reset();
    m_snap.clear();
    say({});
    showTurn({});
}

bool SelectTool::wantsKey(const QKeyEvent &event) const
{
    const bool isTab = event.key() == Qt::Key_Tab || event.key() == Qt::Key_Backtab;
    return isTab && !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
}

bool SelectTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event)) {
        const bool used = SelectionTool::keyPress(event);
        if (const std::optional<Point> way = nudgeOf(*event); used && way)
            sayMoved(*way);
        return used;
    }
    if (!isBusy())
        selectNext(event->key() == Qt::Key_Tab && !(event->modifiers() & Qt::ShiftModifier) ? 1 : -1);
    return true;
}

void SelectTool::selectNext(int step)
{
    if (const StrokeId next = nextStroke(*m_editor.layer().reached(), m_editor.clock().time(), selection(), step))
        select(Selection{{next}, {}});
    const Document &document = m_editor.document();
    const Rect box = seenSelection(*document.painting(), document.selection());
    if (!box.isEmpty() && m_canvas.selectionOnScreen().isEmpty())
        m_canvas.bringIntoView(Point{(box.left + box.right) / 2, (box.top + box.bottom) / 2});
    saySelected();
}

/// Says which stroke was come to, since its handles do not tell it from others that lie there.
void SelectTool::saySelected()
{
    if (selection().isEmpty())
        return;
    const Painting &painting = *m_editor.document().painting();
    const std::set<StrokeId> all = selectableStrokes(*m_editor.layer().reached(), m_editor.clock().time());
    const StrokeId chosen = *selection().strokes.begin();
    qsizetype place = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        place += all.contains(stroke->id);
        if (stroke->id == chosen)
            break;
    }
    //: a stroke in words, and which it is of all, from the bottom: "stroke 3, even, blue, 34 segments: 2 of 12"
    emit m_commands.said(
        tr("%1: %2 of %3").arg(wordsOfSelected(painting, selection().strokes)).arg(place).arg(all.size()), 8000);
}

void SelectTool::sayMoved(Point way)
{
    const Display lengths = lengthDisplay(&m_canvas);
    //: strokes in words, and by how much they were moved: "stroke 3, even, blue, 34 segments: moved by 10, 0"
    emit m_commands.said(tr("%1: moved by %2, %3")
                             .arg(wordsOfSelected(*m_editor.document().painting(), m_canvas.selection().strokes),
                                  lengths.number(way.x), lengths.text(way.y)),
                         8000);
}

QWidget *SelectTool::options()
{
    if (!m_options)
        m_options = new TransformBar(m_editor, m_commands);
    return m_options;
}

void SelectTool::hover(const PointerEvent &event)
{
    const auto handle = handles().at(event.pixel, m_canvas.view(), m_canvas.devicePixelRatioF());
    if (handle == m_hovered)
        return;
    m_hovered = handle;
    m_said.clear();
    m_canvas.refreshCursor();
    m_canvas.updateSelection();
    emit hintChanged();
}

void SelectTool::leave()
{
    if (!m_hovered)
        return;
    m_hovered.reset();
    m_canvas.updateSelection();
    emit hintChanged();
}

bool SelectTool::leavesToGuides(Point pixel) const
{
    const View &view = m_canvas.view();
    return !handles().at(pixel, view, m_canvas.devicePixelRatioF()) &&
           pickAll(*m_editor.layer().reached(), m_editor.clock().time(), view.toCanvas(pixel), tolerance()).empty();
}

QCursor SelectTool::cursor() const
{
    return m_hovered ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

/// Shows the angle by which strokes are turned, on the canvas and in the row over it.
void SelectTool::showTurn(std::optional<double> angle, Point pixel)
{
    m_turned = angle;
    m_turnedAt = pixel;
    if (m_options)
        m_options->showTurn(angle);
    m_canvas.updateSelection();
}

void SelectTool::say(const QString &text)
{
    if (text == m_said)
        return;
    m_said = text;
    emit hintChanged();
}

QString SelectTool::hint() const
{
    if (!m_said.isEmpty())
        return m_said;
    return m_hovered ? SelectHints::ofHandle(*m_hovered)
                     : SelectHints::ofKeys(m_canvas.modifiers(), !selection().isEmpty());
}

std::optional<double> SelectTool::paintMargin() const
{
    constexpr double marks = 40; // logical pixels for the handles around the box, and for the mark of a snap
    const bool centre = m_handle ? m_handle->kind == Kind::Centre : m_handles.mode() == TransformHandles::Mode::Turn;
    if ((centre || m_turned) && !selection().isEmpty())
        return {}; // The centre may lie anywhere, and the angle stands beside the pointer.
    return marks * m_canvas.devicePixelRatioF();
}

void SelectTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const OverlayColours &colours = m_canvas.overlayColours();
    SelectionTool::paint(painter, view, dpr);
    const bool movesCentre = m_gesture.isOpen() && m_handle && m_handle->kind == Kind::Centre;
    if (movesCentre)
        m_handles.paint(painter, view, dpr, colours.accent, m_handle);
    else if (!isBusy() && !selection().isEmpty())
        handles().paint(painter, view, dpr, colours.accent, m_hovered);
    if (m_gesture.isOpen() && m_snap.found().to != SnapTo::Nothing)
        paintSnapMark(painter, view.toPixels(m_snap.found().point), colours, dpr);
    if (m_turned)
        paintBadge(painter, angleText(*m_turned), m_turnedAt, 0, view, dpr);
}

} // namespace suffuse

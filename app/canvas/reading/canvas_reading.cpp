#include "app/canvas/reading/canvas_reading.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/reading/read_item.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "model/paint/half_width.h"
#include "render/view.h"

#include <QAccessibleWidget>

#include <algorithm>

namespace suffuse {

namespace {

constexpr std::size_t mostEvents = 100; ///< about single strokes, of one change; more are told as one

/// Of each canvas that has one.
std::map<const QObject *, CanvasReading *> &readings()
{
    static std::map<const QObject *, CanvasReading *> all;
    return all;
}

/// The canvas itself: what it is as a widget, and the strokes on it as its children.
class ReadCanvas : public QAccessibleWidget {
public:
    explicit ReadCanvas(CanvasWidget &canvas) : QAccessibleWidget(&canvas, QAccessible::Canvas) {}

    int childCount() const override { return reading() ? int(top().size()) : 0; }

    QAccessibleInterface *child(int index) const override
    {
        return index >= 0 && index < childCount() ? reading()->interfaceOf(top()[std::size_t(index)]) : nullptr;
    }

    int indexOfChild(const QAccessibleInterface *child) const override
    {
        const auto *item = dynamic_cast<const ReadItem *>(child);
        const bool isOwn = item && reading() && reading()->tree().parentOf(item->item()) == 0;
        return isOwn ? reading()->tree().placeOf(item->item()) : -1;
    }

    QAccessibleInterface *childAt(int x, int y) const override
    {
        const StrokeId stroke = reading() ? reading()->strokeAt({x, y}) : 0;
        return stroke ? reading()->interfaceOf({stroke, 0}) : nullptr;
    }

    QAccessibleInterface *focusChild() const override
    {
        const StrokeId stroke = reading() ? reading()->focused() : 0;
        return stroke ? reading()->interfaceOf({stroke, 0}) : QAccessibleWidget::focusChild();
    }

    QString text(QAccessible::Text kind) const override
    {
        if (kind != QAccessible::Description || !reading())
            return QAccessibleWidget::text(kind);
        if (!reading()->said().isEmpty())
            return reading()->said();
        const Document &document = reading()->canvas().editor().unsettled();
        return CanvasReading::tr("%Ln stroke(s)", nullptr, int(document.painting()->strokes.size())) +
               //: between "12 strokes" and "2 selected"
               CanvasReading::tr(", ") +
               CanvasReading::tr("%Ln selected", nullptr, int(document.selection().strokes.size()));
    }

    QAccessible::State state() const override
    {
        QAccessible::State state = QAccessibleWidget::state();
        state.multiSelectable = true;
        state.extSelectable = true;
        return state;
    }

private:
    /// The canvas gets it later than its interface, which its name brings into being, and loses it earlier.
    CanvasReading *reading() const
    {
        const auto found = readings().find(widget());
        return found == readings().end() ? nullptr : found->second;
    }
    const std::vector<TreeItem> &top() const { return reading()->tree().in(0); }
};

QAccessibleInterface *makeReadCanvas(const QString &, QObject *object)
{
    auto *canvas = qobject_cast<CanvasWidget *>(object);
    return canvas ? new ReadCanvas(*canvas) : nullptr;
}

} // namespace

void installCanvasReading()
{
    static const bool installed = (QAccessible::installFactory(makeReadCanvas), true);
    Q_UNUSED(installed);
}

CanvasReading::CanvasReading(CanvasWidget &canvas, QObject *parent) : QObject(parent), m_canvas(canvas)
{
    readings()[&canvas] = this;
    canvas.installEventFilter(this);
    QAccessible::installActivationObserver(this);
    connect(&canvas.editor().laterChanges(), &LaterChanges::changed, this, &CanvasReading::follow);
    m_told = canvas.editor().unsettled().painting();
    m_selected = canvas.editor().selection().strokes;
}

CanvasReading::~CanvasReading()
{
    QAccessible::removeActivationObserver(this);
    readings().erase(&m_canvas);
    for (const auto &[item, id] : m_ids)
        QAccessible::deleteAccessibleInterface(id);
}

const StrokeTree &CanvasReading::tree() const
{
    const PaintingPtr &painting = m_canvas.editor().unsettled().painting();
    if (m_tree.painting() != painting)
        m_tree = StrokeTree(painting);
    return m_tree;
}

QAccessibleInterface *CanvasReading::interfaceOf(const TreeItem &item)
{
    if (!tree().contains(item))
        return nullptr;
    const auto [known, isNew] = m_ids.try_emplace({item.stroke, item.group}, 0);
    if (isNew)
        known->second = QAccessible::registerAccessibleInterface(new ReadItem(*this, item));
    return QAccessible::accessibleInterface(known->second);
}

QAccessibleInterface *CanvasReading::parentOf(const TreeItem &item)
{
    const GroupId group = tree().parentOf(item);
    return group ? interfaceOf({0, group}) : ownInterface();
}

void CanvasReading::tell(const TreeItem &about, QAccessible::Event what)
{
    const bool isCanvas = about == TreeItem();
    if (QAccessibleInterface *interface = isCanvas ? ownInterface() : interfaceOf(about)) {
        QAccessibleEvent event(interface, what);
        QAccessible::updateAccessibility(&event);
        emit told(what, about);
    }
}

QAccessibleInterface *CanvasReading::ownInterface() const
{
    return QAccessible::queryAccessibleInterface(&m_canvas);
}

StrokeId CanvasReading::focused() const
{
    const std::set<StrokeId> &selected = m_canvas.editor().selection().strokes;
    return m_canvas.hasFocus() && selected.size() == 1 ? *selected.begin() : 0;
}

std::set<StrokeId> CanvasReading::strokesOf(const TreeItem &item) const
{
    if (item.stroke)
        return {item.stroke};
    std::set<StrokeId> strokes;
    for (const TreeItem &child : tree().in(item.group))
        strokes.merge(strokesOf(child));
    return strokes;
}

bool CanvasReading::isSelected(const TreeItem &item) const
{
    const std::set<StrokeId> &selected = m_canvas.editor().selection().strokes;
    if (item.stroke || selected.empty())
        return selected.contains(item.stroke);
    return std::ranges::includes(selected, strokesOf(item));
}

bool CanvasReading::canBeSelected(const TreeItem &item) const
{
    const Painting &painting = *tree().painting();
    return std::ranges::any_of(strokesOf(item), [&](StrokeId id) {
        const StrokePtr stroke = painting.find(id);
        return stroke && painting.isVisible(*stroke) && !painting.isLocked(*stroke);
    });
}

QRect CanvasReading::areaOf(const TreeItem &item) const
{
    Rect box;
    const View &view = m_canvas.view();
    for (const StrokeId id : strokesOf(item)) {
        const StrokePtr found = stroke(id);
        const Rect seen = found ? seenBox(*found) : Rect();
        if (seen.isEmpty())
            continue;
        for (const Point corner : {Point{seen.left, seen.top}, Point{seen.right, seen.top}, Point{seen.left, seen.bottom},
                                   Point{seen.right, seen.bottom}})
            box.include(view.toPixels(corner));
    }
    if (box.isEmpty())
        return {};
    const double dpr = m_canvas.devicePixelRatioF();
    // At great zooms a box is wider than whole numbers reach.
    const auto whole = [dpr](double pixels) { return int(std::clamp(pixels / dpr, -1e6, 1e6)); };
    const QRect area(QPoint(whole(std::floor(box.left)), whole(std::floor(box.top))),
                     QPoint(whole(std::ceil(box.right)), whole(std::ceil(box.bottom))));
    return area.translated(m_canvas.mapToGlobal(QPoint()));
}

StrokeId CanvasReading::strokeAt(QPoint global) const
{
    const QPoint local = m_canvas.mapFromGlobal(global);
    if (!m_canvas.rect().contains(local))
        return 0;
    Editor &editor = m_canvas.editor();
    const View &view = m_canvas.view();
    constexpr double slack = 3; // logical pixels in which hairlines are found
    const double dpr = m_canvas.devicePixelRatioF();
    const auto found = pickSeen(*editor.layer().reached(), editor.clock().time(),
                                view.toCanvas(devicePixels(m_canvas, local)), slack * dpr / view.scale);
    return found ? found->stroke : 0;
}

void CanvasReading::select(const TreeItem &item, bool besides)
{
    Editor &editor = m_canvas.editor();
    const std::set<StrokeId> reached = selectableStrokes(*editor.layer().reached(), editor.clock().time());
    std::set<StrokeId> meant = strokesOf(item);
    std::erase_if(meant, [&](StrokeId id) { return !reached.contains(id); });
    if (meant.empty())
        return;
    Selection chosen;
    if (besides) {
        chosen = Selection{editor.selection().strokes, {}};
        if (std::ranges::includes(chosen.strokes, meant))
            std::erase_if(chosen.strokes, [&](StrokeId id) { return meant.contains(id); });
        else
            chosen.strokes.merge(meant);
    } else {
        chosen.strokes = std::move(meant);
        m_canvas.setFocus(Qt::OtherFocusReason);
    }
    editor.document().setSelection(std::move(chosen));
    editor.laterChanges().flush();
}

void CanvasReading::say(const QString &sentence)
{
    m_said = sentence;
    if (!m_active)
        return;
    tell({}, QAccessible::DescriptionChanged);
    tell({}, QAccessible::Alert);
}

bool CanvasReading::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusIn && m_active) {
        m_focused = 0; // The canvas has told that it has the keyboard; the stroke comes after it.
        QMetaObject::invokeMethod(this, &CanvasReading::tellFocus, Qt::QueuedConnection);
    } else if (event->type() == QEvent::FocusOut) {
        m_focused = 0;
    }
    return QObject::eventFilter(watched, event);
}

void CanvasReading::follow(const Change &change)
{
    if (!m_active) {
        m_told = m_canvas.editor().unsettled().painting();
        if (change.reset || change.selection || change.order)
            m_selected = m_canvas.editor().selection().strokes;
        forgetGone();
        return;
    }
    const PaintingPtr before = std::exchange(m_told, tree().painting());
    if (change.reset || change.order || change.canvas || change.texts) {
        tellStrokes(change, *before);
        forgetGone();
        tell({}, QAccessible::ObjectReorder);
    } else if (!change.strokes.empty()) {
        tellStrokes(change, *before);
    }
    if (change.reset || change.selection || change.order)
        tellSelection();
}

/// Interfaces of what is not in the painting any more go, since nothing could be asked of them.
void CanvasReading::forgetGone()
{
    if (m_ids.empty())
        return;
    const StrokeTree &now = tree();
    std::erase_if(m_ids, [&now](const auto &known) {
        const bool gone = !now.contains({known.first.first, known.first.second});
        if (gone)
            QAccessible::deleteAccessibleInterface(known.second);
        return gone;
    });
}

void CanvasReading::tellStrokes(const Change &change, const Painting &before)
{
    if (change.reset || change.strokes.size() > mostEvents)
        return; // The reorder that follows makes readers ask again.
    for (const StrokeId id : change.strokes) {
        const bool was = before.find(id) != nullptr, is = tree().contains({id, 0});
        const auto known = m_ids.find({id, 0});
        if (is && !was)
            tell({id, 0}, QAccessible::ObjectCreated);
        else if (was && !is && known != m_ids.end())
            tellGone(known->second, id);
        else if (is && known != m_ids.end()) {
            tell({id, 0}, QAccessible::NameChanged);
            tell({id, 0}, QAccessible::LocationChanged);
        }
    }
}

/// Its interface stands in no tree any more, and goes next.
void CanvasReading::tellGone(QAccessible::Id interface, StrokeId stroke)
{
    if (QAccessibleInterface *gone = QAccessible::accessibleInterface(interface)) {
        QAccessibleEvent event(gone, QAccessible::ObjectDestroyed);
        QAccessible::updateAccessibility(&event);
        emit told(QAccessible::ObjectDestroyed, {stroke, 0});
    }
}

void CanvasReading::tellSelection()
{
    const std::set<StrokeId> &now = m_canvas.editor().selection().strokes;
    std::vector<StrokeId> others;
    std::ranges::set_symmetric_difference(m_selected, now, std::back_inserter(others));
    m_selected = now;
    if (others.size() <= mostEvents)
        for (const StrokeId id : others)
            tell({id, 0}, now.contains(id) ? QAccessible::SelectionAdd : QAccessible::SelectionRemove);
    if (!others.empty())
        tell({}, QAccessible::SelectionWithin);
    tellFocus();
}

void CanvasReading::tellFocus()
{
    const StrokeId now = focused();
    if (std::exchange(m_focused, now) == now || now == 0 || !m_active)
        return;
    tell({now, 0}, QAccessible::Focus);
}

} // namespace suffuse

#include "model/document.h"

#include <unordered_map>

namespace suffuse {

namespace {

/// Without ids and segments that the painting lacks, and with the strokes of selected segments. One pass.
Selection existing(const Selection &selection, const Painting &painting)
{
    if (selection.strokes.empty() && selection.segments.empty())
        return {};
    std::unordered_map<StrokeId, int> wanted; // id → number of segments
    for (StrokeId id : selection.strokes)
        wanted[id] = -1;
    for (const SegmentRef &ref : selection.segments)
        wanted[ref.stroke] = -1;
    for (const StrokePtr &stroke : painting.strokes)
        if (const auto it = wanted.find(stroke->id); it != wanted.end())
            it->second = int(stroke->segments.size());
    Selection result;
    for (StrokeId id : selection.strokes)
        if (wanted[id] >= 0)
            result.strokes.insert(id);
    for (const SegmentRef &ref : selection.segments) {
        if (ref.segment < 0 || ref.segment >= wanted[ref.stroke])
            continue;
        result.segments.insert(ref);
        result.strokes.insert(ref.stroke);
    }
    return result;
}

/// Swaps strokes in place; none comes or goes.
void swapStrokes(StrokeList &strokes, std::map<StrokeId, StrokePtr> &states)
{
    std::size_t found = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto it = states.find(std::as_const(strokes)[i]->id); // writing would end the sharing
        if (it == states.end())
            continue;
        Q_ASSERT_X(it->second, "Document::exchange", "a stroke goes, but the edit gives no order");
        if (it->second)
            std::swap(strokes[i], it->second);
        if (++found == states.size())
            break;
    }
    Q_ASSERT_X(found == states.size(), "Document::exchange", "a stroke comes, but the edit gives no order");
}

/// Swaps strokes and their order. What lies below the first that differs goes on sharing its blocks.
void swapStrokesAndOrder(Painting &painting, Edit &edit)
{
    StrokeList &strokes = painting.strokes;
    const std::vector<StrokeId> before = orderOf(painting);
    const std::vector<StrokeId> after = orderWanted(edit, before);
    const auto first =
        std::size_t(std::mismatch(before.begin(), before.end(), after.begin(), after.end(),
                                  [&](StrokeId a, StrokeId b) { return a == b && !edit.strokes.contains(a); })
                        .first -
                    before.begin());

    std::unordered_map<StrokeId, StrokePtr> there;
    there.reserve(before.size() - first + edit.strokes.size());
    for (std::size_t i = first; i < before.size(); ++i)
        there.emplace(before[i], std::as_const(strokes)[i]);
    for (auto &[id, state] : edit.strokes)
        std::swap(there[id], state);
    strokes.resize(first);
    for (std::size_t i = first; i < after.size(); ++i) {
        const auto it = there.find(after[i]);
        const bool known = it != there.end() && it->second;
        Q_ASSERT_X(known, "Document::exchange", "the order names a stroke that is not there, or names it twice");
        if (known)
            strokes.push_back(std::move(it->second));
    }
    Q_ASSERT_X(std::none_of(there.begin(), there.end(), [](const auto &entry) { return bool(entry.second); }),
               "Document::exchange", "the order leaves out a stroke");
    edit.order.reset();
    edit.places = orderDifference(after, before);
}

} // namespace

Document::Document(QObject *parent) : QObject(parent), m_painting(std::make_shared<const Painting>()) {}

PaintingPtr Document::snapshot() const
{
    if (!m_draft)
        return m_painting;
    auto painting = std::make_shared<Painting>(*m_painting);
    painting->strokes.push_back(m_draft);
    return painting;
}

void Document::setSelection(Selection selection)
{
    selection = existing(selection, *m_painting);
    if (selection == m_selection)
        return;
    m_selection = std::move(selection);
    Change change;
    change.selection = true;
    emit changed(change);
}

void Document::exchange(Edit &edit)
{
    if (edit.isEmpty())
        return;
    Change change;
    for (const auto &[id, state] : edit.strokes) {
        change.strokes.push_back(id);
        m_nextStroke = std::max(m_nextStroke, id + 1);
    }
    change.order = edit.reorders();
    change.canvas = edit.touchesTheRest();

    if (change.canvas || change.order || !edit.strokes.empty()) {
        auto painting = std::make_shared<Painting>(*m_painting);
        if (edit.reorders())
            swapStrokesAndOrder(*painting, edit);
        else if (!edit.strokes.empty())
            swapStrokes(painting->strokes, edit.strokes);
        if (edit.canvas)
            std::swap(painting->canvas, *edit.canvas);
        if (edit.groups) {
            std::swap(painting->groups, *edit.groups);
            for (const Group &group : painting->groups)
                m_nextGroup = std::max(m_nextGroup, group.id + 1);
        }
        if (edit.swatches)
            std::swap(painting->swatches, *edit.swatches);
        if (edit.underlay)
            std::swap(painting->underlay, *edit.underlay);
        m_painting = std::move(painting);
    }

    exchangeSelection(edit, change);
    emit changed(change);
}

void Document::exchangeSelection(Edit &edit, Change &change)
{
    const bool same = !edit.selection || *edit.selection == m_selection;
    // What stays and keeps its segments needs no look at all the strokes.
    if (same && !edit.reorders() && (edit.strokes.empty() || m_selection.segments.empty()))
        return;
    Selection after = existing(edit.selection ? *edit.selection : m_selection, *m_painting);
    change.selection = after != m_selection;
    // What leaves the selection because it no longer exists must come back with it.
    if (edit.selection || change.selection)
        edit.selection = m_selection;
    m_selection = std::move(after);
}

void Document::setDraft(StrokePtr draft)
{
    if (draft == m_draft)
        return;
    m_draft = std::move(draft);
    Change change;
    change.draft = true;
    emit changed(change);
}

void Document::reset(PaintingPtr painting)
{
    m_painting = painting ? std::move(painting) : std::make_shared<const Painting>();
    m_draft.reset();
    m_selection.clear();
    m_nextStroke = m_painting->nextStrokeId();
    m_nextGroup = 1;
    for (const Group &group : m_painting->groups)
        m_nextGroup = std::max(m_nextGroup, group.id + 1);
    Change change;
    change.order = change.canvas = change.selection = change.draft = change.reset = true;
    emit changed(change);
}

StrokeId Document::takeStrokeId()
{
    return m_nextStroke++;
}

GroupId Document::takeGroupId()
{
    return m_nextGroup++;
}

void Document::reserve(const Edit &edit)
{
    for (const auto &[id, state] : edit.strokes)
        m_nextStroke = std::max(m_nextStroke, id + 1);
    if (edit.groups)
        for (const Group &group : *edit.groups)
            m_nextGroup = std::max(m_nextGroup, group.id + 1);
}

} // namespace suffuse

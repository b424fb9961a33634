#include "model/document/document.h"

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

/// The selection without ids and segments that the painting does not have. The strokes of selected segments are
/// selected, too.
Selection existing(Selection selection, const Painting &painting)
{
    if (selection.strokes.empty() && selection.segments.empty())
        return {};
    std::vector<std::pair<StrokeId, int>> there; // ids and numbers of segments
    there.reserve(painting.strokes.size());
    for (const StrokePtr &stroke : painting.strokes)
        there.emplace_back(stroke->id, int(stroke->segments.size()));
    if (!std::ranges::is_sorted(there)) // Most often the order is nearly that of the ids.
        std::ranges::sort(there);
    auto next = there.begin(); // The selection is in ascending order, too.
    const auto segmentsOf = [&](StrokeId id) {
        while (next != there.end() && next->first < id)
            ++next;
        return next != there.end() && next->first == id ? next->second : -1;
    };
    std::erase_if(selection.strokes, [&](StrokeId id) { return segmentsOf(id) < 0; });
    next = there.begin();
    std::erase_if(selection.segments,
                  [&](const SegmentRef &ref) { return ref.segment < 0 || ref.segment >= segmentsOf(ref.stroke); });
    for (const SegmentRef &ref : selection.segments)
        selection.strokes.insert(ref.stroke);
    return selection;
}

/// Swaps strokes in place; none is added or removed.
void swapStrokes(StrokeList &strokes, std::map<StrokeId, StrokePtr> &states)
{
    std::size_t found = 0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        // A write access would end the sharing of the block.
        const auto it = states.find(std::as_const(strokes)[i]->id);
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

/// Strokes in an order, that are taken by their ids. In a new order most of them follow each other as they did before,
/// and are found without being looked up.
class StrokesById {
public:
    explicit StrokesById(std::vector<StrokePtr> strokes) : m_strokes(std::move(strokes))
    {
        m_ids.reserve(m_strokes.size());
        for (const StrokePtr &stroke : m_strokes)
            m_ids.push_back(stroke->id);
    }

    /// Puts another state in; where there is none, the stroke comes behind all others.
    void swap(StrokeId id, StrokePtr &state)
    {
        if (!find(id)) {
            m_next = m_ids.size();
            if (!m_places.empty())
                m_places[id] = m_next;
            m_ids.push_back(id);
            m_strokes.emplace_back();
        }
        std::swap(m_strokes[m_next], state);
    }
    /// Null where it is not there, or was taken.
    StrokePtr take(StrokeId id) { return find(id) ? std::exchange(m_strokes[m_next++], nullptr) : nullptr; }
    bool isEmpty() const
    {
        return std::ranges::none_of(m_strokes, [](const StrokePtr &stroke) { return bool(stroke); });
    }

private:
    bool find(StrokeId id)
    {
        if (m_next < m_ids.size() && m_ids[m_next] == id)
            return true;
        // Where blocks went past each other there are few such places, which are found without a table.
        if (m_searched < mostSearched) {
            ++m_searched;
            const auto it = std::ranges::find(m_ids, id);
            m_next = it == m_ids.end() ? m_next : std::size_t(it - m_ids.begin());
            return it != m_ids.end();
        }
        if (m_places.empty())
            for (std::size_t i = 0; i < m_ids.size(); ++i)
                m_places.emplace(m_ids[i], i);
        const auto it = m_places.find(id);
        if (it == m_places.end())
            return false;
        m_next = it->second;
        return true;
    }

    std::vector<StrokePtr> m_strokes;
    std::vector<StrokeId> m_ids;
    static constexpr int mostSearched = 8;
    int m_searched = 0;
    std::unordered_map<StrokeId, std::size_t> m_places; ///< made when more strokes are looked up
    std::size_t m_next = 0;                             ///< behind the one that was found last
};

/// Swaps strokes and their order. Below the first place that differs, blocks stay shared. Only the strokes from there
/// to the last place that differs are looked up; what lies above them, as the rest of a text above a letter that comes,
/// moves as it is.
void swapStrokesAndOrder(Painting &painting, Edit &edit)
{
    StrokeList &strokes = painting.strokes;
    const std::vector<StrokeId> before = orderOf(painting);
    const std::vector<StrokeId> after = orderWanted(edit, before);
    const auto stays = [&](StrokeId a, StrokeId b) { return a == b && !edit.strokes.contains(a); };
    const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end(), stays);
    const auto bEnd = std::mismatch(before.rbegin(), std::make_reverse_iterator(b), after.rbegin(),
                                    std::make_reverse_iterator(a), stays)
                          .first.base();
    const auto first = std::size_t(b - before.begin()), last = std::size_t(bEnd - before.begin());
    StrokesById there(
        std::vector<StrokePtr>(strokes.cbegin() + std::ptrdiff_t(first), strokes.cbegin() + std::ptrdiff_t(last)));
    for (auto &[id, state] : edit.strokes)
        there.swap(id, state);
    const std::size_t end = after.size() - (before.size() - last);
    const auto taken = [&](std::size_t i) {
        StrokePtr stroke = there.take(after[i]);
        Q_ASSERT_X(stroke, "Document::exchange", "the order names a stroke that is not there, or names it twice");
        return stroke;
    };
    if (end == last) { // What lies above them stays where it is.
        for (std::size_t i = first; i < end; ++i)
            if (StrokePtr stroke = taken(i))
                strokes[i] = std::move(stroke);
    } else {
        const std::vector<StrokePtr> above(strokes.cbegin() + std::ptrdiff_t(last), strokes.cend());
        strokes.resize(first);
        for (std::size_t i = first; i < end; ++i)
            if (StrokePtr stroke = taken(i))
                strokes.push_back(std::move(stroke));
        for (const StrokePtr &stroke : above)
            strokes.push_back(stroke);
    }
    Q_ASSERT_X(there.isEmpty(), "Document::exchange", "the order leaves out a stroke");
    edit.order.reset();
    edit.places = orderDifference(after, before);
}

/// Whether groups are the same, but for what those of them say that are texts.
bool sameButForTexts(const std::vector<Group> &a, const std::vector<Group> &b)
{
    return std::ranges::equal(a, b, [](const Group &x, const Group &y) {
        if (!x.text || !y.text)
            return x == y;
        Group other = y;
        other.text = x.text;
        return x == other;
    });
}

} // namespace

Document::Document(QObject *parent) : QObject(parent), m_painting(std::make_shared<const Painting>()) {}

PaintingPtr Document::snapshot() const
{
    if (!m_draft)
        return m_painting;
    auto painting = std::make_shared<Painting>(*m_painting);
    painting->strokes.push_back(m_draft);
    for (const StrokePtr &stroke : m_draftCompany)
        painting->strokes.push_back(stroke);
    return painting;
}

void Document::setSelection(Selection selection)
{
    selection = existing(std::move(selection), *m_painting);
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
    emit aboutToExchange();
    Change change;
    for (const auto &[id, state] : edit.strokes) {
        change.strokes.push_back(id);
        m_nextStroke = std::max(m_nextStroke, id + 1);
    }
    change.order = edit.reorders();
    change.texts = edit.groups && sameButForTexts(*edit.groups, m_painting->groups);
    change.canvas = edit.canvas || edit.swatches || edit.underlay || (edit.groups && !change.texts);

    if (edit.touchesTheRest() || change.order || !edit.strokes.empty()) {
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
    // If all selected strokes stay and keep their segments, the strokes need not be looked at.
    if (same && !edit.reorders() && (edit.strokes.empty() || m_selection.segments.empty()))
        return;
    const bool given = edit.selection.has_value();
    Selection after = existing(given ? std::move(*edit.selection) : m_selection, *m_painting);
    change.selection = after != m_selection;
    std::swap(m_selection, after);
    // What leaves the selection because it no longer exists must come back with it.
    if (given || change.selection)
        edit.selection = std::move(after);
}

void Document::setDraft(StrokePtr draft, std::vector<StrokePtr> company)
{
    if (!draft)
        company.clear();
    if (draft == m_draft && company == m_draftCompany)
        return;
    m_draft = std::move(draft);
    m_draftCompany = std::move(company);
    Change change;
    change.draft = true;
    emit changed(change);
}

void Document::reset(PaintingPtr painting)
{
    m_painting = painting ? std::move(painting) : std::make_shared<const Painting>();
    m_draft.reset();
    m_draftCompany.clear();
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

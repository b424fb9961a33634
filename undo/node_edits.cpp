#include "undo/node_edits.h"

#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chain_strokes.h"
#include "model/shaping/erasing/erase.h"
#include "model/shaping/erasing/fill_cut.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "undo/history/order_tree.h"
#include "undo/history/remap.h"

namespace suffuse {

namespace {

using NodesOfStrokes = std::map<StrokeId, std::vector<int>>;

NodesOfStrokes nodesByStroke(const std::set<NodeRef> &nodes)
{
    NodesOfStrokes result;
    for (const NodeRef &ref : nodes)
        result[ref.stroke].push_back(ref.node);
    return result;
}

/// Calls `change` for the unlocked strokes among the keys of a map. Strokes that it changes go into the edit.
template <typename Map, typename Change>
Edit reshape(const Document &document, const Map &targets, Change change)
{
    Edit edit;
    if (targets.empty())
        return edit;
    const Painting &painting = *document.painting();
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = targets.find(stroke->id);
        if (it == targets.end() || isLocked(*stroke))
            continue;
        Stroke result = change(*stroke, it->second);
        if (result != *stroke)
            edit.strokes.emplace(stroke->id, std::make_shared<const Stroke>(std::move(result)));
    }
    return edit;
}

void setSelection(Edit &edit, const Document &document, Selection selection)
{
    if (selection != document.selection())
        edit.selection = std::move(selection);
}

/// For each segment k of the reshaped stroke, which replaces the segments [sources[k], sources[k + 1]), the index of a
/// selected one of these, if there is one. `end` is one behind the last segment that was replaced.
std::vector<int> selectedSources(const std::vector<int> &sources, int end, StrokeId stroke, const Selection &selection)
{
    std::vector<int> result = sources;
    for (std::size_t k = 0; k < sources.size(); ++k) {
        const int next = k + 1 < sources.size() ? sources[k + 1] : end;
        for (int s = sources[k]; s < next; ++s)
            if (selection.segments.contains({stroke, s})) {
                result[k] = s;
                break;
            }
    }
    return result;
}

/// Puts parts of strokes in the strokes' places. The first part keeps the id, the others get new ones.
class Parts {
public:
    explicit Parts(Document &document) : m_document(document), m_selection(document.selection()) {}

    void keep(const Stroke &stroke) { m_order.push_back(stroke.id); }

    /// `sources` says which segments of the stroke the segments of the parts came from, one part after the other.
    void replace(const Stroke &stroke, std::vector<Stroke> parts, const std::vector<int> &sources)
    {
        const bool wasSelected = m_selection.strokes.contains(stroke.id);
        const std::set<SegmentRef> before = takeSegments(m_selection, stroke.id);
        if (parts.empty())
            m_edit.strokes.emplace(stroke.id, nullptr);
        std::size_t k = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            Stroke &part = parts[i];
            if (i > 0)
                part.id = m_document.takeStrokeId();
            if (wasSelected)
                m_selection.strokes.insert(part.id);
            for (int s = 0; s < int(part.segments.size()) && k < sources.size(); ++s, ++k)
                if (before.contains({stroke.id, sources[k]}))
                    m_selection.segments.insert({part.id, s});
            m_order.push_back(part.id);
            m_edit.strokes.emplace(part.id, std::make_shared<const Stroke>(std::move(part)));
        }
    }

    Edit edit()
    {
        if (m_edit.strokes.empty())
            return {};
        m_edit.order = std::move(m_order);
        for (const auto &[id, stroke] : m_edit.strokes)
            if (!stroke)
                m_selection.strokes.erase(id);
        setSelection(m_edit, m_document, std::move(m_selection));
        return std::move(m_edit);
    }

private:
    Document &m_document;
    Selection m_selection;
    Edit m_edit;
    std::vector<StrokeId> m_order;
};

/// Splits segments. `split(stroke, places, &sources)` makes the new stroke.
template <typename Split>
Edit splitSegments(const Document &document, const PlacesOfStrokes &places, Split split)
{
    Selection selection = document.selection();
    Edit edit = reshape(document, places, [&](const Stroke &stroke, const std::vector<CurvePlace> &where) {
        std::vector<int> sources;
        Stroke result = split(stroke, where, &sources);
        remap(selection, stroke.id, sources);
        return result;
    });
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

/// The strokes that the chains of a cut stroke make. `sources` goes along with its segments.
std::vector<Stroke> apart(const Stroke &cut, std::vector<int> &sources)
{
    std::vector<int> from;
    std::vector<Stroke> strokes = strokesOfChains(cut, &from);
    for (int &source : from)
        source = sources[std::size_t(source)];
    sources = std::move(from);
    return strokes;
}

Edit splitIntoChains(const Document &document, const PlacesOfStrokes &places)
{
    return splitSegments(document, places, cutInOne);
}

} // namespace

Edit replaceStrokes(const Document &document, std::vector<Stroke> strokes)
{
    std::map<StrokeId, Stroke *> byId;
    for (Stroke &s : strokes)
        if (problemOf(s).isEmpty())
            byId.emplace(s.id, &s);
    return reshape(document, byId, [](const Stroke &, Stroke *wanted) { return std::move(*wanted); });
}

Edit insertNodes(const Document &document, const PlacesOfStrokes &places)
{
    return splitSegments(document, places, withNodes);
}

Edit deleteNodes(const Document &document, const std::set<NodeRef> &nodes, double gap)
{
    Selection selection = document.selection();
    std::set<StrokeId> emptied;
    Edit edit = reshape(document, nodesByStroke(nodes), [&](const Stroke &before, const std::vector<int> &chosen) {
        std::vector<int> wanted = chosen;
        const BendsRemoved removed = withoutBends(withSeamsBeside(before, wanted), wanted, gap);
        const Stroke &stroke = removed.stroke;
        const std::vector<int> &gone = removed.deleted;
        if (gone.empty())
            return stroke;
        int end = int(stroke.segments.size());
        const auto isGone = [&](int node) { return std::find(gone.begin(), gone.end(), node) != gone.end(); };
        const auto staysOf = [&](const Chain &chain) { // A segment needs two nodes.
            int left = !isGone(endNode(stroke, chain.last));
            for (int node = chain.first; node <= chain.last; ++node)
                left += !isGone(node);
            return left >= 2;
        };
        if (std::ranges::none_of(chainsOf(stroke), staysOf)) {
            emptied.insert(before.id);
            return before;
        }
        while (isGone(end))
            --end;
        std::vector<int> sources;
        Stroke result = withoutNodes(stroke, gone, &sources);
        remap(selection, stroke.id, selectedSources(sources, end, stroke.id, selection));
        return result;
    });
    if (!emptied.empty()) {
        edit.order.emplace();
        for (const StrokePtr &s : document.painting()->strokes)
            if (!emptied.contains(s->id))
                edit.order->push_back(s->id);
        for (StrokeId id : emptied) {
            edit.strokes.emplace(id, nullptr);
            remap(selection, id, {});
            selection.strokes.erase(id);
        }
    }
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

Edit bridgeSegments(const Document &document, const std::set<SegmentRef> &segments)
{
    NodesOfStrokes wanted;
    for (const SegmentRef &ref : segments)
        wanted[ref.stroke].push_back(ref.segment);
    Selection selection = document.selection();
    Edit edit = reshape(document, wanted, [&](const Stroke &stroke, const std::vector<int> &chosen) {
        Stroke result = stroke;
        const int n = int(stroke.segments.size());
        std::vector<int> sources;
        for (int k = 0; k < n; ++k)
            sources.push_back(k);
        // The last run comes first, so that the indices before it stay right.
        for (std::size_t i = chosen.size(); i > 0;) {
            const int last = chosen[--i];
            int first = last;
            while (i > 0 && chosen[i - 1] == first - 1)
                first = chosen[--i];
            if (first < 0 || last >= n)
                continue;
            const std::size_t before = result.segments.size();
            result = withBridge(result, first, last);
            if (result.segments.size() < before)
                sources.erase(sources.begin() + first + 1, sources.begin() + last + 1);
        }
        remap(selection, stroke.id, selectedSources(sources, n, stroke.id, selection));
        return result;
    });
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

Edit moveNodes(const Document &document, const std::set<NodeRef> &nodes, Point by, double reach, SoftMove::Ends ends)
{
    return reshape(document, nodesByStroke(nodes), [&](const Stroke &stroke, const std::vector<int> &which) {
        return SoftMove(stroke, which, reach, ends).by(by);
    });
}

Edit setNodeKind(const Document &document, const std::set<NodeRef> &nodes, NodeKind kind)
{
    return reshape(document, nodesByStroke(nodes), [kind](const Stroke &stroke, const std::vector<int> &which) {
        return withNodeKind(stroke, which, kind);
    });
}

Edit splitAt(Document &document, const PlacesOfStrokes &places, Leaves leaves)
{
    if (leaves == Leaves::Chains)
        return splitIntoChains(document, places);
    const PaintingPtr painting = document.painting();
    Parts parts(document);
    const Locks isLocked(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        const auto it = places.find(stroke->id);
        std::vector<Stroke> cut;
        std::vector<int> sources;
        if (it != places.end() && !isLocked(*stroke) && stroke->fill)
            cut = apart(cutInOne(*stroke, it->second, &sources), sources);
        else if (it != places.end() && !isLocked(*stroke))
            cut = cutAt(*stroke, it->second);
        if (cut.size() < 2) {
            parts.keep(*stroke);
            continue;
        }
        if (!stroke->fill)
            withNodes(*stroke, it->second, &sources);
        parts.replace(*stroke, std::move(cut), sources);
    }
    return parts.edit();
}

Edit cutAlong(const Document &document, const PlacesOfStrokes &places, Point a, Point b)
{
    return splitSegments(document, places,
                         [a, b](const Stroke &stroke, const std::vector<CurvePlace> &where, std::vector<int> *sources) {
                             return stroke.fill ? filledCut(stroke, a, b, sources) : cutInOne(stroke, where, sources);
                         });
}

Edit splitAtNodes(Document &document, const std::set<NodeRef> &nodes, Leaves leaves)
{
    PlacesOfStrokes places;
    for (const NodeRef &ref : nodes)
        if (ref.node > 0)
            places[ref.stroke].push_back({ref.node, 0});
    return splitAt(document, places, leaves);
}

Edit eraseAlong(Document &document, const std::set<StrokeId> &targets, const std::vector<Point> &path, double radius,
                Microseconds T, Leaves leaves)
{
    const PaintingPtr painting = document.painting();
    Parts parts(document);
    const Editable isEditable(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        const bool isMeant = targets.contains(stroke->id) && isEditable(*stroke);
        if (!isMeant || !mayErase(*stroke, path, radius)) {
            parts.keep(*stroke);
            continue;
        }
        std::vector<int> sources;
        std::vector<Stroke> left;
        if (leaves == Leaves::Strokes && !stroke->fill)
            left = erased(*stroke, path, radius, &sources, T);
        else if (std::optional<Stroke> one = erasedInOne(*stroke, path, radius, &sources, T))
            left.push_back(std::move(*one));
        if (leaves == Leaves::Strokes && stroke->fill && !left.empty())
            left = apart(left.front(), sources);
        if (left.size() == 1 && left.front().segments == stroke->segments)
            parts.keep(*stroke);
        else
            parts.replace(*stroke, std::move(left), sources);
    }
    return parts.edit();
}

Edit breakApart(Document &document)
{
    const PaintingPtr painting = document.painting();
    Parts parts(document);
    const Locks isLocked(painting->groups);
    for (const StrokePtr &stroke : painting->strokes) {
        std::vector<Stroke> chains;
        std::vector<int> sources;
        if (document.selection().strokes.contains(stroke->id) && !isLocked(*stroke))
            chains = strokesOfChains(*stroke, &sources);
        if (chains.size() < 2)
            parts.keep(*stroke);
        else
            parts.replace(*stroke, std::move(chains), sources);
    }
    return parts.edit();
}

Edit removeErasures(const Document &document)
{
    Selection selection = document.selection();
    std::map<StrokeId, bool> targets;
    for (const StrokeId id : selection.strokes)
        targets.emplace(id, true);
    Edit edit = reshape(document, targets, [&](const Stroke &stroke, bool) {
        const auto chosen = selection.segments.lower_bound({stroke.id, 0});
        const bool isPart = chosen != selection.segments.end() && chosen->stroke == stroke.id;
        std::vector<int> gone, sources;
        for (int k = 0; k < int(stroke.segments.size()); ++k)
            if (stroke.segments[std::size_t(k)].takesPaint() &&
                (!isPart || selection.segments.contains({stroke.id, k})))
                gone.push_back(k);
        std::optional<Stroke> left = gone.empty() ? std::nullopt : withoutSegments(stroke, gone, &sources);
        if (!left)
            return stroke;
        remap(selection, stroke.id, sources);
        return std::move(*left);
    });
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

Edit reverseSelection(const Document &document)
{
    Selection selection = document.selection();
    std::map<StrokeId, bool> targets;
    for (StrokeId id : selection.strokes)
        targets.emplace(id, true);
    Edit edit = reshape(document, targets, [&](const Stroke &stroke, bool) {
        std::vector<int> sources;
        for (int k = int(stroke.segments.size()); k-- > 0;)
            sources.push_back(k);
        remap(selection, stroke.id, sources);
        return reversed(stroke);
    });
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

Edit extendStroke(const Document &document, NodeRef end, const Stroke &added)
{
    const std::map<StrokeId, int> target{{end.stroke, end.node}};
    Selection selection = document.selection();
    Edit edit = reshape(document, target, [&](const Stroke &before, int node) {
        std::optional<Stroke> longer = joinedAt(before, node, added, 0);
        if (!longer)
            return before;
        const NodeSides sides = sidesOf(before, node);
        const int n = int(before.segments.size()), more = int(longer->segments.size()) - n;
        const int place = sides.before >= 0 ? sides.before + 1 : sides.after; // where the new segments stand
        std::vector<int> sources;
        for (int k = 0; k < n + more; ++k)
            sources.push_back(k < place ? k : k < place + more ? -1 : k - more);
        remap(selection, end.stroke, sources);
        return std::move(*longer);
    });
    if (!edit.isEmpty())
        setSelection(edit, document, std::move(selection));
    return edit;
}

} // namespace suffuse

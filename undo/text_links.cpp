#include "undo/text_links.h"

#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/baseline_curve.h"
#include "undo/text_edits.h"

namespace suffuse {

namespace {

constexpr double curveRounding = 3e-6; ///< of its extent; what float32 can tell

/// A text that follows no stroke any more, and keeps its curve.
Text released(Text text)
{
    text.follows = 0;
    text.followMap = {};
    return text;
}

std::vector<Cubic> underMap(std::vector<Cubic> curves, const Affine &map)
{
    for (Cubic &curve : curves)
        for (Point &p : curve.p)
            p = map(p);
    return curves;
}

bool isSameCurve(const std::vector<Cubic> &a, const std::vector<Cubic> &b)
{
    Rect reach;
    for (const Cubic &curve : b)
        reach = reach.united(curve.controlBox());
    const double extent = std::hypot(reach.width(), reach.height()) + 1e-9;
    if (a.size() == b.size())
        return std::ranges::equal(a, b, [most = curveRounding * extent](const Cubic &x, const Cubic &y) {
            return std::ranges::equal(x.p, y.p, [most](Point p, Point q) { return length(p - q) <= most; });
        });
    // Uneven maps split segments.
    const BaselineCurve first(a), second(b);
    for (int i = 0; i <= 32; ++i)
        if (length(first.at(first.length() * i / 32).point - second.at(second.length() * i / 32).point) > 1e-3 * extent)
            return false;
    return true;
}

/// How far a curve has been moved, if nothing else was done with it.
std::optional<Affine> moveBetween(const std::vector<Cubic> &before, const std::vector<Cubic> &after)
{
    const Affine move = Affine::translation(after.front().p[0] - before.front().p[0]);
    return isSameCurve(underMap(before, move), after) ? std::optional(move) : std::nullopt;
}

/// What an edit makes of a painting, as far as texts need it: its strokes and its groups.
Painting editedBy(const Painting &before, const Edit &edit)
{
    Painting painting = before;
    if (edit.groups)
        painting.groups = *edit.groups;
    if (!edit.reorders()) {
        for (std::size_t i = 0; i < painting.strokes.size(); ++i)
            if (const auto at = edit.strokes.find(std::as_const(painting.strokes)[i]->id); at != edit.strokes.end())
                painting.strokes[i] = at->second;
        return painting;
    }
    std::unordered_map<StrokeId, StrokePtr> there;
    for (const StrokePtr &stroke : before.strokes)
        there.emplace(stroke->id, stroke);
    for (const auto &[id, stroke] : edit.strokes)
        there[id] = stroke;
    painting.strokes.clear();
    for (const StrokeId id : orderWanted(edit, orderOf(before)))
        painting.strokes.push_back(there.at(id));
    return painting;
}

/// What becomes of the text of a group, which follows a stroke.
class Follower {
public:
    Follower(const Painting &before, const Painting &now, const Group &group)
        : m_before(before), m_now(now), m_group(group.id), m_text(*group.text)
    {}

    /// The text in the edited painting; no value where it stays.
    std::optional<Text> text() const
    {
        const StrokePtr was = m_before.find(m_text.follows), is = m_now.find(m_text.follows);
        if (!is)
            return released(m_text);
        Text text = m_text;
        const SharedText old = textOf(m_before, m_group);
        if (!was || was == is || !old || old->follows != text.follows || old->followMap != text.followMap ||
            old->curve != text.curve || textAround(m_now, *is) != 0 || isTextLocked(m_now, m_group))
            return {};
        const std::vector<Cubic> from = baselineOf(*was), to = baselineOf(*is);
        if (from.empty() || to.empty() || from == to)
            return {};
        if (old->place != text.place)
            if (const std::optional<Affine> since = mapOfStroke(*old, from, to)) {
                text.followMap = text.followMap * *since;
                return text;
            }
        text.curve = underMap(to, text.followMap);
        return text;
    }

private:
    /// The map back from a stroke that was mapped together with its text, or moved by itself.
    std::optional<Affine> mapOfStroke(const Text &old, const std::vector<Cubic> &from,
                                      const std::vector<Cubic> &to) const
    {
        const std::optional<Affine> back = old.place.inverse();
        const Affine with = back ? m_text.place * *back : Affine();
        if (isSameCurve(underMap(from, with), to))
            return with.inverse();
        const std::optional<Affine> move = moveBetween(from, to);
        return move ? move->inverse() : std::nullopt;
    }

    const Painting &m_before, &m_now;
    GroupId m_group;
    const Text &m_text;
};

/// The texts of which something is selected, and that is not locked.
std::set<GroupId> chosenTexts(const Document &document)
{
    const Painting &painting = *document.painting();
    std::set<GroupId> texts;
    if (std::ranges::none_of(painting.groups, [](const Group &g) { return bool(g.text); }))
        return texts;
    const Locks isLocked(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->group != 0 && document.selection().strokes.contains(stroke->id) && !isLocked(*stroke))
            texts.insert(textAround(painting, *stroke));
    return texts;
}

/// Changes the texts of which something is selected.
Edit changeTexts(const Document &document, const std::function<SharedText(const Text &)> &change)
{
    const std::set<GroupId> texts = chosenTexts(document);
    Edit edit;
    std::vector<Group> groups = document.painting()->groups;
    for (Group &group : groups)
        if (group.text && texts.contains(group.id))
            group.text = change(*group.text);
    if (groups != document.painting()->groups)
        edit.groups = std::move(groups);
    return edit;
}

} // namespace

std::vector<Cubic> baselineOf(const Stroke &stroke)
{
    std::vector<Cubic> curves;
    for (std::size_t k = 0; k < stroke.segments.size() && (k == 0 || !stroke.beginsChain(k)); ++k)
        curves.push_back(stroke.cubicOf(stroke.segments[k]));
    if (curves.size() > std::size_t(Text::mostCurves))
        curves.clear();
    return curves;
}

bool leadsOtherTexts(const Painting &painting, const std::map<GroupId, Text> &texts,
                     const std::function<bool(StrokeId)> &isAmong)
{
    return std::ranges::any_of(painting.groups, [&](const Group &group) {
        return group.text && group.text->follows != 0 && !texts.contains(group.id) && isAmong(group.text->follows);
    });
}

void followCurves(const Painting &before, Edit &edit, const std::function<LaidText(const Text &)> &lay)
{
    const auto follows = [&](const Group &group) {
        return group.text && group.text->follows != 0 && (edit.groups || edit.strokes.contains(group.text->follows));
    };
    if ((edit.strokes.empty() && !edit.groups) ||
        std::ranges::none_of(edit.groups ? *edit.groups : before.groups, follows))
        return;
    const Painting now = editedBy(before, edit);
    std::vector<Group> groups = now.groups;
    for (Group &group : groups) {
        std::optional<Text> text = follows(group) ? Follower(before, now, group).text() : std::nullopt;
        if (!text || !problemOf(*text).isEmpty())
            continue;
        if (text->curve != group.text->curve) {
            const auto letters = relaidLetters(now, group.id, lay(*group.text), *text, lay(*text));
            if (!letters)
                continue;
            for (const StrokePtr &letter : *letters)
                edit.strokes[letter->id] = letter;
        }
        group.text = std::move(*text);
    }
    if (groups != now.groups)
        edit.groups = std::move(groups);
}

void linkCopies(std::span<Group> groups, const std::unordered_map<StrokeId, StrokeId> &copies, Point by)
{
    for (Group &group : groups) {
        if (!group.text || group.text->follows == 0)
            continue;
        const auto copy = copies.find(group.text->follows);
        if (copy == copies.end()) {
            group.text = released(*group.text);
            continue;
        }
        Text text = *group.text;
        text.follows = copy->second;
        text.followMap = text.followMap * Affine::translation(-1 * by);
        group.text = std::move(text);
    }
}

Edit releaseTexts(const Document &document)
{
    return changeTexts(document, [](const Text &text) { return SharedText(released(text)); });
}

bool canReleaseTexts(const Document &document)
{
    const Painting &painting = *document.painting();
    return std::ranges::any_of(chosenTexts(document), [&](GroupId group) {
        const SharedText text = textOf(painting, group);
        return text && text->follows != 0;
    });
}

Edit textsToStrokes(const Document &document)
{
    return changeTexts(document, [](const Text &) { return SharedText(); });
}

bool canTurnTexts(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    return !selected.empty() && std::ranges::any_of(painting.groups, [](const Group &g) { return bool(g.text); }) &&
           std::ranges::any_of(painting.strokes, [&](const StrokePtr &stroke) {
               return stroke->group != 0 && selected.contains(stroke->id) && textAround(painting, *stroke) != 0;
           });
}

} // namespace suffuse

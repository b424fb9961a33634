#include "undo/text_links.h"

#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/baseline_curve.h"
#include "undo/history/restore_edit.h"
#include "undo/text_edits.h"

namespace suffuse {

namespace {

/// A text that follows no stroke any more, and keeps its curve.
Text released(Text text)
{
    text.follows = 0;
    text.followMap = {};
    return text;
}

/// How far a curve has been moved, if nothing else was done with it.
std::optional<Affine> moveBetween(const std::vector<Cubic> &before, const std::vector<Cubic> &after)
{
    const Affine move = Affine::translation(after.front().p[0] - before.front().p[0]);
    return isSameCurve(mapped(before, move), after) ? std::optional(move) : std::nullopt;
}

/// What a text follows of a chain, which it followed as it was: all of it, or the part along which it stands.
std::vector<Cubic> followed(const std::vector<Cubic> &own, const std::vector<Cubic> &was, std::vector<Cubic> is)
{
    if (isSameCurve(own, was))
        return is;
    const BaselineCurve before(was), now(is);
    const auto ends = before.endsOf(BaselineCurve(own));
    if (!ends || !(now.length() > 0))
        return is;
    const double stretched = now.length() / before.length();
    std::vector<Cubic> part = now.between(stretched * ends->first, stretched * ends->second);
    return part.empty() ? is : part;
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
        text.curve = followed(text.curve, mapped(from, text.followMap), mapped(to, text.followMap));
        return text;
    }

private:
    /// The map back from a stroke that was mapped together with its text, or moved by itself.
    std::optional<Affine> mapOfStroke(const Text &old, const std::vector<Cubic> &from,
                                      const std::vector<Cubic> &to) const
    {
        const std::optional<Affine> back = old.place.inverse();
        const Affine with = back ? m_text.place * *back : Affine();
        if (isSameCurve(mapped(from, with), to))
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

bool leadsOtherTexts(const Painting &painting, const std::map<GroupId, Text> &texts,
                     const std::function<bool(StrokeId)> &isAmong)
{
    return std::ranges::any_of(painting.groups, [&](const Group &group) {
        return group.text && group.text->follows != 0 && !texts.contains(group.id) && isAmong(group.text->follows);
    });
}

void completeTexts(const Painting &before, Edit &edit, const LayText &lay)
{
    followTexts(before, edit);
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
            const std::optional<LaidText> was = lay(*group.text), is = was ? lay(*text) : std::nullopt;
            const auto letters = is ? relaidLetters(now, group.id, *was, *text, *is) : std::nullopt;
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

Painting withTextsCompleted(const Painting &before, const Painting &after, const LayText &lay)
{
    Document document;
    document.reset(std::make_shared<const Painting>(before));
    Edit edit = restorePainting(document, after);
    completeTexts(before, edit, lay);
    document.exchange(edit);
    return *document.painting();
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

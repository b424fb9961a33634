#include "undo/text_edits.h"

#include "model/brush/brush_width.h"
#include "model/painting/validate.h"
#include "model/shaping/transform.h"
#include "undo/fill_edits.h"
#include "undo/history/order_tree.h"
#include "undo/lettering/letter_erasures.h"

#include <numeric>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

/// What stands where in a text, for comparing two states of it.
struct Letter {
    const LaidCluster *cluster = nullptr;
    QStringView characters; ///< of the text, which must live on
    Affine place;           ///< from ems to the canvas
    StrokePtr stroke;
};

std::vector<Letter> lettersIn(const LaidText &laid, const Text &text)
{
    std::vector<Letter> letters;
    letters.reserve(laid.clusters.size());
    const QStringView string = text.string;
    for (const LaidCluster &cluster : laid.clusters)
        if (cluster.hasInk())
            letters.push_back(
                {&cluster, string.mid(cluster.from, cluster.to - cluster.from), text.place * cluster.place, nullptr});
    return letters;
}

/// For each of some texts its partner among others, −1: none. Partners stand in the same order in both, and as many as
/// possible have one. Where that would take long, only the ends are looked at.
std::vector<int> partners(const std::vector<QStringView> &of, const std::vector<QStringView> &among)
{
    std::vector<int> out(of.size(), -1);
    std::size_t head = 0, tail = 0;
    const std::size_t least = std::min(of.size(), among.size());
    for (; head < least && of[head] == among[head]; ++head)
        out[head] = int(head);
    for (; tail < least - head && of[of.size() - 1 - tail] == among[among.size() - 1 - tail]; ++tail)
        out[of.size() - 1 - tail] = int(among.size() - 1 - tail);
    const std::size_t n = of.size() - head - tail, m = among.size() - head - tail;
    constexpr std::size_t mostPairs = 4'000'000;
    if (n == 0 || m == 0 || n * m > mostPairs)
        return out;
    std::vector<std::vector<std::uint32_t>> longest(n + 1, std::vector<std::uint32_t>(m + 1, 0));
    for (std::size_t i = n; i-- > 0;)
        for (std::size_t j = m; j-- > 0;)
            longest[i][j] = of[head + i] == among[head + j] ? longest[i + 1][j + 1] + 1
                                                            : std::max(longest[i + 1][j], longest[i][j + 1]);
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
        if (of[head + i] == among[head + j])
            out[head + i++] = int(head + j++);
        else if (longest[i + 1][j] >= longest[i][j + 1])
            ++i;
        else
            ++j;
    }
    return out;
}

std::vector<QStringView> namesOf(const std::vector<Letter> &letters)
{
    std::vector<QStringView> names;
    for (const Letter &letter : letters)
        names.push_back(letter.characters);
    return names;
}

/// Gives the letters of a text their strokes: by their order if there are as many, else by their names. Returns what
/// else stands in the group, in order.
std::vector<StrokePtr> findStrokes(const Painting &painting, GroupId group, std::vector<Letter> &letters)
{
    std::vector<StrokePtr> own, others;
    own.reserve(letters.size());
    WithinGroup within(painting, group);
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->group == group)
            own.push_back(stroke);
        else if (within(*stroke))
            others.push_back(stroke);
    std::vector<int> found(letters.size(), -1);
    if (own.size() == letters.size()) {
        std::iota(found.begin(), found.end(), 0);
    } else {
        std::vector<QStringView> names;
        for (const StrokePtr &stroke : own)
            names.emplace_back(stroke->name);
        found = partners(namesOf(letters), names);
    }
    std::vector<bool> isLetter(own.size());
    for (std::size_t k = 0; k < letters.size(); ++k)
        if (found[k] >= 0) {
            letters[k].stroke = own[std::size_t(found[k])];
            isLetter[std::size_t(found[k])] = true;
        }
    if (others.empty()) {
        for (std::size_t k = 0; k < own.size(); ++k)
            if (!isLetter[k])
                others.push_back(own[k]);
        return others;
    }
    // In the order of the painting, since those of a group within must stay together.
    std::unordered_set<StrokeId> letterIds;
    for (std::size_t k = 0; k < own.size(); ++k)
        if (isLetter[k])
            letterIds.insert(own[k]->id);
    others.clear();
    for (const StrokePtr &stroke : painting.strokes)
        if (!letterIds.contains(stroke->id) && within(*stroke))
            others.push_back(stroke);
    return others;
}

/// The order in which the strokes of a text lie: its letters as they follow each other, and what else stands in the
/// group above the letter that it lies above now, or above all letters where it lies above all that stay.
std::vector<StrokeId> orderOfText(const Painting &painting, const std::vector<StrokeId> &letters,
                                  const std::vector<StrokePtr> &others)
{
    if (others.empty())
        return letters;
    const std::unordered_set<StrokeId> kept(letters.begin(), letters.end());
    std::unordered_set<StrokeId> otherIds;
    for (const StrokePtr &other : others)
        otherIds.insert(other->id);
    std::unordered_map<StrokeId, std::vector<StrokeId>> above; // by the letter below them; 0: none
    StrokeId top = 0;
    for (const StrokePtr &stroke : painting.strokes)
        if (kept.contains(stroke->id))
            top = stroke->id;
        else if (otherIds.contains(stroke->id))
            above[top].push_back(stroke->id);
    std::vector<StrokeId> order;
    const auto add = [&](StrokeId letter) { order.insert(order.end(), above[letter].begin(), above[letter].end()); };
    if (top != 0)
        add(0);
    for (const StrokeId letter : letters) {
        order.push_back(letter);
        if (letter != top)
            add(letter);
    }
    add(top);
    return order;
}

/// For each new letter the old one that it goes on with, or −1.
std::vector<int> stayingLetters(const std::vector<Letter> &old, const QString &oldString,
                                const std::vector<Letter> &now, const QString &string, std::optional<qsizetype> at)
{
    const qsizetype least = std::min(oldString.size(), string.size());
    qsizetype head = 0, tail = 0;
    const qsizetype mostHead = at ? std::clamp<qsizetype>(*at, 0, least) : least;
    while (head < mostHead && oldString[head] == string[head])
        ++head;
    while (tail < least - head && oldString[oldString.size() - 1 - tail] == string[string.size() - 1 - tail])
        ++tail;
    std::vector<int> out(now.size(), -1);
    const auto same = [&](std::size_t i, std::size_t j) { return old[i].characters == now[j].characters; };
    std::size_t first = 0, last = 0;
    const std::size_t count = std::min(old.size(), now.size());
    while (first < count && same(first, first) && now[first].cluster->to <= head && old[first].cluster->to <= head) {
        out[first] = int(first);
        ++first;
    }
    while (last < count - first) {
        const std::size_t i = old.size() - 1 - last, j = now.size() - 1 - last;
        if (!same(i, j) || now[j].cluster->from < string.size() - tail ||
            old[i].cluster->from < oldString.size() - tail)
            break;
        out[j] = int(i);
        ++last;
    }
    std::vector<QStringView> before, after;
    for (std::size_t i = first; i < old.size() - last; ++i)
        before.push_back(old[i].characters);
    for (std::size_t j = first; j < now.size() - last; ++j)
        after.push_back(now[j].characters);
    const std::vector<int> middle = partners(after, before);
    for (std::size_t j = 0; j < middle.size(); ++j)
        if (middle[j] >= 0)
            out[first + j] = int(first) + middle[j];
    return out;
}

/// Gives a stroke the outline of a letter. The segments have the values of the first one it had that lays paint.
void setOutline(Stroke &stroke, const Letter &letter)
{
    const auto laying = std::ranges::find(stroke.segments, false, &Segment::takesPaint);
    Segment values = laying == stroke.segments.end() ? stroke.segments.front() : *laying;
    values.start = values.lift = values.fade = false;
    values.node = NodeKind::Corner;
    values.style.reset();
    stroke.segments.clear();
    stroke.origin = letter.place.offset;
    for (const std::vector<Cubic> &contour : *letter.cluster->outline) {
        bool isFirst = true;
        for (const Cubic &curve : contour) {
            Segment segment = values;
            for (std::size_t i = 0; i < 4; ++i)
                segment.bezier[i] = toOffset(letter.place.turned(curve.p[i]), {});
            if (!isFirst)
                segment.bezier[0] = stroke.segments.back().bezier[3];
            if (std::ranges::all_of(segment.bezier, [&](Offset o) { return o == segment.bezier[0]; }))
                continue;
            segment.start = isFirst && !stroke.segments.empty();
            isFirst = false;
            stroke.segments.push_back(std::move(segment));
        }
    }
}

bool hasSameLinearPart(const Affine &a, const Affine &b)
{
    return a.a == b.a && a.b == b.b && a.c == b.c && a.d == b.d;
}

/// A stroke that is a letter now, or null where it cannot be. What was erased of it goes along with `map`, from where
/// the letter was to where it is.
StrokePtr asLetter(const Stroke &values, const Letter &letter, const Affine &map = {})
{
    auto stroke = std::make_shared<Stroke>(values);
    stroke->name = letter.characters.toString();
    setOutline(*stroke, letter);
    Stroke erased = values;
    std::erase_if(erased.segments, [](const Segment &segment) { return !segment.takesPaint(); });
    if (!erased.segments.empty() && !stroke->segments.empty()) {
        erased.fill = {};
        erased = transformed(erased, map, SpreadRule::Scales);
        for (Segment &segment : erased.segments) {
            for (Offset &p : segment.bezier)
                p = toOffset(erased.origin + p, stroke->origin);
            stroke->segments.push_back(std::move(segment));
        }
    }
    return stroke->segments.empty() || !problemOf(*stroke).isEmpty() ? nullptr : stroke;
}

/// What a staying letter becomes.
StrokePtr staying(const Letter &old, const Letter &now)
{
    const bool keepsShape = old.cluster->outline == now.cluster->outline && hasSameLinearPart(old.place, now.place);
    if (!keepsShape) {
        const std::optional<Affine> back = old.place.inverse();
        return asLetter(*old.stroke, now, back ? now.place * *back : Affine());
    }
    if (old.place.offset == now.place.offset)
        return old.stroke;
    auto moved = std::make_shared<Stroke>(*old.stroke);
    moved->origin = moved->origin + (now.place.offset - old.place.offset);
    return problemOf(*moved).isEmpty() ? moved : nullptr;
}

/// Whether a letter has the outline that the font gives it, and nobody has drawn it otherwise.
bool isAsSet(const Letter &letter)
{
    Stroke set = *letter.stroke;
    setOutline(set, letter);
    if (set.segments.size() > letter.stroke->segments.size())
        return false;
    const double most = 1e-4 * std::sqrt(std::abs(letter.place.determinant()));
    for (std::size_t k = 0; k < set.segments.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i)
            if (!(length(set.origin + set.segments[k].bezier[i] -
                         (letter.stroke->origin + letter.stroke->segments[k].bezier[i])) <= most))
                return false;
    return true;
}

/// What a letter becomes whose curve has changed: what was drawn otherwise, and letters of a font that is missing, are
/// turned and moved as they are. Null where it cannot be.
StrokePtr following(const Letter &old, const Letter &now)
{
    const std::optional<Affine> back = old.place.inverse();
    if (!back || hasSameLinearPart(old.place, now.place) || isAsSet(old))
        return staying(old, now);
    std::optional<Stroke> turned = tryTransformed(*old.stroke, now.place * *back, SpreadRule::Scales);
    return turned ? std::make_shared<const Stroke>(std::move(*turned)) : nullptr;
}

LetterErasures erasuresIn(const std::vector<Letter> &letters, const Text &before, const Text &after)
{
    LetterErasures erasures(before, after);
    for (const Letter &letter : letters)
        if (letter.stroke)
            erasures.note(*letter.stroke);
    erasures.findLong();
    return erasures;
}

/// How a letter went to where it is.
LetterErasures::Step stepBetween(const Letter &old, const Letter &now)
{
    const std::optional<Affine> back = old.place.inverse();
    return {back ? now.place * *back : Affine(), old.cluster->along, now.cluster->along};
}

/// A letter that looks as another one.
Stroke like(const Stroke &neighbour, const Stroke &letter)
{
    Stroke stroke = neighbour;
    stroke.id = 0;
    stroke.visible = true;
    stroke.locked = false;
    std::erase_if(stroke.segments,
                  [](const Segment &segment) { return segment.takesPaint(); }); // only that letter is erased
    stroke.segments.resize(1);
    Segment &values = stroke.segments.front();
    values.born = letter.segments.front().born;
    values.rewet.clear();
    values.lift = values.fade = false;
    if (stroke.fill) {
        Fill fill = *stroke.fill;
        fill.born = values.born;
        stroke.fill = fill;
    }
    return stroke;
}

} // namespace

Stroke letterWith(const Brush &brush, double size, Microseconds born)
{
    constexpr double mostSpread = 1.0 / 30; // ems
    Stroke stroke;
    stroke.style = brush.style;
    stroke.mix = brush.mix;
    stroke.brush = brush.name;
    Segment values = valuesAtFullPressure(brush);
    values.born = born;
    stroke.segments.push_back(values);
    Fill fill = usualFill(stroke);
    const double spread = mostSpread * size;
    fill.diffusion = std::min(fill.diffusion, float(spread * spread / (4 * double(fill.maxAge))));
    stroke.fill = fill;
    stroke.segments.front().density = 0;
    return stroke;
}

std::vector<StrokeId> lettersOf(const Painting &painting, GroupId group, const LaidText &laid)
{
    const SharedText text = textOf(painting, group);
    if (!text)
        return {};
    std::vector<Letter> letters = lettersIn(laid, *text);
    findStrokes(painting, group, letters);
    std::vector<StrokeId> ids;
    for (const Letter &letter : letters)
        ids.push_back(letter.stroke ? letter.stroke->id : 0);
    return ids;
}

std::optional<std::vector<StrokePtr>> relaidLetters(const Painting &painting, GroupId group, const LaidText &before,
                                                    const Text &text, const LaidText &after)
{
    std::vector<Letter> old = lettersIn(before, *textOf(painting, group)), now = lettersIn(after, text);
    if (old.size() != now.size())
        return {};
    findStrokes(painting, group, old);
    const SharedText was = textOf(painting, group);
    const LetterErasures erasures = erasuresIn(old, *was, text);
    std::vector<StrokePtr> relaid;
    for (std::size_t k = 0; k < old.size(); ++k) {
        if (!old[k].stroke)
            continue; // It was deleted, and stays so.
        const StrokePtr made = erasures.bent(following(old[k], now[k]), stepBetween(old[k], now[k]));
        if (!made)
            return {};
        if (made != old[k].stroke)
            relaid.push_back(made);
    }
    return relaid;
}

Edit setText(Document &document, GroupId group, const Text &text, const LaidText *before, const LaidText &after,
             const TextChange &change)
{
    const Painting &painting = *document.painting();
    const Group *present = painting.findGroup(group);
    const Text was = present && present->text && before ? *present->text : Text();
    if ((present && isTextLocked(painting, group)) || !problemOf(text).isEmpty())
        return {};
    std::vector<Letter> old, now = lettersIn(after, text);
    if (present && before)
        old = lettersIn(*before, was);
    const std::vector<StrokePtr> others = present ? findStrokes(painting, group, old) : std::vector<StrokePtr>();
    const std::vector<int> stays = stayingLetters(old, was.string, now, text.string, change.at);
    const LetterErasures erasures = erasuresIn(old, was, text);

    Edit edit;
    std::vector<StrokeId> letters;
    StrokePtr neighbour;
    for (std::size_t k = 0; k < now.size() && !neighbour; ++k) // for those before the first that stays
        if (stays[k] >= 0)
            neighbour = old[std::size_t(stays[k])].stroke;
    if (!neighbour)
        for (const Letter &letter : old)
            neighbour = neighbour ? neighbour : letter.stroke;
    std::vector<bool> isGone(old.size(), true);
    for (const int stay : stays)
        if (stay >= 0)
            isGone[std::size_t(stay)] = false;
    std::size_t next = 0; // of the old letters, behind the last one that stays
    for (std::size_t k = 0; k < now.size(); ++k) {
        const Letter *letter = stays[k] >= 0 ? &old[std::size_t(stays[k])] : nullptr;
        StrokePtr made;
        if (letter) {
            next = std::size_t(stays[k]) + 1;
            if (!letter->stroke)
                continue; // It was deleted, and stays so.
            made = erasures.bent(staying(*letter, now[k]), stepBetween(*letter, now[k]));
            if (!made)
                return {};
            neighbour = letter->stroke;
            if (made != letter->stroke)
                edit.strokes.emplace(made->id, made);
        } else {
            const bool replaces = next < old.size() && isGone[next] && old[next].stroke;
            const StrokePtr &model = replaces ? old[next].stroke : neighbour;
            Stroke values = model && change.likeNeighbours ? like(*model, change.letter) : change.letter;
            values.id = document.takeStrokeId();
            values.group = group;
            made = asLetter(values, now[k]);
            if (!made)
                continue; // It is too small, or lies too far out.
            edit.strokes.emplace(made->id, made);
        }
        letters.push_back(made->id);
    }
    for (std::size_t i = 0; i < old.size(); ++i)
        if (isGone[i] && old[i].stroke)
            edit.strokes.emplace(old[i].stroke->id, nullptr);

    const bool remains = !letters.empty() || !others.empty();
    std::vector<StrokeId> order;
    bool isPut = false;
    const auto put = [&] {
        if (std::exchange(isPut, true))
            return;
        const std::vector<StrokeId> together = orderOfText(painting, letters, others);
        order.insert(order.end(), together.begin(), together.end());
    };
    WithinGroup within(painting, group);
    for (const StrokePtr &stroke : painting.strokes)
        if (within(*stroke))
            put();
        else
            order.push_back(stroke->id);
    put();
    if (order != orderOf(painting))
        edit.order = std::move(order);

    std::vector<Group> groups = painting.groups;
    if (!remains)
        std::erase_if(groups, [group](const Group &g) { return g.id == group; });
    else if (present)
        std::ranges::find(groups, group, &Group::id)->text = text;
    else
        groups.push_back({group, {}, 0, true, false, text});
    if (groups != painting.groups)
        edit.groups = std::move(groups);
    return edit;
}

} // namespace suffuse

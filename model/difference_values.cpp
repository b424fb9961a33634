// Single values that differ, written as the text form writes them.
#include "model/document/difference.h"
#include "model/formats/text/text_numbers.h"
#include "model/formats/text/value_json.h"

#include <QCryptographicHash>

#include <map>

namespace suffuse {

namespace {

/// Names and values of one thing, in the order of the text form.
using Members = std::vector<std::pair<QByteArray, QByteArray>>;

QByteArray text(const QString &value)
{
    QByteArray out;
    appendString(out, value);
    return out;
}
QByteArray text(bool value)
{
    return value ? "true" : "false";
}
template <typename Number>
requires std::is_floating_point_v<Number> || std::is_same_v<Number, std::uint64_t> QByteArray text(Number value)
{
    QByteArray out;
    appendNumber(out, value);
    return out;
}
template <typename Number>
QByteArray pairOf(Number x, Number y)
{
    return '[' + text(x) + ',' + text(y) + ']';
}
template <typename Value>
QByteArray json(const Value &value)
{
    QByteArray out;
    appendJson(out, value);
    return out;
}
QByteArray seconds(Microseconds value)
{
    QByteArray out;
    appendSeconds(out, value);
    return out;
}
QByteArray groupText(GroupId id)
{
    return id ? text(std::uint64_t(id)) : QByteArray("null");
}
QByteArray word(const char *value)
{
    return '"' + QByteArray(value) + '"';
}
QByteArray imageText(const EncodedImage &image)
{
    if (!image)
        return "null";
    return text(QStringLiteral("%1 bytes, SHA-256 %2")
                    .arg(image->size())
                    .arg(QString::fromLatin1(QCryptographicHash::hash(*image, QCryptographicHash::Sha256).toHex())));
}

Members membersOf(const Stroke &s)
{
    return {{"name", text(s.name)},
            {"group", groupText(s.group)},
            {"visible", text(s.visible)},
            {"locked", text(s.locked)},
            {"style", json(s.style)},
            {"mix", json(s.mix)},
            {"origin", pairOf(s.origin.x, s.origin.y)},
            {"brush", text(s.brush)}};
}

Members membersOf(const Segment &s)
{
    static constexpr const char *nodes[] = {"smooth", "symmetric", "corner"};
    Members out;
    for (std::size_t k = 0; k < s.bezier.size(); ++k)
        out.emplace_back("bezier[" + QByteArray::number(int(k)) + ']', pairOf(s.bezier[k].x, s.bezier[k].y));
    out.insert(out.end(), {{"diffusion", text(s.diffusion)},
                           {"density", text(s.density)},
                           {"granulation", text(s.granulation)},
                           {"maxAge", text(s.maxAge)},
                           {"born", seconds(s.born)},
                           {"colour", json(s.colour)},
                           {"style", s.style ? json(*s.style) : QByteArray("null")},
                           {"anisotropy.ratio", text(s.anisotropyRatio)},
                           {"anisotropy.angle", text(s.anisotropyAngle)},
                           {"node", word(nodes[int(s.node)])}});
    QByteArray rewet = "[";
    for (const Rewet &r : s.rewet)
        rewet += (rewet.size() > 1 ? ",[" : "[") + seconds(r.time) + ',' + seconds(r.extra) + ']';
    out.emplace_back("rewet", rewet + ']');
    return out;
}

Members membersOf(const Canvas &c)
{
    static constexpr const char *kinds[] = {"none", "procedural", "image"};
    static constexpr const char *grains[] = {"tooth", "fibres", "weave"};
    const Paper &p = c.paper;
    return {{"width", text(c.width)},
            {"height", text(c.height)},
            {"background", json(c.background)},
            {"paper.kind", word(kinds[int(p.kind)])},
            {"paper.grain", word(grains[int(p.grain)])},
            {"paper.seed", text(std::uint64_t(p.seed))},
            {"paper.scale", text(p.scale)},
            {"paper.strength", text(p.strength)},
            {"paper.image", imageText(p.image)}};
}

Members membersOf(const Group &g)
{
    return {{"name", text(g.name)},
            {"parent", groupText(g.parent)},
            {"visible", text(g.visible)},
            {"locked", text(g.locked)}};
}

Members membersOf(const Swatch &s)
{
    return {{"name", text(s.name)}, {"colour", json(s.colour)}};
}

Members membersOf(const Underlay &u)
{
    return {{"image", imageText(u.image)},
            {"area", '[' + text(u.area.left) + ',' + text(u.area.top) + ',' + text(u.area.width()) + ',' +
                         text(u.area.height()) + ']'},
            {"opacity", text(u.opacity)},
            {"visible", text(u.visible)}};
}

/// Null: it is not there.
template <typename Thing>
void compare(const QString &path, const Thing *before, const Thing *after, std::vector<ValueDifference> &out)
{
    const Members a = before ? membersOf(*before) : Members(), b = after ? membersOf(*after) : Members();
    const std::size_t count = std::max(a.size(), b.size());
    for (std::size_t k = 0; k < count; ++k) {
        const QByteArray &name = (a.empty() ? b : a)[k].first;
        const QByteArray was = a.empty() ? QByteArray() : a[k].second, is = b.empty() ? QByteArray() : b[k].second;
        if (was != is)
            out.push_back({path + QString::fromLatin1(name), QString::fromUtf8(was), QString::fromUtf8(is)});
    }
}

void compareGroups(const Painting &before, const Painting &after, std::vector<ValueDifference> &out)
{
    std::map<GroupId, std::pair<const Group *, const Group *>> groups;
    for (const Group &g : before.groups)
        groups[g.id].first = &g;
    for (const Group &g : after.groups)
        groups[g.id].second = &g;
    for (const auto &[id, both] : groups)
        compare(QStringLiteral("groups[%1].").arg(id), both.first, both.second, out);
    const auto idsOf = [](const Painting &painting) {
        QByteArray list = "[";
        for (const Group &g : painting.groups)
            list += (list.size() > 1 ? "," : "") + text(std::uint64_t(g.id));
        return QString::fromLatin1(list + ']');
    };
    if (idsOf(before) != idsOf(after))
        out.push_back({QStringLiteral("groups"), idsOf(before), idsOf(after)});
}

} // namespace

StrokeDifference differenceOf(const Stroke &before, const Stroke &after)
{
    StrokeDifference out;
    compare(QString(), &before, &after, out.values);
    const auto &a = before.segments, &b = after.segments;
    const std::size_t least = std::min(a.size(), b.size());
    std::size_t head = 0, tail = 0;
    while (head < least && a[head] == b[head])
        ++head;
    while (tail < least - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail])
        ++tail;
    for (std::size_t k = head; k < std::max(a.size(), b.size()) - tail; ++k) {
        const bool inA = k < a.size() - tail, inB = k < b.size() - tail;
        if (!inA) {
            out.added.push_back(k);
        } else if (!inB) {
            out.removed.push_back(k);
        } else if (!(a[k] == b[k])) {
            out.changed.push_back(k);
            compare(QStringLiteral("segments[%1].").arg(k), &a[k], &b[k], out.values);
        }
    }
    return out;
}

std::vector<ValueDifference> valuesThatDiffer(const Painting &before, const Painting &after)
{
    std::vector<ValueDifference> out;
    compare(QStringLiteral("canvas."), &before.canvas, &after.canvas, out);
    if (before.groups != after.groups)
        compareGroups(before, after, out);
    for (std::size_t k = 0; k < std::max(before.swatches.size(), after.swatches.size()); ++k) {
        compare(QStringLiteral("swatches[%1].").arg(k), k < before.swatches.size() ? &before.swatches[k] : nullptr,
                k < after.swatches.size() ? &after.swatches[k] : nullptr, out);
    }
    compare(QStringLiteral("underlay."), before.underlay.get(), after.underlay.get(), out);
    return out;
}

} // namespace suffuse

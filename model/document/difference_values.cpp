// Single values that differ, written as the text form writes them.
#include "model/document/difference.h"
#include "model/formats/text/field_json.h"

#include <map>

namespace suffuse {

namespace {

/// Appends what differs between two things, which may be null where they do not exist.
template <typename Thing>
void compare(const QString &path, const Thing *before, const Thing *after, std::vector<ValueDifference> &out)
{
    const FieldTexts a = before ? fieldTextsOf(*before) : FieldTexts();
    const FieldTexts b = after ? fieldTextsOf(*after) : FieldTexts();
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
            list += (list.size() > 1 ? "," : "") + QByteArray::number(quint64(g.id));
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

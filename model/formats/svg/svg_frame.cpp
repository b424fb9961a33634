#include "model/formats/svg/svg_frame.h"

#include "model/formats/svg/css/css_blending.h"
#include "model/formats/svg/svg_length.h"
#include "model/formats/svg/svg_matrix.h"

#include <algorithm>

namespace suffuse {

namespace {

/// A size of the document; no value for per cents and what is no size.
std::optional<double> sizeOf(const QXmlStreamAttributes &root, const char *name)
{
    const std::optional<double> size = svgLength(root.value(QLatin1String(name)).toString());
    return size && *size > 0 ? size : std::nullopt;
}

constexpr qsizetype longestWords = 80; ///< by which a text is called

} // namespace

void takeSize(SvgDrawing &drawing, const QXmlStreamAttributes &root)
{
    const std::optional<double> width = sizeOf(root, "width"), height = sizeOf(root, "height");
    drawing.area = svgViewBox(root);
    if (drawing.area.isEmpty()) {
        if (width && height)
            drawing.area = Rect::of(0, 0, *width, *height);
        return;
    }
    const Rect box = drawing.area;
    const double byWidth = width.value_or(HUGE_VAL) / box.width(), byHeight = height.value_or(HUGE_VAL) / box.height();
    const double scale = std::min(byWidth, byHeight);
    drawing.scale = std::isfinite(scale) ? scale : 1;
    if (!width || !height)
        return;
    const SvgMatrix placing =
        svgViewport(box, Rect::of(0, 0, *width, *height), root.value(QLatin1String("preserveAspectRatio")).toString());
    if (placing.a != placing.d || !(placing.a > 0)) // "none" stretches, which a canvas cannot
        return;
    drawing.scale = placing.a;
    drawing.area = Rect::of(-placing.e / placing.a, -placing.f / placing.a, *width / placing.a, *height / placing.a);
}

void dissolveGroups(SvgDrawing &drawing)
{
    std::vector<SvgGroup> &groups = drawing.groups;
    std::vector<int> held(groups.size(), 0), into(groups.size(), -1);
    for (const SvgPath &path : drawing.paths)
        if (path.group >= 0)
            ++held[std::size_t(path.group)];
    for (std::size_t i = 0; i < groups.size(); ++i) // Where letters are no single paths, as faded ones, it is no text.
        if (groups[i].text && std::size_t(held[i]) != groups[i].letters)
            groups[i].text = {};
    std::vector<QString> handed(groups.size());
    for (std::size_t i = groups.size(); i-- > 0;) // Groups come before those within them.
        if (held[i] > 0 && groups[i].parent >= 0)
            ++held[std::size_t(groups[i].parent)];
    for (std::size_t i = 0; i < groups.size(); ++i) {
        SvgGroup &group = groups[i];
        if (group.words.isEmpty() || group.text || held[i] == 0)
            continue;
        ++drawing.losses.fixedTexts;
        if (group.name.isEmpty()) // A text that can be typed is called by its words anyway.
            group.name = group.words.left(longestWords);
    }
    const auto isKept = [&](std::size_t i) {
        return held[i] > 1 || (held[i] > 0 && (groups[i].text || groups[i].isHidden || blends(groups[i])));
    };
    std::vector<SvgGroup> kept;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const int parent = groups[i].parent;
        const int outer = parent >= 0 ? into[std::size_t(parent)] : -1;
        const QString fromAbove = parent >= 0 ? handed[std::size_t(parent)] : QString();
        const QString name = groups[i].name.isEmpty() ? fromAbove : groups[i].name;
        into[i] = outer;
        handed[i] = isKept(i) ? QString() : name;
        if (!isKept(i))
            continue;
        into[i] = int(kept.size());
        kept.push_back(groups[i]);
        kept.back().name = name, kept.back().parent = outer;
    }
    for (SvgPath &path : drawing.paths) {
        if (path.group < 0)
            continue;
        if (path.name.isEmpty())
            path.name = handed[std::size_t(path.group)];
        path.group = into[std::size_t(path.group)];
    }
    groups = std::move(kept);
}

} // namespace suffuse

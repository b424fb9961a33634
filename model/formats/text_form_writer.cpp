// docs/text-form.md, writing. One segment a line, so that a version control system shows what changed.
#include "model/formats/embedded_image.h"
#include "model/formats/files.h"
#include "model/formats/text/text_numbers.h"
#include "model/formats/text/value_json.h"

namespace suffuse {

namespace {

void append(QByteArray &out, Offset p)
{
    appendNumber(out.append('['), p.x);
    appendNumber(out.append(','), p.y);
    out.append(']');
}

void append(QByteArray &out, bool value)
{
    out.append(value ? "true" : "false");
}

void appendOptional(QByteArray &out, const Segment &s)
{
    if (s.style)
        appendJson(out.append(", \"style\": "), *s.style);
    if (s.anisotropyRatio != 1 || s.anisotropyAngle != 0) {
        appendNumber(out.append(", \"anisotropy\": {\"ratio\": "), s.anisotropyRatio);
        appendNumber(out.append(", \"angle\": "), s.anisotropyAngle);
        out.append('}');
    }
    if (s.node != NodeKind::Smooth)
        out.append(s.node == NodeKind::Symmetric ? ", \"node\": \"symmetric\"" : ", \"node\": \"corner\"");
    if (s.rewet.empty())
        return;
    out.append(", \"rewet\": [");
    for (std::size_t k = 0; k < s.rewet.size(); ++k) {
        appendSeconds(out.append(k ? ",[" : "["), s.rewet[k].time);
        appendSeconds(out.append(','), s.rewet[k].extra);
        out.append(']');
    }
    out.append(']');
}

void append(QByteArray &out, const Segment &s)
{
    out.append("{\"bezier\": [");
    for (std::size_t k = 0; k < 4; ++k) {
        if (k)
            out.append(',');
        append(out, s.bezier[k]);
    }
    appendNumber(out.append("], \"diffusion\": "), s.diffusion);
    appendNumber(out.append(", \"density\": "), s.density);
    appendNumber(out.append(", \"granulation\": "), s.granulation);
    appendNumber(out.append(", \"maxAge\": "), s.maxAge);
    appendSeconds(out.append(", \"born\": "), s.born);
    appendJson(out.append(", \"colour\": "), s.colour);
    appendOptional(out, s);
    out.append('}');
}

void append(QByteArray &out, const Stroke &stroke)
{
    appendNumber(out.append("{\"id\": "), stroke.id);
    appendString(out.append(", \"name\": "), stroke.name);
    out.append(", \"group\": ");
    if (stroke.group)
        appendNumber(out, stroke.group);
    else
        out.append("null");
    append(out.append(", \"visible\": "), stroke.visible);
    append(out.append(", \"locked\": "), stroke.locked);
    appendJson(out.append(",\n   \"style\": "), stroke.style);
    appendJson(out.append(", \"mix\": "), stroke.mix);
    if (stroke.origin != Point{}) {
        appendNumber(out.append(", \"origin\": ["), stroke.origin.x);
        appendNumber(out.append(','), stroke.origin.y);
        out.append(']');
    }
    if (!stroke.brush.isEmpty())
        appendString(out.append(", \"brush\": "), stroke.brush);
    out.append(",\n   \"segments\": [");
    for (std::size_t k = 0; k < stroke.segments.size(); ++k)
        append(out.append(k ? ",\n    " : "\n    "), stroke.segments[k]);
    out.append("]}");
}

void append(QByteArray &out, const Paper &paper)
{
    static constexpr const char *names[] = {"none", "procedural", "image"};
    static constexpr const char *grains[] = {"tooth", "fibres", "weave"};
    static const Paper usual;
    const bool all = paper.kind != PaperKind::None;
    out.append("{\"kind\": \"").append(names[int(paper.kind)]).append('"');
    if (paper.grain != usual.grain)
        out.append(", \"grain\": \"").append(grains[int(paper.grain)]).append('"');
    if (all || paper.seed != usual.seed)
        appendNumber(out.append(", \"seed\": "), std::uint64_t(paper.seed));
    if (all || paper.scale != usual.scale)
        appendNumber(out.append(", \"scale\": "), paper.scale);
    if (all || paper.strength != usual.strength)
        appendNumber(out.append(", \"strength\": "), paper.strength);
    if (paper.image)
        out.append(", \"image\": \"").append(imageToText(*paper.image)).append('"');
    out.append('}');
}

void append(QByteArray &out, const Canvas &canvas)
{
    appendNumber(out.append("{\"width\": "), canvas.width);
    appendNumber(out.append(", \"height\": "), canvas.height);
    appendJson(out.append(", \"background\": "), canvas.background);
    append(out.append(", \"paper\": "), canvas.paper);
    out.append('}');
}

void append(QByteArray &out, const Group &group)
{
    appendNumber(out.append("{\"id\": "), group.id);
    appendString(out.append(", \"name\": "), group.name);
    out.append(", \"parent\": ");
    if (group.parent)
        appendNumber(out, group.parent);
    else
        out.append("null");
    append(out.append(", \"visible\": "), group.visible);
    append(out.append(", \"locked\": "), group.locked);
    out.append('}');
}

void append(QByteArray &out, const Swatch &swatch)
{
    appendString(out.append("{\"name\": "), swatch.name);
    appendJson(out.append(", \"colour\": "), swatch.colour);
    out.append('}');
}

/// The extent that, added to `from`, gives `to` again; a plain difference may be off by one rounding.
double extentTo(double from, double to)
{
    const double plain = to - from;
    for (const double extent : {plain, std::nextafter(plain, HUGE_VAL), std::nextafter(plain, -HUGE_VAL)}) {
        if (from + extent == to)
            return extent;
    }
    return plain;
}

void append(QByteArray &out, const Underlay &underlay)
{
    const Rect &area = underlay.area;
    out.append('{');
    if (underlay.image)
        out.append("\"image\": \"").append(imageToText(*underlay.image)).append("\", ");
    appendNumber(out.append("\"area\": ["), area.left);
    appendNumber(out.append(','), area.top);
    appendNumber(out.append(','), extentTo(area.left, area.right));
    appendNumber(out.append(','), extentTo(area.top, area.bottom));
    appendNumber(out.append("], \"opacity\": "), underlay.opacity);
    append(out.append(", \"visible\": "), underlay.visible);
    out.append('}');
}

template <typename List>
void appendList(QByteArray &out, const char *name, const List &list)
{
    out.append(",\n \"").append(name).append("\": [");
    for (std::size_t k = 0; k < list.size(); ++k)
        append(out.append(k ? ",\n  " : "\n  "), list[k]);
    out.append(']');
}

} // namespace

QByteArray writeTextForm(const Painting &painting)
{
    QByteArray out;
    out.reserve(qsizetype(1024 + 320 * painting.segmentCount()));
    out.append("{\"format\": \"suffuse-text\", \"version\": 1,\n \"canvas\": ");
    append(out, painting.canvas);
    if (!painting.groups.empty())
        appendList(out, "groups", painting.groups);
    if (!painting.swatches.empty())
        appendList(out, "swatches", painting.swatches);
    if (painting.underlay)
        append(out.append(",\n \"underlay\": "), *painting.underlay);
    out.append(",\n \"strokes\": [");
    for (std::size_t k = 0; k < painting.strokes.size(); ++k)
        append(out.append(k ? ",\n  " : "\n  "), *painting.strokes[k]);
    out.append("]}\n");
    return out;
}

} // namespace suffuse

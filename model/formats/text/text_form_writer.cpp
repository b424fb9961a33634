// Writes the text form (docs/text-form.md). Each segment has a line of its own, so that a version control system shows
// what changed.
#include "model/formats/files.h"
#include "model/formats/text/field_json.h"

namespace suffuse {

namespace {

void append(QByteArray &out, const StrokePtr &stroke)
{
    appendObject(out, *stroke, [](std::string_view name) {
        return name == "style" || name == "fill" || name == "picture" || name == "segments" ? ",\n   " : ", ";
    });
}

template <HasFields T>
void append(QByteArray &out, const T &value)
{
    appendObject(out, value);
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
    // The version is the least that can hold the painting, so that a painting which uses nothing new is the same text
    // as before.
    out.append("{\"format\": \"suffuse-text\", \"version\": ").append(QByteArray::number(versionNeededBy(painting)));
    out.append(",\n \"canvas\": ");
    append(out, painting.canvas);
    if (!painting.groups.empty())
        appendList(out, "groups", painting.groups);
    if (!painting.swatches.empty())
        appendList(out, "swatches", painting.swatches);
    if (painting.underlay)
        append(out.append(",\n \"underlay\": "), *painting.underlay);
    appendList(out, "strokes", painting.strokes);
    out.append("}\n");
    return out;
}

} // namespace suffuse

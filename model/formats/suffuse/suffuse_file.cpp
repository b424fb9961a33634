// docs/file-format.md: a painting and what belongs beside it as the bytes of a file.
#include "model/formats/suffuse/field_columns.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_extras.h"
#include "model/formats/suffuse/suffuse_strokes.h"
#include "model/parallel.h"

#include <QCborMap>
#include <QCryptographicHash>

namespace suffuse {

namespace {

constexpr bool laterFieldsHaveColumns()
{
    bool all = true;
    forEachFieldOf<Segment>([&]<class Value>(const Field<Segment, Value> &field) {
        constexpr bool has =
            std::is_same_v<Value, float> || std::is_same_v<Value, Colour> || std::is_same_v<Value, bool>;
        all = all && (field.traits.since == 1 || (has && field.traits.since <= suffuseVersion));
    });
    return all;
}
static_assert(laterFieldsHaveColumns(),
              "a field of a segment that is neither number nor flag needs columns of its own, "
              "and one that this version does not know a greater suffuseVersion");

struct Totals {
    std::uint64_t segments = 0;
    std::uint64_t rewets = 0;
    std::uint64_t blocks = 0;        ///< the number of bytes that all palettes may have at most
    int reader = suffuseLeastReader; ///< the least version of a reader that understands the document
};

Totals totalsOf(const Painting &painting)
{
    constexpr std::uint64_t style = 16, stroke = style + 8 + 4 * 10; // A varint has up to 10 bytes.
    Totals t;
    for (const StrokePtr &s : painting.strokes) {
        t.segments += s->segments.size();
        t.reader = std::max(t.reader, versionNeededBy(*s));
        // UTF-8 may have three bytes for each unit of UTF-16.
        const qsizetype link = s->picture ? s->picture->link.size() : 0;
        t.blocks += stroke + 3 * std::uint64_t(s->name.size() + s->brush.size() + link);
        for (const Segment &segment : s->segments) {
            t.rewets += segment.rewet.size();
            t.blocks += segment.style ? style : 0;
            t.reader = std::max(t.reader, versionNeededBy(segment));
        }
    }
    for (const Group &group : painting.groups)
        t.reader = std::max(t.reader, versionNeededBy(group, true));
    return t;
}

QByteArray header(const Painting &painting, const Totals &totals)
{
    // A document that needs nothing of a later version has the same bytes as before that version.
    const QCborMap map{{QLatin1String("version"), totals.reader},
                       {QLatin1String("reader"), totals.reader},
                       {QLatin1String("program"), QStringLiteral("Suffuse " SUFFUSE_VERSION)},
                       {QLatin1String("strokes"), qint64(painting.strokes.size())},
                       {QLatin1String("segments"), qint64(totals.segments)}};
    return QCborValue(map).toCbor();
}

using Strokes = std::span<const StrokePtr>;

std::vector<QByteArray> strokeChunks(const std::vector<Strokes> &parts, const Totals &totals)
{
    std::vector<QByteArray> chunks(parts.size());
    Density density{totals.segments > freeElements, totals.rewets > freeElements, blockBudget};
    if (totals.blocks <= blockBudget) { // Then no chunk needs to know what the others have used.
        forEachInParallel(parts.size(), [&](std::size_t k) {
            Density own = density;
            chunks[k] = writeStrokes(parts[k], own);
        });
        return chunks;
    }
    for (std::size_t k = 0; k < parts.size(); ++k)
        chunks[k] = writeStrokes(parts[k], density);
    return chunks;
}

} // namespace

std::vector<Strokes> inChunks(Strokes strokes)
{
    std::size_t total = 0;
    for (const StrokePtr &s : strokes)
        total += s->segments.size();
    const std::size_t most = segmentsPerChunk(total);
    std::vector<Strokes> parts;
    for (std::size_t from = 0; from < strokes.size();) {
        std::size_t to = from + 1, segments = strokes[from]->segments.size();
        for (; to < strokes.size() && (segments += strokes[to]->segments.size()) <= most; ++to)
            ;
        parts.push_back(strokes.subspan(from, to - from));
        from = to;
    }
    return parts;
}

QByteArray writeSuffuseFile(const Painting &painting, const DocumentExtras &extras)
{
    const Totals totals = totalsOf(painting);
    std::vector<EncodedImage> images;
    const QByteArray document = writeProperties(painting, images);
    const std::vector<StrokePtr> all(painting.strokes.begin(), painting.strokes.end());
    appendNew(images, imagesOf(all));
    const std::vector<QByteArray> strokes = strokeChunks(inChunks(all), totals);

    QByteArray out = QByteArray(suffuseName) + suffuseLineEnds;
    appendChunk(out, "HEAD", header(painting, totals));
    appendFirstExtras(out, extras);
    for (const EncodedImage &image : images)
        appendChunk(out, "IMAG", *image);
    appendChunk(out, "DOCU", document);
    for (const QByteArray &chunk : strokes)
        appendChunk(out, "STRK", chunk);
    appendLastExtras(out, extras);
    appendChunk(out, "ENDS", QCryptographicHash::hash(out, QCryptographicHash::Sha256));
    return out;
}

} // namespace suffuse

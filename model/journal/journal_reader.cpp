#include "model/formats/embedded_image.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/formats/suffuse/suffuse_strokes.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_layout.h"
#include "model/painting/resolution.h"
#include "model/painting/validate.h"

#include <QCborArray>
#include <QCborMap>

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

std::optional<QCborMap> mapIn(QByteArrayView payload)
{
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(payload.data(), payload.size(), &problem);
    if (problem.error != QCborError::NoError || !value.isMap())
        return std::nullopt;
    return value.toMap();
}

/// Replays records. A record that makes no sense ends the reading like a torn one: what came before it counts.
class JournalReader {
    using Ids = std::unordered_set<StrokeId>;

public:
    JournalReader(const QByteArray &bytes, const QString &fileName)
        : m_bytes(bytes), m_fileName(fileName), m_allowance(freeElements + std::uint64_t(bytes.size()), blockBudget)
    {}

    Result<JournalContent> read()
    {
        if (!m_bytes.startsWith(QByteArray(journalName) + suffuseLineEnds))
            return fileError(m_fileName, FileMessages::tr("is not a journal of Suffuse"));
        m_content.wholeBytes = suffuseSignatureSize;
        if (const Result<void> begun = readBeginning(); !begun)
            return Error{begun.error()};
        for (auto chunk = nextChunk(); chunk && take(*chunk); chunk = nextChunk())
            m_content.wholeBytes = chunk->start + chunk->size();
        return finished();
    }

private:
    std::optional<Chunk> nextChunk() const
    {
        const qsizetype at = m_content.wholeBytes, left = m_bytes.size() - at;
        if (left < 12)
            return std::nullopt;
        ByteCursor cursor(QByteArrayView(m_bytes).sliced(at));
        Chunk chunk{cursor.take(4).toByteArray(), at, {}};
        const std::uint32_t length = cursor.u32();
        chunk.payload = cursor.take(length);
        const std::uint32_t crc = cursor.u32();
        if (!cursor.ok() || crc != crc32c(m_bytes.constData() + at, std::size_t(length) + 8))
            return std::nullopt;
        return chunk;
    }

    Result<void> readBeginning()
    {
        const auto head = nextChunk();
        const auto map = head && head->type == "HEAD" ? mapIn(head->payload) : std::nullopt;
        if (!map)
            return fileError(m_fileName, FileMessages::tr("ends before its first painting was written"));
        if (integerIn(map->value(QLatin1String("reader")), 0) > journalVersion)
            return fileError(m_fileName, FileMessages::tr("was written by a newer program (%1); update Suffuse")
                                             .arg(map->value(QLatin1String("program")).toString()));
        m_content.wholeBytes += head->size();
        readHead(*map);
        const auto base = nextChunk();
        if (!base || base->type != "BASE")
            return fileError(m_fileName, FileMessages::tr("ends before its first painting was written"));
        Result<Painting> painting = readSuffuseFile(base->payload.toByteArray(), m_fileName);
        if (!painting)
            return Error{painting.error()};
        m_content.painting = std::move(*painting);
        m_content.wholeBytes += base->size();
        for (const StrokePtr &stroke : m_content.painting.strokes) {
            m_order.push_back(stroke->id);
            m_strokes.emplace(stroke->id, stroke);
            m_pictures.addOf(*stroke);
        }
        return {};
    }

    void readHead(const QCborMap &map)
    {
        m_content.head = {map.value(QLatin1String("name")).toString(), map.value(QLatin1String("path")).toString(),
                          map.value(QLatin1String("hash")).toByteArray()};
        if (const double resolution = map.value(QLatin1String("inch")).toDouble(); isResolution(resolution))
            m_content.head.resolution = resolution;
        readMoment(map);
    }
    void readMoment(const QCborMap &map)
    {
        m_content.modified = map.value(QLatin1String("modified")).toBool(true);
        m_content.lastChange = integerIn(map.value(QLatin1String("time")));
    }

    /// Applies a record. Returns false if it makes no sense.
    bool take(const Chunk &chunk)
    {
        if (chunk.type == "IMAG") {
            const auto image = checkedImage(chunk.payload.toByteArray());
            if (image)
                m_images.push_back(*image), m_pictures.add(*image);
            return bool(image);
        }
        const bool known = chunk.type == "EDIT" || chunk.type == "SAVE";
        if (!known) // A chunk whose name begins with a small letter may be skipped.
            return chunk.type.front() >= 'a' && chunk.type.front() <= 'z';
        const auto map = mapIn(chunk.payload);
        if (!map)
            return false;
        if (chunk.type == "SAVE")
            readHead(*map);
        else if (!applyEdit(*map))
            return false;
        return true;
    }

    bool applyEdit(const QCborMap &map)
    {
        std::vector<StrokePtr> strokes;
        const QByteArray packed = map.value(QLatin1String("strokes")).toByteArray();
        if (!packed.isEmpty() && !readStrokes(packed, m_allowance, strokes).isEmpty())
            return false;
        m_pictures.giveTo(strokes);
        OrderDifference places;
        if (!readPlaces(map.value(QLatin1String("places")).toArray(), places))
            return false;
        Ids removed;
        for (const QCborValue &id : map.value(QLatin1String("removed")).toArray())
            removed.insert(StrokeId(integerIn(id)));
        if (!fits(strokes, places, removed) || !readRest(map))
            return false;
        if (onlyOnTop(places, !removed.empty(), m_order.size())) {
            for (const StrokePlace &place : places)
                m_order.push_back(place.stroke);
        } else {
            m_ordering += m_order.size();
            if (m_ordering > JournalEncoder::mostOrdering)
                return false;
            m_order = reordered(m_order, places, [&](StrokeId id) { return removed.contains(id); });
        }
        for (const StrokeId id : removed)
            m_strokes.erase(id);
        for (const StrokePtr &stroke : strokes)
            m_strokes[stroke->id] = stroke;
        readMoment(map);
        ++m_content.edits;
        return true;
    }

    /// Whether the order still names each stroke once.
    bool fits(const std::vector<StrokePtr> &strokes, const OrderDifference &places, const Ids &removed) const
    {
        const auto isThere = [&](StrokeId id) { return m_strokes.contains(id); };
        Ids placed, given;
        for (const StrokePlace &place : places)
            if (removed.contains(place.stroke) || !placed.insert(place.stroke).second)
                return false;
        for (const StrokePtr &stroke : strokes)
            if (removed.contains(stroke->id) || !given.insert(stroke->id).second ||
                !(isThere(stroke->id) || placed.contains(stroke->id)))
                return false;
        const bool onTop = onlyOnTop(places, !removed.empty(), m_order.size());
        return std::all_of(placed.begin(), placed.end(),
                           [&](StrokeId id) {
                               return onTop ? !isThere(id) && given.contains(id) : isThere(id) || given.contains(id);
                           }) &&
               std::all_of(removed.begin(), removed.end(), isThere);
    }

    /// Reads canvas, groups, swatches and underlay, as far as the record has them.
    bool readRest(const QCborMap &map)
    {
        const QCborValue document = map.value(QLatin1String("document"));
        if (!document.isByteArray())
            return true;
        std::vector<EncodedImage> images;
        for (const QCborValue &number : map.value(QLatin1String("images")).toArray()) {
            const qint64 k = integerIn(number, -1);
            if (k < 0 || k >= qint64(m_images.size()))
                return false;
            images.push_back(m_images[std::size_t(k)]);
        }
        Painting rest;
        if (!readProperties(document.toByteArray(), images, rest).isEmpty())
            return false;
        m_content.painting = std::move(rest); // The strokes are kept apart until the end.
        return true;
    }

    static bool readPlaces(const QCborArray &list, OrderDifference &places)
    {
        for (qsizetype i = 0; i + 1 < list.size(); i += 2) {
            const qint64 index = integerIn(list.at(i), -1);
            if (index < 0 || index > 0xffffffffll || (!places.empty() && index <= places.back().index))
                return false;
            places.push_back({std::uint32_t(index), StrokeId(integerIn(list.at(i + 1)))});
        }
        return list.size() % 2 == 0;
    }

    Result<JournalContent> finished()
    {
        StrokeList &strokes = m_content.painting.strokes;
        strokes.clear();
        for (const StrokeId id : m_order)
            strokes.push_back(m_strokes[id]);
        if (const QString problem = problemOf(m_content.painting); !problem.isEmpty())
            return fileError(m_fileName, problem);
        return std::move(m_content);
    }

    const QByteArray &m_bytes;
    QString m_fileName;
    JournalContent m_content;
    Allowance m_allowance;
    std::vector<EncodedImage> m_images;
    ImagesByHash m_pictures; ///< the images that pictures may have
    std::vector<StrokeId> m_order;
    std::unordered_map<StrokeId, StrokePtr> m_strokes;
    std::uint64_t m_ordering = 0;
};

} // namespace

Result<JournalContent> readJournal(const QByteArray &bytes, const QString &fileName)
{
    return JournalReader(bytes, fileName).read();
}

} // namespace suffuse

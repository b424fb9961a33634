// docs/file-format.md: the order of chunks, and what a reader does with each.
#include "model/formats/embedded_image.h"
#include "model/formats/files.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse_strokes.h"
#include "model/validate.h"

#include <QCborMap>
#include <QCryptographicHash>

namespace suffuse {

namespace {

struct Totals {
    std::uint64_t segments = 0;
    std::uint64_t rewets = 0;
};

Totals totalsOf(const Painting &painting)
{
    Totals t;
    for (const StrokePtr &stroke : painting.strokes) {
        t.segments += stroke->segments.size();
        for (const Segment &s : stroke->segments)
            t.rewets += s.rewet.size();
    }
    return t;
}

QByteArray header(const Painting &painting, const Totals &totals)
{
    const QCborMap map{{QLatin1String("version"), suffuseVersion},
                       {QLatin1String("reader"), suffuseLeastReader},
                       {QLatin1String("program"), QStringLiteral("Suffuse " SUFFUSE_VERSION)},
                       {QLatin1String("strokes"), qint64(painting.strokes.size())},
                       {QLatin1String("segments"), qint64(totals.segments)}};
    return QCborValue(map).toCbor();
}

class FileReader {
public:
    FileReader(const QByteArray &bytes, const QString &fileName) : m_bytes(bytes), m_fileName(fileName)
    {
        m_allowance.segments = m_allowance.rewets = freeElements + std::uint64_t(bytes.size());
    }

    Result<Painting> read()
    {
        auto chunks = splitChunks(m_bytes, m_fileName);
        if (!chunks)
            return Error{chunks.error()};
        m_chunks = std::move(*chunks);
        for (std::size_t k = 0; k < m_chunks.size(); ++k) {
            if (const auto good = readChunk(k); !good)
                return Error{good.error()};
        }
        return whole();
    }

private:
    Result<void> readChunk(std::size_t k)
    {
        const Chunk &chunk = m_chunks[k];
        const auto wrong = [&](const QString &what) {
            return what.isEmpty() ? Result<void>() : chunkError(m_fileName, chunk, what);
        };
        if ((k == 0) != (chunk.type == "HEAD"))
            return wrong(k == 0 ? FileMessages::tr("the first chunk must be HEAD")
                                : FileMessages::tr("there is more than one HEAD"));
        if (chunk.type == "HEAD")
            return readHeader(chunk);
        if (chunk.type == "IMAG")
            return wrong(readImage(chunk));
        if (chunk.type == "DOCU") {
            if (m_hasDocument)
                return wrong(FileMessages::tr("there is more than one"));
            m_hasDocument = true;
            return wrong(readDocument(chunk.payload, m_images, m_painting));
        }
        if (chunk.type == "STRK")
            return wrong(readStrokes(chunk.payload, m_allowance, m_painting.strokes));
        // Chunks with a small first letter may be skipped.
        if (chunk.type != "ENDS" && !(chunk.type.front() >= 'a' && chunk.type.front() <= 'z'))
            return fileError(
                m_fileName,
                FileMessages::tr("chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse")
                    .arg(excerpt({chunk.type.constData(), 4}))
                    .arg(chunk.start));
        return {};
    }

    Result<void> readHeader(const Chunk &chunk)
    {
        QCborParserError problem;
        const QCborValue value = QCborValue::fromCbor(chunk.payload.data(), chunk.payload.size(), &problem);
        if (problem.error != QCborError::NoError || !value.isMap())
            return chunkError(m_fileName, chunk, FileMessages::tr("is not a CBOR map"));
        const QCborMap map = value.toMap();
        const qint64 reader = map.value(QLatin1String("reader")).toInteger(-1);
        m_strokes = map.value(QLatin1String("strokes")).toInteger(-1);
        m_segments = map.value(QLatin1String("segments")).toInteger(-1);
        if (reader < 1 || m_strokes < 0 || m_segments < 0)
            return chunkError(m_fileName, chunk, FileMessages::tr("lacks the version or the counts"));
        if (reader > suffuseVersion)
            return fileError(m_fileName,
                             FileMessages::tr("was written by a newer program (%1): it needs a reader of version %2, "
                                              "this one is %3; update Suffuse")
                                 .arg(map.value(QLatin1String("program")).toString())
                                 .arg(reader)
                                 .arg(suffuseVersion));
        return {};
    }

    QString readImage(const Chunk &chunk)
    {
        const auto image = checkedImage(chunk.payload.toByteArray());
        if (!image)
            return image.error();
        m_images.push_back(*image);
        return {};
    }

    Result<Painting> whole()
    {
        if (!m_hasDocument)
            return fileError(m_fileName,
                             FileMessages::tr("the chunk DOCU is missing; the file is damaged, take a backup copy"));
        if (m_strokes != qint64(m_painting.strokes.size()) || m_segments != qint64(m_painting.segmentCount()))
            return fileError(
                m_fileName, FileMessages::tr("should hold %1 strokes and %2 segments, but holds %3 and %4; the file is "
                                             "damaged, take a backup copy")
                                .arg(m_strokes)
                                .arg(m_segments)
                                .arg(m_painting.strokes.size())
                                .arg(m_painting.segmentCount()));
        if (const QString problem = problemOf(m_painting); !problem.isEmpty())
            return fileError(m_fileName, problem);
        return std::move(m_painting);
    }

    const QByteArray &m_bytes;
    QString m_fileName;
    std::vector<Chunk> m_chunks;
    std::vector<EncodedImage> m_images;
    Allowance m_allowance;
    Painting m_painting;
    bool m_hasDocument = false;
    qint64 m_strokes = 0, m_segments = 0;
};

} // namespace

QByteArray writeSuffuseFile(const Painting &painting)
{
    const Totals totals = totalsOf(painting);
    Density density{totals.segments > freeElements, totals.rewets > freeElements, blockBudget};
    std::vector<EncodedImage> images;
    const QByteArray document = writeDocument(painting, images);
    QByteArray out = QByteArray(suffuseName) + suffuseLineEnds;
    appendChunk(out, "HEAD", header(painting, totals));
    for (const EncodedImage &image : images)
        appendChunk(out, "IMAG", *image);
    appendChunk(out, "DOCU", document);
    const std::vector<StrokePtr> all(painting.strokes.begin(), painting.strokes.end());
    const std::span<const StrokePtr> strokes(all);
    for (std::size_t from = 0; from < strokes.size();) {
        std::size_t to = from;
        for (std::size_t segments = 0; to < strokes.size() && segments < segmentsPerChunk; ++to)
            segments += strokes[to]->segments.size();
        appendChunk(out, "STRK", writeStrokes(strokes.subspan(from, to - from), density));
        from = to;
    }
    appendChunk(out, "ENDS", QCryptographicHash::hash(out, QCryptographicHash::Sha256));
    return out;
}

Result<Painting> readSuffuseFile(const QByteArray &bytes, const QString &fileName)
{
    return FileReader(bytes, fileName).read();
}

} // namespace suffuse

// docs/file-format.md: what a reader does with each chunk, and with a file that is not whole.
#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/formats/suffuse/suffuse_extras.h"
#include "model/formats/suffuse/suffuse_strokes.h"
#include "model/painting/validate.h"
#include "model/parallel.h"

#include <QCborMap>

#include <algorithm>

namespace suffuse {

namespace {

/// the paper's image and the underlay's
constexpr std::size_t mostImages = 2;

class FileReader {
public:
    FileReader(const QByteArray &bytes, const QString &fileName, bool salvages)
        : m_fileName(fileName), m_salvages(salvages),
          m_allowance(freeElements + std::uint64_t(bytes.size()), blockBudget)
    {}

    Result<LoadedDocument> read(const std::vector<FilePiece> &pieces)
    {
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const Chunk &chunk = pieces[k].chunk;
            if (pieces[k].isSignature()) {
                noteSignature(pieces[k].damage, k + 1 < pieces.size() ? pieces[k + 1].chunk.type : QByteArray());
                continue;
            }
            const QString problem = pieces[k].damage.isEmpty() ? readChunk(chunk, k == 0) : pieces[k].damage;
            if (!m_refusal.isEmpty())
                return fileError(m_fileName, m_refusal);
            if (problem.isEmpty())
                continue;
            if (!m_salvages)
                return chunkError(m_fileName, chunk, problem);
            noteDamage(chunk, problem);
        }
        if (const Result<void> decoded = readStrokeChunks(); !decoded)
            return Error{decoded.error()};
        if (const Result<void> sound = m_salvages ? mend() : checkTotals(); !sound)
            return Error{sound.error()};
        if (const QString problem = problemOf(m_out.painting); !problem.isEmpty())
            return fileError(m_fileName, problem);
        forgetLostCurves(m_out.painting);
        m_out.format = FileFormat::Suffuse;
        return std::move(m_out);
    }

private:
    void lose(const QString &what) { m_out.losses.push_back(what); }

    /// Notes damage that later steps cannot find out. What is lost by it is said once all is read (`mend`).
    void noteDamage(const Chunk &chunk, const QString &problem)
    {
        if (m_firstDamage.isEmpty())
            m_firstDamage = chunk.type.isEmpty() ? FileMessages::tr("byte %1: %2").arg(chunk.start).arg(problem)
                                                 : chunkText(chunk, problem);
        if (const QString part = partBeside(chunk.type); !part.isEmpty()) {
            if (!m_leftOut.contains(part))
                m_leftOut.append(part);
            return;
        }
        m_pictureIsHurt = true;
        if (chunk.type == "IMAG")
            m_images.push_back(nullptr);
        if (chunk.type == "ENDS")
            lose(FileMessages::tr("the end of the file is damaged"));
        if (chunk.type.isEmpty()) {
            m_missedUnknown = true;
            lose(FileMessages::tr("the file is damaged or cut off at byte %1").arg(chunk.start));
        }
    }

    /// Notes a damaged signature, which has nothing of the painting. If HEAD does not follow it, more than that is
    /// lost.
    void noteSignature(const QString &problem, const QByteArray &next)
    {
        m_firstDamage = problem;
        if (next == "HEAD") {
            m_leftOut.append(FileMessages::tr("the first bytes of the file"));
            return;
        }
        m_pictureIsHurt = m_missedUnknown = true;
        lose(FileMessages::tr("the file is damaged or cut off at byte %1").arg(0));
    }

    /// Reads a chunk. Returns an empty text, or what is wrong with it.
    QString readChunk(const Chunk &chunk, bool isFirst)
    {
        if (isFirst != (chunk.type == "HEAD")) {
            if (!m_salvages)
                return isFirst ? FileMessages::tr("the first chunk must be HEAD")
                               : FileMessages::tr("there is more than one HEAD");
            if (chunk.type == "HEAD" && m_strokes >= 0)
                return FileMessages::tr("there is more than one HEAD");
        }
        if (chunk.type == "HEAD")
            return readHeader(chunk);
        if (chunk.type == "IMAG")
            return readImage(chunk);
        if (chunk.type == "DOCU")
            return readDocumentChunk(chunk);
        if (chunk.type == "STRK")
            m_strokeChunks.push_back(chunk);
        else if (isAncillary(chunk))
            readExtra(chunk, m_out.extras);
        else if (chunk.type != "ENDS")
            m_refusal = FileMessages::tr("chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse")
                            .arg(excerpt({chunk.type.constData(), 4}))
                            .arg(chunk.start);
        return {};
    }

    QString readHeader(const Chunk &chunk)
    {
        QCborParserError problem;
        const QCborValue value = QCborValue::fromCbor(chunk.payload.data(), chunk.payload.size(), &problem);
        if (problem.error != QCborError::NoError || !value.isMap())
            return FileMessages::tr("is not a CBOR map");
        const QCborMap map = value.toMap();
        const qint64 reader = integerIn(map.value(QLatin1String("reader")), -1);
        const qint64 strokes = integerIn(map.value(QLatin1String("strokes")), -1);
        const qint64 segments = integerIn(map.value(QLatin1String("segments")), -1);
        if (reader < 1 || strokes < 0 || segments < 0)
            return FileMessages::tr("lacks the version or the counts");
        if (reader > suffuseVersion)
            m_refusal = FileMessages::tr("was written by a newer program (%1): it needs a reader of version %2, "
                                         "this one is %3; update Suffuse")
                            .arg(map.value(QLatin1String("program")).toString())
                            .arg(reader)
                            .arg(suffuseVersion);
        m_strokes = strokes;
        m_segments = segments;
        return {};
    }

    QString readImage(const Chunk &chunk)
    {
        const auto image = checkedImage(chunk.payload.toByteArray());
        if (!image)
            return image.error();
        m_images.push_back(*image);
        m_imagesByHash.add(*image);
        return {};
    }

    QString readDocumentChunk(const Chunk &chunk)
    {
        if (m_hasDocument)
            return FileMessages::tr("there is more than one");
        if (m_salvages) {
            // Without the right number an image could be taken for another one.
            if (m_missedUnknown)
                m_images.clear();
            m_images.resize(std::max(m_images.size(), mostImages));
        }
        Painting properties;
        const QString problem = readProperties(chunk.payload, m_images, properties);
        if (!problem.isEmpty())
            return problem;
        m_hasDocument = true;
        m_out.painting = std::move(properties);
        return {};
    }

    /// Reads the chunks of strokes at the same time, since each stands alone.
    Result<void> readStrokeChunks()
    {
        std::vector<std::vector<StrokePtr>> strokes(m_strokeChunks.size());
        std::vector<QString> problems(m_strokeChunks.size());
        forEachInParallel(m_strokeChunks.size(), [&](std::size_t k) {
            problems[k] = readStrokes(m_strokeChunks[k].payload, m_allowance, strokes[k]);
        });
        for (std::size_t k = 0; k < strokes.size(); ++k) {
            if (problems[k].isEmpty()) {
                m_lostPictures += m_imagesByHash.giveTo(strokes[k]);
                for (StrokePtr &stroke : strokes[k])
                    m_out.painting.strokes.push_back(std::move(stroke));
            } else if (m_salvages) {
                noteDamage(m_strokeChunks[k], problems[k]);
            } else {
                return chunkError(m_fileName, m_strokeChunks[k], problems[k]);
            }
        }
        return {};
    }

    Result<void> checkTotals()
    {
        const Painting &painting = m_out.painting;
        if (!m_hasDocument)
            return fileError(m_fileName,
                             FileMessages::tr("the chunk DOCU is missing; the file is damaged, take a backup copy"));
        if (m_strokes == qint64(painting.strokes.size()) && m_segments == qint64(painting.segmentCount()))
            return {};
        return fileError(m_fileName,
                         FileMessages::tr("should hold %1 strokes and %2 segments, but holds %3 and %4; the file is "
                                          "damaged, take a backup copy")
                             .arg(m_strokes)
                             .arg(m_segments)
                             .arg(painting.strokes.size())
                             .arg(painting.segmentCount()));
    }

    /// Makes a painting of what is left, and says what is missing. It fails if nothing is left.
    Result<void> mend()
    {
        Painting &painting = m_out.painting;
        if (!m_hasDocument && painting.strokes.empty())
            return fileError(
                m_fileName,
                FileMessages::tr("is damaged, and nothing in it is whole (%1); take a backup copy").arg(m_firstDamage));
        if (!m_hasDocument) {
            lose(FileMessages::tr(
                "the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one"));
            leaveGroups();
        }
        if (painting.canvas.paper.kind == PaperKind::Image && !painting.canvas.paper.image) {
            painting.canvas.paper.kind = PaperKind::None;
            lose(FileMessages::tr("the image of the paper is missing; there is no paper now"));
        }
        if (painting.underlay && !painting.underlay->image) {
            painting.underlay.reset();
            lose(FileMessages::tr("the underlay is missing"));
        }
        if (m_lostPictures > 0)
            lose(FileMessages::tr("the images of %n image layer(s) are missing", nullptr, int(m_lostPictures)));
        const qint64 strokes = qint64(painting.strokes.size()), segments = qint64(painting.segmentCount());
        const bool allStrokes = m_strokes == strokes && m_segments == segments;
        m_out.lostStrokes = std::max<qint64>(0, m_strokes - strokes);
        const QString beside = m_leftOut.join(QStringLiteral(", "));
        if (allStrokes && !m_pictureIsHurt && m_out.losses.empty()) {
            m_out.leftOut =
                FileMessages::tr("Damaged and left out: %1. All %2 strokes are here.").arg(beside).arg(strokes);
            return {};
        }
        if (!beside.isEmpty())
            lose(FileMessages::tr("damaged and left out: %1").arg(beside));
        if (m_strokes < 0)
            lose(FileMessages::tr("%1 strokes with %2 segments are here; how many there were is not known")
                     .arg(strokes)
                     .arg(segments));
        else if (!allStrokes)
            lose(FileMessages::tr("%1 of %2 strokes are missing, with %3 of %4 segments")
                     .arg(m_strokes - strokes)
                     .arg(m_strokes)
                     .arg(m_segments - segments)
                     .arg(m_segments));
        else if (m_hasDocument)
            lose(FileMessages::tr("all %1 strokes are here").arg(strokes));
        return {};
    }

    void leaveGroups()
    {
        std::size_t left = 0;
        for (StrokePtr &stroke : m_out.painting.strokes) {
            if (stroke->group == 0)
                continue;
            auto alone = std::make_shared<Stroke>(*stroke);
            alone->group = 0;
            stroke = std::move(alone);
            ++left;
        }
        if (left > 0)
            lose(FileMessages::tr("%1 strokes are in no group any more").arg(left));
    }

    const QString m_fileName;
    const bool m_salvages;
    Allowance m_allowance;
    LoadedDocument m_out;
    std::vector<EncodedImage> m_images; ///< null where an image is missing
    ImagesByHash m_imagesByHash;
    std::vector<Chunk> m_strokeChunks;
    QStringList m_leftOut; ///< the damaged parts besides the picture
    QString m_firstDamage;
    QString m_refusal; ///< why a newer file, which is not a damaged one, is refused
    bool m_pictureIsHurt = false;
    bool m_hasDocument = false;
    bool m_missedUnknown = false;   ///< whether a part was lost that may have been anything
    std::size_t m_lostPictures = 0; ///< whose images are missing
    qint64 m_strokes = -1, m_segments = -1;
};

} // namespace

Result<LoadedDocument> readSuffuseDocument(const QByteArray &bytes, const QString &fileName)
{
    const std::vector<FilePiece> pieces = salvageChunks(bytes);
    const bool damaged =
        std::any_of(pieces.begin(), pieces.end(), [](const FilePiece &p) { return !p.damage.isEmpty(); });
    return FileReader(bytes, fileName, damaged).read(pieces);
}

Result<Painting> readSuffuseFile(const QByteArray &bytes, const QString &fileName, double *resolution)
{
    const auto chunks = splitChunks(bytes, fileName);
    if (!chunks)
        return Error{chunks.error()};
    std::vector<FilePiece> pieces;
    for (const Chunk &chunk : *chunks)
        pieces.push_back({chunk, {}});
    Result<LoadedDocument> document = FileReader(bytes, fileName, false).read(pieces);
    if (!document)
        return Error{document.error()};
    if (resolution)
        *resolution = document->extras.resolution;
    return std::move(document->painting);
}

} // namespace suffuse

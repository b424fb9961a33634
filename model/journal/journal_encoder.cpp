#include "model/formats/files.h"
#include "model/formats/suffuse/suffuse_strokes.h"
#include "model/journal/journal_format.h"
#include "model/journal/journal_layout.h"
#include "model/painting/resolution.h"

#include <QCborArray>
#include <QCborMap>

#include <algorithm>

namespace suffuse {

namespace {

QCborMap toCbor(const JournalHead &head, bool modified, qint64 now)
{
    QCborMap map{{QLatin1String("name"), head.name},
                 {QLatin1String("path"), head.path},
                 {QLatin1String("hash"), head.fileHash},
                 {QLatin1String("modified"), modified},
                 {QLatin1String("time"), now}};
    if (isResolution(head.resolution))
        map.insert(QLatin1String("inch"), head.resolution);
    return map;
}

QCborArray toCbor(const OrderDifference &places)
{
    QCborArray list;
    for (const StrokePlace &place : places) {
        list.append(qint64(place.index));
        list.append(qint64(place.stroke));
    }
    return list;
}

} // namespace

QByteArray JournalEncoder::begin(const JournalHead &head, PaintingPtr painting, bool modified, qint64 now)
{
    QCborMap map = toCbor(head, modified, now);
    map.insert(QLatin1String("version"), journalVersion);
    map.insert(QLatin1String("reader"), journalLeastReader);
    map.insert(QLatin1String("program"), QStringLiteral("Suffuse " SUFFUSE_VERSION));
    QByteArray bytes = QByteArray(journalName) + suffuseLineEnds;
    appendChunk(bytes, "HEAD", QCborValue(map).toCbor());
    appendChunk(bytes, "BASE", writeSuffuseFile(*painting));
    m_next = {};
    for (const StrokePtr &stroke : painting->strokes)
        if (stroke->picture && stroke->picture->image && !stroke->picture->isLinked())
            m_next.pictures.insert(stroke->picture->sha256);
    m_next.painting = std::move(painting);
    m_next.modified = modified;
    m_next.blocks = blockBudget;
    return bytes;
}

QByteArray JournalEncoder::edit(PaintingPtr painting, bool modified, qint64 now)
{
    m_next = m_state;
    const SnapshotDifference difference = snapshotDifference(*m_state.painting, *painting);
    if (difference.isEmpty() && modified == m_state.modified)
        return {};
    QByteArray bytes;
    QCborMap map{{QLatin1String("time"), now}, {QLatin1String("modified"), modified}};
    if (!difference.strokes.empty()) {
        for (const StrokePtr &stroke : difference.strokes) {
            m_next.segments += stroke->segments.size();
            for (const Segment &segment : stroke->segments)
                m_next.rewets += segment.rewet.size();
        }
        Density density{m_next.segments > freeElements, m_next.rewets > freeElements, m_next.blocks};
        map.insert(QLatin1String("strokes"), writeStrokes(difference.strokes, density));
        m_next.blocks = density.blocks;
        bytes += writePictures(difference.strokes);
    }
    if (!difference.removed.empty()) {
        QCborArray removed;
        for (const StrokeId id : difference.removed)
            removed.append(qint64(id));
        map.insert(QLatin1String("removed"), removed);
    }
    if (!difference.places.empty())
        map.insert(QLatin1String("places"), toCbor(difference.places));
    if (!onlyOnTop(difference.places, !difference.removed.empty(), m_state.painting->strokes.size()))
        m_next.ordering += m_state.painting->strokes.size();
    if (difference.rest) {
        std::vector<EncodedImage> images;
        std::vector<qint64> numbers;
        map.insert(QLatin1String("document"), writeProperties(*painting, images));
        bytes += writeImages(images, numbers);
        QCborArray list;
        for (const qint64 number : numbers)
            list.append(number);
        map.insert(QLatin1String("images"), list);
    }
    appendChunk(bytes, "EDIT", QCborValue(map).toCbor());
    m_next.painting = std::move(painting);
    m_next.modified = modified;
    return bytes;
}

/// Writes an image when it is used for the first time.
QByteArray JournalEncoder::writeImages(const std::vector<EncodedImage> &images, std::vector<qint64> &numbers)
{
    QByteArray bytes;
    for (const EncodedImage &image : images) {
        auto at = std::find(m_next.images.begin(), m_next.images.end(), image);
        numbers.push_back(at - m_next.images.begin());
        if (at == m_next.images.end()) {
            appendChunk(bytes, "IMAG", *image);
            m_next.images.push_back(image);
        }
    }
    return bytes;
}

/// Writes the images of pictures that the journal does not have yet.
QByteArray JournalEncoder::writePictures(const std::vector<StrokePtr> &strokes)
{
    QByteArray bytes;
    for (const StrokePtr &stroke : strokes) {
        const SharedPicture &picture = stroke->picture;
        if (!picture || picture->isLinked() || !picture->image || !m_next.pictures.insert(picture->sha256).second)
            continue;
        appendChunk(bytes, "IMAG", *picture->image);
        m_next.images.push_back(picture->image);
    }
    return bytes;
}

QByteArray JournalEncoder::saved(const JournalHead &head, bool modified, qint64 now)
{
    m_next = m_state;
    m_next.modified = modified;
    QByteArray bytes;
    appendChunk(bytes, "SAVE", QCborValue(toCbor(head, modified, now)).toCbor());
    return bytes;
}

void JournalEncoder::kept()
{
    m_state = m_next;
}

} // namespace suffuse

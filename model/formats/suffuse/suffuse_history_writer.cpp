#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_history.h"
#include "model/formats/suffuse/suffuse_history_parts.h"

#include <QCborArray>
#include <QCborMap>

#include <algorithm>
#include <unordered_map>

namespace suffuse {

namespace {

/// The strokes that steps name and the painting does not have.
class StrokeTable {
public:
    explicit StrokeTable(const Painting &painting)
    {
        for (const StrokePtr &stroke : painting.strokes)
            m_own.emplace(stroke->id, stroke);
    }

    void add(const StrokePtr &stroke)
    {
        if (!stroke || isOwn(*stroke) || m_places.contains(stroke.get()))
            return;
        for (const StrokePtr &other : m_states[stroke->id]) {
            if (*other == *stroke) {
                m_same.emplace(stroke.get(), other.get());
                return;
            }
        }
        m_states[stroke->id].push_back(stroke);
        m_places.emplace(stroke.get(), 0);
    }

    /// Numbers the strokes after the last `add`. The states of one stroke stand together, since they resemble each
    /// other.
    void number()
    {
        for (const auto &[id, states] : m_states) {
            for (const StrokePtr &stroke : states) {
                m_places[stroke.get()] = m_stored.size();
                m_stored.push_back(stroke);
            }
        }
    }

    qint64 reference(const StrokePtr &stroke) const
    {
        if (!stroke)
            return AbsentStroke;
        if (isOwn(*stroke))
            return OwnStroke;
        const auto same = m_same.find(stroke.get());
        return FirstStored + qint64(m_places.at(same == m_same.end() ? stroke.get() : same->second));
    }
    const std::vector<StrokePtr> &stored() const { return m_stored; }

private:
    bool isOwn(const Stroke &stroke) const
    {
        const auto own = m_own.find(stroke.id);
        return own != m_own.end() && (own->second.get() == &stroke || *own->second == stroke);
    }

    std::unordered_map<StrokeId, StrokePtr> m_own;
    std::map<StrokeId, std::vector<StrokePtr>> m_states;
    std::unordered_map<const Stroke *, std::size_t> m_places;
    std::unordered_map<const Stroke *, const Stroke *> m_same;
    std::vector<StrokePtr> m_stored;
};

QCborArray selectedStrokes(const Selection &selection)
{
    QCborArray list;
    StrokeId before = 0; // The ids are written as differences, which are small numbers.
    for (const StrokeId id : selection.strokes) {
        list.append(qint64(id - before));
        before = id;
    }
    return list;
}

QCborArray selectedSegments(const Selection &selection)
{
    QCborArray list;
    for (const SegmentRef &ref : selection.segments) {
        list.append(qint64(ref.stroke));
        list.append(ref.segment);
    }
    return list;
}

void insertRest(QCborMap &map, const Edit &edit, std::vector<EncodedImage> &images)
{
    int parts = 0;
    Painting rest;
    const auto take = [&](const auto &part, auto &place, HistoryPart bit) {
        if (!part)
            return;
        parts |= bit;
        place = *part;
    };
    take(edit.canvas, rest.canvas, CanvasPart);
    take(edit.groups, rest.groups, GroupsPart);
    take(edit.swatches, rest.swatches, SwatchesPart);
    take(edit.underlay, rest.underlay, UnderlayPart);
    if (parts == 0)
        return;
    map.insert(QLatin1String("parts"), parts);
    map.insert(QLatin1String("rest"), writeProperties(rest, images));
}

QCborMap stepMap(const HistoryStep &step, const StrokeTable &table, std::vector<EncodedImage> &images,
                 const Selection *&before)
{
    const Edit &edit = step.edit;
    QCborMap map{{QLatin1String("text"), step.text}};
    QCborArray strokes, places;
    for (const auto &[id, stroke] : edit.strokes) {
        strokes.append(qint64(id));
        strokes.append(table.reference(stroke));
    }
    if (!strokes.isEmpty())
        map.insert(QLatin1String("strokes"), strokes);
    if (edit.places) {
        for (const StrokePlace &place : *edit.places) {
            places.append(qint64(place.index));
            places.append(qint64(place.stroke));
        }
        map.insert(QLatin1String("places"), places);
    }
    insertRest(map, edit, images);
    if (edit.selection && !(before && *before == *edit.selection)) {
        map.insert(QLatin1String("selected"), selectedStrokes(*edit.selection));
        if (!edit.selection->segments.empty())
            map.insert(QLatin1String("segments"), selectedSegments(*edit.selection));
        before = &*edit.selection;
    }
    return map;
}

using Steps = std::span<const HistoryStep>;

/// The `count` steps that are nearest to the present one.
Steps nearest(const UndoHistory &history, std::size_t count, std::size_t &done)
{
    const std::size_t all = history.steps.size();
    const std::size_t before = std::min(history.done, count - std::min(all - history.done, count / 2));
    const std::size_t first = history.done - before;
    done = before;
    return Steps(history.steps).subspan(first, std::min(count, all - first));
}

QByteArray encoded(Steps steps, std::size_t done, const Painting &painting)
{
    StrokeTable table(painting);
    for (const HistoryStep &step : steps)
        for (const auto &[id, stroke] : step.edit.strokes)
            table.add(stroke);
    table.number();
    std::vector<EncodedImage> images;
    writeProperties(painting, images);
    const std::size_t own = images.size();
    QCborArray list, newImages;
    const Selection *before = nullptr;
    for (const HistoryStep &step : steps)
        list.append(stepMap(step, table, images, before));
    // Pictures name their images by SHA-256, so these come last, behind those that steps name by number.
    const std::vector<StrokePtr> strokes(painting.strokes.begin(), painting.strokes.end());
    std::vector<EncodedImage> known = imagesOf(strokes), all = known;
    appendNew(all, imagesOf(table.stored()));
    images.insert(images.end(), all.begin() + std::ptrdiff_t(known.size()), all.end());
    for (std::size_t k = own; k < images.size(); ++k)
        newImages.append(*images[k]);
    const QCborMap map{{QLatin1String("painting"), hashOf(painting)},
                       {QLatin1String("done"), qint64(done)},
                       {QLatin1String("steps"), list},
                       {QLatin1String("images"), newImages}};
    return packHistory(table.stored(), QCborValue(map).toCbor());
}

} // namespace

QByteArray writeHistory(const UndoHistory &history, const Painting &painting)
{
    for (std::size_t count = std::min(history.steps.size(), mostHistorySteps); count > 0; count /= 2) {
        std::size_t done = 0;
        const Steps steps = nearest(history, count, done);
        if (QByteArray bytes = encoded(steps, done, painting); !bytes.isEmpty())
            return bytes;
    }
    return {};
}

} // namespace suffuse

#include "model/document/document.h"
#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/formats/suffuse/suffuse_history.h"
#include "model/formats/suffuse/suffuse_history_parts.h"
#include "model/painting/validate.h"

#include <unordered_set>

namespace suffuse {

namespace {

/// Makes steps of values. Whether the steps fit is tried afterwards.
class HistoryReader {
public:
    explicit HistoryReader(const Painting &painting) : m_painting(painting)
    {
        for (const StrokePtr &stroke : painting.strokes)
            m_own.emplace(stroke->id, stroke);
        writeProperties(painting, m_images); // only the images are needed
    }

    QString read(const QByteArray &bytes, UndoHistory &history)
    {
        QByteArray cbor;
        if (!unpackHistory(bytes, m_stored, cbor))
            return FileMessages::tr("it is damaged");
        for (const StrokePtr &stroke : m_stored)
            if (const QString problem = problemOf(*stroke); !problem.isEmpty())
                return problem;
        QCborParserError parsed; // CBOR that is not whole must not be looked into.
        const QCborValue value = QCborValue::fromCbor(cbor, &parsed);
        if (parsed.error != QCborError::NoError)
            return FileMessages::tr("it is damaged");
        bool ok = true;
        MapReader map(value, ok);
        if (!ok || map.take("painting").toByteArray() != hashOf(m_painting))
            return FileMessages::tr("it belongs to another painting");
        for (const QCborValue &item : map.take("images").toArray()) {
            const auto image = checkedImage(item.toByteArray());
            if (!image)
                return image.error();
            m_images.push_back(*image);
        }
        ImagesByHash images;
        for (const StrokePtr &stroke : m_painting.strokes)
            images.addOf(*stroke);
        for (const EncodedImage &image : m_images)
            images.add(image);
        images.giveTo(m_stored);
        const QCborArray steps = map.take("steps").toArray();
        history.done = std::size_t(std::max<qint64>(0, integerIn(map.take("done"))));
        if (steps.size() > qsizetype(mostHistorySteps) || history.done > std::size_t(steps.size()))
            return FileMessages::tr("it has too many steps");
        for (const QCborValue &item : steps)
            if (const QString problem = readStep(item, history); !problem.isEmpty())
                return problem;
        return {};
    }

private:
    QString readStep(const QCborValue &item, UndoHistory &history)
    {
        bool ok = true;
        HistoryStep step;
        MapReader map(item, ok);
        map.read("text", step.text);
        ok = readStrokeStates(map.take("strokes").toArray(), step.edit) && ok;
        if (const QCborValue places = map.take("places"); places.isArray())
            ok = readPlaces(places.toArray(), step.edit) && ok;
        ok = readSelection(map.take("selected"), map.take("segments").toArray()) && ok;
        step.edit.selection = m_selection;
        const QString problem = readRest(map, step.edit);
        history.steps.push_back(std::move(step));
        return ok ? problem : FileMessages::tr("step %1 is damaged").arg(history.steps.size());
    }

    bool readStrokeStates(const QCborArray &list, Edit &edit)
    {
        for (qsizetype k = 0; k + 1 < list.size(); k += 2) {
            const auto id = StrokeId(integerIn(list.at(k)));
            const qint64 reference = integerIn(list.at(k + 1), -1);
            StrokePtr stroke;
            if (reference == OwnStroke) {
                const auto own = m_own.find(id);
                stroke = own == m_own.end() ? nullptr : own->second;
            } else if (reference >= FirstStored && std::size_t(reference - FirstStored) < m_stored.size()) {
                stroke = m_stored[std::size_t(reference - FirstStored)];
            }
            if (reference < 0 || (reference != AbsentStroke && (!stroke || stroke->id != id)))
                return false;
            edit.strokes[id] = std::move(stroke);
        }
        return list.size() % 2 == 0;
    }

    static bool readPlaces(const QCborArray &list, Edit &edit)
    {
        edit.places.emplace();
        for (qsizetype k = 0; k + 1 < list.size(); k += 2) {
            const qint64 index = integerIn(list.at(k), -1);
            if (index < 0 || index > 0xffffffffLL)
                return false;
            edit.places->push_back({std::uint32_t(index), StrokeId(integerIn(list.at(k + 1)))});
        }
        return list.size() % 2 == 0;
    }

    /// Reads a selection. If it is absent, it is that of the step before.
    bool readSelection(const QCborValue &selected, const QCborArray &segments)
    {
        if (!selected.isArray())
            return selected.isUndefined();
        m_selection = {};
        StrokeId id = 0;
        for (const QCborValue &step : selected.toArray())
            m_selection.strokes.insert(id += StrokeId(integerIn(step)));
        for (qsizetype k = 0; k + 1 < segments.size(); k += 2)
            m_selection.segments.insert({StrokeId(integerIn(segments.at(k))),
                                         int(std::clamp<qint64>(integerIn(segments.at(k + 1)), -1, 1 << 30))});
        return true;
    }

    QString readRest(const MapReader &map, Edit &edit) const
    {
        const qint64 parts = integerIn(map.take("parts"));
        if (parts == 0)
            return {};
        Painting rest;
        const QByteArray bytes = map.take("rest").toByteArray();
        if (const QString problem = readProperties(bytes, m_images, rest); !problem.isEmpty())
            return problem;
        if (const QString problem = problemOf(rest); !problem.isEmpty())
            return problem;
        if (parts & CanvasPart)
            edit.canvas = rest.canvas;
        if (parts & GroupsPart)
            edit.groups = rest.groups;
        if (parts & SwatchesPart)
            edit.swatches = rest.swatches;
        if (parts & UnderlayPart)
            edit.underlay = rest.underlay;
        return {};
    }

    const Painting &m_painting;
    std::unordered_map<StrokeId, StrokePtr> m_own;
    std::vector<StrokePtr> m_stored;
    std::vector<EncodedImage> m_images;
    Selection m_selection;
};

/// Walks through the steps on a document of its own.
class Trial {
public:
    explicit Trial(const Painting &painting)
    {
        m_document.reset(std::make_shared<const Painting>(painting));
        for (const StrokePtr &stroke : painting.strokes)
            m_present.insert(stroke->id);
    }

    /// Exchanges an edit. Returns false if the step does not fit the present painting, or does not lead to a valid one.
    bool exchange(Edit edit)
    {
        // Steps of earlier versions also name strokes that came and went within the step.
        std::erase_if(edit.strokes,
                      [&](const auto &entry) { return !entry.second && !m_present.contains(entry.first); });
        if (!(edit.places ? placesFit(edit) : statesFit(edit)))
            return false;
        for (const auto &[id, stroke] : edit.strokes) {
            if (stroke)
                m_present.insert(id);
            else
                m_present.erase(id);
        }
        m_document.exchange(edit);
        return problemOfMembership(*m_document.painting()).isEmpty();
    }

private:
    /// Whether the edit neither adds nor removes strokes.
    bool statesFit(const Edit &edit) const
    {
        return std::all_of(edit.strokes.begin(), edit.strokes.end(),
                           [&](const auto &entry) { return entry.second && m_present.contains(entry.first); });
    }

    /// Whether the order has exactly the strokes that exist then. Those that the places do not name keep their order.
    bool placesFit(const Edit &edit) const
    {
        std::unordered_set<StrokeId> placed;
        for (const StrokePlace &place : *edit.places) {
            const auto it = edit.strokes.find(place.stroke);
            const bool there = it == edit.strokes.end() ? m_present.contains(place.stroke) : bool(it->second);
            if (!there || !placed.insert(place.stroke).second)
                return false;
        }
        return std::all_of(edit.strokes.begin(), edit.strokes.end(), [&](const auto &entry) {
            return m_present.contains(entry.first) || (entry.second && placed.contains(entry.first));
        });
    }

    Document m_document;
    std::unordered_set<StrokeId> m_present;
};

QString problemOf(const UndoHistory &history, const Painting &painting)
{
    const auto notFitting = [](std::size_t k) {
        return FileMessages::tr("step %1 does not fit the painting").arg(k + 1);
    };
    Trial back(painting), on(painting);
    for (std::size_t k = history.done; k-- > 0;)
        if (!back.exchange(history.steps[k].edit))
            return notFitting(k);
    for (std::size_t k = history.done; k < history.steps.size(); ++k)
        if (!on.exchange(history.steps[k].edit))
            return notFitting(k);
    return {};
}

} // namespace

Result<UndoHistory> readHistory(const QByteArray &bytes, const Painting &painting)
{
    UndoHistory history;
    QString problem = HistoryReader(painting).read(bytes, history);
    if (problem.isEmpty())
        problem = problemOf(history, painting);
    if (!problem.isEmpty())
        return Error{FileMessages::tr("the undo history was left out: %1").arg(problem)};
    return history;
}

} // namespace suffuse

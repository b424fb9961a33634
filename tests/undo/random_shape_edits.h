// Random edits of nodes, shapes and groups for the tests of undo.
#pragma once

#include "model/shaping/erasing/erase.h"
#include "model/shaping/erasing/fill_cut.h"
#include "tests/model/awkward_strokes.h"
#include "tests/undo/random_edits.h"
#include "undo/area_edits.h"
#include "undo/colour_edits.h"
#include "undo/fill_edits.h"
#include "undo/layers/group_edits.h"
#include "undo/node_edits.h"
#include "undo/transform_edits.h"

namespace suffuse::test {

inline PaintingPtr awkwardPainting(AwkwardStrokes &random, int strokes)
{
    auto p = std::make_shared<Painting>();
    for (int i = 1; i <= strokes; ++i) {
        const int segments = 1 + random.below(6);
        auto s = std::make_shared<Stroke>(random.below(3) ? random.stroke(segments) : random.chains(segments));
        s->id = StrokeId(i);
        p->strokes.push_back(s);
    }
    return p;
}

/// One of all the edits that shape; may be empty.
class ShapeEdits {
public:
    ShapeEdits(Document &document, unsigned seed) : m_document(document), m_random(seed), m_others(document, seed) {}

    Edit next()
    {
        if (m_random.below(3) == 0)
            selectSome();
        switch (m_random.below(29)) {
        case 0:
            return insertNodes(m_document, places());
        case 1:
            return deleteNodes(m_document, nodes(4));
        case 2:
            return bridgeSegments(m_document, m_document.selection().segments);
        case 3:
            return moveNodes(m_document, nodes(3), m_random.point(20));
        case 4:
            return setNodeKind(m_document, nodes(4), NodeKind(m_random.below(3)));
        case 5:
            return splitAt(m_document, places(), leaves());
        case 6:
            return splitAtNodes(m_document, nodes(3), leaves());
        case 7:
            return eraseAlong(m_document, m_random.below(2) ? m_document.selection().strokes : allIds(),
                              {m_random.point(300), m_random.point(300)}, m_random.real(0, 30),
                              std::numeric_limits<Microseconds>::max(), leaves());
        case 8:
            return joinNodes(m_document, endNode(), endNode());
        case 9:
            return joinSelection(m_document);
        case 10:
            return reverseSelection(m_document);
        case 11:
            return extendStroke(m_document, endNode(), m_random.stroke(2));
        case 12: {
            const double k = std::exp(m_random.real(-0.3, 0.3));
            const Point fixed = m_random.point(200);
            return transformSelection(m_document,
                                      m_random.below(2) ? Affine::scaling(fixed, k, -k)
                                                        : Affine::about(fixed, k, m_random.real(-0.2, 0.2), 0, 1 / k),
                                      SpreadRule(m_random.below(8) != 0));
        }
        case 13:
            return align(m_document, Align(m_random.below(6)), AlignTo(m_random.below(4)), anyId());
        case 14:
            return distribute(m_document, Axis(m_random.below(2)), Spacing(m_random.below(2)));
        case 15:
            return groupSelection(m_document, QStringLiteral("group"));
        case 16:
            return m_random.below(2) ? ungroupSelection(m_document) : ungroup(m_document, anyGroup());
        case 17:
            return m_random.below(2) ? setLocked(m_document, m_document.selection().strokes, m_random.below(2))
                                     : setVisible(m_document, m_document.selection().strokes, m_random.below(2));
        case 18:
            return m_random.below(2) ? setGroupLocked(m_document, anyGroup(), m_random.below(3) == 0)
                                     : setGroupVisible(m_document, anyGroup(), m_random.below(2));
        case 19:
            return m_random.below(2) ? unlockAll(m_document) : showAll(m_document);
        case 20: {
            const QString name = QString::number(m_random.below(100));
            return m_random.below(2) ? renameStroke(m_document, anyId(), name)
                                     : renameGroup(m_document, anyGroup(), name);
        }
        case 21:
            return combineSelection(m_document);
        case 22:
            return breakApart(m_document);
        case 23:
            return removeErasures(m_document);
        case 24:
            return fills();
        case 25: {
            const Point a = m_random.point(300), b = m_random.point(300);
            PlacesOfStrokes places;
            for (const StrokePtr &stroke : m_document.painting()->strokes)
                places[stroke->id] = stroke->fill ? filledCutPlaces(*stroke, a, b) : crossings(*stroke, a, b);
            return cutAlong(m_document, places, a, b);
        }
        case 26:
            return recolour(m_document, partsToColour(*m_document.painting(), m_document.selection()),
                            [this](const Colour &each) {
                                return Colour{float(m_random.real(0, 1)), each.blue, each.red, each.opacity};
                            });
        case 27:
            return m_random.below(4) ? combineAreas(m_document, AreaSet(m_random.below(5)))
                                     : linesToAreas(m_document);
        default:
            return m_others.next();
        }
    }

    int below(int n) { return m_random.below(n); }

private:
    Edit fills()
    {
        const std::set<StrokeId> &strokes = m_document.selection().strokes;
        switch (m_random.below(5)) {
        case 0:
        case 1:
            return addFills(m_document, strokes);
        case 2:
            return removeFills(m_document, strokes);
        case 3:
            return m_random.below(2) ? addGradients(m_document, strokes) : swapGradients(m_document, strokes);
        default:
            return changeStrokes(m_document, strokes, [](Stroke &stroke) { // a fill alone
                for (Segment &segment : stroke.segments)
                    segment.density = stroke.fill && !segment.takesPaint() ? 0 : segment.density;
            });
        }
    }
    StrokePtr any()
    {
        const auto &strokes = m_document.painting()->strokes;
        return strokes.empty() ? nullptr : strokes[std::size_t(m_random.below(int(strokes.size())))];
    }
    StrokeId anyId()
    {
        const StrokePtr s = any();
        return s ? s->id : 0;
    }
    std::set<StrokeId> allIds()
    {
        std::set<StrokeId> ids;
        for (const StrokePtr &stroke : m_document.painting()->strokes)
            ids.insert(stroke->id);
        return ids;
    }
    GroupId anyGroup()
    {
        const auto &groups = m_document.painting()->groups;
        return groups.empty() ? 0 : groups[std::size_t(m_random.below(int(groups.size())))].id;
    }
    NodeRef endNode()
    {
        const StrokePtr s = any();
        if (!s)
            return {};
        return {s->id, m_random.below(3) ? (m_random.below(2) ? nodeCount(*s) - 1 : 0) : m_random.below(nodeCount(*s))};
    }
    Leaves leaves() { return m_random.below(2) ? Leaves::Chains : Leaves::Strokes; }
    std::set<NodeRef> nodes(int count)
    {
        std::set<NodeRef> result;
        for (int i = m_random.below(count); i >= 0; --i)
            if (const StrokePtr s = any())
                result.insert({s->id, m_random.below(nodeCount(*s) + 1)}); // one too far, at times
        return result;
    }
    PlacesOfStrokes places()
    {
        PlacesOfStrokes result;
        for (int i = m_random.below(4); i >= 0; --i)
            if (const StrokePtr s = any())
                result[s->id].push_back({m_random.below(int(s->segments.size())), m_random.real(0, 1)});
        return result;
    }
    void selectSome()
    {
        Selection selection;
        for (int i = m_random.below(5); i >= 0; --i)
            if (const StrokePtr s = any()) {
                selection.strokes.insert(s->id);
                if (m_random.below(2))
                    selection.segments.insert({s->id, m_random.below(int(s->segments.size()))});
            }
        m_document.setSelection(selection);
    }

    Document &m_document;
    AwkwardStrokes m_random;
    RandomEdits m_others;
};

} // namespace suffuse::test

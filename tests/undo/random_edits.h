// Paintings and random edits for the tests of undo.
#pragma once

#include "model/brush/stroke_builder.h"
#include "undo/edits.h"

#include <QTest>
#include <QUndoStack>

#include <random>

namespace suffuse {

/// Segments of 10 units in a row along x.
inline StrokePtr makeStroke(StrokeId id, double x, double y, int segments = 4, GroupId group = 0)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->group = group;
    s->origin = {x, y};
    for (int k = 0; k < segments; ++k) {
        Segment g;
        for (int i = 0; i < 4; ++i)
            g.bezier[std::size_t(i)] = {float(10 * k) + float(i) * 10 / 3, 0};
        if (k > 0)
            g.bezier[0] = s->segments.back().bezier[3];
        g.density = float(9 + k);
        s->segments.push_back(g);
    }
    return s;
}

/// Strokes 1…n; 60 apart, so that each meets its neighbours (s ≈ 7, reach 28, length 40) and no other.
inline PaintingPtr makePainting(int n)
{
    auto p = std::make_shared<Painting>();
    for (int i = 1; i <= n; ++i)
        p->strokes.push_back(makeStroke(StrokeId(i), 60.0 * i, 0));
    return p;
}

inline std::vector<StrokeId> orderOf(const Document &d)
{
    std::vector<StrokeId> order;
    for (const StrokePtr &s : d.painting()->strokes)
        order.push_back(s->id);
    return order;
}

inline const Stroke &strokeOf(const Document &d, StrokeId id)
{
    return *d.painting()->find(id);
}

inline void select(Document &d, std::set<StrokeId> strokes, std::set<SegmentRef> segments = {})
{
    d.setSelection({std::move(strokes), std::move(segments)});
}

/// All the way back gives the painting of hash `first`, and forward again the one that is there now.
inline void checkUndoAllAndRedo(QUndoStack &stack, const Document &d, const QByteArray &first)
{
    const QByteArray last = hashOf(*d.painting());
    const int steps = stack.index();
    while (stack.canUndo())
        stack.undo();
    QCOMPARE(hashOf(*d.painting()), first);
    while (stack.index() < steps)
        stack.redo();
    QCOMPARE(hashOf(*d.painting()), last);
}

/// One random edit of every kind there is; may be empty.
class RandomEdits {
public:
    RandomEdits(Document &document, unsigned seed) : m_document(document), m_random(seed) {}

    Edit next()
    {
        switch (below(12)) {
        case 0:
            return addStrokes(m_document, {scribble()}, below(2) == 0);
        case 1:
            select();
            return deleteSelection(m_document);
        case 2:
            select();
            return duplicateSelection(m_document, {real(-50, 50), real(-50, 50)});
        case 3:
            select();
            return arrangeSelection(m_document, Arrange(below(4)));
        case 4:
            select();
            return reorder(m_document, m_document.selection().strokes, below(3) ? anyId() : 0);
        case 5: {
            Canvas canvas = m_document.painting()->canvas;
            canvas.width = real(-10, 2000); // sometimes refused
            return setCanvas(m_document, canvas);
        }
        case 6:
            return changeStrokes(m_document, {anyId()}, [this](Stroke &s) {
                s.name = QString::number(below(1000));
                s.visible = below(2);
                s.locked = below(8) == 0;
                s.mix = below(2) ? Mix{MixMode::Beta, float(real(0, 1))} : Mix();
                s.origin.x += real(-5, 5);
                if (below(4) == 0)
                    s.picture = below(3) ? SharedPicture(picture()) : SharedPicture();
            });
        case 7:
            return groups();
        default:
            select();
            return changeSegments(m_document, targetSegments(m_document), [this](Segment &s) {
                s.density = float(real(-1, 20));
                s.colour.red = float(real(0, 1));
                if (below(3) == 0)
                    s.style = Style{StyleKind::Feathering, {1, float(real(0.4, 4)), 0}};
                if (below(3) == 0)
                    s.bezier[1].y += float(real(-3, 3));
            });
        }
    }

    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_random); }
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }

private:
    StrokeId anyId()
    {
        const auto &strokes = m_document.painting()->strokes;
        return strokes.empty() ? 0 : strokes[std::size_t(below(int(strokes.size())))]->id;
    }

    void select()
    {
        Selection s;
        for (int i = below(3); i >= 0; --i)
            s.strokes.insert(anyId());
        if (below(2))
            s.segments = {{anyId(), below(4)}, {anyId(), below(4)}};
        m_document.setSelection(s);
    }

    Picture picture()
    {
        Picture p;
        const auto image = std::make_shared<const QByteArray>(QByteArray("\x89PNG\r\n\x1a\n") + char('a' + below(3)));
        p.sha256 = sha256Of(*image);
        if (below(3) == 0)
            p.link = QStringLiteral("a.png");
        else
            p.image = image;
        p.corner.x = float(real(-5, 0));
        return p;
    }

    StrokePtr scribble()
    {
        std::vector<PenSample> samples;
        PenSample p{{real(0, 500), real(0, 500)}, 0, 1};
        for (int i = below(12); i >= 0; --i) {
            p.position = p.position + Point{real(-10, 10), real(-10, 10)};
            p.time += 12'000;
            p.pressure = float(real(0, 1));
            samples.push_back(p);
        }
        const auto &brushes = builtinBrushes();
        return buildStroke(brushes[std::size_t(below(int(brushes.size())))], m_document.takeStrokeId(), samples);
    }

    /// Groups, swatches and underlay have no edit functions of their own yet: as plain edits. The strokes of the lower
    /// half form a group.
    Edit groups()
    {
        Edit edit;
        if (below(2)) {
            edit.swatches = std::vector<Swatch>{{QString::number(below(9)), {float(real(0, 1)), 0, 0, 1}}};
            auto underlay = std::make_shared<Underlay>();
            underlay->area = Rect::of(0, 0, real(1, 100), 50);
            edit.underlay = below(2) ? underlay : nullptr;
            return edit;
        }
        const auto &strokes = m_document.painting()->strokes;
        const GroupId id = m_document.takeGroupId();
        edit.groups = std::vector<Group>{{id, QStringLiteral("g"), 0, below(4) != 0, below(6) == 0}};
        Group &group = edit.groups->front();
        group.opacity = below(2) ? 1 : float(real(0, 1));
        group.blend = below(2) ? BlendMode::Normal : BlendMode(below(blendModes));
        for (std::size_t i = 0; i < strokes.size(); ++i) {
            auto s = std::make_shared<Stroke>(*strokes[i]);
            s->group = i < strokes.size() / 2 ? id : 0;
            edit.strokes.emplace(s->id, s);
        }
        return edit;
    }

    Document &m_document;
    std::mt19937 m_random;
};

} // namespace suffuse

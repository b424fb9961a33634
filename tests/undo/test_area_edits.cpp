// Edits of areas against winding numbers of what they were made of, counted at points.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/shapes.h"
#include "tests/model/area/windings.h"
#include "tests/model/awkward_strokes.h"
#include "tests/trials.h"
#include "tests/undo/steps.h"
#include "undo/area_edits.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"

#include <QTest>

#include <numbers>

using namespace suffuse;
using namespace suffuse::test;

namespace {

using Loops = std::vector<std::vector<Cubic>>;

Loops placed(const Stroke &stroke)
{
    Loops loops = closedOutline(stroke);
    for (std::vector<Cubic> &loop : loops)
        for (Cubic &curve : loop)
            for (Point &p : curve.p)
                p = p + stroke.origin;
    return loops;
}

bool isInside(const Stroke &stroke, Point at)
{
    const int winding = windingAt(placed(stroke), at, 100);
    return stroke.fill->rule == FillRule::NonZero ? winding != 0 : winding % 2 != 0;
}

double extentOf(const Stroke &stroke)
{
    return sizeOf(areaOf(closedOutline(stroke), stroke.fill->rule));
}

Stroke filled(Stroke stroke, const Colour &colour)
{
    Fill fill;
    fill.colour = colour;
    stroke.fill = fill;
    for (Segment &segment : stroke.segments)
        segment.density = 0;
    return stroke;
}

constexpr Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1};

Stroke shape(ShapeKind kind, Point a, Point b, const Colour &colour)
{
    ShapeForm form;
    form.kind = kind;
    return filled(strokeAlong(outlineOf(form, a, b), Brush(), 0, 1'000'000), colour);
}

Stroke square(double x, double y, double side, const Colour &colour = red)
{
    return shape(ShapeKind::Rectangle, {x, y}, {x + side, y + side}, colour);
}

struct Work {
    Document document;

    explicit Work(std::vector<Stroke> strokes)
    {
        auto painting = std::make_shared<Painting>();
        std::set<StrokeId> ids;
        for (Stroke &stroke : strokes) {
            stroke.id = StrokeId(painting->strokes.size() + 1);
            ids.insert(stroke.id);
            painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        document.reset(painting);
        document.setSelection({ids, {}});
    }

    AreaProblem combine(AreaSet how)
    {
        AreaProblem problem = AreaProblem::None;
        Edit edit = combineAreas(document, how, &problem);
        document.exchange(edit);
        return problem;
    }
    const StrokeList &strokes() const { return document.painting()->strokes; }
    const Stroke &only() const { return *strokes()[0]; }
};

/// Closed loops that cross, touch and lie on each other.
class RandomOutlines {
public:
    explicit RandomOutlines(unsigned seed) : m_random(seed) {}

    Stroke next()
    {
        for (;;)
            if (Stroke stroke = tried(); !stroke.segments.empty())
                return stroke;
    }

    int below(int n) { return m_random.below(n); }
    double real(double from, double to) { return m_random.real(from, to); }

private:
    Stroke tried()
    {
        std::vector<std::vector<Cubic>> loops;
        for (int n = 1 + m_random.below(2); n > 0; --n)
            loops.push_back(loop());
        Stroke stroke;
        // Origins as they come from a hand, so that outlines which touch do so within float32 only.
        stroke.origin = {m_random.real(-3, 3), m_random.real(-3, 3)};
        for (const std::vector<Cubic> &loop : loops) {
            const Stroke one = strokeAlong(loop, Brush(), 0, 1'000'000);
            std::vector<Segment> segments = one.segments;
            for (Segment &segment : segments)
                for (Offset &o : segment.bezier)
                    o = toOffset(one.origin + o, stroke.origin);
            appendChain(stroke, std::move(segments));
        }
        stroke = filled(stroke, m_random.below(2) ? red : blue);
        Fill fill = *stroke.fill;
        fill.rule = FillRule(m_random.below(2));
        stroke.fill = fill;
        return stroke;
    }

    std::vector<Cubic> loop()
    {
        const int kind = m_random.below(5);
        ShapeForm form;
        form.kind = ShapeKind(kind % 4);
        form.corners = 3 + m_random.below(6);
        form.rounding = m_random.below(2) ? 0.5 : 0;
        if (kind < 3) {
            const Point a = onGrid();
            const Point b = a + Point{double(10 * (1 + m_random.below(5))), double(10 * (1 + m_random.below(5)))};
            return outlineOf(form, a, b);
        }
        std::vector<Cubic> curves;
        const Point first = m_random.below(2) ? onGrid() : m_random.point(80);
        Point at = first;
        for (int k = 2 + m_random.below(4); k > 0; --k) {
            const Point to = k == 1 ? first : m_random.below(2) ? onGrid() : m_random.point(80);
            if (m_random.below(2)) {
                curves.push_back({{at, at + (1.0 / 3) * (to - at), at + (2.0 / 3) * (to - at), to}});
            } else {
                const Point out = m_random.point(40), in = m_random.point(40);
                curves.push_back({{at, at + out, to + in, to}});
            }
            at = to;
        }
        return curves;
    }
    Point onGrid()
    {
        const int x = m_random.below(8);
        return {double(10 * x), double(10 * m_random.below(8))};
    }

    AwkwardStrokes m_random;
};

bool isWanted(AreaSet how, const std::vector<Stroke> &operands, Point at)
{
    const bool first = isInside(operands[0], at), second = isInside(operands[1], at);
    switch (how) {
    case AreaSet::Union:
        return first || second;
    case AreaSet::Difference:
        return first && !second;
    case AreaSet::Intersection:
        return first && second;
    case AreaSet::Exclusion:
        return first != second;
    case AreaSet::Division:
        break;
    }
    return first;
}

} // namespace

class TestAreaEdits : public QObject {
    Q_OBJECT

private slots:
    void setsOfSquares()
    {
        const struct {
            AreaSet how;
            double size;
            std::size_t strokes;
        } wanted[] = {{AreaSet::Union, 175, 1},
                      {AreaSet::Difference, 75, 1},
                      {AreaSet::Intersection, 25, 1},
                      {AreaSet::Exclusion, 150, 1},
                      {AreaSet::Division, 100, 2}};
        for (const auto &each : wanted) {
            Work w({square(0, 0, 10), square(5, 5, 10, blue)});
            QCOMPARE(w.combine(each.how), AreaProblem::None);
            QCOMPARE(w.strokes().size(), each.strokes);
            double size = 0;
            std::set<StrokeId> ids;
            for (const StrokePtr &stroke : w.strokes()) {
                QCOMPARE(problemOf(*stroke), QString());
                QCOMPARE(stroke->fill->colour, red); // that of the lowest
                size += extentOf(*stroke);
                ids.insert(stroke->id);
            }
            QVERIFY2(std::abs(size - each.size) < 1e-3, qPrintable(QString::number(size)));
            QVERIFY(ids.contains(1) && !ids.contains(2));
            QVERIFY(w.document.selection().strokes == ids && w.document.selection().segments.empty());
        }
    }

    /// Pieces of an outline have the values of the segments where they came from, whichever stroke these were of.
    void piecesKeepTheirValues()
    {
        Stroke below = square(0, 0, 10), above = square(5, 5, 10, blue);
        for (std::size_t i = 0; i < 4; ++i) {
            below.segments[i].diffusion = float(1 + i), above.segments[i].diffusion = float(11 + i);
            below.segments[i].granulation = 0.25f, above.segments[i].granulation = 0.75f;
            below.segments[i].colour = {float(i) / 8, 0, 0, 1}, above.segments[i].colour = {0, float(i) / 8, 0, 1};
        }
        above.style = {StyleKind::Feathering, {1, 1, 0}};
        const std::vector<Stroke> operands{below, above};
        for (const AreaSet how :
             {AreaSet::Union, AreaSet::Difference, AreaSet::Intersection, AreaSet::Exclusion, AreaSet::Division}) {
            Work w(operands);
            QCOMPARE(w.combine(how), AreaProblem::None);
            std::set<float> seen;
            for (const StrokePtr &stroke : w.strokes())
                for (const Segment &segment : stroke->segments) {
                    const Cubic curve = stroke->cubicOf(segment);
                    const Segment *from = nullptr;
                    bool isAbove = false;
                    for (const Stroke &operand : operands)
                        for (const Segment &each : operand.segments)
                            if (distanceTo({{operand.cubicOf(each)}}, curve.at(0.3)) < 1e-3 &&
                                distanceTo({{operand.cubicOf(each)}}, curve.at(0.7)) < 1e-3)
                                from = &each, isAbove = &operand == &operands[1];
                    QVERIFY(from);
                    QCOMPARE(segment.diffusion, from->diffusion);
                    QCOMPARE(segment.granulation, from->granulation);
                    QCOMPARE(segment.colour, from->colour);
                    QVERIFY(stroke->styleOf(segment) == operands[isAbove ? 1 : 0].style);
                    seen.insert(segment.diffusion);
                }
            QVERIFY(seen.size() >= 4);
        }
        Work moved({below});
        Edit edit = offsetAreas(moved.document, 2);
        moved.document.exchange(edit);
        QCOMPARE(moved.only().segments.size(), std::size_t(4));
        std::set<float> values;
        for (const Segment &segment : moved.only().segments)
            values.insert(segment.diffusion);
        QCOMPARE(values, (std::set<float>{1, 2, 3, 4}));
    }

    /// Of outlines that lie on each other the lower stroke's values count, and each of many segments finds its own.
    void sharedEdgesAndManySegments()
    {
        Stroke below = square(0, 0, 10), above = square(0, 0, 10, blue);
        for (Segment &segment : above.segments)
            segment.diffusion = 99;
        Work same({below, above});
        QCOMPARE(same.combine(AreaSet::Union), AreaProblem::None);
        QCOMPARE(same.only().segments.size(), std::size_t(4));
        for (const Segment &segment : same.only().segments)
            QCOMPARE(segment.diffusion, below.segments.front().diffusion);

        Stroke many;
        constexpr int count = 5'000;
        for (int i = 0; i < count; ++i) {
            const auto at = [](int k) {
                const double a = 2 * std::numbers::pi * (k % count) / count;
                return toOffset(Point{500 * std::cos(a), 500 * std::sin(a)}, {});
            };
            Segment segment;
            const Offset a = at(i), b = at(i + 1);
            segment.bezier = {
                a, {(2 * a.x + b.x) / 3, (2 * a.y + b.y) / 3}, {(a.x + 2 * b.x) / 3, (a.y + 2 * b.y) / 3}, b};
            segment.diffusion = float(1 + i);
            many.segments.push_back(segment);
        }
        Work w({filled(many, red), square(600, 0, 10)});
        QCOMPARE(w.combine(AreaSet::Union), AreaProblem::None);
        std::size_t right = 0;
        for (const Segment &segment : w.only().segments)
            for (const Segment &each : many.segments)
                right += each.diffusion == segment.diffusion &&
                         length(w.only().cubicOf(segment).at(0.5) - many.cubicOf(each).at(0.5)) < 0.01;
        QVERIFY2(right >= count - 4, qPrintable(QString::number(right)));
    }

    /// A disc is not divided where it turns, and a corner stays one.
    void outlinesHaveNoNodesThatDoNothing()
    {
        Work w({shape(ShapeKind::Ellipse, {0, 0}, {100, 100}, red), square(200, 200, 10)});
        QCOMPARE(w.combine(AreaSet::Union), AreaProblem::None);
        QCOMPARE(w.only().segments.size(), std::size_t(8));
        Stroke blob; // with a turn inside of each of its curves
        const Point corners[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
        for (int i = 0; i < 4; ++i) {
            const Point a = corners[i], b = corners[(i + 1) % 4], out = {0.3 * (b - a).y, -0.3 * (b - a).x};
            Segment segment;
            segment.bezier = {toOffset(a, {}), toOffset(a + out, {}), toOffset(b + out, {}), toOffset(b, {})};
            segment.node = NodeKind::Corner;
            blob.segments.push_back(segment);
        }
        Work other({filled(blob, red), square(300, 0, 10)});
        QCOMPARE(other.combine(AreaSet::Union), AreaProblem::None);
        QCOMPARE(other.only().segments.size(), std::size_t(8));
        for (int i = 0; i < 4; ++i)
            QCOMPARE(other.only().segments[std::size_t(i)].node, NodeKind::Corner);
    }

    /// Edges that lie on each other in the picture do so in numbers, whatever the strokes' origins are.
    void neighboursBecomeOne()
    {
        Stroke left = square(0, 0, 10), right = square(10, 0, 10);
        left.origin = left.origin + Point{1234.5678901, 876.54321};
        right.origin = right.origin + Point{1234.5678902, 876.54321};
        Work w({left, right});
        QCOMPARE(w.combine(AreaSet::Union), AreaProblem::None);
        QCOMPARE(chainsOf(w.only()).size(), std::size_t(1));
        QCOMPARE(w.only().segments.size(), std::size_t(4));
        QVERIFY(std::abs(extentOf(w.only()) - 200) < 0.01);
    }

    void whatLeavesNothingIsRefused()
    {
        for (const AreaSet how : {AreaSet::Difference, AreaSet::Exclusion}) {
            Work w({square(0, 0, 10), square(0, 0, 10)});
            const PaintingPtr before = w.document.painting();
            QCOMPARE(w.combine(how), AreaProblem::Empty);
            QCOMPARE(w.document.painting(), before);
        }
        Work apart({square(0, 0, 10), square(20, 0, 10)});
        QCOMPARE(apart.combine(AreaSet::Intersection), AreaProblem::Empty);
        Work one({square(0, 0, 10)});
        QCOMPARE(one.combine(AreaSet::Union), AreaProblem::TooFew);
    }

    void whatIsLockedHiddenOrUnfilledStays()
    {
        Stroke locked = square(2, 2, 3), hidden = square(3, 3, 3), line = square(4, 4, 3);
        locked.locked = true;
        hidden.visible = false;
        line.fill = {};
        Work w({square(0, 0, 10), locked, hidden, line, square(5, 5, 10)});
        QCOMPARE(w.combine(AreaSet::Union), AreaProblem::None);
        QCOMPARE(w.strokes().size(), std::size_t(4));
        QVERIFY(std::abs(extentOf(w.only()) - 175) < 1e-3);
        QVERIFY(*w.strokes()[1] == [&] {
            locked.id = 2;
            return locked;
        }());
    }

    void groupsAndPlacesStay()
    {
        Work w({square(0, 0, 10), square(50, 50, 5), square(5, 5, 10)});
        Edit group = groupSelection(w.document, "all");
        w.document.exchange(group);
        w.document.setSelection({{1, 3}, {}});
        QCOMPARE(w.combine(AreaSet::Division), AreaProblem::None);
        QCOMPARE(w.strokes().size(), std::size_t(3));
        QCOMPARE(w.strokes()[2]->id, StrokeId(2)); // what lay above the lowest lies above its parts
        for (const StrokePtr &stroke : w.strokes())
            QCOMPARE(stroke->group, w.document.painting()->groups[0].id);
        QCOMPARE(problemOf(*w.document.painting()), QString());
    }

    /// What was erased from one stays erased.
    void erasuresComeAlong()
    {
        Stroke erased = square(5, 5, 10);
        Segment lift;
        lift.bezier = {Offset{2, 2}, {3, 3}, {4, 4}, {5, 5}};
        lift.lift = true;
        appendChain(erased, {lift});
        for (const bool below : {true, false})
            for (const AreaSet how : {AreaSet::Union, AreaSet::Difference}) {
                Work w(below ? std::vector{erased, square(0, 0, 10)} : std::vector{square(0, 0, 10), erased});
                QCOMPARE(w.combine(how), AreaProblem::None);
                QCOMPARE(w.only().hasErasure(), below || how == AreaSet::Union);
            }
    }

    void randomPairs()
    {
        RandomOutlines random(7 + firstSeed());
        int done = 0, uncertain = 0;
        const int count = trials(1000, 100'000);
        for (int i = 0; i < count; ++i) {
            std::vector<Stroke> operands{random.next(), random.next()};
            if (random.below(8) == 0)
                operands[1] = operands[0];
            const auto how = AreaSet(random.below(5));
            Work w(operands);
            const PaintingPtr before = w.document.painting();
            const AreaProblem problem = w.combine(how);
            QVERIFY2(problem != AreaProblem::TooMuch, qPrintable(QString::number(i)));
            done += problem == AreaProblem::None;
            uncertain += problem == AreaProblem::Uncertain;
            if (problem != AreaProblem::None)
                QCOMPARE(w.document.painting(), before);
            else
                QCOMPARE(problemOf(*w.document.painting()), QString());
            if (problem == AreaProblem::Uncertain)
                continue;
            const Loops a = placed(operands[0]), b = placed(operands[1]);
            for (int k = 0; k < 12; ++k) {
                const double x = random.real(-20, 140);
                const Point at{x, random.real(-20, 140)};
                if (distanceTo(a, at) < 0.7 || distanceTo(b, at) < 0.7)
                    continue;
                int inside = 0;
                if (problem == AreaProblem::None)
                    for (const StrokePtr &stroke : w.strokes())
                        inside += isInside(*stroke, at);
                QVERIFY2(inside == int(isWanted(how, operands, at)),
                         qPrintable(QStringLiteral("pair %1, set %2, %3 at (%4, %5)")
                                        .arg(i)
                                        .arg(int(how))
                                        .arg(inside)
                                        .arg(at.x)
                                        .arg(at.y)));
            }
        }
        QVERIFY2(done > count / 2, qPrintable(QString::number(done)));
        QVERIFY2(uncertain <= count / 1000, qPrintable(QString::number(uncertain)));
    }

    /// Outlines of which every line crosses every other one.
    void whatWouldTakeMinutesIsRefused()
    {
        Stroke hatch;
        constexpr int lines = 6000;
        Offset at{0, 0};
        for (int i = 0; i < lines; ++i) {
            const Offset to = i + 1 == lines ? Offset{0, 0}
                              : i % 2 == 0   ? Offset{1000, float(i % 977)}
                                             : Offset{0, float((i * 31) % 983)};
            Segment segment;
            segment.bezier = {at, at, to, to};
            hatch.segments.push_back(segment);
            at = to;
        }
        Stroke across = hatch;
        for (Segment &segment : across.segments)
            for (Offset &o : segment.bezier)
                std::swap(o.x, o.y);
        Work w({filled(hatch, red), filled(across, blue)});
        const PaintingPtr before = w.document.painting();
        QCOMPARE(w.combine(AreaSet::Union), AreaProblem::TooMuch);
        QCOMPARE(w.document.painting(), before);
    }

    void outlinesMove()
    {
        for (const double by : {2.0, -2.0, -6.0}) {
            Work w({square(0, 0, 10)});
            AreaProblem problem = AreaProblem::None;
            Edit edit = offsetAreas(w.document, by, &problem);
            QCOMPARE(problem, by > -5 ? AreaProblem::None : AreaProblem::Empty);
            w.document.exchange(edit);
            const double side = by > -5 ? 10 + 2 * by : 10;
            QVERIFY2(std::abs(extentOf(w.only()) - side * side) < 0.01,
                     qPrintable(QString::number(extentOf(w.only()))));
            QCOMPARE(w.only().segments.size(), std::size_t(4)); // Corners stay corners.
        }
        Work disc({shape(ShapeKind::Ellipse, {0, 0}, {100, 100}, red)});
        Edit edit = offsetAreas(disc.document, 10);
        disc.document.exchange(edit);
        QVERIFY(std::abs(extentOf(disc.only()) - 3600 * std::numbers::pi) < 5);
    }

    /// The area of a line is where its paint is seen.
    void linesBecomeAreas()
    {
        Stroke line;
        Segment segment;
        segment.bezier = {Offset{0, 0}, {100, 0}, {200, 0}, {300, 0}};
        segment.diffusion = 5;
        segment.density = 20;
        segment.colour = blue;
        line.segments = {segment};
        Work w({line});
        Edit edit = linesToAreas(w.document);
        w.document.exchange(edit);
        QCOMPARE(w.strokes().size(), std::size_t(1));
        const Stroke &area = w.only();
        QVERIFY(area.fill && isFillAlone(area) && area.id == 1);
        QCOMPARE(area.fill->colour, blue);
        QCOMPARE(area.fill->diffusion, 0.0f);
        const double half = halfWidth(5, 20, 1, visibleCut(area.style));
        QVERIFY(half > 2);
        QVERIFY2(std::abs(extentOf(area) - (600 * half + std::numbers::pi * half * half)) < 0.02 * 600 * half,
                 qPrintable(QString::number(extentOf(area))));
        // A fill has no line.
        AreaProblem problem = AreaProblem::None;
        w.document.setSelection({{1}, {}});
        QVERIFY(linesToAreas(w.document, &problem).isEmpty());
        QCOMPARE(problem, AreaProblem::TooFew);
    }

    /// A line of many segments whose widths differ has an outline of few nodes.
    void linesOfManyWidthsBecomeSmooth()
    {
        Stroke line;
        Offset at{0, 0};
        for (int k = 0; k < 200; ++k) {
            const Offset to{float(2 * k + 2), float(40 * std::sin(0.03 * k))};
            Segment segment;
            segment.bezier = {
                at, {(2 * at.x + to.x) / 3, (2 * at.y + to.y) / 3}, {(at.x + 2 * to.x) / 3, (at.y + 2 * to.y) / 3}, to};
            segment.diffusion = float(4 + 3 * std::sin(0.05 * k));
            segment.density = 20;
            line.segments.push_back(segment);
            at = to;
        }
        Work w({line});
        double wanted = 0;
        for (const Segment &segment : line.segments)
            wanted += 2 * polygonLength(offsetsOf(segment)) *
                      halfWidth(double(segment.diffusion), 20, 1, visibleCut(line.style));
        Edit edit = linesToAreas(w.document);
        w.document.exchange(edit);
        QCOMPARE(chainsOf(w.only()).size(), std::size_t(1));
        QVERIFY2(w.only().segments.size() < 40, qPrintable(QString::number(w.only().segments.size())));
        QVERIFY2(std::abs(extentOf(w.only()) - wanted) < 0.05 * wanted,
                 qPrintable(QStringLiteral("%1 of %2").arg(extentOf(w.only())).arg(wanted)));
    }

    void filledLinesBecomeTwo()
    {
        Stroke both = square(0, 0, 100);
        for (Segment &segment : both.segments)
            segment.density = 20;
        Work w({both});
        Edit edit = linesToAreas(w.document);
        w.document.exchange(edit);
        QCOMPARE(w.strokes().size(), std::size_t(2));
        QVERIFY(isFillAlone(*w.strokes()[0]) && isFillAlone(*w.strokes()[1]));
        QVERIFY(std::abs(extentOf(*w.strokes()[0]) - 10'000) < 1e-3);
        QVERIFY(isInside(*w.strokes()[1], {50, 0}) && !isInside(*w.strokes()[1], {50, 50}));
    }
};

QTEST_GUILESS_MAIN(TestAreaEdits)
#include "test_area_edits.moc"

// Edits of fills: what begins, what changes, and what stays.
#include "model/area/area_sets.h"
#include "model/area/outline.h"
#include "model/paint/half_width.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"
#include "undo/colour_edits.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"
#include "undo/node_edits.h"
#include "undo/time_edits.h"

#include <QTest>

using namespace suffuse;

namespace {

constexpr Colour red{1, 0, 0, 1}, blue{0, 0, 1, 1};

StrokePtr triangle(StrokeId id, bool locked = false)
{
    Stroke stroke;
    stroke.id = id;
    stroke.locked = locked;
    stroke.style = {StyleKind::Feathering, {0.8f, 1.5f, 0}};
    const Offset corners[] = {{0, 0}, {60, 0}, {30, 50}, {0, 0}};
    for (int i = 0; i < 3; ++i) {
        Segment segment;
        segment.bezier = {corners[i], corners[i], corners[i + 1], corners[i + 1]};
        segment.diffusion = 7;
        segment.granulation = 0.4f;
        segment.maxAge = 3;
        segment.born = 2'000'000 + i;
        segment.colour = red;
        stroke.segments.push_back(segment);
    }
    return std::make_shared<const Stroke>(stroke);
}

struct Work {
    Document document;

    Work()
    {
        auto painting = std::make_shared<Painting>();
        painting->strokes = {triangle(1), triangle(2), triangle(3, true)};
        document.reset(painting);
    }
    void apply(Edit edit) { document.exchange(edit); }
    const Stroke &stroke(StrokeId id) { return *document.painting()->find(id); }
    void fillAlone(StrokeId id, const Colour &colour, std::optional<Gradient> gradient = {})
    {
        apply(changeStrokes(document, {id}, [&](Stroke &stroke) {
            for (Segment &segment : stroke.segments)
                segment.density = 0;
            Fill fill = usualFill(stroke);
            fill.colour = colour;
            fill.gradient = gradient;
            stroke.fill = fill;
        }));
    }
};

} // namespace

class TestFilling : public QObject {
    Q_OBJECT

private slots:
    void aFillBeginsAsItsStrokeIs()
    {
        const Fill fill = usualFill(*triangle(1));
        QCOMPARE(fill.diffusion, 7.0f);
        QCOMPARE(fill.granulation, 0.4f);
        QCOMPARE(fill.maxAge, 3.0f);
        QCOMPARE(fill.born, Microseconds(2'000'002)); // with what closes the outline
        QCOMPARE(fill.colour, red);
        // Half of its density is where the style's paint ends.
        QVERIFY(std::abs(0.5 * double(fill.density) - visibleCut(triangle(1)->style)) < 1e-6);
        Stroke filled = *triangle(1);
        filled.fill = fill;
        QCOMPARE(problemOf(filled), QString());
    }

    void onlyWhatIsNotFilledIsFilled()
    {
        Work w;
        w.apply(addFills(w.document, {1, 3}));
        QVERIFY(w.stroke(1).fill && !w.stroke(2).fill && !w.stroke(3).fill); // that one is locked
        w.apply(changeFills(w.document, *w.document.painting(), {1, 2},
                            [](Fill &now, const Fill &) { now.colour = blue; }));
        QCOMPARE(w.stroke(1).fill->colour, blue);
        QVERIFY(!w.stroke(2).fill);
        QVERIFY(addFills(w.document, {1}).isEmpty());
        w.apply(removeFills(w.document, {1, 2}));
        QVERIFY(w.stroke(1) == *triangle(1));
        QVERIFY(removeFills(w.document, {1, 2}).isEmpty());
    }

    void changesCountFromWhereTheyBegan()
    {
        Work w;
        w.apply(addFills(w.document, {1, 2}));
        const PaintingPtr before = w.document.painting();
        for (const float by : {2.0f, 5.0f, 1.5f}) // as a drag does
            w.apply(changeFills(w.document, *before, {1, 2},
                                [by](Fill &now, const Fill &then) { now.diffusion = by * then.diffusion; }));
        QCOMPARE(w.stroke(1).fill->diffusion, 10.5f);
        QCOMPARE(w.stroke(2).fill->diffusion, 10.5f);
        QVERIFY(changeFills(w.document, *before, {1}, [](Fill &now, const Fill &) { now.maxAge = -1; }).isEmpty());
    }

    void cutFillsFallApartIntoWhatTheyAre()
    {
        Work w;
        w.apply(addFills(w.document, {1}));
        w.document.setSelection({{1}, {}});
        w.apply(cutAlong(w.document, {{1, {{0, 0.5}}}}, {30, -10}, {30, 70}));
        QCOMPARE(chainsOf(w.stroke(1)).size(), std::size_t(2));
        const auto size = [](const Stroke &stroke) { return sizeOf(areaOf(closedOutline(stroke), stroke.fill->rule)); };
        QVERIFY(std::abs(size(w.stroke(1)) - 1500) < 1e-3);
        w.apply(breakApart(w.document));
        QCOMPARE(w.document.painting()->strokes.size(), std::size_t(4));
        for (const StrokeId id : w.document.selection().strokes)
            QVERIFY(std::abs(size(w.stroke(id)) - 750) < 1e-3);
        // Parts of strokes, as it is where they need not stay one.
        w.apply(addFills(w.document, {2}));
        const auto before = w.document.painting()->strokes.size();
        w.apply(eraseAlong(w.document, {2}, {{30, -10}, {30, 70}}, 2));
        QCOMPARE(w.document.painting()->strokes.size(), before + 1);
    }

    /// The fill belongs to the stroke: it is recoloured with all of it, and not with a part.
    void recolouringTakesTheFillAlong()
    {
        Work w;
        w.apply(addFills(w.document, {1}));
        const auto toBlue = [](const Colour &) { return blue; };
        w.apply(recolour(w.document, partsToColour(*w.document.painting(), {{1}, {{1, 0}}}), toBlue));
        QCOMPARE(w.stroke(1).segments[0].colour, blue);
        QCOMPARE(w.stroke(1).fill->colour, red);
        w.apply(recolour(w.document, partsToColour(*w.document.painting(), {{1}, {}}), toBlue));
        QCOMPARE(w.stroke(1).segments[2].colour, blue);
        QCOMPARE(w.stroke(1).fill->colour, blue);
        QVERIFY(recolour(w.document, partsToColour(*w.document.painting(), {{1}, {}}), toBlue).isEmpty());
    }

    /// A segment of what is a fill alone has no paint: its colour is that of the fill.
    void segmentsThatOnlyBoundColourTheFill()
    {
        Work w;
        w.fillAlone(1, red);
        const auto toBlue = [](const Colour &) { return blue; };
        w.apply(recolour(w.document, partsToColour(*w.document.painting(), {{1}, {{1, 0}}}), toBlue));
        QCOMPARE(w.stroke(1).fill->colour, blue);
    }

    /// A gradient that is added goes from one side of the outline to the other, however far its handles reach.
    void aNewGradientSpansTheOutline()
    {
        Stroke bow;
        bow.id = 1;
        Segment segment;
        segment.bezier = {Offset{0, 0}, Offset{-60, -100}, Offset{160, -100}, Offset{100, 0}};
        bow.segments = {segment};
        bow.fill = Fill{};
        auto painting = std::make_shared<Painting>();
        painting->strokes = {std::make_shared<const Stroke>(bow)};
        Document document;
        document.reset(painting);
        Edit edit = addGradients(document, {1});
        document.exchange(edit);
        const std::optional<Gradient> gradient = document.painting()->find(1)->fill->gradient;
        QVERIFY(gradient);
        double left = 0, right = 0;
        for (int i = 0; i <= 10'000; ++i) {
            const double x = bow.cubicOf(segment).at(i / 10'000.0).x;
            left = std::min(left, x), right = std::max(right, x);
        }
        QVERIFY(left < -1 && left > -20);
        QVERIFY(std::abs(gradient->from.x - left) < 1e-3 && std::abs(gradient->to.x - right) < 1e-3);
        QVERIFY(std::abs(gradient->from.y + 37.5f) < 1e-3f && gradient->from.y == gradient->to.y);
    }

    void swatchesChangeTheSecondColourOfAGradient()
    {
        Work w;
        w.fillAlone(1, blue, Gradient{{0, 0}, {60, 0}, {1, 0, 0, 0.5f}});
        Painting painting = *w.document.painting();
        painting.swatches = {{"red", red, true}};
        w.document.reset(std::make_shared<const Painting>(painting));
        const Colour green{0, 1, 1, 1};
        w.apply(changeSwatch(w.document, 0, green, usersOf(*w.document.painting(), 0)));
        QCOMPARE(w.stroke(1).fill->colour, blue);
        QCOMPARE(w.stroke(1).fill->gradient->colour, (Colour{0, 1, 1, 0.5f}));
    }

    /// What was its fill alone does not vanish with it.
    void anOutlineGetsThePaintOfItsFill()
    {
        Work w;
        w.fillAlone(1, blue);
        w.apply(addFills(w.document, {2}));
        const Stroke outlined = w.stroke(2);
        w.apply(removeFills(w.document, {1, 2}));
        QVERIFY(!w.stroke(1).fill && !w.stroke(2).fill);
        QVERIFY(w.stroke(2).segments == outlined.segments);
        for (const Segment &segment : w.stroke(1).segments) {
            QCOMPARE(segment.colour, blue);
            const double cut = visibleCut(w.stroke(1).style), age = double(segment.maxAge);
            QVERIFY(halfWidth(double(segment.diffusion), double(segment.density), age, cut) >= 0.99);
        }
        // So does a copy of one of its segments.
        w.fillAlone(1, blue);
        w.document.setSelection({{1}, {{1, 0}}});
        w.apply(duplicateSelection(w.document, {0, 0}));
        const Stroke &copy = w.stroke(*w.document.selection().strokes.begin());
        QVERIFY(!copy.fill && copy.segments.size() == 1 && copy.segments[0].density > 0);
        QCOMPARE(copy.segments[0].colour, blue);
    }

    /// One stroke has one fill. Where it cannot show what was there, nothing is combined.
    void combiningKeepsFillsOrIsRefused()
    {
        Work w;
        const auto combines = [&](std::set<StrokeId> strokes) {
            w.document.setSelection({std::move(strokes), {}});
            bool keeps = true;
            const Edit edit = combineSelection(w.document, &keeps);
            return keeps ? edit.isEmpty() ? QString("nothing to do") : QString("combined") : QString("refused");
        };
        QCOMPARE(combines({1, 2}), QString("combined")); // none is filled
        w.fillAlone(1, blue);
        QCOMPARE(combines({1, 2}), QString("refused")); // one is
        w.fillAlone(2, red);
        QCOMPARE(combines({1, 2}), QString("refused")); // in different colours
        w.fillAlone(2, blue);
        QCOMPARE(combines({1, 2}), QString("refused")); // They overlap.
        w.apply(changeStrokes(w.document, {2}, [](Stroke &stroke) { stroke.origin = {60, 0}; }));
        QCOMPARE(combines({1, 2}), QString("combined"));
        w.apply(combineSelection(w.document));
        QCOMPARE(w.stroke(2).fill->colour, blue);
        QCOMPARE(chainsOf(w.stroke(2)).size(), std::size_t(2));
    }

    void fillsAreNotWettedAgain()
    {
        Work w;
        w.fillAlone(1, blue);
        w.document.setSelection({{1}, {}});
        QVERIFY(rewet(w.document, 10'000'000, 1'000'000).isEmpty());
        w.apply(addFills(w.document, {2}));
        w.document.setSelection({{1, 2}, {}});
        w.apply(rewet(w.document, 10'000'000, 1'000'000));
        QCOMPARE(w.stroke(2).segments[0].rewet.size(), std::size_t(1));
        QVERIFY(w.stroke(1).segments[0].rewet.empty());
    }
};

QTEST_GUILESS_MAIN(TestFilling)
#include "test_filling.moc"

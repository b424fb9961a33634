// Values that change together, the pen that strokes remember, brushes and appearances put on them, random variation.
#include "model/area/outline.h"
#include "model/brush/stroke_builder.h"
#include "model/paint/style_function.h"
#include "model/painting/validate.h"
#include "model/restyling/appearance.h"
#include "model/restyling/restyle.h"
#include "model/restyling/value_change.h"
#include "model/restyling/vary.h"

#include <QTest>

#include <numbers>

using namespace suffuse;

namespace {

/// Pressure that rises and falls along a stroke.
double pressureAt(double u)
{
    return 0.25 + 0.6 * std::sin(std::numbers::pi * u);
}

/// A wavy line of 400 units in 1.6 s, as a pen paints it.
Stroke painted(const char *brush, double scale = 1)
{
    Brush with = *findBrush(brush);
    with.setSpread(with.spread() * scale);
    std::vector<PenSample> samples;
    for (int i = 0; i <= 200; ++i) {
        const double u = i / 200.0;
        samples.push_back({{100 + 400 * u, 300 + 30 * std::sin(6 * u)}, Microseconds(i) * 8000, float(pressureAt(u))});
    }
    return *buildStroke(with, 7, samples);
}

Restyle with(const Stroke &stroke, const char *brush, BrushPart part)
{
    Restyle how{*findBrush(brush), part, findBrush(stroke.brush), {}};
    how.strongest.take(stroke, how.painted);
    return how;
}

double spreadOf(const Segment &s)
{
    return std::sqrt(4 * double(s.diffusion) * double(s.maxAge));
}

double lengthOf(const Stroke &stroke)
{
    double length = 0;
    for (const Segment &s : stroke.segments)
        length += arcLength(stroke.cubicOf(s));
    return length;
}

/// The spread at the segment nearest to a share of the stroke's way.
double spreadAlong(const Stroke &stroke, double share)
{
    const double place = share * lengthOf(stroke);
    double length = 0;
    for (const Segment &s : stroke.segments)
        if ((length += arcLength(stroke.cubicOf(s))) >= place)
            return spreadOf(s);
    return spreadOf(stroke.segments.back());
}

/// A square of 40 units, filled; its outline is painted or not.
Stroke filledSquare(bool alone)
{
    Stroke stroke;
    stroke.id = 5;
    const Offset corners[] = {{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}};
    for (int k = 0; k < 4; ++k) {
        Segment segment;
        segment.bezier = {corners[k], corners[k], corners[k + 1], corners[k + 1]};
        if (alone)
            segment.density = 0;
        stroke.segments.push_back(segment);
    }
    Fill fill;
    fill.colour = {0.25f, 0.5f, 0.75f, 1};
    stroke.fill = fill;
    return stroke;
}

} // namespace

class TestRestyling : public QObject {
    Q_OBJECT

private slots:
    void changesKeepToTheirBounds()
    {
        const ValueChange twice{ValueChange::Scale, 2, 1e-45, 1e12}, more{ValueChange::Shift, 0.3, 0, 1};
        QCOMPARE(twice.applied(3), 6.0);
        QCOMPARE(twice.applied(0), 0.0);
        QCOMPARE(twice.applied(9e11), 1e12);
        QCOMPARE(more.applied(0.5), 0.8);
        QCOMPARE(more.applied(0.9), 1.0);
        QCOMPARE((ValueChange{ValueChange::Shift, -0.5, 0, 1}.applied(0.2)), 0.0);
        QCOMPARE((ValueChange{ValueChange::Shift, 0, 0, 1}.applied(0.1234567)), 0.1234567);
    }

    /// The pressure that was painted with is found again, whatever the size of the brush was.
    void pressureIsHeardAgain_data()
    {
        QTest::addColumn<QString>("brush");
        QTest::addColumn<double>("scale");
        for (const char *brush : {"ink-wash", "brush-pen", "dry-brush", "soft-airbrush"})
            for (const double scale : {1.0, 2.5})
                QTest::addRow("%s × %g", brush, scale) << QString(brush) << scale;
    }

    void pressureIsHeardAgain()
    {
        QFETCH(QString, brush);
        QFETCH(double, scale);
        const Stroke stroke = painted(brush.toLatin1().constData(), scale);
        StrongestPaint strongest;
        const Brush *by = findBrush(brush);
        strongest.take(stroke, by);
        const std::vector<RememberedPen> pens = penOf(stroke, by, strongest);
        QCOMPARE(pens.size(), stroke.segments.size());
        const double length = pens.back().distance + pens.back().rest;
        double greatest = 0, sum = 0;
        for (const RememberedPen &pen : pens)
            greatest = std::max(greatest, pen.pressure);
        QVERIFY(greatest > 0.97);
        // What is heard grows and falls as the pen's pressure did: by rank, at pairs of places.
        int right = 0, pairs = 0;
        for (std::size_t a = 0; a < pens.size(); a += 5)
            for (std::size_t b = a + 5; b < pens.size(); b += 5) {
                const double then = pressureAt(pens[a].distance / length) - pressureAt(pens[b].distance / length);
                if (std::abs(then) < 0.15)
                    continue;
                ++pairs;
                right += (pens[a].pressure - pens[b].pressure) * then > 0;
            }
        QVERIFY(pairs > 20);
        QVERIFY2(right >= 0.95 * pairs, qPrintable(QString("%1 of %2").arg(right).arg(pairs)));
        for (const RememberedPen &pen : pens)
            sum += pen.speed;
        QVERIFY(std::abs(sum / double(pens.size()) - length / 1.6) < 0.15 * length / 1.6);
    }

    void anEvenStrokeHasFullPressure()
    {
        Stroke stroke = painted("flat-marker");
        for (const Brush *by : {findBrush("flat-marker"), static_cast<const Brush *>(nullptr)}) {
            StrongestPaint strongest;
            strongest.take(stroke, by);
            for (const RememberedPen &pen : penOf(stroke, by, strongest))
                QVERIFY(pen.pressure > 0.999);
        }
    }

    /// The stroke looks as if the pen had painted it with the other brush from the start.
    void aWholeBrushIsAsIfPaintedWithIt()
    {
        const Stroke before = painted("ink-wash"), wanted = painted("brush-pen");
        std::vector<int> sources;
        const Stroke after = restyled(before, with(before, "brush-pen", BrushPart::Whole), {}, &sources);
        QVERIFY(problemOf(after).isEmpty());
        QCOMPARE(sources.size(), after.segments.size());
        QCOMPARE(after.brush, QString("brush-pen"));
        QVERIFY(after.style == wanted.style && after.mix == wanted.mix);
        QCOMPARE(after.id, before.id);
        // The strongest place counts as full pressure; in between the ratio of two places is about what it would be.
        for (const double share : {0.25, 0.75}) {
            const double ratio = spreadAlong(after, share) / spreadAlong(after, 0.5);
            const double meant = spreadAlong(wanted, share) / spreadAlong(wanted, 0.5);
            QVERIFY2(std::abs(ratio / meant - 1) < 0.15, qPrintable(QString("%1, %2").arg(ratio).arg(meant)));
        }
        QVERIFY(spreadAlong(after, 0.01) < 0.5 * spreadAlong(after, 0.5)); // it tapers
        for (const Segment &s : after.segments) {
            QCOMPARE(s.maxAge, findBrush("brush-pen")->maxAge);
            QVERIFY(s.colour == findBrush("brush-pen")->colour);
        }
        QVERIFY(std::abs(lengthOf(after) / lengthOf(before) - 1) < 1e-4);
        QCOMPARE(after.segments.front().born, before.segments.front().born);
    }

    void partsOfABrushLeaveTheOthers()
    {
        const Stroke before = painted("ink-wash");
        const Stroke form = restyled(before, with(before, "dry-brush", BrushPart::Form), {}, nullptr);
        QVERIFY(form.style == before.style && form.brush == before.brush);
        for (const Segment &s : form.segments) {
            QVERIFY(s.colour == before.segments[0].colour);
            QCOMPARE(s.maxAge, before.segments[0].maxAge);
            QCOMPARE(s.granulation, before.segments[0].granulation);
        }
        QVERIFY(std::abs(spreadAlong(form, 0.5) / findBrush("dry-brush")->spread() - 1) < 0.15);

        const Stroke colour = restyled(before, with(before, "flat-marker", BrushPart::Colour), {}, nullptr);
        QCOMPARE(colour.segments.size(), before.segments.size());
        for (std::size_t k = 0; k < before.segments.size(); ++k) {
            QVERIFY(colour.segments[k].colour == findBrush("flat-marker")->colour);
            QCOMPARE(colour.segments[k].diffusion, before.segments[k].diffusion);
            QCOMPARE(colour.segments[k].density, before.segments[k].density);
        }

        const Stroke texture = restyled(before, with(before, "dry-brush", BrushPart::Texture), {}, nullptr);
        QVERIFY(texture.style == findBrush("dry-brush")->style);
        QCOMPARE(texture.segments.size(), before.segments.size());
        for (std::size_t k = 0; k < before.segments.size(); ++k) {
            const Segment &was = before.segments[k], &is = texture.segments[k];
            QVERIFY(is.colour == was.colour);
            QCOMPARE(is.maxAge, findBrush("dry-brush")->maxAge);
            QVERIFY(std::abs(spreadOf(is) / spreadOf(was) - 1) < 1e-6);
            // What varied goes on varying.
            QVERIFY(std::abs(double(is.density) / double(was.density) /
                                 (double(texture.segments[0].density) / double(before.segments[0].density)) -
                             1) < 1e-6);
        }
    }

    void chosenSegmentsAloneAreRestyled()
    {
        const Stroke before = painted("ink-wash");
        std::vector<bool> chosen(before.segments.size());
        for (std::size_t k = 10; k < 20; ++k)
            chosen[k] = true;
        std::vector<int> sources;
        const Stroke after = restyled(before, with(before, "dry-brush", BrushPart::Whole), chosen, &sources);
        QVERIFY(after.style == before.style && after.brush == before.brush);
        for (std::size_t k = 0; k < after.segments.size(); ++k) {
            const bool meant = chosen[std::size_t(sources[k])];
            QCOMPARE(after.segments[k].style.has_value(), meant);
            if (!meant)
                QVERIFY(after.segments[k] == before.segments[std::size_t(sources[k])]);
        }
    }

    void whatTakesPaintAwayStays()
    {
        Stroke before = painted("ink-wash");
        before.segments[5].lift = true;
        const Stroke after = restyled(before, with(before, "flat-marker", BrushPart::Whole), {}, nullptr);
        QVERIFY(after.segments[5] == before.segments[5]);
        QVERIFY(varied(before, {.density = 1}, {}).segments[5] == before.segments[5]);
    }

    void appearanceKeepsWhatVaries()
    {
        const Stroke pen = painted("brush-pen"), like = painted("gouache");
        const Appearance look = appearanceOf(like);
        const Stroke kept = withAppearance(pen, look, Variation::Kept);
        QVERIFY(problemOf(kept).isEmpty());
        QVERIFY(kept.style == like.style && kept.mix == like.mix);
        const Appearance got = appearanceOf(kept);
        QVERIFY(std::abs(got.diffusion / look.diffusion - 1) < 1e-5);
        QVERIFY(std::abs(got.density / look.density - 1) < 1e-5);
        QVERIFY(std::abs(got.maxAge / look.maxAge - 1) < 1e-5);
        QVERIFY(std::abs(got.colour[0] - look.colour[0]) < 1e-3);
        for (std::size_t k = 1; k < pen.segments.size(); ++k) {
            const double was = double(pen.segments[k].diffusion) / double(pen.segments[0].diffusion);
            const double is = double(kept.segments[k].diffusion) / double(kept.segments[0].diffusion);
            QVERIFY(std::abs(is / was - 1) < 1e-6);
        }
        const Stroke levelled = withAppearance(pen, look, Variation::Levelled);
        for (const Segment &s : levelled.segments) {
            QCOMPARE(s.diffusion, float(look.diffusion));
            QCOMPARE(s.density, float(look.density));
            QCOMPARE(s.colour.yellow, float(look.colour[1]));
        }
        // Its own appearance changes nothing that can be seen.
        const Stroke same = withAppearance(pen, appearanceOf(pen), Variation::Kept);
        for (std::size_t k = 0; k < pen.segments.size(); ++k)
            QVERIFY(std::abs(double(same.segments[k].density) / double(pen.segments[k].density) - 1) < 1e-6);
    }

    void variationStraysAsFarAsSaid()
    {
        const Stroke before = painted("brush-pen");
        for (const VaryAmounts::Per per : {VaryAmounts::EachStroke, VaryAmounts::EachSegment, VaryAmounts::Along}) {
            VaryAmounts amounts{.diffusion = 0.5, .density = 0.3, .lightness = 0.1, .per = per, .seed = 3};
            const Stroke after = varied(before, amounts, {});
            QVERIFY(after == varied(before, amounts, {})); // the same seed
            double least = 1e9, greatest = 0, step = 0, last = 0;
            for (std::size_t k = 0; k < before.segments.size(); ++k) {
                const Segment &was = before.segments[k], &is = after.segments[k];
                const double factor = double(is.diffusion) / double(was.diffusion);
                QVERIFY(factor < 1.5 + 1e-6 && factor > 1 / 1.5 - 1e-6);
                QVERIFY(std::abs(is.colour.red - was.colour.red) < 0.1f + 1e-6f);
                QCOMPARE(is.maxAge, was.maxAge);
                QVERIFY(is.bezier == was.bezier && is.born == was.born);
                step = k > 0 ? std::max(step, std::abs(factor - last)) : 0;
                last = factor;
                least = std::min(least, factor);
                greatest = std::max(greatest, factor);
            }
            QCOMPARE(greatest - least < 1e-5, per == VaryAmounts::EachStroke);
            if (per != VaryAmounts::EachStroke)
                QVERIFY(greatest / least > 1.2);
            QCOMPARE(step > 0.25, per == VaryAmounts::EachSegment);
            amounts.seed = 4;
            QVERIFY(!(varied(before, amounts, {}) == after));
        }
        QVERIFY(varied(before, {}, {}) == before);
    }

    void huesTurn()
    {
        const Colour red{1, 0, 0, 0.5f};
        const Colour yellow = withHueTurned(red, 2 * std::numbers::pi / 3);
        QVERIFY(std::abs(yellow.yellow - 1) < 1e-6f && yellow.red < 1e-6f && yellow.blue < 1e-6f);
        QCOMPARE(yellow.opacity, 0.5f);
        const Colour grey{0.4f, 0.4f, 0.4f, 1};
        QVERIFY(std::abs(withHueTurned(grey, 1).blue - 0.4f) < 1e-6f);
    }

    /// A brush or an appearance on what is a fill alone changes the fill, and no outline appears.
    void fillsTakeBrushes()
    {
        const Stroke stroke = filledSquare(true);
        const Brush &brush = *findBrush("glow");
        Stroke whole = restyled(stroke, with(stroke, "glow", BrushPart::Whole), {}, nullptr);
        QVERIFY(isFillAlone(whole));
        QCOMPARE(whole.fill->colour, brush.colour);
        QCOMPARE(whole.segments.size(), stroke.segments.size());
        QVERIFY(whole.style == brush.style);
        // It ends on its outline as before.
        QVERIFY(std::abs(double(whole.fill->density) / visibleCut(whole.style) - 1 / visibleCut(stroke.style)) < 1e-4);
        QCOMPARE(whole.fill->maxAge, whole.segments[0].maxAge);
        Stroke coloured = restyled(stroke, with(stroke, "glow", BrushPart::Colour), {}, nullptr);
        QCOMPARE(coloured.fill->colour, brush.colour);
        QCOMPARE(coloured.fill->diffusion, stroke.fill->diffusion);
        // One of its segments stands for the fill, while one that has paint does not.
        std::vector<bool> one(4, false);
        one[1] = true;
        QCOMPARE(restyled(stroke, with(stroke, "glow", BrushPart::Colour), one, nullptr).fill->colour, brush.colour);
        const Stroke outlined = filledSquare(false);
        QVERIFY(restyled(outlined, with(outlined, "glow", BrushPart::Colour), one, nullptr).fill == outlined.fill);
    }

    void fillsStray()
    {
        VaryAmounts amounts;
        amounts.hue = 1;
        amounts.density = 0.5;
        const Stroke stroke = filledSquare(true), other = varied(stroke, amounts, {});
        QVERIFY(other.fill->colour != stroke.fill->colour && other.fill->density != stroke.fill->density);
        QVERIFY(isFillAlone(other));
        QVERIFY(varied(stroke, amounts, {}) == other);
        std::vector<bool> one(4, false);
        one[2] = true;
        const Stroke outlined = filledSquare(false);
        QVERIFY(varied(outlined, amounts, one).fill == outlined.fill);
        QVERIFY(varied(stroke, amounts, one).fill->colour != stroke.fill->colour);
    }

    void fillsTakeAppearances()
    {
        const Stroke line = painted("pencil"), fill = filledSquare(true), both = filledSquare(false);
        const Stroke asLine = withAppearance(fill, appearanceOf(line), Variation::Kept);
        QVERIFY(isFillAlone(asLine));
        QCOMPARE(asLine.fill->diffusion, float(appearanceOf(line).diffusion));
        QCOMPARE(asLine.fill->colour.red, float(appearanceOf(line).colour[0]));
        const Appearance copied = appearanceOf(fill);
        QVERIFY(copied.isFillAlone && copied.fill == fill.fill);
        const Stroke lineLikeIt = withAppearance(line, copied, Variation::Levelled);
        QVERIFY(!lineLikeIt.fill); // It has its line.
        QCOMPARE(lineLikeIt.segments[3].density, line.segments[3].density);
        QCOMPARE(lineLikeIt.segments[3].colour, fill.fill->colour);
        const Stroke filledLine = withAppearance(line, appearanceOf(both), Variation::Kept);
        QVERIFY(filledLine.fill);
        QCOMPARE(filledLine.fill->colour, both.fill->colour);
        // The gradient lies in the other outline as it lay in its own.
        Fill graded = *both.fill;
        graded.gradient = Gradient{{0, 0}, {40, 40}, {1, 1, 1, 1}};
        Stroke source = both, target = fill;
        source.fill = graded;
        for (Segment &segment : target.segments)
            for (Offset &o : segment.bezier)
                o = {o.x * 2 + 10, o.y};
        const Stroke taken = withAppearance(target, appearanceOf(source), Variation::Kept);
        QVERIFY(taken.fill->gradient);
        QCOMPARE(taken.fill->gradient->from, (Offset{10, 0}));
        QCOMPARE(taken.fill->gradient->to, (Offset{90, 40}));
        QVERIFY(isFillAlone(taken));
    }
};

QTEST_APPLESS_MAIN(TestRestyling)
#include "test_restyling.moc"

// Colours under shifts, what looks nearest, the list of a painting's colours, and what is painted in one of them.
#include "model/brush/brush_dynamics.h"
#include "model/colour/colour_shift.h"
#include "model/colour/colour_uses.h"
#include "model/colour/hue_shares.h"
#include "model/colour/perceived.h"
#include "model/paint/derived_figures.h"
#include "model/paint/style_function.h"
#include "model/painting/ryb.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>

using namespace suffuse;

namespace {

constexpr Colour red{1, 0, 0, 1}, yellow{0, 1, 0, 1}, blue{0, 0, 1, 1}, white{0, 0, 0, 1}, black{1, 1, 1, 1};

double farthest(const Colour &a, const Colour &b)
{
    return std::max({std::abs(a.red - b.red), std::abs(a.yellow - b.yellow), std::abs(a.blue - b.blue)});
}

class RandomColours {
public:
    Colour next()
    {
        const auto share = [this] { return float(m_random.generateDouble()); };
        return {share(), share(), share(), share()};
    }

private:
    QRandomGenerator m_random{19};
};

/// A stroke of segments of 30 units, one of each colour.
StrokePtr strokeOf(StrokeId id, const std::vector<Colour> &colours)
{
    auto stroke = std::make_shared<Stroke>();
    stroke->id = id;
    for (const Colour &colour : colours) {
        const float x = float(30 * stroke->segments.size());
        Segment segment;
        segment.bezier = {Offset{x, 0}, {x + 10, 0}, {x + 20, 0}, {x + 30, 0}};
        segment.colour = colour;
        stroke->segments.push_back(segment);
    }
    return stroke;
}

/// A square of 30 units, filled with one colour, or two, and with or without a white outline.
StrokePtr filled(StrokeId id, const std::vector<Colour> &colours, bool outlined)
{
    auto stroke = std::make_shared<Stroke>();
    stroke->id = id;
    const Offset corners[] = {{0, 0}, {30, 0}, {30, 30}, {0, 30}, {0, 0}};
    for (int k = 0; k < 4; ++k) {
        Segment segment;
        segment.bezier = {corners[k], corners[k], corners[k + 1], corners[k + 1]};
        segment.density = outlined ? 9 : 0;
        segment.colour = white;
        stroke->segments.push_back(segment);
    }
    Fill fill;
    fill.colour = colours[0];
    if (colours.size() > 1)
        fill.gradient = Gradient{{0, 0}, {30, 0}, colours[1]};
    stroke->fill = fill;
    return stroke;
}

} // namespace

class TestColourMaps : public QObject {
    Q_OBJECT

private slots:
    /// A stroke that was erased softly has the colour of its paint; nothing else of it is coloured.
    void erasuresHaveNoColour()
    {
        Painting painting;
        Stroke stroke = *strokeOf(1, {red, white, white, white});
        for (const std::size_t k : {1, 2, 3})
            stroke.segments[k].lift = true;
        painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
        const ColourParts whole = partsToColour(painting, {{1}, {}});
        QCOMPARE(whole.size(), std::size_t(1));
        QCOMPARE(whole.front().count(), std::size_t(1));
        const ColourSummary summary = summaryOf(whole, false);
        QCOMPARE(summary.usual, red);
        QVERIFY(!summary.several);
        QVERIFY(partsToColour(painting, {{1}, {{1, 2}}}).empty());
        QCOMPARE(partsToColour(painting, {{1}, {{1, 0}, {1, 2}}}).front().count(), std::size_t(1));
        QVERIFY(partsOfColour(painting, white).empty());
    }

    void aShiftOfNothingKeepsEveryBit()
    {
        RandomColours colours;
        for (int i = 0; i < 1000; ++i) {
            const Colour colour = colours.next();
            QCOMPARE(shifted(colour, {}), colour);
        }
    }

    void hueTurnsAroundTheWheel()
    {
        const ColourShift third{.hue = 1.0 / 3};
        QVERIFY(farthest(shifted(red, third), yellow) < 1e-6);
        QVERIFY(farthest(shifted(yellow, third), blue) < 1e-6);
        QVERIFY(farthest(shifted(blue, third), red) < 1e-6);
        RandomColours colours;
        for (int i = 0; i < 200; ++i) { // there and back, white and black in it as they were
            const Colour colour = colours.next();
            const Colour there = shifted(colour, third);
            QVERIFY(std::abs(toShares(there, 0).chroma - toShares(colour, 0).chroma) < 1e-6);
            QVERIFY(farthest(shifted(there, {.hue = -1.0 / 3}), colour) < 1e-6);
            QCOMPARE(there.opacity, colour.opacity);
        }
    }

    void greysStayGrey()
    {
        for (const float level : {0.0f, 0.3f, 1.0f}) {
            const Colour grey{level, level, level, 0.5f};
            QVERIFY(isGrey(grey));
            QVERIFY(isGrey(shifted(grey, {.hue = 0.4, .saturation = 5, .lightness = 0.2})));
            QVERIFY(farthest(shifted(grey, {.hue = 0.4, .saturation = 5}), grey) < 1e-6);
        }
        QVERIFY(isGrey(shifted({0.2f, 0.8f, 0.4f, 1}, {.saturation = 0})));
        QVERIFY(!isGrey({0.2f, 0.8f, 0.4f, 1}));
    }

    void lightnessGoesToWhiteAndBlack()
    {
        const Colour green{0.1f, 0.7f, 0.8f, 1};
        QVERIFY(farthest(shifted(green, {.lightness = 1}), white) < 1e-6);
        QVERIFY(farthest(shifted(green, {.lightness = -1}), black) < 1e-6);
        const HueShares before = toShares(green, 0), paler = toShares(shifted(green, {.lightness = 0.5}), 0);
        QVERIFY(std::abs(paler.hue - before.hue) < 1e-5);
        QVERIFY(std::abs(paler.chroma - before.chroma / 2) < 1e-6);
    }

    /// Whatever is picked for a colour with a hue, the shift leads there.
    void aShiftLeadsFromOneColourToAnother()
    {
        RandomColours colours;
        for (int i = 0; i < 2000; ++i) {
            const Colour from = colours.next(), to = colours.next();
            const Colour reached = shifted(from, shiftBetween(from, to));
            QVERIFY2(farthest(reached, to) < 2e-5, qPrintable(QString::number(i)));
        }
        QCOMPARE(shiftBetween(red, red), ColourShift());
        const ColourShift ofGrey = shiftBetween({0.5f, 0.5f, 0.5f, 1}, red);
        QCOMPARE(ofGrey.hue, 0.0);
        QCOMPARE(ofGrey.saturation, 1.0);
    }

    void differencesStay()
    {
        const Colour leaf{0.05f, 0.6f, 0.5f, 1}, darker{0.25f, 0.75f, 0.66f, 1};
        const ColourShift shift = shiftBetween(leaf, {0.6f, 0.3f, 0.05f, 1});
        const HueShares a = toShares(shifted(leaf, shift), 0), b = toShares(shifted(darker, shift), 0);
        const HueShares a0 = toShares(leaf, 0), b0 = toShares(darker, 0);
        const double turned = (b.hue - a.hue) - (b0.hue - a0.hue);
        QVERIFY(std::abs(turned - std::round(turned)) < 1e-5);
        QVERIFY(b.black > a.black + 0.05);
    }

    void perceivedColoursAreThoseOfOklab()
    {
        QVERIFY(std::abs(distanceOf(perceivedOf(white), perceivedOf(black)) - 1) < 1e-3);
        const Perceived p = perceivedOf(rybFromSrgb(1, 0, 0)); // as its author gives it
        QVERIFY(std::abs(p[0] - 0.628) < 1e-3 && std::abs(p[1] - 0.225) < 1e-3 && std::abs(p[2] - 0.126) < 1e-3);
        const ColourPalette palette({red, blue, white, white});
        QCOMPARE(palette.nearest({0.9f, 0.2f, 0, 1}), red);
        QCOMPARE(palette.nearest({0.1f, 0.1f, 0, 1}), white);
        QVERIFY(ColourPalette({}).isEmpty());
    }

    void partsAreWhatCanBeChanged()
    {
        Painting painting;
        painting.groups = {{1, "hidden", 0, false, false}};
        for (StrokeId id = 1; id <= 4; ++id) {
            Stroke stroke = *strokeOf(id, {red, blue});
            stroke.locked = id == 2;
            stroke.group = id == 3 ? 1 : 0;
            painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        const auto ids = [](const ColourParts &parts) {
            std::vector<StrokeId> found;
            for (const ColourPart &part : parts)
                found.push_back(part.stroke->id);
            return found;
        };
        QCOMPARE(ids(partsToColour(painting, {})), std::vector<StrokeId>({1, 4}));
        QCOMPARE(ids(partsToColour(painting, {{2, 3, 4}, {}})), std::vector<StrokeId>({4}));
        const ColourParts some = partsToColour(painting, {{1, 4}, {{4, 1}}});
        QCOMPARE(ids(some), std::vector<StrokeId>({1, 4}));
        QCOMPARE(some[0].count(), std::size_t(2)); // all of it
        QCOMPARE(some[1].chosen, std::vector<bool>({false, true}));
        // What has a colour is found in all of them.
        QCOMPARE(ids(partsOfColour(painting, {0, 0, 1, 0.3f})), std::vector<StrokeId>({1, 2, 3, 4}));
        QVERIFY(partsOfColour(painting, yellow).empty());
    }

    void coloursAreListedByPaint()
    {
        Painting painting;
        const Colour thin{0, 1, 0, 0.25f};
        painting.strokes = {strokeOf(1, {red, red, blue}), strokeOf(2, {red, thin})};
        Stroke lifted = *strokeOf(3, {white});
        lifted.segments[0].lift = true;
        painting.strokes.push_back(std::make_shared<const Stroke>(lifted));
        const std::vector<ColourUse> uses = coloursOf(partsToColour(painting, {}), 24);
        QCOMPARE(uses.size(), std::size_t(3)); // what takes paint away has no colour
        QCOMPARE(uses[0].colour, red);
        QCOMPARE(uses[0].segments, std::size_t(3));
        QCOMPARE(uses[0].strokes, std::size_t(2));
        QCOMPARE(uses[1].colour, blue);
        QCOMPARE(uses[2].colour, yellow); // opaque: the opacity is no colour, but less paint
        QVERIFY(std::abs(uses[0].paint - 3 / 4.25) < 1e-9);
        QVERIFY(std::abs(uses[2].paint - 0.25 / 4.25) < 1e-9);
        QVERIFY(coloursOf({}, 24).empty());
    }

    /// A fill is paint by its area, and so are both colours of a gradient; what only bounds it is none.
    void fillsArePaint()
    {
        Painting painting;
        painting.strokes = {strokeOf(1, {red}), filled(2, {blue}, false), filled(3, {yellow, black}, true)};
        const ColourParts parts = partsToColour(painting, {});
        const std::vector<ColourUse> uses = coloursOf(parts, 24);
        // The line of 30 units, as wide as it is seen; squares of 30 × 30 units, one of them in two colours, with an
        // outline of 4 × 30 units.
        QCOMPARE(uses.size(), std::size_t(5));
        const auto paintOf = [&](const Colour &colour) {
            const auto use = std::ranges::find(uses, colour, &ColourUse::colour);
            return use == uses.end() ? -1 : use->paint;
        };
        const Stroke &stroke = *painting.strokes[0];
        const double half = derivedFigures(stroke.segments[0], stroke.style).halfWidth;
        QVERIFY(half > 0);
        const double line = 30 * 2 * half, square = 900 * densityFunction(stroke.style, 1);
        const double all = line + 2 * square + 4 * line;
        QVERIFY(std::abs(paintOf(red) - line / all) < 1e-6);
        QVERIFY(std::abs(paintOf(blue) - square / all) < 1e-6);
        QVERIFY(std::abs(paintOf(yellow) - 0.5 * square / all) < 1e-6);
        QVERIFY(std::abs(paintOf(black) - 0.5 * square / all) < 1e-6);
        QVERIFY(std::abs(paintOf(white) - 4 * line / all) < 1e-6);
        const ColourUse &filling = *std::ranges::find(uses, blue, &ColourUse::colour);
        QCOMPARE(filling.segments, std::size_t(0));
        QCOMPARE(filling.strokes, std::size_t(1));
    }

    /// A line that is crisp since it holds very much paint covers no more than another one of its width.
    void crispLinesAreNoMoreThanTheyCover()
    {
        Stroke thin = *strokeOf(1, {red});
        const double diffusion = 0.01, spread = spreadAt(diffusion, 1), density = densityOfPeak(1e6, spread);
        thin.segments[0].maxAge = 1;
        thin.segments[0].diffusion = float(diffusion);
        thin.segments[0].density = float(density);
        QVERIFY(density > 1e5);
        const double covered = 30 * 2 * halfWidth(diffusion, density, 1, visibleCut(thin.style));
        Painting painting;
        painting.strokes = {std::make_shared<const Stroke>(thin), filled(2, {blue}, false)};
        const std::vector<ColourUse> uses = coloursOf(partsToColour(painting, {}), 24);
        QCOMPARE(uses[0].colour, blue);
        QVERIFY(std::abs(uses[1].paint / uses[0].paint - covered / (900 * densityFunction(thin.style, 1))) < 1e-3);
    }

    void fillsAreMeantWithWhatOnlyBoundsThem()
    {
        Painting painting;
        painting.strokes = {filled(1, {blue}, false), filled(2, {yellow, black}, true)};
        ColourParts parts = partsToColour(painting, {{1}, {{1, 2}}});
        QVERIFY(parts.size() == 1 && parts[0].fill && !parts[0].gradient && parts[0].count() == 1);
        ColourSummary summary = summaryOf(parts, false);
        QCOMPARE(summary.usual, blue);
        QVERIFY(summary.onlyFills && !summary.several);
        QCOMPARE(summary.segments, std::size_t(1));
        parts = partsToColour(painting, {{2}, {{2, 2}}}); // that has paint of its own
        QVERIFY(!parts[0].fill && !parts[0].gradient);
        parts = partsToColour(painting, {{2}, {}});
        QVERIFY(parts[0].fill && parts[0].gradient);
        summary = summaryOf(parts, false);
        QVERIFY(summary.several && !summary.onlyFills);
        QCOMPARE(summary.segments, std::size_t(4));
        // Exactly one colour: that of segments, of a fill, or the second one of a fill.
        parts = partsOfColour(painting, black);
        QVERIFY(parts.size() == 1 && !parts[0].fill && parts[0].gradient && parts[0].count() == 0);
        parts = partsOfColour(painting, yellow);
        QVERIFY(parts.size() == 1 && parts[0].fill && !parts[0].gradient);
        parts = partsOfColour(painting, white); // The outline of the first one is not seen.
        QVERIFY(parts.size() == 1 && parts[0].stroke->id == 2 && parts[0].count() == 4);
    }

    void manyColoursBecomeFew()
    {
        RandomColours random;
        std::vector<Colour> all;
        for (int i = 0; i < 400; ++i) { // reds and blues that stray
            Colour colour = i % 2 ? red : blue;
            const Colour by = random.next();
            colour.red = std::clamp(colour.red + 0.05f * (by.red - 0.5f), 0.0f, 1.0f);
            colour.blue = std::clamp(colour.blue + 0.05f * (by.blue - 0.5f), 0.0f, 1.0f);
            all.push_back(colour);
        }
        Painting painting;
        painting.strokes = {strokeOf(1, all)};
        const ColourParts parts = partsToColour(painting, {});
        const std::vector<ColourUse> few = coloursOf(parts, 2);
        QCOMPARE(few.size(), std::size_t(2));
        for (const ColourUse &use : few) { // no red is taken for a blue
            QCOMPARE(use.segments, std::size_t(200));
            for (const Colour &member : use.members)
                QVERIFY(farthest(member, use.colour) < 0.2);
        }
        for (const std::size_t most : {std::size_t(1), std::size_t(7), std::size_t(24)}) {
            const std::vector<ColourUse> uses = coloursOf(parts, most);
            std::size_t segments = 0;
            double paint = 0;
            for (const ColourUse &use : uses)
                segments += use.segments, paint += use.paint;
            QVERIFY(uses.size() <= most);
            QCOMPARE(segments, std::size_t(400)); // each is in one of them
            QVERIFY(std::abs(paint - 1) < 1e-9);
        }
    }

    /// What a brush strays by within a stroke is one colour, however far that looks: around the wheel, and with every
    /// brush that comes with the program.
    void aBrushThatStraysPaintsOneColour()
    {
        std::vector<Colour> wheel = {
            white, black, {0.5f, 0.5f, 0.5f, 1}, {0.1f, 0.3f, 0.2f, 1}, {0.6f, 0.75f, 0.5f, 1}, {0.32f, 0.22f, 1, 1}};
        for (int hue = 0; hue < 24; ++hue) { // saturated
            const auto channel = [hue](int k) {
                return float(std::clamp(2 - std::abs(std::remainder(hue - 8.0 * k, 24)) / 4, 0.0, 1.0));
            };
            wheel.push_back({channel(0), channel(1), channel(2), 1});
        }
        int straying = 0;
        for (const Brush &preset : builtinBrushes()) {
            const bool mixes = std::ranges::any_of(
                preset.dynamics, [](const BrushDynamic &d) { return d.quantity == BrushQuantity::ColourMix; });
            straying += preset.jitter != ColourJitter();
            for (const Colour &colour : wheel)
                for (std::uint64_t seed = 1; seed <= 40 && !mixes; ++seed) {
                    Brush brush = preset;
                    brush.colour = colour;
                    std::vector<Colour> laid;
                    for (int k = 0; k < 60; ++k) // long enough for it to go from one end to the other
                        laid.push_back(paintAt(brush, {.pressure = 0.5, .distance = 0.7 * k}, seed).colour);
                    Painting painting;
                    painting.strokes = {strokeOf(1, laid)};
                    const ColourSummary found = summaryOf(partsToColour(painting, {}), false);
                    QVERIFY2(!found.several, qPrintable(QString("%1 in %2 %3 %4")
                                                            .arg(brush.name)
                                                            .arg(colour.red)
                                                            .arg(colour.yellow)
                                                            .arg(colour.blue)));
                    QVERIFY(!found.other);
                }
        }
        QVERIFY(straying > 2);
        // Colours a sixth of the wheel apart are two, in one stroke and in two.
        for (std::size_t k = 6; k + 4 < wheel.size(); ++k) {
            Painting one, two;
            one.strokes = {strokeOf(1, {wheel[k], wheel[k], wheel[k + 4]})};
            two.strokes = {strokeOf(1, {wheel[k], wheel[k]}), strokeOf(2, {wheel[k + 4]})};
            QVERIFY(summaryOf(partsToColour(one, {}), false).several);
            QVERIFY(summaryOf(partsToColour(two, {}), false).several);
        }
        // Two strokes that look different are two colours, though one brush might stray as far within one.
        Painting pale;
        pale.strokes = {strokeOf(1, {white, white}), strokeOf(2, {{0.2f, 0.2f, 0.2f, 1}})};
        QVERIFY(summaryOf(partsToColour(pale, {}), false).several);
    }

    void theUsualColourIsTheMostFrequentOne()
    {
        Painting painting;
        painting.strokes = {strokeOf(1, {red, blue, blue}), strokeOf(2, {black, black, black})};
        const ColourSummary all = summaryOf(partsToColour(painting, {}), false);
        QCOMPARE(all.usual, black);
        QVERIFY(all.several);
        QCOMPARE(all.strokes, std::size_t(2));
        QCOMPARE(all.segments, std::size_t(6));
        QCOMPARE(summaryOf(partsToColour(painting, {}), true).usual, blue); // a grey has no hue to shift
        QCOMPARE(summaryOf(partsToColour(painting, {{2}, {}}), true).usual, black);
        painting.strokes = {strokeOf(1, {red, {1, 0, 0, 0.5f}})};
        const ColourSummary one = summaryOf(partsToColour(painting, {}), false);
        QCOMPARE(one.usual, red);
        QVERIFY(!one.several); // in opacity only
    }
};

QTEST_GUILESS_MAIN(TestColourMaps)
#include "test_colour_maps.moc"

// The brushes that come with the program. What each looks like: docs/brushes.md.
#include "model/brush/brush.h"

#include <algorithm>

namespace suffuse {

namespace {

using enum BrushQuantity;
using enum BrushInput;

using Curves = std::vector<std::tuple<BrushQuantity, BrushInput, ResponseCurve>>;

/// A line from one share at input 0 to another at 1.
ResponseCurve ramp(float from, float to)
{
    return {{{0, from}, {1, to}}};
}

Style uniform(float xi1, float xi2)
{
    return {StyleKind::Uniform, {xi1, xi2, 0}};
}

Style feathering(float xi1, float xi2)
{
    return {StyleKind::Feathering, {xi1, xi2, 0}};
}

Style edge(float xi1, float xi2, float xi3)
{
    return {StyleKind::Edge, {xi1, xi2, xi3}};
}

/// What every brush has: its id, its style, its spread, which it reaches in `maxAge` seconds, and its peak.
struct Base {
    const char *id;
    Style style;
    double spread;
    float maxAge;
    float peak;
};

Brush make(const Base &base, const Colour &colour, float granulation, const Curves &curves)
{
    Brush b;
    b.name = QLatin1String(base.id);
    b.style = base.style;
    b.maxAge = base.maxAge;
    b.setSpread(base.spread);
    b.peak = base.peak;
    b.colour = colour;
    b.granulation = granulation;
    b.dynamics.clear();
    for (const auto &[quantity, input, curve] : curves)
        b.setCurve(quantity, input, curve);
    return b;
}

Mix beta(float value)
{
    return {MixMode::Beta, value};
}

std::vector<Brush> inkBrushes()
{
    // Wet ink, of which light strokes stay thin and grey.
    Brush wash = make({"ink-wash", uniform(0.4f, 0.1f), 10, 2, 1.2f}, {0.86f, 0.8f, 0.94f, 0.92f}, 0.85f,
                      {{Density, Pressure, ramp(0.35f, 1)}});

    // A pointed brush: pressure opens it, haste thins it, both ends are drawn out.
    Brush pen = make({"brush-pen", uniform(0.5f, 0.03f), 9, 0.3f, 1.6f}, {0.93f, 0.9f, 0.97f, 0.97f}, 1,
                     {{Size, Pressure, {{{0, 0.08f}, {0.35f, 0.4f}, {1, 1}}}}, {Size, Speed, ramp(1, 0.7f)}});
    pen.fullSpeed = 200;
    pen.taper = {2, 3.5f, 0.05f};
    pen.stabiliser = {Stabiliser::Kind::Weighted, 0.1f, 30};

    // It runs out of ink on the way, sooner where the hand hurries. Only the hills of the paper take what is left.
    Brush dry = make({"dry-brush", uniform(0.68f, 0.05f), 18, 0.25f, 1.65f}, {0.88f, 0.84f, 0.94f, 0.95f}, 0,
                     {{Size, Pressure, ramp(0.55f, 1)},
                      {Size, Speed, ramp(1, 0.8f)},
                      {Density, Pressure, ramp(0.75f, 1)},
                      {Density, Speed, ramp(1, 0.76f)},
                      {Density, Distance, {{{0, 1}, {0.3f, 0.85f}, {1, 0.6f}}}},
                      {Density, Drift, ramp(0.8f, 1)}});
    dry.fullDistance = 30;
    dry.driftLength = 2;
    dry.taper = {0.5f, 1.5f, 0.4f};

    // Blots that swell and shrink along the way and go on running for seconds.
    Brush splash = make({"ink-splash", uniform(0.3f, 0.03f), 24, 4, 1.1f}, {0.9f, 0.82f, 0.95f, 0.95f}, 0.8f,
                        {{Size, Speed, ramp(1, 0.5f)},
                         {Size, StrokeRandom, ramp(0.7f, 1)},
                         {Size, Drift, {{{0, 0.08f}, {0.55f, 0.2f}, {0.85f, 0.8f}, {1, 1}}}},
                         {Density, Pressure, ramp(0.6f, 1)}});
    splash.driftLength = 0.7f;

    // A broad nib that is held slantwise: the direction of the path decides the width.
    Brush nib = make({"broad-nib", uniform(0.5f, 0.03f), 2.6, 0.2f, 1.7f}, {0.9f, 0.86f, 0.97f, 0.97f}, 1,
                     {{Size, Pressure, ramp(0.7f, 1)}});
    nib.tip = {14, -0.7853982f, false};
    nib.stabiliser = {Stabiliser::Kind::Weighted, 0.1f, 30};
    return {wash, pen, dry, splash, nib};
}

/// A loaded round brush, for a mouse as much as for a pen: a slow hand lays down broad, deep paint, a quick one a thin
/// and watery line. Its ends are round and a little narrower, the edge is darker, and the pigment is nowhere quite
/// even.
Brush roundWash()
{
    Brush round = make({"round-wash", edge(0.42f, 0.3f, 0.8f), 22, 2.5f, 1.1f}, {0.3f, 0.22f, 0.92f, 0.95f}, 0.55f,
                       {{Size, Pressure, {{{0, 0.2f}, {0.5f, 0.65f}, {1, 1}}}},
                        {Size, Speed, {{{0, 1}, {0.35f, 0.65f}, {1, 0.32f}}}},
                        {Opacity, Speed, ramp(1, 0.6f)}});
    round.mix = beta(0.7f);
    round.fullSpeed = 70;
    round.taper = {0.6f, 1.1f, 0.5f};
    round.jitter = {0.05f, 0.05f, 0.05f, 0.06f, true};
    round.driftLength = 2.5f;
    round.stabiliser = {Stabiliser::Kind::Weighted, 0.06f, 30};
    return round;
}

std::vector<Brush> watercolourBrushes()
{
    Brush flat = make({"flat-wash", uniform(0.35f, 0.035f), 26, 1.5f, 1.3f}, {0.25f, 0.12f, 0.75f, 0.5f}, 0.7f,
                      {{Size, Pressure, ramp(0.7f, 1)},
                       {Size, Speed, ramp(1, 0.8f)},
                       {Size, Drift, ramp(0.9f, 1)},
                       {Opacity, Drift, ramp(0.8f, 1)}});
    flat.mix = beta(0.5f);
    flat.driftLength = 3;

    // A pale wash, F ≈ 0.3 inside, within a dark rim. More grain would break the rim where the brush is large, since
    // the paint thins out there over many of the paper's hills.
    Brush dark =
        make({"watercolour-edge", edge(0.5f, 0.5f, 0.4f), 20, 2, 0.92f}, {0.2f, 0.3f, 0.9f, 0.9f}, 0.85f,
             {{Size, Speed, ramp(1, 0.55f)}, {Size, Drift, ramp(0.85f, 1)}, {Density, Pressure, ramp(0.7f, 1)}});
    dark.mix = beta(0.7f);
    dark.fullSpeed = 80;
    dark.driftLength = 3;
    dark.taper = {0.8f, 1.6f, 0.2f};

    // Pigment settles in the paper's grain.
    Brush granulating =
        make({"granulating-wash", feathering(0.9f, 2.4f), 24, 2, 0.95f}, {0.55f, 0.2f, 0.8f, 0.9f}, 0.05f,
             {{Size, Speed, ramp(1, 0.6f)}, {Density, Pressure, ramp(0.7f, 1)}, {Density, Drift, ramp(0.85f, 1)}});
    granulating.mix = beta(0.6f);
    granulating.fullSpeed = 70;
    granulating.taper = {0.6f, 1.2f, 0.4f};
    granulating.jitter = {0.06f, 0.03f, 0.04f, 0.03f, true};

    // It spreads for a long time, has no edge, and is as uneven as water.
    Brush wet = make({"wet-in-wet", feathering(1.2f, 1), 42, 6, 1.1f}, {0.75f, 0.25f, 0.5f, 0.75f}, 0.9f,
                     {{Size, Drift, ramp(0.55f, 1)}, {Density, Pressure, ramp(0.4f, 1)}});
    wet.mix = beta(0.8f);
    wet.driftLength = 1.5f;

    Brush glaze = make({"glaze", uniform(0.4f, 0.05f), 24, 0.8f, 1.4f}, {0.1f, 0.75f, 0.15f, 0.32f}, 1,
                       {{Opacity, Pressure, ramp(0.4f, 1)}});
    glaze.mix = beta(1);

    // It is loaded with two colours, and the second comes through on the way.
    Brush twoTone = make({"two-tone", uniform(0.4f, 0.06f), 20, 1.5f, 1.3f}, {0.9f, 0.55f, 0.1f, 0.8f}, 0.7f,
                         {{Size, Pressure, ramp(0.6f, 1)},
                          {Size, Speed, ramp(1, 0.5f)},
                          {ColourMix, Distance, {{{0, 0}, {0.5f, 0.45f}, {1, 1}}}}});
    twoTone.secondColour = {0.35f, 0.2f, 0.85f, 0.8f};
    twoTone.fullDistance = 16;
    twoTone.fullSpeed = 70;
    twoTone.taper = {0.8f, 1.6f, 0.2f};
    twoTone.mix = beta(0.5f);
    return {roundWash(), flat, dark, granulating, wet, glaze, twoTone};
}

std::vector<Brush> dryBrushes()
{
    Brush pencil =
        make({"pencil", uniform(0.6f, 0.1f), 2, 0.2f, 1}, {0.78f, 0.76f, 0.78f, 0.85f}, 0.3f,
             {{Size, Speed, ramp(1, 0.7f)}, {Density, Pressure, ramp(0.6f, 1)}, {Density, Speed, ramp(1, 0.8f)}});
    pencil.fullSpeed = 700; // of a fine point
    pencil.taper = {2, 5, 0.3f};

    // In the hollows of the paper (γ ≈ 0.55) a light touch falls below ξ1, so that only the hills take chalk.
    Brush chalk = make({"dry-chalk", uniform(0.7f, 0.04f), 12, 0.25f, 1.3f}, {0.75f, 0.55f, 0.4f, 0.9f}, 0.1f,
                       {{Density, Pressure, ramp(0.7f, 1)}});

    // The side of the stick, which paints when the pen lies down, is broad and catches only the grain.
    Brush charcoal = make({"charcoal", uniform(0.78f, 0.09f), 11, 0.2f, 1.5f}, {0.86f, 0.84f, 0.88f, 0.9f}, 0,
                          {{Size, Pressure, ramp(0.55f, 1)},
                           {Size, Tilt, ramp(0.6f, 1)},
                           {Density, Pressure, {{{0, 0.62f}, {0.6f, 0.78f}, {1, 1}}}},
                           {Density, Tilt, ramp(1, 0.75f)},
                           {Density, Drift, ramp(0.9f, 1)}});
    charcoal.driftLength = 1.5f;

    // Soft sticks of pigment: no two touches have quite the same tone, and all of them the same hue.
    Brush pastel = make({"pastel", uniform(0.62f, 0.05f), 13, 0.2f, 1.5f}, {0.7f, 0.3f, 0.35f, 0.92f}, 0.12f,
                        {{Size, Pressure, ramp(0.6f, 1)}, {Density, Pressure, ramp(0.7f, 1)}});
    pastel.jitter = {0.04f, 0.04f, 0.04f, 0.05f, true};
    pastel.driftLength = 3;
    return {pencil, chalk, charcoal, pastel};
}

std::vector<Brush> flatBrushes()
{
    Brush marker = make({"flat-marker", uniform(0.5f, 0.012f), 14, 0.25f, 1.5f}, {0.95f, 0.6f, 0.05f, 0.9f}, 1, {});

    // Opaque, a little uneven in tone, the grain just shows where it is thin.
    Brush gouache =
        make({"gouache", uniform(0.5f, 0.03f), 16, 0.4f, 1.6f}, {0.75f, 0.15f, 0.2f, 0.98f}, 0.45f,
             {{Size, Pressure, ramp(0.6f, 1)}, {Size, Speed, ramp(1, 0.65f)}, {Density, Speed, ramp(1, 0.75f)}});
    gouache.jitter = {0, 0.03f, 0, 0.05f, true};
    gouache.fullSpeed = 120;
    gouache.taper = {0.4f, 0.8f, 0.5f};
    return {marker, gouache};
}

std::vector<Brush> airBrushes()
{
    // It is nearly Gaussian across, and pressure is opacity.
    Brush soft = make({"soft-airbrush", feathering(1, 1.2f), 40, 0.5f, 1}, {0.8f, 0.35f, 0.25f, 0.35f}, 1,
                      {{Density, Pressure, ramp(0.05f, 1)}});

    // Light that is seen on dark grounds: a bright core in a wide halo.
    Brush glow = make({"glow", feathering(1.6f, 2), 34, 0.5f, 1.6f}, {0.02f, 0.45f, 0, 0.85f}, 1,
                      {{Size, Pressure, ramp(0.5f, 1)}, {Opacity, Pressure, ramp(0.3f, 1)}});
    return {soft, glow};
}

} // namespace

const std::vector<Brush> &builtinBrushes()
{
    static const std::vector<Brush> brushes = [] {
        std::vector<Brush> all;
        const auto add = [&all](const char *group, std::vector<Brush> members) {
            for (Brush &b : members) {
                b.group = QLatin1String(group);
                all.push_back(std::move(b));
            }
        };
        add("ink", inkBrushes());
        add("watercolour", watercolourBrushes());
        add("dry", dryBrushes());
        add("flat", flatBrushes());
        add("air", airBrushes());
        return all;
    }();
    return brushes;
}

const Brush &firstBrush()
{
    return *findBrush(QStringLiteral("round-wash"));
}

const Brush *findBrush(const QString &name)
{
    const auto &all = builtinBrushes();
    const auto it = std::find_if(all.begin(), all.end(), [&name](const Brush &b) { return b.name == name; });
    return it == all.end() ? nullptr : &*it;
}

} // namespace suffuse

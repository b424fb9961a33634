#include "model/brush.h"

#include <algorithm>

namespace suffuse {

namespace {

Style style(StyleKind kind, float xi1, float xi2, float xi3 = 0)
{
    return {kind, {xi1, xi2, xi3}};
}

/// Wet ink: s = 10, edge (10 % to 90 %) 5.6 units wide; light strokes stay thin and grey.
Brush inkWash()
{
    Brush b;
    b.name = QStringLiteral("ink-wash");
    b.style = style(StyleKind::Uniform, 0.4f, 0.1f);
    b.diffusion = 12.5f, b.maxAge = 2;
    b.peak = 1.2f, b.pressureFloor = 0.35f;
    b.granulation = 0.85f;
    b.colour = {0.86f, 0.8f, 0.94f, 0.92f};
    return b;
}

/// s = 20: a pale wash, F ≈ 0.3 inside, within a dark rim of 2.5 units.
Brush watercolourEdge()
{
    Brush b;
    b.name = QStringLiteral("watercolour-edge");
    b.style = style(StyleKind::Edge, 0.5f, 0.5f, 0.4f);
    b.mix = {MixMode::Beta, 0.7f};
    b.diffusion = 50, b.maxAge = 2;
    b.peak = 0.85f, b.pressureFloor = 0.7f;
    b.granulation = 0.6f;
    b.colour = {0.2f, 0.3f, 0.9f, 0.9f};
    return b;
}

/// s = 40, nearly Gaussian across; pressure is opacity.
Brush softAirbrush()
{
    Brush b;
    b.name = QStringLiteral("soft-airbrush");
    b.style = style(StyleKind::Feathering, 1, 1.2f);
    b.diffusion = 800, b.maxAge = 0.5f;
    b.peak = 1, b.pressureFloor = 0.05f;
    b.colour = {0.8f, 0.35f, 0.25f, 0.35f};
    return b;
}

/// s = 14 in a quarter of a second, edge 0.7 units wide, half-width 14.7 whatever the pressure.
Brush flatMarker()
{
    Brush b;
    b.name = QStringLiteral("flat-marker");
    b.style = style(StyleKind::Uniform, 0.5f, 0.012f);
    b.diffusion = 196, b.maxAge = 0.25f;
    b.peak = 1.5f, b.pressureFloor = 1;
    b.colour = {0.95f, 0.6f, 0.05f, 0.9f};
    return b;
}

/// s = 12; in the paper's hollows (γ ≈ 0.55) a light touch falls below ξ1, so that only its hills take chalk.
Brush dryChalk()
{
    Brush b;
    b.name = QStringLiteral("dry-chalk");
    b.style = style(StyleKind::Uniform, 0.7f, 0.04f);
    b.diffusion = 144, b.maxAge = 0.25f;
    b.peak = 1.3f, b.pressureFloor = 0.7f;
    b.granulation = 0.1f;
    b.colour = {0.75f, 0.55f, 0.4f, 0.9f};
    return b;
}

/// s = 2, half-width 1.4 at full pressure, 0.9 at a third.
Brush pencil()
{
    Brush b;
    b.name = QStringLiteral("pencil");
    b.style = style(StyleKind::Uniform, 0.6f, 0.1f);
    b.diffusion = 5, b.maxAge = 0.2f;
    b.peak = 1, b.pressureFloor = 0.6f;
    b.granulation = 0.3f;
    b.colour = {0.78f, 0.76f, 0.78f, 0.85f};
    return b;
}

} // namespace

const std::vector<Brush> &builtinBrushes()
{
    static const std::vector<Brush> brushes{inkWash(),    watercolourEdge(), softAirbrush(),
                                            flatMarker(), dryChalk(),        pencil()};
    return brushes;
}

const Brush *findBrush(const QString &name)
{
    const auto &all = builtinBrushes();
    const auto it = std::find_if(all.begin(), all.end(), [&name](const Brush &b) { return b.name == name; });
    return it == all.end() ? nullptr : &*it;
}

} // namespace suffuse

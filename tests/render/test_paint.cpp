// The formulas of tools and panels (model/paint) against the reference's, and the kernels' (render/math) against both.
#include "model/paint/half_width.h"
#include "model/paint/local_paint.h"
#include "model/paint/point_density.h"
#include "model/paint/seen_paint.h"
#include "render/math/scalar.h"
#include "render/probe.h"
#include "render/reference/local_paint.h"
// After the numbers: templates over them.
#include "render/math/shade.h"

#include <QTest>

#include <random>

using namespace suffuse;

namespace {

const std::vector<Style> &someStyles()
{
    static const std::vector<Style> styles{
        {StyleKind::Uniform, {0.5f, 0.05f, 0}},   {StyleKind::Uniform, {0.5f, 0.2f, 0}},
        {StyleKind::Uniform, {2, 0.01f, 0}},      {StyleKind::Feathering, {1, 1.5f, 0}},
        {StyleKind::Feathering, {0.3f, 0.5f, 0}}, {StyleKind::Feathering, {4, 9, 0}},
        {StyleKind::Edge, {0.36f, 0.40f, 0.5f}},  {StyleKind::Edge, {0.6f, 0.65f, 0.9f}},
        {StyleKind::Edge, {1, 0.2f, 0.9f}},       {StyleKind::Edge, {1, 1.25f, 0.05f}},
    };
    return styles;
}

reference::Xi xiOf(const Style &style)
{
    return {double(style.xi[0]), double(style.xi[1]), double(style.xi[2])};
}

/// One curved segment, wider along an angle than across it.
StrokePtr someStroke(std::mt19937 &random, bool even)
{
    std::uniform_real_distribution<double> place(0, 60), unit(0.1, 1);
    Stroke stroke;
    stroke.id = 1;
    stroke.origin = {1000, -500};
    for (int k = 0; k < 3; ++k) {
        Segment s;
        for (auto &p : s.bezier)
            p = {float(place(random)), float(place(random))};
        if (k > 0)
            s.bezier[0] = stroke.segments.back().bezier[3];
        s.diffusion = float(40 * unit(random));
        s.density = float(20 * unit(random));
        s.granulation = float(unit(random));
        s.colour = {float(unit(random)), float(unit(random)), float(unit(random)), float(unit(random))};
        s.anisotropyRatio = even ? 1 : float(0.3 + 4 * unit(random));
        s.anisotropyAngle = float(3 * unit(random));
        stroke.segments.push_back(s);
    }
    return std::make_shared<const Stroke>(std::move(stroke));
}

} // namespace

class TestPaint : public QObject {
    Q_OBJECT

private slots:
    void styleFunctionIsTheReferences()
    {
        for (const Style &style : someStyles())
            for (double density = 1e-4; density < 20; density *= 1.013) {
                const double f = densityFunction(style, density);
                const double truth = reference::densityFunction(style.kind, xiOf(style), density);
                QVERIFY2(std::abs(f - truth) < 1e-12, qPrintable(QStringLiteral("%1: %2").arg(density).arg(f - truth)));
                const double kernel = math::withStyle<double>(
                    style.kind, [&](int i) { return double(style.xi[std::size_t(i)]); },
                    [&](const auto &s) { return math::meanOf(s, density, 0.0); });
                QVERIFY2(std::abs(f - kernel) < 2e-4,
                         qPrintable(QStringLiteral("%1: %2").arg(density).arg(f - kernel)));
            }
    }

    void cutsAreWhereTheStrokeEnds()
    {
        for (const Style &style : someStyles()) {
            const double cut = visibleCut(style);
            if (hasRim(style.kind)) {
                QVERIFY(std::abs(cut / reference::edgeCut(xiOf(style)) - 1) < 1e-12);
                double least = 1;
                for (double density = cut; density < 1e3; density *= 1.001)
                    least = std::min(least, densityFunction(style, density * 1.0001));
                QVERIFY(std::abs(least - leastInsideRim(style)) < 1e-4);
            } else {
                // The paper's F is ½ there; F̃ (17) is less by what it takes away to end at φ₀.
                const reference::Xi xi = xiOf(style);
                const double lowest = 1 / (1 + std::exp(std::min(xi[0], 8 * xi[1]) / xi[1]));
                const double half = style.kind == StyleKind::Uniform ? (0.5 - lowest) / (1 - lowest) : 0.5;
                QVERIFY(std::abs(densityFunction(style, cut) - half) < 1e-12);
            }
            // Behind a rim what is far inside comes back slowly.
            const double shown = densityFunction(style, plottedDensity(style)) / densityFunction(style, 1e6);
            QVERIFY(shown > (hasRim(style.kind) ? 0.75 : 0.95));
        }
    }

    void meansAreTheReferences()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> unit(0.01, 1);
        for (int trial = 0; trial < 200; ++trial) {
            LocalPaint paint;
            reference::LocalDensity truth;
            truth.granulation = 0;
            std::array<double, 3> shares{};
            std::array<reference::Xi, 3> xi{};
            for (int k = 0; k < 1 + trial % 5; ++k) {
                const Style &style = someStyles()[std::size_t(unit(random) * 9.9)];
                Segment s;
                s.granulation = float(unit(random));
                s.colour = {float(unit(random)), float(unit(random)), float(unit(random)), float(unit(random))};
                const double density = unit(random);
                paint.add(s, style, density);
                truth.density += density;
                truth.granulation += density * double(s.granulation);
                const double colour[] = {s.colour.red, s.colour.yellow, s.colour.blue, s.colour.opacity};
                for (std::size_t i = 0; i < 4; ++i)
                    truth.colour[i] += density * colour[i];
                shares[std::size_t(style.kind)] += density;
                for (std::size_t i = 0; i < 3; ++i)
                    xi[std::size_t(style.kind)][i] += density * double(style.xi[i]);
            }
            for (const StyleKind kind : styleKinds) {
                const std::size_t k = std::size_t(kind);
                if (!(shares[k] > 0))
                    continue;
                for (double &x : xi[k])
                    x /= shares[k];
                truth.styles[std::size_t(truth.styleCount++)] = {kind, shares[k] / truth.density, xi[k]};
            }
            truth.granulation /= truth.density;
            for (double &c : truth.colour)
                c /= truth.density;
            const double eta = unit(random);
            QVERIFY(std::abs(paint.granulation() - truth.granulation) < 1e-14);
            QVERIFY(std::abs(paint.coverage(eta) - reference::localDensityFunction(truth, eta, 0)) < 1e-12);
            QVERIFY(std::abs(paint.opacity(eta) - reference::paintOf(truth, eta, 0).opacity) < 1e-12);
        }
        const LocalPaint none;
        QCOMPARE(none.coverage(1), 0.0);
        QCOMPARE(none.opacity(0.5), 0.0);
        QCOMPARE(none.granulation(), 1.0);
    }

    void densityAtAPointIsTheProbes()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> place(-10, 70);
        int within = 0;
        for (int trial = 0; trial < 40; ++trial) {
            Painting painting;
            const StrokePtr stroke = someStroke(random, trial % 2);
            painting.strokes = {stroke};
            const Microseconds time = 700'000;
            double peak = 0;
            for (const Segment &s : stroke->segments)
                peak = std::max(peak, peakDensity(double(s.density), s.spread(time)));
            for (int k = 0; k < 20; ++k) {
                const Point at = stroke->origin + Offset{float(place(random)), float(place(random))};
                const Result<Probe> truth = probe(painting, time, at.x, at.y);
                QVERIFY(bool(truth));
                const double density = strokeDensityAt(*stroke, time, at);
                if (truth->strokes.empty()) {
                    QVERIFY(density < 1e-6 * peak);
                    continue;
                }
                ++within;
                const ProbeStroke &here = truth->strokes.front();
                QVERIFY2(std::abs(density - here.density) < 1e-3 * peak,
                         qPrintable(QStringLiteral("%1 of %2, peak %3").arg(density).arg(here.density).arg(peak)));
                QVERIFY(std::abs(seenPaint(*stroke, time, at).opacity - here.opacity) < 0.03);
            }
            QCOMPARE(strokeDensityAt(*stroke, 0, stroke->origin + stroke->segments[0].bezier[0]), 0.0);
        }
        QVERIFY(within > 300);
    }
};

QTEST_GUILESS_MAIN(TestPaint)
#include "test_paint.moc"

// The probe's numbers by hand, and the reference's paper.
#include "render/math/paper.h"
#include "render/probe.h"
#include "render/reference/density.h"
#include "render/reference/paper.h"
#include "render/reference/style.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace suffuse;
using reference::PaperField;

namespace {

/// A straight segment on the x axis, from 0 to 100, spread 5.
Stroke line(StrokeId id, Colour colour, float density = 10)
{
    Stroke stroke;
    stroke.id = id;
    stroke.name = QString("line %1").arg(id);
    Segment segment;
    segment.bezier = {{{0, 0}, {25, 0}, {75, 0}, {100, 0}}};
    segment.diffusion = 6.25f;
    segment.density = density;
    segment.colour = colour;
    stroke.segments = {segment};
    return stroke;
}

Painting paintingOf(std::vector<Stroke> strokes)
{
    Painting painting;
    for (Stroke &stroke : strokes)
        painting.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    return painting;
}

Paper proceduralPaper()
{
    Paper paper;
    paper.kind = PaperKind::Procedural;
    paper.seed = 42;
    paper.scale = 24;
    paper.strength = 0.8f;
    return paper;
}

} // namespace

class TestProbe : public QObject {
    Q_OBJECT

private slots:
    void oneStrokeByHand()
    {
        const Painting painting = paintingOf({line(7, {1, 0, 0, 0.5f})});
        const auto result = probe(painting, painting.end(), 40, 3);
        QVERIFY(bool(result));
        QCOMPARE(result->paper, 1.0);
        QCOMPARE(result->rybBefore, (std::array<double, 3>{0, 0, 0}));
        QCOMPARE(result->rgbBefore, (std::array<double, 3>{1, 1, 1}));
        QCOMPARE(result->strokes.size(), std::size_t(1));
        const ProbeStroke &stroke = result->strokes[0];
        QCOMPARE(stroke.id, StrokeId(7));
        QCOMPARE(stroke.name, QString("line 7"));
        const double density = reference::straightDensity(100, 5, 10, 40, 3);
        QVERIFY(std::abs(stroke.density - density) < 1e-12);
        QCOMPARE(stroke.modulated, stroke.density); // ω = 1
        const double f = reference::densityFunction(StyleKind::Uniform, {0.5f, 0.05f, 0}, density);
        QVERIFY(std::abs(stroke.densityFunction - f) < 1e-11);
        QVERIFY(std::abs(stroke.opacity - 0.5 * f) < 1e-11);
        QVERIFY(std::abs(stroke.rybAfter[0] - 0.5 * f) < 1e-11);
        QVERIFY(std::abs(stroke.rgbAfter[1] - (1 - 0.5 * f)) < 1e-11);
        QCOMPARE(stroke.shares.size(), std::size_t(1));
        QCOMPARE(stroke.shares[0].share, 1.0);
    }

    void strokesStandFromBottomToTop()
    {
        Stroke hidden = line(3, {0, 0, 1, 1});
        hidden.visible = false;
        Stroke far = line(4, {0, 0, 1, 1});
        far.origin = {0, 500};
        Stroke pigment = line(5, {0, 0, 1, 1});
        pigment.mix = {MixMode::Beta, 1};
        Painting painting = paintingOf({line(2, {0, 1, 0, 1}), hidden, far, pigment});
        painting.canvas.background = {0.5f, 0, 0, 0.5f};
        const auto result = probe(painting, painting.end(), 50, 0);
        QVERIFY(bool(result));
        QCOMPARE(result->rybBefore[0], 0.25);
        QCOMPARE(result->strokes.size(), std::size_t(2));
        QCOMPARE(result->strokes[0].id, StrokeId(2));
        QCOMPARE(result->strokes[1].id, StrokeId(5));
        const double w = result->strokes[0].opacity;
        QVERIFY(w > 0.99);
        QVERIFY(std::abs(result->strokes[0].rybAfter[0] - (1 - w) * 0.25) < 1e-12);
        // Pigment over yellow keeps it: green.
        QVERIFY(std::abs(result->strokes[1].rybAfter[1] - w) < 1e-12);
        QVERIFY(std::abs(result->strokes[1].rgbAfter[1] - 1) < 0.01);
        QVERIFY(probe(painting, painting.end(), 50, -300)->strokes.empty());
        QVERIFY(probe(painting, -1, 50, 0)->strokes.empty()); // before they were born
    }

    /// Shares go through the tree of groups that blend, and the final colour is that of the picture.
    void groupsThatBlend()
    {
        Stroke below = line(1, {0, 1, 0, 1}), above = line(2, {1, 0, 0, 1});
        above.group = 7;
        Painting painting = paintingOf({below, above});
        Group group;
        group.id = 7;
        const double w = probe(painting, painting.end(), 50, 0)->strokes[0].opacity;
        QVERIFY(w > 0.99);
        for (const BlendMode mode : {BlendMode::Normal, BlendMode::Multiply, BlendMode::SourceAtop,
                                     BlendMode::DestinationIn, BlendMode::DestinationOut, BlendMode::Plus}) {
            group.opacity = 0.25f, group.blend = mode;
            painting.groups = {group};
            const auto found = probe(painting, painting.end(), 50, 0);
            QVERIFY(bool(found));
            const double lower = found->strokes[0].colourShare, upper = found->strokes[1].colourShare;
            QVERIFY(std::abs(lower + upper + found->canvasShare - 1) < 1e-12);
            const bool takes = mode == BlendMode::DestinationIn || mode == BlendMode::DestinationOut;
            const double kept = mode == BlendMode::DestinationIn ? 0.25 : mode == BlendMode::Plus ? 0.8 : 0.75;
            QVERIFY2(std::abs(lower - kept) < 0.02, qPrintable(QString::number(lower)));
            QVERIFY2(std::abs(upper - (takes ? 0 : 1 - kept)) < 0.02, qPrintable(QString::number(upper)));
            QCOMPARE(found->strokes[1].rybAfter, (std::array<double, 3>{w, 0, 0})); // of the group, over white
            // A point above all strokes is touched by what acts everywhere alone.
            QCOMPARE(reaching(painting, painting.end(), {50, 300}).strokes.size(),
                     std::size_t(mode == BlendMode::DestinationIn ? 2 : 0));
        }
        // Yellow, a quarter of red over it: (1, 1 − ¼, 0) in RGB.
        group.blend = BlendMode::Normal;
        painting.groups = {group};
        const auto found = probe(painting, painting.end(), 50, 0);
        QVERIFY(std::abs(found->rgbAfter[0] - 1) < 0.01 && std::abs(found->rgbAfter[1] - 0.75) < 0.01);
    }

    void segmentsShareByDensity()
    {
        Stroke stroke = line(1, {1, 0, 0, 1});
        stroke.segments.push_back(stroke.segments[0]);
        stroke.segments[1].bezier = {{{100, 0}, {125, 0}, {175, 0}, {200, 0}}};
        stroke.segments[1].colour = {0, 0, 1, 0.5f};
        stroke.segments[1].granulation = 0.25f;
        stroke.segments[1].style = Style{StyleKind::Feathering, {2, 1, 0}};
        const Painting painting = paintingOf({stroke});
        const ProbeStroke here = probe(painting, painting.end(), 101, 1)->strokes.at(0);
        QCOMPARE(here.shares.size(), std::size_t(2));
        const double a = reference::straightDensity(100, 5, 10, 101, 1),
                     b = reference::straightDensity(100, 5, 10, 1, 1);
        QVERIFY(std::abs(here.shares[0].share - a / (a + b)) < 1e-12);
        QVERIFY(std::abs(here.density - (a + b)) < 1e-12);
        QVERIFY(std::abs(here.granulation - (a + 0.25 * b) / (a + b)) < 1e-12);
        QVERIFY(std::abs(here.colour[0] - a / (a + b)) < 1e-12);
        QVERIFY(std::abs(here.colour[3] - (a + 0.5 * b) / (a + b)) < 1e-12);
        // F = Σ share_kind · F_kind(φ′; ξ̄_kind)
        const double f = a / (a + b) * reference::densityFunction(StyleKind::Uniform, {0.5f, 0.05f, 0}, a + b) +
                         b / (a + b) * std::min(1.0, (a + b) / 2);
        QVERIFY(std::abs(here.densityFunction - f) < 1e-11);
    }

    void agesCountForTheSpread()
    {
        Stroke stroke = line(1, {1, 0, 0, 1});
        stroke.segments[0].born = 1'000'000;
        const Painting painting = paintingOf({stroke});
        QVERIFY(probe(painting, 1'000'000, 50, 0)->strokes.empty());
        for (double age : {0.25, 0.5, 1.0, 3.0}) {
            const double s = std::sqrt(4 * 6.25 * std::min(age, 1.0));
            const ProbeStroke here = probe(painting, 1'000'000 + toMicroseconds(age), 50, 2)->strokes.at(0);
            QVERIFY(std::abs(here.density - reference::straightDensity(100, s, 10, 50, 2)) < 1e-12);
        }
    }

    void granulationShowsThePaper()
    {
        Stroke stroke = line(1, {1, 0, 0, 1});
        stroke.segments[0].granulation = 0.25f;
        Painting painting = paintingOf({stroke});
        painting.canvas.paper = proceduralPaper();
        const auto result = probe(painting, painting.end(), 40, 1);
        const double eta = PaperField(painting.canvas.paper, nullptr).at({40, 1}, 0);
        QCOMPARE(result->paper, eta);
        QVERIFY(eta < 1);
        const ProbeStroke &here = result->strokes.at(0);
        QVERIFY(std::abs(here.modulated - (0.75 * eta + 0.25) * here.density) < 1e-14);
    }

    void paperIsBoundedAndSharp_data()
    {
        QTest::addColumn<int>("grain");
        QTest::addRow("tooth") << int(PaperGrain::Tooth);
        QTest::addRow("fibres") << int(PaperGrain::Fibres);
        QTest::addRow("weave") << int(PaperGrain::Weave);
    }

    void paperIsBoundedAndSharp()
    {
        QFETCH(int, grain);
        Paper paper = proceduralPaper();
        paper.grain = PaperGrain(grain);
        const PaperField field(paper, nullptr);
        std::mt19937_64 engine(3);
        std::uniform_real_distribution<double> any(-1e4, 1e4);
        double least = 1, greatest = 0, sum = 0, differences = 0;
        for (int i = 0; i < 20000; ++i) {
            const Point at{any(engine), any(engine)};
            const double eta = field.at(at, 0.5);
            least = std::min(least, eta);
            greatest = std::max(greatest, eta);
            sum += eta / 20000;
            differences += std::abs(field.at(at + Point{0.01, 0}, 0) - field.at(at, 0)) / 20000;
            // The program's is the same.
            QVERIFY(std::abs(math::proceduralPaper(at.x, at.y, 0.5, grain, paper.seed, double(paper.scale),
                                                   double(paper.strength)) -
                             eta) < 1e-9);
        }
        const double floor = 1 - double(paper.strength);
        QVERIFY(least >= floor - 1e-15 && greatest <= 1);
        QVERIFY(least < floor + 0.05 && greatest > 0.95);
        QVERIFY(std::abs(sum - (1 - 0.5 * double(paper.strength))) < 0.04);
        QVERIFY(differences > 1e-3); // a hundredth of a unit shows detail of its own
    }

    void paperGradientsFollowTheHash()
    {
        // By hand: (0, 0) of layer 0 with seed 0 hashes to 0.
        QCOMPARE(reference::paperGradient(0, 0, 0, 0), (Point{-1, -1}));
        const auto mix = [](std::uint64_t z) {
            z = (z ^ (z >> 16)) * 0x7FEB352Dull % 0x100000000ull;
            z = (z ^ (z >> 15)) * 0x846CA68Bull % 0x100000000ull;
            return z ^ (z >> 16);
        };
        const std::uint64_t m = 0x100000000ull;
        for (std::uint64_t x : {1ull, 77ull, 0xFFFFFFFFull}) {
            const std::uint64_t seeded = (9 * 0x9E3779B9ull + 3 * 0x85EBCA6Bull) % m;
            const std::uint64_t h = mix(mix(seeded ^ (x * 0xC2B2AE35ull % m)) ^ (5 * 0x27D4EB2Full % m));
            const Point expected{double(h % 65536) / 32768 - 1, double(h / 65536) / 32768 - 1};
            QCOMPARE(reference::paperGradient(std::uint32_t(x), 5, 3, 9), expected);
        }
        // Next to a lattice point of the coarsest octave, seen from so far that it alone fades in: R(u, v) + ½ = (−2,
        // 3) has (u, v) = (0.5, 3.5).
        const Paper paper = proceduralPaper();
        const double step = 1e-3;
        const Point gradient = reference::paperGradient(0xFFFFFFFEu, 3, 0, paper.seed);
        const Point moved{0.6 * step, 0.8 * step}; // R of a step to the right
        const double t = (24.0 / 8 - 2) / 3, share = t * t * (3 - 2 * t);
        const double n = 2.5 * share * dot(gradient, moved);
        const double eta = PaperField(paper, nullptr).at(24.0 * Point{0.5 + step, 3.5}, 8);
        QVERIFY(std::abs(eta - (1 - double(paper.strength) * (0.5 + 0.5 * n))) < 1e-8);
    }

    void paperIsContinuousInPlaceAndZoom_data() { paperIsBoundedAndSharp_data(); }

    void paperIsContinuousInPlaceAndZoom()
    {
        QFETCH(int, grain);
        Paper paper = proceduralPaper();
        paper.grain = PaperGrain(grain);
        const PaperField field(paper, nullptr);
        // Along lines over many cells of all layers.
        for (double x = -30; x < 30; x += 0.01) {
            QVERIFY(std::abs(field.at({x, 7}, 1) - field.at({x + 1e-7, 7}, 1)) < 1e-6);
            QVERIFY(std::abs(field.at({7, x}, 1) - field.at({7, x + 1e-7}, 1)) < 1e-6);
        }
        // Layers fade in: no jump while zooming.
        double previous = field.at({100.3, 55.1}, 40);
        for (double px = 40; px > 0.01; px *= 0.9995) {
            const double eta = field.at({100.3, 55.1}, px);
            QVERIFY(std::abs(eta - previous) < 3e-3);
            previous = eta;
        }
        QCOMPARE(field.at({100.3, 55.1}, 100), 1 - double(0.8f) * 0.5); // too far for any layer
        Paper other = paper;
        other.seed = 43;
        QVERIFY(field.at({100.3, 55.1}, 1) != PaperField(other, nullptr).at({100.3, 55.1}, 1));
        other = paper;
        other.grain = PaperGrain((grain + 1) % 3);
        QVERIFY(field.at({100.3, 55.1}, 1) != PaperField(other, nullptr).at({100.3, 55.1}, 1));
    }

    void paperHasNoDirectionOfThePixels()
    {
        // A pixel and its neighbour right differ no more nor less than it and its neighbour across a corner.
        const PaperField field(proceduralPaper(), nullptr);
        const auto difference = [&](Point step) {
            double sum = 0;
            for (int i = 0; i < 20000; ++i) {
                const Point at{(i % 141) * 37.7, (i / 141) * 41.3};
                sum += std::abs(field.at(at + step, 5) - field.at(at, 5));
            }
            return sum;
        };
        const double along = difference({6, 0}), down = difference({0, 6}), across = difference({4.2426, 4.2426});
        QVERIFY2(std::abs(along / across - 1) < 0.05 && std::abs(down / across - 1) < 0.05,
                 qPrintable(QString("%1 %2 %3").arg(along).arg(down).arg(across)));
    }

    void farAndFinePaperIsFinite()
    {
        Paper paper = proceduralPaper();
        paper.scale = 1e-6f;
        const double eta = PaperField(paper, nullptr).at({-1e6, 1e6}, 0);
        QVERIFY(eta >= 1 - double(paper.strength) - 1e-15 && eta <= 1);
    }

    void imagePaperIsBilinearAndRepeats()
    {
        Paper paper;
        paper.kind = PaperKind::Image;
        paper.scale = 10;
        paper.strength = 0.5f;
        auto texture = std::make_shared<PaperTexture>(PaperTexture{2, 2, {0.0f, 1.0f, 0.5f, 0.25f}});
        const PaperField field(paper, texture);
        const auto etaOf = [](double grey) { return 1 - 0.5 * (1 - grey); };
        QVERIFY(std::abs(field.at({5, 5}, 1) - etaOf(0)) < 1e-15);
        QVERIFY(std::abs(field.at({15, 5}, 1) - etaOf(1)) < 1e-15);
        QVERIFY(std::abs(field.at({5, 15}, 1) - etaOf(0.5)) < 1e-15);
        QVERIFY(std::abs(field.at({10, 5}, 1) - etaOf(0.5)) < 1e-15);
        QVERIFY(std::abs(field.at({10, 10}, 1) - etaOf(1.75 / 4)) < 1e-15);
        QVERIFY(std::abs(field.at({-5, 5}, 1) - etaOf(1)) < 1e-15); // left of 0: the right column again
        QVERIFY(std::abs(field.at({5 + 20 * 7, 15 - 20 * 9}, 1) - etaOf(0.5)) < 1e-15);
        paper.strength = 0;
        QCOMPARE(PaperField(paper, texture).at({3, 4}, 1), 1.0);
    }
};

QTEST_GUILESS_MAIN(TestProbe)
#include "test_probe.moc"

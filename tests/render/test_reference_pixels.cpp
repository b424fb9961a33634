// Whole pictures of the reference against one pixel at a time: every sample by the adaptive integral, in canvas units.
#include "model/painting/influence.h"
#include "model/painting/validate.h"
#include "render/reference/density.h"
#include "render/reference/local_paint.h"
#include "render/reference/paper.h"
#include "render/reference/reference.h"
#include "tests/render/paintings.h"

#include <QtTest>

#include <numbers>
#include <random>

using namespace suffuse;
using namespace suffuse::reference;

namespace {

/// The stroke of one style at a canvas point; the slope is per unit.
LocalDensity localDensity(const Stroke &stroke, Microseconds time, Point x)
{
    LocalDensity local;
    local.granulation = 0;
    Point gradient;
    for (const Segment &segment : stroke.segments) {
        const double s = segment.spread(time);
        const Kernel kernel = segment.isIsotropic()
                                  ? isotropicKernel(s)
                                  : anisotropicKernel(s, segment.anisotropyRatio, segment.anisotropyAngle);
        const DensityAndGradient d = segmentDensity(stroke.cubicOf(segment), kernel, segment.density, x);
        const Colour &c = segment.colour;
        const std::array<double, 4> colour{c.red, c.yellow, c.blue, c.opacity};
        local.density += d.density;
        gradient = gradient + d.gradient;
        local.granulation += d.density * double(segment.granulation);
        for (std::size_t i = 0; i < 4; ++i)
            local.colour[i] += d.density * colour[i];
    }
    if (!(local.density > 0))
        return local;
    local.granulation /= local.density;
    for (double &c : local.colour)
        c /= local.density;
    local.slope = length(gradient);
    local.styleCount = 1;
    local.styles[0] = {stroke.style.kind, 1, {stroke.style.xi[0], stroke.style.xi[1], stroke.style.xi[2]}};
    return local;
}

/// k of the supersampling rule, as docs/reference.md words it.
int levelAt(const Stroke &stroke, Microseconds time, const View &view, Point centre)
{
    const bool parallel = std::abs(std::remainder(view.rotation, std::numbers::pi / 2)) < 1e-12;
    const double half = parallel ? view.px() / 2 : view.px() / std::numbers::sqrt2;
    int level = 0;
    for (const Segment &segment : stroke.segments) {
        const double s = segment.spread(time) * std::sqrt(std::min(1.0, double(segment.anisotropyRatio)));
        int k = 0;
        while (k < 6 && std::ldexp(s, k) < view.px())
            ++k;
        if (influenceOf(stroke, segment, time).grown(half).contains(centre))
            level = std::max(level, k);
    }
    return level;
}

std::array<double, 4> pixelColour(const Painting &painting, const View &view, int column, int row, bool transparent)
{
    const Microseconds time = painting.end();
    const PaperField paper(painting.canvas.paper, nullptr);
    Spot spot = bareSpot(painting.canvas.background, transparent);
    for (const StrokePtr &stroke : painting.strokes) {
        const int n = 1 << levelAt(*stroke, time, view, view.toCanvas({column + 0.5, row + 0.5}));
        reference::Paint sum;
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const Point x = view.toCanvas({column + (i + 0.5) / n, row + (j + 0.5) / n});
                const reference::Paint paint =
                    paintOf(localDensity(*stroke, time, x), paper.at(x, view.px() / n), view.px() / n);
                sum.opacity += paint.opacity;
                for (std::size_t c = 0; c < 3; ++c)
                    sum.colour[c] += paint.opacity * paint.colour[c];
            }
        }
        for (double &c : sum.colour)
            c = sum.opacity > 0 ? c / sum.opacity : 0;
        sum.opacity /= n * n;
        mix(spot, stroke->mix, sum);
    }
    return storedColour(spot, transparent);
}

} // namespace

class TestReferencePixels : public QObject {
    Q_OBJECT

    std::mt19937_64 m_engine{5};

    double linear(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(m_engine); }
    double logarithmic(double lo, double hi) { return std::exp(linear(std::log(lo), std::log(hi))); }

    Style anyStyle(int i)
    {
        const double xi1 = logarithmic(0.05, 5);
        switch (i % 3) {
        case 0:
            return {StyleKind::Uniform, {float(xi1), float(xi1 * logarithmic(1e-3, 1)), 0}};
        case 1:
            return {StyleKind::Feathering, {float(xi1), float(logarithmic(0.5, 60)), 0}};
        default:
            return {StyleKind::Edge, {float(xi1), float(xi1 * linear(0.1, 1.25)), float(linear(0.1, 1))}};
        }
    }

    /// Two strokes of any shape, spread and style, from hairlines to fogs; on paper.
    PaintingPtr anyPainting(int i)
    {
        auto painting = std::make_shared<Painting>();
        painting->canvas.width = painting->canvas.height = 32;
        painting->canvas.paper.kind = PaperKind::Procedural;
        painting->canvas.background = {0.2f, 0.1f, 0.5f, 0.5f};
        for (int n = 0; n < 2; ++n) {
            const auto shape = test::allShapes[std::size_t(i + n) % std::size(test::allShapes)];
            const double spread = i % 2 ? logarithmic(2, 40) : logarithmic(0.1, 2);
            Stroke stroke = test::stroke(StrokeId(n + 1), shape, {linear(8, 24), linear(8, 24)}, linear(4, 14), spread,
                                         anyStyle(i + n), n ? Mix{MixMode::Beta, 0.5f} : Mix{});
            for (Segment &segment : stroke.segments) {
                segment.density = float(double(segment.density) * logarithmic(0.2, 1e4));
                segment.granulation = float(linear(0, 1));
                segment.colour = {float(linear(0, 1)), float(linear(0, 1)), float(linear(0, 1)), float(linear(0.3, 1))};
                if (i % 4 == 1) {
                    segment.anisotropyRatio = float(logarithmic(0.05, 20));
                    segment.anisotropyAngle = float(linear(0, 6));
                }
            }
            painting->strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        return painting;
    }

private slots:
    void picturesMatchPixelsByBruteForce()
    {
        int painted = 0;
        for (int i = 0; i < 48; ++i) {
            const PaintingPtr painting = anyPainting(i);
            QCOMPARE(problemOf(*painting), QString());
            View view = View::ofArea(painting->canvas.area(), 16, 16);
            view.rotation = i % 3 == 1 ? linear(0, 6) : 0;
            view.mirrored = i % 5 == 1;
            const bool transparent = i % 6 == 5;
            FloatPicture picture;
            const auto stats =
                makeReferenceRenderer(2)->render({painting, painting->end(), view, transparent}, picture);
            QVERIFY(bool(stats));
            for (int n = 0; n < 4; ++n) {
                const int x = int(linear(0, 16)), y = int(linear(0, 16));
                const auto expected = pixelColour(*painting, view, x, y, transparent);
                for (std::size_t c = 0; c < 4; ++c) {
                    // Straight colour of next to no paint has no digits left to compare.
                    const double weight = c < 3 ? expected[3] : 1;
                    const double off = std::abs(picture.at(x, y)[c] - expected[c]) * weight;
                    QVERIFY2(off < 1e-6, qPrintable(QString("%1 (%2, %3): %4").arg(i).arg(x).arg(y).arg(off)));
                }
                painted += std::abs(expected[3] - 1) > 1e-3 || std::abs(expected[0] - 0.9) > 0.05;
            }
        }
        QVERIFY(painted > 60); // not all of it empty canvas
    }
};

QTEST_GUILESS_MAIN(TestReferencePixels)
#include "test_reference_pixels.moc"

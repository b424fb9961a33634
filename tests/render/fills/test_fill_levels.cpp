// Where a thin fill is supersampled: at the pixels whose squares, grown by four spreads, it bounds. On paper a pixel in
// the middle of paint looks otherwise by one sample than by four, so that the last of these pixels show.
#include "render/reference/fill_source.h"
#include "tests/render/filled.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

constexpr Microseconds dry = 1'000'000;
const Rect sheet = Rect::of(0, 0, 64, 48);
const View view = View::ofArea(sheet, 64, 48);

const Style edge{StyleKind::Edge, {0.5292f, 0.5027f, 0.72f}};

/// Whether a line runs through the inside of a rectangle; by how far its part there is from being none, px. Negative:
/// so far it is away.
double depthOf(Point a, Point b, const Rect &r)
{
    // The largest rectangle of the family r grown by −d that the line still meets: by halving, of what is exact.
    const auto meets = [&](double d) {
        double from = 0, to = 1;
        const auto cut = [&](double start, double way, double low, double high) {
            if (way == 0) {
                if (!(start > low && start < high))
                    to = -1;
                return;
            }
            const double p = (low - start) / way, q = (high - start) / way;
            from = std::max(from, std::min(p, q)), to = std::min(to, std::max(p, q));
        };
        cut(a.x, b.x - a.x, r.left + d, r.right - d);
        cut(a.y, b.y - a.y, r.top + d, r.bottom - d);
        return from < to;
    };
    double low = -1, high = 0.5 * r.width();
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (meets(middle) ? low : high) = middle;
    }
    return low;
}

/// A triangle one of whose sides passes a corner of a pixel's grown square at some distance, negative: outside of it.
std::vector<Point> triangleAt(std::mt19937_64 &random, double s, double distance)
{
    std::uniform_real_distribution<double> u(0, 1);
    const Point centre{std::floor(20 + 24 * u(random)) + 0.5, std::floor(15 + 18 * u(random)) + 0.5};
    const double angle = 2 * 3.14159265358979 * u(random), half = 0.5 + 4 * s;
    const Point n{std::cos(angle), std::sin(angle)}, t{-n.y, n.x};
    const Point corner = centre + Point{std::copysign(half, n.x), std::copysign(half, n.y)};
    const Point on = corner + (-distance) * n;
    return {on + (50 + 20 * u(random)) * t, on + (-50 - 20 * u(random)) * t, on + (-60 - 10 * u(random)) * n};
}

} // namespace

class TestFillLevels : public QObject {
    Q_OBJECT

private slots:
    void referenceAgainstClippedLines()
    {
        std::mt19937_64 random(3 + firstSeed());
        std::uniform_real_distribution<double> u(-1, 1);
        int decided = 0, isNear = 0;
        for (int i = 0; i < trials(300, 20'000); ++i) {
            const double s = 0.75 + 0.24 * u(random), distance = 0.02 * u(random) * std::abs(u(random));
            Stroke stroke = emptyFill(1, s, edge);
            addPolygon(stroke, triangleAt(random, s, distance));
            const double spread = std::sqrt(4 * double(stroke.fill->diffusion));
            const reference::FillSource source(stroke, dry, view, 6.5);
            for (int k = 0; k < 40; ++k) {
                const Rect pixel = Rect::of(std::floor(32 + 20 * u(random)), std::floor(24 + 16 * u(random)), 1, 1);
                const Rect square = pixel.grown(4 * spread);
                double depth = -1;
                std::vector<Point> corners;
                for (const Segment &g : stroke.segments)
                    corners.push_back(stroke.origin + g.bezier[0]);
                corners.push_back(stroke.origin + stroke.segments.back().bezier[3]);
                for (std::size_t c = 0; c < corners.size(); ++c)
                    depth = std::max(depth, depthOf(corners[c], corners[(c + 1) % corners.size()], square));
                if (std::abs(depth) < 1e-7)
                    continue;
                ++decided, isNear += depth > 0;
                QVERIFY2(source.isNear(pixel) == (depth > 0), qPrintable(QString::number(depth)));
            }
        }
        QVERIFY(isNear > decided / 10 && isNear < decided);
    }

    /// What bounds nothing makes nothing near: lines there and back, and outlines within outlines.
    void whatBoundsNothingIsNotNear()
    {
        Stroke stroke = emptyFill(1, 0.75, edge);
        addRectangle(stroke, Rect::of(4, 4, 56, 40));
        addRectangle(stroke, Rect::of(20, 15, 10, 8));
        addPolygon(stroke, {{32, 10}, {50, 40}, {32, 10}});
        const reference::FillSource source(stroke, dry, view, 6.5);
        for (const Point p : {Point{22, 17}, {25, 20}, {40, 23}, {33, 12}})
            QVERIFY(!source.isNear(Rect::of(p.x, p.y, 1, 1)));
        // Sides that the square only touches are not in it: 4 s is 3 px.
        QVERIFY(source.isNear(Rect::of(6, 20, 1, 1)) && !source.isNear(Rect::of(7, 20, 1, 1)));
        QVERIFY(source.isNear(Rect::of(30, 6, 1, 1)) && !source.isNear(Rect::of(30, 7, 1, 1)));
        QVERIFY(source.isNear(Rect::of(1, 20, 1, 1)) && !source.isNear(Rect::of(0, 20, 1, 1)));
        QVERIFY(source.isNear(Rect::of(30, 46, 1, 1)) && !source.isNear(Rect::of(30, 47, 1, 1)));
    }

    void pictures()
    {
        const std::unique_ptr<Renderer> cpu = make(Backend::Cpu), reference = make(Backend::Reference);
        std::mt19937_64 random(11 + firstSeed());
        std::uniform_real_distribution<double> u(-1, 1);
        for (int i = 0; i < trials(40, 3'000); ++i) {
            const double s = i % 4 == 0 ? 0.75 : 0.85 + 0.35 * u(random); // three pixels, or anything
            Stroke stroke = emptyFill(1, s, i % 5 ? edge : randomStyle(random));
            if (i % 4 == 0)
                addRectangle(stroke, Rect::of(5, 6, 40 + i % 3, 30));
            else if (i % 4 == 3)
                addEllipse(stroke, {32 + 8 * u(random), 24 + 6 * u(random)}, 20 + 8 * u(random), 16 + 6 * u(random));
            else
                addPolygon(stroke, triangleAt(random, s, 0.01 * u(random) * std::abs(u(random))));
            changeFill(stroke, [](Fill &f) { f.granulation = 0.3f; });
            const PaintingPtr p = painting({stroke}, 64, 48, {PaperKind::Procedural, std::uint32_t(i), 3, 0.6f, {}});
            const Worst w = worst(test::render(*cpu, p, view, -1, false), test::render(*reference, p, view, -1, false));
            QVERIFY2(w.difference <= 1.0 / 512, qPrintable(QStringLiteral("%1: s %2, %3/512 at %4, %5")
                                                               .arg(i)
                                                               .arg(s)
                                                               .arg(512 * w.difference)
                                                               .arg(w.x)
                                                               .arg(w.y)));
        }
    }
};

QTEST_GUILESS_MAIN(TestFillLevels)
#include "test_fill_levels.moc"

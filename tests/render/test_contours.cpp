// Contours of strokes against the reference: that paths lie where the reference has the level, by bisection.
#include "render/contours/contours.h"

#include "model/paint/local_paint.h"
#include "render/contours/style_levels.h"
#include "render/reference/density.h"
#include "render/reference/fill_source.h"
#include "render/reference/stroke_source.h"
#include "render/reference/style.h"
#include "tests/render/filled.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include <QTest>

#include <random>

using namespace suffuse;
using namespace suffuse::contours;
using namespace suffuse::test;

namespace {

constexpr Microseconds end = 1'000'000'000;

/// What the reference has at a point of a stroke: what lays and takes away paint together.
class ReferenceStroke {
public:
    ReferenceStroke(const Stroke &stroke, double eta) : m_stroke(stroke), m_eta(eta)
    {
        for (const Segment &s : stroke.segments)
            m_kernels.push_back(
                s.isIsotropic() ? reference::isotropicKernel(s.spread(end))
                                : reference::anisotropicKernel(s.spread(end), s.anisotropyRatio, s.anisotropyAngle));
        if (!stroke.fill)
            return;
        View view;
        view.scale = 2 / stroke.fill->spread(end);
        view.width = view.height = int(600 * view.scale);
        view.centre = {300, 200};
        m_view = view;
        m_fill.emplace(stroke, end, view, reference::reachOf(stroke, end));
    }
    LocalPaint at(Point p) const
    {
        LocalPaint paint;
        for (std::size_t k = 0; k < m_kernels.size(); ++k) {
            const Segment &s = m_stroke.segments[k];
            const double density =
                s.density > 0
                    ? reference::segmentDensity(offsetsOf(s), m_kernels[k], s.density, p - m_stroke.origin).density
                    : 0;
            if (density > 0)
                paint.add(s, m_stroke.styleOf(s), density);
        }
        if (m_fill) {
            const reference::FillSample sample = m_fill->at(m_view.toPixels(p));
            paint.add(*m_stroke.fill, m_stroke.style, sample.density, sample.place);
        }
        return paint;
    }
    /// As far as it is left where paint is made paler.
    double coverage(Point p) const { return at(p).coverage(m_eta) * std::exp(-at(p).faded()); }
    double opacity(Point p) const { return at(p).opacity(m_eta); }

private:
    const Stroke &m_stroke;
    double m_eta;
    View m_view;
    std::vector<reference::Kernel> m_kernels;
    std::optional<reference::FillSource> m_fill;
};

struct Nearness {
    double worst = 0;
    Point at; ///< where that is
    int points = 0;

    bool isWithin(double tolerance) const { return worst <= tolerance + 1e-5; }
    QString text() const { return QStringLiteral("%1 at (%2, %3)").arg(worst).arg(at.x).arg(at.y); }
};

/// How far random points of loops lie from where a function comes to a level, by bisection across the loop.
template <class Function>
Nearness nearness(const Loops &loops, const Function &function, double level, int points, unsigned seed)
{
    std::vector<const Cubic *> curves;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &curve : loop)
            curves.push_back(&curve);
    Nearness result;
    if (curves.empty())
        return result;
    std::mt19937 random(seed + 1000 * firstSeed());
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (int i = 0; i < points; ++i) {
        const Cubic &curve = *curves[random() % curves.size()];
        const double t = anywhere(random);
        const Point p = curve.at(t), along = curve.derivative(t);
        const double size = length(along);
        if (!(size > 0))
            continue;
        const Point across = (1 / size) * Point{-along.y, along.x};
        const bool within = function(p) >= level;
        double near = 0, far = 1.0 / 1024;
        const auto isOther = [&](double d) {
            return (function(p + d * across) >= level) != within || (function(p - d * across) >= level) != within;
        };
        while (far < 1 && !isOther(far))
            near = far, far *= 2;
        while (far - near > 1e-5) {
            const double middle = 0.5 * (near + far);
            (isOther(middle) ? far : near) = middle;
        }
        if (far > result.worst)
            result.worst = far, result.at = p;
        ++result.points;
    }
    return result;
}

void checkClosed(const Loops &loops)
{
    for (const std::vector<Cubic> &loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            QCOMPARE(loop[i].p[3], loop[(i + 1) % loop.size()].p[0]);
}

/// Lines from a point to the right enter loops so often.
int windingOf(const Loops &loops, Point p)
{
    int winding = 0;
    for (const std::vector<Cubic> &loop : loops)
        for (const Cubic &c : loop)
            for (int i = 0; i < 64; ++i) {
                const Point a = c.at(i / 64.0), b = c.at((i + 1) / 64.0);
                if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x)
                    winding += a.y <= p.y ? 1 : -1;
            }
    return winding;
}

/// Whether the loops run once around what is at least at a level, and not around anything else.
template <class Function>
bool checkInside(const Loops &loops, const Function &function, double level)
{
    std::mt19937 random(3 + firstSeed());
    bool ok = true;
    const auto check = [&](Point p) {
        const double value = function(p);
        if (std::abs(value - level) > 0.02)
            QCOMPARE(windingOf(loops, p), value >= level ? 1 : 0);
        ok = true;
    };
    for (int i = 0; i < 60 && ok; ++i) {
        ok = false;
        check({150 + double(random() % 3000) / 10, 80 + double(random() % 2400) / 10});
    }
    return ok;
}

} // namespace

class TestContours : public QObject {
    Q_OBJECT

private slots:
    void stylesBackwards()
    {
        for (const StyleKind kind : styleKinds) {
            const Style style = test::styleOf(kind);
            for (const double level : {0.01, 0.3, 0.5, 0.9}) {
                const std::vector<double> at = crossingsOf(style, level);
                QVERIFY(!at.empty());
                for (std::size_t k = 0; k < at.size(); ++k) {
                    QCOMPARE(densityFunction(style, at[k] * (1 + 1e-9)) >= level, k % 2 == 0);
                    QCOMPARE(densityFunction(style, at[k] * (1 - 1e-9)) >= level, k % 2 == 1);
                }
            }
            const CoverageCurve curve(style);
            for (double density = 0.01; density < 3; density *= 1.01) {
                const CoverageCurve::Value value = curve.at(density);
                QVERIFY(std::abs(value.coverage - densityFunction(style, density)) < 1e-12);
                const double above = densityFunction(style, density + 1e-7),
                             below = densityFunction(style, density - 1e-7);
                if (value.coverage > 0 && value.coverage < 1 && above > 0 && below > 0 && above < 1)
                    QVERIFY(std::abs(value.slope - (above - below) / 2e-7) < 1e-4 * (1 + std::abs(value.slope)));
            }
            const std::vector<CoverageStep> steps = stepsOf(style, 64);
            for (double density = 1e-3; density < 5; density *= 1.003) {
                double shown = 0;
                for (const CoverageStep &step : steps)
                    if (step.density <= density)
                        shown = step.coverage;
                QVERIFY(std::abs(shown - densityFunction(style, density)) <= 1.0 / 128 + 1e-9);
            }
        }
    }

    void pathsLieOnTheContour_data()
    {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("kind");
        for (const Shape shape : {Shape::Straight, Shape::Curved, Shape::Looping, Shape::Cusped})
            for (const StyleKind kind : styleKinds)
                QTest::addRow("%d %d", int(shape), int(kind)) << int(shape) << int(kind);
    }
    void pathsLieOnTheContour()
    {
        QFETCH(int, shape);
        QFETCH(int, kind);
        Stroke s = stroke(1, Shape(shape), {300, 200}, 100, 12, test::styleOf(StyleKind(kind)));
        s.segments[1].granulation = 0.4f;
        s.segments[2].anisotropyRatio = 1.7f;
        s.segments[2].anisotropyAngle = 0.6f;
        const StrokeContours contours(s, end, {1.0 / 256, 0.8, nullptr});
        const ReferenceStroke exact(s, 0.8);
        int points = 0;
        for (const double level : {0.1, 0.5, 0.85}) {
            const Loops loops = contours.outline(level);
            checkClosed(loops);
            QVERIFY(!loops.empty());
            const Nearness near = nearness(
                loops, [&](Point p) { return exact.coverage(p); }, level, 280, unsigned(points));
            QVERIFY2(near.isWithin(1.0 / 256), qPrintable(near.text()));
            points += near.points;
            if (!checkInside(
                    loops, [&](Point p) { return exact.coverage(p); }, level))
                return;
        }
    }

    void bandsAreOpacities()
    {
        Stroke s = stroke(1, Shape::Curved, {300, 200}, 100, 12, test::styleOf(StyleKind::Uniform));
        s.segments[0].colour.opacity = 0.4f;
        const StrokeContours contours(s, end, {});
        const ReferenceStroke exact(s, 1);
        const std::vector<Band> bands = contours.bands(16);
        QVERIFY(bands.size() > 5);
        for (const Band &band : bands) {
            const double level = band.opacity - bands.front().opacity / 2;
            const Nearness near = nearness(
                band.loops, [&](Point p) { return exact.opacity(p); }, level, 60, 1);
            QVERIFY2(near.isWithin(1.0 / 256), qPrintable(near.text()));
        }
    }

    void otherStrokes_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : {"tiny", "huge", "hair", "lifted", "granulated and lifted", "faded", "faded fill",
                                 "mixed styles", "spread fill", "narrow fill", "fill with a line", "turned fill"})
            QTest::newRow(what) << what;
    }
    void otherStrokes()
    {
        QFETCH(QString, what);
        Stroke s = stroke(1, Shape::Curved, {300, 200}, 100, 12, test::styleOf(StyleKind::Uniform));
        if (what == "tiny")
            s = stroke(1, Shape::Tiny, {300, 200}, 10, 8, test::styleOf(StyleKind::Uniform));
        if (what == "huge")
            s = stroke(1, Shape::Huge, {300, 200}, 1000, 900, test::styleOf(StyleKind::Feathering));
        if (what == "hair")
            s = stroke(1, Shape::Curved, {300, 200}, 20, 0.02, test::styleOf(StyleKind::Uniform));
        if (what.contains("lifted")) {
            s.segments[1].lift = true;
            s.segments[1].density *= 0.7f;
            s.segments[1].bezier = s.segments[0].bezier;
            s.segments[1].bezier[1].x += 20;
            s.segments[1].start = true;
            s.segments[2].start = true;
        }
        if (what == "faded") {
            s.segments[1].fade = true;
            s.segments[1].density = 12;
            s.segments[1].bezier = s.segments[0].bezier;
            s.segments[1].bezier[1].x += 20;
            s.segments[1].start = true;
            s.segments[2].start = true;
        }
        if (what.startsWith("granulated"))
            s.segments[0].granulation = 0.2f;
        if (what == "mixed styles")
            s.segments[1].style = test::styleOf(StyleKind::Feathering);
        if (what.contains("fill")) {
            const double spread = what.startsWith("narrow") ? 0.5 : 10;
            s = emptyFill(1, spread, test::styleOf(StyleKind::Uniform));
            addEllipse(s, {300, 200}, 120, 70);
            addRectangle(s, Rect::of(280, 180, 50, 30), true);
        }
        if (what == "fill with a line")
            s.segments[2].density = 9;
        if (what == "faded fill") {
            s.segments[2].density = 9;
            s.segments[2].fade = true;
        }
        if (what == "turned fill") {
            Fill fill = *s.fill;
            fill.anisotropyRatio = 2, fill.anisotropyAngle = 0.7f;
            s.fill = fill;
        }
        const StrokeContours contours(s, end, {1.0 / 256, 0.8, nullptr});
        const ReferenceStroke exact(s, 0.8);
        for (const double level : {0.2, 0.5}) {
            const Loops loops = contours.outline(level);
            checkClosed(loops);
            QVERIFY(!loops.empty());
            const Nearness near = nearness(
                loops, [&](Point p) { return exact.coverage(p); }, level, what.contains("fill") ? 30 : 100, 7);
            QVERIFY2(near.isWithin(1.0 / 256), qPrintable(near.text()));
            if (!checkInside(
                    loops, [&](Point p) { return exact.coverage(p); }, level))
                return;
        }
    }

    void slopesAreThose()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> anywhere(-1, 1);
        for (const double spread : {0.5, 10.0})
            for (const float ratio : {1.0f, 2.0f}) {
                Stroke s = emptyFill(1, spread, test::styleOf(StyleKind::Uniform));
                addEllipse(s, {300, 200}, 120, 70);
                addRectangle(s, Rect::of(280, 180, 50, 30), true);
                changeFill(s, [&](Fill &fill) { fill.anisotropyRatio = ratio, fill.anisotropyAngle = 0.7f; });
                s.segments[1].density = 2;
                const StrokeField field(s, end, 1, 1.0 / 256);
                for (int i = 0; i < 400; ++i) {
                    const Point edge =
                        i % 2 == 0 ? Point{280, 195 + 14 * anywhere(random)} : Point{305 + 24 * anywhere(random), 180};
                    const Point p = edge + 2 * spread * Point{anywhere(random), anywhere(random)};
                    const double h = 1e-3 * spread;
                    const Point slope{
                        (field.modulatedAt(p + Point{h, 0}).value - field.modulatedAt(p - Point{h, 0}).value) / (2 * h),
                        (field.modulatedAt(p + Point{0, h}).value - field.modulatedAt(p - Point{0, h}).value) /
                            (2 * h)};
                    const Point own = field.modulatedAt(p).slope;
                    QVERIFY2(length(own - slope) * spread < 1e-3, qPrintable(QString("%1 %2: %3 %4, not %5 %6")
                                                                                 .arg(p.x)
                                                                                 .arg(p.y)
                                                                                 .arg(own.x)
                                                                                 .arg(own.y)
                                                                                 .arg(slope.x)
                                                                                 .arg(slope.y)));
                }
            }
    }

    void crispFillsAreTheirOutlines()
    {
        Stroke s = emptyFill(1, 0, test::styleOf(StyleKind::Uniform));
        addEllipse(s, {300, 200}, 60, 35);
        const std::vector<Band> bands = StrokeContours(s, end, {}).bands(16);
        QCOMPARE(bands.size(), 1u);
        QVERIFY(std::abs(bands.front().opacity - densityFunction(s.style, s.fill->density) * s.fill->colour.opacity) <
                1e-9);
        const Loops loops = StrokeContours(s, end, {}).outline(0.5);
        Rect box;
        for (const std::vector<Cubic> &loop : loops)
            for (const Cubic &c : loop)
                box = box.united(c.controlBox());
        QVERIFY(std::abs(box.width() - 120) < 1e-3 && std::abs(box.height() - 70) < 1e-3);

        // Paint of its segments lies around it, and what both cover is one area.
        s.segments[0].density = 6;
        const Loops both = StrokeContours(s, end, {}).outline(0.5);
        checkClosed(both);
        for (const Point p : {Point{300, 200}, Point{250, 190}})
            QVERIFY(windingOf(both, p) != 0);
    }

    void nothingWhereNothingIsCovered()
    {
        Stroke s = stroke(1, Shape::Curved, {300, 200}, 100, 12, test::styleOf(StyleKind::Uniform));
        for (Segment &segment : s.segments)
            segment.density *= 0.1f;
        QVERIFY(StrokeContours(s, end, {}).outline(0.5).empty());
        QVERIFY(StrokeContours(s, end, {}).bands(8).empty());
        QVERIFY(StrokeContours(s, 0, {}).outline(0.5).empty()); // of age 0
        for (Segment &segment : s.segments)
            segment.colour.opacity = 0;
        QVERIFY(StrokeContours(s, end, {}).bands(8).empty());
    }

    void stopsWhenCancelled()
    {
        const Stroke s = stroke(1, Shape::Looping, {300, 200}, 3000, 2, test::styleOf(StyleKind::Uniform));
        const std::atomic<bool> cancel = true;
        QVERIFY(StrokeContours(s, end, {1.0 / 256, 1, &cancel}).bands(64).empty());
    }
};

QTEST_GUILESS_MAIN(TestContours)
#include "test_contours.moc"

// Strokes of a painting made anew: where they go, what stays, and how near they come.
#include "model/painting/ryb.h"
#include "render/backends.h"
#include "render/fitting/fitting.h"
#include "render/fitting/picture_metrics.h"
#include "render/gradient/scene_gradient.h"
#include "render/refit/refit_target.h"

#include <QTest>

#include <cmath>

using namespace suffuse;
using namespace suffuse::refit;

namespace {

/// A soft stroke from one point to another.
Stroke strokeFrom(StrokeId id, Point from, Point to, const Colour &colour, double spread, GroupId group = 0)
{
    Stroke stroke;
    stroke.id = id;
    stroke.group = group;
    stroke.origin = from;
    stroke.style = {StyleKind::Feathering, {1, 1, 0}};
    Segment segment;
    for (std::size_t i = 0; i < 4; ++i)
        segment.bezier[i] = toOffset(from + (double(i) / 3) * (to - from), from);
    segment.maxAge = 1;
    segment.diffusion = float(spread * spread / 4);
    segment.density = float(2 * spread);
    segment.colour = colour;
    segment.born = Microseconds(id) * 1'000'000;
    stroke.segments.push_back(segment);
    return stroke;
}

constexpr Colour red{0.8f, 0.1f, 0.1f, 0.9f}, blue{0.1f, 0.2f, 0.8f, 0.7f}, dark{0.7f, 0.7f, 0.7f, 0.8f};

/// A blue stroke (1), eight thin red ones beside each other (2 to 9), and a dark one across all (10).
Painting eightBetween(GroupId group = 0)
{
    Painting painting;
    painting.canvas.width = 80, painting.canvas.height = 60;
    painting.canvas.background = {0, 0.1f, 0, 1};
    const auto add = [&](const Stroke &stroke) { painting.strokes.push_back(std::make_shared<const Stroke>(stroke)); };
    add(strokeFrom(1, {10, 50}, {70, 45}, blue, 8, group));
    for (int k = 0; k < 8; ++k)
        add(strokeFrom(StrokeId(2 + k), {20, 20 + 1.5 * k}, {55, 24 + 1.5 * k}, red, 2.5, group));
    add(strokeFrom(10, {40, 5}, {42, 55}, dark, 3, group));
    return painting;
}

std::unordered_set<StrokeId> redOnes()
{
    return {2, 3, 4, 5, 6, 7, 8, 9};
}

struct Refitted {
    Painting painting;
    RefitPictures::Difference before, after;
    double apart = 0; ///< mean square, of what the fit and the renderer draw of the area
    QString error;
};

Refitted refitted(const Painting &painting, const std::unordered_set<StrokeId> &ids, int strokes,
                  const RefitGoal &goal = {}, int steps = 200)
{
    Refitted out;
    const auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    const Result<RefitScope> scope = RefitScope::of(std::make_shared<const Painting>(painting), ids);
    if (!scope || !renderer)
        return {{}, {}, {}, 0, scope ? renderer.error() : scope.error()};
    const RefitPictures pictures(*scope, goal, **renderer, 20'000);
    Result<fitting::FitTarget> target = pictures.target();
    if (!target)
        return {{}, {}, {}, 0, target.error()};
    fitting::FitOptions options;
    options.strokes = strokes, options.steps = steps, options.threads = 1;
    fitting::Fitting fit(std::move(*target), options);
    while (fit.step()) {
    }
    const StrokeList made = placed(*scope, fit.painting());
    out.painting = scope->with(made);
    const Rect area = areaWith(*scope, made);
    const auto before = pictures.differenceOf(painting, area), after = pictures.differenceOf(out.painting, area);
    if (!before || !after)
        return {{}, {}, {}, 0, before ? after.error() : before.error()};
    out.before = *before, out.after = *after;
    return out;
}

} // namespace

class TestRefit : public QObject {
    Q_OBJECT

private slots:
    void eightStrokesBecomeTwo()
    {
        const Painting before = eightBetween();
        const Refitted now = refitted(before, redOnes(), 2);
        QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
        const Painting &painting = now.painting;
        QVERIFY(painting.strokes.size() >= 3 && painting.strokes.size() <= 4);
        QCOMPARE(painting.strokes.front(), before.strokes.front()); // the same objects
        QCOMPARE(painting.strokes.back(), before.strokes.back());
        for (std::size_t i = 1; i + 1 < painting.strokes.size(); ++i) {
            QVERIFY(painting.strokes[i]->id > 10);
            for (const Segment &segment : painting.strokes[i]->segments)
                QVERIFY(segment.born >= 2'000'000 && segment.born <= 9'000'000);
        }
        QCOMPARE(now.before.greatest, 0.0);
        QVERIFY2(now.after.rootMeanSquare < 2.5 && now.after.greatest < 25,
                 qPrintable(QStringLiteral("%1 %2").arg(now.after.rootMeanSquare).arg(now.after.greatest)));
    }

    /// What the fit draws on its ground is what the renderer draws of the painting below the highest of the new
    /// strokes.
    void theGroundIsThatOfThePainting()
    {
        Painting painting = eightBetween();
        painting.strokes.pop_back(); // Nothing lies above.
        const auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
        QVERIFY(renderer);
        const Result<RefitScope> scope = RefitScope::of(std::make_shared<const Painting>(painting), redOnes());
        QVERIFY(scope && !scope->hasAbove());
        const RefitGoal own;
        const RefitPictures pictures(*scope, own, **renderer, 20'000);
        Result<fitting::FitTarget> target = pictures.target();
        QVERIFY(target && target->weight.isEmpty() && target->onBlack.picture.isEmpty());
        const fitting::FitPicture wanted = target->picture;
        fitting::FitOptions options;
        options.strokes = 3, options.steps = 60, options.threads = 1;
        fitting::Fitting fit(std::move(*target), options);
        while (fit.step()) {
        }
        const double drawn = 255 * std::sqrt(fitting::meanSquare(fit.picture(), wanted));
        const auto is = pictures.differenceOf(scope->with(placed(*scope, fit.painting())), scope->area());
        QVERIFY(is);
        QVERIFY2(std::abs(is->rootMeanSquare - drawn) < 0.1 + 0.02 * drawn,
                 qPrintable(QStringLiteral("%1 %2").arg(is->rootMeanSquare).arg(drawn)));
    }

    /// Strokes that are made paler along a line become fewer that look so.
    void fadedStrokesBecomeFewer()
    {
        Painting painting = eightBetween();
        for (std::size_t i = 1; i < 9; ++i) {
            Stroke stroke = *painting.strokes[i];
            Segment fading = strokeFrom(1, {38, 10}, {38, 45}, red, 5).segments[0];
            for (Offset &at : fading.bezier)
                at = toOffset(Point{38, 10} + at, stroke.origin);
            fading.fade = fading.start = true;
            fading.born = stroke.segments[0].born;
            stroke.segments.push_back(fading);
            painting.strokes[i] = std::make_shared<const Stroke>(stroke);
        }
        const Refitted now = refitted(painting, redOnes(), 4);
        QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
        QVERIFY(now.painting.strokes.size() <= 6);
        QVERIFY2(now.after.rootMeanSquare < 4 && now.after.greatest < 40,
                 qPrintable(QStringLiteral("%1 %2").arg(now.after.rootMeanSquare).arg(now.after.greatest)));
    }

    /// On a sheet that lets through, on white and on black.
    void coverageIsKept()
    {
        for (const float opacity : {0.0f, 0.5f}) {
            Painting painting = eightBetween();
            painting.canvas.background.opacity = opacity;
            const Refitted now = refitted(painting, redOnes(), 3);
            QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
            QVERIFY2(now.after.rootMeanSquare < 4 && now.after.greatest < 40,
                     qPrintable(QStringLiteral("%1 %2").arg(now.after.rootMeanSquare).arg(now.after.greatest)));
        }
    }

    /// White strokes on nothing are seen on black alone.
    void whiteOnNothing()
    {
        Painting painting;
        painting.canvas.width = 60, painting.canvas.height = 40;
        painting.canvas.background.opacity = 0;
        for (int k = 0; k < 6; ++k)
            painting.strokes.push_back(std::make_shared<const Stroke>(
                strokeFrom(StrokeId(1 + k), {15, 15 + 2.0 * k}, {45, 15 + 2.0 * k}, {0, 0, 0, 0.9f}, 3)));
        const Refitted now = refitted(painting, {1, 2, 3, 4, 5, 6}, 2);
        QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
        QVERIFY(!now.painting.strokes.empty());
        QVERIFY2(now.after.rootMeanSquare < 5, qPrintable(QString::number(now.after.rootMeanSquare)));
    }

    void anIsolatedGroupIsAScopeOfItsOwn()
    {
        Painting painting = eightBetween(1);
        Group group;
        group.id = 1, group.opacity = 0.6f, group.name = "layer";
        painting.groups.push_back(group);
        const Refitted now = refitted(painting, redOnes(), 3);
        QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
        QVERIFY2(now.after.rootMeanSquare < 3, qPrintable(QString::number(now.after.rootMeanSquare)));
        QCOMPARE(now.painting.groups, painting.groups);
        for (const StrokePtr &stroke : now.painting.strokes)
            QCOMPARE(stroke->group, GroupId(1));
        RefitGoal goal;
        goal.painting = std::make_shared<const Painting>(eightBetween());
        QVERIFY(refitted(painting, redOnes(), 3, goal).error.contains("group like others"));
    }

    void aWholeGroupThatMixesInItsOwnWay()
    {
        for (const bool isWash : {false, true}) {
            Painting painting = eightBetween();
            Group outer, inner;
            outer.id = 4, outer.name = "outer";
            inner.id = 7, inner.parent = 4, inner.name = "inner";
            if (isWash)
                inner.wash = Wash{};
            else
                inner.opacity = 0.8f;
            painting.groups = {outer, inner};
            for (std::size_t i = 1; i < 9; ++i) {
                Stroke stroke = *painting.strokes[i];
                stroke.group = i < 3 ? 4 : 7;
                painting.strokes[i] = std::make_shared<const Stroke>(stroke);
            }
            const QString part = refitted(painting, {2, 3, 4}, 1).error;
            QVERIFY2(part.contains("“inner”"), qPrintable(part));
            const Refitted now = refitted(painting, redOnes(), 3);
            QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
            QVERIFY2(now.after.rootMeanSquare < 4, qPrintable(QString::number(now.after.rootMeanSquare)));
            QCOMPARE(now.painting.groups.size(), std::size_t(2));
            QVERIFY(!now.painting.groups[1].isIsolated() && !now.painting.groups[1].wash);
            QCOMPARE(now.painting.strokes[1]->group, GroupId(7));
        }
    }

    /// Whoever is shown alone stays so; a group that is left empty goes.
    void groupsAfterwards()
    {
        Painting painting = eightBetween();
        Group alone, other;
        alone.id = 3, alone.solo = true, alone.opacity = 0.5f;
        other.id = 5, other.parent = 3;
        painting.groups = {alone, other};
        for (std::size_t i = 1; i < 9; ++i) {
            Stroke stroke = *painting.strokes[i];
            stroke.group = i < 5 ? 5 : 3;
            painting.strokes[i] = std::make_shared<const Stroke>(stroke);
        }
        const Result<RefitScope> scope =
            RefitScope::of(std::make_shared<const Painting>(painting), {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
        QVERIFY(scope);
        QCOMPARE(scope->count(), std::size_t(8)); // The others are hidden.
        QVERIFY(!scope->isWholePainting());
        const Painting now = scope->with({std::make_shared<const Stroke>(strokeFrom(1, {1, 1}, {9, 9}, red, 2))});
        QCOMPARE(now.groups, std::vector<Group>{alone});
        QCOMPARE(now.strokes.size(), std::size_t(3));
        QCOMPARE(now.strokes[1]->group, GroupId(3));
    }

    void whatLiesBetweenLiesBelow()
    {
        const Painting painting = eightBetween();
        const Result<RefitScope> scope = RefitScope::of(std::make_shared<const Painting>(painting), {2, 5, 9});
        QVERIFY(scope);
        QCOMPARE(scope->count(), std::size_t(3));
        QCOMPARE(scope->between(), std::size_t(5));
        const Painting now = scope->with({std::make_shared<const Stroke>(strokeFrom(1, {1, 1}, {9, 9}, red, 2))});
        std::vector<StrokeId> order;
        for (const StrokePtr &stroke : now.strokes)
            order.push_back(stroke->id);
        QCOMPARE(order, (std::vector<StrokeId>{1, 3, 4, 6, 7, 8, 11, 10}));
    }

    /// A goal for the whole picture, seen through what lies above.
    void toAnotherLook()
    {
        const Painting painting = eightBetween();
        Painting wanted = painting; // with one green stroke in place of the red ones
        wanted.strokes = {
            painting.strokes[0],
            std::make_shared<const Stroke>(strokeFrom(2, {18, 22}, {60, 30}, {0.1f, 0.7f, 0.8f, 0.8f}, 7)),
            painting.strokes[9]};
        RefitGoal goal;
        goal.painting = std::make_shared<const Painting>(wanted);
        const Refitted now = refitted(painting, redOnes(), 3, goal, 600);
        QVERIFY2(now.error.isEmpty(), qPrintable(now.error));
        QVERIFY(now.before.rootMeanSquare > 15);
        QVERIFY2(now.after.rootMeanSquare < 4,
                 qPrintable(QStringLiteral("%1 → %2").arg(now.before.rootMeanSquare).arg(now.after.rootMeanSquare)));
        QCOMPARE(now.painting.strokes.back(), painting.strokes.back());
        wanted.canvas.width = 200;
        goal.painting = std::make_shared<const Painting>(wanted);
        QVERIFY(refitted(painting, redOnes(), 3, goal).error.contains("shape"));
    }

    void whatCannotBeChosen()
    {
        Painting painting = eightBetween();
        const auto errorOf = [&](const std::unordered_set<StrokeId> &ids) {
            const Result<RefitScope> scope = RefitScope::of(std::make_shared<const Painting>(painting), ids);
            return scope ? QString() : scope.error();
        };
        QVERIFY(errorOf({}).contains("choose others"));
        QVERIFY(errorOf({99}).contains("choose others"));
        Stroke locked = *painting.strokes[0];
        locked.locked = true;
        painting.strokes[0] = std::make_shared<const Stroke>(locked);
        QVERIFY(errorOf({1}).contains("unlocked"));
        painting.strokes.push_back(std::make_shared<const Stroke>(strokeFrom(20, {500, 500}, {510, 510}, red, 3)));
        QVERIFY(errorOf({20}).contains("beside the sheet"));
        QVERIFY(errorOf({2}).isEmpty());
    }

    /// Derivatives over a ground of pixels, against central differences.
    void gradientOverAGround()
    {
        using namespace gradient;
        FlatScene scene;
        scene.view = View::ofArea(Rect::of(0, 0, 24, 20), 24, 20);
        scene.strokes.push_back({0, 1, StyleKind::Uniform, {0.5, 0.3, 0}, 1, true, false, {}});
        SegmentNumbers s;
        for (int i = 0; i < 4; ++i)
            s.x[i] = 5 + 4 * i, s.y[i] = 8 + i;
        s.density = 4, s.spread = 3, s.colour[0] = 0.7, s.colour[2] = 0.2, s.opacity = 0.6, s.granulation = 1;
        scene.segments.push_back(s);
        auto ground = std::make_shared<std::vector<float>>(3 * 24 * 20);
        for (std::size_t i = 0; i < ground->size(); ++i)
            (*ground)[i] = float(i % 7) / 7;
        scene.ground = ground;
        SceneGradient<double> g{Threads(1)};
        g.choose(scene);
        const auto loss = [&g](const FlatScene &of) {
            double sum = 0;
            for (const double v : g.draw(of))
                sum += v * v;
            return sum;
        };
        const FlatGradient by =
            g.drawAndDifferentiate(scene, [](std::size_t, std::size_t count, const double *rgb, double *out) {
                for (std::size_t i = 0; i < 3 * count; ++i)
                    out[i] = 2 * rgb[i];
            });
        for (double SegmentNumbers::*const number : {&SegmentNumbers::opacity, &SegmentNumbers::density}) {
            FlatScene more = scene, less = scene;
            more.segments[0].*number += 1e-5, less.segments[0].*number -= 1e-5;
            const double slope = (loss(more) - loss(less)) / 2e-5;
            QVERIFY2(std::abs(by.segments[0].*number - slope) < 1e-5 * (1 + std::abs(slope)),
                     qPrintable(QString::number(slope)));
        }
        // A ground of one colour is a background of that colour.
        scene.background[0] = 0.25, scene.background[1] = 0.5, scene.background[2] = 0.75;
        for (std::size_t i = 0; i < ground->size(); ++i)
            (*ground)[i] = 0.25f * float(i % 3 + 1);
        const auto drawn = g.draw(scene);
        const std::vector<double> one(drawn.begin(), drawn.end());
        scene.ground = nullptr;
        const auto other = g.draw(scene);
        QVERIFY(std::equal(other.begin(), other.end(), one.begin()));
    }
};

QTEST_GUILESS_MAIN(TestRefit)

#include "test_refit.moc"

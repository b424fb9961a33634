// What a CUDA renderer must do on any device, emulated or real.
#pragma once

#include "model/painting/influence.h"
#include "render/bench/generator.h"
#include "render/cuda/cuda_renderer.h"
#include "tests/render/cell_corners.h"

#include <functional>

namespace suffuse::test {

using OpenDevice = std::function<std::shared_ptr<cuda::Device>()>;

/// At most one level of 8 bits apart, as far as pixels are covered.
inline void compare8(const FloatPicture &a, const FloatPicture &b, const char *what)
{
    const auto level = [](const FloatPicture &p, int x, int y, int c) {
        const float *v = p.at(x, y);
        return std::lround(255 * double(v[c] * (c < 3 ? v[3] : 1)));
    };
    QCOMPARE(a.rgba.size(), b.rgba.size());
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 4; ++c)
                QVERIFY2(std::abs(level(a, x, y, c) - level(b, x, y, c)) <= 1,
                         qPrintable(QStringLiteral("%1: channel %2 at %3, %4: %5 against %6")
                                        .arg(QLatin1String(what))
                                        .arg(c)
                                        .arg(x)
                                        .arg(y)
                                        .arg(double(a.at(x, y)[c]))
                                        .arg(double(b.at(x, y)[c]))));
}

/// Within a level of the CPU and within 1/512 of the reference.
inline void compareWithOthers(Renderer &cuda, const PaintingPtr &p, const View &view, const char *what,
                              Microseconds time = -1, bool transparent = false)
{
    const FloatPicture picture = test::render(cuda, p, view, time, transparent);
    compare8(picture, test::render(*make(Backend::Cpu), p, view, time, transparent), what);
    const Worst w = worst(picture, test::render(*make(Backend::Reference), p, view, time, transparent));
    QVERIFY2(
        w.difference <= 1.0 / 512,
        qPrintable(
            QStringLiteral("%1: %2/512 at %3, %4").arg(QLatin1String(what)).arg(w.difference * 512).arg(w.x).arg(w.y)));
}

/// How many strokes the device built, and how many segments with paint those that it left to the host have. An outline
/// without paint, as that of a fill, has no nodes, and so none that are left.
struct BuiltByDevice {
    int strokes = 0, ofAll = 0;
    std::size_t segmentsLeft = 0;
};

/// Compares what a device builds with what the host builds, bit for bit.
inline BuiltByDevice checkNodesOf(cuda::DeviceNodes &device, const Painting &p, Microseconds time, int octave)
{
    const std::vector<StrokePtr> strokes(p.strokes.begin(), p.strokes.end());
    const Rect all = p.canvas.area();
    const auto built = device.build(strokes, time, octave, all, 0);
    const auto sameGroup = [](const NodeGroup &a, const NodeGroup &b) {
        return a.begin == b.begin && a.end == b.end && a.row == b.row && a.rowPerNode == b.rowPerNode &&
               a.reachBegin == b.reachBegin && a.reachEnd == b.reachEnd;
    };
    BuiltByDevice counts{0, int(strokes.size()), 0};
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!built[i]) {
            counts.segmentsLeft += std::size_t(
                std::ranges::count_if(strokes[i]->segments, [](const Segment &s) { return s.density > 0; }));
            continue;
        }
        ++counts.strokes;
        const auto host = buildNodes(*strokes[i], time, octave, all);
        const StrokeNodes &a = *built[i], &b = *host;
        const auto [x, y] = std::ranges::mismatch(a.nodes, b.nodes);
        if (a.nodes.size() != b.nodes.size() || x != a.nodes.end())
            qWarning("stroke %zu: %zu nodes against %zu, which differ from number %td on", i, a.nodes.size(),
                     b.nodes.size(), x - a.nodes.begin());
        const bool same = a.nodes == b.nodes && a.rows == b.rows && a.reaches == b.reaches && a.clipped == b.clipped &&
                          std::ranges::equal(a.groups, b.groups, sameGroup);
        if (!same) {
            QTest::qFail("the device built other nodes", __FILE__, __LINE__);
            return counts;
        }
    }
    return counts;
}

/// A device builds the host's nodes.
inline void checkNodes(const OpenDevice &open, int strokes)
{
    cuda::DeviceNodes device(open());
    bench::PaintingOptions options;
    options.strokes = strokes, options.segments = 23 * strokes;
    for (const double spread : {6.0, 32.0}) {
        options.spreadLow = spread, options.spreadHigh = 3 * spread;
        const Painting p = bench::makePainting(options);
        for (const int octave : {-4, 0, 3}) {
            const BuiltByDevice built = checkNodesOf(device, p, p.end(), octave);
            QCOMPARE(built.strokes, built.ofAll);
        }
        checkNodesOf(device, p, p.end() / 2, 0);
    }
    std::mt19937_64 random(3);
    for (int i = 0; i < 8; ++i) {
        const auto p =
            painting(i % 2 ? fadedStrokes(random, 12, 300, 200) : randomStrokes(random, 12, 300, 200), 300, 200);
        QVERIFY(checkNodesOf(device, *p, p->end(), 3 * i - 9).strokes > 0);
        checkNodesOf(device, *p, 600000, 1);
    }
}

/// Pictures are the same whether the device or the host builds nodes, from scratch, after edits, zoomed and in between
/// times.
inline void checkPicturesByNodes(const OpenDevice &open)
{
    std::mt19937_64 random(29);
    std::uniform_real_distribution<double> u(0, 1);
    auto p = painting(randomStrokes(random, 40, 120, 90), 120, 90);
    CudaRenderer byDevice({open()}, 0, true, {}, 0), byHost({open()}, 0, true, {}, SIZE_MAX);
    FloatPicture one, other;
    Microseconds time = p->end();
    for (int step = 0; step < 24; ++step) {
        View view = View::ofArea(p->canvas.area(), 120, 90);
        view.scale *= std::exp2(step / 6 - 1);
        QVERIFY(byDevice.render({p, time, view}, one));
        QVERIFY(byHost.render({p, time, view}, other));
        QVERIFY2(one.rgba == other.rgba, qPrintable(QString::number(step)));
        p = randomlyEdited(p, random);
        if (step % 5 == 4)
            time = Microseconds(u(random) * double(p->end()));
        if (step % 7 == 6)
            time = p->end();
    }
    CudaRenderer fresh({open(), open()}, 0, true, {}, 0);
    const View view = View::ofArea(p->canvas.area(), 120, 90);
    QVERIFY(byHost.render({p, time, view}, other));
    QVERIFY(test::render(fresh, p, view, time).rgba == other.rgba);
}

inline void checkPictures(const OpenDevice &open)
{
    CudaRenderer cuda({open()}, 0);
    std::mt19937_64 random(7);
    for (int i = 0; i < 6; ++i) {
        const Paper paper = i % 2 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}, PaperGrain(i / 2)} : Paper{};
        const auto p = painting(randomStrokes(random, 10, 72, 54), 72, 54, paper);
        const View view = View::ofArea(p->canvas.area(), 72, 54);
        compareWithOthers(cuda, p, view, "random painting", -1, i == 2);
        compareWithOthers(cuda, p, view, "still spreading", 600000);
    }
    const auto p = painting(randomStrokes(random, 8, 72, 54), 72, 54, {PaperKind::Procedural, 3, 12, 1, {}});
    for (const double scale : {0.02, 0.1, 0.4, 3.0, 40.0, 900.0, 20000.0})
        for (const double rotation : {0.0, 0.7})
            compareWithOthers(cuda, p, {{30.2, 23.1}, scale, rotation, rotation > 0, 37, 30}, "zoomed");
}

inline void checkKinds(const OpenDevice &open)
{
    CudaRenderer cuda({open()}, 0);
    for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
        for (const Shape shape : allShapes) {
            const auto p = painting({stroke(1, Shape::Curved, {25, 15}, 20, 7, styleOf(StyleKind::Uniform)),
                                     stroke(2, shape, {24, 18}, 15, 5, styleOf(kind), {MixMode::Beta, 0.8f})},
                                    48, 36);
            compareWithOthers(cuda, p, View::ofArea(p->canvas.area(), 48, 36), "plain strokes");
        }
    for (const double angle : {0.0, 0.4}) {
        Stroke s = stroke(1, Shape::Curved, {24, 18}, 15, 3, styleOf(StyleKind::Edge));
        for (Segment &g : s.segments)
            g.anisotropyRatio = 5, g.anisotropyAngle = float(angle);
        compareWithOthers(cuda, painting({s}, 48, 36), {{24, 18}, 1.5, 0.3, true, 50, 50}, "anisotropic");
    }
    for (const double spread : {0.02, 0.3}) {
        const auto p = painting({stroke(1, Shape::Curved, {20, 16}, 14, spread, styleOf(StyleKind::Uniform)),
                                 stroke(2, Shape::Looping, {20, 16}, 10, 2 * spread, styleOf(StyleKind::Edge))},
                                40, 32);
        compareWithOthers(cuda, p, View::ofArea(p->canvas.area(), 40, 32), "hairlines");
    }
    Stroke s = stroke(1, Shape::Curved, {10053.3, -9947.7}, 30, 9, styleOf(StyleKind::Uniform));
    s.segments[1].colour = {0.9f, 0.4f, 0.2f, 1};
    for (double scale = 512; scale < 2e9; scale *= 64)
        compareWithOthers(cuda, painting({s}), {s.origin, scale, 0, false, 24, 24}, "deep zoom");
}

/// Strokes of several chains, from which paint is lifted.
inline void checkLifts(const OpenDevice &open)
{
    CudaRenderer cuda({open()}, 0);
    std::mt19937_64 random(7);
    for (int i = 0; i < 4; ++i) {
        const Paper paper = i % 2 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}, PaperGrain(i / 2)} : Paper{};
        const auto p = painting(liftedStrokes(random, 8, 72, 54), 72, 54, paper);
        const View view = View::ofArea(p->canvas.area(), 72, 54);
        compareWithOthers(cuda, p, view, "lifted painting", -1, i == 2);
        compareWithOthers(cuda, p, view, "lifted, still spreading", 600000);
    }
    const auto zoomed = painting(liftedStrokes(random, 6, 72, 54), 72, 54);
    for (const double scale : {0.1, 0.4, 3.0, 900.0, 20000.0})
        compareWithOthers(cuda, zoomed, {{30.2, 23.1}, scale, 0.7, true, 37, 30}, "lifted, zoomed");
    for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
        Stroke s = wash(1, Rect::of(10, 8, 50, 38), 8, 5, styleOf(kind));
        liftAlong(s, {12, 4}, {50, 40}, 4, 2);
        const auto p = painting({s}, 72, 54);
        compareWithOthers(cuda, p, View::ofArea(p->canvas.area(), 72, 54), "lifted wash");
        CudaRenderer whole({open()}, 0, false);
        const View view = View::ofArea(p->canvas.area(), 72, 54);
        QVERIFY(test::render(cuda, p, view).rgba == test::render(whole, p, view).rgba);
    }
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(Rect::of(0, 0, 72, 54), 72, 54);
    auto p = painting(liftedStrokes(random, 12, 72, 54), 72, 54);
    FloatPicture picture;
    QVERIFY(live.render({p, p->end(), view}, picture));
    for (int step = 1; step <= 6; ++step) {
        p = withDensity(p, 5, 1 + 0.05 * step);
        QVERIFY(live.render({p, p->end(), view, false, step < 6}, picture));
        const FloatPicture whole = test::render(fresh, p, view);
        QVERIFY(step < 6 ? worst(picture, whole).difference <= 1e-5 : picture.rgba == whole.rgba);
    }
}

/// Strokes that are made paler, some of which are lifted, too.
inline void checkFades(const OpenDevice &open)
{
    CudaRenderer cuda({open()}, 0);
    std::mt19937_64 random(7);
    const View view = View::ofArea(Rect::of(0, 0, 72, 54), 72, 54);
    for (int i = 0; i < 4; ++i) {
        const Paper paper = i % 2 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}, PaperGrain(i / 2)} : Paper{};
        const auto p = painting(fadedStrokes(random, 8, 72, 54), 72, 54, paper);
        compareWithOthers(cuda, p, view, "faded painting", -1, i == 2);
        compareWithOthers(cuda, p, view, "faded, still spreading", 600000);
    }
    const auto zoomed = painting(fadedStrokes(random, 6, 72, 54), 72, 54);
    for (const double scale : {0.1, 0.4, 3.0, 900.0, 20000.0})
        compareWithOthers(cuda, zoomed, {{30.2, 23.1}, scale, 0.7, true, 37, 30}, "faded, zoomed");
    for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge}) {
        const Stroke before = wash(1, Rect::of(10, 8, 50, 38), 8, 5, styleOf(kind));
        Stroke s = before;
        fadeAlong(s, {12, 20}, {30, 26}, 3, 0.5);
        const auto p = painting({s}, 72, 54);
        compareWithOthers(cuda, p, view, "faded wash");
        CudaRenderer whole({open()}, 0, false);
        const FloatPicture faded = test::render(cuda, p, view),
                           was = test::render(cuda, painting({before}, 72, 54), view);
        QVERIFY(faded.rgba == test::render(whole, p, view).rgba && faded.rgba != was.rgba);
        Rect met;
        for (const Segment &g : s.segments)
            if (g.fade)
                met = met.united(influenceOf(s, g, p->end()));
        for (int y = 0; y < 54; ++y)
            for (int x = 0; x < 72; ++x)
                for (int c = 0; c < 4 && !met.grown(1).contains({x + 0.5, y + 0.5}); ++c)
                    // A stroke with one more sum is evaluated by other code, which rounds in another way.
                    QVERIFY(std::abs(faded.at(x, y)[c] - was.at(x, y)[c]) < 2e-6f);
    }
}

/// Fills of all kinds, with whatever else a stroke may have.
inline void checkFills(const OpenDevice &open, int randomOnes)
{
    CudaRenderer cuda({open()}, 0);
    const View view = View::ofArea(Rect::of(0, 0, 64, 48), 64, 48);
    for (const StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
        for (const double spread : {0.0, 0.01, 0.3, 1.5, 5.0, 40.0}) {
            Stroke disc = emptyFill(1, spread, styleOf(kind)),
                   box = emptyFill(2, spread, styleOf(kind), {0.9f, 0.1f, 0.2f, 1});
            addEllipse(disc, {28, 24}, 22, 15);
            addEllipse(disc, {30, 22}, 9, 7, true);
            addRectangle(box, Rect::of(22, 14, 30, 24));
            compareWithOthers(cuda, painting({disc, box}, 64, 48), view, "shapes");
        }
    for (const double spread : {1e-3, 4.0, 60.0}) {
        Stroke s = emptyFill(1, spread, styleOf(StyleKind::Uniform));
        addEllipse(s, {300, 24}, 280, 4000);
        Stroke whole = emptyFill(2, spread, styleOf(StyleKind::Edge), {0.5f, 0.5f, 0, 0.3f});
        addRectangle(whole, Rect::of(-1e5, -1e5, 3e5, 3e5));
        compareWithOthers(cuda, painting({s, whole}, 64, 48), view, "larger than the view");
    }
    for (const double angle : {0.0, 0.7}) {
        Stroke s = emptyFill(1, 5, styleOf(StyleKind::Uniform));
        addEllipse(s, {30, 24}, 18, 14);
        changeFill(s, [&](Fill &f) { f.anisotropyRatio = 0.2f, f.anisotropyAngle = float(angle); });
        changeFill(s, [](Fill &f) { f.gradient = {{20, 10}, {45, 30}, {0.9f, 0.1f, 0.8f, 0.5f}}; });
        compareWithOthers(cuda, painting({s}, 64, 48), view, "tensor");
    }
    Stroke deep = emptyFill(1, 9, styleOf(StyleKind::Edge));
    deep.origin = {10'000, -9'000};
    addEllipse(deep, {30, 24}, 20, 14);
    changeFill(deep, [](Fill &f) { f.gradient = {{20, 10}, {45, 30}, {0.9f, 0.1f, 0.8f, 0.5f}}; });
    for (double scale = 64; scale < 2e9; scale *= 64)
        compareWithOthers(cuda, painting({deep}), {deep.origin + Point{50, 24}, scale, 0, false, 24, 24}, "deep zoom");
    for (int i = 0; i < randomOnes; ++i) {
        std::mt19937_64 random(i + 1);
        std::uniform_real_distribution<double> u(0, 1);
        constexpr double least[] = {1.2, 12, 1e-5, 0.3}, most[] = {12, 200, 0.015, 1};
        const double low = least[i % 4], high = most[i % 4];
        std::vector<Stroke> strokes;
        for (int k = 0; k < 3; ++k)
            strokes.push_back(randomFill(random, StrokeId(k + 1), 64, 48, low * std::pow(high / low, u(random))));
        const Paper paper = i % 3 == 0 ? Paper{PaperKind::Procedural, 5, 20, 0.8f, {}} : Paper{};
        const View turned{{32, 24}, 1.3, 0.4, i % 2 == 0, 48, 40};
        compareWithOthers(cuda, painting(strokes, 64, 48, paper), i % 5 == 3 ? turned : view, "random fills", 1'000'000,
                          i % 7 == 0);
        if (QTest::currentTestFailed()) {
            qInfo("random fills %d", i);
            return;
        }
    }
}

/// Crisp edges that lead through corners of cells fill no cell that they only touch.
inline void checkCornersOfCells(const OpenDevice &open, unsigned triangles)
{
    CudaRenderer cuda({open()}, 0);
    checkTrianglesThroughCorners(cuda, triangles);
}

/// Fills are the same to the bit whatever was drawn before, on however many devices, with all tiles looked at and not.
inline void checkFillEdits(const OpenDevice &open, int steps)
{
    for (const double scale : {1.0, 3.0, 900.0}) {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        PaintingPtr p = mixedFills(random, 5, 96, 72, scale == 3 ? PaperKind::Procedural : PaperKind::None);
        CudaRenderer live({open()}, 0), fresh({open()}, 0), several({open(), open()}, 0, false);
        const View view{{48, 36}, scale, 0, false, 150, 140};
        Microseconds time = p->end();
        FloatPicture picture;
        QVERIFY(live.render({p, time, view}, picture));
        int partial = 0;
        for (int step = 0; step < steps; ++step) {
            p = random() % 5 == 0 ? randomlyEdited(p, random) : withEditedFill(p, random);
            if (random() % 8 == 0)
                time = Microseconds(u(random) * double(p->end()));
            const bool drags = random() % 6 == 0;
            const auto stats = live.render({p, time, view, false, drags}, picture);
            QVERIFY(stats);
            partial += stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
            const FloatPicture whole = test::render(fresh, p, view, time);
            if (drags) {
                QVERIFY(worst(picture, whole).difference <= 1e-5);
                QVERIFY(live.render({p, time, view}, picture));
            }
            QVERIFY2(picture.rgba == whole.rgba, qPrintable(QStringLiteral("zoom %1, step %2").arg(scale).arg(step)));
            if (step % 8 == 0)
                QVERIFY(test::render(several, p, view, time).rgba == whole.rgba);
        }
        QVERIFY2(scale > 100 || partial > steps / 8, qPrintable(QString::number(partial)));
    }
}

inline void checkDirtyIsFull(const OpenDevice &open, int steps)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> u(0, 1);
    auto p = painting(randomStrokes(random, 24, 120, 90), 120, 90, {PaperKind::Procedural, 5, 20, 0.8f, {}});
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(p->canvas.area(), 120, 90);
    Microseconds time = p->end();
    FloatPicture picture;
    QVERIFY(live.render({p, time, view}, picture));
    bool partial = false;
    for (int step = 0; step < steps; ++step) {
        p = randomlyEdited(p, random);
        if (random() % 6 == 0)
            time = Microseconds(u(random) * double(p->end()));
        const auto stats = live.render({p, time, view}, picture);
        QVERIFY(stats);
        partial |= stats->tilesEvaluated > 0 && stats->tilesEvaluated < stats->tiles;
        int stored = 0;
        for (const PixelRect &r : stats->dirty)
            stored += ((r.width + 15) / 16) * ((r.height + 15) / 16);
        QCOMPARE(stored, stats->tilesEvaluated);
        QVERIFY2(picture.rgba == test::render(fresh, p, view, time).rgba,
                 qPrintable(QStringLiteral("step %1").arg(step)));
    }
    QVERIFY(partial);
}

/// A stroke that grows on top, and below others that come later.
inline void checkGrowingStroke(const OpenDevice &open)
{
    std::mt19937_64 random(29);
    auto p = painting(randomStrokes(random, 10, 100, 75), 100, 75);
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(p->canvas.area(), 100, 75);
    FloatPicture picture;
    Stroke growing = stroke(999, Shape::Tiny, {}, 1, 3, styleOf(StyleKind::Edge));
    const Segment first = growing.segments.front();
    growing.segments.clear();
    growing.origin = {};
    for (int frame = 0; frame < 60; ++frame) {
        Segment g = first;
        const auto at = [](int k) { return Point{50 + 40 * std::cos(0.15 * k), 37 + 30 * std::sin(0.33 * k)}; };
        const Point a = at(frame), b = at(frame + 1);
        g.bezier = {toOffset(a, {}), toOffset(a + (1.0 / 3) * (b - a), {}), toOffset(a + (2.0 / 3) * (b - a), {}),
                    toOffset(b, {})};
        g.density = 5;
        g.born = p->end();
        growing.segments.push_back(g);
        auto q = std::make_shared<Painting>(*p);
        q->strokes.push_back(std::make_shared<const Stroke>(growing));
        if (frame > 30)
            q->strokes.push_back(p->strokes[0]);
        if (frame > 30)
            q->strokes.erase(q->strokes.begin());
        const Microseconds time = p->end() + frame * 40000;
        QVERIFY(live.render({q, time, view}, picture));
        if (frame % 4 == 0 || frame == 31)
            QVERIFY2(picture.rgba == test::render(fresh, q, view, time).rgba,
                     qPrintable(QStringLiteral("frame %1").arg(frame)));
    }
}

/// A drag may differ by 1e-5; letting go is exact.
inline void checkLayers(const OpenDevice &open)
{
    std::mt19937_64 random(17);
    CudaRenderer live({open()}, 0), fresh({open()}, 0);
    const View view = View::ofArea(Rect::of(0, 0, 100, 75), 100, 75);
    for (const bool transparent : {false, true})
        for (int round = 0; round < 2; ++round) {
            const auto p = painting(randomStrokes(random, 18, 100, 75), 100, 75);
            const std::size_t index = 3 + random() % 12;
            FloatPicture picture;
            QVERIFY(live.render({p, p->end(), view, transparent}, picture));
            PaintingPtr q = p;
            for (int step = 1; step <= 6; ++step) {
                q = withDensity(p, index, 1 + 0.05 * step);
                QVERIFY(live.render({q, q->end(), view, transparent, true}, picture));
                const double off = worst(picture, test::render(fresh, q, view, -1, transparent)).difference;
                QVERIFY2(off <= 1e-5, qPrintable(QStringLiteral("step %1: %2").arg(step).arg(off)));
            }
            QVERIFY(live.render({q, q->end(), view, transparent, false}, picture));
            QVERIFY(picture.rgba == test::render(fresh, q, view, -1, transparent).rgba);
        }
}

/// 8 bits made by the device, and culling, change nothing that they should not.
inline void checkTargetsAndCulling(const OpenDevice &open)
{
    std::mt19937_64 random(19);
    const auto p = painting(randomStrokes(random, 12, 70, 50), 70, 50);
    const View view = View::ofArea(p->canvas.area(), 70, 50);
    CudaRenderer cuda({open()}, 0), whole({open()}, 0, false);
    const FloatPicture picture = test::render(cuda, p, view);
    QVERIFY(picture.rgba == test::render(whole, p, view).rgba);
    Picture8 eight, rounded;
    QVERIFY(cuda.render({p, p->end(), view}, eight));
    rounded.resize(70, 50);
    rounded.store({0, 0, 70, 50}, picture.rgba.data(), 70);
    QVERIFY(eight.argb == rounded.argb);
}

/// Thousands of strokes over each other at one tile, and washes of hundreds of nodes whose colours vary.
inline PaintingPtr heavyPainting(int strokes)
{
    std::mt19937_64 random(61);
    std::uniform_real_distribution<float> u(0, 1);
    std::vector<Stroke> all;
    for (int i = 0; i < strokes; ++i) {
        Stroke s = stroke(StrokeId(i + 1), allShapes[i % 4], {6.0 + 4 * double(u(random)), 6.0 + 4 * double(u(random))},
                          4, 1.5 + double(u(random)), styleOf(StyleKind(i % 3)));
        for (Segment &g : s.segments)
            g.colour = {u(random), u(random), u(random), 0.2f};
        all.push_back(std::move(s));
    }
    for (int i = 0; i < 6; ++i) {
        Stroke s = wash(StrokeId(strokes + i + 1), Rect::of(2, 2, 44, 30), 10 + 4 * i, i == 5 ? 0.7 : 2,
                        styleOf(StyleKind(i % 3)));
        for (std::size_t k = 0; k < s.segments.size(); ++k)
            s.segments[k].colour = {float(k % 7) / 7, float(k % 5) / 5, float(k % 3) / 3, 0.6f};
        if (i == 4)
            liftAlong(s, {4, 4}, {40, 30}, 3, 1);
        all.push_back(std::move(s));
    }
    return painting(all, 48, 36, {PaperKind::Procedural, 5, 20, 0.8f, {}});
}

/// Fills of all kinds over each other: crisp, finer than a pixel, and wider, with and without gradients.
inline PaintingPtr heavyFills(int fills)
{
    std::mt19937_64 random(67);
    std::vector<Stroke> all;
    for (int i = 0; i < fills; ++i) {
        constexpr double spreads[] = {1e-4, 0.4, 3, 30, 0.05};
        all.push_back(randomFill(random, StrokeId(i + 1), 48, 36, spreads[i % 5]));
        if (i % 3)
            changeFill(all.back(), [](Fill &f) { f.anisotropyRatio = f.granulation = 1; });
    }
    return painting(all, 48, 36, {PaperKind::Procedural, 5, 20, 0.8f, {}});
}

/// Who evaluates a stroke changes no bit: its tile, or another warp; whatever was drawn before; on several devices.
inline void checkHeavyTiles(const OpenDevice &open, PaintingPtr p, int repeats)
{
    constexpr std::uint32_t never = UINT32_MAX;
    const View view = View::ofArea(p->canvas.area(), 48, 36);
    CudaRenderer together({open()}, 0, true, {never, never, never, never}),
        apart({open()}, 0, true, {0, 0, 0, 0});
    CudaRenderer some({open()}, 0, true, {300, 100, 500, 900}), usual({open(), open()}, 0), live({open()}, 0);
    FloatPicture picture;
    for (int step = 0; step < 3; ++step) {
        const FloatPicture expected = test::render(together, p, view);
        if (step == 0)
            compare8(expected, test::render(*make(Backend::Cpu), p, view), "heavy tiles");
        for (CudaRenderer *renderer : {&apart, &some, &usual})
            for (int i = 0; i < repeats; ++i) {
                renderer->invalidate();
                QVERIFY2(test::render(*renderer, p, view).rgba == expected.rgba,
                         qPrintable(QStringLiteral("step %1, repeat %2").arg(step).arg(i)));
            }
        QVERIFY(live.render({p, p->end(), view, false, false}, picture));
        QVERIFY2(picture.rgba == expected.rgba, qPrintable(QStringLiteral("history, step %1").arg(step)));
        p = withDensity(p, step == 0 ? p->strokes.size() - 2 : p->strokes.size() / 2, 0.8);
    }
}

/// Keeps its picture on the device.
struct DeviceTarget : Picture8 {
    bool onDevice = true;
    bool takesDeviceFrames() const override { return onDevice; }
};

inline void checkDeviceFrames(const OpenDevice &open)
{
    std::mt19937_64 random(37);
    auto p = painting(randomStrokes(random, 10, 70, 50), 70, 50);
    const View view = View::ofArea(p->canvas.area(), 70, 50);
    const std::shared_ptr<cuda::Device> device = open();
    CudaRenderer cuda({device}, 0), fresh({open()}, 0);
    DeviceTarget target;
    for (int step = 0; step < 4; ++step) {
        const auto stats = cuda.render({p, p->end(), view}, target);
        QVERIFY(stats && stats->frame);
        const auto frame = std::dynamic_pointer_cast<CudaFrame>(stats->frame);
        QVERIFY(frame);
        Pixels<std::uint32_t> argb(70 * 50);
        QVERIFY(!device->download(argb.data(), frame->picture(), argb.size() * sizeof(argb[0])));
        QVERIFY(!device->finish(nullptr));
        Picture8 expected;
        QVERIFY(fresh.render({p, p->end(), view}, expected));
        QVERIFY2(argb == expected.argb, qPrintable(QStringLiteral("step %1").arg(step)));
        p = withDensity(p, std::size_t(step), 0.9);
    }
    target.onDevice = false; // from now on into memory
    const auto stats = cuda.render({p, p->end(), view}, target);
    QVERIFY(stats && !stats->frame);
    QCOMPARE(stats->tilesEvaluated, stats->tiles);
    Picture8 expected;
    QVERIFY(fresh.render({p, p->end(), view}, expected));
    QVERIFY(target.argb == expected.argb);
}

inline void checkCancelling(const OpenDevice &open)
{
    std::mt19937_64 random(9);
    const auto p = painting(randomStrokes(random, 8, 70, 50), 70, 50);
    const View view = View::ofArea(p->canvas.area(), 70, 50);
    CudaRenderer cuda({open()}, 0);
    FloatPicture picture;
    std::atomic<bool> cancel{true};
    const auto first = cuda.render({p, p->end(), view}, picture, &cancel);
    QVERIFY(first && first->cancelled);
    QCOMPARE(first->tilesEvaluated, 0);
    const auto second = cuda.render({p, p->end(), view}, picture);
    QVERIFY(second && !second->cancelled);
    QVERIFY(picture.rgba == test::render(cuda, p, view).rgba);
}

} // namespace suffuse::test

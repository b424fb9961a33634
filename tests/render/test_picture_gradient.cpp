// The gradient of the picture against central differences, and its picture against the renderers (docs/solver.md).
#include "render/gradient/picture_gradient.h"
#include "tests/render/flat_scenes.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include <cstring>
#include <functional>

using namespace suffuse;
using namespace suffuse::test;

namespace {

constexpr int width = 32, height = 16;

/// The loss that is linear in the picture.
double lossOf(SceneGradient<double> &gradient, const FlatScene &scene, const std::vector<double> &by)
{
    const std::span<const double> picture = gradient.draw(scene);
    double sum = 0;
    for (std::size_t i = 0; i < by.size(); ++i)
        sum += picture[i] * by[i];
    return sum;
}

/// How far a derivative is from central differences, in units of `norm`. Where a step meets a bend of the picture (a
/// pixel whose edge begins to cover a jump) a smaller step does not.
double errorOf(double derivative, double &number, double scale, double norm, const std::function<double()> &loss)
{
    const double value = number;
    double least = 1e300;
    for (double step = 1e-5 * scale; step > 1e-8 * scale; step *= 0.2) {
        number = value + step;
        const double above = loss();
        number = value - step;
        const double below = loss();
        number = value;
        least = std::min(least, std::abs((above - below) / (2 * step) - derivative) * scale / norm);
        if (least < 3e-7)
            break;
    }
    return least;
}

double normOf(FlatScene &scene, const FlatGradient &by)
{
    double sum = 0;
    forEachNumber(scene, by, [&](double, double d, double scale) { sum += d * scale * d * scale; });
    return std::sqrt(sum);
}

/// The gradient if segments around a fill keep their common points: what opens a gap there would let paint out, along
/// all of the picture, and cancels.
FlatGradient joined(const FlatScene &scene, FlatGradient by)
{
    for (const FlatStroke &stroke : scene.strokes)
        for (std::size_t k = stroke.first; stroke.filled && k + 1 < stroke.first + stroke.count; ++k) {
            SegmentNumbers &a = by.segments[k], &b = by.segments[k + 1];
            a.x[3] += b.x[0], a.y[3] += b.y[0];
            b.x[0] = b.y[0] = 0;
        }
    return by;
}

/// The greatest difference of two gradients in units of the norm of the first one.
double distanceOf(FlatScene &scene, const FlatGradient &first, const FlatGradient &second)
{
    const FlatGradient a = joined(scene, first), b = joined(scene, second);
    std::vector<double> values;
    forEachNumber(scene, a, [&](double, double d, double scale) { values.push_back(d * scale); });
    std::size_t i = 0;
    double worst = 0;
    forEachNumber(scene, b,
                  [&](double, double d, double scale) { worst = std::max(worst, std::abs(values[i++] - d * scale)); });
    return worst / normOf(scene, a);
}

/// The stroke of a painting that a flat one stands for.
Stroke strokeOf(const FlatScene &scene, const FlatStroke &flat, Style style)
{
    Stroke stroke;
    stroke.id = flat.first + 1;
    stroke.style = style;
    stroke.origin = {std::round(scene.segments[flat.first].x[0]), std::round(scene.segments[flat.first].y[0])};
    for (std::size_t k = flat.first; k < flat.first + flat.count; ++k) {
        const SegmentNumbers &s = scene.segments[k];
        Segment segment;
        for (std::size_t i = 0; i < 4; ++i)
            segment.bezier[i] = toOffset({s.x[i], s.y[i]}, stroke.origin);
        segment.density = float(s.density);
        segment.diffusion = float(s.spread * s.spread / 4);
        segment.colour = {float(s.colour[0]), float(s.colour[1]), float(s.colour[2]), float(s.opacity)};
        segment.lift = scene.marks[k].lift;
        segment.fade = scene.marks[k].fade;
        segment.start = k > flat.first && scene.marks[k].start;
        stroke.segments.push_back(segment);
    }
    if (flat.filled) {
        Fill fill;
        fill.density = float(flat.fill.density);
        fill.diffusion = float(flat.fill.spread * flat.fill.spread / 4);
        fill.colour = {float(flat.fill.colour[0]), 0.5f, 0.2f, 0.8f};
        stroke.fill = fill;
    }
    return stroke;
}

bool sameBits(const FlatGradient &a, const FlatGradient &b)
{
    return a.segments.size() == b.segments.size() && a.strokes.size() == b.strokes.size() &&
           std::memcmp(a.segments.data(), b.segments.data(), a.segments.size() * sizeof a.segments[0]) == 0 &&
           std::memcmp(a.strokes.data(), b.strokes.data(), a.strokes.size() * sizeof a.strokes[0]) == 0;
}

} // namespace

class TestPictureGradient : public QObject {
    Q_OBJECT

    static void addKinds()
    {
        QTest::addColumn<SceneKind>("kind");
        int number = 0;
        for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
            for (const bool pigment : {false, true})
                for (const bool varies : {false, true})
                    for (const bool paper : {false, true}) {
                        SceneKind kind;
                        kind.style = style, kind.pigment = pigment, kind.oneColour = !varies, kind.paper = paper;
                        kind.turnedView = pigment;
                        if (isTried(number++))
                            QTest::addRow("style %d%s%s%s", int(style), pigment ? ", pigment" : "",
                                          varies ? ", varying" : "", paper ? ", paper" : "")
                                << kind;
                    }
        for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering})
            for (const bool varies : {false, true}) {
                SceneKind kind;
                kind.style = style, kind.oneColour = !varies, kind.lifts = true, kind.paper = varies;
                if (isTried(number++))
                    QTest::addRow("lifts, style %d%s", int(style), varies ? ", varying" : "") << kind;
            }
        for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
            for (const bool varies : {false, true}) {
                SceneKind kind;
                kind.style = style, kind.oneColour = !varies, kind.filled = true, kind.turnedView = varies;
                // Where paint is level, paper would bring some of its pixels to the very density at which F bends.
                kind.paper = varies && style == StyleKind::Uniform;
                if (isTried(number++))
                    QTest::addRow("fills, style %d%s", int(style), varies ? ", varying" : "") << kind;
            }
        for (const StyleKind style : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
            for (const bool varies : {false, true}) {
                SceneKind kind;
                kind.style = style, kind.oneColour = !varies, kind.fades = true, kind.turnedView = varies;
                kind.pigment = varies, kind.paper = !varies;
                kind.lifts = varies && style == StyleKind::Uniform;
                kind.filled = varies && style == StyleKind::Feathering;
                if (isTried(number++))
                    QTest::addRow("fades, style %d%s", int(style), varies ? ", varying" : "") << kind;
            }
    }

    static void compare(const DifferentiablePicture &picture, const PaintingPtr &p, const View &view,
                        Renderer &renderer, std::uint64_t seed)
    {
        const FloatPicture expected = test::render(renderer, p, view);
        double worst = 0;
        for (std::size_t i = 0; i < picture.picture().size(); ++i)
            worst = std::max(worst, double(std::abs(picture.picture()[i] - expected.rgba[i / 3 * 4 + i % 3])));
        QVERIFY2(worst <= 1.0 / 512, qPrintable(QStringLiteral("seed %1: %2/512").arg(seed).arg(worst * 512)));
    }

private slots:
    void doublesAgreeWithCentralDifferences_data() { addKinds(); }
    void doublesAgreeWithCentralDifferences()
    {
        QFETCH(SceneKind, kind);
        double worst = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) { // 40 kinds of 2 · 5 · 3 segments: 1,200
            FlatScene scene = randomScene(seed, 5, width, height, kind);
            const auto by = randomLoss<double>(seed, width, height);
            SceneGradient<double> gradient;
            gradient.choose(scene, {1e-7});
            gradient.draw(scene);
            const FlatGradient exact = gradient.backward(by);
            const double norm = normOf(scene, exact);
            QVERIFY(norm > 1);
            const auto loss = [&] { return lossOf(gradient, scene, by); };
            forEachNumber(scene, exact, [&](double &number, double derivative, double scale) {
                worst = std::max(worst, errorOf(derivative, number, scale, norm, loss));
            });
        }
        QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
    }

    void floatsAgreeWithDoubles_data() { addKinds(); }
    void floatsAgreeWithDoubles()
    {
        QFETCH(SceneKind, kind);
        std::vector<double> distances;
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            FlatScene scene = randomScene(seed, 5, 2 * width, 2 * height, kind);
            SceneGradient<double> inDouble;
            SceneGradient<float> inFloat;
            inDouble.choose(scene), inFloat.choose(scene);
            inDouble.draw(scene), inFloat.draw(scene);
            const auto byDouble = randomLoss<double>(seed, 2 * width, 2 * height);
            const auto byFloat = randomLoss<float>(seed, 2 * width, 2 * height);
            distances.push_back(distanceOf(scene, inDouble.backward(byDouble), inFloat.backward(byFloat)));
        }
        // Where two components of a pixel's colour are the same but for rounding, either side of the bend may be taken.
        std::ranges::sort(distances);
        QVERIFY2(distances[4] < 3e-4, qPrintable(QString::number(distances[4])));
        QVERIFY2(distances.back() < 2e-2, qPrintable(QString::number(distances.back())));
    }

    void bitsDependOnNothingElse()
    {
        SceneKind kind;
        kind.oneColour = false, kind.fades = true;
        FlatScene scene = randomScene(7, 60, 200, 150, kind);
        for (std::size_t i = 0; i < scene.strokes.size(); ++i) {
            scene.strokes[i].kind = StyleKind(i % 3);
            setXi(scene.strokes[i], 0.3, 0.6, 0.5);
            scene.strokes[i].oneColour = i % 2 == 0;
        }
        const FlatScene other = randomScene(8, 20, 90, 170, kind);
        const auto by = randomLoss<float>(7, 200, 150);
        SceneGradient<float> first(1);
        first.choose(scene);
        const std::span<const float> drawn = first.draw(scene);
        const std::vector<float> picture(drawn.begin(), drawn.end());
        const FlatGradient expected = first.backward(by);
        for (const int threads : {1, 2, 3}) {
            SceneGradient<float> gradient{Threads(threads)};
            gradient.choose(other);
            gradient.draw(other);
            gradient.choose(scene);
            for (int i = 0; i < 2; ++i) {
                const std::span<const float> again = gradient.draw(scene);
                QVERIFY(std::equal(again.begin(), again.end(), picture.begin(), picture.end()));
                QVERIFY(sameBits(gradient.backward(by), expected));
            }
            const auto loss = [&](std::size_t from, std::size_t count, const float *rgb, float *out) {
                QVERIFY(std::equal(rgb, rgb + 3 * count, picture.begin() + std::ptrdiff_t(3 * from)));
                std::copy_n(by.begin() + std::ptrdiff_t(3 * from), 3 * count, out);
            };
            QVERIFY(sameBits(gradient.drawAndDifferentiate(scene, loss), expected));
        }
    }

    void filledAndErasedPicturesAgreeWithTheRenderers()
    {
        const auto cpu = make(Backend::Cpu), reference = make(Backend::Reference);
        for (std::uint64_t seed = 1; seed <= std::uint64_t(trials(12, 60)); ++seed) {
            SceneKind kind;
            kind.filled = seed % 3 != 0, kind.lifts = !kind.filled, kind.fades = seed % 4 >= 2;
            kind.least = 4.5, kind.greatest = 9, kind.length = 18;
            const FlatScene scene = randomScene(seed, 4, 96, 72, kind);
            std::vector<Stroke> strokes;
            for (const FlatStroke &flat : scene.strokes)
                strokes.push_back(strokeOf(scene, flat, styleOf(StyleKind(kind.lifts ? seed % 2 : seed % 3))));
            const auto p = painting(strokes, 96, 72);
            const View view = View::ofArea(p->canvas.area(), 96, 72);
            const auto picture = DifferentiablePicture::draw(p, p->end(), view);
            QVERIFY2(picture, qPrintable(picture.error()));
            compare(*picture, p, view, *cpu, seed);
            compare(*picture, p, view, *reference, seed);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void picturesAgreeWithTheRenderers()
    {
        const auto cpu = make(Backend::Cpu), reference = make(Backend::Reference);
        for (std::uint64_t seed = 0; seed < std::uint64_t(trials(16, 80)); ++seed) {
            std::mt19937_64 random(seed);
            std::vector<Stroke> strokes = randomStrokes(random, 6, 96, 72);
            for (Stroke &s : strokes)
                for (Segment &g : s.segments)
                    g.style.reset();
            Paper paper;
            if (seed % 2)
                paper.kind = PaperKind::Procedural, paper.grain = PaperGrain(seed % 3);
            const auto p = painting(strokes, 96, 72, paper);
            View view = View::ofArea(p->canvas.area(), 96, 72);
            if (seed % 3 == 0)
                view.scale = 1.5, view.rotation = double(seed), view.mirrored = seed % 2;
            const auto picture = DifferentiablePicture::draw(p, p->end(), view);
            QVERIFY2(picture, qPrintable(picture.error()));
            compare(*picture, p, view, *cpu, seed);
            compare(*picture, p, view, *reference, seed);
            if (QTest::currentTestFailed())
                return;
        }
    }

    void aPaintingHasTheDerivativesOfItsNumbers()
    {
        std::vector<Stroke> strokes{stroke(1, Shape::Curved, {30, 20}, 12, 4, styleOf(StyleKind::Uniform)),
                                    stroke(2, Shape::Straight, {30, 24}, 15, 5, styleOf(StyleKind::Feathering))};
        strokes[0].visible = false;
        strokes[1].segments[0].born = 5'000'000; // not there yet
        const auto p = painting(strokes, 60, 40);
        const View view = View::ofArea(p->canvas.area(), 60, 40);
        auto picture = DifferentiablePicture::draw(p, 1'000'000, view);
        QVERIFY2(picture, qPrintable(picture.error()));
        const auto by = randomLoss<float>(1, 60, 40);
        const PictureGradient gradient = picture->backward(by);
        QCOMPARE(gradient.strokes.size(), std::size_t(2));
        for (const SegmentSlopes &s : gradient.strokes[0].segments)
            QCOMPARE(s.density, 0.0);
        QCOMPARE(gradient.strokes[1].segments[0].density, 0.0);
        const Segment &segment = strokes[1].segments[1];
        const SegmentSlopes &slopes = gradient.strokes[1].segments[1];
        auto flat = flatten(*p, 1'000'000, view, 1);
        QVERIFY2(flat, qPrintable(flat.error()));
        QCOMPARE(flat->segments.front(), std::size_t(1));
        SceneGradient<double> exact;
        exact.choose(flat->scene);
        const auto loss = [&](const Stroke &changed) {
            std::vector<Stroke> all = strokes;
            all[1] = changed;
            const auto q = flatten(*painting(all, 60, 40), 1'000'000, view, 1);
            return lossOf(exact, q->scene, randomLoss<double>(1, 60, 40));
        };
        Stroke more = strokes[1], less = strokes[1];
        more.segments[1].diffusion *= 1.01f, less.segments[1].diffusion *= 0.99f;
        const double byDiffusion = (loss(more) - loss(less)) / (0.02 * double(segment.diffusion));
        QVERIFY(std::abs(slopes.diffusion - byDiffusion) < 1e-3 * std::abs(byDiffusion));
        more = less = strokes[1];
        more.segments[1].bezier[2].x += 0.01f, less.segments[1].bezier[2].x -= 0.01f;
        const double byPoint = (loss(more) - loss(less)) / 0.02;
        QVERIFY(std::abs(slopes.bezier[2].x - byPoint) < 1e-3 * std::abs(byPoint) + 1e-4);
    }

    void whatFadesHasTheDerivativesOfItsNumbers()
    {
        Stroke faded = stroke(1, Shape::Curved, {30, 20}, 12, 4, styleOf(StyleKind::Edge));
        faded.segments[1].fade = true, faded.segments[1].start = true;
        const auto p = painting({faded}, 60, 40);
        const View view = View::ofArea(p->canvas.area(), 60, 40);
        auto picture = DifferentiablePicture::draw(p, p->end(), view);
        QVERIFY2(picture, qPrintable(picture.error()));
        const SegmentSlopes slopes = picture->backward(randomLoss<float>(1, 60, 40)).strokes[0].segments[1];
        const auto flat = flatten(*p, p->end(), view, 1);
        QVERIFY2(flat, qPrintable(flat.error()));
        SceneGradient<double> exact;
        exact.choose(flat->scene);
        const auto loss = [&](auto change) {
            Stroke changed = faded;
            change(changed.segments[1]);
            const auto q = flatten(*painting({changed}, 60, 40), p->end(), view, 1);
            return lossOf(exact, q->scene, randomLoss<double>(1, 60, 40));
        };
        const auto agrees = [&](double slope, auto number, float step) {
            const double by =
                (loss([&](Segment &s) { number(s) += step; }) - loss([&](Segment &s) { number(s) -= step; })) /
                (2 * double(step));
            return std::abs(by) > 1e-3 && std::abs(slope - by) < 1e-3 * std::abs(by) + 1e-4;
        };
        const Segment &own = faded.segments[1];
        QVERIFY(agrees(
            slopes.density, [](Segment &s) -> float & { return s.density; }, 0.01f * own.density));
        QVERIFY(agrees(
            slopes.diffusion, [](Segment &s) -> float & { return s.diffusion; }, 0.01f * own.diffusion));
        QVERIFY(agrees(
            slopes.bezier[2].x, [](Segment &s) -> float & { return s.bezier[2].x; }, 0.01f));
        QVERIFY(agrees(
            slopes.bezier[2].y, [](Segment &s) -> float & { return s.bezier[2].y; }, 0.01f));
        QCOMPARE(slopes.opacity, 0.0);
        QCOMPARE(slopes.colour[0], 0.0);
    }

    /// The picture of a stroke that fades tells how much it does, from the picture of one that fades less.
    void aFitFindsHowMuchAStrokeFades()
    {
        SceneKind kind;
        kind.fades = true, kind.least = 4;
        FlatScene scene = randomScene(5, 1, 48, 48, kind);
        for (int j = 0; j < 4; ++j) // across the middle of the segment before it
            scene.segments[2].x[j] = scene.segments[1].x[j], scene.segments[2].y[j] = scene.segments[1].y[3 - j];
        SceneGradient<float> gradient;
        gradient.choose(scene);
        const std::span<const float> drawn = gradient.draw(scene);
        const std::vector<float> target(drawn.begin(), drawn.end());
        double &density = scene.segments[2].density;
        const double wanted = density;
        density *= 0.3;
        for (int step = 0; step < 12; ++step) {
            const FlatGradient &by = gradient.drawAndDifferentiate(
                scene, [&](std::size_t first, std::size_t count, const float *rgb, float *out) {
                    for (std::size_t i = 0; i < 3 * count; ++i)
                        out[i] = 2 * (rgb[i] - target[3 * first + i]);
                });
            double loss = 0;
            for (std::size_t i = 0; i < target.size(); ++i)
                loss += std::pow(double(gradient.picture()[i]) - double(target[i]), 2);
            if (loss < 1e-8)
                break;
            density -= 2 * loss / by.segments[2].density; // exact where the loss is a square
        }
        QVERIFY2(std::abs(density / wanted - 1) < 1e-3, qPrintable(QString::number(density / wanted)));
    }

    void whatIsNotSeenHasNoDerivatives()
    {
        SceneKind kind;
        FlatScene scene = randomScene(3, 4, 40, 30, kind);
        for (SegmentNumbers &s : scene.segments)
            for (int i = 0; i < 4; ++i)
                s.x[i] += 1000;
        SceneGradient<float> gradient;
        gradient.choose(scene);
        const std::span<const float> picture = gradient.draw(scene);
        for (std::size_t i = 3; i < picture.size(); ++i)
            QCOMPARE(picture[i], picture[i - 3]);
        const FlatGradient &by = gradient.backward(randomLoss<float>(1, 40, 30));
        QCOMPARE(normOf(scene, by), 0.0);
        // Strokes that the view cuts off, and pictures smaller than a tile.
        for (const auto &[w, h] : {std::pair{1, 1}, {17, 1}, {1, 40}}) {
            FlatScene cut = randomScene(4, 3, w, h, kind);
            SceneGradient<double> exact;
            exact.choose(cut, {1e-7});
            const auto weights = randomLoss<double>(2, w, h);
            lossOf(exact, cut, weights);
            const FlatGradient slopes = exact.backward(weights);
            const double norm = normOf(cut, slopes);
            forEachNumber(cut, slopes, [&](double &number, double derivative, double scale) {
                const double error =
                    errorOf(derivative, number, scale, norm, [&] { return lossOf(exact, cut, weights); });
                QVERIFY2(error < 1e-6, qPrintable(QString::number(error)));
            });
        }
        FlatScene empty;
        empty.view = viewOf(20, 10, false);
        gradient.choose(empty);
        QCOMPARE(gradient.draw(empty).size(), std::size_t(600));
        QVERIFY(gradient.backward(randomLoss<float>(1, 20, 10)).segments.empty());
    }

    void whatHasNoGradientIsNamed()
    {
        const auto messageOf = [](const Stroke &s, const std::vector<Group> &groups = {}) {
            const auto p = painting({s}, 60, 40);
            auto grouped = std::make_shared<Painting>(*p);
            grouped->groups = groups;
            const auto flat = flatten(*grouped, p->end(), View::ofArea(p->canvas.area(), 60, 40), 1);
            return flat ? QString() : flat.error();
        };
        const Stroke plain = stroke(3, Shape::Curved, {30, 20}, 12, 4, styleOf(StyleKind::Edge));
        QCOMPARE(messageOf(plain), QString());
        Stroke s = plain;
        s.segments[1].lift = true;
        QVERIFY(messageOf(s).startsWith("stroke 3: its picture has no gradient, since paint is taken away"));
        s.segments[1].lift = false, s.segments[1].fade = true;
        QCOMPARE(messageOf(s), QString());
        s.segments[1].diffusion = 1.7f * 1.7f / 4;
        QVERIFY(messageOf(s).contains("a spread of 1.7 units, and 2 are"));
        s = plain;
        s.segments[1].style = styleOf(StyleKind::Uniform);
        QVERIFY(messageOf(s).contains("style varies"));
        s.segments[1].fade = true; // It has no style.
        QCOMPARE(messageOf(s), QString());
        s = plain;
        s.segments[1].anisotropyRatio = 4;
        QVERIFY(messageOf(s).contains("anisotropy"));
        s = stroke(3, Shape::Looping, {30, 20}, 12, 4, styleOf(StyleKind::Edge));
        s.fill = Fill();
        QVERIFY(messageOf(s).contains("crosses itself"));
        s = plain;
        s.segments[2].diffusion = 0.1f;
        QVERIFY(messageOf(s).contains("a spread of 0.63"));
        s = plain;
        s.group = 1;
        Group group;
        group.id = 1;
        QCOMPARE(messageOf(s, {group}), QString()); // It is passed through.
        group.opacity = 0.5f;
        QVERIFY(messageOf(s, {group}).contains("layer of its own"));
    }
};

QTEST_GUILESS_MAIN(TestPictureGradient)
#include "test_picture_gradient.moc"

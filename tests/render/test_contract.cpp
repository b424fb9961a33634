// The CPU renderer against the reference, 1/512 per channel at every pixel (docs/solver.md, "Tolerance").
#include "tests/render/paintings.h"

using namespace suffuse;
using namespace suffuse::test;

class TestContract : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);

    void compare(const PaintingPtr &p, const View &view, Microseconds time = -1, bool transparent = false)
    {
        const FloatPicture a = test::render(*m_cpu, p, view, time, transparent);
        const FloatPicture b = test::render(*m_reference, p, view, time, transparent);
        const Worst w = worst(a, b);
        QVERIFY2(w.difference <= 1.0 / 512,
                 qPrintable(QStringLiteral("%1/512 at %2, %3").arg(w.difference * 512).arg(w.x).arg(w.y)));
    }

private slots:
    void everyStyleMixingAndShape()
    {
        for (StyleKind kind : {StyleKind::Uniform, StyleKind::Feathering, StyleKind::Edge})
            for (const Mix mix : {Mix{}, Mix{MixMode::Beta, 0.8f}})
                for (Shape shape : allShapes) {
                    Stroke below = stroke(1, Shape::Curved, {50, 30}, 30, 9, styleOf(StyleKind::Uniform), {},
                                          {0.9f, 0.2f, 0.1f, 1});
                    const auto p = painting({below, stroke(2, shape, {48, 36}, 25, 6, styleOf(kind), mix)});
                    compare(p, View::ofArea(p->canvas.area(), 96, 72));
                    if (QTest::currentTestFailed())
                        QFAIL(qPrintable(QStringLiteral("style %1 mix %2 shape %3")
                                             .arg(int(kind))
                                             .arg(int(mix.mode))
                                             .arg(int(shape))));
                }
    }

    void steepStyles()
    {
        for (const Style style :
             {Style{StyleKind::Uniform, {0.5f, 0.001f, 0}}, Style{StyleKind::Uniform, {0.1f, 0.05f, 0}},
              Style{StyleKind::Uniform, {0.05f, 1.0f, 0}}, Style{StyleKind::Feathering, {0.6f, 64, 0}},
              Style{StyleKind::Feathering, {1, 0.5f, 0}}, Style{StyleKind::Feathering, {0.1f, 4, 0}},
              Style{StyleKind::Edge, {0.3f, 0.37f, 1}}, Style{StyleKind::Edge, {0.3f, 0.1f, 0.05f}},
              Style{StyleKind::Edge, {0.8f, 0.9f, 0.7f}}})
            for (double spread : {1.2, 5.0, 14.0}) {
                const auto p = painting({stroke(1, Shape::Curved, {48, 36}, 35, spread, style),
                                         stroke(2, Shape::Looping, {40, 36}, 25, spread, style)});
                compare(p, View::ofArea(p->canvas.area(), 96, 72));
                if (QTest::currentTestFailed())
                    QFAIL(qPrintable(QStringLiteral("kind %1 xi %2 %3 %4 spread %5")
                                         .arg(int(style.kind))
                                         .arg(double(style.xi[0]))
                                         .arg(double(style.xi[1]))
                                         .arg(double(style.xi[2]))
                                         .arg(spread)));
            }
    }

    void randomPaintings()
    {
        std::mt19937_64 random(7);
        Paper papers[4];
        for (int i = 1; i < 4; ++i)
            papers[i] = {PaperKind::Procedural, 5, i == 3 ? 8.0f : 20.0f, 0.8f, {}, PaperGrain(i - 1)};
        for (int i = 0; i < 12; ++i) {
            const auto p = painting(randomStrokes(random, 12, 96, 72), 96, 72, papers[i % 4]);
            compare(p, View::ofArea(p->canvas.area(), 96, 72), -1, i % 3 == 2);
            compare(p, View::ofArea(p->canvas.area(), 96, 72), 600000); // still spreading
        }
    }

    void longStrokes()
    {
        // Pen-like strokes of 70 segments: their dry blocks are merged into fewer nodes.
        std::mt19937_64 random(21);
        std::normal_distribution<double> normal;
        for (int i = 0; i < 6; ++i) {
            Stroke s = stroke(1, Shape::Tiny, {}, 1, 3 + 2 * i, randomStyle(random));
            const Segment first = s.segments.front();
            s.origin = {};
            s.segments.clear();
            Point at{10, 20.0 + 5 * i}, handle{2, 1};
            for (int k = 0; k < 70; ++k) {
                const Point next =
                    at + Point{1.4 + 0.3 * normal(random), 2.5 * std::sin(0.2 * k) + 0.3 * normal(random)};
                const Point turn{1 + 0.2 * normal(random), 0.8 * std::cos(0.2 * k)};
                Segment g = first;
                g.bezier = {toOffset(at, {}), toOffset(at + 0.4 * handle, {}), toOffset(next - 0.4 * turn, {}),
                            toOffset(next, {})};
                g.density = float(1.2 * std::sqrt(std::numbers::pi) * (3 + 2 * i) * (0.7 + 0.3 * std::sin(0.1 * k)));
                if (i % 2)
                    g.colour = {float(0.5 + 0.5 * std::sin(0.15 * k)), 0.3f, 0.9f, 0.8f};
                s.segments.push_back(g);
                at = next, handle = turn;
            }
            const auto p = painting({s}, 128, 96);
            compare(p, View::ofArea(p->canvas.area(), 128, 96));
            compare(p, View{{60, 50}, 7, 0.2, false, 96, 96});
        }
    }

    void scribbles()
    {
        // Passes so faint that only ten of them together show: what each leaves out adds up.
        for (const Style &style :
             {Style{StyleKind::Uniform, {0.5f, 0.005f, 0}}, Style{StyleKind::Feathering, {1, 12, 0}},
              Style{StyleKind::Edge, {0.36f, 0.4f, 0.5f}}}) {
            Stroke s = stroke(1, Shape::Tiny, {}, 1, 6, style);
            const Segment first = s.segments.front();
            s.origin = {};
            s.segments.clear();
            Point at{16, 20};
            for (int pass = 0; pass < 60; ++pass)
                for (int k = 0; k < 8; ++k) {
                    const Point next = at + Point{pass % 2 ? -8.0 : 8.0, 0.6 / 8};
                    Segment g = first;
                    g.bezier = {toOffset(at, {}), toOffset(at + (1.0 / 3) * (next - at), {}),
                                toOffset(at + (2.0 / 3) * (next - at), {}), toOffset(next, {})};
                    g.density = float(0.062 * double(style.xi[0]) * std::sqrt(std::numbers::pi) * 6);
                    s.segments.push_back(g);
                    at = next;
                }
            const auto p = painting({s}, 96, 72);
            compare(p, View::ofArea(p->canvas.area(), 96, 72));
        }
    }

    void zoomedTurnedAndMirrored()
    {
        std::mt19937_64 random(11);
        const auto tooth = painting(randomStrokes(random, 10, 96, 72), 96, 72, {PaperKind::Procedural, 3, 12, 1, {}});
        for (double scale : {0.02, 0.1, 0.4, 3.0, 40.0, 900.0, 20000.0})
            for (double rotation : {0.0, 0.7}) {
                View v{{40.2, 33.1}, scale, rotation, rotation > 0, 48, 40};
                auto p = std::make_shared<Painting>(*tooth);
                if (rotation > 0)
                    p->canvas.paper.grain = scale > 1 ? PaperGrain::Fibres : PaperGrain::Weave;
                compare(p, v);
                if (QTest::currentTestFailed())
                    QFAIL(qPrintable(QStringLiteral("scale %1 rotation %2").arg(scale).arg(rotation)));
            }
    }

    /// Follows an edge from 1:1 to 1e9×, in a document far from 0: each view is centred where the last one was
    /// steepest.
    void deepZoom()
    {
        for (const Style &style :
             {styleOf(StyleKind::Uniform), styleOf(StyleKind::Feathering), styleOf(StyleKind::Edge)}) {
            Stroke s = stroke(1, Shape::Curved, {10053.3, -9947.7}, 30, 9, style);
            s.segments[1].colour = {0.9f, 0.4f, 0.2f, 1};
            const auto p = painting({s});
            Point centre = s.origin;
            for (double scale = 1; scale < 2e9; scale *= 8) {
                const View v{centre, std::min(scale, 1e9), 0, false, 40, 40};
                compare(p, v);
                if (QTest::currentTestFailed())
                    QFAIL(qPrintable(QStringLiteral("style %1 at %2x").arg(int(style.kind)).arg(scale)));
                const FloatPicture picture = test::render(*m_reference, p, v);
                double steepest = -1;
                for (int y = 4; y < 36; ++y)
                    for (int x = 4; x < 36; ++x)
                        if (const double d = std::abs(double(picture.at(x, y)[0]) - double(picture.at(x + 1, y)[0]));
                            d > steepest)
                            steepest = d, centre = v.toCanvas({x + 1.0, y + 0.5});
            }
        }
    }

    void anisotropic()
    {
        for (double angle : {0.0, 0.4, 1.5707963267948966})
            for (double ratio : {0.1, 1.0, 9.0}) {
                Stroke s = stroke(1, Shape::Curved, {48, 36}, 30, 5, styleOf(StyleKind::Edge));
                for (Segment &g : s.segments)
                    g.anisotropyRatio = float(ratio), g.anisotropyAngle = float(angle);
                const auto p = painting({s});
                compare(p, View::ofArea(p->canvas.area(), 96, 72));
                compare(p, View{{48, 36}, 1.5, 0.3, true, 64, 64});
            }
    }

    void hairlines()
    {
        for (double spread : {0.02, 0.1, 0.3, 0.7}) {
            Stroke s = stroke(1, Shape::Curved, {20, 16}, 14, spread, styleOf(StyleKind::Uniform));
            Stroke t = stroke(2, Shape::Looping, {20, 16}, 10, 2 * spread, styleOf(StyleKind::Edge));
            const auto p = painting({s, t}, 40, 32);
            compare(p, View::ofArea(p->canvas.area(), 40, 32));
        }
        // Young segments of a live stroke: spreads from a hairline to full size in one stroke.
        Stroke s = stroke(1, Shape::Curved, {20, 16}, 14, 4, styleOf(StyleKind::Uniform));
        for (std::size_t i = 0; i < s.segments.size(); ++i)
            s.segments[i].born = Microseconds(i) * 499000;
        const auto p = painting({s}, 40, 32);
        compare(p, View::ofArea(p->canvas.area(), 40, 32), 1000000);
    }
};

QTEST_GUILESS_MAIN(TestContract)
#include "test_contract.moc"

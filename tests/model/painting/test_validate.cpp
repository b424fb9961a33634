// The border of domains.
#include "model/painting/validate.h"

#include <QTest>

#include <functional>

using namespace suffuse;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

Segment goodSegment()
{
    Segment s;
    s.bezier = {Offset{0, 0}, {1, 0}, {2, 0}, {3, 0}};
    return s;
}

std::shared_ptr<Stroke> goodStroke(StrokeId id = 1, GroupId group = 0)
{
    auto s = std::make_shared<Stroke>();
    s->id = id;
    s->group = group;
    s->segments = {goodSegment(), goodSegment()};
    s->segments[1].bezier[0] = s->segments[0].bezier[3];
    return s;
}

} // namespace

class TestValidate : public QObject {
    Q_OBJECT

    /// Refuses, naming the path, what each change makes of a good segment.
    void refuses(const QString &path, const std::function<void(Segment &)> &change)
    {
        Segment s = goodSegment();
        change(s);
        const QString problem = problemOf(s);
        QVERIFY2(problem.startsWith(path + QLatin1Char(':')), qPrintable(path + QLatin1String(" / ") + problem));
    }
    void accepts(const std::function<void(Segment &)> &change)
    {
        Segment s = goodSegment();
        change(s);
        QCOMPARE(problemOf(s), QString());
    }

private slots:
    void everyFloatIsGuarded()
    {
        for (float bad : {notANumber, infinite, -infinite, -1.0f}) {
            refuses(QStringLiteral("diffusion"), [bad](Segment &s) { s.diffusion = bad; });
            refuses(QStringLiteral("density"), [bad](Segment &s) { s.density = bad; });
            refuses(QStringLiteral("granulation"), [bad](Segment &s) { s.granulation = bad; });
            refuses(QStringLiteral("maxAge"), [bad](Segment &s) { s.maxAge = bad; });
            refuses(QStringLiteral("colour[2]"), [bad](Segment &s) { s.colour.blue = bad; });
            refuses(QStringLiteral("colour[3]"), [bad](Segment &s) { s.colour.opacity = bad; });
            refuses(QStringLiteral("anisotropy.ratio"), [bad](Segment &s) { s.anisotropyRatio = bad; });
            refuses(QStringLiteral("style.xi[0]"), [bad](Segment &s) {
                s.style = Style{StyleKind::Edge, {bad, 1, 1}};
            });
        }
        refuses(QStringLiteral("bezier[2][1]"), [](Segment &s) { s.bezier[2].y = notANumber; });
        refuses(QStringLiteral("bezier[3][0]"), [](Segment &s) { s.bezier[3].x = -infinite; });
        refuses(QStringLiteral("anisotropy.angle"), [](Segment &s) { s.anisotropyAngle = notANumber; });
    }

    void boundsAreWhereTheContractHasThem()
    {
        accepts([](Segment &s) { s.diffusion = 1e12f; });
        refuses(QStringLiteral("diffusion"), [](Segment &s) { s.diffusion = 1.0001e12f; });
        refuses(QStringLiteral("diffusion"), [](Segment &s) { s.diffusion = 0; });
        accepts([](Segment &s) { s.diffusion = std::numeric_limits<float>::denorm_min(); });
        accepts([](Segment &s) { s.density = 0; });
        accepts([](Segment &s) { s.density = 1e12f; });
        refuses(QStringLiteral("density"), [](Segment &s) { s.density = 2e12f; });
        accepts([](Segment &s) { s.maxAge = 1e6f; });
        refuses(QStringLiteral("maxAge"), [](Segment &s) { s.maxAge = 1.00001e6f; });
        accepts([](Segment &s) { s.born = -1'000'000'000'000'000; });
        refuses(QStringLiteral("born"), [](Segment &s) { s.born = 1'000'000'000'000'001; });
        refuses(QStringLiteral("born"), [](Segment &s) { s.born = std::numeric_limits<Microseconds>::min(); });
        accepts([](Segment &s) { s.rewet = {{1, 0}, {1, 5}}; });
        refuses(QStringLiteral("rewet[0][1]"), [](Segment &s) { s.rewet = {{1, -1}}; });
        refuses(QStringLiteral("rewet[1][0]"), [](Segment &s) { s.rewet = {{2, 1}, {1, 1}}; });
    }

    void styles()
    {
        const auto style = [](StyleKind kind, float a, float b, float c) { return problemOf(Style{kind, {a, b, c}}); };
        QCOMPARE(style(StyleKind::Uniform, 0.5f, 0.05f, 0), QString());
        QVERIFY(style(StyleKind::Uniform, 0.5f, 0, 0).startsWith(QLatin1String("style.xi[1]:")));
        QVERIFY(style(StyleKind::Uniform, 0.5f, 0.1f, 0.2f).startsWith(QLatin1String("style.xi[2]:")));
        QCOMPARE(style(StyleKind::Feathering, 0.5f, 0.5f, 0), QString());
        QCOMPARE(style(StyleKind::Feathering, 0.5f, 64, 0), QString());
        QVERIFY(style(StyleKind::Feathering, 0.5f, 64.1f, 0).startsWith(QLatin1String("style.xi[1]:")));
        QVERIFY(style(StyleKind::Feathering, 0.5f, 0.49f, 0).startsWith(QLatin1String("style.xi[1]:")));
        for (float xi1 : {0.37f, 1.0f, 3e5f, 7e-6f}) {
            // The border itself survives its rounding to float32, in both ways of computing it.
            QCOMPARE(style(StyleKind::Edge, xi1, float(std::cbrt(2.0) * double(xi1)), 1), QString());
            QCOMPARE(style(StyleKind::Edge, xi1, std::cbrt(2.0f) * xi1, 0.3f), QString());
            QVERIFY(style(StyleKind::Edge, xi1, 1.261f * xi1, 1).startsWith(QLatin1String("style.xi[1]:")));
        }
        QVERIFY(style(StyleKind::Edge, 1, 1, 0).startsWith(QLatin1String("style.xi[2]:")));
        QVERIFY(style(StyleKind::Edge, 1, 1, 1.01f).startsWith(QLatin1String("style.xi[2]:")));
        QVERIFY(problemOf(Mix{MixMode::Beta, 1.5f}).startsWith(QLatin1String("mix.beta:")));
        QVERIFY(problemOf(Mix{MixMode::Alpha, 0.5f}).startsWith(QLatin1String("mix.beta:")));
    }

    void strokes()
    {
        auto s = goodStroke();
        QCOMPARE(problemOf(*s), QString());
        s->segments[1].bezier[0].x = std::nextafter(3.0f, 4.0f);
        QVERIFY(problemOf(*s).startsWith(QLatin1String("segments[1].bezier[0]:")));
        s = goodStroke();
        s->segments[1].density = -3;
        QCOMPARE(problemOf(*s), QStringLiteral("segments[1].density: -3 is not in [0, 1e12]"));
        s->segments.clear();
        QVERIFY(problemOf(*s).startsWith(QLatin1String("segments:")));
        s = goodStroke(0);
        QVERIFY(problemOf(*s).startsWith(QLatin1String("id:")));
        s = goodStroke();
        s->origin.y = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(problemOf(*s).startsWith(QLatin1String("origin[1]:")));
        s->origin = {1e12, 0};
        QVERIFY(problemOf(*s).startsWith(QLatin1String("segments[0].bezier[1][0]:"))); // 1e12 + 1
    }

    void canvases()
    {
        Canvas c;
        QCOMPARE(problemOf(c), QString());
        c.width = 0;
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.width:")));
        c = {};
        c.height = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.height:")));
        c = {};
        c.background.yellow = 2;
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.background[1]:")));
        c = {};
        c.paper.grain = PaperGrain(3);
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.paper.grain:")));
        c.paper.grain = PaperGrain::Weave;
        QVERIFY(problemOf(c).isEmpty());
        c.paper.scale = 0;
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.paper.scale:")));
        c = {};
        c.paper.kind = PaperKind::Image;
        QVERIFY(problemOf(c).startsWith(QLatin1String("canvas.paper.image:")));
    }

    void paintings()
    {
        Painting p;
        QCOMPARE(problemOf(p), QString());
        p.strokes = {goodStroke(1), goodStroke(2), goodStroke(1)};
        QVERIFY(problemOf(p).startsWith(QLatin1String("strokes[2].id:")));
        p.strokes = {goodStroke(1), goodStroke(2, 7)};
        QVERIFY(problemOf(p).startsWith(QLatin1String("strokes[1].group:")));
        p.groups = {{7, {}, 0, true, false}};
        QCOMPARE(problemOf(p), QString());
        p.strokes = {goodStroke(1, 7), goodStroke(2), goodStroke(3, 7)};
        QVERIFY(problemOf(p).startsWith(QLatin1String("strokes[2].group:")));
        // A subgroup's members are the group's.
        p.groups.push_back({8, {}, 7, true, false});
        p.strokes = {goodStroke(1, 7), goodStroke(2, 8), goodStroke(3, 7), goodStroke(4)};
        QCOMPARE(problemOf(p), QString());
        p.strokes.push_back(goodStroke(5, 8));
        QVERIFY(problemOf(p).startsWith(QLatin1String("strokes[4].group:")));
        p.strokes.clear();
        p.groups = {{7, {}, 8, true, false}, {8, {}, 7, true, false}};
        QVERIFY(problemOf(p).startsWith(QLatin1String("groups[0].parent:")));
        p.groups = {{7, {}, 9, true, false}};
        QVERIFY(problemOf(p).startsWith(QLatin1String("groups[0].parent:")));
        p.groups = {{7, {}, 0, true, false}, {7, {}, 0, true, false}};
        QVERIFY(problemOf(p).startsWith(QLatin1String("groups[1].id:")));
    }
};

QTEST_GUILESS_MAIN(TestValidate)
#include "test_validate.moc"

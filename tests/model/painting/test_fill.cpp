// Fills as values: what is allowed, what files hold of them, and what becomes of them when strokes change.
#include "model/document/difference.h"
#include "model/formats/files.h"
#include "model/painting/field_hash.h"
#include "model/painting/tensor.h"
#include "model/painting/validate.h"
#include "model/shaping/transform.h"
#include "tests/model/awkward_strokes.h"
#include "tests/model/formats/suffuse_chunks.h"

#include <QCborMap>
#include <QTest>

#include <numbers>

using namespace suffuse;
using namespace suffuse::test;

namespace {

Stroke filledTriangle()
{
    Stroke s = line({{0, 0}, {10, 0}, {0, 10}});
    Fill fill;
    fill.colour = {0.5f, 0, 0.25f, 0.75f};
    s.fill = fill;
    return s;
}

/// The stroke with its fill changed by `change(fill)`.
template <class Change>
Stroke with(const Stroke &stroke, Change change)
{
    Stroke out = stroke;
    Fill fill = *stroke.fill;
    change(fill);
    out.fill = fill;
    return out;
}

Painting paintingOf(Stroke stroke)
{
    Painting p;
    p.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    return p;
}

QByteArray textOf(const Stroke &stroke)
{
    return writeTextForm(paintingOf(stroke));
}

QByteArray withFill(const QByteArray &fill, int version = 2)
{
    return "{\"format\": \"suffuse-text\", \"version\": " + QByteArray::number(version) +
           ", \"strokes\": [{\"segments\": [{\"bezier\": [[0,0],[1,0],[2,0],[3,0]], \"diffusion\": 1, "
           "\"density\": 1}], \"fill\": " +
           fill + "}]}";
}

QString errorOf(const QByteArray &text)
{
    const auto p = readTextForm(text, QStringLiteral("a.json"));
    return p ? QStringLiteral("no error") : p.error();
}

} // namespace

class TestFill : public QObject {
    Q_OBJECT

private slots:
    void equalByValue()
    {
        const Stroke a = filledTriangle();
        Stroke b = a;
        QVERIFY(a == b);
        b = with(a, [](Fill &) {});
        QVERIFY2(a == b, "another fill of the same values is the same");
        QVERIFY(!(a == with(a, [](Fill &f) { f.rule = FillRule::EvenOdd; })));
        b.fill = {};
        QVERIFY(!(a == b) && !(b == a));
        QVERIFY(hashOf(paintingOf(a)) != hashOf(paintingOf(b)));
        QVERIFY(hashOf(paintingOf(a)) == hashOf(paintingOf(with(a, [](Fill &f) { f.anisotropyAngle = -0.0f; }))));
        QVERIFY(hashOf(paintingOf(a)) != hashOf(paintingOf(with(a, [](Fill &f) { f.born = 1; }))));
        const Gradient gradient{{1, 2}, {3, 4}, {}};
        QVERIFY(hashOf(paintingOf(a)) != hashOf(paintingOf(with(a, [&](Fill &f) { f.gradient = gradient; }))));
    }

    /// Documents hold hashes of paintings, so those of strokes without a fill stay what they were.
    void othersKeepTheirHash()
    {
        Painting p = paintingOf(line({{0, 0}, {10, 0}, {0, 10}}));
        QCOMPARE(hashOf(p).toHex(), QByteArray("442b78b40b43d157eeeb77019c0d759badfa6080c1bc0e43621b9d22de80aad8"));
    }

    void knowsItsTime()
    {
        const Stroke s = with(filledTriangle(), [](Fill &f) { f.born = -2'000'000, f.maxAge = 100; });
        QCOMPARE(s.born(), -2'000'000);
        QCOMPARE(s.driesAt(), 98'000'000);
        QCOMPARE(s.fill->age(-2'000'001) <= 0, true);
        QCOMPARE(s.fill->spread(98'000'000), std::sqrt(4 * 12.5 * 100));
        QCOMPARE(s.fill->spread(-3'000'000), 0.0);
    }

    void outsideIsRefused_data()
    {
        QTest::addColumn<QByteArray>("fill");
        QTest::addColumn<QString>("place");
        const auto row = [](const char *name, const QByteArray &fill, const char *place) {
            QTest::newRow(name) << fill << QString::fromLatin1(place);
        };
        const QByteArray both = "\"diffusion\": 1, \"density\": 1";
        row("D below 0", R"({"diffusion": -1, "density": 1})", "strokes[0].fill.diffusion: -1 is not in [0, 1e12]");
        row("NaN", R"({"diffusion": NaN, "density": 1})", "strokes[0].fill.diffusion");
        row("density below 0", R"({"diffusion": 1, "density": -1})", "strokes[0].fill.density: -1 is not in [0, 1e12]");
        row("density is missing", R"({"diffusion": 1})", "strokes[0].fill.density: is missing");
        row("granulation", "{" + both + ", \"granulation\": 2}", "strokes[0].fill.granulation: 2 is not in [0, 1]");
        row("maxAge", "{" + both + ", \"maxAge\": 0}", "strokes[0].fill.maxAge: 0 is not in (0, 1e6]");
        row("colour", "{" + both + ", \"colour\": [0,0,0,2]}", "strokes[0].fill.colour[3]: 2 is not in [0, 1]");
        row("rule", "{" + both + ", \"rule\": \"odd\"}", "strokes[0].fill.rule: ");
        row("born", "{" + both + ", \"born\": 2e9}", "strokes[0].fill.born: 2e+09 is not in [-1e9, 1e9]");
        row("unknown", "{" + both + ", \"spread\": 1}", "strokes[0].fill.spread");
        row("gradient without colour", "{" + both + ", \"gradient\": {\"from\": [0,0], \"to\": [1,0]}}",
            "strokes[0].fill.gradient.colour: is missing");
        row("gradient of one point",
            "{" + both + ", \"gradient\": {\"from\": [1,0], \"to\": [1,0], \"colour\": [0,0,0,1]}}",
            "strokes[0].fill.gradient.to: it is the same point as from");
        row("gradient far away",
            "{" + both + ", \"gradient\": {\"from\": [1,0], \"to\": [1,2e12], \"colour\": [0,0,0,1]}}",
            "strokes[0].fill.gradient.to[1]: 1.99999999e+12 is not in [-1e12, 1e12]");
        row("anisotropy", "{" + both + ", \"anisotropy\": {\"ratio\": 0, \"angle\": 0}}",
            "strokes[0].fill.anisotropy.ratio: 0 is not in [1e-6, 1e6]");
        row("no object", "3", "strokes[0].fill");
    }
    void outsideIsRefused()
    {
        QFETCH(QByteArray, fill);
        QFETCH(QString, place);
        const QString error = errorOf(withFill(fill));
        QVERIFY2(error.contains(place), qPrintable(error));
    }

    void versionsOfTheTextForm()
    {
        const QByteArray fill = R"({"diffusion": 2, "density": 1.5})";
        QCOMPARE(errorOf(withFill(fill)), QStringLiteral("no error"));
        const QString error = errorOf(withFill(fill, 1));
        QVERIFY2(error.contains(QLatin1String("version")), qPrintable(error));
        const auto p = readTextForm(withFill(fill), QStringLiteral("a.json"));
        Fill usual;
        usual.diffusion = 2, usual.density = 1.5f;
        QVERIFY(p->strokes[0]->fill == SharedFill(usual));
        QVERIFY(writeTextForm(*p).startsWith(R"({"format": "suffuse-text", "version": 2,)"));
        Stroke without = *p->strokes[0];
        without.fill = {};
        QVERIFY(!textOf(without).contains("fill") && textOf(without).contains("\"version\": 1,"));
    }

    void textIsExact()
    {
        const Stroke s = with(filledTriangle(), [](Fill &f) {
            f.gradient = {{1, -0.1f}, {30, 1e-30f}, {1, 0.1f, 0, 0.5f}};
            f.rule = FillRule::EvenOdd;
            f.anisotropyRatio = 3;
            f.born = 16'000;
        });
        const QByteArray text = textOf(s);
        QVERIFY2(
            text.contains(R"("fill": {"diffusion": 12.5, "density": 1, "granulation": 1, "maxAge": 1, "born": 0.016, )"
                          R"("colour": [0.5,0,0.25,0.75], "rule": "evenodd", "gradient": {"from": [1,-0.1], )"
                          R"("to": [30,1e-30], "colour": [1,0.1,0,0.5]}, "anisotropy": {"ratio": 3, "angle": 0}})"),
            text.constData());
        const auto again = readTextForm(text, QStringLiteral("a.json"));
        QVERIFY2(again, again ? "" : qPrintable(again.error()));
        QVERIFY(*again->strokes[0] == s);
    }

    /// A document that has none is what it was before there were fills, and one that has asks for a reader that knows
    /// them.
    void documentsAskForAReader()
    {
        const auto reader = [](const QByteArray &file) -> qint64 {
            for (const auto &[type, payload] : chunksOf(file))
                if (type == "HEAD")
                    return QCborValue::fromCbor(payload).toMap().value(QLatin1String("reader")).toInteger();
            return -1;
        };
        Stroke without = filledTriangle();
        without.fill = {};
        QCOMPARE(reader(writeSuffuseFile(paintingOf(without))), 1);
        Painting p = paintingOf(filledTriangle());
        auto second = std::make_shared<Stroke>(without);
        second->id = 2;
        p.strokes.push_back(second);
        auto third = std::make_shared<Stroke>(with(filledTriangle(), [](Fill &f) {
            f.gradient = {{0, 0}, {1, 1}, {}};
            f.born = std::numeric_limits<std::int32_t>::min();
        }));
        third->id = 9;
        p.strokes.push_back(third);
        const QByteArray file = writeSuffuseFile(p);
        QCOMPARE(reader(file), 2);
        const auto read = readPainting(file, QStringLiteral("a.suffuse"));
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QVERIFY(*read == p);
    }

    void differencesAreNamed()
    {
        const Stroke a = filledTriangle();
        const auto changed = differenceOf(a, with(a, [](Fill &f) { f.density = 3; })).values;
        QCOMPARE(changed.size(), std::size_t(1));
        QCOMPARE(changed[0],
                 (ValueDifference{QStringLiteral("fill.density"), QStringLiteral("1"), QStringLiteral("3")}));
        Stroke without = a;
        without.fill = {};
        const auto added = differenceOf(without, a).values;
        QVERIFY(added.size() > 5);
        QCOMPARE(added[0],
                 (ValueDifference{QStringLiteral("fill.diffusion"), QStringLiteral("null"), QStringLiteral("12.5")}));
    }

    void isMappedWithItsStroke()
    {
        const Stroke s = with(filledTriangle(), [](Fill &f) { f.gradient = {{2, 1}, {6, 4}, {}}; });
        const auto twice = transformed(s, Affine::about({}, 0, -2, 2, 0), SpreadRule::Scales);
        QCOMPARE(twice.fill->diffusion, 4 * s.fill->diffusion);
        QCOMPARE(twice.fill->density, s.fill->density);
        QCOMPARE(twice.fill->gradient->from, (Offset{-2, 4}));
        QCOMPARE(twice.fill->gradient->to, (Offset{-8, 12}));
        QCOMPARE(transformed(s, Affine::about({}, 0, -2, 2, 0), SpreadRule::Stays).fill->diffusion, s.fill->diffusion);
        // The place between the colours is the same at mapped points, and so is the tensor's quadratic form.
        const Affine map = Affine::about({}, 3, 0.5, -1, 0.7);
        const Stroke uneven = transformed(s, map, SpreadRule::Scales);
        const auto placeAt = [](const Gradient &g, Point x) {
            const Point from = Point() + g.from, along = (Point() + g.to) - from;
            return dot(x - from, along) / dot(along, along);
        };
        for (const Point x : {Point{0, 0}, Point{5, -3}, Point{-2, 8}})
            QVERIFY(std::abs(placeAt(*uneven.fill->gradient, map(x)) - placeAt(*s.fill->gradient, x)) < 1e-5);
        const Tensor tensor = tensorOf(*uneven.fill), wanted = mapped(tensorOf(*s.fill), map);
        QVERIFY(std::abs(tensor.xx - wanted.xx) + std::abs(tensor.xy - wanted.xy) + std::abs(tensor.yy - wanted.yy) <
                1e-4 * wanted.xx);
        QCOMPARE(uneven.fill->density, s.fill->density);
    }
};

QTEST_GUILESS_MAIN(TestFill)
#include "test_fill.moc"

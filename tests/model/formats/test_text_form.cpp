// docs/text-form.md: exact both ways; what is wrong is named with its place.
#include "model/formats/files.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"
#include "tests/model/random_paintings.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace suffuse;

namespace {

QByteArray documentOf(const QByteArray &strokes, const QByteArray &more = {})
{
    return "{\"format\": \"suffuse-text\", \"version\": 1, \"strokes\": [" + strokes + "]" + more + "}";
}

QByteArray strokeOf(const QByteArray &segments, const QByteArray &more = {})
{
    return "{\"segments\": [" + segments + "]" + more + "}";
}

QByteArray segmentOf(const QByteArray &more = {}, const QByteArray &bezier = "[[0,0],[1,0],[2,0],[3,0]]")
{
    return "{\"bezier\": " + bezier + ", \"diffusion\": 12.5, \"density\": 9" + more + "}";
}

QString errorOf(const QByteArray &text)
{
    const auto p = readTextForm(text, QStringLiteral("a.json"));
    return p ? QStringLiteral("no error") : p.error();
}

} // namespace

class TestTextForm : public QObject {
    Q_OBJECT

private slots:
    void randomPaintingsComeBack()
    {
        for (quint32 seed = 0; seed < 60; ++seed) {
            test::RandomPaintings random(seed);
            const Painting p = random.painting(6, 12);
            QCOMPARE(problemOf(p), QString());
            const QByteArray text = writeTextForm(p);
            const auto q = readTextForm(text, QStringLiteral("a.json"));
            QVERIFY2(q, q ? "" : qPrintable(q.error()));
            const QByteArray again = writeTextForm(*q);
            QCOMPARE(again, text);
            QVERIFY(hashOf(*q) == hashOf(*readTextForm(again, QStringLiteral("b.json"))));
            // An underlay's far corner is rounded once, when it comes in.
            Painting withoutUnderlay = p, other = *q;
            withoutUnderlay.underlay = other.underlay = nullptr;
            QVERIFY(withoutUnderlay == other);
        }
    }

    void everyFloatComesBack()
    {
        QRandomGenerator random(5);
        for (int k = 0; k < 20000; ++k) {
            auto s = std::make_shared<Stroke>();
            s->id = 1;
            Segment &segment = s->segments.emplace_back();
            float v = 0;
            do {
                v = std::bit_cast<float>(random.generate());
            } while (!(std::abs(v) <= 9e11f));
            segment.bezier[1] = {v, -v};
            segment.born = Microseconds(random.generate64() % 2'000'000'000'000'000) - 1'000'000'000'000'000;
            Painting p;
            p.strokes.push_back(s);
            const auto q = readTextForm(writeTextForm(p), QStringLiteral("a.json"));
            QVERIFY2(q, q ? "" : qPrintable(q.error()));
            QCOMPARE(std::bit_cast<quint32>(q->strokes[0]->segments[0].bezier[1].x), std::bit_cast<quint32>(v));
            QCOMPARE(q->strokes[0]->segments[0].born, segment.born);
        }
    }

    void oneSegmentALine()
    {
        const auto p =
            readTextForm(documentOf(strokeOf(segmentOf() + "," + segmentOf({}, "[[3,0],[4,0],[5,0],[6,0]]"))),
                         QStringLiteral("a.json"));
        QVERIFY(p);
        const QByteArray text = writeTextForm(*p);
        int lines = 0;
        for (const QByteArray &line : text.split('\n')) {
            QVERIFY(line.count("\"bezier\"") <= 1);
            lines += int(line.count("\"bezier\""));
        }
        QCOMPARE(lines, 2);
        for (const char *absent :
             {"origin", "brush\"", "anisotropy", "node", "rewet", "groups", "swatches", "underlay", "seed"})
            QVERIFY2(!text.contains(absent), absent);
        QVERIFY(text.contains("\"diffusion\": 12.5, \"density\": 9, \"granulation\": 1, \"maxAge\": 1, \"born\": 0, "
                              "\"colour\": [0,0,0,1]"));
    }

    void missingMembersTakeDefaults()
    {
        const auto p = readTextForm("\xef\xbb\xbf \n" +
                                        documentOf(strokeOf(segmentOf()) + "," + strokeOf(segmentOf(), ", \"id\": 41") +
                                                   "," + strokeOf(segmentOf(), ", \"group\": null")),
                                    QStringLiteral("a.json"));
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(p->canvas, Canvas());
        QCOMPARE(p->strokes[0]->id, StrokeId(42));
        QCOMPARE(p->strokes[1]->id, StrokeId(41));
        QCOMPARE(p->strokes[2]->id, StrokeId(43));
        Segment usual;
        usual.bezier = {Offset{0, 0}, {1, 0}, {2, 0}, {3, 0}};
        QVERIFY(p->strokes[0]->segments[0] == usual);
    }

    void numbersAreRoundedOnce()
    {
        const auto p =
            readTextForm(documentOf(strokeOf(segmentOf(", \"born\": 0.0160004, \"granulation\": 1e-60, \"maxAge\": 0.1",
                                                       "[[0.1,-1E+2],[1,0],[2,0],[3,0]]"))),
                         QStringLiteral("a.json"));
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        const Segment &s = p->strokes[0]->segments[0];
        QCOMPARE(s.born, Microseconds(16000));
        QCOMPARE(s.granulation, 0.0f);
        QCOMPARE(s.maxAge, 0.1f);
        QCOMPARE(s.bezier[0].x, 0.1f);
        QCOMPARE(s.bezier[0].y, -100.0f);
        QVERIFY(writeTextForm(*p).contains("\"born\": 0.016,"));
    }

    void badContentIsNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("message");
        const auto row = [](const char *tag, const QByteArray &text, const char *message) {
            QTest::newRow(tag) << text << QString::fromUtf8(message);
        };
        const auto segment = [](const QByteArray &more) { return documentOf(strokeOf(segmentOf(more))); };
        const QByteArray bad = "{\"bezier\": [[0,0],[1,0],[2,0],[3,0]], \"diffusion\": -3, \"density\": 9}";
        row("domain",
            documentOf(strokeOf(segmentOf()) + "," + strokeOf(segmentOf({}, "[[0,0],[1,0],[2,0],[0,0]]") + "," + bad)),
            "a.json: strokes[1].segments[1].diffusion: -3 is not in (0, 1e12]");
        row("text for a number", segment(", \"born\": \"soon\""),
            "a.json: strokes[0].segments[0].born: \"soon\" is not a number");
        row("null for a number", segment(", \"maxAge\": null"),
            "a.json: strokes[0].segments[0].maxAge: null is not a number");
        row("NaN", segment(", \"maxAge\": NaN"), "maxAge: NaN is not a number");
        row("Infinity", segment(", \"maxAge\": -Infinity"), "maxAge: -Infinity is not a number");
        row("too large", segment(", \"maxAge\": 1e400"), "maxAge: 1e400 is too large");
        row("too large for a float", segment(", \"granulation\": 1e39"), "granulation: 1e39 is too large");
        row("birth out of range", segment(", \"born\": 1e13"), "segments[0].born: 1e13 s is not in");
        row("unknown member", segment(", \"colour2\": 1"), "a.json: strokes[0].segments[0].colour2: is not a member");
        row("given twice", segment(", \"density\": 9"), "strokes[0].segments[0].density: is given twice");
        row("missing", documentOf(strokeOf("{\"bezier\": [[0,0],[1,0],[2,0],[3,0]], \"density\": 9}")),
            "strokes[0].segments[0].diffusion: is missing");
        row("three points", documentOf(strokeOf(segmentOf({}, "[[0,0],[1,0],[2,0]]"))),
            "segments[0].bezier: has 3 points instead of 4");
        row("three coordinates", documentOf(strokeOf(segmentOf({}, "[[0,0],[1,0,0],[2,0],[3,0]]"))),
            "bezier[1]: has 3 numbers instead of 2");
        row("short colour", segment(", \"colour\": [0,0,0]"), "segments[0].colour: has 3 numbers instead of 4");
        row("colour out of range", segment(", \"colour\": [0,0,1.5,1]"), "segments[0].colour[2]: 1.5 is not in [0, 1]");
        row("broken join", documentOf(strokeOf(segmentOf() + "," + segmentOf())), "strokes[0].segments[1].bezier[0]");
        row("no segments", documentOf(strokeOf({})), "strokes[0].segments");
        row("same id", documentOf(strokeOf(segmentOf(), ", \"id\": 1") + "," + strokeOf(segmentOf(), ", \"id\": 1")),
            "strokes[1].id");
        row("id 0", documentOf(strokeOf(segmentOf(), ", \"id\": 0")), "strokes[0].id: 0 is not an id");
        row("negative id", documentOf(strokeOf(segmentOf(), ", \"id\": -1")),
            "strokes[0].id: -1 is not a whole number");
        row("broken id", documentOf(strokeOf(segmentOf(), ", \"id\": 1.5")),
            "strokes[0].id: 1.5 is not a whole number");
        row("no such group", documentOf(strokeOf(segmentOf(), ", \"group\": 4")), "strokes[0].group");
        row("style kind", documentOf(strokeOf(segmentOf(), ", \"style\": {\"kind\": \"wet\", \"xi\": [1,1]}")),
            "strokes[0].style.kind: “wet” is none of: uniform, feathering, edge");
        row("style count", documentOf(strokeOf(segmentOf(), ", \"style\": {\"kind\": \"edge\", \"xi\": [1,1]}")),
            "strokes[0].style.xi: has 2 numbers; the kind edge has 3");
        row("style count 2", segment(", \"style\": {\"xi\": [1,1,1,1], \"kind\": \"uniform\"}"),
            "segments[0].style.xi: has 4 numbers; the kind uniform has 2");
        row("beta without mode", documentOf(strokeOf(segmentOf(), ", \"mix\": {\"mode\": \"alpha\", \"beta\": 1}")),
            "strokes[0].mix.beta: belongs to");
        row("beta missing", documentOf(strokeOf(segmentOf(), ", \"mix\": {\"mode\": \"beta\"}")),
            "strokes[0].mix.beta: is missing");
        row("visible", documentOf(strokeOf(segmentOf(), ", \"visible\": 1")),
            "strokes[0].visible: 1 is not true or false");
        row("name", documentOf(strokeOf(segmentOf(), ", \"name\": [1]")), "strokes[0].name: […] is not a string");
        row("latin-1", documentOf(strokeOf(segmentOf(), ", \"name\": \"\xe4\"")), "strokes[0].name: is not UTF-8");
        row("strokes an object", "{\"format\": \"suffuse-text\", \"version\": 1, \"strokes\": {}}",
            "strokes: {…} is not a list");
        row("no strokes", "{\"format\": \"suffuse-text\", \"version\": 1}", "a.json: strokes: is missing");
        row("no format", "{\"version\": 1, \"strokes\": []}", "a.json: format: is missing");
        row("version", "{\"format\": \"suffuse-text\", \"version\": 6, \"strokes\": []}",
            "version: 6 is newer than this program");
        row("a group that blends in version 2",
            "{\"format\": \"suffuse-text\", \"version\": 2, \"strokes\": [], \"groups\": [{\"id\": 1, \"opacity\": "
            "0.5}]}",
            "version: 2 does not know all");
        row("an unknown mode",
            "{\"format\": \"suffuse-text\", \"version\": 3, \"strokes\": [], \"groups\": [{\"id\": 1, \"blend\": "
            "\"mix\"}]}",
            "groups[0].blend");
        row("an opacity above 1",
            "{\"format\": \"suffuse-text\", \"version\": 3, \"strokes\": [], \"groups\": [{\"id\": 1, \"opacity\": "
            "1.5}]}",
            "groups[0].opacity: 1.5 is not in [0, 1]");
        row("a chain in version 1", segment(", \"start\": true"), "version: 1 does not know all");
        row("lifting in version 1", segment(", \"lift\": true"), "version: 1 does not know all");
        row("fading in version 1", segment(", \"fade\": true"), "version: 1 does not know all");
        row("fading in version 3",
            documentOf(strokeOf(segmentOf(", \"fade\": true"))).replace("\"version\": 1", "\"version\": 3"),
            "version: 3 does not know all");
        row("fade", segment(", \"fade\": 1"), "segments[0].fade: 1 is not true or false");
        row("lift and fade",
            documentOf(strokeOf(segmentOf(", \"lift\": true, \"fade\": true")))
                .replace("\"version\": 1", "\"version\": 4"),
            "segments[0].fade: a segment that lifts cannot fade as well");
        row("lift", segment(", \"lift\": 1"), "segments[0].lift: 1 is not true or false");
        row("canvas", documentOf({}, ", \"canvas\": {\"width\": 0}"), "canvas.width: 0 is not in (0, 1e6]");
        row("paper grain", documentOf({}, ", \"canvas\": {\"paper\": {\"kind\": \"procedural\", \"grain\": \"wool\"}}"),
            "canvas.paper.grain: “wool” is none of: tooth, fibres, weave");
        row("paper image", documentOf({}, ", \"canvas\": {\"paper\": {\"kind\": \"image\"}}"),
            "canvas.paper.image: is missing");
        row("paper file", documentOf({}, ", \"canvas\": {\"paper\": {\"kind\": \"image\", \"image\": \"gone.png\"}}"),
            "canvas.paper.image: the image file");
        row("paper data",
            documentOf({},
                       ", \"canvas\": {\"paper\": {\"kind\": \"none\", \"image\": \"data:image/png;base64,AAAA\"}}"),
            "canvas.paper.image: is not a PNG");
        row("paper base64",
            documentOf({}, ", \"canvas\": {\"paper\": {\"kind\": \"none\", \"image\": \"data:image/png;base64,!\"}}"),
            "canvas.paper.image: the base64");
        row("underlay area",
            documentOf({}, ", \"underlay\": {\"image\": \"data:image/png;base64,iVBORw0KGgo=\", \"area\": [0,0,-1,1]}"),
            "underlay.area: width and height");
        row("group twice", documentOf({}, ", \"groups\": [{\"id\": 1}, {\"id\": 1}]"), "groups[1].id");
    }

    void badContentIsNamed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, message);
        const QString error = errorOf(text);
        QVERIFY2(error.startsWith(QLatin1String("a.json: ")) && error.contains(message), qPrintable(error));
    }

    void syntaxErrorsHaveLineAndColumn_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("place");
        const auto row = [](const char *tag, const QByteArray &text, const char *place) {
            QTest::newRow(tag) << text << QString::fromUtf8(place);
        };
        row("cut off", "{\"format\": \"suffuse-text\",\n \"version\": 1,\n \"strokes\": [", "line 3, column 14");
        row("inside a string", "{\"format\": \"suff", "line 1, column 17");
        row("missing comma", "{\"format\": \"suffuse-text\"\n\"version\": 1}", "line 2, column 1");
        row("trailing comma", "{\"format\": \"suffuse-text\",}", "line 1, column 27");
        row("no colon", "{\"format\" 1}", "line 1, column 11");
        row("no name", "{1: 2}", "line 1, column 2");
        row("after the end", documentOf({}) + "\n\n x", "line 3, column 2");
        row("umlaut before", "{\"format\": \"suffuse-text\", \"version\": 1, \"groups\": [{\"name\": \"äö\" x",
            "line 1, column 67");
        row("escape", "{\"format\": \"\\x\"", "escape");
        row("lone surrogate", "{\"format\": \"\\ud800 \"", "escape");
        row("control character", "{\"format\": \"a\nb\"", "control character");
        row("comment", "{ // no comments\n}", "line 1, column 3");
        row("value missing", "{\"version\": }", "line 1, column 13");
    }

    void syntaxErrorsHaveLineAndColumn()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        const QString error = errorOf(text);
        QVERIFY2(error.startsWith(QLatin1String("a.json: line ")) && error.contains(place), qPrintable(error));
    }

    void hostileInputsEnd()
    {
        const QByteArray deep(5'000'000, '[');
        QVERIFY(errorOf(deep).contains(QLatin1String("not an object")));
        QVERIFY(
            errorOf("{\"strokes\": " + deep).startsWith(QStringLiteral("a.json: strokes[0]: […] is not an object")));
        QVERIFY(errorOf("{\"x\": " + deep).contains(QLatin1String("not a member")));
        QVERIFY(errorOf("{\"version\": " + QByteArray(1'000'000, '9')).contains(QLatin1String("whole number")));
        QVERIFY(errorOf("{\"canvas\": {\"width\": 1" + QByteArray(1'000'000, '0') + "}}")
                    .contains(QLatin1String("too large")));
        QVERIFY(errorOf("{\"canvas\": {\"width\": 1e99999999999999999999}}").contains(QLatin1String("too large")));
        QVERIFY(errorOf("{\"canvas\": {\"width\": 1e-99999999999999999999}}")
                    .contains(QLatin1String("format: is missing")));
        QVERIFY(errorOf({}).contains(QLatin1String("ends here")));
        QVERIFY(errorOf(QByteArray(3, '\0')).contains(QLatin1String("is not an object")));
        const auto p =
            readTextForm(documentOf(strokeOf(segmentOf(), ", \"name\": \"\\u0000\\ud83d\\ude00\\u00e4\\/\"")),
                         QStringLiteral("a.json"));
        QVERIFY(p);
        QCOMPARE(p->strokes[0]->name, QString(QChar(0)) + QStringLiteral("😀ä/"));
    }

    void everyTruncationIsAnError()
    {
        test::RandomPaintings random(11);
        QByteArray text = writeTextForm(random.painting(2, 3)).trimmed();
        for (qsizetype size = 0; size < text.size(); ++size) {
            const auto p = readPainting(text.left(size), QStringLiteral("a.json"));
            QVERIFY2(!p && p.error().startsWith(QLatin1String("a.json: ")), qPrintable(QString::number(size)));
        }
        QVERIFY(readPainting(text, QStringLiteral("a.json")));
    }

    void imagesBesideTheFile()
    {
        QTemporaryDir folder;
        const QByteArray png = QByteArray("\x89PNG\r\n\x1a\n") + "body";
        QFile image(folder.filePath(QStringLiteral("paper.png")));
        QVERIFY(image.open(QIODevice::WriteOnly) && image.write(png) == png.size());
        image.close();
        const QByteArray text =
            documentOf({}, ", \"canvas\": {\"paper\": {\"kind\": \"image\", \"image\": \"paper.png\"}}");
        const auto p = readTextForm(text, folder.filePath(QStringLiteral("a.json")));
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        QCOMPARE(*p->canvas.paper.image, png);
        const QByteArray written = writeTextForm(*p);
        QVERIFY(written.contains("data:image/png;base64,"));
        QVERIFY(*readTextForm(written, QStringLiteral("elsewhere.json")) == *p);
    }

    void colours_data()
    {
        QTest::addColumn<QList<double>>("rgb");
        QTest::addColumn<QList<double>>("ryb");
        QTest::newRow("white") << QList<double>{1, 1, 1} << QList<double>{0, 0, 0};
        QTest::newRow("black") << QList<double>{0, 0, 0} << QList<double>{1, 1, 1};
        QTest::newRow("red") << QList<double>{1, 0, 0} << QList<double>{1, 0, 0};
        QTest::newRow("yellow") << QList<double>{1, 1, 0} << QList<double>{0, 1, 0};
        QTest::newRow("green") << QList<double>{0, 1, 0} << QList<double>{0, 1, 1};
        QTest::newRow("blue") << QList<double>{0, 0, 1} << QList<double>{0, 0, 1};
        QTest::newRow("cyan") << QList<double>{0, 1, 1} << QList<double>{0, 0.5, 1};
        QTest::newRow("magenta") << QList<double>{1, 0, 1} << QList<double>{1, 0, 0.5};
        QTest::newRow("orange") << QList<double>{1, 0.5, 0} << QList<double>{1, 1, 0};
    }

    void colours()
    {
        QFETCH(QList<double>, rgb);
        QFETCH(QList<double>, ryb);
        const auto there = rybFromSrgb(std::array{rgb[0], rgb[1], rgb[2]});
        const auto back = srgbFromRyb(std::array{ryb[0], ryb[1], ryb[2]});
        for (std::size_t k = 0; k < 3; ++k) {
            QVERIFY(std::abs(there[k] - ryb[qsizetype(k)]) <= 1e-12);
            QVERIFY(std::abs(back[k] - rgb[qsizetype(k)]) <= 1e-12);
        }
    }

    void coloursComeBack()
    {
        QRandomGenerator random(3);
        for (int k = 0; k < 100000; ++k) {
            const std::array<double, 3> rgb{random.generateDouble(), random.generateDouble(), random.generateDouble()};
            const auto back = srgbFromRyb(rybFromSrgb(rgb));
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY2(std::abs(back[c] - rgb[c]) <= 1e-12, qPrintable(QString::number(back[c] - rgb[c])));
        }
    }
};

QTEST_APPLESS_MAIN(TestTextForm)
#include "test_text_form.moc"

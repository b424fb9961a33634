// A number that is added to a segment is one row of the list of its fields: a segment with one more is tried here in
// all that walks through the list. tests/app/panels/test_number_rows.cpp does the same with the inspector.
#include "model/formats/files.h"
#include "model/formats/suffuse/field_columns.h"
#include "model/formats/text/field_json.h"
#include "model/painting/field_domains.h"
#include "model/painting/field_hash.h"
#include "model/shaping/curves/split.h"
#include "tests/model/tried_segment.h"

#include <QTest>

#include <set>

using namespace suffuse;
using test::TriedSegment;

namespace {

TriedSegment someSegment()
{
    TriedSegment s;
    s.bezier = {Offset{0, 0}, {1, 0.5f}, {2, 0}, {3, 0}};
    s.diffusion = 7;
    return s;
}

QByteArray hash(const TriedSegment &segment)
{
    FieldHash out;
    out.put(segment);
    return out.result();
}

QString problem(const TriedSegment &segment)
{
    DomainCheck check;
    check.checkFields(segment);
    return check.problem();
}

QByteArray textOf(const TriedSegment &segment)
{
    QByteArray out;
    appendObject(out, segment);
    return out;
}

/// What is read of a text, or the reader's error.
Result<TriedSegment> fromText(const QByteArray &text)
{
    JsonReader json(text, QStringLiteral("a.json"));
    TriedSegment segment;
    readObject(json, segment);
    json.finish();
    if (!json.ok())
        return Error{json.error()};
    return segment;
}

/// The numbers of some segments as a document has them; whether all of it was read.
template <class Columns>
bool roundTrip(const std::vector<TriedSegment> &segments, std::vector<TriedSegment> &read, qsizetype &size)
{
    Columns written, columns;
    for (const TriedSegment &s : segments)
        written.add(s);
    ColumnWriter out;
    written.putUsed(out);
    size = out.bytes().size();
    ColumnReader in(out.bytes());
    columns.getUsed(in, segments.size());
    read.assign(segments.size(), TriedSegment());
    for (std::size_t k = 0; k < read.size(); ++k)
        columns.set(read[k], k);
    return in.atEnd();
}

} // namespace

class TestFields : public QObject {
    Q_OBJECT

private slots:
    void everyFieldHasItsName()
    {
        std::set<std::string_view> names;
        std::size_t count = 0;
        forEachFieldOf<Segment>([&](const auto &f) { names.insert(f.name), ++count; });
        QCOMPARE(names.size(), count);
        QCOMPARE(count, std::size_t(15));
        QCOMPARE(numbersOf<Segment>.size(), std::size_t(10)); // D, φ, ω, t_max, four of the colour, ratio, angle
        QCOMPARE(predictedNumbersOf<Segment>.size(), std::size_t(8));
        QVERIFY(laterNumbersOf<Segment>.empty());
        const Segment usual;
        for (const Number<Segment> &n : numbersOf<Segment>) {
            QVERIFY2(n.traits.domain.contains(n.usual()), n.name);
            QCOMPARE(n.of(usual), n.usual());
        }
    }

    void domainsAreWrittenAsPeopleDo_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("greatest");
        QTest::addColumn<bool>("open");
        QTest::addColumn<QString>("text");
        const auto row = [](const char *text, const Domain &d) {
            QTest::newRow(text) << d.least << d.greatest << d.open << QString::fromLatin1(text);
        };
        row("[0, 1]", share);
        row("(0, 1e12]", {0, 1e12, true});
        row("[-1e12, 1e12]", coordinate);
        row("[-1e9, 1e9]", moment);
        row("[1e-6, 1e6]", {1e-6, 1e6});
        row("(0, 3.4e38]", positive);
        row("[-3.4e38, 3.4e38]", anyNumber);
        row("[0.5, 64]", {0.5, 64});
        row("[1, 9007199254740991]", identity);
        row("[0.002, 0.2]", {0.002, 0.2});
    }
    void domainsAreWrittenAsPeopleDo()
    {
        QFETCH(double, least);
        QFETCH(double, greatest);
        QFETCH(bool, open);
        const Domain domain{least, greatest, open};
        QTEST(domain.text(), "text");
        QVERIFY(domain.contains(domain.leastFloat()) && domain.contains(float(domain.leastFloat())));
        QVERIFY(domain.contains(float(domain.greatest)));
        QVERIFY(!domain.contains(std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!domain.contains(std::numeric_limits<float>::quiet_NaN()));
        QCOMPARE(domain.contains(least), !open);
    }

    void oneMoreIsHashed()
    {
        TriedSegment a = someSegment(), b = a;
        QCOMPARE(hash(a), hash(b));
        FieldHash before;
        before.put(static_cast<const Segment &>(a));
        QCOMPARE(hash(a), before.result()); // paintings of before it keep their hash, which documents hold
        b.wetness = 0.5f;
        QVERIFY(hash(a) != hash(b));
    }

    void oneMoreHasItsDomain()
    {
        TriedSegment s = someSegment();
        QCOMPARE(problem(s), QString());
        s.wetness = 2;
        QCOMPARE(problem(s), QStringLiteral("water.wetness: 2 is not in [0, 1]"));
        s.wetness = std::numeric_limits<float>::quiet_NaN();
        QVERIFY(problem(s).startsWith(QLatin1String("water.wetness: ")));
    }

    void oneMoreIsInTheTextForm()
    {
        TriedSegment s = someSegment();
        QVERIFY2(!textOf(s).contains("water"), "it is as always");
        Segment plain = s;
        QByteArray plainText;
        appendObject(plainText, plain);
        QCOMPARE(textOf(s), plainText);
        s.wetness = 0.75f;
        QVERIFY2(textOf(s).endsWith(", \"water\": {\"wetness\": 0.75}}"), textOf(s).constData());
        const Result<TriedSegment> read = fromText(textOf(s));
        QVERIFY2(read, qPrintable(read ? QString() : read.error()));
        QVERIFY(*read == s);
        QVERIFY(*fromText(plainText) == someSegment()); // a file of before it
        const auto wrong = fromText("{\"bezier\": [[0,0],[0,0],[0,0],[0,0]], \"diffusion\": 1, \"density\": 1, "
                                    "\"water\": {\"wetness\": \"much\"}}");
        QVERIFY(!wrong && wrong.error().contains(QLatin1String("water.wetness")));
    }

    void oneMoreIsInTheDocument()
    {
        using Columns = LaterColumns<TriedSegment>;
        static_assert(laterNumbersOf<TriedSegment>.size() == 1 && plainNumbersOf<TriedSegment>.size() == 2);
        std::vector<TriedSegment> segments(50, someSegment()), read;
        qsizetype size = -1;
        QVERIFY(roundTrip<Columns>(segments, read, size));
        QCOMPARE(size, qsizetype(0)); // documents that do not use it are what they were
        QCOMPARE(read[7].wetness, TriedSegment().wetness);
        QCOMPARE(versionNeededBy(segments[7]), suffuseLeastReader);
        segments[7].wetness = 0;
        segments[8].wetness = -0.0f;
        segments[9].wetness = 0.123f;
        QVERIFY(roundTrip<Columns>(segments, read, size));
        QVERIFY(size > 0);
        for (std::size_t k = 0; k < segments.size(); ++k)
            QCOMPARE(std::bit_cast<std::uint32_t>(read[k].wetness), std::bit_cast<std::uint32_t>(segments[k].wetness));
        QCOMPARE(versionNeededBy(segments[7]), 2);
    }

    void oneMoreIsADifference()
    {
        TriedSegment before = someSegment(), after = before;
        after.wetness = 0.5f;
        const FieldTexts a = fieldTextsOf(before), b = fieldTextsOf(after);
        QCOMPARE(a.size(), b.size());
        int differences = 0;
        for (std::size_t k = 0; k < a.size(); ++k)
            if (a[k] != b[k]) {
                ++differences;
                QCOMPARE(b[k].first, QByteArray("water.wetness"));
                QCOMPARE(a[k].second, QByteArray("0.25"));
                QCOMPARE(b[k].second, QByteArray("0.5"));
            }
        QCOMPARE(differences, 1);
        QVERIFY(!(before == after));
    }

    void oneMoreIsAveraged()
    {
        TriedSegment longOne = someSegment(), shortOne = someSegment();
        longOne.bezier = {Offset{0, 0}, {10, 0}, {20, 0}, {30, 0}};
        shortOne.bezier = {Offset{30, 0}, {33, 0}, {37, 0}, {40, 0}};
        longOne.wetness = 0;
        shortOne.wetness = 1;
        shortOne.diffusion = 15;
        TriedSegment mean = longOne;
        setMeanNumbers(mean, std::vector<const TriedSegment *>{&longOne, &shortOne}, std::vector<double>{30, 10});
        QCOMPARE(mean.wetness, 0.25f);
        QCOMPARE(mean.diffusion, 9.0f);
        QCOMPARE(mean.anisotropyRatio, longOne.anisotropyRatio);
    }

    /// What walks through the lists for tried segments does so for real ones.
    void theRealOnesWalkThroughTheLists()
    {
        Painting painting;
        auto stroke = std::make_shared<Stroke>();
        stroke->id = 1;
        stroke->segments = {someSegment()};
        painting.strokes.push_back(stroke);
        QByteArray segment;
        appendObject(segment, stroke->segments.front());
        QVERIFY(writeTextForm(painting).contains(segment));
        QCOMPARE(problemOf(stroke->segments.front()), problem(someSegment()));
        auto wrong = std::make_shared<Stroke>(*stroke);
        wrong->segments.front().granulation = 2;
        DomainCheck check;
        check.checkFields(wrong->segments.front());
        QCOMPARE(problemOf(*wrong), QStringLiteral("segments[0].") + check.problem());
    }
};

QTEST_GUILESS_MAIN(TestFields)
#include "test_fields.moc"

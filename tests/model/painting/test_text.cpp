// A group that is a text: its values go through every kind of file, and what has none is what it was.
#include "model/document/difference.h"
#include "model/formats/files.h"
#include "model/journal/journal_format.h"
#include "model/painting/fields.h"
#include "model/painting/validate.h"

#include <QTest>

using namespace suffuse;

namespace {

const QString file = QStringLiteral("a.json");

Text heading()
{
    Text text;
    text.string = QStringLiteral("Tea\n茶");
    text.family = QStringLiteral("DejaVu Serif");
    text.weight = 700;
    text.italic = true;
    text.size = 48.5;
    text.letterSpacing = 0.25f;
    text.lineHeight = 1.5f;
    text.alignment = TextAlignment::Centre;
    text.vertical = true;
    text.place = {0, -1, 1, 0, {10.1, -20}};
    text.curve = {{{Point{0, 0}, {0.1, 2}, {3, 4}, {5, 6}}}, {{Point{5, 6}, {7, 8}, {9, 10}, {11, 12}}}};
    return text;
}

Painting lettered(SharedText text)
{
    Painting painting;
    painting.groups = {{1, QStringLiteral("g"), 0, true, false, std::move(text)}};
    auto stroke = std::make_shared<Stroke>();
    stroke->id = 1;
    stroke->name = QStringLiteral("T");
    stroke->group = 1;
    stroke->segments.resize(1);
    painting.strokes.push_back(stroke);
    return painting;
}

QString problemWith(const std::function<void(Text &)> &change)
{
    Text text = heading();
    change(text);
    return problemOf(lettered(text));
}

} // namespace

class TestText : public QObject {
    Q_OBJECT

private slots:
    void equalByValue()
    {
        const SharedText a = heading(), b = heading();
        QVERIFY(a == b && a && *a == *b && a->string == b->string);
        Text other = heading();
        other.curve[1].p[2].x += 1e-9;
        QVERIFY(!(SharedText(other) == a) && !(SharedText() == a) && SharedText() == SharedText());
        QVERIFY(lettered(a) == lettered(b) && !(lettered(a) == lettered(other)));
    }

    void inTheTextForm()
    {
        const Painting painting = lettered(heading());
        const QByteArray json = writeTextForm(painting);
        QVERIFY(json.contains("\"version\": 2"));
        QVERIFY2(json.contains("\"text\": {\"string\": \"Tea\\n茶\", \"family\": \"DejaVu Serif\", \"weight\": 700, "
                               "\"italic\": true, \"size\": 48.5, \"letterSpacing\": 0.25, \"lineHeight\": 1.5, "
                               "\"alignment\": \"centre\", \"vertical\": true, \"place\": [0,-1,1,0,10.1,-20], "
                               "\"curve\": [[[0,0],[0.1,2],[3,4],[5,6]],[[5,6],[7,8],[9,10],[11,12]]]}"),
                 json.constData());
        const auto again = readTextForm(json, file);
        QVERIFY2(again, again ? "" : qPrintable(again.error()));
        QVERIFY(*again == painting);
        QByteArray early = json;
        early.replace("\"version\": 2", "\"version\": 1");
        const auto refused = readTextForm(early, file);
        QVERIFY(!refused && refused.error().contains(QLatin1String("version: 1 does not know all")));
    }

    void whatIsLeftOutIsUsual()
    {
        const auto read = readTextForm("{\"format\": \"suffuse-text\", \"version\": 2, \"strokes\": [], \"groups\": "
                                       "[{\"id\": 1, \"text\": {\"string\": \"a\", \"family\": \"F\", \"size\": 9}}]}",
                                       file);
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        Text wanted;
        wanted.string = QStringLiteral("a");
        wanted.family = QStringLiteral("F");
        wanted.size = 9;
        QVERIFY(read->groups.at(0).text == SharedText(wanted));
    }

    void refusedInTheTextForm_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("error");
        const auto row = [](const char *name, const char *text, const char *error) {
            QTest::newRow(name) << QByteArray(text) << QString::fromLatin1(error);
        };
        row("no string", "\"family\": \"F\", \"size\": 9", "groups[0].text.string: is missing");
        row("no size", "\"string\": \"\", \"family\": \"F\", \"size\": 0", "groups[0].text.size: 0 is not in (0, 1e6]");
        row("a matrix of five", "\"string\": \"\", \"family\": \"F\", \"size\": 9, \"place\": [1,2,3,4,5]",
            "groups[0].text.place: has 5 numbers instead of 6");
        row("a curve of three points",
            "\"string\": \"\", \"family\": \"F\", \"size\": 9, \"curve\": [[[0,0],[1,1],[2,2]]]",
            "groups[0].text.curve[0]: has 3 points instead of 4");
        row("an alignment that there is not",
            "\"string\": \"\", \"family\": \"F\", \"size\": 9, \"alignment\": \"left\"", "groups[0].text.alignment");
        row("a member that there is not", "\"string\": \"\", \"family\": \"F\", \"size\": 9, \"bold\": true", "bold");
    }
    void refusedInTheTextForm()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, error);
        const auto read = readTextForm("{\"format\": \"suffuse-text\", \"version\": 2, \"strokes\": [], \"groups\": "
                                       "[{\"id\": 1, \"text\": {" +
                                           text + "}}]}",
                                       file);
        QVERIFY(!read);
        QVERIFY2(read.error().contains(error), qPrintable(read.error()));
    }

    void outOfDomain()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(problemOf(lettered(heading())), QString());
        QCOMPARE(problemWith([&](Text &t) { t.size = nan; }),
                 QStringLiteral("groups[0].text.size: nan is not in (0, 1e6]"));
        QCOMPARE(problemWith([&](Text &t) { t.place.d = nan; }),
                 QStringLiteral("groups[0].text.place[3]: nan is not in [-1e12, 1e12]"));
        QCOMPARE(problemWith([&](Text &t) { t.curve[1].p[2].y = nan; }),
                 QStringLiteral("groups[0].text.curve[1][2][1]: nan is not in [-1e12, 1e12]"));
        QCOMPARE(problemWith([](Text &t) { t.weight = 0; }),
                 QStringLiteral("groups[0].text.weight: 0 is not in [1, 1e3]"));
        QCOMPARE(problemWith([](Text &t) { t.alignment = TextAlignment(7); }),
                 QStringLiteral("groups[0].text.alignment: there is no such alignment"));
        QCOMPARE(problemWith([](Text &t) { t.string = QString(100'001, QLatin1Char('a')); }),
                 QStringLiteral("groups[0].text.string: 100001 characters are more than 100000"));
        QCOMPARE(problemWith([](Text &t) { t.family = QString(1'001, QLatin1Char('a')); }),
                 QStringLiteral("groups[0].text.family: 1001 characters are more than 1000"));
        QCOMPARE(problemWith([](Text &t) { t.string = QString(QChar(0xd800)); }),
                 QStringLiteral("groups[0].text.string: it is no valid Unicode"));
        QCOMPARE(problemWith([](Text &t) { t.curve.resize(100'001); }),
                 QStringLiteral("groups[0].text.curve: 100001 curves are more than 100000"));
    }

    void inADocument()
    {
        const Painting painting = lettered(heading()), plain = lettered({});
        const auto again = readPainting(writePainting(painting, FileFormat::Suffuse), file);
        QVERIFY2(again, again ? "" : qPrintable(again.error()));
        QVERIFY(*again == painting);
        // Readers that know no texts read the outlines, so they are not kept from it.
        const QByteArray bytes = writePainting(painting, FileFormat::Suffuse);
        QVERIFY(bytes.left(200).contains(QByteArray("freader\x01", 8)));
        QVERIFY(!writePainting(plain, FileFormat::Suffuse).contains("string"));
    }

    void wrongTypesInADocument()
    {
        QByteArray bytes = writeSuffuseFile(lettered(heading()));
        const qsizetype at = bytes.indexOf("place") + 5;
        QVERIFY(at > 5 && quint8(bytes[at]) == 0x86); // an array of six
        bytes[at] = char(0x66);                       // a text of six bytes
        const auto read = readDocument(bytes, file);
        QVERIFY(!read || !read->losses.empty());
    }

    void hashed()
    {
        Text other = heading();
        QVERIFY(hashOf(lettered(heading())) == hashOf(lettered(heading())));
        QVERIFY(hashOf(lettered(heading())) != hashOf(lettered({})));
        other.curve.pop_back();
        QVERIFY(hashOf(lettered(heading())) != hashOf(lettered(other)));
        other = heading();
        other.place.offset.y = 1;
        QVERIFY(hashOf(lettered(heading())) != hashOf(lettered(other)));
    }

    void told()
    {
        Text other = heading();
        other.string = QStringLiteral("Tea");
        other.size = 12;
        using Difference = std::vector<ValueDifference>;
        QCOMPARE(
            valuesThatDiffer(lettered(heading()), lettered(other)),
            (Difference{{"groups[1].text.string", "\"Tea\\n茶\"", "\"Tea\""}, {"groups[1].text.size", "48.5", "12"}}));
        const Difference gone = valuesThatDiffer(lettered(heading()), lettered({}));
        QCOMPARE(gone.front(), (ValueDifference{"groups[1].text.string", "\"Tea\\n茶\"", "null"}));
        QVERIFY(differenceOf(lettered(heading()), lettered(other)).groups);
    }

    void inAJournal()
    {
        JournalEncoder encoder;
        QByteArray bytes = encoder.begin({}, std::make_shared<const Painting>(lettered({})), false, 1);
        encoder.kept();
        bytes += encoder.edit(std::make_shared<const Painting>(lettered(heading())), true, 2);
        encoder.kept();
        const auto content = readJournal(bytes, file);
        QVERIFY2(content, content ? "" : qPrintable(content.error()));
        QVERIFY(content->painting == lettered(heading()));
    }
};

QTEST_APPLESS_MAIN(TestText)
#include "test_text.moc"

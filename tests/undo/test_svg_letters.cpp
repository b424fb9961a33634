// Texts of drawings by the fonts of the machine: their letters are those that Suffuse's own texts have, so that typing
// goes on where the drawing left off.
#include "model/document/document.h"
#include "model/formats/svg/svg_painting.h"
#include "model/shaping/baseline_curve.h"
#include "undo/lettering/text_layout.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"

#include <QFontDatabase>
#include <QGuiApplication>
#include <QTest>

using namespace suffuse;

namespace {

Painting read(const QByteArray &content, QString *leftOut = nullptr)
{
    const QByteArray bytes = "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
                             "viewBox='0 0 400 300' width='800'>" +
                             content + "</svg>";
    const Result<Painting> painting = readSvg(bytes, QStringLiteral("a.svg"), nullptr, leftOut);
    return painting ? *painting : Painting();
}

/// The greatest distance between a point of a letter as the drawing has it and as the text has it, canvas units.
/// Infinite where they are not the same letters.
double apart(const Painting &painting)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const Group &group : painting.groups) {
        if (!group.text)
            return never;
        TextLayout layout;
        const LaidText laid = layout.lay(*group.text);
        std::vector<const Stroke *> strokes;
        for (const StrokePtr &stroke : painting.strokes)
            if (stroke->group == group.id)
                strokes.push_back(stroke.get());
        std::size_t at = 0;
        for (const LaidCluster &cluster : laid.clusters) {
            if (!cluster.hasInk())
                continue;
            if (at >= strokes.size())
                return never;
            const Stroke &stroke = *strokes[at++];
            std::size_t k = 0;
            for (const std::vector<Cubic> &contour : *cluster.outline)
                for (const Cubic &curve : contour) {
                    if (k >= stroke.segments.size())
                        return never;
                    const Segment &segment = stroke.segments[k++];
                    for (std::size_t i = 0; i < 4; ++i) {
                        const Point there = (group.text->place * cluster.place)(curve.p[i]);
                        most = std::max(most, length(stroke.origin + segment.bezier[i] - there));
                    }
                }
            if (k != stroke.segments.size() ||
                stroke.name != group.text->string.mid(cluster.from, cluster.to - cluster.from))
                return never;
        }
        if (at != strokes.size())
            return never;
    }
    return painting.groups.empty() ? never : most;
}

} // namespace

class TestSvgLetters : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (QFontDatabase::families().isEmpty())
            QSKIP("There are no fonts here.");
        setLetterShaper(&m_shaper);
    }
    void cleanupTestCase() { setLetterShaper(nullptr); }

    void lettersAreThoseOfTexts_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("plain") << QByteArray("<text x='20' y='50' font-size='40'>AVATAR, finer</text>");
        QTest::newRow("middle") << QByteArray(
            "<text x='200' y='50' font-size='20' text-anchor='middle'>To an y</text>");
        QTest::newRow("end") << QByteArray("<text x='390' y='50' text-anchor='end' font-family='serif' "
                                           "font-style='italic' font-weight='bold'>Waves</text>");
        QTest::newRow("spaced") << QByteArray("<text x='20' y='50' letter-spacing='3' font-size='30'>office</text>");
        QTest::newRow("turned") << QByteArray("<g transform='rotate(20) skewX(10)'><text x='20' y='50' "
                                              "transform='scale(1.5 2)' font-size='12'>Wolken</text></g>");
        QTest::newRow("lines") << QByteArray("<text x='200' y='50' font-size='16' text-anchor='middle'>"
                                             "<tspan x='200'>One</tspan><tspan x='200' y='70'>and two</tspan>"
                                             "<tspan x='200' y='110'>and four</tspan></text>");
        QTest::newRow("line") << QByteArray("<path id='p' d='M20 100C100 20 200 180 300 90' fill='none'/>"
                                            "<text font-size='20'><textPath href='#p'>Along it</textPath></text>");
        const QByteArray wave = "<path id='p' d='M20 100C100 20 200 180 300 90' fill='none'/>";
        QTest::newRow("from a length on") << QByteArray(
            wave + "<text font-size='20'><textPath xlink:href='#p' startOffset='41'>Along it</textPath></text>");
        QTest::newRow("from a share on") << QByteArray(
            wave + "<text font-size='20'><textPath href='#p' startOffset='30%'>Along it</textPath></text>");
        QTest::newRow("around a share") << QByteArray(wave + "<text font-size='20' text-anchor='middle'><textPath "
                                                             "href='#p' startOffset='40%'>Along it</textPath></text>");
        QTest::newRow("up to a share") << QByteArray(wave + "<text font-size='20' text-anchor='end'><textPath "
                                                            "href='#p' startOffset='90%'>Along it</textPath></text>");
        QTest::newRow("on a straight line")
            << QByteArray("<line id='p' x1='10' y1='200' x2='300' y2='120'/><text font-size='20'><textPath href='#p' "
                          "startOffset='12.5'>Along it</textPath></text>");
        QTest::newRow("Hebrew on a line") << QByteArray(
            wave + "<text font-size='20'><textPath href='#p' startOffset='50'>\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d"
                   "</textPath></text>");
        QTest::newRow("Hebrew up to its end")
            << QByteArray(wave + "<text font-size='20' direction='rtl'><textPath href='#p' startOffset='100%'>"
                                 "\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d</textPath></text>");
        QTest::newRow("Hebrew") << QByteArray("<text x='200' y='50' font-size='30'>\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d"
                                              "</text>");
        QTest::newRow("Hebrew from the right") << QByteArray(
            "<text x='200' y='50' direction='rtl' font-size='30'>\xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d</text>");
        QTest::newRow("both ways") << QByteArray("<text x='200' y='50' text-anchor='middle'>abc \xd7\xa9\xd7\x9c "
                                                 "12</text>");
    }
    void lettersAreThoseOfTexts()
    {
        QFETCH(QByteArray, content);
        const Painting painting = read(content);
        QVERIFY(painting.strokes.size() > 2 || content.contains("\xd7"));
        QVERIFY2(apart(painting) < 1e-3, qPrintable(QString::number(apart(painting))));
    }

    /// The letters that stay keep what was changed of them.
    void typingGoesOn()
    {
        Document document;
        document.reset(std::make_shared<Painting>(
            read("<text x='20' y='50' font-size='40' fill='#803020'>Dusk</text><rect width='9' height='9'/>")));
        const Painting before = *document.painting();
        QCOMPARE(before.strokes.size(), std::size_t(5));
        const Group group = before.groups.front();
        TextLayout layout;
        const LaidText was = layout.lay(*group.text);
        Text text = *group.text;
        text.string = QStringLiteral("Dusky");
        TextChange change;
        change.letter = *before.strokes.front();
        Edit edit = setText(document, group.id, text, &was, layout.lay(text), change);
        document.exchange(edit);
        const Painting &after = *document.painting();
        QCOMPARE(after.strokes.size(), std::size_t(6));
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(after.strokes[i], before.strokes[i]);
        QCOMPARE(after.strokes[4]->name, QString("y"));
        QCOMPARE(after.strokes[4]->fill->colour, before.strokes[0]->fill->colour);
    }

    /// Wherever the line stands in the drawing: what becomes of its stroke becomes of the text.
    void textsFollowTheStrokesOfDrawings_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<bool>("follows");
        const QByteArray wave = "<path id='p' d='M20 100C100 20 200 180 300 90' fill='none' stroke='#268' "
                                "stroke-width='3' stroke-linecap='round' stroke-linejoin='round'/>";
        const auto along = [](const QByteArray &offset, const QByteArray &reference = "href='#p'") {
            return "<textPath " + reference + " startOffset='" + offset + "'>Along it</textPath></text>";
        };
        QTest::newRow("whole") << wave + "<text font-size='20'>" + along("0") << true;
        QTest::newRow("xlink, before it") << "<text font-size='20'>" + along("0", "xlink:href='#p'") + wave << true;
        QTest::newRow("from a length on") << wave + "<text font-size='20'>" + along("35") << true;
        QTest::newRow("around a share") << wave + "<text font-size='20' text-anchor='middle'>" + along("45%") << true;
        QTest::newRow("moved apart") << "<g transform='translate(9 20) rotate(10)'>" + wave +
                                            "</g><text font-size='20' transform='scale(.8)'>" + along("10")
                                     << true;
        QTest::newRow("a line") << QByteArray("<line id='p' x1='20' y1='60' x2='350' y2='80' stroke='#268' "
                                              "stroke-linecap='round'/><text font-size='20'>") +
                                       along("20%")
                                << true;
        QTest::newRow("an area") << QByteArray("<path id='p' d='M20 100C100 20 200 180 300 90V200H20Z' fill='#268'/>"
                                               "<text font-size='20'>") +
                                        along("15")
                                 << true;
        QTest::newRow("used elsewhere") << "<defs>" + wave +
                                               "</defs><use href='#p' x='12' y='40'/>"
                                               "<text font-size='20'>" +
                                               along("0")
                                        << true;
        QTest::newRow("not painted") << "<defs>" + wave + "</defs><text font-size='20'>" + along("0") << false;
        QTest::newRow("dashed") << QByteArray(wave).replace("/>", " stroke-dasharray='9'/>") + "<text font-size='20'>" +
                                       along("0")
                                << false;
    }
    void textsFollowTheStrokesOfDrawings()
    {
        QFETCH(QByteArray, content);
        QFETCH(bool, follows);
        Document document;
        document.reset(std::make_shared<Painting>(read(content)));
        const Painting before = *document.painting();
        const auto group = std::ranges::find_if(before.groups, [](const Group &g) { return bool(g.text); });
        QVERIFY(group != before.groups.end());
        QCOMPARE(group->text->follows != 0, follows);
        if (!follows)
            return;
        QVERIFY(textAround(before, *before.find(group->text->follows)) == 0);
        Edit edit = changeStrokes(document, {group->text->follows}, [](Stroke &stroke) {
            stroke.segments.front().bezier[1].y += 60;
            stroke.origin.x += 20;
        });
        TextLayout layout;
        completeTexts(before, edit, [&](const Text &text) { return layout.lay(text); });
        document.exchange(edit);
        const Painting &after = *document.painting();
        const Text text = *textOf(after, group->id);
        QVERIFY(text.curve != group->text->curve);
        const BaselineCurve led(mapped(baselineOf(*after.find(text.follows)), text.followMap)),
            old(mapped(baselineOf(*before.find(text.follows)), group->text->followMap));
        const auto is = led.endsOf(BaselineCurve(text.curve)), was = old.endsOf(BaselineCurve(group->text->curve));
        QVERIFY(is && was);
        QVERIFY(std::abs(is->first / led.length() - was->first / old.length()) < 0.01);
        QVERIFY(std::abs(is->second / led.length() - was->second / old.length()) < 0.01);
        Painting lettersAlone = after;
        std::erase_if(lettersAlone.groups, [&](const Group &g) { return g.id != group->id; });
        QVERIFY2(apart(lettersAlone) < 1e-2, qPrintable(QString::number(apart(lettersAlone))));
    }

    void otherFontsStandInAndAreNamed()
    {
        QString leftOut;
        QVERIFY(!read("<text y='50' font-family='No Such Font, Neither This'>a</text>", &leftOut).strokes.empty());
        QCOMPARE(leftOut, QString("Other fonts stand in for those that are not installed: No Such Font."));
        QVERIFY(!read("<text y='50' font-family='sans-serif'>a</text>", &leftOut).strokes.empty());
        QCOMPARE(leftOut, QString());
        const Painting sans = read("<text y='50' font-family='sans-serif'>a</text>");
        TextLayout layout;
        QVERIFY(layout.lay(*sans.groups.front().text).hasFamily);
    }

    /// What a text of Suffuse's cannot be comes in as letters, and that is said. Its group has its words for a name.
    void otherTextsAreLettersAndSaySo()
    {
        const QString said = QStringLiteral("1 text(s) came in as letters: they cannot be typed in again.");
        for (const char *content :
             {"<text id='text12' y='50' font-size='20' text-decoration='underline'>Old  title</text>",
              "<text y='50' font-size='20'>Old <tspan fill='red'>title</tspan></text>",
              "<text y='50' font-size='20' fill='none' stroke='red' stroke-linejoin='round'>Old title</text>",
              "<path id='p' d='M20 100C100 20 200 180 300 90' fill='none'/>"
              "<text font-size='20'><textPath href='#p' startOffset='-30'>Old title</textPath></text>"}) {
            QString leftOut;
            const Painting painting = read(content, &leftOut);
            QCOMPARE(leftOut, said);
            QCOMPARE(painting.groups.size(), std::size_t(1));
            QCOMPARE(painting.groups[0].name, QString("Old title"));
        }
        QString leftOut;
        const Painting named =
            read("<text id='head' y='50' font-size='20' text-decoration='underline'>Old title</text>", &leftOut);
        QCOMPARE(named.groups.at(0).name, QString("head"));
        QCOMPARE(leftOut, said);
        QVERIFY(read("<text y='50' font-size='20'>Old title</text>", &leftOut).groups.at(0).text);
        QCOMPARE(leftOut, QString());
    }

private:
    LineShaper m_shaper;
};

QTEST_MAIN(TestSvgLetters)
#include "test_svg_letters.moc"

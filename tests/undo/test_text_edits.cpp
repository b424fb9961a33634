// Texts as they are typed in: what stays of their letters, and that every step has its way back.
#include "model/painting/validate.h"
#include "tests/undo/text_page.h"
#include "undo/layers/group_edits.h"
#include "undo/text_links.h"
#include "undo/transform_edits.h"

#include <QGuiApplication>
#include <QRandomGenerator>
#include <QTest>

using namespace suffuse;

namespace {

const Colour red{1, 0.2f, 0, 1};

double farthest(const Stroke &a, const Stroke &b)
{
    if (a.segments.size() != b.segments.size())
        return 1e9;
    double most = 0;
    for (std::size_t k = 0; k < a.segments.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i)
            most = std::max(most, length(a.origin + a.segments[k].bezier[i] - (b.origin + b.segments[k].bezier[i])));
    return most;
}

} // namespace

class TestTextEdits : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!LineShaper().hasFamily(QStringLiteral("DejaVu Sans")))
            QSKIP("DejaVu Sans is not installed");
    }

    void aTextIsAGroupOfFills()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("Oi b")));
        QCOMPARE(page.names(), QStringLiteral("Oib"));
        QCOMPARE(page.painting().groups.size(), std::size_t(1));
        QCOMPARE(textOf(page.painting(), group)->string, QStringLiteral("Oi b"));
        QCOMPARE(problemOf(page.painting()), QString());
        for (const StrokePtr &stroke : page.painting().strokes) {
            QCOMPARE(stroke->group, group);
            QVERIFY(stroke->fill && stroke->fill->rule == FillRule::NonZero);
            QCOMPARE(stroke->fill->colour, (Colour{0.5f, 0.25f, 0, 1}));
            for (const Segment &segment : stroke->segments)
                QCOMPARE(segment.density, 0.0f);
        }
        const auto chains = [&](int letter) {
            int count = 0;
            for (std::size_t k = 0; k < page.letter(letter)->segments.size(); ++k)
                count += page.letter(letter)->beginsChain(k);
            return count;
        };
        QCOMPARE(chains(0), 2); // O
        QCOMPARE(chains(1), 2); // i
        page.stack.undo();
        QVERIFY(page.painting().strokes.empty() && page.painting().groups.empty());
    }

    void lettersThatStayKeepTheirValues()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        page.recolour(1, red);
        const std::vector<StrokeId> before = orderOf(page.painting());
        const StrokePtr first = page.letter(0), last = page.letter(2);
        page.retype(group, QStringLiteral("axbc"), 1);
        QCOMPARE(page.names(), QStringLiteral("axbc"));
        QCOMPARE(page.letter(0), first); // the very same
        QCOMPARE(page.letter(2)->id, before[1]);
        QCOMPARE(page.letter(2)->fill->colour, red);
        QCOMPARE(page.letter(3)->id, before[2]);
        QVERIFY(page.letter(3)->origin.x > last->origin.x + 10);
        QCOMPARE(page.letter(3)->segments, last->segments);
        QCOMPARE(page.letter(1)->fill->colour, first->fill->colour); // like the one before it
        QVERIFY(page.letter(1)->born() > first->born());
        page.retype(group, QStringLiteral("axbbc"), 3);
        QCOMPARE(page.letter(3)->fill->colour, red); // so is this
        page.stack.undo();
        page.stack.undo();
        QCOMPARE(orderOf(page.painting()), before);
        QCOMPARE(page.letter(0), first);
        QCOMPARE(page.letter(2), last);
    }

    void whereItWasTypedCounts()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("aaa")));
        page.recolour(0, red);
        page.retype(group, QStringLiteral("aaaa"), 0); // in front of the first
        QCOMPARE(page.letter(1)->fill->colour, red);
        page.retype(group, QStringLiteral("aaa"), 1); // without the second
        QCOMPARE(page.letter(0)->fill->colour, red);  // the new one, which looks like its neighbour
        QVERIFY(!(page.letter(1)->fill->colour == red));
    }

    void anotherFontKeepsThem()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        page.recolour(1, red);
        const StrokePtr b = page.letter(1);
        Text text = *textOf(page.painting(), group);
        text.weight = 700;
        text.size = 50;
        page.set(group, text);
        QCOMPARE(page.letter(1)->id, b->id);
        QCOMPARE(page.letter(1)->fill->colour, red);
        QCOMPARE(page.letter(1)->born(), b->born());
        QVERIFY(farthest(*page.letter(1), *b) > 1);
        QCOMPARE(problemOf(page.painting()), QString());
    }

    void emptiedTextsGo()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("ab")));
        page.retype(group, QStringLiteral("  "));
        QVERIFY(page.painting().strokes.empty() && page.painting().groups.empty());
        page.stack.undo();
        QCOMPARE(page.names(), QStringLiteral("ab"));
        TextPage other;
        other.put(typedText(QString()));
        QCOMPARE(other.stack.count(), 0);
    }

    void theOrderStays()
    {
        TextPage page;
        const GroupId below = page.put(typedText(QStringLiteral("ab")));
        page.put(typedText(QStringLiteral("cd")));
        page.retype(below, QStringLiteral("xaby"));
        QCOMPARE(page.names(), QStringLiteral("xabycd"));
        QCOMPARE(problemOf(page.painting()), QString());
    }

    void whatElseStandsInTheGroupStays()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("ab")));
        auto stroke = std::make_shared<Stroke>(*page.letter(0));
        stroke->id = page.document.takeStrokeId();
        stroke->name = QStringLiteral("flourish");
        page.push(addStrokes(page.document, {stroke}, false));
        page.retype(group, QStringLiteral("abc"));
        QCOMPARE(page.names(), QStringLiteral("abcflourish"));
        page.retype(group, QString());
        QCOMPARE(page.names(), QStringLiteral("flourish"));
    }

    /// A stroke that was put between two letters stays there, whatever is typed around it.
    void whatStandsBetweenLettersStaysThere()
    {
        for (const std::size_t place : {0u, 1u, 2u}) {
            TextPage page;
            const GroupId group = page.put(typedText(QStringLiteral("ab")));
            auto stroke = std::make_shared<Stroke>(*page.letter(0));
            stroke->id = page.document.takeStrokeId();
            stroke->name = QStringLiteral("-");
            Edit edit = addStrokes(page.document, {stroke}, false);
            edit.order->pop_back();
            edit.order->insert(edit.order->begin() + std::ptrdiff_t(place), stroke->id);
            page.push(std::move(edit));
            page.retype(group, QStringLiteral("abc"));
            QCOMPARE(page.names(), place == 0 ? "-abc" : place == 1 ? "a-bc" : "abc-");
            page.retype(group, QStringLiteral("xabc"));
            QCOMPARE(page.names(), place == 0 ? "-xabc" : place == 1 ? "xa-bc" : "xabc-");
            page.retype(group, QStringLiteral("xbc"));
            QCOMPARE(page.names(), place == 0 ? "-xbc" : place == 1 ? "x-bc" : "xbc-");
        }
    }

    void deletedLettersStayDeleted()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        page.select(1);
        page.push(deleteSelection(page.document));
        page.retype(group, QStringLiteral("abcd"), 3);
        QCOMPARE(page.names(), QStringLiteral("acd"));
    }

    void textsFollowTheirLetters_data()
    {
        QTest::addColumn<Affine>("map");
        QTest::newRow("moved") << Affine::translation({12.5, -300});
        QTest::newRow("turned") << Affine::rotation({100, 100}, 0.7);
        QTest::newRow("scaled") << Affine::scaling({3, 4}, 2, 0.5);
        QTest::newRow("skewed and mirrored") << Affine::skew({0, 0}, 0.3, 0) * Affine::scaling({0, 0}, -1, 1);
    }
    void textsFollowTheirLetters()
    {
        QFETCH(Affine, map);
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("map me")));
        const Affine place = textOf(page.painting(), group)->place;
        const PaintingPtr before = page.document.painting();
        page.document.setSelection({strokesWithin(page.painting(), group), {}});
        page.push(transformSelection(page.document, map, SpreadRule::Scales));
        const Affine now = textOf(page.painting(), group)->place, wanted = map * place;
        for (const Point p : {Point{0, 0}, Point{500, 0}, Point{0, 100}})
            QVERIFY(length(now(p) - wanted(p)) < 1e-6);
        // What is typed then goes on from there, and nothing else moves.
        const StrokePtr last = page.letter(4);
        page.retype(group, QStringLiteral("map me!"));
        QCOMPARE(page.letter(4), last);
        TextPage fresh;
        Text text = typedText(QStringLiteral("map me!"));
        text.place = wanted;
        fresh.put(text);
        QVERIFY(farthest(*page.letter(5), *fresh.letter(5)) < 2e-3);
        page.stack.undo();
        page.stack.undo();
        QVERIFY(page.painting() == *before);
    }

    /// Edits that know no map are looked at.
    void textsFollowWhatMovesTheirStrokes()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("ab")));
        const Affine place = textOf(page.painting(), group)->place;
        page.document.setSelection({strokesWithin(page.painting(), group), {}});
        const Point before = page.letter(1)->origin;
        page.push(align(page.document, Align::Left, AlignTo::Canvas));
        const Point by = page.letter(1)->origin - before;
        QVERIFY(by.x < -20);
        QCOMPARE(textOf(page.painting(), group)->place, Affine::translation(by) * place);
        // A map without a name: turned by hand, stroke by stroke.
        const Affine turn = Affine::rotation({30, 40}, 0.4);
        Edit edit;
        for (const StrokePtr &stroke : page.painting().strokes)
            edit.strokes.emplace(stroke->id,
                                 std::make_shared<const Stroke>(transformed(*stroke, turn, SpreadRule::Scales)));
        const Affine wanted = turn * textOf(page.painting(), group)->place;
        page.push(std::move(edit));
        const Affine now = textOf(page.painting(), group)->place;
        for (const Point p : {Point{0, 0}, Point{200, 0}, Point{0, 100}})
            QVERIFY(length(now(p) - wanted(p)) < 1e-3);
        // A colour is no map.
        page.recolour(0, red);
        QCOMPARE(textOf(page.painting(), group)->place, now);
    }

    void aLetterThatIsMovedAlone()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        page.select(1);
        page.push(transformSelection(page.document, Affine::translation({0, 30}), SpreadRule::Scales));
        QCOMPARE(textOf(page.painting(), group)->place, typedText({}).place);
        const StrokePtr moved = page.letter(1);
        page.retype(group, QStringLiteral("abcd"));
        QCOMPARE(page.letter(1), moved); // Nothing before it has changed.
    }

    void aMissingFontLeavesTheOutlines()
    {
        TextPage page;
        Text text = typedText(QStringLiteral("abc"));
        const GroupId group = page.put(text);
        // As if the file came from a machine that had it.
        auto other = std::make_shared<Painting>(page.painting());
        text.family = QStringLiteral("No Such Family At All");
        other->groups[0].text = text;
        page.document.reset(other);
        const StrokePtr c = page.letter(2);
        page.retype(group, QStringLiteral("abXc"), 2);
        QCOMPARE(page.names(), QStringLiteral("abXc"));
        QCOMPARE(page.letter(3)->id, c->id);
        QCOMPARE(page.letter(3)->segments, c->segments);
        QVERIFY(page.letter(3)->origin.x > c->origin.x);
    }

    void plainStrokes()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        QVERIFY(!canTurnTexts(page.document));
        page.select(0);
        QVERIFY(canTurnTexts(page.document));
        QCOMPARE(selectedText(page.document), group);
        page.push(textsToStrokes(page.document));
        QVERIFY(!textOf(page.painting(), group));
        QCOMPARE(page.names(), QStringLiteral("abc"));
        QVERIFY(!canTurnTexts(page.document));
        page.stack.undo();
        QVERIFY(textOf(page.painting(), group));
        page.push(ungroup(page.document, group));
        QVERIFY(page.painting().groups.empty());
    }

    void copiesAreTexts()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("ab")));
        page.document.setSelection({strokesWithin(page.painting(), group), {}});
        page.push(duplicateSelection(page.document, {10, 20}));
        QCOMPARE(page.painting().groups.size(), std::size_t(2));
        const Group &copy = page.painting().groups[1];
        QVERIFY(copy.id != group);
        QCOMPARE(copy.text->place, Affine::translation({60, 220}));
        page.retype(copy.id, QStringLiteral("abc"));
        QVERIFY(length(page.letter(2)->origin - page.letter(0)->origin - Point{10, 20}) < 1e-9);
    }

    void textsWithALockedLetterStay()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("abc")));
        page.push(setLocked(page.document, {page.letter(1)->id}, true));
        QVERIFY(isTextLocked(*page.document.painting(), group));
        const int steps = page.stack.count();
        page.retype(group, QStringLiteral("xy"));
        QCOMPARE(page.stack.count(), steps);
    }

    /// What was erased of a letter goes along with it, also where it gets another outline.
    void erasuresGoAlong()
    {
        TextPage page;
        Text text = typedText(QStringLiteral("ab"));
        const GroupId group = page.put(text);
        const Stroke before = *page.letter(1);
        page.push(changeStrokes(page.document, {before.id}, [](Stroke &stroke) {
            Segment erasure = stroke.segments.front();
            erasure.start = erasure.lift = true;
            erasure.density = 1;
            erasure.diffusion = 9;
            erasure.bezier = {Offset{0, -50}, Offset{20, -50}, Offset{40, -50}, Offset{60, -50}};
            stroke.segments.push_back(erasure);
        }));
        text.size = 50;
        page.set(group, text);
        const StrokePtr half = page.letter(1);
        QCOMPARE(half->segments.size(), before.segments.size() + 1);
        const Segment &erasure = half->segments.back();
        QVERIFY(erasure.lift && erasure.start && !half->segments.front().lift);
        QCOMPARE(erasure.diffusion, 9.0f / 4);
        // Half as long, and as far up from the line of writing, which runs through the text's place.
        QVERIFY(std::abs(erasure.bezier[3].x - erasure.bezier[0].x - 30) < 1e-3);
        QVERIFY(std::abs((half->origin + erasure.bezier[0]).y -
                         (text.place.offset.y + ((before.origin + Offset{0, -50}).y - text.place.offset.y) / 2)) <
                1e-3);
        page.retype(group, QStringLiteral("abc")); // a new letter is whole
        QVERIFY(std::ranges::none_of(page.letter(2)->segments, &Segment::lift));
        text.string = QStringLiteral("abc");
        text.weight = 700;
        page.set(group, text);
        QVERIFY(page.letter(1)->segments.back().lift);
    }

    void lockedTextsStay()
    {
        TextPage page;
        const GroupId group = page.put(typedText(QStringLiteral("ab")));
        page.push(setGroupLocked(page.document, group, true));
        const int steps = page.stack.count();
        page.retype(group, QStringLiteral("abc"));
        QCOMPARE(page.stack.count(), steps);
    }

    /// Whatever is typed in whatever order: the painting is sound, the letters are those of the text, and undo leads
    /// back.
    void randomWalk()
    {
        QRandomGenerator random(7);
        const QStringList pieces{QStringLiteral("a"),
                                 QStringLiteral("ffi"),
                                 QStringLiteral(" "),
                                 QStringLiteral("\n"),
                                 QStringLiteral("\u6c34"),
                                 QStringLiteral("e\u0301"),
                                 QStringLiteral("\u05d0\u05d1"),
                                 QStringLiteral("W.")};
        for (int walk = 0; walk < 12; ++walk) {
            TextPage page;
            const GroupId group = page.put(typedText(QStringLiteral("start")));
            std::vector<PaintingPtr> states{page.document.painting()};
            for (int step = 0; step < 40; ++step) {
                const SharedText now = textOf(page.painting(), group);
                if (!now)
                    break;
                Text text = *now;
                const qsizetype from = random.bounded(int(text.string.size()) + 1);
                switch (random.bounded(7)) {
                case 0:
                    text.string.remove(from, random.bounded(4));
                    break;
                case 1:
                    text.vertical = !text.vertical;
                    break;
                case 2:
                    text.letterSpacing = float(random.bounded(3)) / 10;
                    break;
                case 3:
                    page.document.setSelection({strokesWithin(page.painting(), group), {}});
                    page.push(transformSelection(page.document, Affine::rotation({0, 0}, random.generateDouble()),
                                                 SpreadRule::Stays));
                    break;
                default:
                    text.string.insert(from, pieces[random.bounded(int(pieces.size()))]);
                }
                if (!text.string.isValidUtf16())
                    continue;
                text.place = textOf(page.painting(), group)->place;
                page.set(group, text, from);
                QCOMPARE(problemOf(page.painting()), QString());
                if (const SharedText set = textOf(page.painting(), group)) {
                    const std::vector<StrokeId> letters = lettersOf(page.painting(), group, page.layout.lay(*set));
                    QCOMPARE(letters, orderOf(page.painting()));
                }
            }
            const PaintingPtr last = page.document.painting();
            while (page.stack.canUndo())
                page.stack.undo();
            QVERIFY(page.painting().strokes.empty());
            while (page.stack.canRedo())
                page.stack.redo();
            QVERIFY(page.painting() == *last);
        }
    }
};

QTEST_MAIN(TestTextEdits)
#include "test_text_edits.moc"

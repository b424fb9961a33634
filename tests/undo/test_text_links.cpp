// Texts that follow the curve of a stroke: whatever becomes of the stroke becomes of them, in the same edit.
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "model/shaping/baseline_curve.h"
#include "model/shaping/transform.h"
#include "tests/undo/text_page.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/layer_edits.h"
#include "undo/text_links.h"
#include "undo/transform_edits.h"

#include <QGuiApplication>
#include <QRandomGenerator>
#include <QTest>

using namespace suffuse;

namespace {

/// A page with a wave and a text along it.
struct WavePage : TextPage {
    GroupId text = 0;
    StrokeId wave = 0;

    explicit WavePage(const QString &string = QStringLiteral("along"))
    {
        Stroke stroke;
        stroke.id = wave = document.takeStrokeId();
        stroke.origin = {100, 400};
        for (int k = 0; k < 3; ++k) {
            Segment segment;
            const float x = 150.0f * float(k);
            segment.bezier = {Offset{x, 0}, Offset{x + 50, k % 2 ? 60.0f : -60.0f},
                              Offset{x + 100, k % 2 ? 60.0f : -60.0f}, Offset{x + 150, 0}};
            stroke.segments.push_back(segment);
        }
        pushStep(stack, document, addStrokes(document, {std::make_shared<const Stroke>(stroke)}, false));
        Text set = typedText(string);
        set.size = 60;
        set.place = {};
        set.curve = baselineOf(stroke);
        set.follows = wave;
        text = put(set);
    }

    StrokePtr stroke() const { return painting().find(wave); }
    Text set() const { return *textOf(painting(), text); }
    void reshape(const std::function<void(Stroke &)> &how) { push(changeStrokes(document, {wave}, how)); }
    void select(const std::set<StrokeId> &strokes) { document.setSelection({strokes, {}}); }
    std::set<StrokeId> letters(GroupId group) const { return strokesWithin(painting(), group); }

    std::vector<StrokeId> lettersInOrder() { return lettersOf(painting(), text, layout.lay(set())); }
    double middleOf(StrokeId letter) const { return curveBox(*painting().find(letter)).centre().x; }
    /// Erases out of a letter along the pieces 0, 1, … of a path, of which it may have some. Each is born 100 µs later.
    void erase(StrokeId letter, const std::function<std::optional<std::pair<Point, Point>>(int)> &piece)
    {
        push(changeStrokes(document, {letter}, [&piece](Stroke &stroke) {
            bool goesOn = false;
            for (int k = 0; k < 60; ++k) {
                const auto ends = piece(k);
                if (!ends) {
                    goesOn = false;
                    continue;
                }
                Segment erasure;
                erasure.lift = true;
                erasure.start = !std::exchange(goesOn, true);
                erasure.maxAge = 0.1f;
                erasure.born = 100 * k;
                for (int i = 0; i < 4; ++i)
                    erasure.bezier[std::size_t(i)] =
                        toOffset(ends->first + (i / 3.0) * (ends->second - ends->first), stroke.origin);
                if (!erasure.start)
                    erasure.bezier[0] = stroke.segments.back().bezier[3];
                stroke.segments.push_back(erasure);
            }
        }));
    }

    /// How far the letters of a text are from where it is set, at most; canvas units.
    double strayOf(GroupId group)
    {
        const Text as = *textOf(painting(), group);
        const LaidText laid = layout.lay(as);
        const std::vector<StrokeId> ids = lettersOf(painting(), group, laid);
        double most = 0;
        std::size_t k = 0;
        for (const LaidCluster &cluster : laid.clusters) {
            if (!cluster.hasInk() || ids[k++] == 0)
                continue;
            const Point begin = (as.place * cluster.place)(cluster.outline->front().front().p[0]);
            const Stroke &letter = *painting().find(ids[k - 1]);
            most = std::max(most, length(letter.cubicOf(letter.segments.front()).p[0] - begin));
        }
        return most;
    }
    /// How far the curve of a text is from that of the stroke that it follows, as far as it was turned away from it.
    double apartOf(GroupId group) const
    {
        const Text as = *textOf(painting(), group);
        const BaselineCurve own(as.curve);
        std::vector<Cubic> led = baselineOf(*painting().find(as.follows));
        for (Cubic &curve : led)
            for (Point &p : curve.p)
                p = as.followMap(p);
        const BaselineCurve other(led);
        double most = 0;
        for (int i = 0; i <= 16; ++i)
            most =
                std::max(most, length(own.at(own.length() * i / 16).point - other.at(other.length() * i / 16).point));
        return most;
    }
};

} // namespace

class TestTextLinks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!LineShaper().hasFamily(QStringLiteral("DejaVu Sans")))
            QSKIP("DejaVu Sans is not installed");
    }

    void aReshapedStrokeTakesItsTextAlong()
    {
        WavePage page;
        const PaintingPtr before = page.document.painting();
        const int steps = page.stack.index();
        page.reshape([](Stroke &stroke) { stroke.segments[0].bezier[1].y = -200; });
        QCOMPARE(page.stack.index(), steps + 1);
        QCOMPARE(page.set().curve, baselineOf(*page.stroke()));
        QVERIFY(page.strayOf(page.text) < 1e-3);
        QVERIFY(*page.letter(2) != *before->strokes[2]);
        page.stack.undo();
        QVERIFY(page.painting() == *before);
        page.stack.redo();
        QCOMPARE(page.set().curve, baselineOf(*page.stroke()));
    }

    void aMovedStrokeTakesItsTextAlong()
    {
        WavePage page;
        const Point was = page.letter(1)->origin;
        page.select({page.wave});
        page.push(transformSelection(page.document, Affine::translation({30, -20}), SpreadRule::Scales));
        QVERIFY(length(page.letter(1)->origin - was - Point{30, -20}) < 1e-6);
        QVERIFY(page.strayOf(page.text) < 1e-3);
    }

    /// What one drag of the eraser took from several letters stays one path where the line bends strongly: its parts
    /// in letters beside each other still lie upon each other, it keeps its distance from the line, and it comes back.
    void anErasureOverSeveralLettersBends()
    {
        WavePage page;
        const std::vector<StrokeId> letters = page.lettersInOrder();
        const auto level = [](Stroke &stroke) {
            for (Segment &segment : stroke.segments)
                for (Offset &p : segment.bezier)
                    p.y = 0;
        };
        page.reshape(level);
        constexpr double above = 20, piece = 8;
        for (const StrokeId id : letters) // each part of the path in the letters that it may reach
            page.erase(id, [&page, id](int k) {
                const Point from{100 + piece * k, 400 - above};
                const bool reaches = std::abs(from.x + piece / 2 - page.middleOf(id)) < 40;
                return reaches ? std::optional(std::pair(from, from + Point{piece, 0})) : std::nullopt;
            });
        const PaintingPtr straight = page.document.painting();
        page.reshape([](Stroke &stroke) { stroke.segments[0].bezier[1].y = stroke.segments[0].bezier[2].y = -260; });
        QVERIFY(page.strayOf(page.text) < 1e-3);
        const BaselineCurve line(page.set().curve);
        std::map<Microseconds, Cubic> parts;
        int shared = 0;
        for (const StrokeId id : letters) {
            const StrokePtr letter = page.painting().find(id);
            for (const Segment &segment : letter->segments) {
                if (!segment.lift)
                    continue;
                const Cubic curve = letter->cubicOf(segment);
                for (const Point p : {curve.p[0], curve.p[3]}) {
                    const double along = line.besides(p, piece * double(segment.born) / 100);
                    QVERIFY(std::abs(length(p - line.at(along).point) - above) < 1e-3);
                }
                const auto [other, isNew] = parts.emplace(segment.born, curve);
                shared += !isNew;
                for (std::size_t i = 0; i < 4; ++i)
                    QVERIFY(length(curve.p[i] - other->second.p[i]) < 1e-3);
            }
        }
        QVERIFY(shared > 5);
        page.reshape(level);
        for (const StrokeId id : letters) {
            const StrokePtr was = straight->find(id), is = page.painting().find(id);
            QCOMPARE(is->segments.size(), was->segments.size());
            for (std::size_t k = 0; k < is->segments.size(); ++k)
                for (std::size_t i = 0; i < 4; ++i)
                    QVERIFY(length(is->origin + is->segments[k].bezier[i] -
                                   (was->origin + was->segments[k].bezier[i])) < 1e-3);
        }
    }

    /// What was erased out of one letter goes with it as it is.
    void anErasureWithinOneLetterIsTurnedWithIt()
    {
        WavePage page;
        const StrokeId id = page.lettersInOrder()[1];
        const Stroke before = *page.painting().find(id);
        const Point corner = before.cubicOf(before.segments.front()).p[0];
        page.erase(id, [corner](int k) {
            return k < 2 ? std::optional(std::pair(corner + Point{5.0 * k, 0}, corner + Point{5.0 * k + 5, 0}))
                         : std::nullopt;
        });
        page.reshape([](Stroke &stroke) { stroke.segments[0].bezier[1].y = stroke.segments[0].bezier[2].y = -260; });
        const StrokePtr after = page.painting().find(id);
        const Segment &first = after->segments[after->segments.size() - 2], &last = after->segments.back();
        QVERIFY(first.lift && last.lift);
        const Point begin = after->cubicOf(first).p[0], end = after->cubicOf(last).p[3];
        QVERIFY(length(begin - after->cubicOf(after->segments.front()).p[0]) < 1e-3);
        QVERIFY(std::abs(length(end - begin) - 10) < 1e-3);
        QVERIFY(std::abs(end.y - begin.y) > 1);
    }

    /// A letter keeps what makes it that letter: its colour, and what was drawn otherwise.
    void lettersKeepTheirValues()
    {
        WavePage page;
        page.recolour(2, {1, 0.2f, 0, 1});
        page.push(changeStrokes(page.document, {page.letter(3)->id}, [](Stroke &stroke) {
            stroke.segments.resize(stroke.segments.size() - 1); // open now, as no font has it
        }));
        const std::size_t segments = page.letter(3)->segments.size();
        const Point was = page.letter(3)->origin;
        page.reshape([](Stroke &stroke) { stroke.segments[0].bezier[2].y = 150; });
        QCOMPARE(page.letter(2)->fill->colour, (Colour{1, 0.2f, 0, 1}));
        QCOMPARE(page.letter(3)->segments.size(), segments);
        QVERIFY(length(page.letter(3)->origin - was) > 1);
    }

    /// What is mapped as a whole, text and stroke, is what the map makes of it, and is linked as before.
    void bothAreMappedTogether()
    {
        const Affine maps[] = {Affine::translation({7, 9}), Affine::rotation({300, 300}, 0.7),
                               Affine::scaling({0, 0}, 1.5, 1.5), Affine::scaling({0, 0}, 2, 0.7),
                               Affine::skew({100, 100}, 0.4, 0)};
        for (const Affine &map : maps) {
            WavePage page;
            const Stroke letter = *page.letter(2);
            std::set<StrokeId> all = page.letters(page.text);
            all.insert(page.wave);
            page.select(all);
            page.push(transformSelection(page.document, map, SpreadRule::Scales));
            const Point begin = map(letter.cubicOf(letter.segments.front()).p[0]);
            const Stroke now = *page.letter(2);
            QVERIFY(length(now.cubicOf(now.segments.front()).p[0] - begin) < 1e-3);
            QVERIFY(page.strayOf(page.text) < 1e-2);
            QVERIFY2(page.apartOf(page.text) < 0.2, qPrintable(QString::number(page.apartOf(page.text))));
            page.reshape([](Stroke &stroke) { stroke.origin.y += 40; });
            QVERIFY(page.strayOf(page.text) < 1e-2);
            const Stroke last = *page.letter(2);
            QVERIFY(length(last.cubicOf(last.segments.front()).p[0] - begin - Point{0, 40}) < 0.5);
        }
    }

    void aTextThatWasMovedKeepsItsDistance()
    {
        WavePage page;
        page.select(page.letters(page.text));
        page.push(transformSelection(page.document, Affine::translation({0, 50}), SpreadRule::Scales));
        const Point was = page.letter(1)->origin;
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QVERIFY(length(page.letter(1)->origin - was - Point{25, 0}) < 1e-6);
    }

    void aStrokeThatIsDeletedLeavesTheText()
    {
        WavePage page;
        const StrokePtr letter = page.letter(1);
        const Text was = page.set();
        page.select({page.wave});
        page.push(deleteSelection(page.document));
        QCOMPARE(page.letter(0), letter);
        QCOMPARE(page.set().follows, StrokeId(0));
        QCOMPARE(page.set().curve, was.curve);
        page.stack.undo();
        QCOMPARE(page.set(), was);
    }

    void aReleasedTextStays()
    {
        WavePage page;
        QVERIFY(!canReleaseTexts(page.document));
        page.select(page.letters(page.text));
        QVERIFY(canReleaseTexts(page.document));
        const StrokePtr letter = page.letter(1);
        page.push(releaseTexts(page.document));
        QVERIFY(!canReleaseTexts(page.document));
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QCOMPARE(page.letter(1), letter);
        QVERIFY(!page.set().curve.empty());
        page.stack.undo();
        page.stack.undo();
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QVERIFY(page.letter(1) != letter);
    }

    void aLockedTextStays()
    {
        WavePage page;
        page.push(setGroupLocked(page.document, page.text, true));
        const StrokePtr letter = page.letter(1);
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QCOMPARE(page.letter(1), letter);
        page.push(setGroupLocked(page.document, page.text, false));
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QCOMPARE(page.set().curve, baselineOf(*page.stroke()));
    }

    /// Else two texts could lead each other in a circle.
    void aLetterLeadsNoText()
    {
        WavePage page;
        const StrokePtr leading = page.letter(2);
        Text other = typedText(QStringLiteral("x"));
        other.place = {};
        other.curve = baselineOf(*leading);
        other.follows = leading->id;
        const GroupId group = page.put(other);
        const StrokePtr letter = page.painting().strokes.back();
        page.reshape([](Stroke &stroke) { stroke.origin.x += 25; });
        QCOMPARE(page.painting().strokes.back(), letter);
        QCOMPARE(*textOf(page.painting(), group), other);
    }

    void copiesFollowCopies()
    {
        WavePage page;
        std::set<StrokeId> all = page.letters(page.text);
        page.select(all);
        page.push(duplicateSelection(page.document, {10, 20}));
        QCOMPARE(page.painting().groups.back().text->follows, StrokeId(0)); // the text alone
        QCOMPARE(page.painting().groups.back().text->curve, page.set().curve);
        page.stack.undo();
        all.insert(page.wave);
        page.select(all);
        page.push(duplicateSelection(page.document, {10, 20}));
        const Group copy = page.painting().groups.back();
        QVERIFY(copy.id != page.text);
        QVERIFY(copy.text->follows != 0 && copy.text->follows != page.wave);
        QVERIFY(page.apartOf(copy.id) < 1e-6);
        const Point was = page.painting().strokes.back()->origin;
        const StrokePtr own = page.letter(1);
        page.push(changeStrokes(page.document, {copy.text->follows}, [](Stroke &stroke) { stroke.origin.x += 25; }));
        QVERIFY(length(page.painting().strokes.back()->origin - was - Point{25, 0}) < 1e-6);
        QCOMPARE(page.letter(1), own);
        QVERIFY(page.strayOf(copy.id) < 1e-3);
    }

    void copiedLayersFollowCopies()
    {
        WavePage page;
        std::set<StrokeId> all = page.letters(page.text);
        all.insert(page.wave);
        page.select(all);
        page.push(groupSelection(page.document, QStringLiteral("both")));
        const auto layer = std::ranges::find_if(page.painting().groups, [](const Group &g) { return !g.text; })->id;
        GroupId copy = 0;
        page.push(duplicateGroup(page.document, layer, QStringLiteral("copy"), copy));
        const Group text = *std::ranges::find_if(
            page.painting().groups, [&](const Group &group) { return group.text && group.id != page.text; });
        QVERIFY(text.text->follows != 0 && text.text->follows != page.wave);
        QVERIFY(page.painting().find(text.text->follows));
    }

    /// Both formats keep the link; without one they are what they were.
    void filesKeepTheLink()
    {
        WavePage page;
        const Painting painting = page.painting();
        const QByteArray text = writeTextForm(painting);
        QVERIFY(text.contains("\"version\": 5") && text.contains("\"follows\": "));
        const Result<Painting> read = readTextForm(text, QStringLiteral("a"));
        QVERIFY(read && *read == painting && hashOf(*read) == hashOf(painting));
        const Result<Painting> document = readSuffuseFile(writeSuffuseFile(painting), QStringLiteral("a"));
        QVERIFY(document && *document == painting);

        page.select(page.letters(page.text));
        page.push(releaseTexts(page.document));
        const QByteArray plainText = writeTextForm(page.painting());
        QVERIFY(plainText.contains("\"version\": 2") && !plainText.contains("follow"));
        QVERIFY(hashOf(page.painting()) != hashOf(painting));
    }

    void aFileWithoutTheStrokeLeavesTheCurve()
    {
        WavePage page;
        Painting without = page.painting();
        without.strokes.erase(without.strokes.cbegin());
        for (const bool isText : {true, false}) {
            const Result<Painting> read = isText ? readTextForm(writeTextForm(without), QStringLiteral("a"))
                                                 : readSuffuseFile(writeSuffuseFile(without), QStringLiteral("a"));
            QVERIFY(read);
            QCOMPARE(read->groups.front().text->follows, StrokeId(0));
            QCOMPARE(read->groups.front().text->curve, page.set().curve);
        }
    }

    /// Whatever is done in whatever order: the painting is sound, the text lies along its stroke, and undo leads back.
    void randomWalk()
    {
        QRandomGenerator random(11);
        const auto number = [&random](double most) { return (2 * random.generateDouble() - 1) * most; };
        for (int walk = 0; walk < 10; ++walk) {
            WavePage page;
            std::vector<PaintingPtr> states;
            for (int step = 0; step < 40; ++step) {
                states.resize(std::size_t(page.stack.index()), nullptr);
                states.push_back(page.document.painting());
                std::set<StrokeId> chosen;
                if (random.bounded(2))
                    chosen = page.letters(page.text);
                if (random.bounded(2))
                    chosen.insert(page.wave);
                page.select(chosen);
                switch (random.bounded(6)) {
                case 0:
                    page.reshape([&](Stroke &stroke) {
                        const auto k = std::size_t(random.bounded(int(stroke.segments.size())));
                        stroke.segments[k].bezier[1 + std::size_t(random.bounded(2))].y += float(number(30));
                    });
                    break;
                case 1:
                    page.push(transformSelection(page.document, Affine::translation({number(50), number(50)}),
                                                 SpreadRule::Scales));
                    break;
                case 2:
                    page.push(
                        transformSelection(page.document, Affine::rotation({300, 300}, number(1)), SpreadRule::Scales));
                    break;
                case 3: {
                    const double scale = std::exp(number(0.2));
                    page.push(transformSelection(page.document, Affine::scaling({300, 300}, scale, scale),
                                                 SpreadRule::Scales));
                    break;
                }
                case 4:
                    page.retype(page.text, QStringLiteral("along %1").arg(random.bounded(100)));
                    break;
                default:
                    if (page.stack.canUndo() && page.stack.index() > 2) {
                        page.stack.undo();
                        const PaintingPtr &was = states[std::size_t(page.stack.index())];
                        QVERIFY(!was || *was == page.painting());
                    }
                }
                QCOMPARE(problemOf(page.painting()), QString());
                QCOMPARE(page.set().follows, page.wave);
                QVERIFY2(page.apartOf(page.text) < 0.05, qPrintable(QString::number(page.apartOf(page.text))));
                QVERIFY2(page.strayOf(page.text) < 0.05, qPrintable(QString::number(page.strayOf(page.text))));
            }
        }
    }
};

QTEST_MAIN(TestTextLinks)
#include "test_text_links.moc"

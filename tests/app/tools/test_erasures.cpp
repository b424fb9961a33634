// What the eraser that lifts paint leaves: erasures that can be seen, moved, weakened and taken out.
#include "app/panels/inspector/figures/density_plot.h"
#include "app/panels/inspector/figures/figures_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/rows/erasure_rows.h"
#include "app/panels/inspector/segment_section.h"
#include "app/tools/nodes/erasures.h"
#include "app/tools/nodes/node_marks.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "tests/app/nodes.h"
#include "tests/app/panel_bench.h"
#include "tests/app/tools/eraser_session.h"
#include "undo/edits.h"
#include "undo/layers/group_edits.h"
#include "undo/transform_edits.h"

#include <QStatusBar>
#include <QTemporaryDir>

using namespace suffuse;

class TestErasures : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    /// In the Segments tool an erasure is one thing: a click takes it, a drag moves it, Del takes it out.
    void erasuresAreSegments()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.erase({250, 250}, {250, 390});
        s.dry();
        const int count = s.erasing(s.id), paint = int(s.stroke().segments.size()) - count;
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.id}, {}});
        QTRY_VERIFY(s.summary().contains("4 segment(s)") && s.summary().contains("erasing"));
        const auto onCurve = [&](int k) { return s.stroke().cubicOf(s.stroke().segments[std::size_t(k)]).at(0.5); };
        const Chain first = chainAt(s.stroke(), paint);
        s.click(onCurve(first.first + 2)); // beside the paint's own curve
        QCOMPARE(int(s.selection().segments.size()), first.last - first.first + 1);
        QVERIFY(s.selection().segments.contains({s.id, first.first}));
        QTRY_VERIFY(s.summary().contains("take paint away"));
        const Stroke before = s.stroke();
        const Point grabbed = onCurve(first.first + 2);
        s.drag(grabbed, grabbed + Point{40, 0});
        for (int k = 0; k < int(before.segments.size()); ++k) {
            const bool moves = k >= first.first && k <= first.last;
            const double by = double(s.stroke().segments[std::size_t(k)].bezier[1].x) -
                              double(before.segments[std::size_t(k)].bezier[1].x);
            QVERIFY(std::abs(by - (moves ? 40 : 0)) < 1e-3);
        }
        QTest::keyClick(&s.canvas(), Qt::Key_Right);
        QVERIFY(s.stroke().segments[std::size_t(first.first)].bezier[0].x >
                before.segments[std::size_t(first.first)].bezier[0].x + 40.5f);
        QCOMPARE(s.stroke().segments[0], before.segments[0]);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke() == before);
        // Weaker, in the inspector's way; then out.
        s.editor().push(changeSegments(s.editor().document(), targetSegments(s.editor().document()),
                                       [](Segment &segment) { segment.density *= 0.1f; }),
                        "weaken");
        QCOMPARE(s.stroke().segments[0].density, before.segments[0].density);
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.erasing(s.id), count - (first.last - first.first + 1));
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        s.use(Command::RemoveErasures);
        QCOMPARE(s.erasing(s.id), 0);
        QVERIFY(!s.window.action(Command::RemoveErasures).isEnabled());
    }

    /// What a click has chosen is what a drag moves, though a node of the paint lies beside it.
    void aChosenErasureIsTakenBeforeNodesOfPaint()
    {
        EraserSession s;
        const Point node = nodePosition(s.stroke(), 1);
        s.erase(node + Point{3, -60}, node + Point{3, 60});
        s.dry();
        s.use(Command::Segments);
        std::set<SegmentRef> erasing;
        for (int k = 0; k < int(s.stroke().segments.size()); ++k)
            if (s.stroke().segments[std::size_t(k)].lift)
                erasing.insert({s.id, k});
        QVERIFY(!erasing.empty());
        s.editor().document().setSelection({{s.id}, erasing});
        const Stroke before = s.stroke();
        const int steps = s.steps();
        s.drag(node + Point{2, 0}, node + Point{42, 0});
        QCOMPARE(s.steps(), steps + 1);
        for (int k = 0; k < int(before.segments.size()); ++k) {
            const double by = double(s.stroke().segments[std::size_t(k)].bezier[1].x) -
                              double(before.segments[std::size_t(k)].bezier[1].x);
            QVERIFY2(std::abs(by - (erasing.contains({s.id, k}) ? 40 : 0)) < 1e-3, qPrintable(QString::number(k)));
        }
    }

    /// The inspector speaks of strength and size, not of ink; the handle that shows how wide paint is stays away.
    void theInspectorSpeaksOfErasures()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Segments);
        auto &panel = *s.window.findChild<InspectorPanel *>();
        auto &figures = *panel.findChild<FiguresSection *>();
        auto &segments = *panel.findChild<SegmentSection *>();
        std::set<SegmentRef> erasing;
        for (int k = 0; k < int(s.stroke().segments.size()); ++k)
            if (s.stroke().segments[std::size_t(k)].lift)
                erasing.insert({s.id, k});
        const auto speaksOfErasures = [&] { return !segments.erasure()->size()->label()->isHidden(); };
        const auto hasWidthHandle = [&] {
            for (double x = 190; x <= 610; x += 4)
                for (double y = 260; y <= 400; y += 4) {
                    s.hover({x, y});
                    if (s.hint().contains("set the width"))
                        return true;
                }
            return false;
        };
        s.editor().document().setSelection({{s.id}, erasing});
        QTRY_VERIFY(speaksOfErasures());
        QVERIFY(figures.warnings()->text().isEmpty());
        QVERIFY(figures.densityPlot()->isHidden() && figures.figure(3)->isHidden() && !figures.figure(6)->isHidden());
        QVERIFY(segments.colour()->isHidden());
        QVERIFY(!hasWidthHandle());
        erasing.insert({s.id, 1}); // paint, too: it counts alone
        s.editor().document().setSelection({{s.id}, erasing});
        QTRY_VERIFY(!speaksOfErasures());
        QVERIFY(figures.figure(6)->isHidden() && !figures.figure(3)->isHidden() && !segments.colour()->isHidden());
        QVERIFY(hasWidthHandle());
    }

    /// While erasures are shown, one of any stroke can be taken, also of one that is not selected.
    void anErasureOfAnyStrokeIsTaken()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.other}, {}});
        const Chain erasure = chainAt(s.stroke(), int(s.stroke().segments.size()) - 1);
        const int middle = (erasure.first + erasure.last) / 2;
        const Point at = s.stroke().cubicOf(s.stroke().segments[std::size_t(middle)]).at(0.5);
        s.click(at); // not shown: the paint is meant, if there is any
        QVERIFY(!s.selection().segments.contains({s.id, middle}));
        s.editor().document().setSelection({{s.other}, {}});
        s.use(Command::ShowErasures);
        s.click(at);
        QCOMPARE(s.selection().strokes, std::set<StrokeId>{s.id});
        QCOMPARE(int(s.selection().segments.size()), erasure.last - erasure.first + 1);
        QVERIFY(s.selection().segments.contains({s.id, middle}));
        const int steps = s.steps();
        s.editor().document().setSelection({});
        s.drag(at, at + Point{30, 0}); // takes it and moves it
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(s.stroke().cubicOf(s.stroke().segments[std::size_t(middle)]).at(0.5).x > at.x + 29);
        s.use(Command::Undo);
        s.editor().push(setLocked(s.editor().document(), {s.id}, true), "lock");
        s.editor().document().setSelection({});
        s.click(at);
        QVERIFY(s.selection().segments.empty());
        s.use(Command::ShowErasures);
    }

    /// One path of the hand through several strokes is one thing, as it was when it was painted.
    void anErasureThroughSeveralStrokesIsOne()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 500}); // through both
        s.dry();
        s.erase({250, 250}, {250, 390}); // another one, through the first stroke only
        s.dry();
        QVERIFY(s.erasing(s.other) > 0);
        s.use(Command::ShowErasures);
        s.use(Command::Segments);
        s.editor().document().setSelection({});
        const auto lifts = [&](StrokeId id, double x) {
            std::set<SegmentRef> found;
            const Stroke &stroke = s.stroke(id);
            for (int k = 0; k < int(stroke.segments.size()); ++k)
                if (const Segment &segment = stroke.segments[std::size_t(k)];
                    segment.lift && std::abs(stroke.cubicOf(segment).at(0.5).x - x) < 20)
                    found.insert({id, k});
            return found;
        };
        const std::set<SegmentRef> above = lifts(s.id, 350), below = lifts(s.other, 350);
        std::set<SegmentRef> both = above;
        both.insert(below.begin(), below.end());
        QVERIFY(!above.empty() && !below.empty() && !lifts(s.id, 250).empty());
        const int middle = std::next(above.begin(), std::ptrdiff_t(above.size() / 2))->segment;
        const Point at = s.stroke().cubicOf(s.stroke().segments[std::size_t(middle)]).at(0.5);
        s.click(at);
        QCOMPARE(s.selection().segments, both);
        QCOMPARE(s.selection().strokes, (std::set<StrokeId>{s.id, s.other}));
        // It moves as one, in one step, and so it is taken out.
        const PaintingPtr before = s.editor().document().painting();
        const int steps = s.steps();
        s.drag(at, at + Point{40, 0});
        QCOMPARE(s.steps(), steps + 1);
        for (const StrokeId id : {s.id, s.other})
            for (int k = 0; k < int(s.stroke(id).segments.size()); ++k) {
                const double by = double(s.stroke(id).segments[std::size_t(k)].bezier[0].x) -
                                  double(before->find(id)->segments[std::size_t(k)].bezier[0].x);
                QVERIFY(std::abs(by - (both.contains({id, k}) ? 40 : 0)) < 1e-3);
            }
        s.use(Command::Undo);
        s.editor().document().setSelection({});
        s.click(at);
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.erasing(s.other), 0);
        QCOMPARE(s.erasing(s.id), int(lifts(s.id, 250).size()));
        QCOMPARE(s.steps(), steps + 1);
        // The strokes that it ran through are seen as selected, but not meant by the next Delete.
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));
        QCOMPARE(s.steps(), steps + 1);
        s.use(Command::Undo);
        // A second click means the part in this stroke, a third one its segment.
        s.editor().document().setSelection({});
        s.click(at);
        s.click(at);
        QCOMPARE(s.selection().segments, above);
        s.click(at); // it is short, so its nodes lie everywhere
        QVERIFY(s.selection().segments.empty() && dynamic_cast<NodeTool *>(s.canvas().tool())->nodes().size() == 1);
        // What is locked is left out.
        s.editor().push(setLocked(s.editor().document(), {s.other}, true), "lock");
        s.editor().document().setSelection({});
        s.click(at);
        QCOMPARE(s.selection().segments, above);
        s.use(Command::ShowErasures);
    }

    /// Between two strokes a slow hand is over bare paper for longer than an erasure takes to dry.
    void aSlowHandsErasureIsOneToo()
    {
        EraserSession s;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({350, 250}));
        for (int i = 1; i <= 50; ++i) {
            s.advance(40'000);
            s.move({350, 250 + 5.0 * i});
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 500}));
        s.dry();
        s.erase({390, 250}, {390, 500}); // a path beside it is another one
        s.dry();
        const auto birthsOf = [&](StrokeId id) {
            std::vector<Microseconds> births;
            for (const Segment &segment : s.stroke(id).segments)
                if (segment.lift && std::abs(s.stroke(id).cubicOf(segment).at(0.5).x - 350) < 15)
                    births.push_back(segment.born);
            return births;
        };
        const std::vector<Microseconds> above = birthsOf(s.id), below = birthsOf(s.other);
        QVERIFY(!above.empty() && !below.empty());
        QVERIFY2(below.front() - above.back() > 150'000, qPrintable(QString::number(below.front() - above.back())));
        s.use(Command::ShowErasures);
        s.use(Command::Segments);
        s.editor().document().setSelection({});
        for (int k = 0; k < int(s.stroke().segments.size()); ++k)
            if (const Segment &segment = s.stroke().segments[std::size_t(k)];
                segment.lift && segment.born == above[above.size() / 2]) {
                s.click(s.stroke().cubicOf(segment).at(0.5));
                break;
            }
        QCOMPARE(s.selection().segments.size(), above.size() + below.size());
        QCOMPARE(s.selection().strokes, (std::set<StrokeId>{s.id, s.other}));
        // So it is where the strokes run the other way now: their births tell which way the hand went.
        const Selection both = s.selection();
        s.use(Command::ReverseStrokes);
        const SegmentRef reversed = *s.selection().segments.begin();
        QVERIFY(s.selection() != both && s.stroke(reversed.stroke).segments[std::size_t(reversed.segment)].lift);
        QCOMPARE(wholeErasureOf(s.painting(), reversed), s.selection().segments);
        s.use(Command::ShowErasures);
    }

    /// A copy of a stroke has births like the original's, but its erasure is another one; those of strokes that were
    /// copied together belong together.
    void theErasureOfACopyIsItsOwn()
    {
        for (const EraserMode mode : {EraserMode::Lift, EraserMode::Fade})
            for (const bool duplicates : {true, false})
                for (const bool both : {true, false}) {
                    EraserSession s(mode);
                    s.erase({350, 250}, {350, 500}); // through both
                    s.dry();
                    const auto whole = [&s](StrokeId id) {
                        return wholeErasureOf(s.painting(), {id, int(s.stroke(id).segments.size()) - 1});
                    };
                    const auto erasing = [&s](const std::set<StrokeId> &ids) {
                        std::set<SegmentRef> found;
                        for (const StrokeId id : ids)
                            for (int k = 0; k < int(s.stroke(id).segments.size()); ++k)
                                if (s.stroke(id).segments[std::size_t(k)].takesPaint())
                                    found.insert({id, k});
                        return found;
                    };
                    const std::set<StrokeId> originals{s.id, s.other};
                    QCOMPARE(whole(s.id), erasing(originals));
                    s.editor().document().setSelection({both ? originals : std::set<StrokeId>{s.id}, {}});
                    if (!duplicates)
                        s.use(Command::Copy);
                    s.use(duplicates ? Command::Duplicate : Command::PasteInPlace);
                    const std::set<StrokeId> copies = s.selection().strokes;
                    QCOMPARE(copies.size(), std::size_t(both ? 2 : 1));
                    QVERIFY(!copies.contains(s.id));
                    const auto isApart = [&] {
                        return std::ranges::all_of(copies, [&](StrokeId id) { return whole(id) == erasing(copies); }) &&
                               std::ranges::all_of(originals,
                                                   [&](StrokeId id) { return whole(id) == erasing(originals); });
                    };
                    QVERIFY(isApart()); // at the same place, too
                    s.editor().push(changeStrokes(s.editor().document(), copies,
                                                  [](Stroke &stroke) {
                                                      stroke.segments[0].colour = {1, 0, 0, 1};
                                                  }),
                                    "recolour");
                    QVERIFY(isApart());
                    s.editor().push(
                        transformSelection(s.editor().document(), Affine::translation({40, 30}), SpreadRule::Stays),
                        "move");
                    QVERIFY(isApart());
                }
    }

    /// A fast hand passes several strokes, as letters, in one moment: its births are the same all along that line.
    void aFastHandsErasureIsNoCopy()
    {
        Painting painting;
        const auto add = [&painting](StrokeId id, Point by) {
            Stroke stroke = *makeStroke(id, 1, 10);
            Segment segment = stroke.segments[0];
            segment.bezier = {Offset{-5, 0}, Offset{-2, 0}, Offset{2, 0}, Offset{5, 0}};
            segment.start = segment.lift = true;
            segment.maxAge = 0.1f;
            segment.born = 5'000'000;
            stroke.segments.push_back(segment);
            stroke.origin = Point{100, 100} + by;
            painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
        };
        add(1, {});
        add(2, {30, 0});
        add(3, {60, 4}); // a letter that was turned
        add(4, {10, 50});
        QCOMPARE(wholeErasureOf(painting, {2, 1}), (std::set<SegmentRef>{{1, 1}, {2, 1}, {3, 1}}));
        QCOMPARE(wholeErasureOf(painting, {4, 1}), (std::set<SegmentRef>{{4, 1}}));
    }

    /// An erasure is nothing without the paint that it takes away.
    void duplicateDoublesAnErasure()
    {
        EraserSession s;
        s.eraser().setChoice({.strength = 0.4});
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Segments);
        const Stroke before = s.stroke();
        const Chain erasure = chainAt(before, int(before.segments.size()) - 1);
        Selection chosen{{s.id}, {}};
        for (int k = erasure.first; k <= erasure.last; ++k)
            chosen.segments.insert({s.id, k});
        s.editor().document().setSelection(chosen);
        const QImage weak = s.pictureNow();
        s.use(Command::Duplicate);
        QCOMPARE(s.editor().undoText(), QString("Duplicate"));
        QVERIFY(s.window.statusBar()->currentMessage().contains("twice")); // Two lines at one place look like one.
        QCOMPARE(s.painting().strokes.size(), std::size_t(2));             // no stroke more
        const int count = erasure.last - erasure.first + 1;
        QCOMPARE(s.stroke().segments.size(), before.segments.size() + std::size_t(count));
        QCOMPARE(chainsOf(s.stroke()).back(), (Chain{erasure.last + 1, erasure.last + count}));
        QVERIFY(
            std::equal(s.stroke().segments.end() - count, s.stroke().segments.end(), before.segments.end() - count));
        std::set<SegmentRef> copies;
        for (int k = 1; k <= count; ++k)
            copies.insert({s.id, erasure.last + k});
        QCOMPARE(s.selection().segments, copies); // Arrow keys move the copy.
        QVERIFY(s.pictureNow() != weak);          // It takes away once more.
        QTest::keyClick(&s.canvas(), Qt::Key_Right);
        QCOMPARE(s.stroke().segments[std::size_t(erasure.first)], before.segments[std::size_t(erasure.first)]);
        QVERIFY(s.stroke().segments.back().bezier[0].x > before.segments.back().bezier[0].x);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.stroke(), before);
        QCOMPARE(s.selection().segments, chosen.segments);
        s.editor().push(setLocked(s.editor().document(), {s.id}, true), "lock");
        const int steps = s.steps();
        s.editor().document().setSelection(chosen);
        s.use(Command::Duplicate);
        QCOMPARE(s.steps(), steps);
    }

    /// In lettering a node is in reach everywhere. Over an erasure one is meant where it is seen.
    void anErasureBesideANodeIsGrabbed()
    {
        EraserSession s;
        s.eraser().setRadius(100); // so that it has few nodes itself
        constexpr double beside = 6.5;
        const double unit = s.canvas().devicePixelRatioF() / s.canvas().view().scale; // of a logical pixel
        const Cubic curve = s.stroke().cubicOf(s.stroke().segments[2]);
        const Point node = curve.p[0], along = (1 / length(curve.p[1] - node)) * (curve.p[1] - node);
        const Point place = node + (beside * unit) * Point{along.y, -along.x};
        s.erase(place - 40 * along, place + 120 * along);
        s.dry();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.id}, {}});
        for (const Segment &segment : s.stroke().segments)
            if (segment.takesPaint())
                for (const Point end : {s.stroke().cubicOf(segment).p[0], s.stroke().cubicOf(segment).p[3]})
                    QVERIFY(length(s.sent(place) - end) > NodeMarks::reach * unit);
        QVERIFY(length(s.sent(place) - node) < NodeMarks::reach * unit);
        s.click(place);
        QVERIFY(!s.selection().segments.empty());
        for (const SegmentRef &ref : s.selection().segments)
            QVERIFY(s.stroke(ref.stroke).segments[std::size_t(ref.segment)].takesPaint());
        s.editor().document().setSelection({{s.id}, {}});
        s.click(node);
        QVERIFY(s.selection().segments.empty());
    }

    /// Nodes of paint do not hide it.
    void anErasureIsSeenOverNodes()
    {
        EraserSession s;
        const Point node = nodePosition(s.stroke(), 2), up{0, 60};
        s.erase(node - up, node + up);
        s.dry();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.id}, {}});
        const auto overNode = [&s, node] {
            while (!s.canvas().isUpToDate())
                QTest::qWait(5);
            const double dpr = s.canvas().devicePixelRatioF();
            const int side = int(4 * dpr);
            const Point pixel = s.canvas().view().toPixels(node);
            return s.canvas().grab().toImage().copy(int(pixel.x) - side / 2, int(pixel.y) - side / 2, side, side);
        };
        const QImage lined = overNode();
        const Microseconds born = s.stroke().segments.back().born;
        s.editor().clock().setTime(s.stroke(s.other).driesAt());
        QVERIFY(s.editor().clock().time() < born);
        QVERIFY(overNode() != lined);
    }

    /// The frame goes by what is seen.
    void erasuresDoNotEnlargeTheFrame()
    {
        EraserSession s;
        s.editor().document().setSelection({{s.id}, {}});
        const Rect before = selectionBox(s.painting(), s.selection());
        const QRect onScreen = s.canvas().selectionOnScreen();
        s.editor().document().setSelection({});
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.editor().document().setSelection({{s.id}, {}});
        bool beyond = false;
        for (const Segment &segment : s.stroke().segments)
            beyond = beyond || (segment.lift && s.stroke().cubicOf(segment).p[3].y > before.bottom + 1);
        QVERIFY(beyond);
        QCOMPARE(selectionBox(s.painting(), s.selection()), before);
        QCOMPARE(s.canvas().selectionOnScreen(), onScreen);
    }

    void hintsSpeakOfTheErasure()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.id}, {}});
        const Chain erasure = chainAt(s.stroke(), int(s.stroke().segments.size()) - 1);
        const Segment &beside = s.stroke().segments[std::size_t(erasure.first) + 2]; // no node is shown near its middle
        const Point at = s.stroke().cubicOf(beside).at(0.5);
        s.hover(at);
        QVERIFY2(s.hint().startsWith("Drag to move the erasure"), qPrintable(s.hint()));
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(at));
        for (int i = 1; i <= 6; ++i)
            s.move(at + Point{4.0 * i, 0});
        QVERIFY2(s.hint().startsWith("Move the erasure"), qPrintable(s.hint()));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(at + Point{24, 0}));
        QCOMPARE(s.editor().undoText(), QString("Move erasure"));
        s.hover({20, 20});
        QVERIFY(!s.hint().contains("erasure"));
    }

    /// A short erasure is little more than its nodes: they are taken only once it is selected.
    void itsNodesComeSecond()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Segments);
        s.editor().document().setSelection({{s.id}, {}});
        const Chain erasure = chainAt(s.stroke(), int(s.stroke().segments.size()) - 1);
        const Point end = nodePosition(s.stroke(), endNode(s.stroke(), erasure.last));
        s.hover(end);
        QVERIFY2(s.hint().startsWith("Drag to move the erasure"), qPrintable(s.hint()));
        const Stroke before = s.stroke();
        s.drag(end, end + Point{25, 0});
        QCOMPARE(s.editor().undoText(), QString("Move erasure"));
        for (int k = erasure.first; k <= erasure.last; ++k)
            QVERIFY(s.stroke().segments[std::size_t(k)].bezier[0].x > before.segments[std::size_t(k)].bezier[0].x + 24);
        s.use(Command::Undo);
        s.editor().document().setSelection({{s.id}, {}});
        const auto *tool = qobject_cast<NodeTool *>(s.canvas().tool());
        s.click(end);
        QCOMPARE(int(s.selection().segments.size()), erasure.last - erasure.first + 1);
        QVERIFY(tool->nodes().empty());
        s.click(end);
        QCOMPARE(tool->nodes(), (std::set<NodeRef>{{s.id, endNode(s.stroke(), erasure.last)}}));
        s.hover(end);
        QVERIFY2(s.hint().startsWith("Drag to move nodes"), qPrintable(s.hint()));
    }

    /// Values of whole strokes are those of their paint.
    void erasuresKeepTheirValues()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        const Stroke before = s.stroke();
        s.editor().document().setSelection({{s.id}, {}});
        s.editor().push(changeSegments(s.editor().document(), targetSegments(s.editor().document()),
                                       [](Segment &segment) { segment.diffusion = 3; }),
                        "change");
        for (std::size_t k = 0; k < before.segments.size(); ++k)
            QCOMPARE(s.stroke().segments[k].diffusion, before.segments[k].lift ? before.segments[k].diffusion : 3.0f);
    }

    void erasuresAreShownWhenWanted()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Pan);
        const auto shown = [&] {
            while (!s.canvas().isUpToDate())
                QTest::qWait(5);
            return s.canvas().grab().toImage();
        };
        const QImage bare = shown();
        s.use(Command::ShowErasures);
        const QImage lines = shown();
        QVERIFY(lines != bare);
        s.use(Command::ShowErasures);
        QCOMPARE(shown(), bare);
        s.editor().document().setSelection({{s.id}, {}});
        const QImage outlined = shown();
        s.use(Command::ShowErasures);
        QVERIFY(shown() != outlined);
        s.use(Command::ShowErasures);
        QCOMPARE(shown(), outlined);
        // Those of a stroke that is not selected are shown, too; only their lines are paler.
        s.editor().document().setSelection({{s.other}, {}});
        const QImage others = shown();
        s.use(Command::ShowErasures);
        QVERIFY(shown() != others);
        s.use(Command::ShowOutlines);
        QVERIFY(shown() != lines);
        s.editor().document().setSelection({});
        QCOMPARE(shown(), lines);
        s.use(Command::ShowOutlines);
        s.use(Command::ShowErasures);
    }

    /// What is not begun has no line, as it has no outline.
    void erasuresThatAreNotBegunAreNotShown()
    {
        EraserSession s;
        s.erase({350, 250}, {350, 390});
        s.dry();
        s.use(Command::Pan);
        const auto shown = [&] {
            while (!s.canvas().isUpToDate())
                QTest::qWait(5);
            return s.canvas().grab().toImage();
        };
        const Microseconds born = s.stroke().segments.back().born;
        QVERIFY(s.stroke().segments.back().lift && born > 0);
        s.editor().clock().setTime(0);
        const QImage bare = shown();
        s.use(Command::ShowErasures);
        QCOMPARE(shown(), bare);
        s.editor().clock().setTime(born);
        const QImage lines = shown();
        s.use(Command::ShowErasures);
        QVERIFY(shown() != lines);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestErasures)
#include "test_erasures.moc"

// Bands, lassos and touch paths: what they take of strokes, groups and layers.
#include "app/session/current_layer.h"
#include "app/session/selecting/pick.h"
#include "app/session/settings/settings.h"
#include "tests/app/selecting.h"

#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

class TestBands : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        QVERIFY(m_folder.isValid());
    }

    void init() { settings::store().clear(); }

    void bandsAddAndTakeAway()
    {
        Selecting s(
            {line(1, {200, 200}, {400, 200}), line(2, {200, 300}, {400, 300}), line(3, {200, 400}, {400, 400})});
        s.drag({{150, 150}, {450, 250}});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.drag({{380, 405}, {150, 260}, {450, 260}}, shift); // from paint; the corner is what counts at the end
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.drag({{150, 260}, {450, 450}}, shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
        s.drag({{150, 350}, {450, 250}}, shift | ctrl);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 3}));
        QCOMPARE(s.steps(), 0);
    }

    void shiftDragFromPaintIsABand()
    {
        Selecting s({line(1, {200, 200}, {600, 200}), line(2, {300, 300}, {500, 300})});
        s.select({1});
        s.drag({{250, 202}, {550, 400}}, shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        QCOMPARE(s.box(1).left, 200.0);
        QCOMPARE(s.steps(), 0);
    }

    void lassoTakesWhatItGoesAround()
    {
        Selecting s(
            {line(1, {200, 200}, {260, 200}), line(2, {500, 200}, {560, 200}), line(3, {350, 450}, {400, 450})});
        s.use(Command::Lasso);
        const std::vector<Point> around{{170, 150}, {290, 150}, {290, 350}, {470, 350}, {470, 150},
                                        {590, 150}, {590, 380}, {170, 380}, {170, 160}};
        s.drag(around);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.drag({{480, 150}, {580, 150}, {580, 250}, {480, 250}}, shift | ctrl);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.use(Command::Lasso); // off again
        s.drag({{150, 140}, {610, 400}});
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.use(Command::TouchPath);
        QVERIFY(!s.window.action(Command::Lasso).isChecked());
        s.drag({{375, 400}, {376, 500}});
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
    }

    /// Where paint covers all of the canvas no press is on empty paper, and a drag moves what lies there. With Shift
    /// the lasso begins on paint, and after Esc what it goes around is all that is selected.
    void lassoBeginsOnPaintWithShift()
    {
        Selecting s(
            {line(1, {-100, 250}, {900, 250}), line(2, {300, 250}, {360, 250}), line(3, {500, 250}, {560, 250})});
        auto ground = std::make_shared<Stroke>(s.stroke(1));
        for (Segment &segment : ground->segments) {
            segment.diffusion = 10'000;
            segment.density = 1000;
        }
        auto covered = std::make_shared<Painting>(s.painting());
        covered->strokes = {ground, covered->find(2), covered->find(3)};
        s.editor().document().reset(covered);
        s.editor().clock().setTime(s.painting().end());
        s.use(Command::Lasso);
        const std::vector<Point> around{{270, 220}, {390, 220}, {390, 280}, {270, 280}, {270, 225}};
        QVERIFY(pickTopmost(s.painting(), s.painting().end(), around.front(), 1));
        s.select({3});
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        s.drag(around, shift);
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        QCOMPARE(s.steps(), 0); // nothing was moved
    }

    void touchPathSelectsVisiblePaint()
    {
        Selecting s(
            {line(1, {200, 200}, {600, 200}), line(2, {200, 300}, {600, 300}), line(3, {200, 500}, {600, 500})});
        s.drag({{400, 150}, {420, 350}}, alt);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.drag({{300, 508}, {320, 508}}, alt); // beside the curve, on the paint
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        s.drag({{300, 400}, {320, 400}}, alt);
        QVERIFY(s.selected().empty());
        s.drag({{400, 150}, {400, 250}}, alt | shift);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        QCOMPARE(s.steps(), 0);
    }

    void lockedAndHiddenStrokesAreNotSelected()
    {
        auto locked = std::make_shared<Stroke>(*line(2, {200, 200}, {600, 200}));
        locked->locked = true;
        auto hidden = std::make_shared<Stroke>(*line(3, {200, 200}, {600, 200}));
        hidden->visible = false;
        Selecting s({line(1, {200, 200}, {600, 200}), locked, hidden});
        s.click({400, 200});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.drag({{400, 100}, {400, 300}}, alt);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.use(Command::InvertSelection);
        QVERIFY(s.selected().empty());
        s.use(Command::InvertSelection);
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
    }

    /// As a click, a band means groups as wholes: those that it goes around, which is all that is seen of them.
    void bandsTakeWholeGroups()
    {
        Selecting s({line(1, {200, 200}, {400, 200}), line(2, {200, 300}, {400, 300}), line(3, {200, 400}, {400, 400}),
                     line(4, {500, 300}, {600, 300})});
        const std::set<StrokeId> group{1, 2, 3};
        s.select(group);
        s.use(Command::GroupStrokes);
        const std::vector<Point> aroundTwo{{150, 150}, {450, 350}}, aroundAll{{150, 150}, {450, 450}},
            aroundFour{{150, 250}, {650, 350}};
        s.click({50, 50});
        s.drag(aroundTwo);
        QVERIFY(s.selected().empty());
        s.drag(aroundFour);
        QCOMPARE(s.selected(), std::set<StrokeId>{4});
        s.drag(aroundAll, shift);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3, 4}));
        s.drag(aroundTwo, shift | ctrl);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3, 4}));
        s.drag(aroundAll, shift | ctrl);
        QCOMPARE(s.selected(), std::set<StrokeId>{4});
        s.drag(aroundTwo, ctrl);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.click({50, 50});
        s.drag({{300, 150}, {300, 250}}, alt);
        QCOMPARE(s.selected(), group);
        s.use(Command::Lasso);
        s.drag({{150, 150}, {450, 150}, {450, 350}, {150, 350}, {150, 155}});
        QVERIFY(s.selected().empty());
        s.drag({{150, 150}, {450, 150}, {450, 450}, {150, 450}, {150, 155}});
        QCOMPARE(s.selected(), group);
        s.use(Command::Lasso);
        // What is hidden or locked does not count, as for a click.
        for (const bool locks : {false, true}) {
            Stroke changed = s.stroke(3);
            changed.visible = locks;
            changed.locked = locks;
            Edit edit;
            edit.strokes.emplace(3, std::make_shared<const Stroke>(changed));
            s.editor().push(std::move(edit), "one less");
            s.select({});
            s.drag(aroundTwo);
            QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        }
    }

    /// A double click goes into a group. Groups within it are wholes there.
    void bandsWithinAGroup()
    {
        Selecting s({line(1, {200, 200}, {400, 200}), line(2, {200, 300}, {400, 300}), line(3, {200, 400}, {400, 400}),
                     line(4, {200, 500}, {400, 500})});
        s.select({3, 4});
        s.use(Command::GroupStrokes);
        s.select({1, 2, 3, 4});
        s.use(Command::GroupStrokes);
        const std::vector<Point> aroundThree{{150, 150}, {450, 450}}, aroundAll{{150, 150}, {450, 550}};
        s.click({50, 50});
        s.drag(aroundThree);
        QVERIFY(s.selected().empty());
        const auto goInto = [&s](Point at) {
            s.click(at);
            s.send(QEvent::MouseButtonDblClick, s.logical(s.canvas().view().toPixels(at)), none);
            s.send(QEvent::MouseButtonRelease, s.logical(s.canvas().view().toPixels(at)), none);
        };
        goInto({300, 200});
        QCOMPARE(s.selected(), std::set<StrokeId>{1});
        s.drag(aroundThree);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2}));
        s.drag(aroundAll);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3, 4}));
        s.drag(aroundThree);
        QVERIFY(s.selected().empty());
        goInto({300, 400});
        QCOMPARE(s.selected(), std::set<StrokeId>{3});
        s.drag(aroundThree);
        QCOMPARE(s.selected(), (std::set<StrokeId>{1, 2, 3}));
    }

    /// With "This Layer Only" tools leave what is elsewhere alone, say so, and take what is in the layer one by one.
    void onlyTheLayerIsReached()
    {
        StrokeList strokes;
        for (int i = 1; i <= 4; ++i) {
            Stroke stroke = *line(StrokeId(i), {100, 100.0 * i}, {300, 100.0 * i});
            stroke.group = i == 2 || i == 3 ? 1 : 0;
            strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
        }
        Selecting s(std::move(strokes));
        auto painting = std::make_shared<Painting>(s.painting());
        Group group;
        group.id = 1;
        painting->groups = {group};
        s.editor().document().reset(painting);
        s.editor().clock().setTime(painting->end());
        CurrentLayer &layer = s.editor().layer();
        QSignalSpy noted(&layer, &CurrentLayer::noted);
        layer.choose(1);
        s.use(Command::ThisLayerOnly);
        noted.clear();
        const auto turnBack = qScopeGuard([&s] { s.use(Command::ThisLayerOnly); });

        s.click({200, 100});
        QVERIFY(s.selected().empty());
        QCOMPARE(int(noted.count()), 1);
        s.click({200, 250});
        QCOMPARE(int(noted.count()), 1); // There is nothing at all.
        s.click({200, 200});
        QCOMPARE(s.selected(), std::set<StrokeId>{2});
        s.drag({{50, 50}, {350, 450}});
        QCOMPARE(s.selected(), (std::set<StrokeId>{2, 3}));
        s.select({});
        QCOMPARE(int(noted.count()), 1);

        s.use(Command::Knife);
        s.drag({{170, 50}, {170, 450}});
        for (const StrokeId id : {1, 2, 3, 4})
            QCOMPARE(nodeCount(*s.painting().find(id)) > nodeCount(*painting->find(id)), id == 2 || id == 3);
        s.use(Command::Undo);
        const int steps = s.steps();
        s.drag({{170, 50}, {170, 150}});
        QCOMPARE(int(noted.count()), 2);
        for (const Command tool : {Command::Eraser, Command::Push, Command::Redraw}) {
            s.use(tool);
            s.drag({{150, 100}, {200, 102}, {250, 100}});
            QVERIFY2(*s.editor().document().painting() == *painting, qPrintable(QString::number(int(tool))));
        }
        QCOMPARE(int(noted.count()), 5);
        QCOMPARE(s.steps(), steps);
        s.use(Command::Select);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBands)
#include "test_bands.moc"

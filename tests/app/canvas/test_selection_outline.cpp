// The outlines of the selected strokes: thinned out where they are many, apart where they move.
#include "app/canvas/overlay/selection_outline.h"
#include "app/session/selecting/pick.h"
#include "model/brush/brush.h"
#include "model/brush/stroke_fit.h"
#include "model/shaping/shapes.h"
#include "tests/app/selecting.h"
#include "undo/transform_edits.h"

#include <QTest>

#include <random>

using namespace suffuse;

class TestSelectionOutline : public QObject {
    Q_OBJECT

private slots:
    void theOutlineThinsOutAndLeavesOutWhatIsNotSeen()
    {
        Painting painting;
        for (int i = 0; i < 2000; ++i)
            painting.strokes.push_back(line(StrokeId(i + 1), {5.0 * (i % 100), 20.0 * (i / 100)},
                                            {5.0 * (i % 100) + 4, 20.0 * (i / 100) + 15}));
        Selection all{selectableStrokes(painting, painting.end()), {}};
        const OverlayColours colours{Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta};
        SelectionOutline outline;
        const auto draw = [&](const View &view, const Selection &selection) {
            QImage image(view.width, view.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            outline.paint(painter, view, painting, selection, colours, 1);
            painter.end();
            return image;
        };
        const auto marked = [](const QImage &image) {
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += image.pixel(x, y) != qRgb(255, 255, 255);
            return count;
        };
        const View whole = View::ofArea(Rect::of(0, 0, 500, 400), 500, 400);
        const QImage first = draw(whole, all);
        QVERIFY(outline.isThin());
        QVERIFY(marked(first) > 10'000);
        QCOMPARE(draw(whole, all), first); // from the picture that was kept
        const QImage one = draw(whole, Selection{{1}, {}});
        QVERIFY(!outline.isThin());
        QVERIFY(marked(one) > 20 && marked(one) < 400);
        const View close = View::ofArea(Rect::of(0, 0, 25, 20), 500, 400);
        QVERIFY(marked(draw(close, all)) > 1000); // a few strokes, drawn finely
        QVERIFY(!outline.isThin());
        const View beside = View::ofArea(Rect::of(2000, 0, 500, 400), 500, 400);
        QCOMPARE(marked(draw(beside, all)), 0);
        painting.strokes[0] = line(1, {300, 0}, {310, 390});
        QVERIFY(draw(whole, Selection{{1}, {}}) != one);
    }

    /// Few segments may be long, and crowd what lies below as many do: the rings of a gradient, and what was scribbled.
    void longLinesThinOutToo()
    {
        const auto circle = [](StrokeId id, double radius) {
            return strokeAlong(
                outlineOf({.kind = ShapeKind::Ellipse}, {250 - radius, 200 - radius}, {250 + radius, 200 + radius}),
                builtinBrushes().front(), id, 0);
        };
        Painting painting;
        std::size_t segments = 0;
        for (int i = 0; i < 130; ++i) {
            painting.strokes.push_back(std::make_shared<const Stroke>(circle(StrokeId(i + 1), 20 + i)));
            segments += painting.strokes[std::size_t(i)]->segments.size();
        }
        QVERIFY(segments <= 600);
        const OverlayColours colours{Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta};
        SelectionOutline outline;
        const auto isThin = [&](const View &view, const Selection &selection) {
            QImage image(view.width, view.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            outline.paint(painter, view, painting, selection, colours, 1);
            return outline.isThin();
        };
        const View whole = View::ofArea(Rect::of(0, 0, 500, 400), 1000, 800);
        const Selection all{selectableStrokes(painting, painting.end()), {}};
        QCOMPARE(all.strokes.size(), std::size_t(130));
        QVERIFY(isThin(whole, all));
        QVERIFY(!isThin(whole, Selection{{1, 60, 130}, {}}));
        QVERIFY(!isThin(View::ofArea(Rect::of(0, 0, 4000, 3200), 1000, 800), all)); // from afar they are short
        // A line that is long only beyond the view is none that crowds it.
        QVERIFY(!isThin(View::ofArea(Rect::of(398, 199, 1, 1), 1000, 1000), Selection{{130}, {}}));
    }

    void whatMovesAmongManyIsOutlinedApart()
    {
        Painting painting;
        for (int i = 0; i < 800; ++i)
            painting.strokes.push_back(
                line(StrokeId(i + 1), {10.0 * (i % 40), 20.0 * (i / 40)}, {10.0 * (i % 40) + 8, 20.0 * (i / 40) + 15}));
        const Selection all{selectableStrokes(painting, painting.end()), {}};
        const OverlayColours colours{Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta};
        const View view = View::ofArea(Rect::of(0, 0, 500, 400), 500, 400);
        const auto draw = [&](SelectionOutline &outline, bool moving) {
            QImage image(view.width, view.height, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::white);
            QPainter painter(&image);
            outline.paint(painter, view, painting, all, colours, 1, moving);
            return image;
        };
        const auto inks = [](const QImage &image, QRect where) {
            int count = 0;
            for (int y = where.top(); y <= where.bottom(); ++y)
                for (int x = where.left(); x <= where.right(); ++x)
                    count += image.pixel(x, y) != qRgb(255, 255, 255);
            return count;
        };
        SelectionOutline outline;
        const QImage first = draw(outline, false);
        QVERIFY(outline.isThin());
        const QRect home(0, 0, 9, 16), away(420, 100, 60, 200); // right of the others
        QVERIFY(inks(first, home) > 10);
        QCOMPARE(inks(first, away), 0);
        for (int step = 0; step < 3; ++step) {
            painting.strokes[0] = line(1, {430, 110.0 + 60 * step}, {470, 130.0 + 60 * step});
            const QImage moving = draw(outline, true);
            QCOMPARE(inks(moving, home), 0);
            QVERIFY(inks(moving, away) > 20 && inks(moving, away) < 90); // where it is, not where it was
            QVERIFY(inks(moving, QRect(0, 0, 420, 400)) > inks(first, QRect(0, 0, 420, 400)) / 2);
        }
        SelectionOutline fresh;
        QCOMPARE(draw(outline, false), draw(fresh, false)); // once it rests
    }

    /// Where strokes come, go and change while all are moving, the outline is that of those that are there.
    void whatComesAndGoesAmongManyIsOutlined()
    {
        Painting painting;
        for (int i = 0; i < 800; ++i)
            painting.strokes.push_back(line(StrokeId(i + 1), {10.0 * (i % 40), 20.0 * (i / 40)},
                                            {10.0 * (i % 40) + 18, 20.0 * (i / 40) + 35}));
        const View view = View::ofArea(Rect::of(0, 0, 500, 460), 500, 460);
        const auto draw = [&](SelectionOutline &outline, bool moving) {
            QImage image(view.width, view.height, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            const Selection all{selectableStrokes(painting, painting.end()), {}};
            outline.paint(painter, view, painting, all,
                          {Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta}, 1, moving);
            return image;
        };
        SelectionOutline kept;
        draw(kept, false);
        QVERIFY(kept.isThin());
        std::mt19937 random(3);
        StrokeId next = 2000;
        for (int step = 0; step < 40; ++step) {
            for (int i = 0; i < 4; ++i) {
                const auto at = painting.strokes.begin() + std::ptrdiff_t(random() % painting.strokes.size());
                const Stroke whole = **at;
                const Point start = Point{} + whole.segments.front().bezier[0], by{6.0 + i, 11};
                *at = line(whole.id, start, start + by);
                if (i % 2 == 0)
                    painting.strokes.insert(at + 1, line(next++, start + 2 * by, start + 3 * by));
                painting.strokes.erase(painting.strokes.begin() + std::ptrdiff_t(random() % painting.strokes.size()));
            }
            SelectionOutline fresh;
            QCOMPARE(draw(kept, true), draw(fresh, true));
        }
        SelectionOutline fresh;
        QCOMPARE(draw(kept, false), draw(fresh, false)); // once it rests
    }

    void boxesFollowTheStrokes()
    {
        std::mt19937 random(5);
        Painting painting;
        for (int i = 0; i < 200; ++i)
            painting.strokes.push_back(line(StrokeId(i + 1), {10.0 * i, 3.0 * i}, {10.0 * i + 8, 20}));
        SelectionOutline outline;
        for (int step = 0; step < 200; ++step) {
            const std::size_t n = painting.strokes.size(), place = random() % n, other = random() % n;
            const Point at{double(random() % 1000), double(random() % 1000)};
            const auto where = std::as_const(painting.strokes).begin() + std::ptrdiff_t(place);
            switch (step % 4) {
            case 0:
                painting.strokes.erase(where);
                break;
            case 1:
                painting.strokes.insert(where, line(StrokeId(1000 + step), at, at + Point{5, 7}));
                break;
            case 2:
                painting.strokes[place] = line(std::as_const(painting.strokes)[place]->id, at, at + Point{-9, 3});
                break;
            default:
                std::swap(painting.strokes[place], painting.strokes[other]);
                break;
            }
            Selection some;
            Rect box;
            for (const StrokePtr &stroke : std::as_const(painting.strokes))
                if (stroke->id % 5 == StrokeId(step / 20) % 5) {
                    some.strokes.insert(stroke->id);
                    for (const Segment &segment : stroke->segments)
                        box = box.united(stroke->cubicOf(segment).controlBox());
                }
            QCOMPARE(outline.boxOf(painting, some), box);
            QCOMPARE(outline.curveBoxOf(painting, some), selectionBox(painting, some));
        }
    }

    void lockedStrokesAreNotTransformed()
    {
        Painting painting;
        painting.strokes.push_back(line(1, {10, 10}, {50, 60}));
        Stroke locked = *line(2, {100, 10}, {150, 90});
        locked.locked = true;
        painting.strokes.push_back(std::make_shared<const Stroke>(locked));
        SelectionOutline outline;
        QCOMPARE(outline.curveBoxOf(painting, {{1, 2}, {}}), Rect::of(10, 10, 40, 50));
        QVERIFY(outline.curveBoxOf(painting, {{2}, {}}).isEmpty());
    }

    void whatIsKeptLooksLikeWhatIsNew_data()
    {
        QTest::addColumn<double>("dpr");
        QTest::newRow("scale 1") << 1.0;
        QTest::newRow("scale 2") << 2.0;
    }

    void whatIsKeptLooksLikeWhatIsNew()
    {
        QFETCH(double, dpr);
        Painting painting;
        for (int i = 0; i < 800; ++i)
            painting.strokes.push_back(line(StrokeId(i + 1), {100 + 8.0 * (i % 40), 100 + 12.0 * (i / 40)},
                                            {100 + 8.0 * (i % 40) + 7, 100 + 12.0 * (i / 40) + 9}));
        SelectionOutline kept;
        View view = View::ofArea(Rect::of(0, 0, 512, 448), int(512 * dpr), int(448 * dpr));
        const auto draw = [&](SelectionOutline &outline, const Selection &selection, const QColor &accent,
                              const QRegion &clip) {
            QImage image(view.width, view.height, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            if (!clip.isEmpty())
                painter.setClipRegion(clip);
            outline.paint(painter, view, painting, selection, {Qt::gray, Qt::black, accent, Qt::green, Qt::magenta},
                          dpr);
            return image;
        };
        const auto isSame = [&](const Selection &selection, const QColor &accent = QColor(20, 110, 230),
                                const QRegion &clip = {}) {
            SelectionOutline fresh;
            const QImage expected = draw(fresh, selection, accent, clip);
            return draw(kept, selection, accent, clip) == expected && (selection.isEmpty() || fresh.isThin());
        };
        const Selection all{selectableStrokes(painting, painting.end()), {}};
        QVERIFY(isSame(all));
        QVERIFY(isSame({}));
        QVERIFY(isSame(all));
        QVERIFY(isSame(all, Qt::red));
        QVERIFY(isSame(all, Qt::red, QRegion(33, 41, 200, 100) + QRegion(70, 120, 301, 77)));
        const Point home = view.centre;
        for (const Point by : {Point{30, 17}, Point{-90, 5}, Point{0, -120}, Point{400, 0}}) {
            view.centre = home + by;
            QVERIFY(isSame(all));
        }
        view.centre = home;
        view.scale *= 1.25;
        QVERIFY(isSame(all));
        view.rotation = 0.4;
        view.mirrored = true;
        QVERIFY(isSame(all));
        QVERIFY(isSame({}));
        const StrokeList before = painting.strokes;
        painting.strokes[7] = line(8, {300, 300}, {340, 180});
        QVERIFY(isSame(all));
        QVERIFY(isSame({}));
        painting.strokes = before; // undone while nothing was selected
        QVERIFY(isSame(all));
        Selection some = all;
        for (StrokeId id = 1; id <= 50; ++id)
            some.strokes.erase(id);
        QVERIFY(isSame(some));
        painting.strokes.erase(std::as_const(painting.strokes).begin());
        QVERIFY(isSame(some));
        QVERIFY(isSame(all)); // the first is not there any more
        painting.strokes = before;
        QVERIFY(isSame(all));
    }

    /// Also where a stroke has more segments than are drawn finely, at rest and while it is dragged.
    void chosenSegmentsStandOut_data()
    {
        QTest::addColumn<int>("segments");
        QTest::addColumn<bool>("moving");
        QTest::addColumn<double>("dpr");
        for (const int segments : {100, 400, 900, 4000})
            for (const bool moving : {false, true})
                for (const double dpr : {1.0, 2.0})
                    QTest::addRow("%d%s, scale %g", segments, moving ? " moving" : "", dpr)
                        << segments << moving << dpr;
    }

    void chosenSegmentsStandOut()
    {
        QFETCH(int, segments);
        QFETCH(bool, moving);
        QFETCH(double, dpr);
        Painting painting;
        painting.strokes.push_back(line(1, {0, 50}, {400, 50}, segments));
        const View view = View::ofArea(Rect::of(0, 0, 400, 100), int(400 * dpr), int(100 * dpr));
        const auto draw = [&](SelectionOutline &outline, const Selection &selection, const QColor &paper) {
            QImage image(view.width, view.height, QImage::Format_RGB32);
            image.fill(paper);
            QPainter painter(&image);
            outline.paint(painter, view, painting, selection,
                          {Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta}, dpr, moving);
            return image;
        };
        // How thick the line is on average, in colours that differ from the paper by a fifth of all there is.
        const auto thickness = [&](const QImage &image, double from, const QColor &paper) {
            constexpr int columns = 40;
            int sum = 0;
            for (int x = int(from * dpr); x < int(from * dpr) + columns; ++x) {
                int first = 0, last = -1;
                for (int y = 0; y < image.height(); ++y) {
                    const QRgb p = image.pixel(x, y);
                    if (std::abs(qRed(p) - paper.red()) + std::abs(qGreen(p) - paper.green()) +
                            std::abs(qBlue(p) - paper.blue()) >
                        153)
                        first = last < 0 ? y : first, last = y;
                }
                sum += last < 0 ? 0 : last - first + 1;
            }
            return sum / (columns * dpr);
        };
        Selection some{{1}, {}};
        for (int k = segments / 4; k < segments / 2; ++k)
            some.segments.insert({1, k});
        SelectionOutline outline;
        for (const QColor &paper : {QColor(Qt::white), QColor(Qt::black), QColor(20, 110, 230), QColor(59, 36, 25)}) {
            const QImage image = draw(outline, some, paper);
            const double chosen = thickness(image, 130, paper), other = thickness(image, 280, paper);
            QVERIFY2(chosen >= 1.5 && chosen >= other + 1, qPrintable(QString("%1 %2").arg(chosen).arg(other)));
        }
        const QImage first = draw(outline, some, Qt::white);
        Selection others{{1}, {}};
        for (int k = 3 * segments / 4; k < segments; ++k)
            others.segments.insert({1, k});
        SelectionOutline fresh, again;
        QCOMPARE(draw(outline, others, Qt::white), draw(fresh, others, Qt::white));
        QCOMPARE(draw(outline, some, Qt::white), first);
        painting.strokes[0] = line(1, {0, 20}, {400, 80}, segments);
        const QImage moved = draw(outline, some, Qt::white);
        QVERIFY(moved != first);
        if (!moving)
            QCOMPARE(moved, draw(again, some, Qt::white));
    }

    /// Where lines lie close together they are faint, so that the paint can be judged; they are seen on any.
    void linesThatLieCloseTogetherAreFainter()
    {
        const View view = View::ofArea(Rect::of(0, 0, 400, 400), 400, 400);
        const auto meanChange = [&](int strokes, const QColor &paper) {
            Painting painting;
            for (int i = 0; i < strokes; ++i)
                painting.strokes.push_back(line(StrokeId(i + 1), {10, 10 + 380.0 * i / strokes},
                                                {390, 10 + 380.0 * i / strokes}, 1200 / strokes));
            SelectionOutline outline;
            QImage image(400, 400, QImage::Format_RGB32);
            image.fill(paper);
            QPainter painter(&image);
            const Selection all{selectableStrokes(painting, painting.end()), {}};
            outline.paint(painter, view, painting, all,
                          {Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta}, 1);
            double sum = 0, most = 0;
            for (int y = 0; y < 400; ++y)
                for (int x = 0; x < 400; ++x) {
                    const QRgb p = image.pixel(x, y);
                    const double by = std::abs(qRed(p) - paper.red()) + std::abs(qGreen(p) - paper.green()) +
                                      std::abs(qBlue(p) - paper.blue());
                    sum += by;
                    most = std::max(most, by);
                }
            return std::pair(sum / (400.0 * 400 * 765), most / 765);
        };
        for (const QColor &paper : {QColor(Qt::white), QColor(Qt::black), QColor(20, 110, 230), QColor(Qt::gray)}) {
            const auto [few, fewMost] = meanChange(6, paper);
            const auto [many, manyMost] = meanChange(100, paper);
            QVERIFY2(many < 0.1, qPrintable(QString::number(many)));
            QVERIFY(manyMost < fewMost);
            QVERIFY2(manyMost > 0.05, qPrintable(QString::number(manyMost)));
        }
    }

    /// A few strokes are drawn finely. Where their lines lie closer than they are wide, the paint is seen through them;
    /// one that lies apart is as strong as it is alone.
    void fewLinesThatLieCloseTogetherAreFainter()
    {
        const View view = View::ofArea(Rect::of(0, 0, 400, 400), 400, 400);
        Painting painting;
        painting.strokes.push_back(line(1, {50, 300}, {350, 300}));
        for (int i = 0; i < 80; ++i) // half a pixel apart
            painting.strokes.push_back(line(StrokeId(i + 2), {100, 100 + 0.5 * i}, {300, 100 + 0.5 * i}));
        const auto change = [&](const Selection &selection, const QRect &where, const QColor &paper) {
            SelectionOutline outline;
            QImage image(400, 400, QImage::Format_RGB32);
            image.fill(paper);
            QPainter painter(&image);
            outline.paint(painter, view, painting, selection,
                          {Qt::gray, Qt::black, QColor(20, 110, 230), Qt::green, Qt::magenta}, 1);
            painter.end();
            double sum = 0;
            for (int y = where.top(); y <= where.bottom(); ++y)
                for (int x = where.left(); x <= where.right(); ++x) {
                    const QRgb p = image.pixel(x, y);
                    sum += std::abs(qRed(p) - paper.red()) + std::abs(qGreen(p) - paper.green()) +
                           std::abs(qBlue(p) - paper.blue());
                }
            return sum / (double(where.width()) * where.height() * 765);
        };
        const Selection all{selectableStrokes(painting, painting.end()), {}}, alone{{1}, {}};
        const QRect crowd(110, 105, 180, 30), apart(60, 297, 280, 7);
        for (const QColor &paper : {QColor(Qt::white), QColor(Qt::black), QColor(200, 60, 30)}) {
            const double covered = change(all, crowd, paper);
            QVERIFY2(covered > 0.02 && covered < 0.3, qPrintable(QString::number(covered)));
            QVERIFY(change(alone, apart, paper) > 0.05);
            QCOMPARE(change(all, apart, paper), change(alone, apart, paper));
        }
    }

    void aMaskIsPaintedTurned()
    {
        PixelMask mask;
        mask.clear(200, 150);
        std::mt19937 random(2);
        for (int i = 0; i < 5000; ++i)
            mask.set(int(random() % 200), int(random() % 150));
        const QRect part(3, 5, 190, 140);
        const auto draw = [&](const QTransform &way) {
            QImage image(200, 200, QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            painter.setTransform(way);
            mask.paint(painter, {0, 0}, part, {{QColor(10, 20, 30, 100), 0}});
            return image;
        };
        const QImage upright = draw({});
        QVERIFY(upright.pixel(0, 0) == qRgb(255, 255, 255));
        const QImage turned = draw(QTransform(0, 1, -1, 0, 200, 0)); // by a quarter
        QCOMPARE(turned, upright.transformed(QTransform(0, 1, -1, 0, 0, 0)));
        mask.clear(200, 150);
        QImage white(200, 200, QImage::Format_RGB32);
        white.fill(Qt::white);
        QCOMPARE(draw({}), white);
        QCOMPARE(draw(QTransform(0, 1, -1, 0, 200, 0)), white);
    }
};

QTEST_MAIN(TestSelectionOutline)
#include "test_selection_outline.moc"

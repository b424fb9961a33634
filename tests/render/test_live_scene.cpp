// A scene that follows a painting: it holds what a fresh one would, and prepares anew only what differs.
#include "tests/render/paintings.h"

#include "render/nodes/blocks.h"
#include "render/scene/live_scene.h"

using namespace suffuse;
using namespace suffuse::test;

class TestLiveScene : public QObject {
    Q_OBJECT

    const View m_view = View::ofArea(Rect::of(0, 0, 200, 150), 200, 150);

    static bool sameNodes(const StrokeNodes &a, const StrokeNodes &b)
    {
        const auto sameGroup = [](const NodeGroup &g, const NodeGroup &h) {
            return g.begin == h.begin && g.end == h.end && g.row == h.row && g.rowPerNode == h.rowPerNode &&
                   g.reachBegin == h.reachBegin && g.reachEnd == h.reachEnd;
        };
        return a.nodes == b.nodes && a.rows == b.rows && a.reaches == b.reaches && a.clipped == b.clipped &&
               std::ranges::equal(a.groups, b.groups, sameGroup);
    }

    static bool sameScene(const LiveScene &a, const LiveScene &b)
    {
        const auto sameStroke = [](const SceneStrokePtr &s, const SceneStrokePtr &t) {
            return s->stroke == t->stroke && s->bounds == t->bounds && s->values == t->values &&
                   sameNodes(*s->source, *t->source);
        };
        return std::ranges::equal(a.strokes(), b.strokes(), sameStroke) && a.bounds() == b.bounds() &&
               a.nodeCount() == b.nodeCount();
    }

    static SceneChange update(LiveScene &scene, const RenderRequest &request, int threads)
    {
        return scene.update(request, PictureGrid::ofDocument(request.view), threads);
    }

    /// `segments` of a wandering stroke, a sample each 16 ms.
    static Stroke longStroke(int segments)
    {
        Stroke s;
        s.id = 1;
        const auto at = [](int k) {
            return Offset{float(100 + 80 * std::cos(0.05 * k)), float(75 + 60 * std::sin(0.11 * k))};
        };
        for (int k = 0; k < segments; ++k) {
            Segment g;
            for (int i = 0; i < 4; ++i)
                g.bezier[std::size_t(i)] = {at(k).x + float(i) / 3 * (at(k + 1).x - at(k).x),
                                            at(k).y + float(i) / 3 * (at(k + 1).y - at(k).y)};
            g.maxAge = 0.4f;
            g.born = k * 16000;
            s.segments.push_back(g);
        }
        return s;
    }

    /// The last firm border up to a segment.
    static std::size_t lastFirm(const Stroke &stroke, std::size_t segment)
    {
        const std::vector<std::size_t> firm = blocksOf(stroke).firm;
        return *(std::ranges::upper_bound(firm, segment) - 1);
    }

private slots:
    /// A boundary that takes long gives way to a newer picture, and is searched for again with that.
    void whatWasStoppedComesWithTheNextUpdate()
    {
        const PictureGrid grid = PictureGrid::ofDocument(m_view);
        Stroke s = longStroke(200);
        Fill fill;
        fill.density = 1, fill.maxAge = 0.4f;
        s.fill = fill;
        const std::atomic<bool> stop = true, goOn = false;
        LiveScene live;
        for (int turn = 0; turn < 3; ++turn) {
            s.segments[0].bezier[1].x += float(turn);
            RenderRequest request;
            request.painting = painting({s}, 200, 150);
            request.time = 10'000'000;
            request.view = m_view;
            live.update(request, grid, 1, &stop);
            QVERIFY(live.strokes()[0]->outside && !live.strokes()[0]->fill);
            if (turn == 2)
                live.update(request, grid, 1, &stop);
            const SceneChange change = live.update(request, grid, 1, &goOn);
            QCOMPARE(change.replaced.size(), std::size_t(1));
            LiveScene fresh;
            update(fresh, request, 1);
            QVERIFY(sameScene(live, fresh));
            QVERIFY(live.strokes()[0]->fill->panels == fresh.strokes()[0]->fill->panels);
            QVERIFY(!live.strokes()[0]->fill->panels.empty());
        }
    }

    void followsAnyHistory()
    {
        std::mt19937_64 random(41);
        auto p = painting(randomStrokes(random, 100, 200, 150), 200, 150);
        LiveScene live;
        View view = m_view;
        for (int step = 0; step < 80; ++step) {
            auto q = std::make_shared<Painting>(*p);
            const std::size_t at = random() % q->strokes.size();
            Stroke s = *std::as_const(*q).strokes[at];
            switch (random() % 7) {
            case 0:
                s.visible = !s.visible;
                break;
            case 1:
                s.group = 1 - s.group;
                break;
            case 2:
                q->strokes.erase(q->strokes.begin() + std::ptrdiff_t(at));
                break;
            case 3:
                view.scale *= 1.3;
                break;
            case 4:
                q->groups = {{1, {}, 0, random() % 2 == 0, false}};
                break;
            default:
                s.segments.front().density *= 1.1f;
                break;
            }
            if (at < q->strokes.size() && std::as_const(*q).strokes[at]->id == s.id)
                q->strokes[at] = std::make_shared<const Stroke>(s);
            p = q;
            const Microseconds time = random() % 2 ? p->end() : Microseconds(random() % 1'000'000);
            const RenderRequest request{p, time, view};
            update(live, request, 2);
            LiveScene fresh;
            update(fresh, request, 2);
            QVERIFY2(sameScene(live, fresh), qPrintable(QStringLiteral("step %1").arg(step)));
        }
    }

    void preparesWhatDiffers()
    {
        std::mt19937_64 random(43);
        const auto p = painting(randomStrokes(random, 200, 200, 150), 200, 150);
        LiveScene live;
        update(live, {p, p->end(), m_view}, 1);
        const auto before = live.strokes();
        auto q = std::make_shared<Painting>(*p);
        for (const std::size_t i : {std::size_t(150), std::size_t(7)}) {
            Stroke s = *std::as_const(*q).strokes[i];
            s.segments.front().density *= 2;
            q->strokes[i] = std::make_shared<const Stroke>(s);
        }
        const SceneChange change = update(live, {q, q->end(), m_view}, 1);
        QVERIFY(!change.reordered);
        QCOMPARE(change.replaced.size(), std::size_t(2));
        QCOMPARE(change.replaced[0].index, std::size_t(7));
        QCOMPARE(change.replaced[1].index, std::size_t(150));
        QVERIFY(change.replaced[1].before == before[150]);
        for (std::size_t i = 0; i < before.size(); ++i)
            QCOMPARE(live.strokes()[i] == before[i], i != 7 && i != 150);
        QVERIFY(update(live, {q, q->end() + 1000, m_view}, 1).replaced.empty());
    }

    /// Scrubbing to and fro prepares what has dried once.
    void comesBackToWhatHasDried()
    {
        std::mt19937_64 random(47);
        const auto p = painting(randomStrokes(random, 60, 200, 150), 200, 150);
        LiveScene live;
        update(live, {p, p->end(), m_view}, 2);
        const auto dry = live.strokes();
        for (int round = 1; round < 6; ++round) {
            update(live, {p, p->end() * round / 7, m_view}, 2);
            update(live, {p, p->end() * round / 9, m_view}, 2);
            QVERIFY(!std::ranges::equal(live.strokes(), dry));
            update(live, {p, p->end(), m_view}, 2);
            QVERIFY(std::ranges::equal(live.strokes(), dry));
        }
        // Another stroke in its place, another view: what was kept no longer holds.
        update(live, {p, p->end() / 9, m_view}, 2);
        auto q = std::make_shared<Painting>(*p);
        Stroke edited = *std::as_const(*q).strokes[5];
        edited.segments.front().density *= 2;
        q->strokes[5] = std::make_shared<const Stroke>(edited);
        View other = m_view;
        for (const double turn : {0.0, 0.3}) {
            other.rotation = turn;
            update(live, {q, q->end() / 9, other}, 2);
            update(live, {q, q->end(), other}, 2);
            LiveScene fresh;
            update(fresh, {q, q->end(), other}, 2);
            QVERIFY(sameScene(live, fresh));
            for (std::size_t i = 0; i < dry.size(); ++i)
                QVERIFY(live.strokes()[i]->nodes == fresh.strokes()[i]->nodes);
        }
    }

    void threadsChangeNoBit()
    {
        auto stroke = std::make_shared<Stroke>(longStroke(1500));
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            Segment &s = stroke->segments[k];
            s.maxAge = 15;
            s.diffusion = k % 300 == 299 ? 1e8f : 12.5f; // so wide that its nodes are deep
            s.anisotropyRatio = k % 7 == 6 ? 3 : 1;
            s.anisotropyAngle = 0.4f;
            s.colour.red = float(k) / 1500;
        }
        const auto same = [](const SceneStroke &a, const SceneStroke &b) {
            const auto deep = [](const DeepNode &m, const DeepNode &n) {
                return m.x == n.x && m.y == n.y && m.a == n.a && m.b == n.b && m.c == n.c && m.weight == n.weight &&
                       m.row == n.row;
            };
            const auto node = [&](std::size_t i) {
                const ViewNode &m = a.nodes[i], &n = b.nodes[i];
                const NodeBoxes p = a.boxes.boxes(), q = b.boxes.boxes();
                return m.x == n.x && m.y == n.y && m.a == n.a && m.b == n.b && m.c == n.c && m.weight == n.weight &&
                       m.cut == n.cut && m.row == n.row && p.x[i] == q.x[i] && p.y[i] == q.y[i] &&
                       p.reachX[i] == q.reachX[i] && p.reachY[i] == q.reachY[i] && p.weight[i] == q.weight[i] &&
                       p.slowest[i] == q.slowest[i] && p.steepest[i] == q.steepest[i] && p.node[i] == q.node[i];
            };
            bool all = a.nodes.size() == b.nodes.size();
            for (std::size_t i = 0; all && i < a.nodes.size(); ++i)
                all = node(i);
            return all && a.separable == b.separable && a.bounds == b.bounds && a.values == b.values &&
                   std::ranges::equal(a.deep, b.deep, deep);
        };
        for (const Microseconds time : {Microseconds(1500 * 16000), stroke->driesAt() - 1, stroke->driesAt()}) {
            const auto serial = buildNodes(*stroke, time, 0, visibleBox(PictureGrid::ofPicture(m_view)));
            const SceneStroke scene = makeSceneStroke(stroke, serial, PictureGrid::ofPicture(m_view));
            QVERIFY(scene.separable > 0 && scene.separable < int(scene.nodes.size()) && !scene.deep.empty());
            QVERIFY(serial->groups.size() >= 1024);
            for (const int threads : {2, 3, 16}) {
                const auto parallel = buildNodes(*stroke, time, 0, visibleBox(PictureGrid::ofPicture(m_view)), threads);
                QVERIFY(sameNodes(*serial, *parallel));
                FrozenNodes frozen;
                QVERIFY(sameNodes(*serial, *buildNodes(stroke, time, 0, visibleBox(PictureGrid::ofPicture(m_view)),
                                                       frozen, threads)));
                QVERIFY(same(scene, makeSceneStroke(stroke, parallel, PictureGrid::ofPicture(m_view), threads)));
            }
        }
    }

    /// Found along with the nodes they are what is found for each group by itself, but for rounding and for nodes out
    /// of the picture.
    void boundsOfGroups()
    {
        auto stroke = std::make_shared<Stroke>(longStroke(700));
        for (Segment &segment : stroke->segments)
            segment.maxAge = 100, segment.diffusion = 0.5f; // all spread still
        stroke->segments[3].bezier[3] = {400, 75};          // partly outside
        stroke->segments[5].diffusion = 1e-4f;              // supersampled
        for (const View &view : {m_view, View::ofArea(Rect::of(30, 10, 100, 75), 400, 300)}) {
            const auto nodes =
                buildNodes(*stroke, 699 * 16000, zoomOctave(view.scale), visibleBox(PictureGrid::ofPicture(view)));
            const SceneStroke scene = makeSceneStroke(stroke, nodes, PictureGrid::ofPicture(view), 1, true);
            QCOMPARE(scene.groupBounds.size(), nodes->groups.size());
            QVERIFY(makeSceneStroke(stroke, nodes, PictureGrid::ofPicture(view), 3, true).groupBounds ==
                    scene.groupBounds);
            QVERIFY(makeSceneStroke(stroke, nodes, PictureGrid::ofPicture(view)).groupBounds.empty());
            std::size_t seen = 0;
            for (std::size_t g = 0; g < nodes->groups.size(); ++g) {
                const PixelRect &a = scene.groupBounds[g];
                const PixelRect b = pixelBounds(*nodes, nodes->groups[g], stroke->origin, PictureGrid::ofPicture(view));
                const auto edges = [](const PixelRect &r) {
                    return std::array{-r.x, -r.y, r.x + r.width, r.y + r.height};
                };
                const bool whole = b.x > 0 && b.y > 0 && b.x + b.width < view.width && b.y + b.height < view.height;
                seen += whole;
                for (std::size_t i = 0; !a.isEmpty() && i < 4; ++i) {
                    QVERIFY(edges(a)[i] <= edges(b)[i] + 1);
                    QVERIFY(!whole || edges(a)[i] >= edges(b)[i] - 1);
                }
                QVERIFY(!whole || !a.isEmpty());
            }
            QVERIFY2(seen > 20, qPrintable(QString::number(seen)));
        }
    }

    void frozenNodesAreBuiltOnes()
    {
        const Stroke whole = longStroke(300);
        FrozenNodes frozen;
        std::size_t kept = 0;
        for (int segments = 1; segments <= 300; ++segments) {
            auto s = std::make_shared<Stroke>(whole);
            s->segments.resize(std::size_t(segments));
            if (segments > 200)
                s->segments[50].density = 3;
            if (segments > 220)
                s->origin = {5, 7};
            if (segments > 240)
                s->style = styleOf(StyleKind::Edge);
            if (segments > 260)
                s->segments[10].bezier[3].x += 1e6f; // so long that its nodes depend on the view
            if (segments > 280)
                s->segments[250].style = styleOf(StyleKind::Uniform);
            const Microseconds time = s->segments.back().born + 16000;
            const int octave = segments > 180 ? 2 : 0;
            const Rect clip = Rect::of(0, 0, 200 + segments, 150);
            const auto nodes = buildNodes(s, time, octave, clip, frozen);
            QVERIFY2(sameNodes(*nodes, *buildNodes(*s, time, octave, clip)), qPrintable(QString::number(segments)));
            kept = std::max(kept, frozen.segments);
            if (segments == 170)
                QCOMPARE(frozen.segments, lastFirm(*s, 146)); // so many are dry
        }
        QVERIFY(kept > 200);
    }
};

QTEST_GUILESS_MAIN(TestLiveScene)
#include "test_live_scene.moc"

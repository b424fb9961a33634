// Strokes of several chains, and segments that take paint away: nodes, cuts, joins, and what files hold of them.
#include "model/formats/files.h"
#include "model/painting/field_hash.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/split.h"
#include "model/shaping/erasing/erase.h"
#include "tests/model/awkward_strokes.h"
#include "tests/model/formats/suffuse_chunks.h"

#include <QCborMap>
#include <QTest>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Three segments from 0 to 30, then two from 100 to 120, then one from 200 to 210.
Stroke threeChains()
{
    Stroke s = line({{0, 0}, {10, 0}, {20, 0}, {30, 0}});
    appendChain(s, line({{100, 0}, {110, 0}, {120, 0}}).segments);
    appendChain(s, line({{200, 0}, {210, 0}}).segments);
    return s;
}

Painting paintingOf(Stroke stroke)
{
    Painting p;
    p.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    return p;
}

std::vector<double> nodesOf(const Stroke &stroke)
{
    std::vector<double> xs;
    for (int node = 0; node < nodeCount(stroke); ++node)
        xs.push_back(nodePosition(stroke, node).x);
    return xs;
}

qint64 headOf(const QByteArray &file, const char *key)
{
    for (const auto &[type, payload] : chunksOf(file))
        if (type == "HEAD")
            return QCborValue::fromCbor(payload).toMap().value(QLatin1String(key)).toInteger();
    return -1;
}

} // namespace

class TestChains : public QObject {
    Q_OBJECT

private slots:
    void nodesOfChains()
    {
        const Stroke s = threeChains();
        QCOMPARE(problemOf(s), QString());
        QCOMPARE(chainsOf(s), (std::vector<Chain>{{0, 2}, {3, 4}, {5, 5}}));
        QCOMPARE(chainAt(s, 4), (Chain{3, 4}));
        // The starts of the segments, the end of the last chain, then those of the others.
        QCOMPARE(nodesOf(s), (std::vector<double>{0, 10, 20, 100, 110, 200, 210, 30, 120}));
        QCOMPARE(sidesOf(s, 3), (NodeSides{-1, 3}));
        QCOMPARE(sidesOf(s, 4), (NodeSides{3, 4}));
        QCOMPARE(sidesOf(s, 6), (NodeSides{5, -1}));
        QCOMPARE(sidesOf(s, 7), (NodeSides{2, -1}));
        QCOMPARE(sidesOf(s, 8), (NodeSides{4, -1}));
        QCOMPARE(sidesOf(s, 9), NodeSides());
        for (int k = 0; k < 6; ++k)
            QCOMPARE(sidesOf(s, endNode(s, k)).before, k);
        QVERIFY(!isInnerNode(s, 3) && isInnerNode(s, 4) && !isInnerNode(s, 7));
        QVERIFY(!handlePosition(s, 7, true) && handlePosition(s, 7, false));
        const Stroke one = line({{0, 0}, {10, 0}, {20, 0}});
        QCOMPARE(nodesOf(one), (std::vector<double>{0, 10, 20}));
    }

    void onlyChainsMayHaveGaps()
    {
        Stroke s = threeChains();
        s.segments[3].start = false;
        QVERIFY(problemOf(s).startsWith(QLatin1String("segments[3].bezier[0]: ")));
        s = threeChains();
        s.segments[0].start = true; // it is one anyway
        QCOMPARE(problemOf(s), QString());
    }

    void nodesMoveByThemselves()
    {
        const Stroke s = threeChains();
        const Stroke end = withNodeMoved(s, {7}, {0, 5});
        QCOMPARE(nodePosition(end, 7), (Point{30, 5}));
        QCOMPARE(nodePosition(end, 3), (Point{100, 0}));
        const Stroke start = withNodeMoved(s, {3}, {0, 5});
        QCOMPARE(nodePosition(start, 3), (Point{100, 5}));
        QCOMPARE(nodePosition(start, 7), (Point{30, 0}));
        for (const Stroke &t :
             {end, start, withHandleMoved(s, 8, false, {115, 3}), withNodeKind(s, {3, 4, 7}, NodeKind::Smooth)})
            QCOMPARE(problemOf(t), QString());
    }

    void nodesGoWithinTheirChain()
    {
        const Stroke s = threeChains();
        std::vector<int> sources;
        const Stroke t = withoutNodes(s, {1, 7, 5}, &sources); // inside the first, its end, and the last chain's start
        QCOMPARE(nodesOf(t), (std::vector<double>{0, 100, 110, 120, 20}));
        QCOMPARE(sources, (std::vector<int>{0, 3, 4}));
        QCOMPARE(problemOf(t), QString());
        QCOMPARE(withoutNodes(s, {0, 1, 2, 3, 4, 5, 6, 7, 8}), s);
        const Stroke bridged = withBridge(s, 1, 3); // what lies between becomes one chain
        QCOMPARE(chainsOf(bridged).size(), std::size_t(2));
        QCOMPARE(problemOf(bridged), QString());
    }

    void reversedTwiceIsTheSame()
    {
        AwkwardStrokes random(3);
        for (int i = 0; i < 100; ++i) {
            const Stroke s = random.chains(1 + random.below(12)), r = reversed(s);
            QCOMPARE(problemOf(s), QString());
            QCOMPARE(problemOf(r), QString());
            QCOMPARE(reversed(r), s);
            QCOMPARE(chainsOf(r).size(), chainsOf(s).size());
        }
        QCOMPARE(nodesOf(reversed(threeChains())), (std::vector<double>{210, 120, 110, 30, 20, 10, 0, 200, 100}));
    }

    void erasingLeavesOneStroke()
    {
        AwkwardStrokes random(5);
        int cut = 0;
        for (int i = 0; i < 200; ++i) {
            const Stroke s = random.stroke(1 + random.below(10));
            const std::vector<Point> path{s.origin + random.point(80), s.origin + random.point(80)};
            std::vector<int> sources, apart;
            const auto one = erasedInOne(s, path, 12, &sources);
            const std::vector<Stroke> runs = erased(s, path, 12, &apart);
            QCOMPARE(one.has_value(), !runs.empty());
            if (!one)
                continue;
            QCOMPARE(problemOf(*one), QString());
            QCOMPARE(sources, apart);
            const std::vector<Chain> chains = chainsOf(*one);
            QCOMPARE(chains.size(), runs.size());
            for (std::size_t c = 0; c < chains.size(); ++c)
                QCOMPARE(chainOnly(*one, chains[c]).segments, runs[c].segments);
            cut += chains.size() > 1;
        }
        QVERIFY(cut > 20);
    }

    void whatLiftsStaysWhereItIs()
    {
        Stroke s = threeChains();
        s.segments[5].lift = true;
        QCOMPARE(erasedInOne(s, {{205, 0}}, 20), std::optional(s));
        QVERIFY(!erasedInOne(s, {{0, 0}, {130, 0}}, 5)); // what is left lays no paint
        QVERIFY(withoutSegments(s, {5}) && !withoutSegments(s, {0, 1, 2, 3, 4}));
        const auto left = withoutSegments(s, {0, 1, 4});
        QCOMPARE(chainsOf(*left), (std::vector<Chain>{{0, 0}, {1, 1}, {2, 2}}));
        QCOMPARE(problemOf(*left), QString());
    }

    void cuttingLeavesThePieces()
    {
        AwkwardStrokes random(7);
        for (int i = 0; i < 100; ++i) {
            const Stroke s = random.chains(2 + random.below(8));
            std::vector<CurvePlace> places;
            for (int k = 0; k < 3; ++k)
                places.push_back({random.below(int(s.segments.size())), random.below(3) ? random.real(0, 1) : 0});
            std::vector<int> sources;
            const Stroke t = cutInOne(s, places, &sources);
            QCOMPARE(problemOf(t), QString());
            QCOMPARE(sources.size(), t.segments.size());
            QVERIFY(chainsOf(t).size() >= chainsOf(s).size());
            QVERIFY(distanceFrom(s, t) < 1e-3);
            for (std::size_t k = 0; k < sources.size(); ++k)
                QCOMPARE(t.segments[k].lift, s.segments[std::size_t(sources[k])].lift);
        }
        QCOMPARE(chainsOf(cutInOne(threeChains(), {{1, 0}, {3, 0}, {4, 1}})).size(), std::size_t(4));
    }

    void chainsAreJoined()
    {
        const Stroke s = threeChains();
        const auto within = joinedWithin(s, 7, 3); // the first one's end and the second one's start
        QVERIFY(within);
        QCOMPARE(chainsOf(*within), (std::vector<Chain>{{0, 5}, {6, 6}})); // with a bridge
        QCOMPARE(problemOf(*within), QString());
        const auto turned = joinedWithin(s, 7, 8); // two ends: the second one is turned
        QCOMPARE(nodePosition(*turned, 6 + 1 + 0).x, 210.0);
        QCOMPARE(nodePosition(*turned, nodeCount(*turned) - 1).x, 100.0);
        const auto ring = joinedWithin(s, 3, 8);
        QCOMPARE(chainsOf(*ring), (std::vector<Chain>{{0, 2}, {3, 5}, {6, 6}}));
        QVERIFY(!joinedWithin(s, 4, 8) && !joinedWithin(s, 3, 3));
        Stroke other = threeChains();
        other.origin = {0, 50};
        const auto both = joinedAt(s, 8, other, 7);
        QVERIFY(both);
        QCOMPARE(problemOf(*both), QString());
        QCOMPARE(chainsOf(*both).size(), std::size_t(5));
        QCOMPARE(both->segments.size(), std::size_t(13));
        // Strokes of one chain: as always.
        const Stroke a = line({{0, 0}, {10, 0}}), b = line({{20, 0}, {30, 0}});
        QCOMPARE(joinedAt(a, 1, b, 0), joined(a, true, b, false));
    }

    void filesHoldChains()
    {
        AwkwardStrokes random(11);
        for (int i = 0; i < 100; ++i) {
            const Painting p = paintingOf(random.chains(1 + random.below(60)));
            const QByteArray file = writeSuffuseFile(p), text = writeTextForm(p);
            const auto q = readSuffuseFile(file, QStringLiteral("a.suffuse"));
            const auto r = readTextForm(text, QStringLiteral("a.json"));
            QVERIFY2(q && r, qPrintable(!q ? q.error() : !r ? r.error() : QString()));
            QVERIFY(*q == p && *r == p);
            QCOMPARE(hashOf(*q), hashOf(p));
        }
    }

    void onlyWhatUsesItIsOfVersion2()
    {
        const Painting plain = paintingOf(line({{0, 0}, {10, 0}, {20, 0}}));
        QCOMPARE(headOf(writeSuffuseFile(plain), "reader"), 1);
        QCOMPARE(headOf(writeSuffuseFile(plain), "version"), 1);
        QVERIFY(writeTextForm(plain).contains("\"version\": 1"));
        for (const bool lift : {false, true}) {
            Stroke s = *plain.strokes[0];
            (lift ? s.segments[1].lift : s.segments[1].start) = true;
            const Painting p = paintingOf(s);
            QCOMPARE(headOf(writeSuffuseFile(p), "reader"), 2);
            QVERIFY(writeTextForm(p).contains("\"version\": 2"));
            QVERIFY(writeTextForm(p).contains(lift ? "\"lift\": true" : "\"start\": true"));
            QVERIFY(hashOf(p) != hashOf(plain));
        }
    }
};

QTEST_APPLESS_MAIN(TestChains)
#include "test_chains.moc"

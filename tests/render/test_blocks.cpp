// Blocks of segments: an edit moves the borders near it alone, and a stroke that grows keeps those that it has.
#include "render/nodes/blocks.h"
#include "tests/render/erasing/edited_strokes.h"
#include "tests/trials.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

enum class Points { AtRandom, Repeated, Equal, OnAGrid };
constexpr Points allPoints[] = {Points::AtRandom, Points::Repeated, Points::Equal, Points::OnAGrid};

/// A segment whose first point is all that it is.
Segment segmentAt(std::mt19937_64 &random, Points points, int k)
{
    std::uniform_real_distribution<float> u(-1000, 1000);
    Segment g;
    switch (points) {
    case Points::AtRandom: g.bezier[0] = {u(random), u(random)}; break;
    case Points::Repeated: g.bezier[0] = {float(k % 7), float(k % 7 * k % 7)}; break; // round and round
    case Points::Equal: break;
    case Points::OnAGrid: g.bezier[0] = {float(random() % 3), float(random() % 2)}; break;
    }
    return g;
}

std::vector<Segment> randomSegments(std::mt19937_64 &random, Points points, int count)
{
    std::vector<Segment> segments;
    for (int k = 0; k < count; ++k) {
        segments.push_back(segmentAt(random, points, k));
        segments.back().start = random() % 150 == 0;
        segments.back().lift = k > 0 && (segments[std::size_t(k) - 1].lift != (random() % 200 == 0));
    }
    return segments;
}

std::vector<std::size_t> bordersOf(const std::vector<Segment> &segments)
{
    Stroke s;
    s.segments = segments;
    return blocksOf(s).borders;
}

/// Those in [from, to), moved.
std::vector<std::size_t> between(const std::vector<std::size_t> &borders, std::size_t from, std::size_t to,
                                 std::ptrdiff_t by = 0)
{
    std::vector<std::size_t> some;
    for (const std::size_t b : borders)
        if (b >= from && b < to)
            some.push_back(std::size_t(std::ptrdiff_t(b) + by));
    return some;
}

} // namespace

class TestBlocks : public QObject {
    Q_OBJECT

private slots:
    void blocksAreAboutAsLongAsMeant()
    {
        std::mt19937_64 random(1);
        std::size_t segments = 0, blocks = 0, least = 1000;
        for (int i = 0; i < 20; ++i) {
            Stroke s = penStroke(random, Rect::of(0, 0, 800, 600), 1000, 4, styleOf(StyleKind::Uniform), {});
            const std::vector<std::size_t> borders = blocksOf(s).borders;
            QCOMPARE(borders.front(), std::size_t(0));
            QCOMPARE(borders.back(), s.segments.size());
            for (std::size_t k = 1; k < borders.size(); ++k) {
                QVERIFY(borders[k] > borders[k - 1] && borders[k] - borders[k - 1] <= longestBlock);
                least = std::min(least, borders[k] - borders[k - 1]);
            }
            segments += s.segments.size(), blocks += borders.size() - 1;
        }
        qInfo("%.1f segments a block, the shortest has %zu", double(segments) / double(blocks), least);
        QVERIFY(segments > 27 * blocks && segments < 37 * blocks);
    }

    void runsBeginBlocks()
    {
        std::mt19937_64 random(2);
        for (const Points points : allPoints) {
            const auto segments = randomSegments(random, points, 2000);
            const auto borders = bordersOf(segments);
            for (std::size_t k = 1; k < segments.size(); ++k)
                if (segments[k].start || segments[k].lift != segments[k - 1].lift)
                    QVERIFY(std::ranges::binary_search(borders, k));
            for (std::size_t k = 1; k < borders.size(); ++k)
                QVERIFY(borders[k] > borders[k - 1] && borders[k] - borders[k - 1] <= longestBlock);
            QCOMPARE(borders.back(), segments.size());
        }
        QCOMPARE(bordersOf({}), std::vector<std::size_t>{0});
    }

    /// Segments are taken out, put in, changed, and made to begin chains, by the thousand.
    void anEditMovesNoBorderFarAway()
    {
        std::mt19937_64 random(3);
        for (const Points points : allPoints) {
            std::size_t farthest = 0;
            for (int trial = 0; trial < trials(400, 20'000); ++trial) {
                const auto before = randomSegments(random, points, 500);
                const std::size_t from = random() % before.size();
                const std::size_t to = std::min(before.size(), from + random() % 4); // of what goes
                auto after = before;
                after.erase(after.begin() + std::ptrdiff_t(from), after.begin() + std::ptrdiff_t(to));
                const auto more = randomSegments(random, Points::AtRandom, int(random() % 4));
                after.insert(after.begin() + std::ptrdiff_t(from), more.begin(), more.end());
                if (const std::size_t behind = from + more.size(); random() % 2 && behind < after.size())
                    after[behind].start = true;
                const auto by = std::ptrdiff_t(more.size()) - std::ptrdiff_t(to - from);
                const auto a = bordersOf(before), b = bordersOf(after);
                const std::size_t begin = from > borderReach ? from - borderReach : 0, end = to + 1 + borderReach;
                QCOMPARE(between(b, 0, begin), between(a, 0, begin));
                QCOMPARE(between(b, std::size_t(std::ptrdiff_t(end) + by), after.size() + 1),
                         between(a, end, before.size() + 1, by));
                for (const std::size_t border : a)
                    if (border < from && !std::ranges::binary_search(b, border))
                        farthest = std::max(farthest, from - border);
            }
            qInfo("points %d: the farthest border that went lay %zu segments before", int(points), farthest);
        }
    }

    void aGrowingStrokeKeepsFirmBorders()
    {
        std::mt19937_64 random(4);
        for (const Points points : allPoints) {
            Stroke whole;
            whole.segments = randomSegments(random, points, 700);
            Stroke s;
            StrokeBlocks last;
            for (const Segment &g : whole.segments) {
                s.segments.push_back(g);
                const StrokeBlocks now = blocksOf(s);
                QVERIFY(std::ranges::includes(now.borders, now.firm));
                QVERIFY(std::ranges::includes(now.firm, last.firm));
                if (!last.firm.empty()) {
                    const std::size_t firm = last.firm.back();
                    QCOMPARE(between(now.borders, 0, firm + 1), between(last.borders, 0, firm + 1));
                }
                last = now;
            }
            for (std::size_t k = 0; k <= s.segments.size(); ++k)
                QCOMPARE(isFirmBorder(s, k), std::ranges::binary_search(last.firm, k));
            for (const std::size_t from : last.firm) { // as found from there on
                const StrokeBlocks rest = blocksOf(s, from);
                QCOMPARE(rest.borders, between(last.borders, from, s.segments.size() + 1));
                QCOMPARE(rest.firm, between(last.firm, from, s.segments.size() + 1));
            }
        }
    }

    /// Nothing but where segments begin tells where blocks do: so values change, and strokes move, within their blocks.
    void onlyFirstPointsCount()
    {
        std::mt19937_64 random(5);
        const Stroke s = penStroke(random, Rect::of(-300, -300, 800, 600), 900, 4, styleOf(StyleKind::Edge), {});
        Stroke t = s;
        t.origin = {1000, -3}, t.style = styleOf(StyleKind::Uniform);
        for (Segment &g : t.segments) {
            g.density *= 1.5f, g.born += 1000, g.colour.red = 1;
            g.bezier[1] = {0, 0};
        }
        QCOMPARE(blocksOf(t).borders, blocksOf(s).borders);
        Stroke zero = s, negative = s;
        for (std::size_t k = 0; k < s.segments.size(); k += 3)
            zero.segments[k].bezier[0].x = 0, negative.segments[k].bezier[0].x = -0.0f;
        QVERIFY(zero == negative);
        QCOMPARE(blocksOf(zero).borders, blocksOf(negative).borders);
    }
};

QTEST_GUILESS_MAIN(TestBlocks)
#include "test_blocks.moc"

// Groups that are clipped to what lies below them, masks, and washes: what each shows, and that nothing else changes.
#include "tests/render/layers/grouped.h"

#include "render/composition/composition.h"
#include "render/composition/washes.h"
#include "render/probe.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

const View sheet = View::ofArea(Rect::of(0, 0, 96, 72), 96, 72);

/// A level blot around a point.
Stroke blot(StrokeId id, GroupId group, Point centre, double size, Colour colour)
{
    Stroke s = test::stroke(id, Shape::Straight, centre, size, 4, styleOf(StyleKind::Uniform), {}, colour);
    s.group = group;
    return s;
}

constexpr Colour red{0.9f, 0.2f, 0, 0.9f}, blue{0, 0.1f, 0.8f, 0.8f}, green{0, 0.7f, 0.6f, 0.7f};

Group groupOf(GroupId id, GroupId parent = 0)
{
    Group g;
    g.id = id, g.parent = parent;
    return g;
}
Group clipped(GroupId id, GroupId parent = 0)
{
    Group g = groupOf(id, parent);
    g.clips = true;
    return g;
}
Group maskOf(GroupId id, GroupId parent = 0)
{
    Group g = groupOf(id, parent);
    g.mask = true;
    return g;
}

PaintingPtr with(std::vector<Stroke> strokes, std::vector<Group> groups)
{
    auto p = std::make_shared<Painting>(*painting(std::move(strokes)));
    p->groups = std::move(groups);
    return p;
}

PaintingPtr changed(const PaintingPtr &p, GroupId id, const std::function<void(Group &)> &change)
{
    auto q = std::make_shared<Painting>(*p);
    change(*std::ranges::find(q->groups, id, &Group::id));
    return q;
}

PaintingPtr without(const PaintingPtr &p, StrokeId id)
{
    auto q = std::make_shared<Painting>(*p);
    q->strokes.clear();
    for (const StrokePtr &stroke : p->strokes)
        if (stroke->id != id)
            q->strokes.push_back(stroke);
    return q;
}

PaintingPtr hiding(const PaintingPtr &p, StrokeId id)
{
    auto q = std::make_shared<Painting>(*p);
    for (StrokePtr &stroke : q->strokes)
        if (stroke->id == id) {
            Stroke hidden = *stroke;
            hidden.visible = false;
            stroke = std::make_shared<const Stroke>(std::move(hidden));
        }
    return q;
}

} // namespace

class TestBoundedLayers : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu), m_reference = make(Backend::Reference);

    FloatPicture drawn(const PaintingPtr &p, bool transparent = false)
    {
        return test::render(*m_cpu, p, sheet, -1, transparent);
    }
    bool looksTheSame(const PaintingPtr &a, const PaintingPtr &b) { return drawn(a).rgba == drawn(b).rgba; }
    /// As far as rounding goes.
    bool agrees(const PaintingPtr &p)
    {
        for (const bool transparent : {false, true})
            if (worst(drawn(p, transparent), test::render(*m_reference, p, sheet, -1, transparent)).difference >
                1.0 / 512)
                return false;
        return true;
    }
    float alphaAt(const PaintingPtr &p, int x, int y) { return drawn(p, true).rgba[std::size_t(y * 96 + x) * 4 + 3]; }

private slots:
    void clippedToAGroup()
    {
        const PaintingPtr p =
            with({blot(1, 1, {30, 36}, 24, red), blot(2, 2, {50, 36}, 24, blue)}, {groupOf(1), clipped(2)});
        const Composition c = compositionOf(*p);
        QCOMPARE(c.layers.size(), std::size_t(1)); // what it is clipped to is passed through all the same
        QCOMPARE(c.layers[0].clippedTo, 0);
        QCOMPARE(c.shapes, (std::vector<int>{0, Layer::none}));
        QVERIFY(agrees(p));
        const PaintingPtr base = without(p, 2), free = changed(p, 2, [](Group &g) { g.clips = false; });
        QVERIFY(!looksTheSame(p, base));
        QVERIFY(!looksTheSame(p, free));
        QCOMPARE(alphaAt(p, 70, 36), 0.0f); // beyond the base
        QVERIFY(alphaAt(free, 70, 36) > 0.5f);
        // What covers nothing where the base is shows nothing at all.
        const PaintingPtr apart =
            with({blot(1, 1, {12, 12}, 4, red), blot(2, 2, {80, 60}, 4, blue)}, {groupOf(1), clipped(2)});
        QVERIFY(looksTheSame(apart, without(apart, 2)));
    }

    void clippedToAStroke()
    {
        const PaintingPtr p = with({blot(1, 0, {30, 36}, 24, red), blot(2, 2, {50, 36}, 24, blue)}, {clipped(2)});
        QCOMPARE(compositionOf(*p).bases, (std::vector<ClipBase>{{0, 0, 1}}));
        QVERIFY(agrees(p));
        QCOMPARE(alphaAt(p, 70, 36), 0.0f);
    }

    void severalAreClippedToOne()
    {
        const PaintingPtr p =
            with({blot(1, 1, {30, 36}, 24, red), blot(2, 2, {50, 30}, 24, blue), blot(3, 3, {50, 42}, 24, green)},
                 {groupOf(1), clipped(2), clipped(3)});
        const Composition c = compositionOf(*p);
        QCOMPARE(c.layers[0].clippedTo, 0);
        QCOMPARE(c.layers[1].clippedTo, 0);
        QVERIFY(agrees(p));
        QVERIFY(!looksTheSame(p, without(p, 3)));
    }

    /// Nothing is clipped to what lies in another group.
    void clippedToNothing()
    {
        Group plain = groupOf(2);
        plain.isolated = true;
        const std::vector<Stroke> strokes{blot(1, 2, {30, 36}, 24, red), blot(2, 2, {50, 36}, 24, blue)};
        QVERIFY(looksTheSame(with(strokes, {clipped(2)}), with(strokes, {plain})));
        std::vector<Stroke> inner{blot(1, 0, {30, 36}, 24, red), blot(2, 2, {50, 36}, 24, blue)};
        Group isolated = groupOf(2, 1);
        isolated.isolated = true;
        QVERIFY(looksTheSame(with(inner, {groupOf(1), clipped(2, 1)}), with(inner, {groupOf(1), isolated})));
    }

    void clippedToWhatIsHidden()
    {
        const PaintingPtr p =
            with({blot(3, 0, {48, 30}, 30, green), blot(1, 1, {30, 36}, 24, red), blot(2, 2, {50, 36}, 24, blue)},
                 {groupOf(1), clipped(2)});
        const PaintingPtr hidden = changed(p, 1, [](Group &g) { g.visible = false; });
        QVERIFY(looksTheSame(hidden, without(without(p, 1), 2)));
        QVERIFY(looksTheSame(hiding(p, 1), hidden));
        QVERIFY(agrees(hidden));
    }

    void masks()
    {
        const PaintingPtr p = with({blot(1, 1, {30, 36}, 24, red), blot(2, 2, {44, 36}, 12, blue),
                                    blot(3, 1, {60, 36}, 24, green), blot(4, 0, {70, 60}, 8, green)},
                                   {groupOf(1), maskOf(2, 1)});
        QVERIFY(agrees(p));
        QVERIFY(alphaAt(p, 44, 36) > 0.3f);
        QCOMPARE(alphaAt(p, 10, 36), 0.0f); // where the mask is not
        QVERIFY(alphaAt(p, 70, 60) > 0.3f); // what is not in the group
        const PaintingPtr far =
            with({blot(1, 1, {30, 36}, 4, red), blot(2, 2, {84, 60}, 2, blue)}, {groupOf(1), maskOf(2, 1)});
        QVERIFY(looksTheSame(far, without(without(far, 1), 2))); // all is masked
        // Opacity makes a mask weaker, as its coverage is.
        const PaintingPtr weak = changed(p, 2, [](Group &g) { g.opacity = 0.5f; });
        QVERIFY(agrees(weak));
        QVERIFY(alphaAt(weak, 44, 36) < 0.75f * alphaAt(p, 44, 36));
    }

    void masksOfNothing()
    {
        const PaintingPtr p =
            with({blot(1, 1, {30, 36}, 24, red), blot(2, 2, {44, 36}, 12, blue)}, {groupOf(1), maskOf(2, 1)});
        QVERIFY(looksTheSame(hiding(p, 2), without(p, 2)));
        QVERIFY(looksTheSame(changed(p, 2, [](Group &g) { g.visible = false; }), without(p, 2)));
        QVERIFY(looksTheSame(without(p, 1), painting({}))); // a mask alone
    }

    void masksOfThePainting()
    {
        const PaintingPtr p =
            with({blot(1, 0, {30, 36}, 24, red), blot(2, 2, {44, 36}, 12, blue), blot(3, 3, {60, 36}, 24, green)},
                 {maskOf(2), groupOf(3)});
        QCOMPARE(compositionOf(*p).layers[0].group, GroupId(0));
        QVERIFY(agrees(p));
        QCOMPARE(alphaAt(p, 80, 36), 0.0f);
        QVERIFY(alphaAt(p, 44, 36) > 0.3f);
    }

    void soloGroups()
    {
        const PaintingPtr p =
            with({blot(1, 0, {30, 36}, 24, red), blot(2, 2, {44, 36}, 12, blue), blot(3, 3, {60, 36}, 24, green)},
                 {groupOf(1), groupOf(2, 1), groupOf(3)});
        QVERIFY(looksTheSame(changed(p, 1, [](Group &g) { g.solo = true; }), without(without(p, 1), 3)));
        const PaintingPtr hidden = changed(p, 2, [](Group &g) { g.solo = true, g.visible = false; });
        QVERIFY(looksTheSame(hidden, painting({})));
    }

    void sixtyFourDeep()
    {
        auto p = std::make_shared<Painting>();
        p->canvas.width = 96, p->canvas.height = 72;
        for (GroupId id = 1; id <= 64; ++id) {
            Group g = id % 3 == 0 ? clipped(id, id - 1) : groupOf(id, id - 1);
            g.opacity = 0.99f;
            p->groups.push_back(g);
            p->strokes.push_back(std::make_shared<const Stroke>(
                blot(id, id, {20 + double(id % 8) * 7, 20 + double(id % 5) * 8}, 16, id % 2 ? red : blue)));
        }
        QVERIFY(agrees(p));
    }

    /// A wash is the one stroke of all their segments, to the bit.
    void washes()
    {
        std::mt19937_64 random(21);
        for (int round = 0; round < 8; ++round) {
            const Wash wash{styleOf(StyleKind(round % 3)), round % 2 ? Mix{MixMode::Beta, 0.4f} : Mix{}};
            std::vector<Stroke> strokes = randomStrokes(random, 9, 96, 72);
            for (std::size_t i = 2; i < 7; ++i)
                strokes[i].group = i < 5 ? 1 : 2;
            Group g = groupOf(1);
            g.wash = wash;
            const PaintingPtr p = with(strokes, {g, groupOf(2, 1)});
            Stroke one = strokes[2];
            one.style = wash.style, one.mix = wash.mix;
            for (std::size_t i = 3; i < 7; ++i)
                for (std::size_t k = 0; k < strokes[i].segments.size(); ++k) {
                    Segment &segment = one.segments.emplace_back(strokes[i].segments[k]);
                    segment.start = k == 0;
                    for (Offset &o : segment.bezier)
                        o = toOffset(strokes[i].origin + o, one.origin);
                }
            std::vector<Stroke> merged{strokes[0], strokes[1], one, strokes[7], strokes[8]};
            QVERIFY(looksTheSame(p, with(merged, {g})));
            QVERIFY(!looksTheSame(p, changed(p, 1, [](Group &group) { group.wash.reset(); })));
            QVERIFY(agrees(p));
        }
    }

    void whatStaysByItselfInAWash()
    {
        Group g = groupOf(1);
        g.wash = Wash{styleOf(StyleKind::Edge), {}};
        Stroke filled = blot(2, 1, {40, 30}, 20, blue);
        filled.fill = Fill();
        const PaintingPtr p = with(
            {blot(1, 1, {30, 36}, 24, red), filled, blot(3, 1, {60, 36}, 24, green), blot(4, 2, {45, 36}, 30, red)},
            {g, maskOf(2, 1)});
        Washes washes;
        const PaintingPtr drawn = washes.drawn(p);
        QCOMPARE(orderOf(*drawn), (std::vector<StrokeId>{1, 2, 4}));
        QCOMPARE(drawn->strokes[1]->style, g.wash->style);
        QVERIFY(drawn->strokes[2] == p->strokes[3]); // the mask's
        QVERIFY(agrees(p));
        QCOMPARE(orderOf(*washes.drawn(hiding(p, 1))), (std::vector<StrokeId>{1, 2, 3, 4}));
        QVERIFY(agrees(hiding(p, 1)));
    }

    void washesStayTheSameObjects()
    {
        Group g = groupOf(1);
        g.wash = Wash{};
        const PaintingPtr p = with({blot(1, 1, {30, 36}, 24, red), blot(3, 1, {60, 36}, 24, green)}, {g});
        Washes washes;
        const StrokePtr first = washes.drawn(p)->strokes[0];
        QVERIFY(washes.drawn(std::make_shared<Painting>(*p))->strokes[0] == first);
        QVERIFY(washes.drawn(changed(p, 1, [](Group &group) { group.wash->mix.mode = MixMode::Beta; }))->strokes[0] !=
                first);
        const PaintingPtr plain = painting({});
        QVERIFY(washes.drawn(plain) == plain);
    }

    /// An edit of a wash draws what the edited segments reach.
    void editsOfAWash()
    {
        Group g = groupOf(1);
        g.wash = Wash{styleOf(StyleKind::Feathering), {}};
        PaintingPtr p = with({blot(1, 1, {20, 20}, 10, red), blot(3, 1, {76, 56}, 10, green)}, {g});
        const auto live = make(Backend::Cpu, 0, 16);
        FloatPicture picture;
        QVERIFY(live->render({p, p->end(), sheet}, picture));
        p = withDensity(p, 1, 1.5);
        const auto stats = live->render({p, p->end(), sheet}, picture);
        QVERIFY(stats);
        QVERIFY(stats->tilesEvaluated < stats->tiles);
        QVERIFY(picture.rgba == drawn(p).rgba);
    }

    /// The probe shows the picture's colour, and each stroke's part of it.
    void probed()
    {
        Group wash = groupOf(1);
        wash.wash = Wash{styleOf(StyleKind::Feathering), {MixMode::Beta, 0.5f}};
        wash.opacity = 0.8f;
        const PaintingPtr p =
            with({blot(1, 1, {30, 36}, 24, red), blot(2, 1, {44, 36}, 24, green), blot(3, 2, {50, 36}, 20, blue),
                  blot(4, 3, {46, 36}, 30, red), blot(5, 0, {60, 50}, 20, green)},
                 {wash, clipped(2), maskOf(3)});
        for (const Point at : {Point{40.5, 36.5}, Point{52.5, 36.5}, Point{60.5, 44.5}}) {
            const Result<Probe> probed = probe(*p, p->end(), at.x, at.y);
            QVERIFY(probed);
            // A picture of one small pixel: probing knows none.
            const View near = View::ofArea(Rect::of(at.x - 1e-3, at.y - 1e-3, 2e-3, 2e-3), 1, 1);
            const FloatPicture picture = test::render(*m_reference, p, near);
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(std::abs(probed->rgbAfter[c] - double(picture.rgba[c])) < 1e-4);
            double sum = probed->canvasShare;
            for (const ProbeStroke &stroke : probed->strokes) {
                QVERIFY(stroke.id != 4); // a mask shows nothing of itself
                QVERIFY(stroke.colourShare >= 0);
                sum += stroke.colourShare;
            }
            QVERIFY(std::abs(sum - 1) < 1e-9);
        }
        const Result<Probe> between = probe(*p, p->end(), 37.5, 36.5);
        QVERIFY(between);
        QCOMPARE(between->strokes[0].id, StrokeId(1));
        QCOMPARE(between->strokes[1].id, StrokeId(2));
        QCOMPARE(between->strokes[0].opacity, between->strokes[1].opacity); // they are one stroke
    }
};

QTEST_GUILESS_MAIN(TestBoundedLayers)
#include "test_bounded_layers.moc"

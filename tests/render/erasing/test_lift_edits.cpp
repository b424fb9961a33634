// Edits of paint that is lifted: what an erasure leaves as it was, and redraws of what changed.
#include "tests/render/erasing/edited_strokes.h"
#include "tests/render/erasing/lifted.h"

#include "model/painting/influence.h"
#include "model/shaping/erasing/erase.h"

using namespace suffuse;
using namespace suffuse::test;

namespace {

PaintingPtr withStroke(const PaintingPtr &p, std::size_t index, Stroke s)
{
    auto q = std::make_shared<Painting>(*p);
    q->strokes[index] = std::make_shared<const Stroke>(std::move(s));
    return q;
}

/// Greatest difference of pixels that a rectangle of the canvas does not meet (docs/reference.md, "Supersampling").
double differenceOutside(const FloatPicture &a, const FloatPicture &b, const Rect &influence, const View &view)
{
    const Rect met = influence.grown(view.px() * std::numbers::sqrt2 / 2);
    double most = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 4 && !met.contains(view.toCanvas({x + 0.5, y + 0.5})); ++c)
                most = std::max(most, std::abs(double(a.at(x, y)[c]) - double(b.at(x, y)[c])));
    return most;
}

} // namespace

class TestLiftEdits : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);

private slots:
    /// Outside the influence of what lifts every pixel keeps its bits, whatever varies along the stroke.
    void liftingChangesNothingElse()
    {
        for (const Style &style : someStyles())
            for (const int what : {0, 1, 2, 3}) {
                Stroke s = wash(2, Rect::of(14, 12, 100, 60), 12, 4, style);
                for (std::size_t k = 0; k < s.segments.size(); ++k) {
                    if (what == 1)
                        s.segments[k].colour = {float(k % 7) / 7, 0.3f, 0.9f, 0.8f};
                    if (what == 2)
                        s.segments[k].granulation = float(k % 5) / 5;
                    if (what == 3 && k % 9 == 4)
                        s.segments[k].style = styleOf(StyleKind(k % 3));
                }
                const auto p = painting({stroke(1, Shape::Curved, {60, 40}, 40, 9, styleOf(StyleKind::Uniform)), s},
                                        128, 96, {PaperKind::Procedural, 1, 16, 0.7f, {}});
                Stroke lifted = s;
                liftAlong(lifted, {40, 30}, {60, 44}, 3, 2);
                for (const Microseconds time : {p->end(), Microseconds(400'000)}) {
                    Rect influence;
                    for (const Segment &g : lifted.segments)
                        if (g.lift)
                            influence = influence.united(influenceOf(lifted, g, time));
                    for (const View &view :
                         {View::ofArea(Rect::of(0, 0, 128, 96), 128, 96), View{{64, 48}, 0.7, 0.4, true, 90, 70},
                          View{{70, 44}, 5, 0, false, 128, 96}}) {
                        const FloatPicture a = test::render(*m_cpu, p, view, time);
                        const FloatPicture b = test::render(*m_cpu, withStroke(p, 1, lifted), view, time);
                        QVERIFY2(a.rgba != b.rgba, nameOf(style).constData());
                        const double outside = differenceOutside(a, b, influence, view);
                        QVERIFY2(outside == 0, qPrintable(QStringLiteral("%1, what %2, time %3, scale %4: %5")
                                                              .arg(QString::fromLatin1(nameOf(style)))
                                                              .arg(what)
                                                              .arg(time)
                                                              .arg(view.scale)
                                                              .arg(outside)));
                    }
                }
            }
    }

    /// Erasing leaves one stroke. Pixels outside the influence of the segments that were taken or cut keep their bits
    /// while the stroke is wet; once dry, those that the blocks around the cuts do not reach (test_local_edits).
    void erasingChangesNothingElse()
    {
        for (const Style &style :
             {styleOf(StyleKind::Uniform), styleOf(StyleKind::Feathering), styleOf(StyleKind::Edge)}) {
            const Stroke s = wash(1, Rect::of(14, 12, 100, 60), 12, 4, style);
            std::vector<int> sources;
            const auto left = erasedInOne(s, {{60, 40}, {70, 44}}, 5, &sources);
            QVERIFY(left && chainsOf(*left).size() > 2);
            const auto p = painting({s}, 128, 96), q = painting({*left}, 128, 96);
            const View view = View::ofArea(Rect::of(0, 0, 128, 96), 128, 96);
            for (const Microseconds time : {Microseconds(400'000), p->end()}) {
                Rect influence;
                for (std::size_t k = 0; k < s.segments.size(); ++k) {
                    const auto at = std::ranges::find(sources, int(k));
                    const bool stays = at != sources.end() &&
                                       left->segments[std::size_t(at - sources.begin())].bezier == s.segments[k].bezier;
                    if (!stays)
                        influence = influence.united(influenceOf(s, s.segments[k], time));
                }
                const FloatPicture a = test::render(*m_cpu, p, view, time), b = test::render(*m_cpu, q, view, time);
                QVERIFY(a.rgba != b.rgba);
                const double outside = differenceOutside(a, b, influence, view);
                QVERIFY2(outside <= (time == p->end() ? 1.0 / 512 : 0),
                         qPrintable(QStringLiteral("%1: %2").arg(QString::fromLatin1(nameOf(style))).arg(outside)));
                const EditReach reach = reachOfEdit(s, *left, {}, time, view);
                QCOMPARE(pixelsChangedOutside(a, b, reach.areas), 0);
            }
        }
    }

    /// Whatever was edited, an edit's redraw is the full redraw: also where lifting segments come, go or turn into
    /// others.
    void dirtyRedrawIsFullRedraw()
    {
        std::mt19937_64 random(5);
        std::uniform_real_distribution<double> u(0, 1);
        auto p = painting(liftedStrokes(random, 16, 160, 120), 160, 120);
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(p->canvas.area(), 160, 120);
        Microseconds time = p->end();
        QVERIFY(live->render({p, time, view, false}, picture));
        for (int step = 0; step < 80; ++step) {
            p = randomlyEdited(p, random);
            const std::size_t j = random() % p->strokes.size();
            Stroke s = *p->strokes[j];
            Segment &g = s.segments[random() % s.segments.size()];
            if (step % 3 == 0)
                g.lift = !g.lift;
            else if (step % 3 == 1)
                liftAlong(s, {160 * u(random), 120 * u(random)}, {160 * u(random), 120 * u(random)}, 4, 1, 2);
            p = withStroke(p, j, s);
            if (random() % 6 == 0)
                time = Microseconds(u(random) * double(p->end()));
            QVERIFY(live->render({p, time, view, false}, picture));
            QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, view, time).rgba,
                     qPrintable(QStringLiteral("step %1").arg(step)));
        }
    }

    /// A lifting segment that is dragged: layers below and above give the picture to 1e-5, and exactly once it rests.
    void layersHoldWhileALiftIsDragged()
    {
        std::mt19937_64 random(17);
        const View view = View::ofArea(Rect::of(0, 0, 100, 75), 100, 75);
        for (const bool transparent : {false, true}) {
            auto p = painting(liftedStrokes(random, 14, 100, 75), 100, 75);
            Stroke s = *p->strokes[6];
            liftAlong(s, {20, 20}, {80, 50}, 4, 1);
            p = withStroke(p, 6, s);
            const auto live = make(Backend::Cpu);
            FloatPicture picture;
            QVERIFY(live->render({p, p->end(), view, transparent}, picture));
            for (int step = 0; step < 6; ++step) {
                for (Offset &o : s.segments.back().bezier)
                    o.y += 1;
                s.segments.back().start = true; // it came off the one before
                p = withStroke(p, 6, s);
                QVERIFY(live->render({p, p->end(), view, transparent, true}, picture));
                QVERIFY(worst(picture, test::render(*make(Backend::Cpu), p, view, -1, transparent)).difference <= 1e-5);
            }
            QVERIFY(live->render({p, p->end(), view, transparent, false}, picture));
            QVERIFY(picture.rgba == test::render(*make(Backend::Cpu), p, view, -1, transparent).rgba);
        }
    }

    /// A stroke that is erased from while it dries, by a chain that grows.
    void aGrowingLift()
    {
        Stroke s = wash(1, Rect::of(10, 10, 100, 70), 12, 5, styleOf(StyleKind::Edge));
        for (std::size_t k = 0; k < s.segments.size(); ++k)
            s.segments[k].colour = {float(k) / 100, 0.3f, 0.9f, 0.8f};
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        const View view = View::ofArea(Rect::of(0, 0, 128, 96), 128, 96);
        for (int frame = 0; frame < 50; ++frame) {
            const auto at = [](int k) { return Point{15.0 + 1.8 * k, 45 + 20 * std::sin(0.3 * k)}; };
            Segment g = liftBetween(s, at(frame), at(frame + 1), 4, 1);
            g.born = 600'000 + frame * 40'000;
            g.start = frame == 0;
            if (frame > 0)
                g.bezier[0] = s.segments.back().bezier[3];
            s.segments.push_back(g);
            const auto p = painting({s}, 128, 96);
            const Microseconds time = 620'000 + frame * 40'000;
            QVERIFY(live->render({p, time, view, false}, picture));
            if (frame % 5 == 0)
                QVERIFY2(picture.rgba == test::render(*make(Backend::Cpu), p, view, time).rgba,
                         qPrintable(QStringLiteral("frame %1").arg(frame)));
        }
    }

    void influenceOfWhatIsMoved()
    {
        // An edit of a lifting segment evaluates its surroundings alone.
        Stroke s = wash(1, Rect::of(20, 20, 350, 250), 20, 6, styleOf(StyleKind::Edge));
        liftAlong(s, {60, 60}, {90, 70}, 5, 2);
        const auto p = painting({s}, 400, 300);
        const View view = View::ofArea(p->canvas.area(), 400, 300);
        const auto live = make(Backend::Cpu);
        FloatPicture picture;
        QVERIFY(live->render({p, p->end(), view, false}, picture));
        s.segments.back().density *= 0.5f;
        const auto q = withStroke(p, 0, s);
        const auto stats = live->render({q, q->end(), view, false}, picture);
        QVERIFY(stats && stats->tilesEvaluated > 0);
        for (const PixelRect &r : stats->dirty)
            QVERIFY(r.x < 200 && r.y < 150);
        QVERIFY(picture.rgba == test::render(*make(Backend::Cpu), q, view).rgba);
    }
};

QTEST_GUILESS_MAIN(TestLiftEdits)
#include "test_lift_edits.moc"

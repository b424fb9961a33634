// Edits of a few segments: far from them a stroke keeps its nodes and the picture its bits, dry and wet.
#include "model/formats/files.h"
#include "model/painting/influence.h"
#include "model/shaping/erasing/erase.h"
#include "tests/render/erasing/edited_strokes.h"
#include "tests/trials.h"

#include <QFile>

using namespace suffuse;
using namespace suffuse::test;

namespace {

constexpr int width = 240, height = 180;
const Rect sheet = Rect::of(0, 0, width, height);

/// The segments of a stroke that another one does not have as they were. `sources`: where the other one's come from.
std::vector<std::size_t> editedSegments(const Stroke &before, const Stroke &after, const std::vector<int> &sources)
{
    std::vector<char> stays(before.segments.size(), 0);
    for (std::size_t i = 0; i < sources.size(); ++i)
        if (const auto k = std::size_t(sources[i]); after.segments[i] == before.segments[k])
            stays[k] = 1;
    std::vector<std::size_t> edited;
    for (std::size_t k = 0; k < stays.size(); ++k)
        if (!stays[k])
            edited.push_back(k);
    return edited;
}

/// The stroke dry, wet, and half of each: with the moment to look at it.
struct Moment {
    Stroke stroke;
    Microseconds time;
};
std::vector<Moment> momentsOf(const Stroke &s)
{
    Stroke wet = s;
    for (Segment &g : wet.segments)
        g.born = 0, g.maxAge = 100, g.diffusion *= 0.5f;
    return {{s, s.driesAt()}, {wet, 1'000'000}, {s, s.driesAt() / 2}};
}

std::vector<View> someViews(const Rect &area)
{
    const Point centre{(area.left + area.right) / 2, (area.top + area.bottom) / 2};
    return {View::ofArea(area, width, height), View{centre, 0.7, 0.4, true, 120, 90},
            View{centre, 4, 0, false, 160, 120}};
}

} // namespace

class TestLocalEdits : public QObject {
    Q_OBJECT

    std::unique_ptr<Renderer> m_cpu = make(Backend::Cpu);
    std::vector<std::size_t> m_reaches;

    /// Whether the pictures of both strokes are the same where the groups that differ are not, and these lie near
    /// enough to the edit.
    void compare(const Stroke &before, const Stroke &after, const std::vector<std::size_t> &edited, Microseconds time,
                 const View &view, const QByteArray &what)
    {
        const EditReach reach = reachOfEdit(before, after, edited, time, view);
        QVERIFY2(reach.farthest <= borderReach,
                 (what + ": " + QByteArray::number(qulonglong(reach.farthest))).constData());
        m_reaches.push_back(reach.farthest);
        const auto picture = [&](const Stroke &s) {
            return test::render(*m_cpu, painting({s}, width, height, {PaperKind::Procedural, 1, 16, 0.7f, {}}), view,
                                time);
        };
        const int changed = pixelsChangedOutside(picture(before), picture(after), reach.areas);
        QVERIFY2(changed == 0, (what + ": " + QByteArray::number(changed) + " pixels").constData());
    }

    void tellReaches()
    {
        std::ranges::sort(m_reaches);
        if (!m_reaches.empty())
            qInfo("%zu edits: nodes change up to %zu segments away in the middle case, %zu at most", m_reaches.size(),
                  m_reaches[m_reaches.size() / 2], m_reaches.back());
        m_reaches.clear();
    }

    /// Erases and cuts in the middle of a stroke.
    void cutAndCompare(const Stroke &s, Microseconds time, const View &view, const QByteArray &what, std::size_t where,
                       double radius)
    {
        std::vector<int> sources;
        const Point at = s.cubicOf(s.segments[where]).at(0.3);
        const auto left = erasedInOne(s, {at, at + Point{1, 2}}, radius, &sources);
        QVERIFY(left && chainsOf(*left).size() > chainsOf(s).size());
        compare(s, *left, editedSegments(s, *left, sources), time, view, what + " erased");
        if (QTest::currentTestFailed())
            return;
        sources.clear();
        const Stroke cut = cutInOne(s, {{int(where), 0.4}}, &sources);
        QCOMPARE(cut.segments.size(), s.segments.size() + 1);
        compare(s, cut, editedSegments(s, cut, sources), time, view, what + " cut");
    }

private slots:
    void cuts()
    {
        std::mt19937_64 random(11);
        int trial = 0;
        for (const Style &style : someStyles())
            for (const Varies what : allVarieties) {
                const Stroke s = penStroke(random, sheet.grown(-15), 500, 3, style, what);
                for (const Moment &m : momentsOf(s)) {
                    const int number = trial++;
                    if (!isTried(number))
                        continue;
                    const View view = someViews(sheet)[std::size_t(number % 3)];
                    const QByteArray name = nameOf(style) + " varies " + QByteArray::number(int(what));
                    cutAndCompare(m.stroke, m.time, view, name, 150 + random() % 200, 2);
                    if (QTest::currentTestFailed())
                        return;
                }
            }
        tellReaches();
    }

    /// One segment becomes another one, or a node of the stroke moves.
    void singleSegments()
    {
        std::mt19937_64 random(12);
        std::uniform_real_distribution<float> u(0.5f, 1.5f);
        for (int trial = 0; trial < trials(60, 2000); ++trial) {
            const Style style = someStyles()[std::size_t(trial) % someStyles().size()];
            const Stroke s = penStroke(random, sheet.grown(-15), 500, 3, style, allVarieties[trial % 6]);
            const std::size_t k = 100 + random() % 300;
            Stroke t = s;
            std::vector<std::size_t> edited{k};
            switch (trial % 3) {
            case 0:
                t.segments[k].diffusion *= u(random);
                break;
            case 1:
                t.segments[k].density *= u(random);
                break;
            case 2: {
                const Offset to{s.segments[k].bezier[0].x + u(random), s.segments[k].bezier[0].y - u(random)};
                t.segments[k].bezier[0] = t.segments[k - 1].bezier[3] = to;
                edited.push_back(k - 1);
            }
            }
            const View view = someViews(sheet)[0];
            compare(s, t, edited, s.driesAt(), view, nameOf(style) + " trial " + QByteArray::number(trial));
            if (QTest::currentTestFailed())
                return;
            if (trial % 3 < 2) // no border moved, so it stays in its block
                QVERIFY(m_reaches.back() < longestBlock);
        }
        tellReaches();
    }

    /// What is lifted changes nothing but where it reaches, also where it cuts the stroke's last block short of
    /// growing.
    void lifts()
    {
        std::mt19937_64 random(13);
        int trial = 0;
        for (const Style &style : someStyles())
            for (const Varies what : allVarieties) {
                const Stroke s = penStroke(random, sheet.grown(-15), 400, 3, style, what);
                for (const Moment &m : momentsOf(s)) {
                    const int number = trial++;
                    if (!isTried(number))
                        continue;
                    Stroke lifted = m.stroke;
                    for (int chain = 0; chain < 3; ++chain)
                        liftAlong(lifted, {60.0 + 30 * chain, 50}, {80.0 + 30 * chain, 90}, 2.5, 1, 30);
                    const View view = someViews(sheet)[std::size_t(number % 3)];
                    const auto a =
                        buildNodes(m.stroke, m.time, zoomOctave(view.scale), visibleBox(PictureGrid::ofPicture(view)));
                    const auto b =
                        buildNodes(lifted, m.time, zoomOctave(view.scale), visibleBox(PictureGrid::ofPicture(view)));
                    QCOMPARE(groupsOnlyIn(*a, *b).size(), std::size_t(0));
                    compare(m.stroke, lifted, {}, m.time, view,
                            nameOf(style) + " varies " + QByteArray::number(int(what)) + " lifted");
                    if (QTest::currentTestFailed())
                        return;
                }
            }
    }

    void recordedStrokes_data()
    {
        QTest::addColumn<QString>("path");
        for (const char *path : {"ink/sensor_data.csv", "ink/digital_ink.json", "painting30sec.dat"})
            QTest::newRow(path) << QString::fromLatin1(path);
    }
    void recordedStrokes()
    {
        QFETCH(QString, path);
        const QString file = QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/") + path;
        if (!QFile::exists(file))
            QSKIP(qPrintable(QStringLiteral("../shared/data/%1 is missing").arg(path)));
        const auto p = loadPainting(file);
        QVERIFY2(p, p ? "" : qPrintable(p.error()));
        std::vector<StrokePtr> strokes(p->strokes.begin(), p->strokes.end());
        std::ranges::sort(strokes, std::greater{}, [](const StrokePtr &s) { return s->segments.size(); });
        std::mt19937_64 random(14);
        for (std::size_t i = 0; i < std::min<std::size_t>(strokes.size(), 6); ++i) {
            const Stroke &s = *strokes[i];
            if (s.segments.size() < 40)
                continue;
            const View view = View::ofArea(influenceOf(s, s.driesAt()), width, height);
            for (const Moment &m : momentsOf(s)) {
                const std::size_t where = s.segments.size() / 4 + random() % (s.segments.size() / 2);
                cutAndCompare(m.stroke, m.time, view, path.toLatin1(), where, 0.1 * length(lengthOf(m.stroke, where)));
                if (QTest::currentTestFailed())
                    return;
            }
        }
        QVERIFY(!m_reaches.empty());
        tellReaches();
    }

private:
    static Point lengthOf(const Stroke &s, std::size_t k)
    {
        const Cubic c = s.cubicOf(s.segments[k]);
        return c.p[3] - c.p[0];
    }
};

QTEST_GUILESS_MAIN(TestLocalEdits)
#include "test_local_edits.moc"

// Layers that are merged: whatever they and their neighbours do to the picture, it stays.
#include "tests/render/layers/grouped.h"

#include "app/session/commands/session_rows.h"
#include "app/session/current_layer.h"
#include "model/painting/validate.h"
#include "undo/history/order_tree.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/group_roles.h"
#include "undo/layers/merge_layers.h"

#include <QSignalSpy>

using namespace suffuse;
using namespace suffuse::test;

namespace {

const View sheet = View::ofArea(Rect::of(0, 0, 96, 72), 96, 72);

auto pictureOf(Renderer &renderer, const PaintingPtr &painting)
{
    return render(renderer, painting, sheet).rgba;
}

/// From bottom to top: a lantern in group 1, its shade in group 2.
PaintingPtr lantern()
{
    std::vector<Stroke> strokes;
    const Colour yellow{0, 0.9f, 0.1f, 0.9f}, blue{0.2f, 0.1f, 0.8f, 0.8f};
    for (StrokeId id = 1; id <= 4; ++id) {
        const Point at{20 + 12 * double(id), 20 + 8 * double(id)};
        strokes.push_back(
            stroke(id, Shape::Curved, at, 30, 5, styleOf(StyleKind::Uniform), {}, id < 3 ? yellow : blue));
        strokes.back().group = id < 3 ? 1 : 2;
    }
    auto result = std::make_shared<Painting>(*painting(std::move(strokes)));
    result->groups = {{1, "Lantern"}, {2, "Shade"}};
    return result;
}

} // namespace

class TestMergeLayers : public QObject {
    Q_OBJECT

private slots:
    void thePictureStays()
    {
        const std::unique_ptr<Renderer> renderer = make(Backend::Cpu, 1);
        std::mt19937_64 random(23);
        int merged = 0, kept = 0;
        for (int trial = 0; trial < 300; ++trial) {
            Document document;
            document.reset(grouped(painting(randomStrokes(random, 10, 96, 72)), random));
            const PaintingPtr before = document.painting();
            for (const Group &group : before->groups) {
                MergedDown result = mergeDown(document, group.id);
                if (result.why != NotMerged::Merged)
                    continue;
                document.exchange(result.edit);
                QCOMPARE(problemOf(*document.painting()), QString());
                QVERIFY(pictureOf(*renderer, document.painting()) == pictureOf(*renderer, before));
                document.exchange(result.edit);
                QVERIFY(*document.painting() == *before);
                ++merged;
                kept += result.keepsGroup;
            }
        }
        QVERIFY(merged > 300 && kept > 250 && merged - kept > 20);
    }

    void aClippedShadeStaysOnItsLantern_data()
    {
        QTest::addColumn<bool>("lowerIsFaint");
        QTest::newRow("plain") << false;
        QTest::newRow("faint") << true;
    }
    void aClippedShadeStaysOnItsLantern()
    {
        QFETCH(const bool, lowerIsFaint);
        OpenPainting open;
        Commands table;
        addSessionRows(table, open);
        Editor &editor = open.editor;
        QSignalSpy said(&table, &Commands::said);
        editor.document().reset(lantern());
        editor.push(setGroupBlend(editor.document(), {2}, BlendMode::Multiply), "mode");
        editor.push(setGroupOpacity(editor.document(), {2}, 0.7f), "opacity");
        editor.push(setGroupRole(editor.document(), {2}, GroupRole::Clipped, true), "clip");
        if (lowerIsFaint)
            editor.push(setGroupOpacity(editor.document(), {1}, 0.5f), "opacity");
        const PaintingPtr before = editor.document().painting();
        editor.layer().choose(2);
        table[Command::MergeLayerDown].trigger();
        QCOMPARE(editor.layer().group(), GroupId(1));
        QCOMPARE(int(said.count()), 1);
        QVERIFY(said.front().front().toString().contains("Shade"));
        const PaintingPtr after = editor.document().painting();
        QCOMPARE(after->findGroup(2)->parent, GroupId(1));
        QVERIFY(!after->findGroup(1)->isIsolated());
        const std::unique_ptr<Renderer> renderer = make(Backend::Cpu, 1);
        QVERIFY(pictureOf(*renderer, after) == pictureOf(*renderer, before));
        editor.undo();
        QVERIFY(*editor.document().painting() == *before);
        QCOMPARE(editor.layer().group(), GroupId(2));
    }

    /// What is not exported before is not exported then, and nothing else.
    void draftsStayDrafts_data()
    {
        QTest::addColumn<int>("draft");
        QTest::newRow("lower") << 1;
        QTest::newRow("upper") << 2;
    }
    void draftsStayDrafts()
    {
        QFETCH(const int, draft);
        auto painting = std::make_shared<Painting>(*lantern());
        painting->groups[std::size_t(draft) - 1].draft = true;
        Document document;
        document.reset(painting);
        MergedDown merged = mergeDown(document, 2);
        document.exchange(merged.edit);
        for (const StrokePtr &stroke : document.painting()->strokes) {
            const std::vector<GroupId> around = groupsAround(*document.painting(), stroke->group);
            const bool isDraft =
                std::ranges::any_of(around, [&](GroupId id) { return document.painting()->findGroup(id)->draft; });
            QCOMPARE(isDraft, painting->find(stroke->id)->group == GroupId(draft));
        }
    }

    void whatWouldChangeThePictureIsRefused()
    {
        Document document;
        document.reset(lantern());
        const auto change = [&](GroupId id, const std::function<void(Group &)> &change) {
            auto painting = std::make_shared<Painting>(*lantern());
            change(painting->groups[id - 1]);
            document.reset(painting);
            return mergeDown(document, 2).why;
        };
        QCOMPARE(change(1, [](Group &group) { group.clips = true; }), NotMerged::Clipped);
        QCOMPARE(change(1, [](Group &group) { group.mask = true; }), NotMerged::Mask);
        QCOMPARE(change(2, [](Group &group) { group.mask = true; }), NotMerged::Mask);
        QCOMPARE(change(1, [](Group &group) { group.solo = true; }), NotMerged::Hidden);
        auto painting = std::make_shared<Painting>(*lantern());
        Stroke light = *painting->strokes[0];
        light.id = 5, light.group = 3;
        painting->strokes.push_back(std::make_shared<const Stroke>(light));
        painting->groups.push_back({3, "Light"});
        painting->groups.back().clips = true;
        document.reset(painting);
        QCOMPARE(mergeDown(document, 2).why, NotMerged::ClippedTo);
        QCOMPARE(mergeDown(document, 3).why, NotMerged::Merged);
    }
};

QTEST_MAIN(TestMergeLayers)
#include "test_merge_layers.moc"

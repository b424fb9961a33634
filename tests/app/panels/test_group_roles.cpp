// What groups are to others, washes and tags, in the inspector: by events, as one step, and undone.
#include "app/panels/inspector/stroke_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/widgets/habits/house_rules.h"
#include "app/widgets/look/group_tags.h"
#include "app/widgets/look/section.h"
#include "model/painting/validate.h"
#include "model/painting/wash_groups.h"
#include "render/composition/composition.h"
#include "tests/app/group_bench.h"

#include <QSet>
#include <QTemporaryDir>

#include <random>

using namespace suffuse;

namespace {

/// Puts some strokes and groups into a group, at least one of them, on top of all that is there.
void grow(Painting &painting, GroupId around, int depth, std::mt19937 &random)
{
    const auto oneIn = [&](unsigned n) { return random() % n == 0; };
    for (unsigned left = 1 + random() % 3; left > 0; --left) {
        if (depth == 3 || oneIn(2)) {
            Stroke stroke = *makeStroke(StrokeId(painting.strokes.size() + 1), 1, 10);
            stroke.group = around;
            painting.strokes.push_back(std::make_shared<const Stroke>(stroke));
            continue;
        }
        Group &group = painting.groups.emplace_back();
        group.id = painting.groups.size(), group.parent = around;
        group.clips = oneIn(3), group.mask = oneIn(4);
        if (oneIn(4))
            group.wash = Wash();
        grow(painting, GroupId(painting.groups.size()), depth + 1, random);
    }
}

} // namespace

class TestGroupRoles : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        installHouseRules();
    }

    void aGroupIsClippedToWhatIsBelow()
    {
        Inspecting s;
        QCheckBox &box = *s.section().roleSwitch(GroupRole::Clipped);
        s.select({1, 2}); // the lowest of all
        QVERIFY(!box.isEnabled());
        QVERIFY(box.toolTip().contains("nothing below"));
        s.select({3, 4});
        QVERIFY(box.isEnabled() && !box.isChecked());
        QVERIFY(!box.toolTip().contains("nothing below"));
        s.clickRole(GroupRole::Clipped);
        QVERIFY(s.of(s.second).clips && !s.of(s.first).clips);
        QCOMPARE(s.steps(), 1);
        QVERIFY(box.isChecked());
        QVERIFY(!s.section().isolated()->isEnabled()); // It is isolated in any case.
        // Of both groups one can be clipped: the switch is about it alone.
        s.select({1, 2, 3, 4});
        QCOMPARE(box.checkState(), Qt::Checked);
        s.clickRole(GroupRole::Clipped);
        QVERIFY(!s.of(s.second).clips);
        s.clickRole(GroupRole::Clipped);
        QVERIFY(s.of(s.second).clips && !s.of(s.first).clips);
        // What is clipped or a mask is nothing to clip to.
        s.editor.push(setGroupRole(s.editor.document(), {s.first}, GroupRole::Mask, true), "mask");
        const GroupId third = s.group({5}, "third");
        s.select({5});
        QVERIFY(!box.isEnabled());
        s.editor.push(setGroupRole(s.editor.document(), {s.first}, GroupRole::Mask, false), "no mask");
        QTRY_VERIFY(box.isEnabled());
        s.clickRole(GroupRole::Clipped);
        QVERIFY(s.of(third).clips);
        // One that is clipped and has nothing below it any more can be let go.
        s.select({5});
        s.editor.push(arrangeSelection(s.editor.document(), Arrange::Bottom), "bottom");
        QTRY_VERIFY(box.isEnabled() && box.isChecked());
        s.clickRole(GroupRole::Clipped);
        QVERIFY(!s.of(third).clips);
        QTRY_VERIFY(!box.isEnabled());
    }

    /// What a group can be is what it is in the picture when it is made so.
    void rolesAreThoseOfThePicture()
    {
        std::mt19937 random(5);
        int clipped = 0, washes = 0, tried = 0;
        for (int trial = 0; trial < 300; ++trial) {
            Painting painting;
            grow(painting, 0, 0, random);
            QVERIFY2(problemOf(painting).isEmpty(), qPrintable(problemOf(painting)));
            const GroupRoles roles(painting);
            for (const Group &group : painting.groups) {
                Painting changed = painting;
                Group &one = changed.groups[group.id - 1];
                one.clips = true;
                const Composition composition = compositionOf(changed);
                const bool clips = std::ranges::any_of(composition.layers, [&](const Layer &layer) {
                    return layer.group == group.id && layer.clippedTo != Layer::none;
                });
                QCOMPARE(roles.canHave(group, GroupRole::Clipped), clips);
                one.wash = Wash();
                const auto inWashes = washesOf(changed);
                const auto wash = inWashes.find(group.id);
                const bool isWash = wash != inWashes.end() && wash->second == &one;
                QCOMPARE(roles.canHave(group, GroupRole::Wash), isWash);
                clipped += clips, washes += isWash, ++tried;
            }
        }
        QVERIFY(clipped > tried / 5 && clipped < tried * 4 / 5);
        QVERIFY(washes > tried / 5 && washes < tried);
    }

    void aGroupIsAMask()
    {
        Inspecting s;
        QCheckBox &box = *s.section().roleSwitch(GroupRole::Mask);
        s.select({1, 2});
        s.clickRole(GroupRole::Mask);
        QVERIFY(s.of(s.first).mask);
        QCOMPARE(s.steps(), 1);
        s.select({1, 2, 3, 4});
        QCOMPARE(box.checkState(), Qt::PartiallyChecked);
        s.clickRole(GroupRole::Mask);
        QVERIFY(s.of(s.first).mask && s.of(s.second).mask);
        QTRY_COMPARE(box.checkState(), Qt::Checked);
        s.editor.undo();
        QTRY_COMPARE(box.checkState(), Qt::PartiallyChecked);
        // Alone in a group it has nothing to mask.
        s.group({1, 2}, "around");
        s.select({1, 2});
        QVERIFY(box.isEnabled() && !box.isChecked());
        s.select({3, 4, 5, 6});
        s.editor.push(deleteSelection(s.editor.document()), "delete");
        s.select({1, 2});
        QVERIFY(!box.isEnabled());
        QVERIFY(box.toolTip().contains("nothing beside"));
    }

    void groupsAreTagged()
    {
        Inspecting s;
        QComboBox &box = *s.section().tag();
        QCOMPARE(box.count(), groupTags);
        s.select({1, 2});
        QCOMPARE(box.currentIndex(), int(GroupTag::None));
        chooseItem(box, int(GroupTag::Green));
        QCOMPARE(s.of(s.first).tag, GroupTag::Green);
        QCOMPARE(s.steps(), 1);
        s.select({1, 2, 3, 4});
        QCOMPARE(box.currentIndex(), -1);
        chooseItem(box, int(GroupTag::Blue));
        QCOMPARE(s.of(s.first).tag, GroupTag::Blue);
        QCOMPARE(s.of(s.second).tag, GroupTag::Blue);
        QCOMPARE(s.steps(), 2);
        s.editor.undo();
        QTRY_COMPARE(box.currentIndex(), -1);
        // Each mark has a colour that no other has.
        QSet<QRgb> colours;
        for (int tag = 1; tag < groupTags; ++tag)
            colours << colourOf(GroupTag(tag)).rgb();
        QCOMPARE(colours.size(), qsizetype(groupTags - 1));
    }

    void aWashBeginsLikeItsLowestStroke()
    {
        Inspecting s;
        const Style style{StyleKind::Feathering, {1.2f, 2, 0}};
        const Mix mix{MixMode::Beta, 0.3f};
        s.editor.push(
            changeStrokes(s.editor.document(), {1}, [&](Stroke &stroke) { stroke.style = style, stroke.mix = mix; }),
            "style");
        s.select({1, 2});
        WashRows &wash = *s.section().wash();
        QVERIFY(!wash.kind()->isVisible() && !wash.beta()->number()->isVisible());
        s.clickRole(GroupRole::Wash);
        QCOMPARE(s.steps(), 2);
        QVERIFY(s.of(s.first).wash == (Wash{style, mix}));
        QVERIFY(wash.kind()->isVisible() && wash.beta()->number()->isVisible());
        QCOMPARE(wash.kind()->currentIndex(), int(StyleKind::Feathering));
        QVERIFY(wash.xi(1)->number()->isVisible() && !wash.xi(2)->number()->isVisible());
        QCOMPARE(wash.xi(0)->number()->value().value(), double(style.xi[0]));
        QCOMPARE(wash.mode()->currentIndex(), int(MixMode::Beta));
        QCOMPARE(wash.beta()->number()->text(), QString("30 %"));
        // The strokes keep their own, which is not seen.
        const auto notesAreThere = [&] {
            return s.panel.findChild<StyleSection *>()->washNote()->isVisible() &&
                   s.panel.findChild<StrokeSection *>()->washNote()->isVisible();
        };
        QVERIFY(notesAreThere());
        s.select({1});
        QVERIFY(notesAreThere());
        s.select({1, 3});
        QVERIFY(!notesAreThere());
        s.select({1, 2});
        s.clickRole(GroupRole::Wash);
        QVERIFY(!s.of(s.first).wash);
        QVERIFY(!notesAreThere());
        QCOMPARE(s.stroke(1).style, style);
        // Within a wash there is no other.
        s.clickRole(GroupRole::Wash);
        s.select({1, 2, 5});
        const GroupId around = s.group({1, 2, 5}, "around");
        s.select({1, 2, 5});
        s.clickRole(GroupRole::Wash);
        QVERIFY(s.of(around).wash && s.of(s.first).wash);
        s.editor.push(setGroupRole(s.editor.document(), {s.first}, GroupRole::Wash, false), "no wash");
        s.select({1, 2});
        QVERIFY(!s.section().roleSwitch(GroupRole::Wash)->isEnabled());
        QVERIFY(s.section().roleSwitch(GroupRole::Wash)->toolTip().contains("already"));
    }

    void valuesOfWashesChange()
    {
        Inspecting s;
        s.select({1, 2, 3, 4});
        s.clickRole(GroupRole::Wash);
        WashRows &wash = *s.section().wash();
        const auto xi = [&](GroupId id, std::size_t i) { return s.of(id).wash->style.xi[i]; };
        s.select({1, 2});
        type(*wash.xi(0)->number(), "0.25");
        QCOMPARE(xi(s.first, 0), 0.25f);
        QCOMPARE(xi(s.second, 0), 0.5f);
        QCOMPARE(s.steps(), 2);
        QCOMPARE(s.editor.undoStack().undoText(), QString("Change wash"));
        // Mixed values change together, by a factor, in one step for all of a drag.
        s.select({1, 2, 3, 4});
        QVERIFY(!wash.xi(0)->number()->value());
        BarSlider &slider = *wash.xi(0)->slider();
        QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.5));
        for (const double share : {0.52, 0.55, 0.58})
            QTest::mouseMove(&slider, sliderPoint(slider, share));
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.58));
        QCOMPARE(s.steps(), 3);
        QVERIFY(xi(s.first, 0) > 0.26f);
        QVERIFY(std::abs(xi(s.second, 0) / xi(s.first, 0) - 2) < 1e-3f);
        type(*wash.xi(0)->number(), "*2"); // each from what it is
        QVERIFY(std::abs(xi(s.second, 0) / xi(s.first, 0) - 2) < 1e-3f);
        type(*wash.xi(0)->number(), "0.4");
        QCOMPARE(xi(s.first, 0), 0.4f);
        QCOMPARE(xi(s.second, 0), 0.4f);
        // Kind and mixing begin as they do for strokes.
        chooseItem(*wash.kind(), int(StyleKind::Edge));
        QVERIFY(s.of(s.first).wash->style == XiFields::defaultStyle(StyleKind::Edge));
        QTRY_VERIFY(wash.xi(2)->number()->isVisible());
        QVERIFY(!wash.beta()->number()->isEnabled());
        chooseItem(*wash.mode(), int(MixMode::Beta));
        QVERIFY(s.of(s.second).wash->mix == StrokeSection::usualMix(MixMode::Beta));
        QTRY_VERIFY(wash.beta()->number()->isEnabled());
        type(*wash.beta()->number(), "20");
        QCOMPARE(s.of(s.first).wash->mix.beta, 0.2f);
        // What would be no style for one of them is refused for all.
        const QByteArray before = hashOf(*s.editor.document().painting());
        type(*wash.beta()->number(), "*9");
        QCOMPARE(hashOf(*s.editor.document().painting()), before);
        QTRY_VERIFY(s.panel.hint()->isVisible());
        for (int i = s.steps(); i > 0; --i)
            s.editor.undo();
        QVERIFY(!s.of(s.first).wash && !s.of(s.second).wash);
        QTRY_VERIFY(!wash.kind()->isVisible());
    }

    void lockedGroupsStayAsTheyAre()
    {
        Inspecting s;
        Document &document = s.editor.document();
        s.editor.push(setGroupLocked(document, s.second, true), "lock");
        for (const GroupRole role : {GroupRole::Clipped, GroupRole::Mask, GroupRole::Wash})
            QVERIFY(setGroupRole(document, {s.second}, role, true).isEmpty());
        QVERIFY(setGroupTag(document, {s.second}, GroupTag::Red).isEmpty());
        QVERIFY(!setGroupRole(document, {s.first, s.second}, GroupRole::Wash, true).isEmpty());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestGroupRoles)
#include "test_group_roles.moc"

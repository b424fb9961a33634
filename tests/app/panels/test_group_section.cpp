// How groups blend, in the inspector and in the Strokes dock: what is there, by events, as one step, and undone.
#include "app/panels/inspector/stroke_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/widgets/habits/house_rules.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/blend_modes.h"
#include "app/widgets/numbers/number_field.h"
#include "model/painting/fields.h"
#include "tests/app/group_bench.h"

#include <QComboBox>
#include <QMenu>
#include <QScrollBar>
#include <QSet>
#include <QTemporaryDir>
#include <QTreeView>

using namespace suffuse;

class TestGroupSection : public QObject {
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

    /// The section is about groups: where anything else is selected, it is not there.
    void itIsThereForWholeGroups()
    {
        Inspecting s;
        const auto isThereFor = [&](std::set<StrokeId> strokes, std::set<SegmentRef> segments = {}) {
            s.select(std::move(strokes), std::move(segments));
            return s.section().isVisible();
        };
        QVERIFY(isThereFor({1, 2}));
        QCOMPARE(s.section().title()->text(), QString("Group"));
        QVERIFY(isThereFor({1, 2, 3, 4}));
        QCOMPARE(s.section().title()->text(), QString("Groups"));
        QVERIFY(!isThereFor({1}));
        QVERIFY(!isThereFor({1, 2, 5}));
        QVERIFY(!isThereFor({1, 2}, {{1, 0}}));
        QVERIFY(!isThereFor({}));
        QVERIFY(isThereFor({3, 4}));
        s.editor.push(ungroupSelection(s.editor.document()), "ungroup");
        QTRY_VERIFY(!s.section().isVisible());
        s.editor.undo();
        QTRY_VERIFY(s.section().isVisible());
    }

    void opacityIsTyped()
    {
        Inspecting s;
        s.select({1, 2});
        QCOMPARE(s.opacity().text(), QString("100 %"));
        type(s.opacity(), "60");
        QCOMPARE(s.of(s.first).opacity, 0.6f);
        QCOMPARE(s.of(s.second).opacity, 1.0f);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor.undoStack().undoText(), QString("Change group opacity"));
        type(s.opacity(), "60");
        QCOMPARE(s.steps(), 1); // nothing is changed by it
        type(s.opacity(), "130");
        QCOMPARE(s.of(s.first).opacity, 0.6f);
        QVERIFY(s.panel.hint()->text().contains("100"));
        s.editor.undo();
        QTRY_COMPARE(s.opacity().text(), QString("100 %"));
        QCOMPARE(s.of(s.first).opacity, 1.0f);
    }

    /// However many places it goes through, a drag is one step.
    void aDragIsOneStep()
    {
        Inspecting s;
        s.select({1, 2});
        BarSlider &slider = *s.section().opacity()->slider();
        const QByteArray before = hashOf(*s.editor.document().painting());
        QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.9));
        for (const double share : {0.8, 0.5, 0.3})
            QTest::mouseMove(&slider, sliderPoint(slider, share));
        QVERIFY(s.of(s.first).opacity < 0.4f);
        QVERIFY(s.of(s.first).opacity > 0.2f);
        QCOMPARE(s.steps(), 0); // It is not decided yet.
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.3));
        QCOMPARE(s.steps(), 1);
        s.editor.undo();
        QCOMPARE(hashOf(*s.editor.document().painting()), before);
        // One that is given up is none.
        QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.9));
        QTest::mouseMove(&slider, sliderPoint(slider, 0.5));
        QVERIFY(s.of(s.first).opacity < 1);
        QTest::keyClick(&slider, Qt::Key_Escape);
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.5));
        QCOMPARE(hashOf(*s.editor.document().painting()), before);
    }

    /// Each of several groups keeps what it has of its own.
    void severalGroupsChangeTogether()
    {
        Inspecting s;
        s.editor.push(setGroupOpacity(s.editor.document(), {s.first}, 0.5f), "half");
        s.select({1, 2, 3, 4});
        QVERIFY(!s.section().opacity()->number()->value()); // 50 % and 100 %
        BarSlider &slider = *s.section().opacity()->slider();
        QVERIFY(slider.isMixed());
        QTest::mousePress(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.5));
        QTest::mouseMove(&slider, sliderPoint(slider, 0.4));
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, sliderPoint(slider, 0.4));
        const float less = 1 - s.of(s.second).opacity;
        QVERIFY2(less > 0.05f && less < 0.5f, qPrintable(QString::number(double(less))));
        QVERIFY(std::abs(s.of(s.first).opacity - (0.5f - less)) < 1e-6f);
        QCOMPARE(s.steps(), 2);
        const QString made = s.opacity().text();
        QVERIFY2(made.startsWith(QStringLiteral("−")), qPrintable(made));
        s.editor.undo();
        QTRY_VERIFY(s.opacity().text() != made); // The change that is shown is forgotten with it.
        QCOMPARE(s.of(s.first).opacity, 0.5f);
        type(s.opacity(), "*0.5"); // each from what it is
        QCOMPARE(s.of(s.first).opacity, 0.25f);
        QCOMPARE(s.of(s.second).opacity, 0.5f);
        type(s.opacity(), "80"); // one value for all
        QCOMPARE(s.of(s.first).opacity, 0.8f);
        QCOMPARE(s.of(s.second).opacity, 0.8f);
    }

    void aModeIsChosen()
    {
        Inspecting s;
        s.select({1, 2});
        QCOMPARE(s.section().mode()->currentText(), QString("Normal"));
        s.choose(BlendMode::Multiply);
        QCOMPARE(s.of(s.first).blend, BlendMode::Multiply);
        QCOMPARE(s.of(s.second).blend, BlendMode::Normal);
        QCOMPARE(s.steps(), 1);
        QCOMPARE(s.editor.undoStack().undoText(), QString("Change group mode"));
        QTRY_VERIFY(s.section().mode()->toolTip().contains(tipOf(BlendMode::Multiply)));
        s.choose(BlendMode::Multiply);
        QCOMPARE(s.steps(), 1);
        s.select({1, 2, 3, 4});
        QCOMPARE(s.section().mode()->currentIndex(), -1); // Multiply and Normal
        s.choose(BlendMode::SourceAtop);
        QCOMPARE(s.of(s.first).blend, BlendMode::SourceAtop);
        QCOMPARE(s.of(s.second).blend, BlendMode::SourceAtop);
        QTRY_COMPARE(s.section().mode()->currentText(), nameOf(BlendMode::SourceAtop));
        s.editor.undo();
        s.editor.undo();
        QTRY_COMPARE(s.section().mode()->currentText(), QString("Normal"));
    }

    /// Each mode is in the list once, has a name of its own and says what it does.
    void allModesAreThere()
    {
        Inspecting s;
        const QComboBox &box = *s.section().mode();
        QSet<QString> names, tips;
        for (int mode = 0; mode < blendModes; ++mode) {
            const int at = box.findData(mode);
            QVERIFY2(at >= 0, WordsOf<BlendMode>::list[std::size_t(mode)].data());
            QCOMPARE(modeAt(box, at), BlendMode(mode));
            QVERIFY(!box.itemText(at).isEmpty());
            QVERIFY(box.itemData(at, Qt::ToolTipRole).toString().endsWith('.'));
            names << box.itemText(at);
            tips << box.itemData(at, Qt::ToolTipRole).toString();
        }
        QCOMPARE(names.size(), qsizetype(blendModes));
        QCOMPARE(tips.size(), qsizetype(blendModes));
        int items = 0;
        for (int i = 0; i < box.count(); ++i)
            items += box.itemData(i).isValid();
        QCOMPARE(items, blendModes); // The others are lines between families.
    }

    void theSwitchTellsWhatIsolates()
    {
        Inspecting s;
        QCheckBox &box = *s.section().isolated();
        s.select({1, 2});
        QVERIFY(box.isEnabled());
        QCOMPARE(box.checkState(), Qt::Unchecked);
        s.clickIsolated();
        QVERIFY(s.of(s.first).isolated && !s.of(s.second).isolated);
        QCOMPARE(box.checkState(), Qt::Checked);
        s.clickIsolated();
        QVERIFY(!s.of(s.first).isolated);
        QCOMPARE(s.steps(), 2);
        // Opacity and mode isolate in any case; the switch is what it was when they do not any more.
        const QString free = box.toolTip();
        type(s.opacity(), "60");
        QTRY_VERIFY(!box.isEnabled());
        QCOMPARE(box.checkState(), Qt::Checked);
        QVERIFY(box.toolTip() != free);
        s.clickIsolated();
        QCOMPARE(s.steps(), 3);
        type(s.opacity(), "100");
        QTRY_VERIFY(box.isEnabled());
        QCOMPARE(box.checkState(), Qt::Unchecked);
        s.choose(BlendMode::Screen);
        QTRY_VERIFY(!box.isEnabled());
        QCOMPARE(box.checkState(), Qt::Checked);
        // Of several the one that can be switched is.
        s.select({1, 2, 3, 4});
        QVERIFY(box.isEnabled());
        QCOMPARE(box.checkState(), Qt::PartiallyChecked);
        s.clickIsolated();
        QVERIFY(!s.of(s.first).isolated && s.of(s.second).isolated);
        QTRY_COMPARE(box.checkState(), Qt::Checked);
        s.clickIsolated();
        QVERIFY(!s.of(s.first).isolated && !s.of(s.second).isolated);
        QTRY_COMPARE(box.checkState(), Qt::PartiallyChecked);
    }

    void theWheelChangesNothingWithoutFocus()
    {
        Inspecting s;
        s.select({1, 2});
        const QByteArray before = hashOf(*s.editor.document().painting());
        s.panel.setFocus();
        for (QWidget *widget : QWidgetList{s.section().mode(), s.section().opacity()->slider(), &s.opacity()}) {
            QVERIFY(!widget->hasFocus());
            const QPointF at = widget->rect().center();
            QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(widget, &wheel);
            QVERIFY(!widget->hasFocus());
        }
        QCOMPARE(hashOf(*s.editor.document().painting()), before);
        QCOMPARE(s.steps(), 0);
    }

    /// The rows of groups tell what is not usual about them, as long as it is so.
    void rowsTellHowGroupsBlend()
    {
        GroupBench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {320, 400});
        const auto rowOf = [&](StrokeId id) { return panel.model()->indexOf(id).parent(); };
        const auto said = [&](StrokeId id) {
            const QModelIndex row = rowOf(id);
            const QString text = row.data(StrokesModel::MakeUpRole).toString();
            return row.data(Qt::AccessibleDescriptionRole).toString() == text &&
                           row.data(Qt::ToolTipRole).toString() == text
                       ? text
                       : QString("not the same everywhere");
        };
        const auto picture = [&] {
            QTreeView &view = *panel.view();
            return view.viewport()->grab(view.visualRect(panel.viewIndexOf(1).parent())).toImage();
        };
        QCOMPARE(said(1), QString());
        const QImage plain = picture();
        const auto push = [&](Edit edit) { bench.editor.push(std::move(edit), "blend"); };
        push(setGroupBlend(bench.editor.document(), {bench.first}, BlendMode::Multiply));
        QTRY_COMPARE(said(1), QString("Multiply"));
        push(setGroupOpacity(bench.editor.document(), {bench.first}, 0.6f));
        QTRY_COMPARE(said(1), QString("Multiply · 60 %"));
        QCOMPARE(said(3), QString());
        const QImage told = picture();
        const QRect end(told.width() / 2, 0, told.width() / 2, told.height()); // behind the name
        QVERIFY(plain.copy(end) != told.copy(end));
        const QRect name(0, 0, told.width() / 3, told.height());
        QCOMPARE(told.copy(name), plain.copy(name));
        push(setGroupBlend(bench.editor.document(), {bench.first}, BlendMode::Normal));
        QTRY_COMPARE(said(1), QString("60 %"));
        push(setGroupOpacity(bench.editor.document(), {bench.first}, 1));
        push(setGroupIsolated(bench.editor.document(), {bench.first}, true));
        QTRY_COMPARE(said(1), QString("mixes by itself"));
        for (int i = 0; i < 5; ++i)
            bench.editor.undo();
        QTRY_COMPARE(said(1), QString());
        QTRY_COMPARE(picture(), plain);
    }

    /// What is said about a group gives way to its name.
    void theNameComesFirst()
    {
        GroupBench bench;
        const QString name = "A name that is as long as the row of the dock is wide";
        bench.editor.push(renameGroup(bench.editor.document(), bench.first, name), "name");
        StrokesPanel panel(bench.editor);
        showAt(panel, {280, 400});
        const auto picture = [&] {
            QTreeView &view = *panel.view();
            return view.viewport()->grab(view.visualRect(panel.viewIndexOf(1).parent())).toImage();
        };
        const QImage before = picture();
        bench.editor.push(setGroupBlend(bench.editor.document(), {bench.first}, BlendMode::Luminosity), "blend");
        const QModelIndex row = panel.model()->indexOf(1).parent();
        QTRY_COMPARE(row.data(Qt::ToolTipRole).toString(), QString("Luminosity"));
        QCOMPARE(picture(), before);
    }

    void theMenuOfARowSwitches()
    {
        GroupBench bench;
        StrokesPanel panel(bench.editor);
        showAt(panel, {320, 400});
        const auto withAction = [&](auto act) {
            QMenu menu;
            panel.fillMenu(menu, panel.viewIndexOf(1).parent());
            for (QAction *action : menu.actions())
                if (action->text().remove('&') == "Mix by Itself")
                    return act(*action);
            return false;
        };
        const auto trigger = [](QAction &action) {
            action.trigger();
            return action.isEnabled();
        };
        const auto isOn = [](QAction &action) { return action.isChecked(); };
        const auto isFree = [](QAction &action) { return action.isEnabled(); };
        QVERIFY(!withAction(isOn) && withAction(isFree));
        QVERIFY(withAction(trigger));
        QVERIFY(bench.of(bench.first).isolated && !bench.of(bench.second).isolated);
        QVERIFY(withAction(isOn));
        QVERIFY(withAction(trigger));
        QVERIFY(!bench.of(bench.first).isolated);
        QCOMPARE(bench.steps(), 2);
        bench.editor.push(setGroupBlend(bench.editor.document(), {bench.first}, BlendMode::Hue), "hue");
        QVERIFY(withAction(isOn) && !withAction(isFree));
        bench.editor.undo();
        bench.editor.push(setGroupLocked(bench.editor.document(), bench.first, true), "lock");
        QVERIFY(!withAction(isOn) && !withAction(isFree));
    }

    /// What one looks at stays where it is, though rows above it come and go with the selection and the values.
    void theInspectorKeepsItsPlace()
    {
        Inspecting s;
        s.panel.resize(290, 300);
        s.select({5});
        auto &scroll = *s.panel.findChild<PanelScroll *>();
        const auto top = [&](const QWidget *widget) {
            QTest::qWait(5);
            return widget->mapTo(&scroll, QPoint()).y();
        };
        const auto scrollTo = [&](const QWidget *widget, int below) {
            QTest::qWait(5);
            scroll.verticalScrollBar()->setValue(widget->mapTo(scroll.widget(), QPoint()).y() + below);
        };
        const QWidget *style = s.panel.styleSection(), *strokes = s.panel.strokeSection();
        scrollTo(style, 3);
        const int before = top(style);
        QCOMPARE(before, -3);
        const int height = scroll.widget()->height();
        s.select({1, 2}); // a group has a section more, above all others
        QCOMPARE(top(style), before);
        QVERIFY(scroll.widget()->height() > height + 20);
        s.select({5}, {{5, 1}});
        QCOMPARE(top(style), before);
        s.select({}); // The canvas has a page of its own.
        QTest::qWait(5);
        QCOMPARE(scroll.verticalScrollBar()->value(), 0);
        s.select({1, 2});
        QCOMPARE(top(style), before);
        s.select({5});
        scrollTo(strokes, -20);
        const int below = top(strokes);
        emit s.panel.styleSection()->kind()->activated(int(StyleKind::Edge)); // which has a number more
        QCOMPARE(top(strokes), below);
        scroll.verticalScrollBar()->setValue(0); // Whoever is at the beginning stays there.
        s.select({1, 2});
        QTest::qWait(5);
        QCOMPARE(scroll.verticalScrollBar()->value(), 0);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestGroupSection)
#include "test_group_section.moc"

// The fill in the inspector: switched on and off, its values, and what is selected of several strokes.
#include "app/panels/inspector/figures/cross_section_plot.h"
#include "app/panels/inspector/figures/density_plot.h"
#include "app/panels/inspector/figures/figures_section.h"
#include "app/panels/inspector/fill_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/rows/gradient_rows.h"
#include "app/panels/inspector/segment_section.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/number_field.h"
#include "model/area/outline.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"

#include <QCheckBox>
#include <QComboBox>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestFillSection : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void theSwitchFillsAndEmpties()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        FillSection &section = *panel.fillSection();
        bench.select({1, 2});
        QCOMPARE(section.filled()->checkState(), Qt::Unchecked);
        QVERIFY(!section.colour()->isVisible());
        QTest::mouseClick(section.filled(), Qt::LeftButton, {}, {8, section.filled()->height() / 2});
        QCOMPARE(bench.steps(), 1);
        QVERIFY(bench.stroke(1).fill && bench.stroke(2).fill && !bench.stroke(3).fill);
        QVERIFY(section.colour()->isVisible());
        QVERIFY(!section.row(&Fill::diffusion)->number()->value()); // 10 and 20
        bench.select({2, 3});
        QCOMPARE(section.filled()->checkState(), Qt::PartiallyChecked);
        QTest::mouseClick(section.filled(), Qt::LeftButton, {}, {8, section.filled()->height() / 2});
        QVERIFY(bench.stroke(2).fill && bench.stroke(3).fill); // what is partly so becomes so
        QTest::mouseClick(section.filled(), Qt::LeftButton, {}, {8, section.filled()->height() / 2});
        QVERIFY(!bench.stroke(2).fill && !bench.stroke(3).fill);
        QCOMPARE(bench.steps(), 3);
    }

    void gradientsAreAddedTurnedAndRemoved()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        FillSection &section = *panel.fillSection();
        GradientRows &gradient = *section.gradient();
        bench.select({1, 2});
        bench.editor.push(addFills(bench.editor.document(), {1, 2}), "fill");
        const Colour colour = bench.stroke(1).fill->colour;
        QVERIFY(gradient.addButton()->isVisible() && !gradient.colour()->isVisible());
        gradient.addButton()->click();
        QVERIFY(bench.stroke(1).fill->gradient && bench.stroke(2).fill->gradient);
        QCOMPARE(bench.stroke(1).fill->colour, colour);
        QCOMPARE(bench.stroke(1).fill->gradient->colour.opacity, 0.0f);
        const Rect box = outlineBox(bench.stroke(1));
        QCOMPARE(bench.stroke(1).fill->gradient->from.x, float(box.left));
        QCOMPARE(bench.stroke(1).fill->gradient->to.x, float(box.right));
        QVERIFY(!gradient.addButton()->isVisible() && gradient.colour()->isVisible());
        NumberField &red = *gradient.colour()->row(ColourRows::Red)->number();
        red.setFocus();
        red.selectAll();
        QTest::keyClicks(&red, "25");
        QTest::keyClick(&red, Qt::Key_Return);
        QCOMPARE(bench.stroke(1).fill->gradient->colour.red, 0.25f);
        QCOMPARE(bench.stroke(2).fill->gradient->colour.red, 0.25f);
        QCOMPARE(bench.stroke(1).fill->colour, colour);
        gradient.swapButton()->click();
        QCOMPARE(bench.stroke(1).fill->gradient->colour, colour);
        QCOMPARE(bench.stroke(1).fill->colour.red, 0.25f);
        gradient.removeButton()->click();
        QVERIFY(!bench.stroke(1).fill->gradient && !bench.stroke(2).fill->gradient);
        QCOMPARE(bench.steps(), 5);
    }

    /// What is meant stands first: of a fill alone the fill.
    void theFillOfAFillAloneStandsFirst()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        bench.select({1});
        bench.editor.push(addFills(bench.editor.document(), {1}), "fill");
        const auto isFirst = [&] { return panel.fillSection()->y() < panel.segmentSection()->y(); };
        QVERIFY(!isFirst());
        const std::vector<SegmentRef> all{{1, 0}, {1, 1}, {1, 2}, {1, 3}};
        bench.editor.push(changeSegments(bench.editor.document(), all, [](Segment &s) { s.density = 0; }), "bare");
        QTRY_VERIFY(isFirst());
        bench.editor.undo();
        QTRY_VERIFY(!isFirst());
    }

    /// Whichever section stands first, Tab goes down the panel as it is seen.
    void tabGoesThroughTheSectionsAsTheyStand()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1800});
        const auto stops = [&] { // by Tab, in its order
            QWidgetList found;
            for (QWidget *w = panel.nextInFocusChain(); w != &panel; w = w->nextInFocusChain())
                if (panel.isAncestorOf(w) && w->isVisible() && w->isEnabled() && !w->focusProxy() &&
                    (w->focusPolicy() & Qt::TabFocus))
                    found << w;
            return found;
        };
        const auto goesDown = [&] {
            const QWidgetList all = stops();
            for (qsizetype i = 1; i < all.size(); ++i) {
                const QPoint from = all[i - 1]->mapTo(&panel, all[i - 1]->rect().center());
                const QPoint to = all[i]->mapTo(&panel, all[i]->rect().center());
                constexpr int row = 8; // within which centres stand beside each other
                if (to.y() < from.y() - row || (std::abs(to.y() - from.y()) <= row && to.x() <= from.x()))
                    return false;
            }
            return all.size() > 10 && all.contains(panel.alongButton());
        };
        const auto isFirst = [&] { return panel.fillSection()->y() < panel.segmentSection()->y(); };
        bench.select({1});
        bench.editor.push(addFills(bench.editor.document(), {1}), "fill");
        QTRY_VERIFY(!isFirst() && goesDown());
        const qsizetype count = stops().size();
        const std::vector<SegmentRef> all{{1, 0}, {1, 1}, {1, 2}, {1, 3}};
        bench.editor.push(changeSegments(bench.editor.document(), all, [](Segment &s) { s.density = 0; }), "bare");
        QTRY_VERIFY(isFirst());
        QTRY_VERIFY(goesDown());
        bench.editor.undo();
        QTRY_VERIFY(!isFirst());
        QTRY_VERIFY(goesDown());
        QCOMPARE(stops().size(), count);
    }

    /// A shape without an outline is painted by its fill alone: no figure and no warning speaks of paint that is not
    /// there.
    void anOutlineWithoutPaintIsNoFault()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        FiguresSection &figures = *panel.figuresSection();
        const auto bare = [](Segment &segment) { segment.density = 0; };
        bench.select({1});
        const std::vector<SegmentRef> all{{1, 0}, {1, 1}, {1, 2}, {1, 3}};
        bench.editor.push(changeSegments(bench.editor.document(), all, bare), "bare");
        QVERIFY(figures.warnings()->text().startsWith("Density 0") && !figures.fillAlone()->isVisible());
        QTest::mouseClick(panel.fillSection()->filled(), Qt::LeftButton, {}, {8, 8});
        QVERIFY(bench.stroke(1).fill);
        QVERIFY(!figures.warnings()->isVisible() && figures.fillAlone()->isVisible());
        QVERIFY(!figures.crossSection()->isVisible() && !figures.densityPlot()->isVisible());
        QVERIFY(!figures.figure(2)->isVisible());
        bench.select({1, 2});
        QVERIFY(!figures.fillAlone()->isVisible() && figures.densityPlot()->isVisible());
        QVERIFY(figures.figure(2)->isVisible());
    }

    /// After an undo the slider of what differs stands in the middle again, or a touch would do the change once more.
    void anUndoneChangeIsForgotten()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        bench.select({1, 2});
        bench.editor.push(addFills(bench.editor.document(), {1, 2}), "fill");
        for (SliderField *row :
             {panel.fillSection()->row(&Fill::diffusion), panel.fillSection()->row(&Fill::density)}) {
            bench.editor.push(changeFills(bench.editor.document(), *bench.editor.document().painting(), {2},
                                          [](Fill &now, const Fill &) { now.density += 1; }),
                              "other");
            BarSlider *slider = row->slider();
            QTRY_VERIFY(slider->isMixed());
            const auto before = bench.editor.document().painting();
            QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() / 2, 11});
            QTest::mouseMove(slider, {slider->width() * 3 / 4, 11});
            QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() * 3 / 4, 11});
            const QString made = row->number()->text();
            QVERIFY(made.startsWith(QStringLiteral("×")) && bench.editor.document().painting() != before);
            bench.editor.undo();
            QTRY_COMPARE(row->number()->text(), QString("×1.00"));
            QCOMPARE(slider->value(), BarSlider::steps / 2);
            bench.editor.redo();
            QTRY_COMPARE(row->number()->text(), made);
            bench.editor.undo();
        }
    }

    void numbersChangeTheFillAlone()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 1400});
        FillSection &section = *panel.fillSection();
        bench.select({1, 2});
        QTest::mouseClick(section.filled(), Qt::LeftButton, {}, {8, section.filled()->height() / 2});
        const Stroke before = bench.stroke(1);
        type(*section.row(&Fill::density)->number(), "2.5");
        QCOMPARE(bench.stroke(1).fill->density, 2.5f);
        QCOMPARE(bench.stroke(2).fill->density, 2.5f);
        type(*section.row(&Fill::diffusion)->number(), "0"); // A crisp edge is a value, and the slider leads back.
        QCOMPARE(bench.stroke(1).fill->diffusion, 0.0f);
        QCOMPARE(bench.stroke(2).fill->diffusion, 0.0f);
        bench.editor.undo();
        type(*section.row(&Fill::diffusion)->number(), "*2"); // each from what it is
        QCOMPARE(bench.stroke(1).fill->diffusion, 20.0f);
        QCOMPARE(bench.stroke(2).fill->diffusion, 40.0f);
        type(*section.colour()->row(ColourRows::Blue)->number(), "75");
        QCOMPARE(bench.stroke(1).fill->colour.blue, 0.75f);
        section.rule()->setCurrentIndex(1);
        emit section.rule()->activated(1);
        QCOMPARE(bench.stroke(2).fill->rule, FillRule::EvenOdd);
        QVERIFY(bench.stroke(1).segments == before.segments);
        QCOMPARE(bench.steps(), 5);
        bench.editor.undoStack().undo();
        QCOMPARE(section.rule()->currentIndex(), 0);
    }

    void aCommandFills()
    {
        Session s;
        s.paintLine({200, 200}, {400, 260});
        const StrokeId id = s.painting().strokes.front()->id;
        s.editor().document().setSelection({{id}, {}});
        QVERIFY(s.window.action(Command::FillStrokes).isEnabled());
        QVERIFY(!s.window.action(Command::RemoveFills).isEnabled());
        s.use(Command::FillStrokes);
        QVERIFY(s.painting().find(id)->fill);
        QVERIFY(!s.window.action(Command::FillStrokes).isEnabled());
        QVERIFY(s.window.action(Command::AddGradients).isEnabled());
        QVERIFY(!s.window.action(Command::RemoveGradients).isEnabled());
        s.use(Command::AddGradients); // as the inspector's button does
        QVERIFY(s.painting().find(id)->fill->gradient);
        QCOMPARE(s.editor().undoText(), QString("Add gradient"));
        QVERIFY(!s.window.action(Command::AddGradients).isEnabled());
        s.use(Command::RemoveGradients);
        QVERIFY(s.painting().find(id)->fill && !s.painting().find(id)->fill->gradient);
        s.use(Command::RemoveFills);
        QVERIFY(!s.painting().find(id)->fill);
        QVERIFY(!s.window.action(Command::AddGradients).isEnabled());
        QCOMPARE(s.editor().undoStack().count(), 5);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestFillSection)
#include "test_fill_section.moc"

// Values that differ along strokes keep what varies: sliders and the curve along the stroke, by events, as one step,
// and given up.
#include "app/dialogs/vary_dialog.h"
#include "app/panels/brushes/brush_menu.h"
#include "app/panels/inspector/along/along_dialog.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/inspector/stroke_section.h"
#include "app/session/commands/restyling.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/eyedropper_tool.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/numbers/number_field.h"
#include "model/brush/stroke_builder.h"
#include "tests/app/panel_bench.h"
#include "tests/app/scaled.h"
#include "tests/app/shapes.h"

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// A bench with a stroke of id 9 that a pen has painted, selected; its D and φ differ from segment to segment.
struct PenBench : Bench {
    PenBench()
    {
        std::vector<PenSample> samples;
        for (int i = 0; i <= 100; ++i) {
            const double u = i / 100.0;
            samples.push_back({{50 + 300 * u, 200 + 20 * std::sin(5 * u)},
                               Microseconds(i) * 8000,
                               float(0.2 + 0.7 * std::sin(3 * u))});
        }
        auto stroke = std::make_shared<Stroke>(*buildStroke(*findBrush("brush-pen"), 9, samples));
        for (std::size_t k = 0; k < stroke->segments.size(); ++k)
            stroke->segments[k].colour.red = float(0.2 + 0.6 * double(k) / double(stroke->segments.size()));
        editor.push(addStrokes(editor.document(), {stroke}, true), "stroke");
        editor.undoStack().clear();
    }
    const Stroke &pen() { return stroke(9); }
};

} // namespace

class TestMixedValues : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("vary"); }

    void aSliderScalesWhatDiffers()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        SliderField *density = panel.segmentSection()->density();
        BarSlider *slider = density->slider();
        QVERIFY(slider->isMixed());
        QCOMPARE(slider->value(), BarSlider::steps / 2); // the handle stands in the middle
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
        QVERIFY(bench.pen() == before); // a touch changes nothing
        for (const double share : {0.2, 0.9, 0.6})
            QTest::mouseMove(slider, sliderPoint(*slider, share));
        QVERIFY(density->change());
        const double factor = density->change()->amount;
        QVERIFY(factor > 1.4 && factor < 1.8);
        const QString says = QStringLiteral("×") + QLocale().toString(factor, 'f', 2);
        QCOMPARE(density->number()->text(), says);
        QVERIFY(areScaled(before, bench.pen(), &Segment::density, factor)); // what varies is kept
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.6));
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(density->number()->text(), says); // and after the drag
        QVERIFY(slider->isMixed());
        for (std::size_t k = 0; k < before.segments.size(); ++k)
            QCOMPARE(bench.pen().segments[k].diffusion, before.segments[k].diffusion);
        bench.select({1});
        bench.select({9});
        QCOMPARE(density->number()->text(), QString("—"));
        QCOMPARE(slider->value(), BarSlider::steps / 2);
        bench.editor.undo();
        QVERIFY(bench.pen() == before);
    }

    /// Wherever it is, and a slight drag changes slightly; nothing is thinned out of sight unless one drags far.
    void aTouchOfTheBarChangesNothing()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        SliderField *density = panel.segmentSection()->density();
        BarSlider *slider = density->slider();
        QVERIFY(slider->toolTip().contains("multiplies each of them"));
        QVERIFY(!slider->statusTip().isEmpty() && !density->number()->statusTip().isEmpty());
        for (const double share : {0.02, 0.3, 0.98}) {
            const QPoint at = sliderPoint(*slider, share);
            QTest::mousePress(slider, Qt::LeftButton, {}, at);
            QVERIFY(bench.pen() == before);
            QTest::mouseMove(slider, at - QPoint(2, 0));
            QVERIFY(density->change() && density->change()->amount > 0.8 && density->change()->amount < 1);
            QTest::mouseMove(slider, at);
            QTest::mouseRelease(slider, Qt::LeftButton, {}, at);
            QVERIFY(bench.pen() == before);
            QCOMPARE(bench.steps(), 0);
        }
        QTest::mouseClick(slider, Qt::LeftButton, Qt::ControlModifier, sliderPoint(*slider, 0.3)); // one value for all
        QVERIFY(!slider->isMixed());
        bench.editor.undo();
        QVERIFY(bench.pen() == before);
    }

    /// A drag is about what was selected at the press: what comes to be selected meanwhile keeps its values.
    void anotherSelectionEndsTheDrag()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke other = bench.stroke(1);
        BarSlider *slider = panel.segmentSection()->density()->slider();
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
        QTest::mouseMove(slider, sliderPoint(*slider, 0.7));
        const Stroke dragged = bench.pen();
        bench.select({1, 9});
        QTRY_VERIFY(!slider->isSliderDown());
        QCOMPARE(bench.steps(), 1);
        QTest::mouseMove(slider, sliderPoint(*slider, 0.9));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.9));
        QVERIFY(bench.stroke(1) == other && bench.pen() == dragged);
        QCOMPARE(bench.steps(), 1);
    }

    /// The handle stays where it was let go, and goes on from there; back in the middle nothing has changed.
    void aSecondDragGoesOn()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        SliderField *field = panel.segmentSection()->diffusion();
        BarSlider *slider = field->slider();
        const auto drag = [&](double from, double to) {
            QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, from));
            slider->setSliderPosition(int(to * BarSlider::steps));
            QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, to));
        };
        drag(0.5, 0.7);
        const double first = field->change()->amount;
        QVERIFY(first > 2);
        drag(double(slider->value()) / BarSlider::steps, 0.8);
        QVERIFY(areScaled(before, bench.pen(), &Segment::diffusion, field->change()->amount));
        QVERIFY(field->change()->amount > first);
        drag(double(slider->value()) / BarSlider::steps, 0.5);
        QVERIFY(bench.pen() == before); // to the last bit
        bench.editor.undo();
        bench.editor.undo();
        QVERIFY(areScaled(before, bench.pen(), &Segment::diffusion, first));
        QTRY_COMPARE(field->change()->amount, first); // An undo shows the change that is there now.
        QCOMPARE(field->number()->text(), QStringLiteral("×") + QLocale().toString(first, 'f', 2));
        // Somebody else changes the values: the handle is in the middle again.
        bench.editor.push(changeSegments(bench.editor.document(), targetSegments(bench.editor.document()),
                                         [](Segment &segment) { segment.diffusion += 1; }),
                          "other");
        QTRY_COMPARE(slider->value(), BarSlider::steps / 2);
        QCOMPARE(field->number()->text(), QString("—"));
    }

    /// The field says how the values stand to those from which the change counts, after an undo and a redo, too.
    void undoAndRedoKeepTheRelation()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        for (SliderField *field :
             {panel.segmentSection()->density(), panel.segmentSection()->colour()->row(ColourRows::Red)}) {
            const Stroke before = bench.pen();
            BarSlider *slider = field->slider();
            QVERIFY(slider->isMixed());
            QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
            QTest::mouseMove(slider, sliderPoint(*slider, 0.3));
            QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.3));
            const QString made = field->number()->text();
            const int at = slider->value();
            QVERIFY(made.startsWith(QStringLiteral("×0")) || made.startsWith(QStringLiteral("−")));
            const Stroke after = bench.pen();
            QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, double(at) / BarSlider::steps));
            slider->setSliderPosition(int(0.6 * BarSlider::steps));
            QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.6));
            const QString second = field->number()->text();
            QVERIFY(second != made);
            bench.editor.undo();
            QTRY_COMPARE(field->number()->text(), made);
            QCOMPARE(slider->value(), at);
            bench.editor.undo();
            QVERIFY(bench.pen() == before);
            const bool ratio = field == panel.segmentSection()->density();
            QTRY_COMPARE(field->number()->text(), ratio ? QStringLiteral("×1.00") : QStringLiteral("+0 %"));
            QCOMPARE(slider->value(), BarSlider::steps / 2);
            bench.editor.redo();
            QTRY_COMPARE(field->number()->text(), made);
            QVERIFY(bench.pen() == after);
            bench.editor.redo();
            QTRY_COMPARE(field->number()->text(), second);
            bench.editor.undo();
            bench.editor.undo();
        }
    }

    void sharesAreAddedTo()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        SliderField *red = panel.segmentSection()->colour()->row(ColourRows::Red);
        BarSlider *slider = red->slider();
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
        QTest::mouseMove(slider, sliderPoint(*slider, 0.9)); // some are at the limit, and come back
        QTest::mouseMove(slider, sliderPoint(*slider, 0.6));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.6));
        const double by = red->change()->amount;
        QVERIFY(by > 0.05 && by < 0.15);
        QVERIFY2(red->number()->text().startsWith('+') && red->number()->text().endsWith('%'),
                 qPrintable(red->number()->text()));
        for (std::size_t k = 0; k < before.segments.size(); ++k)
            QVERIFY(std::abs(double(bench.pen().segments[k].colour.red - before.segments[k].colour.red) - by) < 1e-6);
        QCOMPARE(bench.steps(), 1);
    }

    void controlMakesThemOne()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        SliderField *density = panel.segmentSection()->density();
        BarSlider *slider = density->slider();
        for (const double share : {0.5, 0.4}) { // in the middle, too, where the handle stands for something else
            QTest::mouseClick(slider, Qt::LeftButton, Qt::ControlModifier, sliderPoint(*slider, share));
            const float first = bench.pen().segments.front().density;
            for (const Segment &s : bench.pen().segments)
                QCOMPARE(s.density, first);
            QVERIFY(!slider->isMixed());
            QVERIFY(std::abs(slider->value() - share * BarSlider::steps) < 12);
            bench.editor.undo();
            QTRY_VERIFY(slider->isMixed());
        }
        type(*density->number(), "12"); // as a number does
        QCOMPARE(bench.pen().segments[7].density, 12.0f);
        QVERIFY(!density->change());
    }

    void theLabelStillResets()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        QTest::mouseDClick(panel.segmentSection()->density()->label(), Qt::LeftButton);
        QCOMPARE(bench.pen().segments[7].density, Segment{}.density);
    }

    void keysGiveTheDragUp()
    {
        for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_Delete}) {
            PenBench bench;
            InspectorPanel panel(bench.editor);
            showAt(panel);
            const Stroke before = bench.pen();
            SliderField *density = panel.segmentSection()->density();
            BarSlider *slider = density->slider();
            QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
            QTest::mouseMove(slider, sliderPoint(*slider, 0.8));
            QVERIFY(!(bench.pen() == before));
            QTest::keyClick(slider, key);
            QVERIFY(bench.pen() == before);
            QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.8));
            QCOMPARE(bench.steps(), 0);
            QTRY_COMPARE(slider->value(), BarSlider::steps / 2);
            QCOMPARE(density->number()->text(), QString("—"));
        }
    }

    void arrowKeysChangeEach()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        NumberField *density = panel.segmentSection()->density()->number();
        density->setFocus();
        for (int i = 0; i < 2; ++i)
            QTest::keyClick(density, Qt::Key_Up);
        QVERIFY(areScaled(before, bench.pen(), &Segment::density, 1.21));
        QCOMPARE(bench.steps(), 1); // keys that follow each other are one step
        NumberField *red = panel.segmentSection()->colour()->row(ColourRows::Red)->number();
        red->setFocus();
        QTest::keyClick(red, Qt::Key_Down);
        QVERIFY(std::abs(double(bench.pen().segments[3].colour.red - before.segments[3].colour.red) + 0.01) < 1e-6);
    }

    void severalStrokesKeepTheirDifference()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2, 3});
        for (const bool beta : {false, true}) {
            if (beta)
                bench.editor.push(changeStrokes(bench.editor.document(), {1, 2, 3},
                                                [](Stroke &s) {
                                                    s.mix = {MixMode::Beta, 0.2f * float(s.id)};
                                                }),
                                  "beta");
            SliderField *field = beta ? panel.strokeSection()->beta() : panel.segmentSection()->diffusion();
            BarSlider *slider = field->slider();
            QTRY_VERIFY(slider->isMixed());
            QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
            QTest::mouseMove(slider, sliderPoint(*slider, 0.6));
            QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.6));
            const double amount = field->change()->amount;
            for (const StrokeId id : {1, 2, 3})
                if (beta)
                    QVERIFY(std::abs(double(bench.stroke(id).mix.beta) - (0.2 * double(id) + amount)) < 1e-6);
                else
                    QVERIFY(std::abs(double(bench.stroke(id).segments[2].diffusion) - 10 * double(id) * amount) < 1e-3);
        }
    }

    void birthsMoveTogether()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.editor.push(changeStrokes(bench.editor.document(), {1, 2, 3},
                                        [](Stroke &stroke) {
                                            for (Segment &s : stroke.segments)
                                                s.born = Microseconds(stroke.id) * 1'000'000;
                                        }),
                          "born");
        bench.select({1, 2});
        SliderField *born = panel.segmentSection()->born();
        BarSlider *slider = born->slider();
        QTRY_VERIFY(slider->isMixed());
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.5));
        for (const double share : {0.1, 0.7})
            QTest::mouseMove(slider, sliderPoint(*slider, share));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.7));
        QVERIFY(bench.stroke(1).born() > 2'000'000);
        QCOMPARE(bench.stroke(2).born() - bench.stroke(1).born(), Microseconds(1'000'000));
        QCOMPARE(bench.stroke(3).born(), Microseconds(3'000'000));
        QVERIFY(born->number()->text().startsWith('+'));
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, double(slider->value()) / BarSlider::steps));
        slider->setSliderPosition(0);
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0));
        QCOMPARE(bench.stroke(1).born(), Microseconds(0)); // not before the painting
        QCOMPARE(bench.stroke(2).born(), Microseconds(1'000'000));
    }

    void alongTheStrokeShowsWhatIsThere()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const Stroke before = bench.pen();
        AlongDialog dialog(bench.editor, &panel);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        const PlaceCurve present = dialog.curve()->curve();
        QVERIFY(present.isPoints() && present.knots.size() > 2 && present.knots.size() < 40);
        // The curve runs through the values that there are.
        QVERIFY(dialog.end()->value() && std::abs(*dialog.end()->value() / before.segments.back().density - 1) < 0.2);
        QVERIFY(bench.pen() == before); // looking changes nothing

        // A point is moved: what lies far from it stays to the last bit.
        CurveEditor &curve = *dialog.curve();
        const QPointF point(present.places[1], present.knots[1]);
        QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget(point).toPoint());
        QTest::mouseMove(&curve, curve.toWidget(point + QPointF(0, 0.1)).toPoint());
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget(point + QPointF(0, 0.1)).toPoint());
        QVERIFY(!(bench.pen() == before));
        QCOMPARE(bench.pen().segments.back(), before.segments.back());
        // A press on the curve makes a point, and Del removes it.
        const std::vector<double> places = curve.curve().places;
        std::size_t widest = 1;
        for (std::size_t i = 1; i < places.size(); ++i)
            if (places[i] - places[i - 1] > places[widest] - places[widest - 1])
                widest = i;
        const double between = 0.5 * (places[widest - 1] + places[widest]);
        QTest::mouseClick(&curve, Qt::LeftButton, {}, curve.toWidget({between, curve.curve().at(between)}).toPoint());
        QCOMPARE(curve.curve().knots.size(), places.size() + 1);
        QTest::keyClick(&curve, Qt::Key_Delete);
        QCOMPARE(curve.curve().places, places);
        dialog.reject();
        QVERIFY(bench.pen() == before);
        QCOMPARE(bench.steps(), 0);
    }

    void alongTheStrokeIsScaled()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        const Stroke before = bench.pen();
        AlongDialog dialog(bench.editor, &panel);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        type(*dialog.scale(), "1.5");
        QVERIFY(areScaled(before, bench.pen(), &Segment::density, 1.5));
        type(*dialog.scale(), "2"); // the field scales what there is now
        QVERIFY(areScaled(before, bench.pen(), &Segment::density, 3));
        dialog.accept();
        QCOMPARE(bench.steps(), 1);
        bench.editor.undo();
        QVERIFY(bench.pen() == before);
    }

    void drawnOverAPartTheRestStays()
    {
        PenBench bench;
        InspectorPanel panel(bench.editor);
        const Stroke before = bench.pen();
        AlongDialog dialog(bench.editor, &panel);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        dialog.choose(AlongDialog::Drawn);
        QVERIFY(bench.pen() == before);
        CurveEditor &curve = *dialog.curve();
        QTest::mousePress(&curve, Qt::LeftButton, {}, curve.toWidget({0.4, 0.9}).toPoint());
        for (int i = 1; i <= 10; ++i)
            QTest::mouseMove(&curve, curve.toWidget({0.4 + 0.02 * i, 0.9}).toPoint());
        QTest::mouseRelease(&curve, Qt::LeftButton, {}, curve.toWidget({0.6, 0.9}).toPoint());
        const Stroke &after = bench.pen(); // its segments were split where they were long
        QCOMPARE(after.segments.front().density, before.segments.front().density);
        QCOMPARE(after.segments.back().density, before.segments.back().density);
        const float drawn = after.segments[after.segments.size() / 2].density;
        QVERIFY(drawn > 2 * before.segments[before.segments.size() / 2].density);
        dialog.reject();
        QVERIFY(bench.pen() == before);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestMixedValues)
#include "test_mixed_values.moc"

// Panels driven by real events: each gesture is one undo step, mixed values stay mixed, what is refused changes
// nothing.
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/history/history_panel.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/inspector/stroke_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/colour_convert.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/paint/derived_figures.h"
#include "tests/app/panel_bench.h"

#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>

#include <numbers>

using namespace suffuse;

class TestPanels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    void arithmetic()
    {
        QCOMPARE(evaluateArithmetic("12*1.5", {}).value(), 18.0);
        QCOMPARE(evaluateArithmetic("+2", 10.0).value(), 12.0);
        QCOMPARE(evaluateArithmetic("*1.5", 10.0).value(), 15.0);
        QCOMPARE(evaluateArithmetic("-=2", 10.0).value(), 8.0);
        QCOMPARE(evaluateArithmetic("-2", 10.0).value(), -2.0);
        QCOMPARE(evaluateArithmetic("(1+2)*3 - 4/2", {}).value(), 7.0);
        QCOMPARE(evaluateArithmetic("2,5 s", {}, "s").value(), 2.5);
        QCOMPARE(evaluateArithmetic("1e3", {}).value(), 1000.0);
        for (const char *bad : {"", "abc", "1+", "(1", "1)", "1/0", "nan", "inf", "1 2*", "1..2"})
            QVERIFY2(!evaluateArithmetic(bad, {}), bad);
        QVERIFY(!evaluateArithmetic("+2", {}).has_value() || evaluateArithmetic("+2", {}).value() == 2.0);
        QVERIFY(!evaluateArithmetic(QString(10000, '('), {}));
    }

    /// A number that the program writes is read as what it says, in every language.
    void groupsOfThousands()
    {
        const auto restore = qScopeGuard([] { QLocale::setDefault(QLocale::English); });
        struct Row {
            const char *text;
            std::optional<double> english, german;
        };
        const std::optional<double> refused;
        for (const Row &row : std::initializer_list<Row>{
                 {"1,536", 1536, 1.536},
                 {"1.536", 1.536, 1536},
                 {"18,918,001", 18'918'001, refused},
                 {"18.918.001", refused, 18'918'001},
                 {"1,001.9", 1001.9, refused},
                 {"1.001,9", refused, 1001.9},
                 {"1,5", 1.5, 1.5}, // the decimal key of another keyboard
                 {"1.5", 1.5, 1.5},
                 {"0,125", 0.125, 0.125}, // no group begins with a zero
                 {"0.125", 0.125, 0.125},
                 {",125", 0.125, 0.125},
                 {"1536,125", 1536.125, 1536.125},
                 {"1,53,600", refused, refused},
                 {"1,5,3", refused, refused},
                 {"12,3456", 12.3456, 12.3456},
                 {"1,000*2 + 1,5", 2001.5, 3.5},
                 {"1,536 u", 1536, 1.536},
                 {"1 536", 1536, 1536},
             })
            for (const bool german : {false, true}) {
                QLocale::setDefault(german ? QLocale::German : QLocale::English);
                const std::optional<double> wanted = german ? row.german : row.english;
                const std::optional<double> value = evaluateArithmetic(row.text, {}, "u");
                QVERIFY2(value.has_value() == wanted.has_value() &&
                             std::abs(value.value_or(0) - wanted.value_or(0)) < 1e-9,
                         row.text);
            }
        QLocale::setDefault(QLocale::German);
        QCOMPARE(evaluateArithmetic("+1", 1.536).value(), 2.536); // the value that is there is no text of the language
        QLocale::setDefault(QLocale::English);
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        type(*panel.segmentSection()->density()->number(), "1,536");
        QCOMPARE(bench.stroke(1).segments[0].density, 1536.0f);
        type(*panel.segmentSection()->density()->number(), "1,53,600");
        QCOMPARE(bench.stroke(1).segments[0].density, 1536.0f);
        QVERIFY(panel.hint()->text().contains("1,53,600"));
        // What is possible is said in numbers that people read.
        type(*panel.segmentSection()->diffusion()->number(), "0");
        QVERIFY2(panel.hint()->text().contains("more than 0 and up to 1,000,000,000,000"),
                 qPrintable(panel.hint()->text()));
        type(*panel.segmentSection()->density()->number(), "9e12");
        QVERIFY2(panel.hint()->text().contains("0 to 1,000,000,000,000"), qPrintable(panel.hint()->text()));
        NumberField field;
        QString hint;
        connect(&field, &NumberField::refused, &field, [&](const QString &text) { hint = text; });
        field.setRange(1e-6, 4);
        type(field, "0");
        QVERIFY2(hint.contains("more than 0 and up to 4"), qPrintable(hint));
        type(field, "0.0000025");
        QVERIFY2(hint.isEmpty(), qPrintable(hint));
    }

    void headingSaysHowManySegmentsOfAll()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const auto says = [&](const QString &text) {
            const auto labels = panel.findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel *label) { return label->isVisible() && label->text() == text; });
        };
        bench.select({1});
        QVERIFY(says("1 stroke(s) · 4 segment(s)"));
        bench.select({1, 2}, {{1, 0}, {1, 1}, {2, 3}});
        QVERIFY(says("2 stroke(s) · 3 of 8 segment(s)"));
    }

    void sliderDragIsOneStep()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        BarSlider *slider = panel.segmentSection()->diffusion()->slider();
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.1));
        for (const double share : {0.3, 0.5, 0.7, 0.8})
            QTest::mouseMove(slider, sliderPoint(*slider, share));
        const float live = bench.stroke(1).segments[0].diffusion;
        QVERIFY(live > 100); // seen before the button is let go
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.8));
        QCOMPARE(bench.steps(), 1);
        for (const Segment &segment : bench.stroke(1).segments)
            QCOMPARE(segment.diffusion, live);
        QCOMPARE(bench.stroke(2).segments[0].diffusion, 20.0f);
        bench.editor.undoStack().undo();
        QCOMPARE(bench.stroke(1).segments[0].diffusion, 10.0f);
        QCOMPARE(panel.segmentSection()->diffusion()->number()->value().value(), 10.0);
    }

    void twoDragsAreTwoSteps()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        BarSlider *slider = panel.segmentSection()->granulation()->slider();
        for (const double share : {0.2, 0.6})
            QTest::mouseClick(slider, Qt::LeftButton, {}, sliderPoint(*slider, share));
        QCOMPARE(bench.steps(), 2);
    }

    void dragBackLeavesNoStep()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1}, {{1, 2}});
        SliderField *field = panel.segmentSection()->diffusion();
        BarSlider *slider = field->slider();
        // The handle's own point: a press there takes hold of it without a jump.
        const double share = double(slider->value()) / BarSlider::steps;
        QTest::mousePress(slider, Qt::LeftButton, {}, sliderPoint(*slider, share));
        QTest::mouseMove(slider, sliderPoint(*slider, 0.9));
        QVERIFY(bench.stroke(1).segments[2].diffusion > 100);
        QCOMPARE(bench.stroke(1).segments[1].diffusion, 10.0f);
        slider->setSliderPosition(int(std::lround(share * BarSlider::steps)));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, sliderPoint(*slider, share));
        QCOMPARE(bench.stroke(1).segments[2].diffusion, 10.0f);
        QCOMPARE(bench.steps(), 0);
    }

    void mixedStaysMixedUntilSet()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2});
        NumberField *diffusion = panel.segmentSection()->diffusion()->number();
        NumberField *density = panel.segmentSection()->density()->number();
        QVERIFY(!diffusion->value());
        QCOMPARE(diffusion->text(), QString("—"));
        QVERIFY(panel.segmentSection()->diffusion()->slider()->isMixed());
        QCOMPARE(density->value().value(), 9.0);

        type(*density, "12*1.5");
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(bench.stroke(2).segments[3].density, 18.0f);
        QCOMPARE(bench.stroke(1).segments[0].diffusion, 10.0f); // untouched by the other field
        QCOMPARE(diffusion->text(), QString("—"));
        // Leaving the mixed field as it is changes nothing.
        diffusion->setFocus();
        QTest::keyClick(diffusion, Qt::Key_Return);
        QCOMPARE(bench.steps(), 1);
        type(*diffusion, "33");
        QCOMPARE(bench.stroke(1).segments[0].diffusion, 33.0f);
        QCOMPARE(bench.stroke(2).segments[0].diffusion, 33.0f);
        QCOMPARE(diffusion->value().value(), 33.0);
    }

    void refusedInputSaysWhy()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        for (const char *bad : {"-3", "0", "2e12", "twelve", "1/0"}) {
            type(*panel.segmentSection()->diffusion()->number(), bad);
            QVERIFY2(panel.hint()->isVisible() && !panel.hint()->text().isEmpty(), bad);
            QCOMPARE(bench.stroke(1).segments[0].diffusion, 10.0f);
        }
        QCOMPARE(bench.steps(), 0);
        type(*panel.segmentSection()->diffusion()->number(), "+2");
        QVERIFY(!panel.hint()->isVisible());
        QCOMPARE(bench.stroke(1).segments[0].diffusion, 12.0f);
    }

    void labelDoubleClickResets()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({3});
        QTest::mouseDClick(panel.segmentSection()->diffusion()->label(), Qt::LeftButton);
        QCOMPARE(bench.stroke(3).segments[0].diffusion, Segment{}.diffusion);
        QCOMPARE(bench.steps(), 1);
    }

    void anisotropyOfSegments()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1}, {{1, 0}});
        SegmentSection *section = panel.segmentSection();
        QVERIFY(!section->angle()->number()->isEnabled()); // it would mean nothing
        type(*section->anisotropy()->number(), "4");
        QCOMPARE(bench.stroke(1).segments[0].anisotropyRatio, 4.0f);
        QCOMPARE(bench.stroke(1).segments[1].anisotropyRatio, 1.0f);
        type(*section->angle()->number(), "30");
        QVERIFY(std::abs(bench.stroke(1).segments[0].anisotropyAngle - float(std::numbers::pi / 6)) < 1e-6f);
        QCOMPARE(section->angle()->number()->text(), QString("30°"));
        QCOMPARE(bench.steps(), 2);
        BarSlider *slider = section->angle()->slider();
        QTest::mouseClick(slider, Qt::LeftButton, {}, sliderPoint(*slider, 0.91));
        const double degrees = double(bench.stroke(1).segments[0].anisotropyAngle) * 180 / std::numbers::pi;
        QVERIFY(degrees > 30 && std::abs(degrees - std::round(degrees)) < 1e-5); // whole degrees
        bench.select({1});
        QCOMPARE(section->anisotropy()->number()->text(), QString("—"));
        QVERIFY(section->angle()->number()->isEnabled());
        for (const char *bad : {"0", "-1", "2e6"}) {
            type(*section->anisotropy()->number(), bad);
            QVERIFY2(panel.hint()->isVisible(), bad);
        }
        QCOMPARE(bench.steps(), 3);
    }

    void stepsOfAFieldAreOneStep()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        NumberField *granulation = panel.segmentSection()->granulation()->number();
        granulation->setFocus();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(granulation, Qt::Key_Up); // more grain: a smaller ω
        QVERIFY(std::abs(bench.stroke(1).segments[0].granulation - 0.97f) < 1e-6f);
        QCOMPARE(bench.steps(), 1);
    }

    void ownStyleOfSegments()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1}, {{1, 1}});
        StyleSection *section = panel.styleSection();
        QCOMPARE(section->source()->currentIndex(), 0);
        emit section->source()->activated(1);
        QVERIFY(bench.stroke(1).segments[1].style.has_value());
        QVERIFY(!bench.stroke(1).segments[0].style.has_value());
        QCOMPARE(section->source()->currentIndex(), 1);

        emit section->kind()->activated(int(StyleKind::Edge));
        QCOMPARE(bench.stroke(1).segments[1].style->kind, StyleKind::Edge);
        QCOMPARE(bench.stroke(1).style.kind, StyleKind::Uniform);
        QCOMPARE(bench.steps(), 2);
        // ξ2 ≤ 2^(1/3) ξ1
        type(*section->xi(1)->number(), "0.9");
        QVERIFY(panel.hint()->isVisible());
        QCOMPARE(bench.stroke(1).segments[1].style->xi[1], XiFields::defaultStyle(StyleKind::Edge).xi[1]);
        type(*section->xi(1)->number(), "0.7");
        QCOMPARE(bench.stroke(1).segments[1].style->xi[1], 0.7f);

        bench.select({1});
        QCOMPARE(section->source()->currentIndex(), -1);
        QCOMPARE(section->kind()->currentIndex(), -1);
        emit section->source()->activated(0);
        QVERIFY(!bench.stroke(1).segments[1].style.has_value());
        emit section->kind()->activated(int(StyleKind::Feathering));
        QCOMPARE(bench.stroke(1).style.kind, StyleKind::Feathering);
        QCOMPARE(bench.stroke(1).style.xi[2], 0.0f);
    }

    void strokeFields()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2});
        StrokeSection *section = panel.strokeSection();
        type(*section->name(), "Hill");
        QCOMPARE(bench.stroke(1).name, QString("Hill"));
        QCOMPARE(bench.stroke(2).name, QString("Hill"));
        QCOMPARE(bench.steps(), 1);
        emit section->mode()->activated(int(MixMode::Beta));
        QCOMPARE(bench.stroke(2).mix.mode, MixMode::Beta);
        type(*section->beta()->number(), "80");
        QCOMPARE(bench.stroke(1).mix.beta, 0.8f);
        emit section->mode()->activated(int(MixMode::Alpha));
        QCOMPARE(bench.stroke(1).mix, Mix{});
        QCOMPARE(bench.steps(), 4);
    }

    void canvasWithoutSelection()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        QVERIFY(panel.canvasSection()->isVisible());
        type(*panel.canvasSection()->widthField(), "*2");
        QCOMPARE(bench.editor.document().painting()->canvas.width, 2048.0);
        emit panel.canvasSection()->paperChoice()->activated(1);
        QCOMPARE(bench.editor.document().painting()->canvas.paper.kind, PaperKind::Procedural);
        QCOMPARE(bench.steps(), 2);
        BarSlider *strength = panel.canvasSection()->paperStrength()->slider();
        QVERIFY(strength->isVisible());
        QTest::mousePress(strength, Qt::LeftButton, {}, sliderPoint(*strength, 0.1));
        QTest::mouseMove(strength, sliderPoint(*strength, 0.4));
        QTest::mouseRelease(strength, Qt::LeftButton, {}, sliderPoint(*strength, 0.9));
        QCOMPARE(bench.steps(), 3);
        bench.editor.undoStack().setIndex(0);
        QCOMPARE(bench.editor.document().painting()->canvas, Canvas{});
    }

    /// A size goes up and down by a tenth of itself, to whole units: one unit a notch would take an afternoon.
    void canvasSizesStepInProportion()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        const auto width = [&bench] { return bench.editor.document().painting()->canvas.width; };
        NumberField *field = panel.canvasSection()->widthField();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(width(), 1126.0);
        QCOMPARE(field->value(), std::optional(1126.0));
        QWheelEvent down({5, 5}, field->mapToGlobal(QPointF(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(field, &down);
        QCOMPARE(width(), 1024.0);  // as many steps down as up
        QCOMPARE(bench.steps(), 0); // and back where it was is no step
        QTest::keyClick(field, Qt::Key_Up);
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(bench.steps(), 1);
        bench.editor.undo();
        QCOMPARE(width(), 1024.0);
        type(*field, "4");
        QTest::keyClick(field, Qt::Key_Up);
        QCOMPARE(width(), 4.4);
    }

    /// A sheet that was made for paper says how large it is there.
    void theCanvasSaysItsSizeOnPaper()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        QLabel *onPaper = panel.canvasSection()->onPaper();
        QVERIFY(!onPaper->isVisible());
        Canvas canvas = Editor::usualCanvas();
        canvas.width = 709, canvas.height = 531;
        bench.editor.newPainting(canvas, 150);
        bench.editor.laterChanges().flush();
        QVERIFY(onPaper->isVisible());
        QCOMPARE(onPaper->text(), QString("120.1 × 89.9 mm at 150 dpi"));
        type(*panel.canvasSection()->widthField(), "*2");
        QCOMPARE(onPaper->text(), QString("240.1 × 89.9 mm at 150 dpi"));
        bench.editor.newPainting(canvas);
        bench.editor.laterChanges().flush();
        QVERIFY(!onPaper->isVisible());
    }

    void wheelPicksColours()
    {
        for (const double hue : {0.0, 1.0 / 3, 0.5, 0.9}) {
            const Colour pure = pureHue(hue);
            QVERIFY(std::abs(toShares(pure, 0).hue - hue) < 1e-6);
        }
        Bench bench;
        bench.editor.setColour({1, 0, 0, 0.5f});
        ColourPanel panel(bench.editor);
        showAt(panel);
        ColourWheel *wheel = panel.wheel();
        QTest::mouseClick(wheel, Qt::LeftButton, {}, wheel->ringPoint(1.0 / 3).toPoint());
        Colour colour = bench.editor.brush().colour;
        QVERIFY(colour.yellow > 0.99f && colour.red < 0.06f && colour.blue < 0.06f);
        QCOMPARE(colour.opacity, 0.5f);
        QTest::mouseClick(wheel, Qt::LeftButton, {}, wheel->trianglePoint(0, 0).toPoint());
        colour = bench.editor.brush().colour;
        QVERIFY(colour.red < 0.05f && colour.yellow < 0.05f && colour.blue < 0.05f); // white
        QTest::mouseClick(wheel, Qt::LeftButton, {}, wheel->trianglePoint(0.5, 0.25).toPoint());
        const HueShares shares = toShares(bench.editor.brush().colour, 0);
        QVERIFY(std::abs(shares.hue - 1.0 / 3) < 0.02); // white kept the hue
        QVERIFY(std::abs(shares.chroma - 0.5) < 0.02 && std::abs(shares.black - 0.25) < 0.02);
        QCOMPARE(bench.steps(), 0);
    }

    void hexAndApply()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel);
        QVERIFY(!panel.applyButton()->isEnabled());
        type(*panel.hex(), "#2f6690");
        QCOMPARE(toOpaqueScreen(bench.editor.brush().colour).name(), QString("#2f6690"));
        const Colour before = bench.editor.brush().colour;
        type(*panel.hex(), "nice");
        QCOMPARE(bench.editor.brush().colour, before);
        QCOMPARE(panel.hex()->text(), QString("#2f6690"));
        bench.editor.setColour({before.red, before.yellow, before.blue, 0.25f});
        bench.select({1, 3});
        QVERIFY(panel.applyButton()->isEnabled());
        QTest::mouseClick(panel.applyButton(), Qt::LeftButton);
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(bench.stroke(3).segments[3].colour, // its opacity is its own
                 (Colour{before.red, before.yellow, before.blue, Colour{}.opacity}));
        QCOMPARE(bench.stroke(2).segments[0].colour, Colour{});
    }

    void densityFunctionEdges()
    {
        const Style uniform{StyleKind::Uniform, {0.5f, 0.05f, 0}};
        QCOMPARE(densityFunction(uniform, 0.05), 0.0);
        QVERIFY(std::abs(densityFunction(uniform, 0.5) - 0.5) < 2e-4);
        const Style feather{StyleKind::Feathering, {2, 2, 0}};
        QCOMPARE(densityFunction(feather, 1.0), 0.25);
        QCOMPARE(densityFunction(feather, 5.0), 1.0);
        QVERIFY(std::abs(densityFunction(feather, visibleCut(feather)) - 0.5) < 1e-12);
        const Style edge{StyleKind::Edge, {0.6f, 0.65f, 0.9f}};
        const double start = visibleCut(edge);
        QCOMPARE(densityFunction(edge, start * 0.9999), 0.0);
        QVERIFY(std::abs(densityFunction(edge, start * 1.000001) - 1) < 1e-4);
        Segment segment;
        segment.density = float(densityOfPeak(1.2, spreadAt(segment.diffusion, segment.maxAge)));
        const DerivedFigures figures = derivedFigures(segment, uniform);
        QVERIFY(std::abs(figures.peak - 1.2) < 1e-6);
        QVERIFY(std::abs(figures.halfWidth - figures.spread * std::sqrt(std::log(2.4))) < 1e-5);
        QVERIFY(!figures.driesOut);
    }

    void everyFocusableWidgetHasAName()
    {
        Bench bench;
        InspectorPanel inspector(bench.editor);
        ColourPanel colour(bench.editor);
        BrushPanel brush(bench.editor);
        StrokesPanel strokes(bench.editor);
        HistoryPanel history(bench.editor);
        for (QWidget *panel : std::initializer_list<QWidget *>{&inspector, &colour, &brush, &strokes, &history})
            for (QWidget *widget : panel->findChildren<QWidget *>()) {
                bool inner = widget->objectName().startsWith("qt_"); // parts that Qt makes and names itself
                for (QWidget *above = widget->parentWidget(); above; above = above->parentWidget())
                    inner = inner || above->inherits("QComboBox");
                if (!(widget->focusPolicy() & Qt::TabFocus) || inner)
                    continue;
                const auto *button = qobject_cast<QAbstractButton *>(widget);
                QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
                         widget->metaObject()->className());
                QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->accessibleName()));
            }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestPanels)
#include "test_panels.moc"

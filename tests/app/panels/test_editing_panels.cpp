// The inspector as a refiner works in it, by real events: figures and warnings, before and after, relative entry, the
// canvas handle for the width.
#include "app/panels/brushes/brush_panel.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/inspector/figures/cross_section_plot.h"
#include "app/panels/inspector/figures/figures_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/tools/nodes/width_handle.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/curves/cross_section.h"
#include "app/widgets/habits/compare_button.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/quantity.h"
#include "model/paint/half_width.h"
#include "model/painting/validate.h"
#include "render/probe.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"
#include "undo/swatch_edits.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTranslator>

#include <numbers>

using namespace suffuse;

class TestEditingPanels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    /// In a low window a panel scrolls, and what it refuses must not be said below its edge.
    void refusalsAreSeenInLowWindows()
    {
        Session s;
        s.window.resize(1366, 700);
        const auto isSeen = [](const QWidget *hint) {
            return hint && QTest::qWaitFor([hint] {
                       return hint->isVisible() && hint->visibleRegion().boundingRect().height() >= hint->height();
                   });
        };
        auto *colour = s.window.findChild<ColourPanel *>();
        s.window.findChild<QDockWidget *>("colourDock")->raise();
        type(*colour->hex(), "greyish");
        QVERIFY(isSeen(colour->findChild<HintLabel *>()));
        QVERIFY(colour->hex()->visibleRegion().boundingRect().height() >= colour->hex()->height());

        auto *brushes = s.window.findChild<BrushPanel *>();
        s.window.findChild<QDockWidget *>("brushesDock")->raise();
        type(*brushes->size()->number(), "12 kg");
        QVERIFY(isSeen(brushes->findChild<HintLabel *>()));
    }

    /// A panel may be shown while a window is being laid out, which must not be laid out once more within that.
    void aPanelThatIsShownLaysOutNothingElse()
    {
        struct Stranger : QWidget {
            int laidOut = 0;
            bool event(QEvent *event) override
            {
                laidOut += event->type() == QEvent::LayoutRequest;
                return QWidget::event(event);
            }
        } stranger;
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 900});
        panel.hide();
        bench.select({1}); // It shows that when it is seen again.
        stranger.laidOut = 0;
        QCoreApplication::postEvent(&stranger, new QEvent(QEvent::LayoutRequest));
        panel.show();
        QCOMPARE(stranger.laidOut, 0);
        QCoreApplication::sendPostedEvents(&stranger);
        QCOMPARE(stranger.laidOut, 1);
    }

    /// The handle is held where it was taken: back at that place the value is what it was.
    void aHandleKeepsItsGrip()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {320, 900});
        bench.select({1});
        BarSlider &slider = *panel.segmentSection()->born()->slider();
        const Painting before = *bench.editor.document().painting();
        const double share = double(slider.sliderPosition()) / BarSlider::steps;
        for (const int off : {-4, -2, 0, 3, 4}) {
            const QPoint grip = sliderPoint(slider, share) + QPoint(off, 0);
            QTest::mousePress(&slider, Qt::LeftButton, {}, grip);
            QTest::mouseMove(&slider, grip + QPoint(20, 0));
            QVERIFY(!(*bench.editor.unsettled().painting() == before));
            QTest::mouseMove(&slider, grip);
            QTest::mouseRelease(&slider, Qt::LeftButton, {}, grip);
            QCOMPARE(bench.steps(), 0);
            QVERIFY(*bench.editor.document().painting() == before);
        }
    }

    /// Where several lengths are meant, each becomes its own share.
    void lengthsTakePerCentOfWhatTheyAre()
    {
        NumberField field;
        field.setRange(0, 1000);
        field.setDisplay(lengthDisplay());
        field.setValue(80);
        QSignalSpy entered(&field, &NumberField::entered), refused(&field, &NumberField::refused);
        type(field, "50%");
        QCOMPARE(field.value(), std::optional(40.0));
        QCOMPARE(entered.size(), 1);
        QCOMPARE(refused.last().first().toString(), QString());
        field.setValue(std::nullopt);
        ValueMap map;
        connect(&field, &NumberField::enteredRelative, &field, [&map](const ValueMap &given) { map = given; });
        type(field, "25%");
        QVERIFY(map);
        QCOMPARE(map(80).value(), 20.0);
        QCOMPARE(map(8).value(), 2.0);
    }

    void unitsConvertOrAreRefused()
    {
        QCOMPARE(evaluateArithmetic("500 ms", {}, "s").value(), 0.5);
        QCOMPARE(evaluateArithmetic("2 min", {}, "s").value(), 120.0);
        QCOMPARE(evaluateArithmetic("12 px", {}, "u").value(), 12.0);
        QCOMPARE(evaluateArithmetic("+250ms", 1.0, "s").value(), 1.25);
        QCOMPARE(evaluateArithmetic("−=250 ms", 1.0, "s").value(), 0.75);
        QCOMPARE(evaluateArithmetic("90 deg", {}, "°").value(), 90.0);
        QVERIFY(std::abs(evaluateArithmetic("1 rad", {}, "°").value() - 57.2957795) < 1e-6);
        for (const char *bad : {"12 mm", "3 px²", "5 %", "1 u²/s s", "ms"})
            QVERIFY2(!evaluateArithmetic(bad, {}, "s"), bad);
        // Of a length, per cent of what it is now, as in Inkscape.
        QCOMPARE(evaluateArithmetic("50%", 80.0, "u").value(), 40.0);
        QCOMPARE(evaluateArithmetic("(2*60) %", 80.0, "px").value(), 96.0);
        QCOMPARE(evaluateArithmetic("50%", -80.0, "u").value(), -40.0);
        QCOMPARE(evaluateArithmetic("50%", 0.0, "u").value(), 0.0);
        QCOMPARE(evaluateArithmetic("+10%", 80.0, "u").value(), 88.0);
        QCOMPARE(evaluateArithmetic("−=10 %", 80.0, "u").value(), 72.0);
        QCOMPARE(evaluateArithmetic("*150%", 80.0, "u").value(), 120.0);
        QCOMPARE(evaluateArithmetic("/50%", 80.0, "u").value(), 160.0);
        QCOMPARE(evaluateArithmetic("50%", 0.2, "%").value(), 50.0); // shares have it as their unit
        QVERIFY(!evaluateArithmetic("50%", {}, "u") && !evaluateArithmetic("%", 80.0, "u"));
        QVERIFY(isRelative("50%", "u") && !isRelative("50%", "%") && !isRelative("50 u", "u"));
        QCOMPARE(foreignUnit("50%", "u"), QString());
        QCOMPARE(foreignUnit("50%", "s"), QString("%"));
        QCOMPARE(foreignUnit("12 mm", "u"), QString("mm"));
        QCOMPARE(foreignUnit("12 s", "s"), QString());
        QCOMPARE(foreignUnit("12+", "s"), QString());

        // Units are shown in the language's words, and understood in both.
        struct Words : QTranslator {
            bool isEmpty() const override { return false; }
            QString translate(const char *, const char *text, const char *, int) const override
            {
                const QString unit = QString::fromUtf8(text);
                return unit == " s" ? QString(" 秒") : unit == " u²/s" ? QString(" u²/秒") : QString();
            }
        } words;
        QCoreApplication::installTranslator(&words);
        QCOMPARE(specOf(Quantity::MaxAge).display.unit, QString(" 秒"));
        QCOMPARE(specOf(Quantity::Diffusion).display.unit, QString(" u²/秒"));
        QCOMPARE(evaluateArithmetic("500 ms", {}, "秒").value(), 0.5);
        for (const char *two : {"2 s", "2 秒", "2"})
            QCOMPARE(evaluateArithmetic(two, {}, "秒").value(), 2.0);
        QCOMPARE(foreignUnit("12 s", "秒"), QString());
        QCOMPARE(foreignUnit("12 mm", "秒"), QString("mm"));
        QCOMPARE(evaluateArithmetic("3 px²/s", {}, "u²/秒").value(), 3.0);
        QCoreApplication::removeTranslator(&words);

        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        NumberField *density = panel.segmentSection()->density()->number();
        type(*density, "12 mm");
        QCOMPARE(bench.steps(), 0);
        QVERIFY2(panel.hint()->text().contains("mm") && panel.hint()->text().contains("u"),
                 "the hint names both units");
        QCOMPARE(density->value().value(), 9.0);
        type(*panel.segmentSection()->maxAge()->number(), "250 ms");
        QCOMPARE(bench.stroke(1).segments[0].maxAge, 0.25f);
    }

    /// A stroke, or what is selected of it, moves in time as one.
    void birthIsAValueToo()
    {
        constexpr Microseconds tenth = 100'000;
        Bench bench;
        bench.editor.push(changeStrokes(bench.editor.document(), {1, 2},
                                        [](Stroke &stroke) {
                                            for (int k = 0; k < 4; ++k)
                                                stroke.segments[std::size_t(k)].born =
                                                    Microseconds(stroke.id) * 10 * tenth + k * tenth;
                                        }),
                          "times");
        const auto births = [&bench](StrokeId id) {
            std::vector<Microseconds> tenths;
            for (const Segment &segment : bench.stroke(id).segments)
                tenths.push_back(segment.born / tenth);
            return tenths;
        };
        using Tenths = std::vector<Microseconds>;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1});
        SliderField *born = panel.segmentSection()->born();
        QCOMPARE(born->number()->value().value(), 1.0);
        type(*born->number(), "12.5");
        QCOMPARE(births(1), (Tenths{125, 126, 127, 128}));
        QCOMPARE(births(2), (Tenths{20, 21, 22, 23}));
        QCOMPARE(bench.steps(), 2);

        bench.select({1, 2});
        QVERIFY(!born->number()->value());
        type(*born->number(), "+500 ms");
        QCOMPARE(births(1), (Tenths{130, 131, 132, 133}));
        QCOMPARE(births(2), (Tenths{25, 26, 27, 28}));
        type(*born->number(), "-=5"); // then stroke 2 would begin before time 0
        QCOMPARE(bench.steps(), 3);
        QVERIFY(panel.hint()->isVisible());

        bench.select({2}, {{2, 1}, {2, 2}});
        QCOMPARE(born->number()->value().value(), 2.6);
        QTest::mousePress(born->slider(), Qt::LeftButton, {}, sliderPoint(*born->slider(), 0.26));
        for (const double share : {0.4, 0.6, 0.8})
            QTest::mouseMove(born->slider(), sliderPoint(*born->slider(), share));
        QVERIFY(births(2)[1] > 70 && births(2)[1] < 90); // while it is dragged
        QTest::mouseRelease(born->slider(), Qt::LeftButton, {}, sliderPoint(*born->slider(), 0.8));
        QCOMPARE(bench.stroke(2).segments[2].born - bench.stroke(2).segments[1].born, tenth);
        QCOMPARE(births(2)[0], 25);
        QCOMPARE(births(2)[3], 28);
        QCOMPARE(bench.steps(), 4);
        bench.editor.undoStack().undo();
        QCOMPARE(births(2), (Tenths{25, 26, 27, 28}));
    }

    void relativeEntryChangesEachOfMixedValues()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2, 3});
        SliderField *diffusion = panel.segmentSection()->diffusion();
        QVERIFY(!diffusion->number()->value());
        type(*diffusion->number(), "*1.5");
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(bench.stroke(1).segments[0].diffusion, 15.0f);
        QCOMPARE(bench.stroke(3).segments[3].diffusion, 45.0f);
        QCOMPARE(diffusion->number()->text(), QString("—"));
        type(*diffusion->number(), "+2");
        QCOMPARE(bench.stroke(2).segments[1].diffusion, 32.0f);
        QCOMPARE(bench.steps(), 2);
        // One value would leave its domain: none is changed.
        type(*diffusion->number(), "-=20");
        QCOMPARE(bench.steps(), 2);
        QVERIFY(!panel.hint()->text().isEmpty());
        bench.editor.undoStack().setIndex(0);
        QCOMPARE(bench.stroke(3).segments[3].diffusion, 30.0f);

        // Per cent are added as they are shown; colours too.
        bench.editor.push(changeSegments(bench.editor.document(), {{1, 0}}, [](Segment &s) { s.colour.red = 0.5f; }),
                          "red");
        NumberField *red = panel.segmentSection()->colour()->row(ColourRows::Red)->number();
        QVERIFY(!red->value());
        type(*red, "+25");
        QCOMPARE(bench.stroke(1).segments[0].colour.red, 0.75f);
        QCOMPARE(bench.stroke(1).segments[1].colour.red, 0.25f);
    }

    void warningsSayWhatDefeatsTheValues()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {300, 1100});
        const auto set = [&](auto change) {
            bench.editor.push(changeSegments(bench.editor.document(), targetSegments(bench.editor.document()), change),
                              "set");
        };
        bench.select({1});
        HintLabel *warnings = panel.figuresSection()->warnings();
        set([](Segment &s) { s.density = 20; });
        QVERIFY2(warnings->isHidden(), qPrintable(warnings->text()));

        set([](Segment &s) { s.density = 2, s.maxAge = 4; });
        const double fades = fadingAge(10, 2, 0.5);
        QVERIFY(fades < 4);
        QVERIFY(warnings->isVisible());
        QVERIFY2(warnings->text().contains(QLocale().toString(fades, 'g', 3)), qPrintable(warnings->text()));
        set([](Segment &s) { s.density = 20; });
        QVERIFY(fadingAge(10, 20, 0.5) / 2.7 > 4 && warnings->isHidden());
        set([](Segment &s) { s.colour.opacity = 0; });
        QVERIFY(warnings->text().contains('0') && warnings->isVisible());
        set([](Segment &s) { s.colour.opacity = 1, s.style = Style{StyleKind::Uniform, {0.5f, 0.4f, 0}}; });
        QVERIFY2(warnings->text().contains("ξ2"), qPrintable(warnings->text()));
        set([](Segment &s) { s.style = Style{StyleKind::Edge, {0.5f, 0.629f, 0.9f}}; });
        QVERIFY2(warnings->text().contains("ξ2"), qPrintable(warnings->text()));
    }

    void unevenSpreadHasTwoFigures()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel, {300, 1100});
        FiguresSection &figures = *panel.figuresSection();
        bench.select({1}); // level, D = 10 for a second
        QVERIFY(!figures.figure(1)->isVisible());
        const auto text = [](double D) { return QLocale().toString(std::sqrt(4 * D), 'g', 3) + " u"; };
        QCOMPARE(figures.figure(0)->text(), text(10));
        const QString level = figures.figure(3)->text();
        const auto set = [&](float ratio, double angle) {
            bench.editor.push(changeSegments(bench.editor.document(), targetSegments(bench.editor.document()),
                                             [=](Segment &s) {
                                                 s.anisotropyRatio = ratio;
                                                 s.anisotropyAngle = float(angle);
                                             }),
                              "set");
        };
        set(4, 0);
        QVERIFY(figures.figure(1)->isVisible());
        QCOMPARE(figures.figure(0)->text(), text(10));
        QCOMPARE(figures.figure(1)->text(), text(40));
        QCOMPARE(figures.figure(3)->text(), level); // what lies along the stroke does not make it wider
        set(4, std::numbers::pi / 2);
        QCOMPARE(figures.figure(0)->text(), text(40));
        QCOMPARE(figures.figure(1)->text(), text(10));
        set(4, std::numbers::pi / 4);
        QCOMPARE(figures.figure(0)->text(), text(25));
        QCOMPARE(figures.figure(1)->text(), text(25));
        set(1, 0);
        QVERIFY(!figures.figure(1)->isVisible());
    }

    void crossSectionIsThatOfTheSolver()
    {
        Bench bench;
        auto stroke = std::make_shared<Stroke>(bench.stroke(1));
        stroke->id = 1;
        stroke->mix = {MixMode::Beta, 0.5f};
        for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
            Segment &s = stroke->segments[k];
            s.density = 18 + float(k);
            s.colour = {0.2f * float(k), 0.5f, 0.1f, 0.9f};
            s.bezier[1].y += 9;
            s.anisotropyRatio = k % 2 ? 2.5f : 1;
            s.anisotropyAngle = 0.6f;
        }
        Painting painting;
        painting.canvas.background = {0.1f, 0.2f, 0, 1};
        painting.strokes = {stroke};
        const Microseconds time = 600'000;
        const auto points = crossSectionOf(painting, *stroke, 1, time, 41);
        QCOMPARE(points.size(), std::size_t(41));
        const Cubic cubic = stroke->cubicOf(stroke->segments[1]);
        const Point t = cubic.derivative(0.5), n = (1 / length(t)) * Point{-t.y, t.x};
        double seen = 0;
        for (const CrossSectionPoint &p : points) {
            const Point at = cubic.at(0.5) + p.offset * n;
            const Result<Probe> truth = probe(painting, time, at.x, at.y);
            QVERIFY(bool(truth));
            if (truth->strokes.empty()) {
                QVERIFY(p.opacity < 1e-6);
                continue;
            }
            const ProbeStroke &here = truth->strokes.front();
            QVERIFY(std::abs(here.density - p.density) < 1e-3);
            QVERIFY(std::abs(here.opacity - p.opacity) < 5e-3);
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(std::abs(here.rgbAfter[i] - p.rgb[i]) < 1e-2);
            seen = std::max(seen, p.opacity);
        }
        QVERIFY(seen > 0.5);
        QVERIFY(crossSectionOf(painting, *stroke, 1, -1, 41).empty()); // before it was painted
    }

    void cutFollowsTheValues()
    {
        Bench bench;
        bench.editor.clock().setManual(true);
        bench.editor.clock().setTime(5'000'000);
        InspectorPanel panel(bench.editor);
        showAt(panel, {300, 1100});
        bench.select({1}, {{1, 1}});
        const auto most = [&] {
            double opacity = 0;
            for (const CrossSectionPoint &p : panel.figuresSection()->crossSection()->points())
                opacity = std::max(opacity, p.opacity);
            return opacity;
        };
        QTRY_VERIFY(most() > 0);
        const double before = most();
        type(*panel.segmentSection()->density()->number(), "0");
        QTRY_VERIFY(most() < before);
        bench.editor.clock().setTime(-1);
        QTRY_VERIFY(panel.figuresSection()->crossSection()->points().empty());
    }

    void beforeAndAfterTouchNoStep()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        bench.select({1, 2});
        CompareButton *compare = panel.compare();
        QVERIFY(!compare->isEnabled());
        type(*panel.segmentSection()->density()->number(), "30");
        type(*panel.segmentSection()->maxAge()->number(), "3");
        QVERIFY(compare->isEnabled());
        const auto shown = [&](StrokeId id) { return bench.editor.shown()->find(id)->segments[0]; };

        QTest::mousePress(compare, Qt::LeftButton); // held
        QCOMPARE(shown(1).density, 9.0f);
        QCOMPARE(shown(2).maxAge, 1.0f);
        QTest::qWait(350);
        QTest::mouseRelease(compare, Qt::LeftButton);
        QCOMPARE(shown(1).density, 30.0f);
        QVERIFY(!compare->isChecked());

        QTest::mouseClick(compare, Qt::LeftButton); // switched
        QCOMPARE(shown(1).density, 9.0f);
        QVERIFY(compare->isChecked());
        QTest::mouseClick(compare, Qt::LeftButton);
        QCOMPARE(shown(1).density, 30.0f);
        QVERIFY(!compare->isChecked());
        QTest::mouseClick(compare, Qt::LeftButton);
        type(*panel.segmentSection()->maxAge()->number(), "2"); // a change ends the look back
        QCOMPARE(shown(1).maxAge, 2.0f);
        QVERIFY(!compare->isChecked());
        QCOMPARE(bench.steps(), 3);

        bench.editor.push(setSwatches(bench.editor.document(), {{"leaf", {0, 1, 1, 1}}}), "swatch"); // in no picture
        QTRY_VERIFY(compare->isEnabled());
        QTest::mouseClick(compare, Qt::LeftButton);
        QCOMPARE(shown(1).density, 9.0f);
        QTest::mouseClick(compare, Qt::LeftButton);

        // Only what was done to the selection: the step before it was another stroke's.
        bench.select({3});
        QVERIFY(!compare->isEnabled());
        type(*panel.segmentSection()->density()->number(), "5");
        QTest::mouseClick(compare, Qt::LeftButton);
        QCOMPARE(shown(3).density, 9.0f);
        QCOMPARE(shown(1).density, 30.0f);
    }

    /// An outline that only bounds a fill has no width.
    void noWidthHandleWhereThereIsNoPaint()
    {
        Session session;
        auto painting = std::make_shared<Painting>();
        Stroke stroke = *makeStroke(1, 8, 25);
        stroke.fill = usualFill(stroke);
        const auto paintWith = [&](float density) {
            for (Segment &segment : stroke.segments)
                segment.density = density;
            painting->strokes = {std::make_shared<const Stroke>(stroke)};
            session.editor().document().reset(std::make_shared<Painting>(*painting));
            session.editor().clock().setTime(5'000'000);
            session.editor().document().setSelection({{1}, {}});
            return WidthHandle(session.canvas()).segment();
        };
        QVERIFY(paintWith(20));
        QVERIFY(!paintWith(0));
    }

    void widthHandleSolvesForDensity()
    {
        Session session;
        Editor &editor = session.editor();
        auto painting = std::make_shared<Painting>();
        Stroke stroke = *makeStroke(1, 8, 25);
        stroke.origin = {300, 300};
        stroke.style = {StyleKind::Uniform, {0.5f, 0.02f, 0}};
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            stroke.segments[k].density = k < 4 ? 20.0f : 15.0f;
        painting->strokes = {std::make_shared<const Stroke>(stroke)};
        editor.document().reset(painting);
        editor.clock().setTime(5'000'000);
        editor.document().setSelection({{1}, {}});
        WidthHandle handle(session.canvas());
        const auto widthOf = [&](std::size_t k) {
            const Segment &s = session.painting().find(1)->segments[k];
            return halfWidth(s.diffusion, s.density, s.maxAge, 0.5);
        };
        const double before = widthOf(4), other = widthOf(0);
        const View &view = session.canvas().view();
        const double dpr = session.canvas().devicePixelRatioF();
        const Cubic cubic = stroke.cubicOf(stroke.segments[4]);
        const auto event = [&](double distance, Qt::KeyboardModifiers modifiers = {}) {
            PointerEvent e;
            e.point = cubic.at(0.5) + Point{0, distance};
            e.pixel = view.toPixels(e.point);
            e.modifiers = modifiers;
            return e;
        };
        const double gap = 9 * dpr / view.scale;
        QVERIFY(!handle.press(event(0))); // on the curve is not on the handle
        QVERIFY(handle.press(event(before + gap)));
        handle.move(event(1.2 * before + gap));
        QVERIFY(std::abs(widthOf(4) - 1.2 * before) < 1e-4);
        QVERIFY(std::abs(widthOf(0) - 1.2 * other) < 1e-4); // the proportions stay
        QCOMPARE(session.painting().find(1)->segments[4].diffusion, 25.0f);
        handle.move(event(40 + gap)); // beyond twice the spread, which is 10
        QVERIFY(std::abs(widthOf(4) - 40) < 1e-3);
        QVERIFY(std::abs(session.painting().find(1)->segments[4].diffusion - 100) < 1e-3);
        const double most = greatestHalfWidth(15, 0.5);
        handle.move(event(0.8 * most + gap, Qt::ShiftModifier));
        QCOMPARE(session.painting().find(1)->segments[4].density, 15.0f);
        QVERIFY(std::abs(widthOf(4) - 0.8 * most) < 1e-4);
        handle.release();
        QCOMPARE(editor.undoStack().count(), 1);
        editor.undoStack().undo();
        QCOMPARE(*session.painting().find(1), stroke);

        // Back at the start no step is left; given up, neither.
        QVERIFY(handle.press(event(before + gap)));
        handle.move(event(2 * before + gap));
        handle.move(event(before + gap));
        handle.release();
        QCOMPARE(editor.undoStack().index(), 0);
        QVERIFY(handle.press(event(before + gap)));
        handle.move(event(2 * before + gap));
        QVERIFY(handle.isBusy());
        handle.cancel();
        QCOMPARE(*session.painting().find(1), stroke);
        QCOMPARE(editor.undoStack().index(), 0);
        editor.push(changeStrokes(editor.document(), {1}, [](Stroke &s) { s.locked = true; }), "lock");
        QVERIFY(!handle.press(event(before + gap)));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestEditingPanels)
#include "test_editing_panels.moc"

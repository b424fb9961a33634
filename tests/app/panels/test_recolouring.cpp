// Colours of what was painted, as a user changes them: by the colour dock, the eyedropper and drops.
#include "app/panels/colour/colour_header.h"
#include "app/panels/colour/colour_panel.h"
#include "app/panels/colour/swatches_section.h"
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/settings/settings.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/colour/screen_colour_rows.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/number_field.h"
#include "model/colour/colour_shift.h"
#include "tests/app/panel_bench.h"
#include "tests/app/two_waves.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>

using namespace suffuse;

class TestRecolouring : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("colour"); }

    void theHeaderSaysWhoseColour()
    {
        TwoWaves s;
        ColourHeader &header = *s.panel.header();
        QCOMPARE(header.text(), QString("Colour of the brush"));
        QVERIFY(!header.selectionButton()->isEnabled() && header.brushButton()->isChecked());
        s.click({250, 318}); // on the first wave
        QCOMPARE(s.selection().strokes, std::set<StrokeId>({s.id}));
        s.editor().laterChanges().flush();
        QCOMPARE(header.text(), QString("Colour of 1 stroke(s)"));
        QVERIFY(header.selectionButton()->isChecked() && !header.applyButton()->isVisibleTo(&header));
        s.select({s.id, s.second}, {{s.id, 0}, {s.id, 2}, {s.second, 1}});
        QCOMPARE(header.text(), QString("Colour of 3 segment(s)"));
        s.select({s.id, s.second});
        QCOMPARE(header.text(), QString("Colour of 2 stroke(s)"));
        QVERIFY(!header.modeChoice()->isVisibleTo(&header));
        QTest::mouseClick(header.brushButton(), Qt::LeftButton);
        QCOMPARE(header.text(), QString("Colour of the brush"));
        QVERIFY(header.applyButton()->isVisibleTo(&header) && header.applyButton()->isEnabled());
        QTest::mouseClick(header.selectionButton(), Qt::LeftButton);
        QCOMPARE(header.text(), QString("Colour of 2 stroke(s)"));
        s.use(Command::Brush);
        QCOMPARE(header.text(), QString("Colour of the brush"));
        s.use(Command::Segments);
        QCOMPARE(header.text(), QString("Colour of 2 stroke(s)"));
    }

    /// A drag is about what was selected at the press: what comes to be selected meanwhile keeps its colour.
    void anotherSelectionEndsADrag()
    {
        TwoWaves s;
        s.select({s.id});
        ColourWheel &wheel = *s.panel.wheel();
        QTest::mousePress(&wheel, Qt::LeftButton, {}, s.ring(0.3));
        QTest::mouseMove(&wheel, s.ring(0.5));
        const Colour dragged = s.colour(s.id), other = s.colour(s.second);
        QVERIFY(!(dragged == waveColour));
        const int steps = s.steps();
        s.select({s.second});
        QTRY_COMPARE(s.steps(), steps + 1); // what was dragged is a step of its own
        QTest::mouseMove(&wheel, s.ring(0.8));
        QTest::mouseRelease(&wheel, Qt::LeftButton, {}, s.ring(0.8));
        QCOMPARE(s.colour(s.id), dragged);
        QCOMPARE(s.colour(s.second), other);
        QCOMPARE(s.steps(), steps + 1);
    }

    void theWheelColoursWhatIsSelected()
    {
        TwoWaves s;
        const Colour brush = s.editor().brush().colour;
        s.select({s.id});
        const int steps = s.steps();
        ColourWheel &wheel = *s.panel.wheel();
        QTest::mousePress(&wheel, Qt::LeftButton, {}, s.ring(0.3));
        QTest::mouseMove(&wheel, s.ring(0.5));
        QVERIFY(!s.isAsBefore()); // it shows at once
        QCOMPARE(s.steps(), steps);
        QTest::keyClick(&s.window, Qt::Key_Escape);
        QVERIFY(s.isAsBefore());
        QCOMPARE(s.steps(), steps);
        QTest::mouseMove(&wheel, s.ring(0.7)); // the button is still down
        QTest::mouseRelease(&wheel, Qt::LeftButton, {}, s.ring(0.7));
        QVERIFY(s.isAsBefore());
        QTest::mousePress(&wheel, Qt::LeftButton, {}, s.ring(0.3));
        QTest::mouseMove(&wheel, s.ring(0.5));
        QTest::keyClick(&s.window, Qt::Key_Delete); // the drag goes, and not the stroke
        QVERIFY(s.isAsBefore());
        QTest::mouseRelease(&wheel, Qt::LeftButton, {}, s.ring(0.5));
        QVERIFY(s.isAsBefore());

        QTest::mousePress(&wheel, Qt::LeftButton, {}, s.ring(0.3));
        for (const double hue : {0.35, 0.4, 0.45, 0.5})
            QTest::mouseMove(&wheel, s.ring(hue));
        QTest::mouseRelease(&wheel, Qt::LeftButton, {}, s.ring(0.5));
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(std::abs(toShares(s.colour(s.id), 0).hue - 0.5) < 0.02);
        QCOMPARE(s.colour(s.second), waveColour);
        QCOMPARE(s.editor().brush().colour, brush);
        for (int i = 0; i < 3; ++i) // quick steps by keys are one step
            QTest::keyClick(&wheel, Qt::Key_Right);
        QCOMPARE(s.steps(), steps + 2);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.isAsBefore());
    }

    void escGivesTheBrushItsColourBack()
    {
        TwoWaves s;
        const Colour brush = s.editor().brush().colour;
        QTest::mousePress(s.panel.wheel(), Qt::LeftButton, {}, s.ring(0.3));
        QVERIFY(s.editor().brush().colour != brush);
        QTest::keyClick(&s.window, Qt::Key_Escape);
        QVERIFY(farthest(s.editor().brush().colour, brush) < 1e-6);
        QCOMPARE(s.editor().brush().colour.opacity, brush.opacity);
    }

    void hexSwatchesAndRecentColoursDoToo()
    {
        TwoWaves s;
        s.addSwatches({{"leaf", withOpacity(green, 0.5f)}});
        s.editor().setColour(red); // which is painted with, and so a recent colour
        s.editor().document().setDraft(wave(99, 0, 0));
        s.editor().document().setDraft(nullptr);
        s.select({s.id}, {{s.id, 1}});
        type(*s.panel.hex(), "#2f6690");
        QCOMPARE(toOpaqueScreen(s.colour(s.id, 1)).name(), QString("#2f6690"));
        QCOMPARE(s.colour(s.id, 0), waveColour);
        SwatchGrid &grid = *s.panel.swatches()->grid();
        QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cell(0).center());
        QCOMPARE(s.colour(s.id, 1), green); // its opacity is its own
        SwatchGrid &recent = *s.panel.history();
        QTest::mouseClick(&recent, Qt::LeftButton, {}, recent.cell(0).center());
        QCOMPARE(s.colour(s.id, 1), red);
        grid.setFocus();
        QTest::keyClick(&grid, Qt::Key_Return);
        QCOMPARE(s.colour(s.id, 1), green);
        QCOMPARE(s.editor().brush().colour, red);
        for (int i = 0; i < 4; ++i)
            s.use(Command::Undo);
        QVERIFY(s.isAsBefore());
        s.use(Command::Brush); // as ever
        QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cell(0).center());
        QCOMPARE(s.editor().brush().colour, withOpacity(green, 0.5f));
        QVERIFY(s.isAsBefore());
    }

    void slidersOfThreeKinds()
    {
        TwoWaves s;
        s.panel.resize(300, 600);
        s.select({s.id, s.second});
        const int steps = s.steps();
        ColourRows &rows = *s.panel.rows();
        ScreenColourRows &screen = *s.panel.screenRows();
        QVERIFY(rows.isVisibleTo(&s.panel) && !screen.isVisibleTo(&s.panel));
        type(*rows.row(ColourRows::Yellow)->number(), "50");
        QCOMPARE(s.colour(s.second), (Colour{0.9f, 0.5f, 0.7f, 1}));
        type(*rows.row(ColourRows::Opacity)->number(), "40");
        QCOMPARE(s.colour(s.id), (Colour{0.9f, 0.5f, 0.7f, 0.4f}));
        QCOMPARE(s.steps(), steps + 2);

        s.panel.sliderChoice()->setCurrentIndex(2);
        emit s.panel.sliderChoice()->activated(2);
        QVERIFY(!rows.isVisibleTo(&s.panel) && screen.isVisibleTo(&s.panel));
        type(*screen.row(ScreenColourRows::Red)->number(), "47");
        type(*screen.row(ScreenColourRows::Green)->number(), "102");
        type(*screen.row(ScreenColourRows::Blue)->number(), "144");
        QCOMPARE(toOpaqueScreen(s.colour(s.id)).name(), QString("#2f6690"));
        QCOMPARE(s.panel.hex()->text(), QString("#2f6690"));
        QCOMPARE(s.colour(s.id).opacity, 0.4f);

        s.panel.sliderChoice()->setCurrentIndex(1);
        emit s.panel.sliderChoice()->activated(1);
        type(*screen.row(ScreenColourRows::Saturation)->number(), "0");
        QVERIFY(isGrey(s.colour(s.id)));
        type(*screen.row(ScreenColourRows::Saturation)->number(), "100"); // the hue is not forgotten
        const QColor blue = toOpaqueScreen(s.colour(s.id));
        QVERIFY2(std::abs(blue.hue() - QColor("#2f6690").hue()) <= 1, qPrintable(blue.name()));
        type(*screen.row(ScreenColourRows::Hue)->number(), "120");
        QVERIFY(std::abs(toOpaqueScreen(s.colour(s.id)).hue() - 120) <= 1);

        const PaintingPtr now = s.editor().document().painting();
        const int count = s.steps();
        BarSlider &hue = *screen.row(ScreenColourRows::Hue)->slider();
        QTest::mousePress(&hue, Qt::LeftButton, {}, along(hue, 0.1));
        QTest::mouseMove(&hue, along(hue, 0.9));
        QVERIFY(s.painting() != *now);
        QTest::keyClick(&s.window, Qt::Key_Escape);
        QVERIFY(s.painting() == *now);
        QCOMPARE(s.steps(), count);
        QTest::mouseRelease(&hue, Qt::LeftButton, {}, along(hue, 0.9));
        type(*screen.row(ScreenColourRows::Opacity)->number(), "100");
        QCOMPARE(s.colour(s.id).opacity, 1.0f);
        QCOMPARE(s.editor().undoText(), QString("Change opacity"));
    }

    void severalColoursAreSetOrShifted()
    {
        TwoWaves s;
        s.select({s.second});
        type(*s.panel.hex(), "#c0ffee");
        const Colour pale = s.colour(s.second);
        s.select({s.id, s.second});
        QComboBox &mode = *s.panel.header()->modeChoice();
        QVERIFY(mode.isVisibleTo(&s.panel));
        QCOMPARE(s.panel.header()->text(), QString("Colours of 2 stroke(s)"));
        QCOMPARE(mode.currentIndex(), 0);
        // None of them is shown as if both had it.
        ColourRows &rows = *s.panel.findChild<ColourRows *>();
        const ColourSwatch &current = *s.panel.findChild<ColourSwatch *>();
        QCOMPARE(s.panel.hex()->text(), QString());
        QCOMPARE(s.panel.hex()->placeholderText(), QString("several"));
        QVERIFY(!rows.row(ColourRows::Red)->number()->value());
        QVERIFY(rows.row(ColourRows::Opacity)->number()->value()); // which both have
        QVERIFY(current.colour() && current.other() && *current.colour() != *current.other());
        const QImage severalWheel = s.panel.wheel()->grab().toImage();
        type(*rows.row(ColourRows::Red)->number(), "+2"); // each by itself
        QVERIFY(std::abs(s.colour(s.second).red - pale.red - 0.02f) < 1e-5f);
        QVERIFY(std::abs(s.colour(s.id).red - waveColour.red - 0.02f) < 1e-5f);
        s.use(Command::Undo);
        s.editor().laterChanges().flush();
        QTest::keyClick(rows.row(ColourRows::Red)->number(), Qt::Key_Up);
        QCOMPARE(s.colour(s.id).red, s.colour(s.second).red); // what is set sets all,
        QCOMPARE(s.colour(s.second).blue, pale.blue);         // and nothing else
        QCOMPARE(s.colour(s.id).blue, waveColour.blue);
        s.use(Command::Undo);
        s.editor().laterChanges().flush();
        type(*s.panel.hex(), "#802040");
        QCOMPARE(s.colour(s.id), s.colour(s.second));
        s.editor().laterChanges().flush();
        QCOMPARE(s.panel.hex()->text(), QString("#802040"));
        QVERIFY(!current.other() && rows.row(ColourRows::Red)->number()->value());
        QVERIFY(s.panel.wheel()->grab().toImage() != severalWheel); // it has its marks again
        s.use(Command::Undo);
        s.editor().laterChanges().flush();
        mode.setCurrentIndex(1);
        emit mode.activated(1);
        type(*s.panel.hex(), "#205020");
        QVERIFY(s.colour(s.id) != s.colour(s.second));
        QCOMPARE(toOpaqueScreen(s.colour(s.id)).name(), QString("#205020"));
        QVERIFY(farthest(s.colour(s.second), pale) > 0.05);
        mode.setCurrentIndex(0);
        emit mode.activated(0);
        type(*s.panel.hex(), "#802040");
        QCOMPARE(s.colour(s.id), s.colour(s.second));
    }

    /// A number of red, yellow or blue is about nothing else: what a brush has strayed by stays, in the other two
    /// exactly.
    void aTypedNumberChangesNoOther()
    {
        TwoWaves s;
        const std::size_t count = s.painting().find(s.id)->segments.size();
        QVERIFY(count > 2);
        const auto strayed = [](std::size_t k) { return 0.04f * float(int(k % 3) - 1); };
        s.editor().push(changeStrokes(s.editor().document(), {s.id},
                                      [&](Stroke &stroke) {
                                          for (std::size_t k = 0; k < count; ++k)
                                              stroke.segments[k].colour = {0.3f + strayed(k), 0.2f + strayed(k + 1),
                                                                           0.9f + strayed(k + 2), 1};
                                      }),
                        "strays");
        s.select({s.id});
        const std::vector<Segment> before = s.painting().find(s.id)->segments;
        QVERIFY(!s.editor().colourTarget().isOneOfSeveral());
        const float usual = s.editor().colourTarget().colour().red;
        ColourRows &rows = *s.panel.findChild<ColourRows *>();
        type(*rows.row(ColourRows::Red)->number(), "60");
        const std::vector<Segment> &after = s.painting().find(s.id)->segments;
        for (std::size_t k = 0; k < count; ++k) {
            QCOMPARE(after[k].colour.yellow, before[k].colour.yellow);
            QCOMPARE(after[k].colour.blue, before[k].colour.blue);
            QVERIFY(std::abs(after[k].colour.red - (before[k].colour.red + 0.6f - usual)) < 1e-6f);
        }
        s.editor().laterChanges().flush();
        QCOMPARE(rows.row(ColourRows::Red)->number()->value(), std::optional<double>(0.6f));
        type(*rows.row(ColourRows::Blue)->number(), "0"); // As far as there is room.
        for (const Segment &segment : s.painting().find(s.id)->segments)
            QVERIFY(segment.colour.blue >= 0 && segment.colour.blue < 0.09f);
    }

    void theEyedropperColoursWhatIsSelected()
    {
        TwoWaves s;
        s.select({s.second});
        type(*s.panel.hex(), "#20a040");
        s.dry();
        const Colour leaf = s.colour(s.second);
        const PaintingPtr now = s.editor().document().painting();
        const Colour brush = s.editor().brush().colour;
        const int steps = s.steps();
        s.select({s.id});
        s.use(Command::Eyedropper);
        QVERIFY(s.canvas().tool()->hint().contains("selected"));
        s.drag({350, 100}, {300, 460}, Qt::ShiftModifier, false); // from the paper onto the second wave
        QCOMPARE(s.colour(s.id), leaf);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.painting() == *now);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 460}));
        QCOMPARE(s.steps(), steps);
        s.drag({350, 100}, {300, 460}, Qt::ShiftModifier);
        QCOMPARE(s.colour(s.id), leaf);
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().brush().colour, brush);
        s.use(Command::Undo);
        // Over what is being coloured it goes on picking what was there.
        s.drag({350, 100}, {300, 340}, {}, false);
        const Colour once = s.colour(s.id);
        s.move({301, 340});
        s.move({300, 340});
        QCOMPARE(s.colour(s.id), once);
        QVERIFY(farthest(once, waveColour) < 0.1);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({300, 340}));

        s.use(Command::Brush);
        s.use(Command::Eyedropper);
        s.drag({350, 100}, {300, 460}, Qt::ShiftModifier);
        QCOMPARE(s.editor().brush().colour, leaf);
    }

    /// The row over the canvas says what a click does, as the hint does.
    void theEyedroppersRowSaysWhatItColours()
    {
        TwoWaves s;
        s.select({});
        s.use(Command::Eyedropper);
        auto *takes = s.canvas().tool()->options()->findChild<QComboBox *>();
        QCOMPARE(takes->itemText(0), QString("The colour, to paint with"));
        s.use(Command::Select);
        s.select({s.id});
        s.use(Command::Eyedropper);
        QCOMPARE(takes->currentText(), QString("The colour, for the selection"));
        s.select({});
        QCOMPARE(takes->currentText(), QString("The colour, to paint with"));
        QVERIFY(takes->sizeHint().width() <= takes->width());
        s.select({s.second});
        QCOMPARE(takes->currentText(), QString("The colour, for the selection"));
        s.use(Command::Brush);
        s.use(Command::Eyedropper); // goes on with what the tool before was about
        QCOMPARE(takes->currentText(), QString("The colour, to paint with"));
    }

    void aDropOnWhatIsSelectedColoursAllOfIt()
    {
        TwoWaves s;
        const StrokeId third = s.addWave(200, 540, false);
        const auto drop = [&s](Point where) {
            QMimeData data;
            data.setColorData(QColor("#00ff00"));
            const QPoint at = s.at(where);
            QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&s.canvas(), &enter);
            QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, {});
            QCoreApplication::sendEvent(&s.canvas(), &dropped);
        };
        s.select({s.id, s.second});
        const int steps = s.steps();
        drop({300, 340});
        QCOMPARE(s.colour(s.id), green);
        QCOMPARE(s.colour(s.second), green);
        QCOMPARE(s.colour(third), waveColour);
        QCOMPARE(s.steps(), steps + 1);
        s.use(Command::Undo);
        drop({300, 580}); // on what is not selected
        QCOMPARE(s.colour(third), green);
        QCOMPARE(s.colour(s.id), waveColour);
        s.select({s.id}, {{s.id, 0}});
        drop({300, 340});
        QCOMPARE(s.colour(s.id, 0), green);
        QCOMPARE(s.colour(s.id, 1), waveColour);
    }

    void aLinkedSwatchRecoloursItsPaint()
    {
        TwoWaves s;
        s.addSwatches({{"wave", waveColour}, {{}, red}});
        SwatchGrid &grid = *s.panel.swatches()->grid();
        const auto trigger = [&grid](int action) {
            const std::unique_ptr<QMenu> menu(grid.menuFor(0));
            menu->actions()[action]->trigger();
        };
        trigger(1); // link
        QVERIFY(s.painting().swatches[0].linked);
        QCOMPARE(s.editor().undoText(), QString("Link swatch"));
        trigger(2); // select what has the colour
        QCOMPARE(s.selection().strokes, std::set<StrokeId>({s.id, s.second}));
        s.select({});
        const PaintingPtr linked = s.editor().document().painting();
        trigger(0); // change the colour
        QCOMPARE(s.panel.header()->text(), QString("Colour of the swatch “wave”"));
        const int steps = s.steps();
        ColourWheel &wheel = *s.panel.wheel();
        QTest::mousePress(&wheel, Qt::LeftButton, {}, s.ring(0.3));
        QTest::mouseMove(&wheel, s.ring(0.5));
        QTest::keyClick(&s.window, Qt::Key_Escape);
        QVERIFY(s.painting() == *linked);
        QTest::mouseRelease(&wheel, Qt::LeftButton, {}, s.ring(0.5));
        type(*s.panel.hex(), "#00ff00");
        QCOMPARE(s.painting().swatches[0].colour, green);
        QCOMPARE(s.colour(s.id, 3), green);
        QCOMPARE(s.colour(s.second), green);
        QCOMPARE(s.steps(), steps + 1);
        s.use(Command::Undo);
        QVERIFY(s.painting() == *linked);
        const Colour brush = s.editor().brush().colour;
        QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cell(1).center()); // taken, not changed
        QCOMPARE(s.editor().brush().colour, withOpacity(red, brush.opacity));
        QVERIFY(s.painting() == *linked);
        QCOMPARE(s.panel.header()->text(), QString("Colour of the brush"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestRecolouring)
#include "test_recolouring.moc"

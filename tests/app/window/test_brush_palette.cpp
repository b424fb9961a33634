// The brush palette that opens where the pointer is, and the brushes in the row over the canvas.
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/painting/seen_width.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/brush_palette.h"
#include "app/widgets/brush/brush_combo.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/brush/brush_pictures.h"
#include "app/widgets/colour/colour_chips.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/brush/brush_width.h"
#include "model/brush/stroke_builder.h"
#include "tests/app/crossing.h"

#include <QTemporaryDir>

using namespace suffuse;

class TestBrushPalette : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void paletteOpensWhereThePointerIsAndClosesByPainting()
    {
        Crossing s;
        s.use(Command::Brush);
        s.askAt({400, 300});
        QVERIFY(s.palette() && s.palette()->isOpen());
        QVERIFY(!s.menu().isVisible());
        const QRect card = s.palette()->geometry();
        QVERIFY(s.window.rect().contains(card));
        QVERIFY(card.contains(s.canvas().mapTo(&s.window, s.at({400, 300}))));
        s.paintLine({100, 60}, {180, 60}); // beside it
        QVERIFY(!s.palette()->isOpen());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4)); // the press that closes it paints
        QVERIFY(s.canvasHasKeyboard());
        // In a corner it keeps within the window.
        s.askAt({5, 5});
        QVERIFY(s.palette()->isOpen());
        QVERIFY(s.window.rect().contains(s.palette()->geometry()));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        QVERIFY(!s.palette()->isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QCOMPARE(s.painting().strokes.size(), std::size_t(4));
    }

    void paletteIsWorkedByKeys()
    {
        Crossing s;
        s.key(Qt::Key_Q);
        QVERIFY(s.palette() && s.palette()->isOpen());
        BrushPalette &palette = *s.palette();
        QCOMPARE(QApplication::focusWidget(), palette.grid());
        QCOMPARE(BrushGrid::brushOf(palette.grid()->currentItem()), s.editor().brush().name);
        const QString before = s.editor().brush().name;
        s.key(Qt::Key_Right);
        QVERIFY(s.editor().brush().name != before);
        QCOMPARE(BrushGrid::brushOf(palette.grid()->currentItem()), s.editor().brush().name);
        QVERIFY(s.window.action(Command::Brush).isChecked()); // to paint with it
        s.key(Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), palette.nearChips());
        const Colour colour = s.editor().brush().colour;
        s.key(Qt::Key_Right);
        s.key(Qt::Key_Down);
        const Colour wanted = palette.nearChips()->colours()[std::size_t(palette.nearChips()->current())];
        s.key(Qt::Key_Space);
        QCOMPARE(s.editor().brush().colour, wanted);
        QVERIFY(!(wanted == colour));
        // Tab goes round within it.
        std::set<QWidget *> visited;
        for (int i = 0; i < 20; ++i) {
            s.key(Qt::Key_Tab);
            QVERIFY(palette.isAncestorOf(QApplication::focusWidget()));
            visited.insert(QApplication::focusWidget());
        }
        QVERIFY(visited.contains(palette.grid()) && visited.size() >= 7);
        s.key(Qt::Key_B); // no command of the canvas
        QVERIFY(palette.isOpen());
        palette.grid()->setFocus();
        s.key(Qt::Key_Q); // the key that opens it closes it
        QVERIFY(!palette.isOpen());
        QVERIFY(s.canvasHasKeyboard());
        QCOMPARE(s.steps(), 0);
    }

    void paletteChangesSizeAndZoom()
    {
        Crossing s;
        s.key(Qt::Key_Q);
        BrushPalette &palette = *s.palette();
        enter(*palette.zoom()->number(), "200");
        QVERIFY(std::abs(s.canvas().view().scale - 2) < 1e-9);
        if (!palette.isOpen()) // Return closes it when the number is taken
            s.key(Qt::Key_Q);
        enter(*palette.size()->number(), "31");
        QVERIFY(std::abs(visibleWidth(s.editor().brush()) - 31) < 1e-4);
        QVERIFY(!palette.isOpen());
    }

    void paletteShowsWhatWasPaintedWith()
    {
        Crossing s;
        s.use(Command::Brush);
        s.editor().setColour(fromScreen(QColor("#c02040")));
        s.paintLine({100, 60}, {180, 60});
        s.key(Qt::Key_Q);
        const std::vector<Colour> &recent = s.palette()->recentChips()->colours();
        QVERIFY(!recent.empty());
        QCOMPARE(toOpaqueScreen(recent.front()).name(), QString("#c02040"));
        s.editor().setColour(fromScreen(QColor("#208040")));
        // Colours that differ only in their opacity are told apart.
        ColourChips chips(2);
        chips.showOpacity();
        const Colour opaque{0.2f, 0.3f, 0.8f, 1}, faint{0.2f, 0.3f, 0.8f, 0.3f};
        chips.setColours({opaque, faint});
        const QImage shown = chips.grab().toImage();
        QVERIFY(shown.copy(chips.cell(0)) != shown.copy(chips.cell(1)));
        QTest::mouseClick(s.palette()->recentChips(), Qt::LeftButton, {}, s.palette()->recentChips()->cell(0).center());
        QCOMPARE(toOpaqueScreen(s.editor().brush().colour).name(), QString("#c02040"));
    }

    /// As the Colour dock does, the palette colours what is selected where that is meant.
    void paletteColoursWhatIsSelected()
    {
        Crossing s;
        s.use(Command::Select);
        s.select({1, 2});
        s.editor().laterChanges().flush();
        QCOMPARE(s.editor().colourTarget().kind(), ColourTarget::Kind::Selection);
        const Colour ofBrush = s.editor().brush().colour;
        const float opacity = s.stroke(1).segments[0].colour.opacity;
        s.key(Qt::Key_Q);
        BrushPalette &palette = *s.palette();
        QCOMPARE(palette.whose()->text(), s.editor().colourTarget().title());
        QVERIFY(palette.whose()->text() != "Colour of the brush");
        const Colour wanted = palette.nearChips()->colours()[5];
        QTest::mouseClick(palette.nearChips(), Qt::LeftButton, {}, palette.nearChips()->cell(5).center());
        for (const StrokeId id : {1, 2}) {
            QCOMPARE(s.stroke(id).segments[0].colour.red, wanted.red);
            QCOMPARE(s.stroke(id).segments[0].colour.blue, wanted.blue);
            QCOMPARE(s.stroke(id).segments[0].colour.opacity, opacity);
        }
        QVERIFY(!(s.stroke(3).segments[0].colour == s.stroke(1).segments[0].colour));
        QCOMPARE(s.steps(), 1);
        enter(*palette.opacity()->number(), "37");
        QCOMPARE(s.stroke(2).segments[0].colour.opacity, 0.37f);
        QCOMPARE(s.steps(), 2);
        QCOMPARE(s.editor().brush().colour, ofBrush);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QCOMPARE(s.stroke(1).segments[0].colour.opacity, opacity);
        // With the brush in hand it is the brush's again.
        s.use(Command::Brush);
        s.key(Qt::Key_Q);
        QCOMPARE(palette.whose()->text(), QString("Colour of the brush"));
        QTest::mouseClick(palette.nearChips(), Qt::LeftButton, {}, palette.nearChips()->cell(2).center());
        QVERIFY(!(s.editor().brush().colour == ofBrush));
        QCOMPARE(s.editor().undoStack().index(), 0);
    }

    void nearColoursGoThroughTheColour()
    {
        for (const char *name : {"#3060a0", "#ffffff", "#000000", "#808080", "#ff0000"}) {
            const Colour colour = fromScreen(QColor(name));
            const std::vector<Colour> near = nearColours(colour);
            QCOMPARE(near.size(), std::size_t(21));
            for (const std::size_t middle : {3, 10, 17})
                QVERIFY2(std::abs(near[middle].red - colour.red) < 1e-5 &&
                             std::abs(near[middle].yellow - colour.yellow) < 1e-5 &&
                             std::abs(near[middle].blue - colour.blue) < 1e-5,
                         name);
            QVERIFY(toOpaqueScreen(near[0]).lightness() >= toOpaqueScreen(near[6]).lightness());
        }
    }

    void rowDropsDownBrushesWithPictures()
    {
        Crossing s;
        s.use(Command::Brush);
        auto *combo = s.canvas().tool()->options()->findChild<BrushCombo *>();
        QVERIFY(combo);
        combo->showPopup();
        QVERIFY(combo->grid());
        const auto isDrawn = [&](const Brush &brush) {
            const QListWidgetItem *item = combo->grid()->itemOf(brush.name);
            const QImage picture = item ? item->icon().pixmap(BrushPictures::size).toImage() : QImage();
            const QPoint middle = picture.rect().center();
            return !picture.isNull() && picture.pixel(middle) != picture.pixel(8, 8); // there is paper
        };
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::all_of(BrushLibrary::instance().brushes(), isDrawn), waitMs);
        // Typing searches, Return takes.
        const QString before = s.editor().brush().name;
        QTest::keyClicks(combo->grid(), "goua");
        QCOMPARE(combo->search()->text(), QString("goua"));
        QTest::keyClick(combo->search(), Qt::Key_Return);
        QVERIFY(!combo->grid());
        QCOMPARE(s.editor().brush().name, QString("gouache"));
        combo->showPopup();
        QTest::keyClick(combo->grid(), Qt::Key_Down);
        QTest::keyClick(combo->grid(), Qt::Key_Escape);
        QVERIFY(!combo->grid());
        QCOMPARE(s.editor().brush().name, QString("gouache")); // only Return takes
        BrushLibrary::instance().use(s.editor(), before);
        QCOMPARE(combo->currentData().toString(), before);
    }

    /// Who opens the program for the first time paints with a brush that a mouse's speed shapes.
    void theFirstBrushIsShapedBySpeed()
    {
        settings::store().remove("brush");
        {
            const MainWindow window;
            QCOMPARE(const_cast<MainWindow &>(window).editor().brush(), firstBrush());
        }
        const auto stroke = [](double unitsASecond) {
            std::vector<PenSample> samples;
            for (int i = 0; i <= 60; ++i)
                samples.push_back({{double(10 * i), 0}, toMicroseconds(10 * i / unitsASecond)});
            return buildStroke(firstBrush(), 1, samples);
        };
        const auto widthOf = [](const Stroke &s) { // in the middle, dry
            const int k = int(s.segments.size()) / 2;
            return seenWidth(s, k, s.segments[std::size_t(k)].born + 100'000'000)->width;
        };
        const StrokePtr slow = stroke(150), quick = stroke(1500);
        QVERIFY2(widthOf(*slow) > 2 * widthOf(*quick),
                 qPrintable(QString("%1 %2").arg(widthOf(*slow)).arg(widthOf(*quick))));
        const auto tapers = [&](const Stroke &s) {
            const auto at = [&](std::size_t k) {
                return std::sqrt(4.0 * s.segments[k].diffusion * s.segments[k].maxAge);
            };
            return at(s.segments.size() - 1) < 0.6 * at(s.segments.size() / 2);
        };
        QVERIFY(tapers(*slow) && tapers(*quick));
        QVERIFY(slow->segments[slow->segments.size() / 2].colour.opacity >
                quick->segments[quick->segments.size() / 2].colour.opacity);
    }

    /// After the first strokes the status bar says what can be done with them, until somebody has done it once.
    void theFirstStrokesLeadToSelecting()
    {
        settings::store().remove("hints/hasSelected");
        Session s;
        const QString usual = s.canvas().tool()->hint();
        for (int i = 1; i <= 3; ++i) {
            QCOMPARE(s.canvas().tool()->hint(), usual);
            s.paintLine({100, 100.0 * i}, {400, 100.0 * i});
        }
        const QString said = s.canvas().tool()->hint();
        QVERIFY2(said.contains("press V"), qPrintable(said));
        s.use(Command::Select);
        s.click({250, 100});
        QCOMPARE(s.selection().strokes.size(), std::size_t(1));
        s.use(Command::Brush);
        s.paintLine({100, 450}, {400, 450});
        QCOMPARE(s.canvas().tool()->hint(), usual);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestBrushPalette)
#include "test_brush_palette.moc"

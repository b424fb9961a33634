// History, swatches, palettes, the sheet to mix on, and the choice of papers.
#include "app/panels/colour/colour_panel.h"
#include "app/panels/colour/swatches_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/session/colour_convert.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/mixing_pad.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/formats/brushes/gimp_palette.h"
#include "model/painting/paper_presets.h"
#include "tests/app/panel_bench.h"
#include "undo/swatch_edits.h"

#include <QComboBox>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace suffuse;

namespace {

constexpr Colour yellow{0, 1, 0, 1}, blue{0, 0, 1, 1}, red{1, 0, 0, 1};

QPoint middleOf(const SwatchGrid &grid, int index)
{
    return grid.cell(index).center();
}

void drag(QWidget &widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {})
{
    QTest::mousePress(&widget, Qt::LeftButton, modifiers, from);
    for (int i = 1; i <= 12; ++i)
        QTest::mouseMove(&widget, from + (to - from) * i / 12);
    QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, to);
}

/// A drop of a colour from elsewhere.
void drop(SwatchGrid &grid, QPoint at, const QColor &colour)
{
    QMimeData data;
    data.setColorData(colour);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&grid, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&grid, &dropped);
}

double distance(const Colour &a, const Colour &b)
{
    return std::max({std::abs(a.red - b.red), std::abs(a.yellow - b.yellow), std::abs(a.blue - b.blue)});
}

} // namespace

class TestColours : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
        setMessageHooks({.error = [this](const QString &message) { m_error = message; }, .unsaved = {}});
    }
    void cleanupTestCase() { setMessageHooks({}); }

    void historyKeepsTheLastSixteen()
    {
        {
            Bench bench;
            ColourPanel panel(bench.editor);
            showAt(panel);
            for (int i = 0; i < 20; ++i) {
                bench.editor.setColour(fromScreen(QColor(10 * i, 40, 90)));
                bench.editor.document().setDraft(makeStroke(99, 1, 10));
                bench.editor.document().setDraft(nullptr);
            }
            const auto &history = panel.history()->swatches();
            QCOMPARE(history.size(), std::size_t(16));
            QCOMPARE(toOpaqueScreen(history[0].colour), QColor(190, 40, 90));
            QCOMPARE(toOpaqueScreen(history[15].colour), QColor(40, 40, 90));
            QTest::mouseClick(panel.history(), Qt::LeftButton, {}, middleOf(*panel.history(), 5));
            QCOMPARE(bench.editor.brush().colour, history[5].colour);
            // One that is used again comes to the front and stands there once.
            bench.editor.document().setDraft(makeStroke(99, 1, 10));
            QCOMPARE(panel.history()->swatches().size(), std::size_t(16));
            QCOMPARE(toOpaqueScreen(panel.history()->swatches()[0].colour), QColor(140, 40, 90));
        }
        Bench next; // another session
        ColourPanel panel(next.editor);
        QCOMPARE(panel.history()->swatches().size(), std::size_t(16));
        QCOMPARE(toOpaqueScreen(panel.history()->swatches()[0].colour), QColor(140, 40, 90));
        QCOMPARE(next.steps(), 0);
    }

    void recentColoursAreOneLineAndTheButtonIsSeen()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        for (const QSize &size : {QSize(200, 258), QSize(296, 258), QSize(320, 420), QSize(420, 900)}) {
            showAt(panel, size);
            for (int i = 0; i < 16; ++i) {
                bench.editor.setColour(fromScreen(QColor(10 * i, 60, 20)));
                bench.editor.document().setDraft(makeStroke(99, 1, 10));
                bench.editor.document().setDraft(nullptr);
            }
            QCoreApplication::processEvents();
            const SwatchGrid &recent = *panel.history();
            QCOMPARE(recent.height(), recent.cell(0).height());
            QVERIFY(recent.cell(1).right() < recent.width());
            QCOMPARE(panel.applyButton()->visibleRegion(), QRegion(panel.applyButton()->rect()));
        }
    }

    /// The wheel makes room for their line before a dock that is not very low would cut it off.
    void recentColoursAreSeenWhole()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        bench.editor.document().setDraft(makeStroke(99, 1, 10));
        bench.editor.document().setDraft(nullptr);
        for (int height = 345; height < 480; height += 15) { // 345: in a window of 1380 x 860
            showAt(panel, {298, height});
            QTest::qWait(5);
            const SwatchGrid &recent = *panel.history();
            QVERIFY2(recent.visibleRegion().boundingRect().height() == recent.height(),
                     qPrintable(QString::number(height)));
        }
    }

    void swatchesAreSeenInLowWindows()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel, {296, 258}); // what a window of 1280 x 800 leaves
        std::vector<Swatch> many(200, Swatch{{}, red});
        bench.editor.push(setSwatches(bench.editor.document(), many), "swatches");
        QCoreApplication::processEvents();
        const SwatchGrid &grid = *panel.swatches()->grid();
        const QRegion seen = grid.visibleRegion();
        for (int i = 0; i < 16; ++i)
            QVERIFY2(seen.contains(grid.cell(i).center()), qPrintable(QString::number(i)));
        QVERIFY(!seen.contains(grid.cell(199).center())); // the rest is scrolled to
        QVERIFY(!panel.rows()->visibleRegion().isEmpty());
    }

    /// The hint that says why takes room from what scrolls, and must not take it from what was typed in.
    void whatWasRefusedStaysInSight()
    {
        Bench bench;
        for (const int height : {160, 180, 200, 220, 240, 260, 280, 300, 340, 400}) {
            ColourPanel panel(bench.editor);
            showAt(panel, {290, height});
            QList<QLineEdit *> fields{panel.hex()};
            for (NumberField *field : panel.findChild<ColourRows *>()->findChildren<NumberField *>())
                fields << field;
            QCOMPARE(fields.size(), 5);
            for (QLineEdit *field : std::as_const(fields)) {
                field->setFocus(Qt::TabFocusReason);
                QTest::qWait(1);
                panel.findChild<QScrollArea *>()->ensureWidgetVisible(field, 0, 0);
                field->selectAll();
                QTest::keyClicks(field, "#zz");
                QTest::keyClick(field, Qt::Key_Return);
                QTest::qWait(1);
                auto *hint = panel.findChild<HintLabel *>();
                QVERIFY(hint->isVisible());
                QVERIFY2(field->visibleRegion().boundingRect() == field->rect(),
                         qPrintable(QString("%1 at %2").arg(field->accessibleName()).arg(height)));
                hint->showHint({});
            }
        }
    }

    /// What CSS calls a colour is one here, as in drawings that come in.
    void coloursAreTypedAsInCss()
    {
        for (const char *text : {"rgb(255, 0, 255)", "#f0f", "ff00ff", "fuchsia", "hsl(300, 100%, 50%)"}) {
            const std::optional<Colour> colour = typedColour(text);
            QVERIFY2(colour, text);
            QCOMPARE(toOpaqueScreen(*colour).name(), QString("#ff00ff"));
        }
        for (const char *text : {"rgb(255, ", "transparent", "#ff00ff80", "nocolour", ""})
            QVERIFY2(!typedColour(text), text);
        Bench bench;
        ColourPanel panel(bench.editor);
        panel.hex()->setText({});
        QTest::keyClicks(panel.hex(), "rgb(0, 128, 255)");
        QTest::keyClick(panel.hex(), Qt::Key_Return);
        QCOMPARE(panel.hex()->text(), QString("#0080ff"));
    }

    void swatchesAreUndoable()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel, {280, 1000});
        SwatchGrid &grid = *panel.swatches()->grid();
        const auto &swatches = [&]() -> const std::vector<Swatch> & {
            return bench.editor.document().painting()->swatches;
        };
        for (const Colour &colour : {yellow, blue, red}) {
            bench.editor.setColour(colour);
            QTest::mouseClick(panel.swatches()->addButton(), Qt::LeftButton);
        }
        QCOMPARE(bench.steps(), 3);
        QCOMPARE(swatches().size(), std::size_t(3));
        QCOMPARE(grid.swatches(), swatches());
        QTest::mouseClick(&grid, Qt::LeftButton, {}, middleOf(grid, 1));
        QCOMPARE(bench.editor.brush().colour, blue);
        QCOMPARE(bench.steps(), 3); // taking one is no edit

        grid.move(0, 3);
        QCOMPARE(swatches()[2].colour, yellow);
        grid.move(2, 0);
        QCOMPARE(swatches()[0].colour, yellow);
        grid.move(1, 2); // where it is
        QCOMPARE(bench.steps(), 5);
        grid.rename(2, "vermilion");
        QCOMPARE(swatches()[2], (Swatch{"vermilion", red}));
        drop(grid, grid.cell(1).topLeft(), QColor("#336699"));
        QCOMPARE(swatches().size(), std::size_t(4));
        QCOMPARE(toOpaqueScreen(swatches()[1].colour).name(), QString("#336699"));
        QTest::mouseClick(&grid, Qt::LeftButton, {}, middleOf(grid, 1));
        QTest::keyClick(&grid, Qt::Key_Right);
        QTest::keyClick(&grid, Qt::Key_Delete);
        QCOMPARE(swatches().size(), std::size_t(3));
        QCOMPARE(swatches()[1].colour.yellow, fromScreen(QColor("#336699")).yellow);
        QCOMPARE(bench.steps(), 8);
        QTest::keyClick(&grid, Qt::Key_Left);
        QTest::keyClick(&grid, Qt::Key_Return);
        QCOMPARE(bench.editor.brush().colour, fromScreen(QColor("#336699")));

        const auto after = swatches();
        bench.editor.undoStack().setIndex(0);
        QVERIFY(swatches().empty() && grid.swatches().empty());
        bench.editor.undoStack().setIndex(8);
        QCOMPARE(swatches(), after);
        QCOMPARE(grid.swatches(), after);
    }

    void palettesInAndOut()
    {
        Bench bench;
        SwatchesSection section(bench.editor);
        const QList<QAction *> menu = section.menuButton()->menu()->actions();
        QVERIFY(!menu[1]->isEnabled()); // nothing to export
        const QString path = m_folder.filePath("three.gpl");
        QVERIFY(writeBytes(path, "GIMP Palette\nName: three\n#\n255 0 0 red\n0 128 0\n0 0 255 blue\n"));
        section.importPalette(path);
        QCOMPARE(bench.steps(), 1);
        QCOMPARE(section.grid()->swatches().size(), std::size_t(3));
        QCOMPARE(section.grid()->swatches()[2].name, QString("blue"));
        section.importPalette(path);
        QCOMPARE(section.grid()->swatches().size(), std::size_t(6));
        QVERIFY(menu[1]->isEnabled());
        const QString out = m_folder.filePath("out.gpl");
        section.exportPalette(out);
        const auto again = readGimpPalette(readBytes(out), out);
        QVERIFY(again);
        QCOMPARE(again->name, QString("out"));
        QCOMPARE(again->swatches, section.grid()->swatches());

        menu.last()->trigger(); // remove all
        QVERIFY(section.grid()->swatches().empty());
        bench.editor.undoStack().undo();
        QCOMPARE(section.grid()->swatches().size(), std::size_t(6));

        QVERIFY(writeBytes(path, "GIMP Palette\n1 2 x\n"));
        const int steps = bench.steps();
        section.importPalette(path);
        QVERIFY2(m_error.contains("three.gpl: line 2"), qPrintable(m_error));
        section.importPalette(m_folder.filePath("gone.gpl"));
        QVERIFY(m_error.contains("gone.gpl"));
        section.exportPalette(m_folder.filePath("no/such/folder.gpl"));
        QVERIFY(m_error.contains("folder.gpl"));
        QCOMPARE(bench.steps(), steps);
    }

    void opaqueSwatchesLeaveTheBrushItsOpacity()
    {
        Bench bench;
        SwatchesSection section(bench.editor);
        showAt(section, {280, 200});
        const QString path = m_folder.filePath("one.gpl");
        QVERIFY(writeBytes(path, "GIMP Palette\n255 0 0 red\n"));
        section.importPalette(path);
        bench.editor.setColour({0, 1, 0, 0.35f});
        QTest::mouseClick(section.grid(), Qt::LeftButton, {}, middleOf(*section.grid(), 0));
        QCOMPARE(bench.editor.brush().colour.red, section.grid()->swatches()[0].colour.red);
        QCOMPARE(bench.editor.brush().colour.opacity, 0.35f);
        QTest::mouseClick(section.addButton(), Qt::LeftButton); // this one has its own
        bench.editor.setColour(blue);
        QTest::mouseClick(section.grid(), Qt::LeftButton, {}, middleOf(*section.grid(), 1));
        QCOMPARE(bench.editor.brush().colour.opacity, 0.35f);
    }

    void padGrowsWithTheDock()
    {
        Bench bench;
        ColourPanel panel(bench.editor);
        showAt(panel, {296, 600});
        const auto heightIn = [&](int height) {
            panel.resize(296, height);
            QTest::qWait(1);
            return panel.mixing()->pad()->height();
        };
        const int low = heightIn(600), high = heightIn(900), highest = heightIn(2000);
        QVERIFY2(high > low + 100, qPrintable(QString("%1 %2").arg(low).arg(high)));
        QVERIFY2(highest >= high && highest <= 400, qPrintable(QString::number(highest)));
        const MixingSection &section = *panel.mixing();
        QVERIFY(section.pad()->y() < 60); // under its buttons
    }

    void padMixesAsPigmentsDo()
    {
        Bench bench;
        MixingSection section(bench.editor);
        showAt(section, {264, 150});
        MixingPad &pad = *section.pad();
        const QPointF left(60, 55), right(200, 55), middle(130, 55);
        QVERIFY(distance(pad.colourAt(middle), {0, 0, 0, 1}) < 0.01); // a clean sheet
        QVERIFY(!section.clearButton()->isEnabled());
        bench.editor.setColour(yellow);
        drag(pad, {40, 55}, {150, 55});
        QVERIFY(section.clearButton()->isEnabled());
        bench.editor.setColour(blue);
        drag(pad, {220, 55}, {110, 55});
        const Colour mixture = pad.colourAt(middle), pureYellow = pad.colourAt(left), pureBlue = pad.colourAt(right);
        QVERIFY(pureYellow.yellow > 0.7f && pureYellow.blue < 0.1f);
        QVERIFY(pureBlue.blue > 0.7f && pureBlue.yellow < 0.1f);
        QVERIFY(mixture.blue > 0.5f && mixture.yellow > 0.4f && mixture.red < 0.1f); // green
        QTest::mouseClick(&pad, Qt::RightButton, {}, middle.toPoint());
        QCOMPARE(bench.editor.brush().colour, mixture);
        QTest::mouseClick(&pad, Qt::LeftButton, Qt::ControlModifier, left.toPoint());
        QCOMPARE(bench.editor.brush().colour, pureYellow);
        QCOMPARE(bench.steps(), 0); // no part of the document
        QTest::mouseClick(section.clearButton(), Qt::LeftButton);
        QVERIFY(distance(pad.colourAt(middle), {0, 0, 0, 1}) < 0.01);
        QVERIFY(!section.clearButton()->isEnabled());
    }

    void padRubs()
    {
        Bench bench;
        MixingSection section(bench.editor);
        showAt(section, {264, 150});
        MixingPad &pad = *section.pad();
        bench.editor.setColour(red);
        QTest::mouseClick(&pad, Qt::LeftButton, {}, {60, 55});
        const Colour bare = pad.colourAt({100, 55});
        QVERIFY(distance(bare, {0, 0, 0, 1}) < 0.02);
        drag(pad, {60, 55}, {120, 55}, Qt::ShiftModifier);
        const Colour near = pad.colourAt({85, 55}), far = pad.colourAt({118, 55});
        QVERIFY(near.red > 0.3f);    // red was carried over
        QVERIFY(far.red < near.red); // and got less on the way
        QVERIFY(near.yellow < 0.15f && near.blue < 0.15f);
        QCOMPARE(bench.editor.brush().colour, red);
        pad.resize(200, 110); // what is painted stays
        QVERIFY(distance(pad.colourAt({85, 55}), near) < 0.02);
    }

    void papersAreChosen()
    {
        Bench bench;
        InspectorPanel panel(bench.editor);
        showAt(panel);
        CanvasSection &section = *panel.canvasSection();
        QComboBox &choice = *section.paperChoice();
        const auto paper = [&] { return bench.editor.document().painting()->canvas.paper; };
        const int presets = int(paperPresets().size());
        QCOMPARE(choice.count(), presets + 2); // none, an image
        QCOMPARE(choice.currentIndex(), 0);
        std::vector<QImage> thumbnails;
        for (int i = 1; i <= presets; ++i) {
            emit choice.activated(i);
            QCOMPARE(presetOf(paper()), i - 1);
            QCOMPARE(choice.currentIndex(), i);
            QCOMPARE(bench.steps(), i);
            thumbnails.push_back(choice.itemIcon(i).pixmap(choice.iconSize()).toImage());
            QVERIFY(!thumbnails.back().isNull());
            for (int k = 0; k + 1 < i; ++k)
                QVERIFY(thumbnails[std::size_t(k)] != thumbnails.back());
        }
        emit section.paperScale()->edited(9.5, nullptr); // the grain stays
        QCOMPARE(paper().grain, PaperGrain::Weave);
        QCOMPARE(paper().scale, 9.5f);
        QCOMPARE(choice.currentText(), QString("Custom"));
        emit choice.activated(0);
        QCOMPARE(paper().kind, PaperKind::None);
        bench.editor.undoStack().undo();
        bench.editor.undoStack().undo();
        QCOMPARE(choice.currentIndex(), presets);
    }

private:
    static bool writeBytes(const QString &path, const QByteArray &bytes)
    {
        QFile file(path);
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
    }
    static QByteArray readBytes(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    QTemporaryDir m_folder;
    QString m_error;
};

QTEST_MAIN(TestColours)
#include "test_colours.moc"

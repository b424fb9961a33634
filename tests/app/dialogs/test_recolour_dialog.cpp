// Recolour Artwork: what of a painting becomes of which colour.
#include "app/dialogs/recolour_dialog.h"
#include "app/panels/colour/colour_panel.h"
#include "app/session/settings/settings.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/colour/colour_wheel.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/numbers/bar_slider.h"
#include "app/widgets/numbers/number_field.h"
#include "model/colour/colour_shift.h"
#include "tests/app/panel_bench.h"
#include "tests/app/two_waves.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace suffuse;

class TestRecolourDialog : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("colour"); }

    void artworkIsRecoloured()
    {
        TwoWaves s;
        s.addSwatches({{"leaf", green}, {"roof", red}});
        s.select({s.second});
        type(*s.panel.hex(), "#c0ffee");
        s.select({});
        const PaintingPtr now = s.editor().document().painting();
        const int steps = s.steps();
        {
            RecolourDialog dialog(s.editor(), &s.window);
            dialog.show();
            QVERIFY(QTest::qWaitForWindowExposed(&dialog));
            QTreeWidget &list = *dialog.list();
            QCOMPARE(list.topLevelItemCount(), 2);
            const int row = dialog.recolouring().uses()[0].colour == waveColour ? 0 : 1;
            list.setCurrentItem(list.topLevelItem(row));
            QTest::mousePress(dialog.wheel(), Qt::LeftButton, {}, dialog.wheel()->ringPoint(0.5).toPoint());
            QVERIFY(farthest(s.colour(s.id), waveColour) > 0.1); // it shows at once
            QTest::mouseRelease(dialog.wheel(), Qt::LeftButton, {}, dialog.wheel()->ringPoint(0.5).toPoint());
            type(*dialog.hex(), "#ff0000");
            QCOMPARE(s.colour(s.id), red);
            QVERIFY(dialog.isVisible()); // Return did not close it
            QCOMPARE(list.topLevelItem(row)->text(1), QString("#ff0000"));
            SwatchGrid &grid = *dialog.swatches();
            QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cell(0).center());
            QCOMPARE(s.colour(s.id), green);
            list.selectAll();
            QTest::mouseClick(dialog.resetButton(), Qt::LeftButton);
            QVERIFY(s.painting() == *now);
            type(*dialog.saturation()->number(), "0");
            QVERIFY(isGrey(s.colour(s.id)) && isGrey(s.colour(s.second)));
            type(*dialog.saturation()->number(), "100");
            QVERIFY(s.painting() == *now);
            dialog.mapsBox()->click();
            QCOMPARE(s.colour(s.second), green);
            QCOMPARE(s.colour(s.id), red);
            QCOMPARE(s.steps(), steps);
            QTest::keyClick(&dialog, Qt::Key_Escape);
            QVERIFY(!dialog.isVisible());
        }
        QVERIFY(s.painting() == *now);
        QCOMPARE(s.steps(), steps);
        {
            RecolourDialog dialog(s.editor(), &s.window);
            dialog.mapsBox()->click();
            dialog.accept();
        }
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Recolour artwork"));
        QCOMPARE(s.colour(s.id), red);
        s.use(Command::Undo);
        QVERIFY(s.painting() == *now);
        s.select({s.id});
        RecolourDialog dialog(s.editor(), &s.window);
        QCOMPARE(dialog.list()->topLevelItemCount(), 1); // of what is selected
    }

    /// A drag that was given up leaves nothing that would have to be saved.
    void artworkAsItWasIsNotModified()
    {
        TwoWaves s;
        QSignalSpy saved(&s.editor(), &Editor::saved);
        s.editor().startSaving(m_folder.filePath("asItWas.suffuse"), true);
        QVERIFY(saved.wait() && !s.editor().isModified());
        RecolourDialog dialog(s.editor(), &s.window);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        BarSlider &slider = *dialog.saturation()->slider();
        for (const bool givesUp : {true, false}) {
            QTest::mousePress(&slider, Qt::LeftButton, {}, along(slider, 0.5));
            QTest::mouseMove(&slider, along(slider, 0.1));
            QVERIFY(s.editor().isModified() && s.window.isWindowModified());
            if (givesUp)
                QTest::keyClick(&slider, Qt::Key_Escape);
            QTest::mouseRelease(&slider, Qt::LeftButton, {}, along(slider, 0.1));
            QCOMPARE(s.editor().isModified(), !givesUp);
            QCOMPARE(s.window.isWindowModified(), !givesUp);
            QCOMPARE(s.isAsBefore(), givesUp);
        }
        type(*dialog.saturation()->number(), "100"); // as it was by hand
        QVERIFY(s.isAsBefore() && !s.editor().isModified());
        dialog.reject();
        QVERIFY(s.isAsBefore() && !s.editor().isModified());
    }

    void artworkIsRecolouredStepByStep()
    {
        TwoWaves s;
        s.addSwatches({{"leaf", green}, {"roof", red}});
        const PaintingPtr now = s.editor().document().painting();
        const int steps = s.steps();
        const Colour was = s.colour(s.id);
        RecolourDialog dialog(s.editor(), &s.window);
        dialog.setStepKeys({QKeySequence("Ctrl+Z")}, {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
        dialog.setModal(true); // as the command opens it
        dialog.show();
        QVERIFY(QTest::qWaitForWindowActive(&dialog));
        dialog.list()->selectAll();
        SwatchGrid &grid = *dialog.swatches();
        grid.setFocus();
        QTest::keyClick(&grid, Qt::Key_Space);
        QCOMPARE(s.colour(s.id), green);
        QTest::keyClick(&grid, Qt::Key_Right);
        QTest::keyClick(&grid, Qt::Key_Space);
        QCOMPARE(s.colour(s.id), red);
        type(*dialog.saturation()->number(), "0");
        dialog.mapsBox()->click();
        grid.setFocus();
        for (int undone = 0; undone < 2; ++undone)
            QTest::keyClick(&grid, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.colour(s.id), red);
        QVERIFY(!dialog.mapsBox()->isChecked());
        QCOMPARE(dialog.saturation()->number()->text(), QString("100 %"));
        QCOMPARE(dialog.hex()->text(), QString("#ff0000"));
        QTest::keyClick(&grid, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.colour(s.id), green);
        QTest::keyClick(&grid, Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(s.colour(s.id), red);
        for (int undone = 0; undone < 5; ++undone) // more than there are
            QTest::keyClick(&grid, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(s.colour(s.id), was);
        QVERIFY(s.painting() == *now);
        QTest::keyClick(&grid, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(s.colour(s.id), green);
        QCOMPARE(s.steps(), steps);
        QVERIFY(dialog.isVisible());
        QTest::keyClick(&grid, Qt::Key_Return); // is OK, and takes no swatch
        QVERIFY(!dialog.isVisible());
        QCOMPARE(s.colour(s.id), green);
        QCOMPARE(s.steps(), steps + 1);
    }

    /// The list of Recolour Artwork shows all of its columns at the size with which the dialog opens.
    void recolourArtworkShowsAllColumns()
    {
        TwoWaves s;
        RecolourDialog dialog(s.editor(), &s.window);
        dialog.show();
        QApplication::processEvents();
        QVERIFY(dialog.list()->header()->length() <= dialog.list()->viewport()->width());
        dialog.reject();
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestRecolourDialog)
#include "test_recolour_dialog.moc"

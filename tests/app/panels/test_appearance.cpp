// Brushes and appearances that are put on strokes, and random variation; each by events, as one step, and given up.
#include "app/dialogs/vary_dialog.h"
#include "app/panels/brushes/brush_menu.h"
#include "app/session/commands/restyling.h"
#include "app/session/settings/settings.h"
#include "app/tools/brush/eyedropper_tool.h"
#include "app/widgets/numbers/number_field.h"
#include "model/brush/stroke_builder.h"
#include "tests/app/scaled.h"
#include "tests/app/shapes.h"

#include <QComboBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// A session with two painted strokes: a brush pen's, selected, and a marker's below it.
struct TwoPainted : WaveSession {
    StrokeId pen = 0, marker = 0;

    TwoPainted()
    {
        pen = paint("brush-pen", 200);
        marker = paint("gouache", 400);
        editor().document().setSelection({{pen}, {}});
        editor().clock().setTime(painting().end());
    }
    StrokeId paint(const char *brush, double y)
    {
        std::vector<PenSample> samples;
        for (int i = 0; i <= 100; ++i)
            samples.push_back({{150 + 4.0 * i, y}, Microseconds(i) * 8000, float(0.3 + 0.006 * i)});
        const StrokeId id = editor().document().takeStrokeId();
        editor().push(addStrokes(editor().document(), {buildStroke(*findBrush(brush), id, samples)}, true), brush);
        return id;
    }
};

} // namespace

class TestAppearance : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("vary"); }

    void aBrushIsPutOnStrokes()
    {
        TwoPainted s;
        const auto before = s.editor().document().painting();
        s.editor().setBrush(*findBrush("dry-brush"));
        const int steps = s.steps();
        s.use(Command::ApplyBrush);
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Apply brush"));
        QCOMPARE(s.stroke(s.pen).brush, QString("dry-brush"));
        QVERIFY(s.stroke(s.pen).style == findBrush("dry-brush")->style);
        QVERIFY(s.stroke(s.marker) == *before->find(s.marker));
        // The pressure rose along the stroke, and is heard again.
        const std::vector<Segment> &segments = s.stroke(s.pen).segments;
        const std::size_t n = segments.size();
        QVERIFY(segments[n / 6].diffusion < segments[n / 2].diffusion);
        QVERIFY(segments[n / 2].diffusion < segments[5 * n / 6].diffusion);
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);

        s.use(Command::ApplyBrushColour);
        QVERIFY(s.stroke(s.pen).segments[5].colour == findBrush("dry-brush")->colour);
        QCOMPARE(s.stroke(s.pen).brush, QString("brush-pen"));
        s.use(Command::ApplyBrushTexture);
        QVERIFY(s.stroke(s.pen).style == findBrush("dry-brush")->style);
        s.use(Command::ApplyBrushForm);
        QCOMPARE(s.steps(), steps + 3);
    }

    void partsOfStrokesAreRestyled()
    {
        TwoPainted s;
        Selection part{{s.pen}, {}};
        for (int k = 10; k < 20; ++k)
            part.segments.insert({s.pen, k});
        s.editor().document().setSelection(part);
        s.editor().setBrush(*findBrush("flat-marker"));
        const Stroke before = s.stroke(s.pen);
        s.use(Command::ApplyBrush);
        QCOMPARE(s.stroke(s.pen).segments[5], before.segments[5]);
        QVERIFY(s.stroke(s.pen).segments[15].style == findBrush("flat-marker")->style);
        QVERIFY(s.selection() == part);
    }

    void theBrushesDockAppliesTheBrush()
    {
        TwoPainted s;
        auto *menu = s.window.findChild<BrushMenu *>();
        QVERIFY(menu);
        emit menu->aboutToShow();
        QAction *colour = nullptr;
        for (QMenu *apply : menu->findChildren<QMenu *>())
            for (QAction *action : apply->actions())
                if (action->text().remove('&') == "Colour Only")
                    colour = action;
        QVERIFY(colour);
        s.editor().setColour({0.1f, 0.2f, 0.3f, 0.9f});
        colour->trigger();
        QVERIFY(s.stroke(s.pen).segments[3].colour == (Colour{0.1f, 0.2f, 0.3f, 0.9f}));
    }

    void lockedStrokesAreLeftAlone()
    {
        TwoPainted s;
        s.use(Command::CopyAppearance);
        s.use(Command::LockStrokes);
        s.editor().document().setSelection({{s.pen}, {}});
        const auto before = s.editor().document().painting();
        QSignalSpy said(s.window.findChild<Commands *>(), &Commands::said);
        for (const Command command :
             {Command::ApplyBrush, Command::ApplyBrushForm, Command::ApplyBrushColour, Command::ApplyBrushTexture,
              Command::PasteAppearance, Command::PasteAppearanceEvenly, Command::VaryStrokes}) // no dialog opens
            s.use(command);
        QVERIFY(s.painting() == *before);
        QCOMPARE(said.size(), 7);
        s.editor().document().setSelection({});
        QVERIFY(!s.window.action(Command::ApplyBrush).isEnabled());
        QVERIFY(!s.window.action(Command::PasteAppearance).isEnabled());
    }

    void appearanceIsCopiedAndPasted()
    {
        TwoPainted s;
        const Stroke pen = s.stroke(s.pen), marker = s.stroke(s.marker);
        s.editor().document().setSelection({{s.marker}, {}});
        s.use(Command::CopyAppearance);
        s.editor().document().setSelection({{s.pen}, {}});
        const int steps = s.steps();
        s.use(Command::PasteAppearance);
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(s.stroke(s.pen).style == marker.style);
        const double factor = double(s.stroke(s.pen).segments[0].diffusion) / double(pen.segments[0].diffusion);
        QVERIFY(areScaled(pen, s.stroke(s.pen), &Segment::diffusion, factor));
        s.use(Command::PasteAppearanceEvenly);
        QCOMPARE(s.stroke(s.pen).segments[0].diffusion, s.stroke(s.pen).segments[30].diffusion);
        s.use(Command::Undo);
        s.use(Command::Undo);
        QVERIFY(s.stroke(s.pen) == pen);
    }

    void theEyedropperMatches()
    {
        TwoPainted s;
        const auto before = s.editor().document().painting();
        const Colour inHand = s.editor().brush().colour;
        s.use(Command::Eyedropper);
        auto *tool = dynamic_cast<EyedropperTool *>(s.canvas().tool());
        QVERIFY(tool);
        tool->setMatches(true);
        QVERIFY(tool->hint().contains("appearance"));
        const int steps = s.steps();
        const auto press = [&](Point at) { QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at(at)); };
        press({350, 400});
        QVERIFY(s.stroke(s.pen).style == s.stroke(s.marker).style);
        QCOMPARE(s.steps(), steps);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QVERIFY(s.painting() == *before);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 400}));
        QCOMPARE(s.steps(), steps);
        s.click({350, 400});
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Match"));
        QVERIFY(s.stroke(s.marker) == *before->find(s.marker));
        s.click({600, 600}); // no stroke
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(s.editor().brush().colour == inHand);
        QVERIFY(s.selection().strokes == std::set<StrokeId>{s.pen});
        s.editor().document().setSelection({});
        QVERIFY(tool->hint().startsWith("Select"));
        s.click({350, 400});
        QCOMPARE(s.steps(), steps + 1);
        tool->setMatches(false);
        s.click({350, 400});
        QVERIFY(!(s.editor().brush().colour == inHand));
    }

    /// One click without a command: the modifier makes the difference.
    void theEyedropperMatchesWithCtrl()
    {
        TwoPainted s;
        s.use(Command::Select);
        s.editor().document().setSelection({{s.pen}, {}});
        const Colour inHand = s.editor().brush().colour;
        const auto before = s.editor().document().painting();
        s.use(Command::Eyedropper);
        QVERIFY(s.canvas().tool()->hint().contains("Ctrl: its whole appearance"));
        const int steps = s.steps();
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, Qt::ControlModifier, s.at({350, 400}));
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Match"));
        QVERIFY(s.stroke(s.pen).style == s.stroke(s.marker).style);
        QVERIFY(s.editor().brush().colour == inHand);
        QVERIFY(s.stroke(s.marker) == *before->find(s.marker));
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, s.at({350, 400})); // without it a colour is taken, as ever
        QVERIFY(s.editor().undoText() != "Match");
    }

    void matchIsACommand()
    {
        TwoPainted s;
        s.use(Command::Select);
        s.editor().document().setSelection({});
        QVERIFY(!s.window.action(Command::MatchAppearance).isEnabled());
        s.editor().document().setSelection({{s.pen}, {}});
        const Colour inHand = s.editor().brush().colour;
        const int steps = s.steps();
        s.use(Command::MatchAppearance);
        auto *tool = dynamic_cast<EyedropperTool *>(s.canvas().tool());
        QVERIFY(tool);
        QVERIFY(s.window.action(Command::Eyedropper).isChecked());
        QVERIFY(tool->hint().startsWith("Click a stroke"));
        s.click({350, 400});
        QCOMPARE(s.steps(), steps + 1);
        QVERIFY(s.stroke(s.pen).style == s.stroke(s.marker).style);
        QVERIFY(s.editor().brush().colour == inHand);
        s.use(Command::Undo);
        s.use(Command::Select); // With another tool matching is over.
        s.use(Command::Eyedropper);
        QVERIFY(!tool->hint().startsWith("Click a stroke"));
        s.editor().document().setSelection({});
        s.click({350, 400});
        QCOMPARE(s.steps(), steps + 1); // That which is undone; the click took a colour.
        QVERIFY(!(s.editor().brush().colour == inHand));
    }

    void variationIsRolled()
    {
        TwoPainted s;
        const auto before = s.editor().document().painting();
        const int steps = s.steps();
        {
            VaryDialog dialog(s.editor(), &s.window);
            const QString command = s.window.action(Command::VaryStrokes).text();
            QCOMPARE(dialog.windowTitle() + QStringLiteral("…"), QString(command).remove('&'));
            QVERIFY(!(s.painting() == *before)); // it shows at once
            QCOMPARE(s.steps(), steps);
            const Painting first = s.painting();
            QTest::mouseClick(dialog.rollButton(), Qt::LeftButton);
            QVERIFY(!(s.painting() == first));
            emit dialog.field(&VaryAmounts::density)->entered(0);
            emit dialog.field(&VaryAmounts::lightness)->entered(0);
            QVERIFY(s.painting() == *before); // nothing strays
            emit dialog.field(&VaryAmounts::diffusion)->entered(0.5);
            dialog.per()->setCurrentIndex(VaryAmounts::EachSegment);
            QVERIFY(!areScaled(*before->find(s.pen), s.stroke(s.pen), &Segment::diffusion,
                               double(s.stroke(s.pen).segments[0].diffusion) /
                                   double(before->find(s.pen)->segments[0].diffusion)));
            dialog.accept();
        }
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Vary"));
        QVERIFY(s.stroke(s.marker) == *before->find(s.marker));
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);
        const VaryAmounts remembered = commands::storedVariation();
        QCOMPARE(remembered.diffusion, 0.5);
        QCOMPARE(remembered.per, VaryAmounts::EachSegment);
    }

    void cancelTakesVariationBack()
    {
        TwoPainted s;
        const auto before = s.editor().document().painting();
        const int steps = s.steps();
        VaryDialog dialog(s.editor(), &s.window);
        dialog.show();
        QVERIFY(!(s.painting() == *before));
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.steps(), steps);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestAppearance)
#include "test_appearance.moc"

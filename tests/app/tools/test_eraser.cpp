// The eraser: it lifts paint or cuts it, as far as it is meant to, and says what it did.
#include "app/session/current_layer.h"
#include "app/session/settings/settings.h"
#include "app/tools/shaping/eraser_tool.h"
#include "model/painting/influence.h"
#include "model/shaping/shapes.h"
#include "tests/app/tools/eraser_session.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"
#include "undo/layers/group_edits.h"

#include <QComboBox>
#include <QSettings>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

/// Where pictures differ, in their pixels.
QRect differing(const QImage &a, const QImage &b)
{
    QRect box;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y))
                box |= QRect(x, y, 1, 1);
    return box;
}

} // namespace

class TestEraser : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void itLiftsInOneStepAndChangesNothingElse()
    {
        EraserSession s;
        const auto before = s.editor().document().painting();
        const QImage picture = s.pictureNow();
        s.erase({350, 250}, {350, 390});
        QCOMPARE(s.steps(), 3);
        QCOMPARE(s.editor().undoText(), EraserTool::tr("Erase"));
        QCOMPARE(s.painting().strokes.size(), std::size_t(2)); // one stroke stays one
        QVERIFY(s.erasing(s.id) > 2);
        QCOMPARE(s.erasing(s.other), 0);
        const Stroke &stroke = s.stroke();
        QVERIFY(std::equal(before->strokes[0]->segments.begin(), before->strokes[0]->segments.end(),
                           stroke.segments.begin()));
        const QImage erased = s.pictureNow();
        Rect influence;
        for (const Segment &segment : stroke.segments)
            if (segment.lift)
                influence = influence.united(influenceOf(stroke, segment, s.editor().clock().time()));
        const QRect changed = differing(picture, erased);
        QVERIFY(!changed.isEmpty());
        for (const QPoint corner : {changed.topLeft(), changed.bottomRight()}) {
            const Point at = s.canvas().view().toCanvas({double(corner.x()), double(corner.y())});
            QVERIFY(influence.grown(1).contains(at)); // outside of it every pixel has its bits
        }
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);
        QCOMPARE(s.pictureNow(), picture);
        s.use(Command::Redo);
        QCOMPARE(s.pictureNow(), erased);
    }

    void visiblePaintFarFromTheCurve()
    {
        EraserSession s;
        const Point curve = s.stroke().cubicOf(s.stroke().segments[1]).at(0.5);
        double distance = 0;
        const Point beside = curve + Point{4, 11};
        nearestPlace(s.stroke(), beside, &distance);
        s.eraser().setRadius(3);
        QVERIFY(distance > 2 * s.eraser().radius());
        s.erase(beside, beside + Point{12, 4});
        QVERIFY(s.erasing(s.id) > 0);
        s.use(Command::Undo);
        s.erase(beside, beside + Point{12, 4}, Qt::ShiftModifier); // cuts: there is no curve
        QCOMPARE(s.steps(), 3);                                    // that which is undone
        QVERIFY2(s.hint().startsWith("Nothing is cut"), qPrintable(s.hint()));
    }

    /// Fills whose edges are softer than the cut is wide close over it, which is said.
    void aCutThatASoftFillClosesIsSaid()
    {
        for (const bool soft : {true, false}) {
            EraserSession s;
            const StrokeId id = s.editor().document().takeStrokeId();
            Stroke square = strokeAlong(outlineOf({}, {300, 100}, {700, 300}), Brush(), id, 0);
            for (Segment &segment : square.segments)
                segment.density = 0;
            Fill fill = usualFill(square);
            fill.maxAge = 1;
            fill.diffusion = soft ? 1'000 : 1; // a spread of 63, and of 2
            square.fill = fill;
            s.editor().push(addStrokes(s.editor().document(), {std::make_shared<const Stroke>(square)}, false), "wash");
            s.advance(5'000'000);
            s.erase({500, 60}, {500, 340}, Qt::ShiftModifier);
            QVERIFY(s.stroke(id) != square);
            QCOMPARE(s.hint().startsWith("It was cut, but hardly a gap is seen"), soft);
        }
    }

    /// The same of strokes that spread further than the cut is wide.
    void aCutThatASoftStrokeClosesIsSaid()
    {
        for (const double spread : {90.0, 4.0}) {
            EraserSession s;
            const StrokeId id = s.editor().document().takeStrokeId();
            Stroke line = strokeAlong(outlineOf({}, {300, 150}, {700, 152}), Brush(), id, 0);
            for (Segment &segment : line.segments) {
                segment.maxAge = 1, segment.diffusion = float(0.25 * spread * spread);
                segment.density = float(3 * spread);
            }
            s.editor().push(addStrokes(s.editor().document(), {std::make_shared<const Stroke>(line)}, false), "line");
            s.advance(5'000'000);
            s.erase({500, 100}, {500, 200}, Qt::ShiftModifier);
            QVERIFY(s.stroke(id) != line);
            QCOMPARE(s.hint().startsWith("It was cut, but hardly a gap is seen"), spread > 20);
        }
    }

    /// What Shift does is said as soon as it is held, and no longer.
    void theHintFollowsShift()
    {
        for (const EraserMode mode : {EraserMode::Fade, EraserMode::Lift}) {
            const QString name = mode == EraserMode::Fade ? "Fade" : "Lift";
            EraserSession s(mode);
            s.canvas().setFocus();
            QVERIFY(s.hint().startsWith(name));
            QTest::keyPress(&s.canvas(), Qt::Key_Shift);
            QVERIFY2(s.hint().startsWith("Cut"), qPrintable(s.hint()));
            QTest::keyRelease(&s.canvas(), Qt::Key_Shift);
            QVERIFY2(s.hint().startsWith(name), qPrintable(s.hint()));
            // While it cuts, Shift is the soft way that was chosen last.
            EraserChoice cutting = s.eraser().choice();
            cutting.setMode(EraserMode::Cut);
            s.eraser().setChoice(cutting);
            QVERIFY(s.hint().startsWith("Cut"));
            QTest::keyPress(&s.canvas(), Qt::Key_Shift);
            QVERIFY2(s.hint().startsWith(name), qPrintable(s.hint()));
            QTest::keyRelease(&s.canvas(), Qt::Key_Shift);
            QCOMPARE(EraserChoice::stored(), cutting);
        }
    }

    /// What was chosen before there was fading keeps its meaning; who has chosen nothing fades.
    void storedChoicesKeepTheirMeaning()
    {
        QSettings &settings = settings::store();
        const auto stored = [&](const char *mode) {
            settings.remove("eraser/soft");
            settings.remove("eraser/mode");
            if (*mode)
                settings.setValue("eraser/mode", mode);
            const EraserChoice choice = EraserChoice::stored();
            return std::pair(choice.mode, choice.soft);
        };
        QCOMPARE(stored("lift"), std::pair(EraserMode::Lift, EraserMode::Lift));
        QCOMPARE(stored("cut"), std::pair(EraserMode::Cut, EraserMode::Lift));
        QCOMPARE(stored(""), std::pair(EraserMode::Fade, EraserMode::Fade));
    }

    void escapeAndUndoGiveItUp()
    {
        EraserSession s;
        const auto before = s.editor().document().painting();
        for (const bool escape : {true, false}) {
            s.erase({350, 250}, {350, 390}, {}, false);
            QVERIFY(s.erasing(s.id) > 0); // the button is still down
            QVERIFY(s.editor().clock().isDrawing());
            if (escape)
                QTest::keyClick(&s.canvas(), Qt::Key_Escape);
            else
                s.use(Command::Undo);
            QVERIFY(!s.editor().clock().isDrawing());
            QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({350, 390}));
            QVERIFY(s.painting() == *before);
            QCOMPARE(s.steps(), 2);
        }
    }

    void itKeepsToItsScope()
    {
        EraserSession s;
        s.editor().document().setSelection({{s.other}, {}});
        s.erase({350, 250}, {350, 500}); // over both
        QCOMPARE(s.erasing(s.id), 0);
        QVERIFY(s.erasing(s.other) > 0);
        QVERIFY(s.hint().contains("selected"));
        s.use(Command::Undo);
        s.erase({350, 250}, {350, 370});
        QVERIFY2(s.hint().contains("not selected"), qPrintable(s.hint()));
        EraserChoice choice;
        choice.setMode(EraserMode::Lift);
        choice.scope = EraserScope::All;
        s.eraser().setChoice(choice);
        s.erase({350, 250}, {350, 500});
        QVERIFY(s.erasing(s.id) > 0 && s.erasing(s.other) > 0);
        s.use(Command::Undo);
        // The group of what is selected, or else the current layer, or else the group of what is pressed.
        s.editor().push(groupSelection(s.editor().document(), "group"), "group");
        choice.scope = EraserScope::Group;
        s.eraser().setChoice(choice);
        s.erase({350, 250}, {350, 500});
        QCOMPARE(s.erasing(s.id), 0);
        QVERIFY(s.erasing(s.other) > 0);
        s.use(Command::Undo);
        s.editor().document().setSelection({});
        s.erase({350, 320}, {350, 500}); // begins on the one that is in no group
        QVERIFY(s.erasing(s.id) > 0);
        QCOMPARE(s.erasing(s.other), 0);
        s.use(Command::Undo);
        s.editor().layer().choose(s.editor().document().painting()->find(s.other)->group);
        s.erase({350, 320}, {350, 500});
        QCOMPARE(s.erasing(s.id), 0);
        QVERIFY(s.erasing(s.other) > 0);
        s.use(Command::Undo);
        s.editor().layer().choose(0);
        s.editor().document().setSelection({{s.id}, {}});
        s.erase({350, 400}, {350, 500});
        QVERIFY2(s.hint().contains("another group"), qPrintable(s.hint()));
    }

    void itSaysWhyItTookNothing()
    {
        EraserSession s;
        const int steps = s.steps();
        s.erase({700, 600}, {760, 600});
        QVERIFY2(s.hint().contains("no paint is seen"), qPrintable(s.hint()));
        s.hover({350, 320});
        s.editor().push(setLocked(s.editor().document(), {s.id}, true), "lock");
        s.erase({350, 250}, {350, 380});
        QVERIFY2(s.hint().contains("locked"), qPrintable(s.hint()));
        QCOMPARE(s.erasing(s.id), 0);
        QCOMPARE(s.steps(), steps + 1);
        s.use(Command::Undo);
        QVERIFY(s.hint().startsWith("Lift")); // it has gone with what it told of
    }

    void modeAndStrength()
    {
        EraserSession s;
        QVERIFY(s.hint().startsWith("Lift"));
        const QCursor soft = s.eraser().cursor();
        s.hover({350, 320}, Qt::ShiftModifier);
        QVERIFY(s.hint().startsWith("Cut"));
        QCOMPARE(s.eraser().cursor().shape(), Qt::CrossCursor);
        QVERIFY(soft.shape() != Qt::CrossCursor);
        s.hover({350, 320});
        QVERIFY(s.hint().startsWith("Lift"));
        auto *modes = s.eraser().options()->findChild<QComboBox *>();
        modes->setCurrentIndex(2);
        emit modes->activated(2);
        QCOMPARE(s.eraser().choice().mode, EraserMode::Cut);
        QVERIFY(s.hint().startsWith("Cut"));
        s.erase({350, 250}, {350, 390});
        QCOMPARE(chainsOf(s.stroke()).size(), std::size_t(2));
        QVERIFY(!s.stroke().hasErasure());
        QCOMPARE(EraserChoice::stored().mode, EraserMode::Cut); // it is remembered
        s.erase({550, 250}, {550, 390}, Qt::ShiftModifier);
        QVERIFY(s.stroke().hasErasure());
        s.eraser().setChoice({});
        s.use(Command::LessOpacity);
        s.use(Command::LessOpacity);
        QVERIFY(std::abs(s.eraser().choice().strength - 0.8) < 1e-9);
        for (int i = 0; i < 12; ++i)
            s.use(Command::LessOpacity);
        QVERIFY(s.eraser().choice().strength > 0);
        s.use(Command::MoreOpacity);
        QVERIFY(std::abs(s.eraser().choice().strength - 0.2) < 1e-9);
        s.eraser().setChoice({});
    }

    /// In the row, not only where the pointer rests.
    void theRowSaysWhatLiftingDoes()
    {
        EraserSession s;
        auto *fields = s.window.findChild<EraserFields *>();
        QVERIFY(fields && fields->liftNote()->isVisible());
        QVERIFY(fields->liftNote()->text().contains("edges draw in"));
        for (const EraserMode mode : {EraserMode::Fade, EraserMode::Cut}) {
            s.choose(mode);
            QVERIFY(!fields->liftNote()->isVisible());
        }
        s.choose(EraserMode::Lift);
        QVERIFY(fields->liftNote()->isVisible());
    }

    void aPensPressureIsItsStrength()
    {
        const auto densityOf = [](double pressure) {
            EraserSession s;
            Pen pen;
            pen.send(s.canvas(), QEvent::TabletPress, s.at({350, 250}), pressure);
            for (int i = 1; i <= 12; ++i) {
                s.advance(interval);
                pen.send(s.canvas(), QEvent::TabletMove, s.at(Point{350, 250 + i * 11.0}), pressure);
            }
            pen.send(s.canvas(), QEvent::TabletRelease, s.at({350, 390}), 0);
            double most = 0;
            for (const Segment &segment : s.stroke().segments)
                most = segment.lift ? std::max(most, double(segment.density)) : most;
            return most;
        };
        QVERIFY(densityOf(0.3) > 0);
        QVERIFY(densityOf(0.3) < 0.2 * densityOf(1));
    }

    void theScopeSaysWhatIsMeant()
    {
        EraserSession s;
        auto *scopes = s.eraser().options()->findChildren<QComboBox *>().at(1);
        QCOMPARE(scopes->itemText(0), QString("All (None Selected)"));
        s.editor().document().setSelection({{s.id}, {}});
        QCOMPARE(scopes->itemText(0), QString("Selected Strokes"));
        QVERIFY(s.hint().contains("selected"));
        QCOMPARE(scopes->count(), 3);
        s.editor().document().setSelection({});
        const auto rows = [&] {
            QStringList texts;
            for (int i = 0; i < scopes->count(); ++i)
                texts << scopes->itemText(i);
            return texts;
        };
        const auto chosen = [&](int row) {
            scopes->setCurrentIndex(row);
            emit scopes->activated(row);
            return s.eraser().choice().scope;
        };
        // No two rows mean the same, and each chooses what it says.
        QCOMPARE(rows(), (QStringList{"All (None Selected)", "Current Group"}));
        QCOMPARE(chosen(1), EraserScope::Group);
        QCOMPARE(scopes->currentText(), QString("Current Group"));
        QCOMPARE(chosen(0), EraserScope::Selected);
        s.editor().document().setSelection({{s.id}, {}});
        QCOMPARE(chosen(2), EraserScope::All);
        s.editor().document().setSelection({});
        QCOMPARE(rows(), (QStringList{"Current Group", "All Strokes"}));
        QCOMPARE(scopes->currentText(), QString("All Strokes"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestEraser)
#include "test_eraser.moc"

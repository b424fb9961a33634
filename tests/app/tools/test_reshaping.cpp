// Simplify, smooth, straighten, grow, shrink and offset, as a user has them.
#include "app/dialogs/reshape_dialog.h"
#include "app/session/settings/settings.h"
#include "app/widgets/numbers/number_field.h"
#include "model/brush/stroke_fit.h"
#include "model/painting/validate.h"
#include "tests/app/trunk.h"
#include "undo/edits.h"

#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

double widthOf(const Segment &s)
{
    return std::sqrt(4 * double(s.diffusion) * double(s.maxAge));
}

/// A wave of four segments of paint, out of which two bent segments take some: no. 4 and 5.
struct ErasedSession : WaveSession {
    ErasedSession()
    {
        const auto erase = [](Stroke &stroke) {
            std::vector<Segment> lifts(stroke.segments.begin(), stroke.segments.begin() + 2);
            for (Segment &lift : lifts) {
                lift.lift = true;
                for (Offset &offset : lift.bezier)
                    offset.y += 10;
            }
            appendChain(stroke, lifts);
        };
        editor().push(changeStrokes(editor().document(), {id}, erase), "erase");
    }
    const Segment &segment(int k) { return stroke().segments[std::size_t(k)]; }
};

} // namespace

class TestReshaping : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }
    void cleanup() { settings::store().remove("reshape"); }

    /// Every click with the Segments tool selects one segment, which alone could not become fewer.
    void oneSelectedSegmentMeansItsStroke()
    {
        TrunkSession s;
        const std::size_t before = s.stroke(s.trunk).segments.size();
        s.editor().document().setSelection({{s.trunk}, {{s.trunk, 40}}});
        QCOMPARE(reshapeSelected(s.editor(), Reshaping::Simplify, {}), QString());
        const std::size_t all = s.stroke(s.trunk).segments.size();
        QVERIFY(all < before / 2);
        QVERIFY(problemOf(s.stroke(s.trunk)).isEmpty());
        s.use(Command::Undo);
        QCOMPARE(s.stroke(s.trunk).segments.size(), before);
        // Two are a run, and only that is changed.
        s.editor().document().setSelection({{s.trunk}, {{s.trunk, 40}, {s.trunk, 41}}});
        reshapeSelected(s.editor(), Reshaping::Simplify, {});
        QVERIFY(s.stroke(s.trunk).segments.size() >= before - 1);
    }

    void aTrunkIsSimplified()
    {
        TrunkSession s;
        const auto before = s.editor().document().painting();
        const std::size_t count = s.stroke(s.trunk).segments.size();
        const int steps = s.steps();
        {
            ReshapeDialog dialog(s.editor(), Reshaping::Simplify, &s.window);
            QVERIFY(s.stroke(s.trunk).segments.size() <= 40); // it shows at once
            QCOMPARE(s.steps(), steps);
            QTRY_VERIFY(dialog.report().contains(QString::number(count)));
            const auto number = QRegularExpression("by ([0-9.]+)").match(dialog.report());
            QVERIFY2(number.hasMatch(), qPrintable(dialog.report()));
            qInfo() << dialog.report();
            QVERIFY(number.captured(1).toDouble() <= 100.0 / 64);
            dialog.accept();
        }
        QCOMPARE(s.steps(), steps + 1);
        QCOMPARE(s.editor().undoText(), QString("Simplify"));
        s.use(Command::Undo);
        QVERIFY(s.painting() == *before);
    }

    /// What the dialog changes is seen; where colours are judged no outline lies over them.
    void theDialogsOpenBesideTheSelection()
    {
        TrunkSession s;
        const QRect all = s.window.screen()->availableGeometry();
        s.window.setGeometry(all.left(), all.top(), all.width() - 40, std::min(620, all.height() - 80));
        s.editor().document().setSelection({{s.trunk}, {}});
        for (const Command command :
             {Command::SimplifyStrokes, Command::VaryStrokes, Command::OffsetStrokes, Command::RecolourArtwork}) {
            QRect placed;
            bool outlines = false;
            QTimer::singleShot(200, &s.window, [&] {
                QWidget *dialog = QApplication::activeModalWidget();
                placed = dialog->frameGeometry();
                outlines = s.canvas().aids().showOutlines;
                QTest::keyClick(dialog, Qt::Key_Escape);
            });
            s.use(command);
            const QRect selected = s.canvas().selectionOnScreen();
            QVERIFY(!selected.isEmpty() && all.contains(placed));
            QVERIFY2(!placed.intersects(selected), qPrintable(s.window.action(command).text()));
            QCOMPARE(outlines, command != Command::RecolourArtwork);
            QVERIFY(s.canvas().aids().showOutlines);
        }
    }

    void cancelLeavesNoTrace()
    {
        TrunkSession s;
        const auto before = s.editor().document().painting();
        const int steps = s.steps();
        for (const Reshaping what :
             {Reshaping::Simplify, Reshaping::Smooth, Reshaping::Straighten, Reshaping::Width, Reshaping::Offset}) {
            ReshapeDialog dialog(s.editor(), what, &s.window);
            QVERIFY(s.painting() != *before);
            QVERIFY(!dialog.fields().empty());
            dialog.choose(Reshaping::Width); // another one begins from the start
            emit dialog.fields().front()->entered(2);
            QVERIFY(std::abs(widthOf(s.stroke(s.trunk).segments[80]) / widthOf(before->find(s.trunk)->segments[80]) -
                             2) < 1e-5);
            dialog.reject();
            QVERIFY(s.painting() == *before);
            QCOMPARE(s.steps(), steps);
        }
    }

    void selectedRunsAloneAreChanged()
    {
        TrunkSession s;
        const Stroke before = s.stroke(s.trunk);
        Selection part{{s.trunk}, {}};
        for (int k = 40; k < 90; ++k)
            part.segments.insert({s.trunk, k});
        s.editor().document().setSelection(part);
        QString why = reshapeSelected(s.editor(), Reshaping::Simplify, {});
        QVERIFY(why.isEmpty());
        const Stroke after = s.stroke(s.trunk);
        const std::size_t fewer = before.segments.size() - after.segments.size();
        QVERIFY(fewer > 30);
        QCOMPARE(s.selection().segments.size(), 50 - fewer); // what they became is selected
        QVERIFY(after.segments[39] == before.segments[39] && after.segments[0] == before.segments[0]);
        s.use(Command::Undo);
        QVERIFY(s.selection() == part);
    }

    void keysDoItAgain()
    {
        WaveSession s;
        const Stroke before = s.stroke();
        s.use(Command::GrowPaint);
        s.use(Command::GrowPaint);
        QCOMPARE(s.steps(), 3);
        for (std::size_t k = 0; k < before.segments.size(); ++k) {
            QVERIFY(std::abs(widthOf(s.stroke().segments[k]) / widthOf(before.segments[k]) - 1.21) < 1e-5);
            QVERIFY(std::abs(double(s.stroke().segments[k].density / before.segments[k].density) - 1.21) < 1e-5);
            QVERIFY(s.stroke().segments[k].bezier == before.segments[k].bezier);
        }
        s.use(Command::ShrinkPaint);
        s.use(Command::ShrinkPaint);
        QVERIFY(std::abs(widthOf(s.stroke().segments[0]) / widthOf(before.segments[0]) - 1) < 1e-5);
        s.use(Command::StraightenStrokes);
        const double once = s.stroke().segments[1].bezier[0].y;
        s.use(Command::StraightenStrokes);
        QVERIFY(std::abs(once - 330) < 0.5 && double(s.stroke().segments[1].bezier[0].y) < once);
        s.use(Command::SmoothStrokes);
        QVERIFY(s.stroke().segments.front().bezier[0] == before.segments.front().bezier[0]);
        QCOMPARE(s.stroke().segments[0].born, before.segments[0].born);
    }

    /// The width of a stroke is that of its paint: what was erased out of it gets neither larger nor closed.
    void erasuresKeepTheirWidth()
    {
        ErasedSession s;
        const Stroke before = s.stroke();
        for (const Command command : {Command::GrowPaint, Command::ShrinkPaint}) {
            s.use(command);
            for (int k = 0; k < 6; ++k)
                QCOMPARE(s.segment(k) == before.segments[std::size_t(k)], k >= 4);
            s.use(Command::Undo);
        }
        // Where erasures are selected, they are meant, and they alone.
        s.editor().document().setSelection({{s.id}, {{s.id, 4}, {s.id, 5}}});
        s.use(Command::GrowPaint);
        for (int k = 0; k < 6; ++k)
            QCOMPARE(s.segment(k) == before.segments[std::size_t(k)], k < 4);
        // So they are in a stroke that has nothing else.
        s.editor().push(changeStrokes(s.editor().document(), {s.id},
                                      [](Stroke &stroke) {
                                          for (Segment &segment : stroke.segments)
                                              segment.lift = true;
                                      }),
                        "lift");
        const Stroke lifts = s.stroke();
        s.editor().document().setSelection({{s.id}, {}});
        s.use(Command::GrowPaint);
        for (int k = 0; k < 6; ++k)
            QVERIFY(s.segment(k).density > lifts.segments[std::size_t(k)].density);
    }

    /// The shape of a stroke is that of its paint: what was erased out of it stays where it was, to the last bit.
    void erasuresStayWhereTheyAre()
    {
        ReshapeAmounts much;
        much.distance = much.smoothing = 200;
        for (const Reshaping what :
             {Reshaping::Simplify, Reshaping::Smooth, Reshaping::Straighten, Reshaping::Offset}) {
            ErasedSession s;
            const Stroke before = s.stroke();
            const auto same = [&](bool lift) {
                const auto of = [lift](const Stroke &stroke) {
                    std::vector<Segment> segments = stroke.segments;
                    std::erase_if(segments, [lift](const Segment &segment) { return segment.lift != lift; });
                    return segments;
                };
                return of(s.stroke()) == of(before);
            };
            s.editor().document().setSelection({{s.id}, {}});
            QCOMPARE(reshapeSelected(s.editor(), what, much), QString());
            QVERIFY2(same(true) && !same(false), qPrintable(nameOf(what)));
            s.use(Command::Undo);
            // Where erasures are selected, they are meant, and they alone.
            s.editor().document().setSelection({{s.id}, {{s.id, 4}, {s.id, 5}}});
            QCOMPARE(reshapeSelected(s.editor(), what, much), QString());
            QVERIFY2(!same(true) && same(false), qPrintable(nameOf(what)));
        }
        // One segment of an erasure alone cannot become fewer, and means the erasure and not the stroke.
        ErasedSession s;
        s.editor().document().setSelection({{s.id}, {{s.id, 5}}});
        QCOMPARE(reshapeSelected(s.editor(), Reshaping::Simplify, much), QString());
        QCOMPARE(s.stroke().segments.size(), std::size_t(5));
        QVERIFY(s.segment(4).lift && !s.segment(3).lift);
        // And one of paint means the paint.
        s.use(Command::Undo);
        const Segment erasing = s.segment(5);
        s.editor().document().setSelection({{s.id}, {{s.id, 1}}});
        QCOMPARE(reshapeSelected(s.editor(), Reshaping::Simplify, much), QString());
        QVERIFY(s.stroke().segments.size() < 6 && s.stroke().segments.back() == erasing);
    }

    void lockedAndHiddenStrokesStay()
    {
        for (const Command command : {Command::LockStrokes, Command::HideStrokes}) {
            WaveSession s;
            s.use(command);
            s.editor().document().setSelection({{s.id}, {}});
            const auto before = s.editor().document().painting();
            QSignalSpy said(s.window.findChild<Commands *>(), &Commands::said);
            for (const Command reshape : {Command::SmoothStrokes, Command::StraightenStrokes, Command::GrowPaint,
                                          Command::ShrinkPaint, Command::SimplifyStrokes, Command::OffsetStrokes})
                s.use(reshape); // no dialog opens
            QVERIFY(s.painting() == *before);
            QCOMPARE(said.size(), 6);
        }
    }

    void nothingSelectedNothingDone()
    {
        WaveSession s;
        s.editor().document().setSelection({});
        for (const Command reshape : {Command::SmoothStrokes, Command::GrowPaint, Command::SimplifyStrokes})
            QVERIFY(!s.window.action(reshape).isEnabled());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestReshaping)
#include "test_reshaping.moc"

// Rulers and guides: scales, dragging guides out and back, exact places, snapping, files.
#include "app/canvas/handles/guide_handle.h"
#include "app/canvas/handles/rulers.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/drawing_aids.h"
#include "app/tools/shaping/eraser_tool.h"
#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/number_field.h"
#include "app/window/layout/workspace_view.h"
#include "model/shaping/transform.h"
#include "tests/app/session.h"

#include <QDialog>
#include <QDoubleSpinBox>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include <numbers>

using namespace suffuse;

namespace {

View viewOf(double scale, double rotation = 0)
{
    View view;
    view.centre = {500, 300};
    view.scale = scale;
    view.rotation = rotation;
    view.width = 1000;
    view.height = 600;
    return view;
}

void drag(Session &s, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {})
{
    QTest::mousePress(&s.canvas(), Qt::LeftButton, modifiers, from);
    QTest::mouseMove(&s.canvas(), (from + to) / 2);
    QTest::mouseMove(&s.canvas(), to);
    QTest::mouseRelease(&s.canvas(), Qt::LeftButton, modifiers, to);
}

struct Ruled : Session {
    Ruled() { window.action(Command::ShowRulers).setChecked(true); }
    ~Ruled() { window.action(Command::ShowRulers).setChecked(false); }
    const std::vector<Guide> &guides() { return editor().aids().guides(); }
};

} // namespace

class TestGuides : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void ticksSuitTheZoom()
    {
        const RulerUnit unit;
        const RulerScale usual = rulerScale(viewOf(1), false, unit, 56);
        QCOMPARE(usual.step, 100.0);
        QCOMPARE(usual.first, 0.0);
        QCOMPARE(usual.decimals, 0);
        QVERIFY(usual.countsX && usual.tick == 10);
        QCOMPARE(rulerScale(viewOf(1), false, unitOf(RulerUnits::Millimetres, 150), 56).step, 10 * 150 / 25.4);
        for (double scale = 1e-3; scale < 1e9; scale *= 3.7) {
            const RulerScale ruler = rulerScale(viewOf(scale), true, unit, 56);
            QVERIFY(ruler.step * scale >= 56 * (1 - 1e-9) && ruler.step * scale <= 2.5 * 56 * (1 + 1e-9));
            QVERIFY(ruler.tick * scale >= 4 && std::abs(std::remainder(ruler.step, ruler.tick)) < 1e-6 * ruler.tick);
            const double shown = ruler.step * std::pow(10, ruler.decimals);
            QVERIFY2(std::abs(shown - std::round(shown)) < 1e-6 * shown, "the labels have too few digits");
        }
    }

    /// What is said of a guide while it is dragged is what the rulers count, to a pixel.
    void aGuideSaysItsPlaceInTheRulersUnit()
    {
        const Guide upright{.upright = true, .place = 157.4};
        QCOMPARE(placeInWords(upright, {}, 1), QString("x 157"));
        QCOMPARE(placeInWords(upright, unitOf(RulerUnits::Millimetres, 150), 1), QString("x 26.7 mm"));
        QCOMPARE(placeInWords({.upright = false, .place = -300}, unitOf(RulerUnits::Inches, 150), 2),
                 QString("y \u22122.000 in"));
    }

    /// An inch has as many units as the painting says, and the usual number where it says none.
    void millimetresAreThoseOfThePainting()
    {
        Ruled s;
        s.window.action(Command::RulersInMillimetres).setChecked(true);
        QCOMPARE(s.canvas().rulerUnit().units, 150 / 25.4);
        s.editor().newPainting(Editor::usualCanvas(), 300);
        QCOMPARE(s.canvas().rulerUnit().units, 300 / 25.4);
        QCOMPARE(s.canvas().rulerUnit().name, QString("mm"));
        drag(s, {300, 6}, s.at({400, 290}), Qt::ShiftModifier); // to a whole tick
        QCOMPARE(s.guides().size(), std::size_t(1));
        const double millimetres = s.guides()[0].place / 300 * 25.4;
        QVERIFY2(std::abs(millimetres - std::round(millimetres)) < 1e-9, qPrintable(QString::number(millimetres)));
        s.window.action(Command::RulersInInches).setChecked(true);
        QCOMPARE(s.canvas().rulerUnit().units, 300.0);
        s.window.action(Command::RulersInUnits).setChecked(true);
        QCOMPARE(s.canvas().rulerUnit().units, 1.0);
    }

    /// Whatever a field shows, a length can be typed in any unit; mm and px know each other by the resolution alone.
    void aLengthIsTypedInAnyUnit()
    {
        const struct {
            const char *text, *unit;
            double wanted;
        } rows[] = {{"12 mm", "u", 12 * 150 / 25.4},
                    {"0.5 in", "u", 75},
                    {"0,5in", "u", 75},
                    {"30 px", "u", 30},
                    {"30 px", "mm", 30 * 25.4 / 150},
                    {"30 u", "px", 30},
                    {"1 cm", "mm", 10},
                    {"72 pt", "in", 1},
                    {"12", "mm", 12},
                    {"2*(3+1) mm", "u", 8 * 150 / 25.4},
                    {"1in + 2mm", "mm", 27.4},
                    {"1in - 4 px", "u", 146},
                    {"+1in", "mm", 35.4},
                    {"50%", "mm", 5}};
        for (const auto &[text, unit, wanted] : rows) {
            const std::optional<double> value = evaluateArithmetic(text, 10, unit, 150);
            QVERIFY2(value && std::abs(*value - wanted) < 1e-9, text);
        }
        QVERIFY(!evaluateArithmetic("12 mm", 10, "u"));
        QVERIFY(!evaluateArithmetic("12 mm", 10, "s", 150));
        QVERIFY(!evaluateArithmetic("1in + 2", 10, "s", 150));
        QCOMPARE(evaluateArithmetic("1 in", 10, "mm"), std::optional(25.4));
    }

    /// Fields show and take what the rulers count, as large as it is on the painting's paper.
    void fieldsCountAsRulersDo()
    {
        Ruled s;
        s.use(Command::Eraser);
        auto &eraser = *s.window.findChild<EraserTool *>();
        NumberField *size = nullptr;
        for (NumberField *field : eraser.options()->findChildren<NumberField *>())
            if (field->accessibleName() == "Size")
                size = field;
        QVERIFY(size);
        const auto type = [&](const QString &text) {
            size->setFocus();
            size->selectAll();
            QTest::keyClicks(size, text);
            QTest::keyClick(size, Qt::Key_Return);
        };
        type("12 mm");
        QCOMPARE(2 * eraser.radius(), 12 * 150 / 25.4);
        QCOMPARE(size->text(), QString("70.87 u"));
        s.window.action(Command::RulersInMillimetres).setChecked(true);
        QCOMPARE(size->text(), QString("12 mm"));
        type("20");
        QCOMPARE(2 * eraser.radius(), 20 * 150 / 25.4);
        type("30 px");
        QCOMPARE(2 * eraser.radius(), 30.0);
        QCOMPARE(size->text(), QString("5.08 mm"));
        s.editor().newPainting(Editor::usualCanvas(), 300);
        QCOMPARE(size->text(), QString("2.54 mm"));
        s.window.action(Command::RulersInInches).setChecked(true);
        QCOMPARE(size->text(), QString("0.1 in"));
        s.window.action(Command::RulersInUnits).setChecked(true);
        QCOMPARE(size->text(), QString("30 u"));
    }

    /// A guide is asked for in that unit, too, and stays where it is if nothing is typed.
    void aGuideIsPlacedInMillimetres()
    {
        Ruled s;
        s.window.action(Command::RulersInMillimetres).setChecked(true);
        const auto ask = [&](const QString &typed) {
            QTimer answer;
            connect(&answer, &QTimer::timeout, this, [&] {
                auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget());
                if (!dialog)
                    return;
                answer.stop();
                auto *box = dialog->findChild<QDoubleSpinBox *>();
                box->selectAll();
                QTest::keyClicks(box, typed);
                dialog->accept();
            });
            answer.start(10);
            s.use(Command::AddUprightGuide);
        };
        ask("10");
        ask("0.5 in");
        ask("123.25 px");
        QCOMPARE(s.guides().size(), std::size_t(3));
        QVERIFY(std::abs(s.guides()[0].place - 10 * 150 / 25.4) < 1e-4);
        QCOMPARE(s.guides()[1].place, 75.0);
        QCOMPARE(s.guides()[2].place, 123.25);
        s.editor().aids().setGuides({{true, 123.2501}});
        ask({});
        QCOMPARE(s.guides()[0], (Guide{true, 123.2501}));
        QCOMPARE(s.guides()[1].place, std::round(s.canvas().view().centre.x));
        s.window.action(Command::RulersInUnits).setChecked(true);
    }

    /// The dialog shows as many decimals as other fields, and Return alone moves nothing by those that it does not
    /// show.
    void theGuideDialogShowsFewDecimalsAndKeepsAll()
    {
        Ruled s;
        s.window.action(Command::RulersInMillimetres).setChecked(true);
        s.editor().aids().setGuides({{true, 379.0123}});
        QString text;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
                answer.stop();
                text = dialog->findChild<QDoubleSpinBox *>()->text();
                dialog->accept();
            }
        });
        answer.start(10);
        emit s.canvas().guideAsked(0);
        QTRY_COMPARE(text, QString("64.18 mm"));
        QTRY_VERIFY(!QApplication::activeModalWidget());
        QCOMPARE(s.guides(), (std::vector<Guide>{{true, 379.0123}}));
        s.window.action(Command::RulersInUnits).setChecked(true);
    }

    /// The figure of a tick right below the corner of both rulers is whole: what the ruler shows of "0" does not depend
    /// on how near the corner is.
    void theFirstFigureIsWhole()
    {
        OverlayColours colours;
        const auto inkBelow = [&](double top) { // of the left ruler, around the tick at 0
            View view = viewOf(1);
            view.centre.y = 300 - top;
            QImage image(int(view.width), int(view.height), QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            paintRulers(painter, view, {}, colours, 1);
            painter.end();
            const QRgb ground = image.pixel(1, 400);
            int ink = 0;
            for (int y = int(rulerWidth) + 1; y < top + 40; ++y)
                for (int x = 1; x < 10; ++x) // beside the short ticks
                    ink += image.pixel(x, y) != ground;
            return ink;
        };
        const int whole = inkBelow(60);
        QVERIFY(whole > 8);
        for (const double top : {rulerWidth + 2, rulerWidth + 5, rulerWidth + 8})
            QVERIFY2(std::abs(inkBelow(top) - whole) <= 2,
                     qPrintable(QString("%1: %2 of %3").arg(top).arg(inkBelow(top)).arg(whole)));
    }

    /// Where the canvas is turned, each ruler counts the axis that lies along it.
    void turnedRulersSwapAxes()
    {
        QVERIFY(rulerScale(viewOf(1, 0.5), false, {}, 56).countsX);
        const RulerScale top = rulerScale(viewOf(1, std::numbers::pi / 2), false, {}, 56);
        QVERIFY(!top.countsX);
        QVERIFY(top.perPixel < 0);
    }

    void guidesComeOutOfRulersAndGoBack()
    {
        Ruled s;
        drag(s, {300, 6}, s.at({400, 250}));
        QCOMPARE(s.guides().size(), std::size_t(1));
        QVERIFY(!s.guides()[0].upright);
        QVERIFY(std::abs(s.guides()[0].place - 250) < 2);
        drag(s, {6, 300}, s.at({400, 250}));
        QCOMPARE(s.guides().size(), std::size_t(2));
        QVERIFY(s.guides()[1].upright);
        QVERIFY(std::abs(s.guides()[1].place - 400) < 2);
        QVERIFY(s.painting().strokes.empty());
        // The end of the upright one lies on the upper ruler.
        drag(s, {s.at({s.guides()[1].place, 0}).x(), 6}, s.at({520, 100}));
        QCOMPARE(s.guides().size(), std::size_t(2));
        QVERIFY(std::abs(s.guides()[1].place - 520) < 2);
        drag(s, {6, s.at({0, s.guides()[0].place}).y()}, {6, 100}); // along its ruler, and let go there
        QCOMPARE(s.guides().size(), std::size_t(1));
        QVERIFY(s.guides()[0].upright);
        QCOMPARE(s.editor().undoStack().count(), 0);
    }

    /// A click on a guide's end neither moves nor removes it, and Esc takes a drag back.
    void clicksAndEscChangeNothing()
    {
        Ruled s;
        s.editor().aids().setGuides({{true, 300}});
        const QPoint end{s.at({300, 0}).x(), 6};
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, end);
        QCOMPARE(s.guides(), (std::vector<Guide>{{true, 300}}));
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, end);
        QTest::mouseMove(&s.canvas(), s.at({500, 200}));
        QVERIFY(s.guides()[0].place > 400);
        QTest::keyClick(&s.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({500, 200}));
        QCOMPARE(s.guides(), (std::vector<Guide>{{true, 300}}));
        s.window.action(Command::LockGuides).setChecked(true);
        drag(s, end, s.at({500, 200})); // out of the ruler comes a new one
        QCOMPARE(s.guides().size(), std::size_t(2));
        QCOMPARE(s.guides()[0].place, 300.0);
        s.window.action(Command::LockGuides).setChecked(false);
    }

    /// The brush paints over a guide, Select takes it where nothing else lies.
    void toolsComeFirstWhereTheyHaveWork()
    {
        Session s;
        s.editor().aids().setGuides({{true, 300}});
        s.paintLine({300, 200}, {420, 200});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        QCOMPARE(s.editor().aids().guides()[0].place, 300.0);
        s.dry();
        s.use(Command::Select);
        drag(s, s.at({300, 500}), s.at({350, 500}));
        QVERIFY(std::abs(s.editor().aids().guides()[0].place - 350) < 2);
        const double before = s.editor().aids().guides()[0].place;
        drag(s, s.at({before, 200}), s.at({before, 260})); // the paint there is moved
        QCOMPARE(s.editor().aids().guides()[0].place, before);
    }

    void aDoubleClickAsksForThePlace()
    {
        Ruled s;
        s.editor().aids().setGuides({{true, 300}});
        const QPoint end{s.at({300, 0}).x(), 6};
        bool asked = false;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            if (auto *dialog = qobject_cast<QDialog *>(QApplication::activeModalWidget())) {
                asked = true;
                answer.stop();
                auto *box = dialog->findChild<QDoubleSpinBox *>();
                box->setValue(123.25);
                dialog->accept();
            }
        });
        answer.start(10);
        QTest::mouseClick(&s.canvas(), Qt::LeftButton, {}, end);
        QTest::mouseDClick(&s.canvas(), Qt::LeftButton, {}, end); // the second click alone
        QTRY_VERIFY(asked);
        QTRY_COMPARE(s.guides(), (std::vector<Guide>{{true, 123.25}}));
    }

    void shapesSnapToGuides()
    {
        Session s;
        s.editor().aids().setGuides({{true, 300}, {false, 200}});
        s.use(Command::Shapes);
        const double near = 4 * s.canvas().devicePixelRatioF() / s.canvas().view().scale;
        s.paintLine({300 + near, 200 - near}, {400, 280});
        QCOMPARE(s.painting().strokes.size(), std::size_t(1));
        const Rect box = curveBox(*s.painting().strokes[0]);
        QVERIFY(std::abs(box.left - 300) < 1e-3 && std::abs(box.top - 200) < 1e-3);
        s.window.action(Command::SnapToGuides).setChecked(false);
        s.paintLine({300 + near, 200 - near}, {400, 280});
        QVERIFY(std::abs(curveBox(*s.painting().strokes[1]).left - 300) > 0.5 * near);
        s.window.action(Command::SnapToGuides).setChecked(true);
    }

    void filesKeepThem()
    {
        Session s;
        s.editor().aids().setGuides({{false, 20}, {true, -3.5}});
        const auto kept = workspaceOf(s.canvas(), s.editor());
        QVERIFY(kept);
        QCOMPARE(kept->guides, s.editor().aids().guides());
        s.editor().newPainting(Editor::usualCanvas());
        QVERIFY(s.editor().aids().guides().empty());
        showWorkspace(*kept, s.canvas(), s.editor());
        QCOMPARE(s.editor().aids().guides(), kept->guides);
        QVERIFY(s.window.action(Command::RemoveGuides).isEnabled());
        s.use(Command::RemoveGuides);
        QVERIFY(s.editor().aids().guides().empty());
        QVERIFY(!s.window.action(Command::RemoveGuides).isEnabled());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestGuides)
#include "test_guides.moc"

// The eraser that fades: paint gets paler by the strength, softly, whatever its style, and what it leaves is edited.
#include "app/panels/inspector/figures/figures_section.h"
#include "app/panels/inspector/fill_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/panels/inspector/rows/erasure_rows.h"
#include "app/panels/inspector/segment_section.h"
#include "app/panels/inspector/style_section.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/slider_field.h"
#include "app/window/pointer/value_card.h"
#include "model/area/outline.h"
#include "model/brush/brush.h"
#include "model/painting/influence.h"
#include "model/shaping/shapes.h"
#include "render/probe.h"
#include "tests/app/tools/eraser_session.h"
#include "undo/edits.h"
#include "undo/node_edits.h"

#include <QComboBox>
#include <QTemporaryDir>

using namespace suffuse;

namespace {

const QStringList washes{"flat-wash", "round-wash", "watercolour-edge"};

/// A session with a hill painted by one wash that goes to and fro, and the eraser that fades, 60 across.
struct HillSession : EraserSession {
    StrokeId hill = 0;

    explicit HillSession(const QString &brush) : EraserSession(EraserMode::Fade)
    {
        use(Command::SelectAll);
        use(Command::Delete);
        use(Command::Eraser);
        const Brush preset = *findBrush(brush);
        const double apart = 0.7 * preset.spread();
        std::vector<Cubic> curves;
        Point from{220, 120};
        for (int pass = 0; from.y < 420; ++pass) {
            const Point to{pass % 2 ? 220.0 : 580.0, from.y}, down{to.x, to.y + apart};
            for (const Point next : {to, down}) {
                const Point third = (1.0 / 3) * (next - from);
                curves.push_back({{from, from + third, next - third, next}});
                from = next;
            }
        }
        hill = editor().document().takeStrokeId();
        editor().push(addStrokes(editor().document(),
                                 {std::make_shared<const Stroke>(strokeAlong(curves, preset, hill, 0))}, false),
                      "hill");
        dry();
        eraser().setRadius(30);
    }
    /// What is seen of the hill at a point, exactly.
    double opacity(Point at)
    {
        const auto found = probe(painting(), painting().end(), at.x, at.y);
        for (const ProbeStroke &stroke : found ? found->strokes : std::vector<ProbeStroke>())
            if (stroke.id == hill)
                return stroke.opacity;
        return 0;
    }
    std::set<SegmentRef> fading()
    {
        std::set<SegmentRef> segments;
        for (int k = 0; k < int(stroke(hill).segments.size()); ++k)
            if (stroke(hill).segments[std::size_t(k)].fade)
                segments.insert({hill, k});
        return segments;
    }
};

} // namespace

class TestFading : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void itTakesTheShareThatWasAsked_data()
    {
        QTest::addColumn<QString>("brush");
        for (const QString &brush : washes)
            QTest::newRow(qPrintable(brush)) << brush;
    }
    void itTakesTheShareThatWasAsked()
    {
        QFETCH(QString, brush);
        HillSession s(brush);
        const auto before = s.editor().document().painting();
        const QImage picture = s.pictureNow();
        const Point from{280, 270}, to{520, 270};
        std::vector<Point> middle;
        std::vector<double> was;
        for (double x = 350; x <= 450; x += 12.5) {
            middle.push_back({x, 270});
            was.push_back(s.opacity(middle.back()));
            QVERIFY(was.back() > 0.05);
        }
        double last = 1;
        for (const double strength : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            s.choose(EraserMode::Fade, strength);
            s.erase(from, to);
            s.dry();
            double most = 0;
            for (std::size_t i = 0; i < middle.size(); ++i) {
                const double left = s.opacity(middle[i]) / was[i];
                QVERIFY2(std::abs(left - (1 - strength)) < 0.02, qPrintable(QString::number(left)));
                most = std::max(most, left);
            }
            QVERIFY(most < last);
            last = most;
            // Outside the influence of what fades every pixel keeps its bits.
            Rect influence;
            for (const Segment &segment : s.stroke(s.hill).segments)
                if (segment.fade)
                    influence = influence.united(influenceOf(s.stroke(s.hill), segment, s.editor().clock().time()));
            QVERIFY(!influence.isEmpty());
            const QImage erased = s.pictureNow();
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    if (!influence.grown(1).contains(s.canvas().view().toCanvas({x + 0.5, y + 0.5})))
                        QCOMPARE(erased.pixel(x, y), picture.pixel(x, y));
            s.use(Command::Undo);
            QVERIFY(s.painting() == *before);
        }
    }

    /// At full strength nothing can be seen within the radius less the soft rim, half is left at most at the radius,
    /// and beside it nothing is taken.
    void fullStrengthLeavesNothing()
    {
        for (const QString &brush : washes)
            for (const double softness : {0.4, 0.6, 1.5}) {
                HillSession s(brush);
                EraserChoice choice;
                choice.softness = softness;
                s.eraser().setChoice(choice);
                const double radius = s.eraser().radius(), rim = SoftTip{radius, softness, 1, SoftWay::Fade}.spread();
                const double path = s.sent({280, 270}).y; // where the pointer is, in whole pixels
                std::vector<double> was;
                for (int i = 0; i < 90; ++i)
                    was.push_back(s.opacity({400, path + i}));
                s.erase({280, 270}, {520, 270});
                s.dry();
                for (std::size_t i = 0; i < was.size(); ++i) {
                    const double left = s.opacity({400, path + double(i)}) / std::max(was[i], 1e-9);
                    if (double(i) <= radius - rim)
                        QVERIFY2(was[i] * left <= 1.0 / 1024, qPrintable(QString::number(left)));
                    if (double(i) >= radius)
                        QVERIFY2(left > 0.49, qPrintable(QString::number(left)));
                    if (double(i) >= 2.8 * radius)
                        QVERIFY2(left > 0.999, qPrintable(QString::number(left)));
                }
            }
    }

    void aSecondPassTakesOfWhatIsLeft()
    {
        HillSession s("flat-wash");
        s.choose(EraserMode::Fade, 0.4);
        const double was = s.opacity({400, 270});
        s.erase({280, 270}, {520, 270});
        s.erase({280, 270}, {520, 270});
        s.dry();
        QVERIFY(std::abs(s.opacity({400, 270}) / was - 0.36) < 0.02);
    }

    /// To and fro in one drag is one time, along lines as well as where they cross.
    void oneDragTakesItsShareOnce()
    {
        HillSession s("flat-wash");
        s.choose(EraserMode::Fade, 0.3);
        const double was = s.opacity({400, 270});
        s.erase({280, 270}, {520, 270}, {}, false);
        Point from{520, 270};
        for (const Point to : {Point{280, 270}, Point{520, 270}, Point{400, 180}, Point{400, 360}}) {
            for (int i = 1; i <= 12; ++i) {
                s.advance(interval);
                s.move(from + (i / 12.0) * (to - from));
            }
            from = to;
        }
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(from));
        s.dry();
        for (const Point at : {Point{340, 270}, Point{320, 270}, Point{400, 330}})
            QVERIFY2(std::abs(s.opacity(at) / was - 0.7) < 0.03, qPrintable(QString::number(s.opacity(at) / was)));
        const double crossed = s.opacity({400, 270}) / was; // The parts beside the crossing reach into it.
        QVERIFY2(crossed > 0.6 && crossed < 0.72, qPrintable(QString::number(crossed)));
        s.erase({280, 270}, {380, 270});
        s.dry();
        QVERIFY(std::abs(s.opacity({320, 270}) / was - 0.49) < 0.03);
    }

    /// A pen's pressure is a share of the strength.
    void aPensPressureCounts()
    {
        HillSession s("flat-wash");
        const double was = s.opacity({400, 270});
        Pen pen;
        pen.send(s.canvas(), QEvent::TabletPress, s.at({280, 270}), 0.5);
        for (int i = 1; i <= 12; ++i) {
            s.advance(interval);
            pen.send(s.canvas(), QEvent::TabletMove, s.at(Point{280 + i * 20.0, 270}), 0.5);
        }
        pen.send(s.canvas(), QEvent::TabletRelease, s.at({520, 270}), 0);
        s.dry();
        QVERIFY(std::abs(s.opacity({400, 270}) / was - 0.5) < 0.03);
    }

    /// The inspector says what share an erasure takes; less of it pales less, and as another kind it lifts.
    void theInspectorWeakensIt()
    {
        HillSession s("watercolour-edge");
        s.choose(EraserMode::Fade, 0.4);
        const double was = s.opacity({400, 270});
        s.erase({280, 270}, {520, 270});
        s.dry();
        s.use(Command::Segments);
        auto &panel = *s.window.findChild<InspectorPanel *>();
        auto &section = *panel.findChild<SegmentSection *>();
        auto &figures = *panel.findChild<FiguresSection *>();
        s.editor().document().setSelection({{s.hill}, s.fading()});
        QVERIFY(!s.fading().empty());
        SliderField *share = section.erasure()->share();
        QTRY_VERIFY(!share->label()->isHidden());
        QCOMPARE(share->number()->text(), QString("40 %"));
        QCOMPARE(figures.figure(6)->text(), QString("40 %"));
        QVERIFY(section.density()->label()->isHidden());
        QVERIFY(s.summary().contains("paler"));
        QCOMPARE(section.erasure()->kind()->currentText(), QString("Fade"));
        emit share->edited(0.2, nullptr);
        s.dry();
        QVERIFY(std::abs(s.opacity({400, 270}) / was - 0.8) < 0.02);
        QTRY_COMPARE(share->number()->text(), QString("20 %"));
        emit section.erasure()->kind()->activated(1);
        QVERIFY(s.fading().empty());
        QVERIFY(s.erasing(s.hill) > 0); // It lifts.
        QTRY_VERIFY(share->label()->isHidden() && !section.erasure()->taken()->label()->isHidden());
        QCOMPARE(section.erasure()->kind()->currentText(), QString("Lift"));
        s.use(Command::Undo);
        QVERIFY(!s.fading().empty());
        // Del takes it out.
        QTest::keyClick(&s.canvas(), Qt::Key_Delete);
        QCOMPARE(s.erasing(s.hill), 0);
        QVERIFY(std::abs(s.opacity({400, 270}) - was) < 1e-12);
    }

    /// Where the paint is a fill alone, an erasure of it is seen by itself all the same.
    void ofAFillTheErasureAloneIsShown()
    {
        HillSession s("flat-wash");
        Stroke filled = s.stroke(s.hill);
        for (Segment &segment : filled.segments)
            segment.density = 0;
        filled.fill = Fill{};
        QVERIFY(isFillAlone(filled));
        s.editor().push(replaceStrokes(s.editor().document(), {filled}), "fill");
        s.erase({280, 270}, {520, 270});
        s.dry();
        QVERIFY(!s.fading().empty() && isFillAlone(s.stroke(s.hill)));
        s.use(Command::Segments);
        auto &panel = *s.window.findChild<InspectorPanel *>();
        auto &section = *panel.findChild<SegmentSection *>();
        auto &fill = *panel.findChild<FillSection *>();
        s.editor().document().setSelection({{s.hill}, s.fading()});
        QTRY_VERIFY(!section.erasure()->share()->label()->isHidden());
        QVERIFY(fill.isHidden() && panel.findChild<StyleSection *>()->isHidden());
        s.use(Command::EditHere);
        auto *card = s.window.findChild<ValueCard *>();
        QVERIFY(card && !card->findChild<SegmentSection *>()->isHidden() &&
                card->findChild<FillSection *>()->isHidden());
        card->close();
        s.editor().document().setSelection({{s.hill}, {}});
        QTRY_VERIFY(!fill.isHidden());
    }

    /// Size and strength are those of the eraser, in its units; another strength leaves the size as it is.
    void sizeAndStrengthAreThoseOfTheEraser()
    {
        for (const double strength : {1.0, 0.4})
            for (const EraserMode mode : {EraserMode::Fade, EraserMode::Lift}) {
                EraserSession s(mode);
                s.choose(mode, strength);
                s.erase({350, 250}, {350, 390});
                s.dry();
                s.use(Command::Segments);
                ErasureRows &rows = *s.window.findChild<InspectorPanel *>()->findChild<SegmentSection *>()->erasure();
                s.selectErasing();
                QTRY_COMPARE(rows.size()->number()->text(), QString("24 u"));
                const int steps = s.steps();
                rows.size()->number()->selectAll();
                QTest::keyClicks(rows.size()->number(), "36");
                QTest::keyClick(rows.size()->number(), Qt::Key_Return);
                QCOMPARE(s.steps(), steps + 1);
                QTRY_COMPARE(rows.size()->number()->text(), QString("36 u"));
                s.use(Command::EditHere);
                auto *card = s.window.findChild<ValueCard *>();
                QVERIFY(card && card->segments()->diffusion()->label()->isHidden());
                QVERIFY(card->segments()->density()->label()->isHidden());
                QCOMPARE(card->segments()->erasure()->size()->number()->text(), QString("36 u"));
                QTRY_COMPARE(QApplication::focusWidget(), card->segments()->erasure()->size()->number());
                card->close();
                for (const Segment &segment : s.stroke().segments)
                    if (segment.takesPaint())
                        QVERIFY(std::abs(segment.spread(segment.driesAt()) / 18 - 0.6) < 0.012);
                QCOMPARE(rows.share()->label()->isHidden(), mode == EraserMode::Lift);
                QCOMPARE(rows.taken()->label()->isHidden(), mode == EraserMode::Fade);
                if (mode == EraserMode::Lift)
                    continue;
                QCOMPARE(rows.share()->number()->text(), strength == 1 ? QString("100 %") : QString("40 %"));
                emit rows.share()->edited(0.5, nullptr);
                QTRY_COMPARE(rows.share()->number()->text(), QString("50 %"));
                QCOMPARE(rows.size()->number()->text(), QString("36 u"));
            }
    }

    /// Erasures of several sizes are scaled together, and the row goes on saying by how much.
    void sizesThatDifferAreScaled()
    {
        EraserSession s(EraserMode::Fade);
        s.erase({350, 250}, {350, 390});
        s.eraser().setRadius(6);
        s.erase({250, 250}, {250, 390});
        s.dry();
        s.use(Command::Segments);
        ErasureRows &rows = *s.window.findChild<InspectorPanel *>()->findChild<SegmentSection *>()->erasure();
        s.selectErasing();
        QTRY_VERIFY(!rows.size()->label()->isHidden());
        QCOMPARE(rows.size()->number()->text(), QString("—"));
        const Stroke before = s.stroke();
        rows.size()->number()->setFocus();
        QTest::keyClick(rows.size()->number(), Qt::Key_Up);
        QTRY_COMPARE(rows.size()->number()->text(), QString("×1.10"));
        for (std::size_t k = 0; k < before.segments.size(); ++k) {
            const Segment &was = before.segments[k], &now = s.stroke().segments[k];
            const double by = was.takesPaint() ? 1.1 : 1;
            QVERIFY(std::abs(now.spread(now.driesAt()) / was.spread(was.driesAt()) - by) < 1e-5);
            QVERIFY(std::abs(double(now.density) / double(was.density) - by) < 1e-5);
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestFading)
#include "test_fading.moc"

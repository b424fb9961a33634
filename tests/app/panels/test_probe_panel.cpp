// The Probe dock, by real events.
#include "app/panels/probe/probe_panel.h"
#include "app/widgets/curves/age_plot.h"
#include "render/probe.h"
#include "tests/app/panel_bench.h"
#include "tests/app/session.h"
#include "undo/edits.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace suffuse;

namespace {

/// A report of the pointer with no button down, which QTest::mouseMove leaves to the window system.
void hover(QWidget &widget, QPoint at)
{
    QMouseEvent event(QEvent::MouseMove, QPointF(at), widget.mapToGlobal(QPointF(at)), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&widget, &event);
}

} // namespace

class TestProbePanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toUtf8());
    }

    void listsWhatLiesUnderThePointer()
    {
        Session session;
        Editor &editor = session.editor();
        auto painting = std::make_shared<Painting>();
        for (StrokeId id = 1; id <= 3; ++id) {
            Stroke stroke = *makeStroke(id, 8, 40);
            stroke.origin = {id == 3 ? 700.0 : 300.0, 300};
            for (Segment &s : stroke.segments)
                s.density = 20, s.colour.opacity = id == 2 ? 0.5f : 1;
            painting->strokes.push_back(std::make_shared<const Stroke>(stroke));
        }
        editor.document().reset(painting);
        editor.clock().setTime(5'000'000);
        QDockWidget *dock = session.window.findChild<QDockWidget *>("probeDock");
        auto *panel = session.window.findChild<ProbePanel *>();
        QVERIFY(dock && panel && dock->isHidden());
        hover(session.canvas(), session.at({360, 300}));
        QCOMPARE(panel->view()->topLevelItemCount(), 0); // nothing is computed for a dock that is not seen
        dock->show();
        dock->raise();
        QTRY_VERIFY(panel->isVisible());
        hover(session.canvas(), session.at({362, 301}));
        QTRY_COMPARE(panel->view()->topLevelItemCount(), 3); // 2, 1, canvas
        QTRY_VERIFY(panel->isUpToDate());
        const auto text = [&](int row, int column) { return panel->view()->topLevelItem(row)->text(column); };
        QVERIFY(text(0, 0).contains('2') && text(1, 0).contains('1'));
        const auto shareOf = [&](int row) { return text(row, ProbePanel::ShareColumn).split(' ').front().toDouble(); };
        QVERIFY(std::abs(shareOf(0) - 50) < 2); // half covers, and the one below has the rest
        QVERIFY(std::abs(shareOf(0) + shareOf(1) + shareOf(2) - 100) < 1.6);

        // Segments by their share of the density; a click selects.
        QTreeWidgetItem *stroke = panel->view()->topLevelItem(1);
        QVERIFY(stroke->childCount() >= 3);
        stroke->setExpanded(true);
        const QString nearest = stroke->child(0)->text(0);
        QVERIFY2(nearest.contains('4'), qPrintable(nearest)); // 350 … 370 from the stroke's start at 300: the fourth
        QTest::mouseClick(panel->view()->viewport(), Qt::LeftButton, {},
                          panel->view()->visualItemRect(stroke->child(0)).center());
        QCOMPARE(session.selection().segments, (std::set<SegmentRef>{{1, 3}}));
        QVERIFY(!panel->plot()->points().empty());
        QTest::mouseClick(panel->view()->viewport(), Qt::LeftButton, {},
                          panel->view()->visualItemRect(panel->view()->topLevelItem(0)).center());
        QCOMPARE(session.selection().strokes, std::set<StrokeId>{2});
        QVERIFY(session.selection().segments.empty());

        // φ(t): nothing at first, most while the paint is fresh, and at the end what the solver says.
        const std::vector<QPointF> ages = panel->plot()->points();
        const Point at = session.canvas().view().toCanvas(
            session.canvas().devicePixelRatioF() *
            Point{double(session.at({362, 301}).x()), double(session.at({362, 301}).y())});
        const Result<Probe> truth = probe(session.painting(), 1'000'000, at.x, at.y);
        QVERIFY(std::abs(ages.back().y() - truth->strokes[1].density) < 2e-3);
        QCOMPARE(ages.back().x(), 1.0);

        // A change shows at the same place.
        editor.push(changeSegments(editor.document(), targetSegments(editor.document()),
                                   [](Segment &s) { s.colour.opacity = 1; }),
                    "opacity");
        QTRY_VERIFY(shareOf(0) > 95);
        // A fill has a row of its own.
        editor.push(changeStrokes(editor.document(), {2},
                                  [](Stroke &s) {
                                      for (Segment &segment : s.segments)
                                          segment.density = 0;
                                      s.segments.back().bezier[3].y += 300;
                                      Fill fill;
                                      fill.density = 9;
                                      s.fill = fill;
                                  }),
                    "fill");
        QTRY_VERIFY(panel->view()->topLevelItem(0)->childCount() == 1 &&
                    panel->view()->topLevelItem(0)->child(0)->text(0) == "Fill");
        session.advance(1);
        QTRY_VERIFY(panel->isUpToDate());
    }

    void goesBackToWhereThePointerRested()
    {
        Session session;
        session.editor().document().reset(std::make_shared<Painting>(*Bench(1).editor.document().painting()));
        auto *panel = session.window.findChild<ProbePanel *>();
        session.window.findChild<QDockWidget *>("probeDock")->show();
        session.window.findChild<QDockWidget *>("probeDock")->raise();
        QTRY_VERIFY(panel->isVisible());
        session.editor().clock().setTime(5'000'000);
        panel->setPoint({80, 100});
        QTRY_VERIFY(panel->rested() == (Point{80, 100}));
        panel->setPoint({700, 600}); // on the way to the dock
        QVERIFY(panel->point() == (Point{700, 600}));
        panel->leaveCanvas();
        QVERIFY(panel->point() == (Point{80, 100}));
        QTRY_VERIFY(panel->isUpToDate());
        QCOMPARE(panel->view()->topLevelItemCount(), 2);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestProbePanel)
#include "test_probe_panel.moc"

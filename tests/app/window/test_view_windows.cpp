// A second window that shows the painting of the first one.
#include "app/session/frames/frame_thread.h"
#include "app/widgets/asking/messages.h"
#include "app/window/layout/view_windows.h"
#include "model/shaping/transform.h"
#include "tests/app/session.h"

#include <QPointer>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

QList<QPointer<ViewWindow>> viewWindows()
{
    QList<QPointer<ViewWindow>> windows;
    for (QWidget *widget : QApplication::topLevelWidgets())
        if (auto *window = qobject_cast<ViewWindow *>(widget))
            windows << window;
    return windows;
}

struct Viewed : Session {
    QPointer<ViewWindow> view;
    Viewed()
    {
        use(Command::NewView);
        view = viewWindows().value(0);
        if (!view)
            qFatal("no view was opened");
    }
    /// Whether both show paint at a point, once their frames are there.
    bool bothShow(Point point)
    {
        for (CanvasWidget *shown : {&canvas(), &view->canvas()}) {
            if (!QTest::qWaitFor([shown] { return shown->isUpToDate(); }, waitMs))
                return false;
            const QImage picture = shown->picture();
            const Point at = shown->view().toPixels(point);
            if (!picture.rect().contains(int(at.x), int(at.y)) || qGray(picture.pixel(int(at.x), int(at.y))) > 200)
                return false;
        }
        return true;
    }
};

} // namespace

class TestViewWindows : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void bothShowEachEdit()
    {
        Viewed s;
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({300, 300}));
        for (int i = 1; i <= 20; ++i) {
            s.advance(interval);
            QTest::mouseMove(&s.canvas(), s.at({300 + 10.0 * i, 300}));
        }
        QVERIFY(s.bothShow({400, 300})); // while the stroke is in hand
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({500, 300}));
        s.dry();
        QVERIFY(s.bothShow({400, 300}));
        s.use(Command::Undo);
        QVERIFY(!s.bothShow({400, 300}));
        s.use(Command::Redo);
        QVERIFY(s.bothShow({400, 300}));
    }

    /// What is dragged is in the document at once, since a picture that floats would be in one window alone.
    void dragsShowInBoth()
    {
        Session s;
        QVERIFY(s.editor().floatingView());
        s.paintLine({300, 300}, {500, 300});
        s.dry();
        s.use(Command::NewView);
        QVERIFY(!s.editor().floatingView());
        s.use(Command::Select);
        s.use(Command::SelectAll);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, s.at({400, 300}));
        QTest::mouseMove(&s.canvas(), s.at({400, 350}));
        QTest::mouseMove(&s.canvas(), s.at({400, 400}));
        const double moved = curveBox(*s.editor().unsettled().painting()->strokes[0]).top;
        QVERIFY2(moved > 380, qPrintable(QString::number(moved)));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at({400, 400}));
        viewWindows()[0]->close();
        QTRY_VERIFY(viewWindows().isEmpty());
        QVERIFY(s.editor().floatingView());
    }

    void oneLooksThereAndPaintsNothing()
    {
        Viewed s;
        CanvasWidget &canvas = s.view->canvas();
        const Point before = canvas.view().centre;
        const View other = s.canvas().view();
        QTest::mousePress(&canvas, Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(&canvas, {230, 220});
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, {230, 220});
        QVERIFY(canvas.view().centre != before);
        QVERIFY(s.painting().strokes.empty());
        QCOMPARE(s.editor().undoStack().count(), 0);
        canvas.setZoom(3);
        QVERIFY(s.view->windowTitle().contains("300"));
        QVERIFY(s.canvas().view() == other);
    }

    /// Closing one asks nothing; with the window in which one paints all go.
    void closingAsksOnce()
    {
        int asked = 0;
        MessageHooks hooks;
        hooks.unsaved = [&](const QString &) {
            ++asked;
            return SaveAnswer::Discard;
        };
        setMessageHooks(hooks);
        const auto back = qScopeGuard([] { setMessageHooks({}); });
        Viewed s;
        s.use(Command::NewView);
        QCOMPARE(viewWindows().size(), 2);
        s.paintLine({300, 300}, {500, 300});
        s.view->close();
        QTRY_COMPARE(viewWindows().size(), 1);
        QCOMPARE(asked, 0);
        QVERIFY(s.window.isVisible());
        QVERIFY(!s.editor().floatingView());
        s.window.close();
        QCOMPARE(asked, 1);
        QTRY_VERIFY(viewWindows().isEmpty());
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestViewWindows)
#include "test_view_windows.moc"

// The dock with a picture to look at, and to pick colours from.
#include "app/panels/reference/reference_panel.h"
#include "app/panels/reference/reference_view.h"
#include "app/session/colour_convert.h"
#include "tests/app/session.h"

#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest>

using namespace suffuse;

namespace {

/// Red on the left, blue on the right, and a clear row below.
QImage halves()
{
    QImage image(40, 20, QImage::Format_ARGB32);
    image.fill(Qt::red);
    for (int y = 0; y < 20; ++y)
        for (int x = 20; x < 40; ++x)
            image.setPixelColor(x, y, Qt::blue);
    for (int x = 0; x < 40; ++x)
        image.setPixelColor(x, 19, Qt::transparent);
    return image;
}

struct WithPicture : Session {
    ReferencePanel *panel = window.findChild<ReferencePanel *>();
    ReferenceView *view = panel->view();
    explicit WithPicture(const QString &path)
    {
        auto *dock = window.findChild<QDockWidget *>("referenceDock");
        dock->show();
        dock->raise();
        QTest::qWait(20);
        if (!path.isEmpty() && !panel->open(path))
            qFatal("the picture was not opened");
    }
    QPoint at(QPointF pixel) { return view->toWidget().map(pixel).toPoint(); }
    QColor brushColour() { return toOpaqueScreen(editor().brush().colour); }
};

bool isNear(const QColor &a, const QColor &b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 12;
}

} // namespace

class TestReferenceDock : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
        m_path = m_folder.filePath("halves.png");
        QVERIFY(halves().save(m_path));
    }

    void theEyedropperPicks()
    {
        WithPicture s(m_path);
        s.use(Command::Eyedropper);
        QTest::mouseClick(s.view, Qt::LeftButton, {}, s.at({10, 10}));
        QVERIFY2(isNear(s.brushColour(), Qt::red), qPrintable(s.brushColour().name()));
        QTest::mouseClick(s.view, Qt::LeftButton, {}, s.at({30, 10}));
        QVERIFY2(isNear(s.brushColour(), Qt::blue), qPrintable(s.brushColour().name()));
        QTest::mouseClick(s.view, Qt::LeftButton, {}, s.at({10, 19.5})); // clear
        QVERIFY(isNear(s.brushColour(), Qt::blue));
        QTest::mouseClick(s.view, Qt::LeftButton, {}, s.at({-2, 10})); // beside it
        QVERIFY(isNear(s.brushColour(), Qt::blue));
        s.use(Command::Brush);
        QTest::mouseClick(s.view, Qt::LeftButton, {}, s.at({10, 10})); // takes hold of the picture
        QVERIFY(isNear(s.brushColour(), Qt::blue));
        QTest::mouseClick(s.view, Qt::LeftButton, Qt::ControlModifier, s.at({10, 10}));
        QVERIFY(isNear(s.brushColour(), Qt::red));
    }

    void theKeyboardPicks()
    {
        WithPicture s(m_path);
        s.view->setFocus();
        QTest::keyClick(s.view, Qt::Key_Right);
        QTest::keyClick(s.view, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(s.view, Qt::Key_Return);
        QVERIFY(isNear(s.brushColour(), Qt::blue));
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(s.view, Qt::Key_Left, Qt::ShiftModifier);
        QTest::keyClick(s.view, Qt::Key_Return);
        QVERIFY(isNear(s.brushColour(), Qt::red));
        const double before = s.view->scale();
        QTest::keyClick(s.view, Qt::Key_Plus);
        QVERIFY(s.view->scale() > before);
        QTest::keyClick(s.view, Qt::Key_0);
        QCOMPARE(s.view->scale(), before);
    }

    /// The pixel under the pointer stays there.
    void theWheelZoomsAndADragMoves()
    {
        WithPicture s(m_path);
        const QPointF at(40, 30), pixel = s.view->toWidget().inverted().map(at);
        const double before = s.view->scale();
        QWheelEvent wheel(at, s.view->mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(s.view, &wheel);
        QVERIFY(s.view->scale() > 1.4 * before);
        QVERIFY(QLineF(s.view->toWidget().map(pixel), at).length() < 1e-6);
        QTest::mousePress(s.view, Qt::LeftButton, {}, {40, 30});
        QTest::mouseMove(s.view, {60, 45});
        QTest::mouseRelease(s.view, Qt::LeftButton, {}, {60, 45});
        QVERIFY(QLineF(s.view->toWidget().map(pixel), QPointF(60, 45)).length() < 1e-6);
    }

    void filesAreDroppedAndRemembered()
    {
        {
            WithPicture s({});
            QMimeData data;
            data.setUrls({QUrl::fromLocalFile(m_path)});
            QDropEvent drop({20, 20}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            QCoreApplication::sendEvent(s.panel, &drop);
            QCOMPARE(s.view->picture().size(), QSize(40, 20));
        }
        WithPicture s({}); // remembers it
        QCOMPARE(s.view->picture().size(), QSize(40, 20));
        QVERIFY(!s.panel->open(m_folder.filePath("none.png")));
        QCOMPARE(s.view->picture().size(), QSize(40, 20));
        QVERIFY(!s.panel->findChild<QLabel *>()->text().isEmpty());
        s.panel->findChild<QToolButton *>("referenceClear")->click();
        QVERIFY(s.view->picture().isNull());
        QVERIFY(QFile::exists(m_path));
        WithPicture again({});
        QVERIFY(again.view->picture().isNull());
    }

private:
    QTemporaryDir m_folder;
    QString m_path;
};

QTEST_MAIN(TestReferenceDock)
#include "test_reference_dock.moc"

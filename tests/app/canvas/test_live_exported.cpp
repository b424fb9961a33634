// What is painted on the canvas with any brush is what suffuse-cli draws of the saved file, bit for bit, at any moment.
#include "app/session/editor.h"
#include "model/formats/files.h"
#include "render/view.h"
#include "tests/app/pen_hand.h"
#include "tests/app/session.h"

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace suffuse;

namespace {

/// A window on a canvas of the size of its widget, a unit a pixel.
struct Sheet : Session {
    Sheet()
    {
        [&] { QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs); }();
        Canvas size = Editor::usualCanvas();
        size.width = canvas().view().width;
        size.height = canvas().view().height;
        editor().newPainting(size);
        use(Command::Brush);
        View view = canvas().view();
        view.scale = 1;
        view.centre = {0.5 * view.width, 0.5 * view.height};
        canvas().lookThrough(view);
        editor().clock().setTime(0);
    }

    /// A wave with all that a pen can report, two seconds after the stroke before.
    void paint(const Brush &brush, Point from)
    {
        constexpr int reports = 40;
        editor().setBrush(brush);
        advance(2'000'000);
        const auto at = [&](int i) { return from + Point{3.5 * i, 14 * std::sin(0.3 * i)}; };
        for (int i = 0; i < reports; ++i) {
            const double way = double(i) / reports;
            pen.send(canvas(), {i == 0 ? QEvent::TabletPress : QEvent::TabletMove, at(i),
                                0.15 + 0.7 * std::sin(3 * way), 60 * way, -20, 0});
            advance(8'000 + 8'000 * (i % 3 == 0));
        }
        pen.send(canvas(), {QEvent::TabletRelease, at(reports), 0, 0, 0, 0});
    }
    /// What stands on the canvas now; it came there frame by frame.
    QImage live()
    {
        [&] { QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs); }();
        return canvas().picture().convertToFormat(QImage::Format_RGB32);
    }

    PenHand pen;
};

} // namespace

class TestLiveExported : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_BACKEND", "cpu");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void everyBrush()
    {
        Sheet sheet;
        const View whole =
            View::ofArea(sheet.painting().canvas.area(), sheet.canvas().view().width, sheet.canvas().view().height);
        QVERIFY(sheet.canvas().view() == whole);
        const std::vector<Brush> &brushes = builtinBrushes();
        QCOMPARE(brushes.size(), std::size_t(20));
        const double width = sheet.canvas().width(), height = sheet.canvas().height();
        int compared = 0;
        for (std::size_t k = 0; k < brushes.size(); ++k) {
            const Point from{20 + 0.22 * width * double(k % 4), 50 + 0.16 * height * double(k / 4)}; // they overlap
            sheet.paint(brushes[k], from);
            if (k % 5 == 3 || k + 1 == brushes.size()) { // the last one is still wet
                compare(sheet, QStringLiteral("after %1").arg(brushes[k].name));
                ++compared;
            }
        }
        sheet.editor().clock().setTime(sheet.painting().end());
        compare(sheet, "dry");
        sheet.editor().clock().lookAt(sheet.painting().end() / 2); // the past, by way of the present
        compare(sheet, "the past");
        QCOMPARE(compared, 5);
    }

private:
    void compare(Sheet &sheet, const QString &when)
    {
        const QString file = m_folder.filePath("live.suffuse"), out = m_folder.filePath("exported.png");
        const QImage live = sheet.live();
        QVERIFY(savePainting(sheet.painting(), file));
        QProcess cli;
        cli.start(QStringLiteral(SUFFUSE_BIN_DIR "/suffuse-cli"),
                  {"render", file, "-o", out, "--size", QStringLiteral("%1x%2").arg(live.width()).arg(live.height()),
                   "--time", QString::number(double(sheet.editor().clock().time()) * 1e-6, 'f', 6), "--backend",
                   "cpu"});
        QVERIFY(cli.waitForFinished(waitMs));
        QVERIFY2(cli.exitCode() == 0, cli.readAllStandardError().constData());
        const QImage exported = QImage(out).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(exported.size(), live.size());
        QSet<QRgb> colours;
        int different = 0;
        for (int y = 0; y < live.height(); ++y)
            for (int x = 0; x < live.width(); ++x) {
                colours.insert(live.pixel(x, y));
                different += live.pixel(x, y) != exported.pixel(x, y);
            }
        QVERIFY2(different == 0, qPrintable(QStringLiteral("%1: %2 pixels differ").arg(when).arg(different)));
        QVERIFY(colours.size() > 1000); // there is something to compare
    }

    QTemporaryDir m_folder;
};

QTEST_MAIN(TestLiveExported)
#include "test_live_exported.moc"

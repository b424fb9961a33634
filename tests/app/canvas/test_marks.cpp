// What lies over the picture: outlines that give way to it, angles and sizes beside the pointer, the pasteboard.
#include "app/tools/brush/brush_tool.h"
#include "app/tools/select/transform_handles.h"
#include "app/widgets/numbers/number_field.h"
#include "tests/app/shapes.h"

#include <QLabel>
#include <QLocale>
#include <QTemporaryDir>

#include <numbers>

using namespace suffuse;

namespace {

const QRgb plate = qRgb(20, 20, 24);

double luminance(QRgb rgb)
{
    const auto linear = [](int channel) {
        const double c = channel / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(qRed(rgb)) + 0.7152 * linear(qGreen(rgb)) + 0.0722 * linear(qBlue(rgb));
}

double contrast(QRgb a, QRgb b)
{
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

/// The box around all pixels of a colour.
QRect boxOf(const QImage &image, QRgb colour)
{
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if ((image.pixel(x, y) & RGB_MASK) == (colour & RGB_MASK))
                box |= QRect(x, y, 1, 1);
    return box;
}

struct Marked : WaveSession {
    Marked() { leave(); }
    QImage shot()
    {
        dry();
        return canvas().grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
    void leave()
    {
        QEvent event(QEvent::Leave);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
    void tool(Command command)
    {
        use(command);
        leave();
    }
    bool showsBadge() { return !boxOf(shot(), plate).isEmpty(); }
};

} // namespace

class TestMarks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        qputenv("SUFFUSE_PRESENTER", "raster");
        qputenv("SUFFUSE_SETTINGS", m_folder.filePath("settings.ini").toLocal8Bit());
    }

    void outlinesGiveWayToThePicture()
    {
        Marked s;
        s.tool(Command::Select);
        s.editor().document().setSelection({});
        const QImage bare = s.shot();
        s.editor().document().setSelection({{s.id}, {}});
        const QImage marked = s.shot();
        QVERIFY(marked != bare);
        s.tool(Command::Brush); // what is painted is to be seen
        QVERIFY(s.shot() == bare);
        s.tool(Command::Select);
        QVERIFY(s.shot() == marked);

        QTest::keyPress(&s.canvas(), Qt::Key_O);
        QVERIFY(s.shot() == bare);
        QTest::keyRelease(&s.canvas(), Qt::Key_O);
        QVERIFY(s.shot() == marked);
        QTest::keyPress(&s.canvas(), Qt::Key_O);
        QFocusEvent away(QEvent::FocusOut); // the release goes elsewhere
        QCoreApplication::sendEvent(&s.canvas(), &away);
        QVERIFY(s.shot() == marked);

        s.editor().setCompared(std::make_shared<Painting>(s.painting())); // Before
        QVERIFY(s.shot() == bare);
        s.editor().setCompared(nullptr);
        QVERIFY(s.shot() == marked);

        const QRect within = QRect(s.at({320, 306}), s.at({480, 334})); // lines, and neither box nor handles
        QVERIFY(marked.copy(within) != bare.copy(within));
        s.use(Command::ShowOutlines);
        QVERIFY(s.shot().copy(within) == bare.copy(within));
        QVERIFY(s.shot() != bare); // what is selected can still be scaled
        Marked next;               // the switch is remembered
        QVERIFY(!next.window.action(Command::ShowOutlines).isChecked());
        s.use(Command::ShowOutlines);
        QVERIFY(s.shot() == marked);
    }

    void theHeldKeyIsACommand()
    {
        Marked s;
        s.tool(Command::Select);
        const QImage marked = s.shot();
        s.window.action(Command::HoldToHideOutlines).setShortcut(QKeySequence("Q"));
        QTest::keyPress(&s.canvas(), Qt::Key_O);
        QVERIFY(s.shot() == marked);
        QTest::keyRelease(&s.canvas(), Qt::Key_O);
        QTest::keyPress(&s.canvas(), Qt::Key_Q);
        QVERIFY(s.shot() != marked);
        QTest::keyRelease(&s.canvas(), Qt::Key_Q);
    }

    /// One of both lines, the dark or the light one, stands out from any paint.
    void linesStandOutFromAnyPaint()
    {
        Marked s;
        for (int r = 0; r <= 255; r += 51)
            for (int g = 0; g <= 255; g += 51)
                for (int b = 0; b <= 255; b += 51) {
                    QImage image(32, 9, QImage::Format_RGB32);
                    image.fill(qRgb(r, g, b));
                    QPainter painter(&image);
                    painter.setRenderHint(QPainter::Antialiasing);
                    QPainterPath line(QPointF(0, 4.5));
                    line.lineTo(32, 4.5);
                    strokeTwoTone(painter, line, s.canvas().overlayColours().accent, 1.1);
                    painter.end();
                    double best = 0;
                    for (int y = 0; y < 9; ++y)
                        best = std::max(best, contrast(image.pixel(16, y), qRgb(r, g, b)));
                    QVERIFY2(best >= 3, qPrintable(QStringLiteral("%1 %2 %3: %4").arg(r).arg(g).arg(b).arg(best)));
                }
    }

    void turningStrokesShowsTheAngle()
    {
        Marked s;
        s.tool(Command::Select);
        NumberField *field = nullptr;
        for (NumberField *f : s.window.findChildren<NumberField *>())
            if (f->accessibleName() == "Rotate the selected strokes by this angle")
                field = f;
        QVERIFY(field);
        s.click({250, 320}); // now it turns
        std::optional<Point> handle;
        for (double x = 600; x <= 630 && !handle; x += 2)
            for (double y = 340; y <= 370 && !handle; y += 2) {
                s.hover({x, y});
                if (s.canvas().tool()->hint().startsWith("Drag: rotate"))
                    handle = Point{x, y};
            }
        QVERIFY(handle);
        QVERIFY(!s.showsBadge());
        s.drag(*handle, *handle + Point{-40, 120}, {}, false);
        QVERIFY(s.showsBadge());
        QVERIFY(field->value() && std::abs(*field->value()) > 5);
        QVERIFY(s.canvas().tool()->hint().contains(QChar(0xB0)));
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, s.at(*handle + Point{-40, 120}));
        QTRY_COMPARE(field->value().value_or(1), 0.0);
        QVERIFY(!s.showsBadge());
    }

    void turningTheCanvasShowsTheAngle()
    {
        Marked s;
        s.tool(Command::Select);
        const QPoint from(400, 100), to(600, 250);
        QTest::keyPress(&s.canvas(), Qt::Key_R);
        QTest::mousePress(&s.canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&s.canvas(), to);
        QVERIFY(std::abs(s.canvas().view().rotation) > 0.01);
        QVERIFY(s.showsBadge());
        const QString angle = angleText(s.canvas().view().rotation);
        const auto isSaid = [&] {
            const QList<QLabel *> labels = s.window.findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(), [&](QLabel *l) { return l->text().endsWith(angle); });
        };
        QVERIFY(isSaid()); // beside the zoom
        QTest::mouseRelease(&s.canvas(), Qt::LeftButton, {}, to);
        QTest::keyRelease(&s.canvas(), Qt::Key_R);
        QVERIFY(!s.showsBadge());
        QVERIFY(isSaid());
        s.use(Command::ResetRotation);
        QVERIFY(!isSaid());
    }

    void anglesAreWritten()
    {
        QLocale::setDefault(QLocale::c());
        constexpr double degree = std::numbers::pi / 180;
        QCOMPARE(angleText(0), QString("0.0°"));
        QCOMPARE(angleText(-0.01 * degree), QString("0.0°"));
        QCOMPARE(angleText(-12.34 * degree), QString("−12.3°"));
        QCOMPARE(angleText(370 * degree), QString("10.0°"));
    }

    void noCircleCrossesABadge()
    {
        View view;
        view.width = 600, view.height = 400;
        for (const Point at : {Point{100, 100}, Point{580, 100}, Point{300, 390}, Point{590, 390}})
            for (const double radius : {0.0, 30.0, 80.0}) {
                QImage image(view.width, view.height, QImage::Format_RGB32);
                image.fill(Qt::white);
                QPainter painter(&image);
                paintBadge(painter, QStringLiteral("Size 30 u"), at, radius, view, 1);
                painter.end();
                const QRect box = boxOf(image, plate);
                QVERIFY(box.width() > 40 && box.height() > 12 && image.rect().contains(box));
                const double dx = std::max({box.left() - at.x, at.x - box.right(), 0.0});
                const double dy = std::max({box.top() - at.y, at.y - box.bottom(), 0.0});
                QVERIFY(std::hypot(dx, dy) >= radius);
            }
        Marked s; // and where it has no room beside the circle, the badge lies over it
        s.tool(Command::Brush);
        for (const double spread : {30.0, 120.0, 400.0}) {
            Brush brush = s.editor().brush();
            brush.setSpread(spread);
            s.editor().setBrush(brush);
            s.hover({512, 384});
            s.use(Command::LargerSize);
            const QImage shot = s.shot();
            const QRect box = boxOf(shot, plate);
            QVERIFY(!box.isEmpty());
            for (int x = box.left() + 8; x < box.right() - 8; ++x)
                for (const int y : {box.top() + 2, box.bottom() - 2})
                    QCOMPARE(shot.pixel(x, y) & RGB_MASK, plate & RGB_MASK);
        }
    }

    void paintBesideTheCanvasIsHiddenOrKnownAsPaint()
    {
        Marked s;
        s.addWave(-300, 300, false);
        s.canvas().panBy({400, 0});
        s.tool(Command::Brush);
        const QPoint beside = s.at({-150, 320}), board = s.at({-150, 600});
        const QImage covered = s.shot();
        QVERIFY(covered.rect().contains(beside) && covered.rect().contains(board));
        const QRgb paint = s.canvas().picture().pixel(beside);
        QVERIFY(contrast(paint, qRgb(255, 255, 255)) > 2);
        QCOMPARE(covered.pixel(beside), covered.pixel(board));
        s.use(Command::ShowBeyond);
        const QImage veiled = s.shot();
        QVERIFY(contrast(veiled.pixel(beside), veiled.pixel(board)) > 1.3);
        QVERIFY(contrast(veiled.pixel(beside), paint) > 1.1);
        QCOMPARE(s.canvas().picture().pixel(beside), paint); // the picture is as it was
        s.use(Command::ShowBeyond);
        QVERIFY(s.shot() == covered);
    }

    void theBoxOfTheSelectionIsDashed_data()
    {
        QTest::addColumn<double>("dpr");
        QTest::newRow("a pixel wide") << 1.0;
        QTest::newRow("two pixels wide") << 2.0;
    }

    void theBoxOfTheSelectionIsDashed()
    {
        QFETCH(double, dpr);
        const int width = int(dpr), size = 400;
        TransformHandles handles;
        handles.setBox(Rect::of(40.5, 40.5, 320, 320));
        View view = View::ofArea(Rect::of(0, 0, size, size), size, size);
        const auto drawn = [&] {
            QImage image(size, size, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            painter.setRenderHint(QPainter::Antialiasing);
            handles.paint(painter, view, dpr, QColor(4, 46, 124), {});
            return image;
        };
        const QImage upright = drawn();
        const int periods = 40, length = 6 * width * (periods / width), from = 80;
        for (const int at : {40, 360}) {
            int dashes = 0, gaps = 0;
            for (int i = from; i < from + length; ++i)
                for (const QPoint pixel : {QPoint(at, i), QPoint(i, at)}) {
                    const QRgb colour = upright.pixel(pixel);
                    dashes += qBlue(colour) > qRed(colour) + 40;
                    gaps += qRed(colour) == qBlue(colour) && qRed(colour) > 100;
                }
            QCOMPARE(dashes, 2 * length * 2 / 3);
            QCOMPARE(gaps, 2 * length / 3);
            QCOMPARE(upright.pixel(at - width, from), qRgb(0, 0, 0)); // beside it nothing
            QCOMPARE(upright.pixel(at + width, from), qRgb(0, 0, 0));
        }
        view.rotation = 0.3;
        const QImage turned = drawn();
        const Point middle = view.toPixels({40.5, 120});
        const QImage onTheLine = turned.copy(int(middle.x) - 8, int(middle.y) - 8, 16, 16);
        QImage nothing = onTheLine;
        nothing.fill(Qt::black);
        QVERIFY(onTheLine != nothing);
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestMarks)
#include "test_marks.moc"

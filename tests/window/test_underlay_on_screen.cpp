// The underlay on the screen: it tints what it lies over by its opacity and nothing else, however the view is turned.
#include "tests/window/screen.h"
#include "undo/edits.h"
#include "undo/underlay_edits.h"

#include <QBuffer>

using namespace suffuse;

namespace {

const Rect place = Rect::of(150, 120, 640, 400);

/// Red and blue above, a green that half shows and nothing below.
QImage fourFields()
{
    QImage image(64, 40, QImage::Format_ARGB32);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const bool left = x < 32, above = y < 20;
            image.setPixelColor(x, y,
                                above ? (left ? QColor(255, 0, 0) : QColor(40, 90, 255))
                                      : (left ? QColor(0, 200, 0, 128) : QColor(0, 0, 0, 0)));
        }
    return image;
}

EncodedImage encoded(const QImage &image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return std::make_shared<const QByteArray>(bytes);
}

/// What a pixel becomes under a colour of the underlay.
QRgb tinted(QRgb below, const QColor &colour, double opacity, bool brightens)
{
    const double strength = opacity * colour.alphaF();
    const auto channel = [&](int b, double c) {
        const double value = brightens ? b + 255 * strength * c - b * strength * c : b * (1 - strength + strength * c);
        return int(std::lround(value));
    };
    return qRgb(channel(qRed(below), colour.redF()), channel(qGreen(below), colour.greenF()),
                channel(qBlue(below), colour.blueF()));
}

/// Compares all of the canvas but borders of fields, where colours mix. Empty: as it should be.
QString wrongPixel(Session &s, const QImage &before, const QImage &after, double opacity, bool brightens = false)
{
    const View &view = s.canvas().view();
    const Rect sheet = s.painting().canvas.area();
    const double margin = 12 * view.px();
    const double blur = place.width() / 64; // of a pixel of the picture
    const QImage picture = fourFields();
    int inside = 0, outside = 0;
    for (int y = 0; y < before.height(); ++y)
        for (int x = 0; x < before.width(); ++x) {
            const Point p = view.toCanvas({x + 0.5, y + 0.5});
            if (!sheet.grown(-margin).contains(p))
                continue;
            const double u = (p.x - place.left) / place.width(), v = (p.y - place.top) / place.height();
            const Rect wide = place.grown(2 * view.px()), narrow = place.grown(-2 * view.px());
            if (wide.contains(p) != narrow.contains(p) || std::abs(u - 0.5) * place.width() < blur ||
                std::abs(v - 0.5) * place.height() < blur)
                continue;
            const bool covered = narrow.contains(p);
            const QRgb now = after.pixel(x, y), was = before.pixel(x, y);
            const QRgb wanted =
                covered ? tinted(was, picture.pixelColor(int(u * 64), int(v * 40)), opacity, brightens) : was;
            if (levels(now, wanted) > (covered ? 3 : 0))
                return QStringLiteral("pixel %1, %2: %3 instead of %4")
                    .arg(x)
                    .arg(y)
                    .arg(now, 8, 16)
                    .arg(wanted, 8, 16);
            ++(covered ? inside : outside);
        }
    return inside > 20'000 && outside > 20'000
               ? QString()
               : QStringLiteral("%1 pixels within, %2 outside").arg(inside).arg(outside);
}

} // namespace

class TestUnderlayOnScreen : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void tintsWhereItLies_data();
    void tintsWhereItLies();
    void brightensADarkCanvas_data() { presenters(); }
    void brightensADarkCanvas();
    void nothingStaysBehind();
    void farAndNear_data() { presenters(); }
    void farAndNear();

private:
    static void presenters();
    static void put(Session &s, double opacity);

    OwnSettings m_settings;
};

void TestUnderlayOnScreen::initTestCase()
{
    BEGIN_ON_SCREEN(m_settings, "raster");
}

void TestUnderlayOnScreen::presenters()
{
    QTest::addColumn<QString>("presenter");
    QTest::newRow("raster") << "raster";
    QTest::newRow("OpenGL") << "opengl";
}

void TestUnderlayOnScreen::put(Session &s, double opacity)
{
    Underlay underlay;
    underlay.image = encoded(fourFields());
    underlay.area = place;
    underlay.opacity = float(opacity);
    s.editor().push(setUnderlay(s.editor().document(), underlay), "underlay");
}

void TestUnderlayOnScreen::tintsWhereItLies_data()
{
    QTest::addColumn<QString>("presenter");
    QTest::addColumn<double>("turned");
    QTest::addColumn<bool>("mirrored");
    for (const char *presenter : {"raster", "opengl"}) {
        QTest::addRow("%s upright", presenter) << presenter << 0.0 << false;
        QTest::addRow("%s turned", presenter) << presenter << 30.0 << false;
        QTest::addRow("%s turned and mirrored", presenter) << presenter << -40.0 << true;
    }
}

void TestUnderlayOnScreen::tintsWhereItLies()
{
    QFETCH(QString, presenter);
    QFETCH(double, turned);
    QFETCH(bool, mirrored);
    QVERIFY(m_settings.begin(qPrintable(presenter)));
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    QCOMPARE(s.canvas().presenterName().toLower(), presenter);
    s.editor().newPainting(Canvas{});
    s.paintLine({100, 300}, {900, 350});
    s.canvas().setZoom(0.6);
    s.canvas().rotateBy(turned);
    if (mirrored)
        s.canvas().mirror();
    s.dry();
    leaveCanvas(s);
    const QImage before = shown(s.canvas());
    put(s, 0.6);
    QTRY_COMPARE_WITH_TIMEOUT(wrongPixel(s, before, shown(s.canvas()), double(0.6f)), QString(), waitMs);

    s.use(Command::ShowUnderlay);
    QVERIFY(!s.painting().underlay->visible);
    QCOMPARE(shown(s.canvas()), before);
    s.use(Command::ShowUnderlay);
    QTRY_COMPARE(wrongPixel(s, before, shown(s.canvas()), double(0.6f)), QString());
    while (s.painting().underlay)
        s.use(Command::Undo);
    QCOMPARE(shown(s.canvas()), before);
}

void TestUnderlayOnScreen::brightensADarkCanvas()
{
    QFETCH(QString, presenter);
    QVERIFY(m_settings.begin(qPrintable(presenter)));
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    Canvas canvas;
    canvas.background = {1, 1, 1, 1};
    s.editor().newPainting(canvas);
    s.dry();
    leaveCanvas(s);
    const QImage before = shown(s.canvas());
    QVERIFY(qGray(before.pixel(before.rect().center())) < 64);
    put(s, 0.5);
    QTRY_COMPARE_WITH_TIMEOUT(wrongPixel(s, before, shown(s.canvas()), 0.5, true), QString(), waitMs);
}

/// Parts that are painted again fit to what is there.
void TestUnderlayOnScreen::nothingStaysBehind()
{
    QVERIFY(m_settings.begin("raster"));
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.editor().newPainting(Canvas{});
    put(s, 0.5);
    s.paintLine({200, 200}, {700, 420});
    s.dry();
    s.editor().document().setSelection({{1}, {}});
    s.canvas().panBy({31, -17});
    for (int i = 0; i < 4; ++i)
        QTest::keyClick(&s.canvas(), Qt::Key_Right, Qt::ShiftModifier);
    leaveCanvas(s);
    QTRY_VERIFY_WITH_TIMEOUT(s.canvas().isUpToDate(), waitMs);
    QTest::qWait(100);
    const QPoint at = s.canvas().mapTo(&s.window, QPoint());
    const QImage seen = s.window.screen()
                            ->grabWindow(s.window.winId(), at.x(), at.y(), s.canvas().width(), s.canvas().height())
                            .toImage()
                            .convertToFormat(QImage::Format_RGB32);
    const QImage anew = shown(s.canvas());
    QCOMPARE(seen.size(), anew.size());
    int stale = 0;
    for (int y = 0; y < anew.height(); ++y)
        for (int x = 0; x < anew.width(); ++x)
            stale += levels(seen.pixel(x, y), anew.pixel(x, y)) > 2;
    QCOMPARE(stale, 0);
}

void TestUnderlayOnScreen::farAndNear()
{
    QFETCH(QString, presenter);
    QVERIFY(m_settings.begin(qPrintable(presenter)));
    Session s;
    QVERIFY(QTest::qWaitForWindowExposed(&s.window));
    s.editor().newPainting(Canvas{});
    put(s, 1);
    View view = s.canvas().view();
    view.centre = {place.left + 0.25 * place.width(), place.top + 0.25 * place.height()}; // in the red
    const auto middle = [&](double scale) {
        view.scale = scale;
        s.canvas().lookThrough(view);
        const QImage image = shown(s.canvas());
        return image.pixel(image.rect().center());
    };
    for (const double scale : {0.5, 4.0, 1000.0, 1e6, 1e9})
        QTRY_VERIFY_WITH_TIMEOUT(levels(middle(scale), qRgb(255, 0, 0)) <= 2, waitMs);
    view.centre = {2000, 2000}; // beside canvas and underlay
    QTRY_VERIFY_WITH_TIMEOUT(levels(middle(1e6), qRgb(255, 0, 0)) > 100, waitMs);
}

QTEST_MAIN(TestUnderlayOnScreen)
#include "test_underlay_on_screen.moc"

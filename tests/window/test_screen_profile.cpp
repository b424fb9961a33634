// The profile that the desktop has given to the screen.
#include "app/canvas/presenters/screen_profile.h"
#include "app/session/settings/colour_settings.h"
#include "tests/wide_profile.h"
#include "tests/window/screen.h"

#include <QScreen>

#include <xcb/xcb.h>

using namespace suffuse;

namespace {

/// As colord and its relatives do it; without bytes the screen has no profile any more.
void giveProfile(const QByteArray &profile)
{
    xcb_connection_t *x = qGuiApp->nativeInterface<QNativeInterface::QX11Application>()->connection();
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(x)).data->root;
    const QByteArray name("_ICC_PROFILE");
    const auto asked = xcb_intern_atom(x, false, uint16_t(name.size()), name.constData());
    const std::unique_ptr<xcb_intern_atom_reply_t, void (*)(void *)> atom(xcb_intern_atom_reply(x, asked, nullptr),
                                                                          std::free);
    if (profile.isEmpty())
        xcb_delete_property(x, root, atom->atom);
    else
        xcb_change_property(x, XCB_PROP_MODE_REPLACE, root, atom->atom, XCB_ATOM_CARDINAL, 8, uint32_t(profile.size()),
                            profile.constData());
    xcb_flush(x);
}

} // namespace

class TestScreenProfile : public QObject {
    Q_OBJECT

    OwnSettings m_settings;

private slots:
    void initTestCase()
    {
        if (const QString why = noScreen(); !why.isEmpty())
            QSKIP(qPrintable(why));
        QVERIFY(!test::wideProfile().isEmpty());
    }
    void cleanup()
    {
        if (noScreen().isEmpty())
            giveProfile({});
    }

    void followsTheSystem_data()
    {
        QTest::addColumn<QByteArray>("presenter");
        QTest::newRow("raster") << QByteArray("raster");
        QTest::newRow("OpenGL") << QByteArray("opengl");
    }

    /// The canvas is converted as soon as the screen has a profile, and is not any more when that goes; the picture
    /// stays.
    void followsTheSystem()
    {
        QFETCH(QByteArray, presenter);
        QVERIFY(m_settings.begin(presenter.constData()));
        Session s;
        const QString plainPresenter = s.canvas().presenterName();
        s.editor().newPainting(Canvas{});
        Brush red = builtinBrushes().front();
        red.colour = {1, 0, 0, 1};
        s.editor().setBrush(red);
        s.use(Command::Brush);
        const double middle = s.painting().canvas.area().height() / 2;
        s.paintLine({200, middle}, {800, middle});
        s.dry();
        const QByteArray profile = test::wideProfile();
        QVERIFY(systemProfileOf(s.canvas().screen()).isEmpty());
        giveProfile(profile);
        QCOMPARE(systemProfileOf(s.canvas().screen()), profile);
        s.canvas().readColours();
        QCOMPARE(s.canvas().presenterName(), QStringLiteral("raster")); // It has the pixels at hand.
        s.dry();
        const QImage converted = shown(s.canvas()), picture = s.canvas().picture();
        const ScreenColours colours(*ColourConversion::between({{}, profile, {}}));
        int differ = 0;
        for (int x = 0; x < picture.width(); x += 3) { // along the stroke, and the sheet beside it
            const int y = picture.height() / 2;
            const Point p = s.canvas().view().toCanvas({x + 0.5, y + 0.5});
            if (p.x < 100 || p.x > 700) // The pointer's circle is further to the right.
                continue;
            std::uint32_t expected = picture.pixel(x, y) | 0xFF000000;
            colours.convert(&expected, 1);
            QCOMPARE(converted.pixel(x, y), expected);
            differ += expected != picture.pixel(x, y);
        }
        QVERIFY(differ > 0);
        giveProfile({});
        s.canvas().readColours();
        QCOMPARE(s.canvas().presenterName(), plainPresenter);
        s.dry();
        QVERIFY(shown(s.canvas()).pixel(picture.width() / 2, picture.height() / 2) ==
                (s.canvas().picture().pixel(picture.width() / 2, picture.height() / 2) | 0xFF000000));
    }
};

QTEST_MAIN(TestScreenProfile)
#include "test_screen_profile.moc"

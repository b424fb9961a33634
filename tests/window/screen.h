// What stands on the screen, and what ought to.
#pragma once

#include "render/backends.h"
#include "tests/app/session.h"

#include <QFile>
#include <QOpenGLWidget>
#include <QTemporaryDir>

#include <algorithm>

namespace suffuse {

/// Why a window test cannot run here; empty: it can.
inline QString noScreen()
{
    const QString platform = QGuiApplication::platformName();
    return platform == "xcb"
               ? QString()
               : QStringLiteral("needs an X server, the platform is %1: run it under xvfb-run").arg(platform);
}

/// Settings of a program that tests windows, which has never run before.
class OwnSettings {
public:
    /// From the next window on; one way to present pictures. False where there is no room for them.
    bool begin(const char *presenter) const
    {
        const QString path = m_folder.filePath("settings.ini");
        QFile::remove(path);
        qputenv("SUFFUSE_SETTINGS", path.toLocal8Bit());
        qputenv("SUFFUSE_PRESENTER", presenter);
        return m_folder.isValid();
    }

private:
    QTemporaryDir m_folder;
};

/// The canvas as it stands on the screen, in device pixels, the overlay with it.
inline QImage shown(CanvasWidget &canvas)
{
    if (auto *gl = canvas.findChild<QOpenGLWidget *>())
        return gl->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    return canvas.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// What one call of the renderer draws of the same moment and view.
inline QImage rendered(Session &s)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu});
    if (!renderer)
        return {};
    Picture8 picture;
    const RenderRequest request{s.editor().document().snapshot(), s.editor().clock().time(), s.canvas().view()};
    if (!(*renderer)->render(request, picture))
        return {};
    return QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                  QImage::Format_RGB32)
        .copy();
}

inline int levels(QRgb a, QRgb b)
{
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

/// Compares within the painting's canvas, a little inside: its border is overlay. Empty: at most one level apart.
inline QString difference(Session &s, const QImage &screen, const QImage &truth)
{
    if (screen.size() != truth.size())
        return QStringLiteral("the screen has %1 × %2 pixels, the picture %3 × %4")
            .arg(screen.width())
            .arg(screen.height())
            .arg(truth.width())
            .arg(truth.height());
    const View &view = s.canvas().view();
    const Rect area = s.painting().canvas.area();
    const double margin = 12 * view.px() * s.canvas().devicePixelRatioF();
    qint64 compared = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            const Point p = view.toCanvas({x + 0.5, y + 0.5});
            if (p.x < area.left + margin || p.y < area.top + margin || p.x > area.right - margin ||
                p.y > area.bottom - margin)
                continue;
            ++compared;
            if (levels(screen.pixel(x, y), truth.pixel(x, y)) > 1)
                return QStringLiteral("pixel %1, %2: %3 on the screen, %4 in the picture")
                    .arg(x)
                    .arg(y)
                    .arg(screen.pixel(x, y), 8, 16)
                    .arg(truth.pixel(x, y), 8, 16);
        }
    return compared > 10'000 ? QString() : QStringLiteral("only %1 pixels were to be compared").arg(compared);
}

/// No ring under the pointer: only the picture is left inside the canvas.
inline void leaveCanvas(Session &s)
{
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&s.canvas(), &leave);
    QCoreApplication::processEvents();
}

inline int paintedPixels(const QImage &picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += qGray(picture.pixel(x, y)) < 128;
    return count;
}

} // namespace suffuse

/// What each test of windows begins with.
#define BEGIN_ON_SCREEN(settings, presenter)                                                                           \
    do {                                                                                                               \
        if (const QString why = noScreen(); !why.isEmpty())                                                            \
            QSKIP(qPrintable(why));                                                                                    \
        QVERIFY((settings).begin(presenter));                                                                          \
    } while (false)

/// The canvas shows what one call of the renderer draws.
#define COMPARE_SCREEN(s)                                                                                              \
    do {                                                                                                               \
        QTRY_VERIFY_WITH_TIMEOUT((s).canvas().isUpToDate(), waitMs);                                                   \
        leaveCanvas(s);                                                                                                \
        const QImage truth = rendered(s);                                                                              \
        QVERIFY(paintedPixels(truth) > 1000);                                                                          \
        QTRY_COMPARE_WITH_TIMEOUT(difference(s, shown((s).canvas()), truth), QString(), 5000);                         \
    } while (false)

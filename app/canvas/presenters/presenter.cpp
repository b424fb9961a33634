#include "app/canvas/presenters/presenter.h"

#include "app/session/settings/settings.h"
#include "model/environment.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace suffuse {

namespace {

/// The driver's name for what draws; empty where there is no OpenGL.
QByteArray openGlRendererName()
{
    QOpenGLContext context;
    if (!context.create())
        return {};
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface))
        return {};
    const auto *name = reinterpret_cast<const char *>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray result(name ? name : "");
    context.doneCurrent();
    return result;
}

bool isHardwareOpenGl()
{
    // Without a display the offscreen platform has no OpenGL, and asking it with DISPLAY set crashes (Qt 6.4).
    static const bool hardware = [] {
        const QString platform = QGuiApplication::platformName();
        if (platform == "offscreen" || platform == "minimal" || platform == "vnc" || platform == "linuxfb")
            return false;
        const QByteArray name = openGlRendererName().toLower();
        return !name.isEmpty() && !name.contains("llvmpipe") && !name.contains("softpipe") &&
               !name.contains("swrast") && !name.contains("software");
    }();
    return hardware;
}

} // namespace

Presenter *makePresenter(CanvasContent &content, QWidget *parent)
{
    QByteArray wish = QByteArray::fromStdString(environment::value(environment::Variable::Presenter)).toLower();
    if (wish.isEmpty() && settings::presenter() != settings::Presenter::Auto)
        wish = settings::presenter() == settings::Presenter::OpenGL ? "opengl" : "raster";
    const bool hasOpenGl = QGuiApplication::platformName() != "offscreen";
    if (!hasOpenGl || !content.screenColours().changesNothing())
        wish = "raster";
    const bool openGl = wish == "opengl" || (wish != "raster" && isHardwareOpenGl());
    return openGl ? makeOpenGlPresenter(content, parent) : makeRasterPresenter(content, parent);
}

bool isFrameUseful(const ShownFrame &frame, const View &view)
{
    const double k = view.scale / frame.view.scale;
    return frame.width() > 0 && frame.height() > 0 && k < 256 && k > 1.0 / 256;
}

void prepareOpenGl()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setSwapInterval(1);
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(8); // QPainter clips with it.
    QSurfaceFormat::setDefaultFormat(format);
}

} // namespace suffuse

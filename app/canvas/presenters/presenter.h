// How the picture gets on the screen: one interface, two ways.
#pragma once

#include "app/canvas/underlay.h"
#include "app/session/frames/shown_frame.h"

#include <QColor>
#include <QWidget>

class QPainter;

namespace suffuse {

/// What a presenter shows; the canvas implements it.
class CanvasContent {
public:
    virtual ~CanvasContent() = default;
    virtual const View &shownView() const = 0;
    virtual void withFrame(const std::function<void(ShownFrame &)> &use) = 0;
    /// Pictures may stay on the device that computes them, or must come to memory, as at first: then `why` says for the
    /// user why. Older frames may still come either way.
    virtual void setDeviceFramesWanted(bool wanted, const QString &why) = 0;
    /// Fills what no frame covers yet.
    virtual QColor backgroundColour() const = 0;
    /// What lies over the picture and below the pasteboard; none, or none that is ready.
    virtual std::optional<ShownUnderlay> underlay() const = 0;
    /// The pasteboard, over what the picture shows beside the canvas; the painter's units are device pixels.
    virtual void paintAround(QPainter &painter) = 0;
    /// Everything else that lies over the picture, in the same units.
    virtual void paintOverlay(QPainter &painter) = 0;
};

/// Fills its widget with the content. The widget takes no input and belongs to its parent.
class Presenter {
public:
    virtual ~Presenter() = default;
    virtual QWidget *widget() = 0;
    virtual QString name() const = 0; ///< "raster" or "OpenGL"
    /// A part of the content has changed, in logical pixels of the widget.
    virtual void updateArea(const QRegion &area) = 0;
};

/// OpenGL where it is hardware, raster where OpenGL is software, absent or the platform is offscreen. The setting and,
/// before it, the environment variable SUFFUSE_PRESENTER=raster|opengl override, except on the offscreen platform. The
/// presenter's widget is a child of `parent`.
Presenter *makePresenter(CanvasContent &content, QWidget *parent);

/// The two kinds, for makePresenter.
Presenter *makeRasterPresenter(CanvasContent &content, QWidget *parent);
Presenter *makeOpenGlPresenter(CanvasContent &content, QWidget *parent);

/// A frame of a scale too far from the view's shows nothing useful; then only the background is drawn.
bool isFrameUseful(const ShownFrame &frame, const View &view);

/// Sets the default surface format; call before QApplication is made.
void prepareOpenGl();

} // namespace suffuse

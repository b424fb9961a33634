// How the picture gets on the screen: one interface, and two ways to do it.
#pragma once

#include "app/canvas/underlay.h"
#include "app/session/colour/screen_colours.h"
#include "app/session/frames/shown_frame.h"

#include <QColor>
#include <QWidget>

class QPainter;

namespace suffuse {

/// What a presenter shows. The canvas implements it.
class CanvasContent {
public:
    virtual ~CanvasContent() = default;
    virtual const View &shownView() const = 0;
    virtual void withFrame(const std::function<void(ShownFrame &)> &use) = 0;
    /// Says whether pictures may stay on the device that computes them or must come to memory, as they do at first. In
    /// the second case `why` tells the user the reason. Frames from before the call may still come either way.
    virtual void setDeviceFramesWanted(bool wanted, const QString &why) = 0;
    /// The colour of what no frame covers yet.
    virtual QColor backgroundColour() const = 0;
    /// What makes the screen's colours of the picture's.
    virtual const ScreenColours &screenColours() const = 0;
    /// The underlay, which lies over the picture and below the pasteboard; no value where there is none or it is not
    /// ready.
    virtual std::optional<ShownUnderlay> underlay() const = 0;
    /// Paints the pasteboard over the part of the picture that lies beside the canvas. The painter's units are device
    /// pixels.
    virtual void paintAround(QPainter &painter) = 0;
    /// Paints everything else that lies over the picture, in the same units.
    virtual void paintOverlay(QPainter &painter) = 0;
};

/// Shows the content in its widget. The widget takes no input and belongs to its parent.
class Presenter {
public:
    virtual ~Presenter() = default;
    virtual QWidget *widget() = 0;
    virtual QString name() const = 0; ///< "raster" or "OpenGL"
    /// Repaints a part of the content, in logical pixels of the widget.
    virtual void updateArea(const QRegion &area) = 0;
};

/// Chooses OpenGL where it is hardware, and raster where OpenGL is software or absent, or the platform is offscreen.
/// Except on the offscreen platform the setting overrides this, and the environment variable
/// SUFFUSE_PRESENTER=raster|opengl overrides both. Where colours are converted for the screen it is always raster,
/// which has the pixels at hand. The presenter's widget is a child of `parent`.
Presenter *makePresenter(CanvasContent &content, QWidget *parent);

/// Make one of the two kinds, for makePresenter.
Presenter *makeRasterPresenter(CanvasContent &content, QWidget *parent);
Presenter *makeOpenGlPresenter(CanvasContent &content, QWidget *parent);

/// Whether a frame shows something useful in a view. If its scale is too far from the view's, only the background is
/// drawn.
bool isFrameUseful(const ShownFrame &frame, const View &view);

/// Sets the default surface format. To be called before QApplication is made.
void prepareOpenGl();

} // namespace suffuse

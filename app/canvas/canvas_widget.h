// The canvas: shows the painting, moves the view, and hands the pointer to the tool in use.
#pragma once

#include "app/canvas/canvas_lift.h"
#include "app/canvas/canvas_view.h"
#include "app/canvas/input/canvas_input.h"
#include "app/canvas/overlay/overlay.h"
#include "app/canvas/overlay/overlay_repaint.h"
#include "app/canvas/overlay/shown_selection.h"
#include "app/canvas/presenters/presenter.h"
#include "app/canvas/tool.h"
#include "app/session/frames/frame_thread.h"
#include "app/session/selecting/snapping.h"
#include "render/backends.h"

#include <QImage>
#include <QWidget>

#include <numbers>

namespace suffuse {

class Editor;
struct Change;

/// Shows the last finished frame at once wherever the view is, and swaps in the sharp one when it is ready.
/// All pixels of its interface are device pixels.
class CanvasWidget : public QWidget, private CanvasContent {
    Q_OBJECT

public:
    explicit CanvasWidget(Editor &editor, QWidget *parent = nullptr, MakeRenderer make = makeRenderer);
    ~CanvasWidget() override;

    Editor &editor() { return m_editor; }
    const View &view() const { return m_view.view(); }
    /// "CPU · 2 threads · AVX2", of the last frame; empty before the first one.
    const QString &backendText() const { return m_backendText; }
    /// Empty, or why the CPU draws, and why the picture takes the way over memory: a line each.
    QString backendNotice() const;
    QString presenterName() const { return m_presenter->name(); }

    /// The tool in use; tools belong to whoever makes them. The old one is cancelled.
    void setTool(Tool *tool);
    Tool *tool() const { return m_input.hand().tool(); }
    /// The tool has seen a press and no release yet.
    bool isPressed() const { return m_input.hand().isPressed(); }

    /// At the pointer if it is over the canvas, else at the centre.
    void zoomBy(double factor) { m_view.zoomAt(zoomCentre(), factor); }
    void setZoom(double scale) { m_view.setScaleAt(zoomCentre(), scale); } ///< pixels per unit
    void fit(); ///< the whole canvas; stays so when the window changes size
    bool isFitted() const { return m_view.isFitted(); }
    /// In a window of any size, its centre in the middle.
    void lookThrough(const View &view) { m_view.lookThrough(view); }
    void panBy(Point pixels) { m_view.panBy(pixels); }
    void rotateBy(double degrees) { m_view.rotateAt(m_view.centre(), degrees * std::numbers::pi / 180); }
    void resetRotation() { m_view.resetRotation(); }
    void mirror() { m_view.mirror(); }

    /// Repaints the overlay, or the part of it in `pixels`.
    void updateOverlay() { m_repaint.all(); }
    void updateOverlay(const QRectF &pixels) { m_repaint.part(pixels); }
    void updateOverlay(const QRegion &pixels) { m_repaint.part(pixels); }
    /// What is selected, less the strokes that are not begun at the moment that is looked at: they have neither outline
    /// nor handles.
    const Selection &selection() const { return m_selected.selection(); }
    /// `selectionBox` of that, from boxes of strokes that are kept.
    Rect selectedCurves() const { return m_selected.curves(); }
    /// Where that is on the screen, as far as the view shows it: global logical pixels; empty: nowhere.
    QRect selectionOnScreen() const;
    /// Repaints what stands at the selected strokes, then and now; while they are dragged together with the next frame.
    void updateSelection() { m_repaint.selection(); }
    void refreshCursor() { setCursor(m_input.cursor()); }
    /// They mean the canvas, even where they are commands' shortcuts.
    void setHeldKeys(const HeldKeys &keys) { m_input.keys().setKeys(keys); }
    /// Keys that stay the window's even where the tool wants them.
    void setWindowKeys(const QList<QKeySequence> &keys) { m_input.setWindowKeys(keys); }

    /// Strokes that float while a gesture maps them.
    CanvasLift &lifted() { return m_lift; }
    bool isLifted() const { return m_lift.isLifted(); }

    /// True when the picture on the screen is that of the document as it is now, at this moment, in this view.
    bool isUpToDate() const;
    /// Serial (FrameInfo) of the first frame that shows the document as it is now.
    quint64 neededFrame() const { return m_lastSerial + (m_renderScheduled ? 1 : 0); }
    /// A copy of the last finished frame, without overlay; null while frames stay on the device.
    QImage picture();
    /// Theme colours of pasteboard and overlay, from the palette.
    const OverlayColours &overlayColours() const { return m_colours; }

    /// Nothing lies over the picture that belongs to the selection or the tool: while the key for it is held, and while
    /// another state of the painting is shown.
    bool isBare() const;
    /// Selected strokes have their lines.
    bool showsOutlines() const;
    /// Snapping, and what is drawn over the picture.
    const CanvasAids &aids() const { return m_aids; }
    void setAids(const CanvasAids &aids)
    {
        m_aids = aids;
        updateOverlay();
    }
    const PenSettings &penSettings() const { return m_input.pen().settings(); }
    void setPenSettings(const PenSettings &settings) { m_input.pen().setSettings(settings); }
    /// The modifier keys as the last event of the canvas left them.
    Qt::KeyboardModifiers modifiers() const { return m_input.modifiers(); }

signals:
    void viewChanged();
    void modifiersChanged();
    void toolChanged();
    void begunChanged();                   ///< `selection`, though nothing else was selected
    void busyChanged();                    ///< something is in the tool's hand, or no more
    void pointerMoved(double x, double y); ///< canvas units
    void pointerLeft();
    void framePresented(const suffuse::FrameInfo &frame);
    void backendChanged();                       ///< its text or its notice
    void underlayFailed(const QString &problem); ///< it cannot be shown
    void penTurned(bool eraser);                 ///< before the first report of the pen's other end

protected:
    bool event(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void enterEvent(QEnterEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool focusNextPrevChild(bool next) override;

private:
    // CanvasContent
    const View &shownView() const override { return view(); }
    void withFrame(const std::function<void(ShownFrame &)> &use) override { m_worker.withFrame(use); }
    void setDeviceFramesWanted(bool wanted, const QString &why) override;
    QColor backgroundColour() const override;
    std::optional<ShownUnderlay> underlay() const override;
    void paintAround(QPainter &painter) override;
    void paintOverlay(QPainter &painter) override;
    void wantUnderlay();
    void endDrag();
    /// A drag may follow that is too much for exact frames.
    bool wantsCoarse() const;

    void follow(const Change &change);
    void followMoment();
    void scheduleRender();
    void requestFrame();
    /// What is shown changes again and again: quick frames do.
    bool isMoving() const;
    void handRests(quint64 serial);
    void paintSelection(QPainter &painter, double dpr);
    void paintAngle(QPainter &painter, double dpr) const;
    void frameReady(const FrameInfo &frame);
    void viewMoved();
    void connectInput();
    void readPalette();
    Point zoomCentre() const;

    Editor &m_editor;
    FrameThread m_worker;
    UnderlayLoader m_underlay;
    Presenter *m_presenter = nullptr;
    CanvasView m_view;
    CanvasInput m_input;
    OverlayColours m_colours;
    CanvasAids m_aids;
    ShownSelection m_selected;
    OverlayRepaint m_repaint;
    QString m_backendText;
    QString m_rendererNotice;
    QString m_presenterNotice;

    CanvasLift m_lift{m_editor, m_worker, m_view, [this] { scheduleRender(); }};
    bool m_renderScheduled = false;
    quint64 m_lastSerial = 0;
};

} // namespace suffuse

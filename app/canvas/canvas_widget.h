// The canvas: it shows the painting, moves the view, and hands the pointer to the tool in use.
#pragma once

#include "app/canvas/canvas_lift.h"
#include "app/canvas/canvas_view.h"
#include "app/canvas/handles/canvas_handles.h"
#include "app/canvas/input/canvas_input.h"
#include "app/canvas/overlay/canvas_overlay.h"
#include "app/canvas/overlay/overlay_repaint.h"
#include "app/canvas/overlay/shown_selection.h"
#include "app/canvas/presenters/canvas_colours.h"
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
struct RulerUnit;

/// Whether one works on a canvas or, since the painting is painted elsewhere, only looks at it.
enum class CanvasUse { Work, Look };

/// Shows the last finished frame at once wherever the view is, and shows the sharp one instead when it is ready.
/// All pixels of its interface are device pixels.
class CanvasWidget : public QWidget, private CanvasContent {
    Q_OBJECT

public:
    explicit CanvasWidget(Editor &editor, QWidget *parent = nullptr, MakeRenderer make = makeRendererAtOnce,
                          CanvasUse use = CanvasUse::Work);
    ~CanvasWidget() override;

    Editor &editor() { return m_editor; }
    const View &view() const { return m_view.view(); }
    /// What drew the last frame, as in "CPU · 2 threads · AVX2"; empty before the first one.
    const QString &backendText() const { return m_backendText; }
    /// Why the CPU draws, and why pictures go through memory, a line for each reason; empty where neither is so.
    QString backendNotice() const;
    /// Takes the settings of colours, and the screen's profile, as they are now.
    void readColours();
    const CanvasColours &colours() const { return m_screenColours; }
    QString presenterName() const { return m_presenter->name(); }

    /// Sets the tool in use, which belongs to whoever made it. The tool before it is cancelled.
    void setTool(Tool *tool);
    /// Ends what the tool has in hand as the release of the button would, before something else is done.
    void finishGesture() { m_input.finish(); }
    /// Finishes what the tool holds between two presses, an outline for example, so that it belongs to the painting:
    /// before all of it is put away.
    void settleTool()
    {
        if (tool() && !isPressed())
            tool()->settle();
    }
    /// Before the painting is written to a file, which ends nothing: what the tool holds goes on being in its hand.
    void settleWritten()
    {
        if (tool() && !isPressed())
            tool()->settleWritten();
    }
    Tool *tool() const { return m_input.hand().tool(); }
    /// Whether the tool has seen a press and no release yet.
    bool isPressed() const { return m_input.hand().isPressed(); }

    /// Zooms at the pointer if it is over the canvas, else at the centre.
    void zoomBy(double factor) { m_view.zoomAt(zoomCentre(), factor); }
    void setZoom(double scale) { m_view.setScaleAt(zoomCentre(), scale); } ///< scale in device pixels per canvas unit
    void fit(); ///< Shows the whole canvas, also after the window changes its size.
    /// Shows what is selected as large as possible, of nodes that the tool has selected the curves around them. Does
    /// nothing without a selection.
    void zoomToSelection();
    bool isFitted() const { return m_view.isFitted(); }
    /// Shows what another view shows. The view may be of a window of another size; its centre stays in the middle.
    void lookThrough(const View &view) { m_view.lookThrough(view); }
    void panBy(Point pixels) { m_view.panBy(pixels); }
    /// Moves the canvas as CanvasView::bringIntoView does, with a margin of a finger's width around the box of pixels.
    void bringIntoView(const Rect &pixels);
    /// Does so with a point of the canvas.
    void bringIntoView(Point point);
    void rotateBy(double degrees) { m_view.rotateAt(m_view.centre(), degrees * std::numbers::pi / 180); }
    void resetRotation() { m_view.resetRotation(); }
    void mirror() { m_view.mirror(); }

    /// Paints with keys, where it is on. It begins at the pointer, or in the middle of the view.
    KeyboardPen &keyboardPen() { return m_input.keyboardPen(); }
    void setKeyboardPenOn(bool on) { keyboardPen().setOn(on, zoomCentre()); }

    /// What is written over the picture for a moment.
    CanvasNote &note() { return m_overlay.note(); }

    /// Repaints the overlay, or the part of it in `pixels`.
    void updateOverlay() { m_repaint.all(); }
    void updateOverlay(const QRectF &pixels) { m_repaint.part(pixels); }
    void updateOverlay(const QRegion &pixels) { m_repaint.part(pixels); }
    /// The selection without the strokes that are not begun at the moment that is looked at, which have neither outline
    /// nor handles.
    const Selection &selection() const { return m_selected.selection(); }
    /// The box that `selectionBox` gives for that selection. It is quick, since it is made from boxes of strokes that
    /// are kept.
    Rect selectedCurves() const { return m_selected.curves(); }
    /// The part of that box that the view shows, in global logical pixels; empty where it shows none of it.
    QRect selectionOnScreen() const;
    /// Repaints what stands at the selected strokes, where they were and where they are. While they are dragged, it
    /// waits for the next frame.
    void updateSelection() { m_repaint.selection(); }
    void refreshCursor() { setCursor(m_input.cursor()); }
    /// Sets keys that mean the canvas while they are held, even where they are shortcuts of commands.
    void setHeldKeys(const HeldKeys &keys) { m_input.keys().setKeys(keys); }
    /// Sets keys that belong to the window even where the tool wants them.
    void setWindowKeys(const QList<QKeySequence> &keys) { m_input.setWindowKeys(keys); }

    /// The strokes that float while a gesture maps them.
    CanvasLift &lifted() { return m_lift; }
    bool isLifted() const { return m_lift.isLifted(); }

    /// Whether the picture on the screen is that of the document as it is now, at this moment, in this view.
    bool isUpToDate() const;
    /// The serial (see FrameInfo) of the first frame that shows the document as it is now.
    quint64 neededFrame() const { return m_lastSerial + (m_renderScheduled ? 1 : 0); }
    /// A copy of the last finished frame, without overlay. It is null while frames stay on the device.
    QImage picture();
    /// The colours of pasteboard and overlay, which follow the palette.
    const OverlayColours &overlayColours() const { return m_overlay.colours(); }

    /// Whether nothing of the selection or of the tool lies over the picture. It is so while the key for it is held,
    /// and while another state of the painting is shown.
    bool isBare() const { return m_overlay.isBare(); }
    /// Whether lines are drawn through the selected strokes.
    bool showsOutlines() const { return m_overlay.showsOutlines(); }
    /// Shows what is selected, though the tool in use shows no outlines, until something is painted or another tool is
    /// taken. What is selected anew is shown by itself.
    void revealSelection(bool revealed = true);
    bool isSelectionRevealed() const { return m_overlay.isRevealed(); }
    /// Whether erasures of all strokes are shown, by the command.
    bool showsErasures() const { return m_overlay.showsErasures(); }
    /// How snapping works, and what is drawn over the picture.
    const CanvasAids &aids() const { return m_overlay.aids(); }
    /// What the rulers count.
    RulerUnit rulerUnit() const;
    void setAids(const CanvasAids &aids)
    {
        m_overlay.setAids(aids);
        updateOverlay();
    }
    const PenSettings &penSettings() const { return m_input.pen().settings(); }
    void setPenSettings(const PenSettings &settings) { m_input.pen().setSettings(settings); }
    /// The modifier keys that were held at the last event of the canvas.
    /// Where the pointer is, if it is over the canvas; device pixels.
    std::optional<Point> pointer() const { return m_input.pointer(); }
    Qt::KeyboardModifiers modifiers() const { return m_input.modifiers(); }

signals:
    void viewChanged();
    void modifiersChanged();
    void toolChanged();
    void begunChanged(); ///< `selection()` has changed, though nothing else was selected
    void busyChanged();  ///< something has come into the tool's hand, has left it, or is pressed no more
    void pointerMoved(double x, double y); ///< canvas units
    void pointerLeft();
    void asked(const suffuse::PointerEvent &event); ///< the right button asks what is there
    void framePresented(const suffuse::FrameInfo &frame);
    void coloursChanged();                       ///< what `colours` says is different
    void backendChanged();                       ///< the text of the backend, or the notice about it, has changed
    void underlayFailed(const QString &problem); ///< the underlay cannot be shown
    void guideAsked(int guide);                  ///< the exact place of a guide is wanted, by its number
    void penTurned(bool eraser);                 ///< emitted before the first report of the pen's other end

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
    void inputMethodEvent(QInputMethodEvent *event) override;
    QVariant inputMethodQuery(Qt::InputMethodQuery query) const override;

private:
    // What presenters ask of the canvas (CanvasContent).
    const View &shownView() const override { return view(); }
    void withFrame(const std::function<void(ShownFrame &)> &use) override { m_worker.withFrame(use); }
    void setDeviceFramesWanted(bool wanted, const QString &why) override;
    QColor backgroundColour() const override;
    const ScreenColours &screenColours() const override { return m_screenColours.screen(); }
    std::optional<ShownUnderlay> underlay() const override;
    void paintAround(QPainter &painter) override;
    void paintOverlay(QPainter &painter) override;
    void wantUnderlay();
    void endDrag();
    /// Whether a drag may follow for which exact frames would take too long.
    bool wantsCoarse() const;

    void follow(const Change &change);
    void followMoment();
    void scheduleRender();
    void requestFrame();
    /// Whether what is shown changes again and again, so that quick frames are good enough.
    bool isMoving() const;
    void handRests(quint64 serial);
    void frameReady(const FrameInfo &frame);
    void viewMoved();
    void connectInput();
    void addHandles();
    void tellShown(bool shown);
    /// Input methods work while what is typed goes into a text.
    void followTyping();
    Point zoomCentre() const;

    Editor &m_editor;
    const CanvasUse m_use;
    FrameThread m_worker;
    UnderlayLoader m_underlay;
    CanvasColours m_screenColours;
    Presenter *m_presenter = nullptr;
    CanvasView m_view;
    CanvasHandles m_handles; ///< of the symmetry, and guides
    CanvasInput m_input;
    ShownSelection m_selected;
    OverlayRepaint m_repaint;
    QString m_backendText;
    QString m_rendererNotice;
    QString m_presenterNotice;

    CanvasLift m_lift{m_editor, m_worker, m_view, [this] { scheduleRender(); }};
    CanvasOverlay m_overlay{m_editor, m_view, m_input, m_handles, m_selected, m_lift};
    bool m_renderScheduled = false;
    quint64 m_lastSerial = 0;
};

} // namespace suffuse

#pragma once

#include "app/session/gesture.h"
#include "app/session/selecting/choosing.h"
#include "app/session/selecting/pick.h"
#include "app/session/selecting/pick_text.h"
#include "app/tools/select/transform_handles.h"
#include "app/tools/select/transform_snap.h"
#include "app/tools/selection_tool.h"

#include <QPointer>

namespace suffuse {

class Commands;
class TransformBar;
struct Change;

/// Selects strokes by their visible paint, moves them, and maps them by the handles around them. A second click
/// switches between the handles that scale and those that turn, as in Inkscape.
class SelectTool : public SelectionTool {
    Q_OBJECT

public:
    SelectTool(CanvasWidget &canvas, Commands &commands, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override;
    QWidget *options() override;
    void release(const PointerEvent &event) override;
    void cancel() override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    /// Selects the next stroke for Tab, and the previous one for Shift+Tab.
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;
    std::optional<double> paintMargin() const override;
    bool leavesToGuides(Point pixel) const override;

    /// The handles around the selection, as they are shown.
    const TransformHandles &handles() const;

protected:
    void pressed(const PointerEvent &event) override;
    void clicked(const PointerEvent &event) override;
    BandShape bandShape(const PointerEvent &event) const override;
    void banded(const Rect &band, const PointerEvent &event) override;
    void tracing(Point point, BandShape shape) override;
    void traced(const std::vector<Point> &path, BandShape shape, const PointerEvent &event) override;
    bool beginDrag(const PointerEvent &event) override;
    void drag(const PointerEvent &event) override;
    void endDrag(bool cancelled) override;

private:
    void followDocument(const Change &change);
    std::optional<SegmentRef> pickPaintOrText(const PointerEvent &event);
    std::set<StrokeId> groupedWith(StrokeId stroke) const;
    void clickedBelow(const PointerEvent &event);
    void clickedStroke(const PointerEvent &event);
    /// Adds strokes to the selection, removes them from it, or replaces it, as the modifier keys say.
    void combine(std::set<StrokeId> found, GroupShare share, const PointerEvent &event);
    void selectNext(int step);
    void saySelected();
    void sayMoved(Point way);

    /// Whether a drag that begins there moves the selection.
    bool isMoving(const PointerEvent &event) const;
    void dragHandle(const PointerEvent &event);
    void dragSelection(const PointerEvent &event);
    void show(const Affine &map);
    /// Shows the numbers of a drag in the status bar.
    void say(const QString &text);
    void showTurn(std::optional<double> angle, Point pixel = {});

    Commands &m_commands;
    std::set<StrokeId> m_dragged; ///< what was selected when the drag began
    QPointer<TransformBar> m_options;
    mutable TransformHandles m_handles;
    mutable bool m_stale = true;  ///< whether the handles' box must be computed anew
    std::set<StrokeId> m_handled; ///< the strokes inside the handles' box
    std::optional<TransformHandle> m_hovered;
    QString m_said;

    std::optional<SegmentRef> m_hit;  ///< the stroke and segment that the press hit
    std::optional<PathTouch> m_touch; ///< what the path that is being drawn has touched
    bool m_selectedByPress = false;
    bool m_turnedByClick = false;            ///< whether the last click has changed the handles' mode
    std::optional<TransformHandle> m_handle; ///< the handle that is dragged
    Gesture m_gesture;
    Affine m_map;                   ///< the map of the drag so far
    std::optional<double> m_turned; ///< radians; it has a value while a drag turns strokes
    Point m_turnedAt;
    TransformSnap m_snap;
    TextLayout m_layout; ///< of texts under the pointer
};

} // namespace suffuse

// Decides which parts of what lies over the picture are painted again, and when.
#pragma once

#include "model/geometry/geometry.h"
#include "model/painting/ids.h"
#include "render/view.h"

#include <QRegion>
#include <QTimer>

#include <functional>
#include <map>
#include <optional>
#include <vector>

class QWidget;

namespace suffuse {

class CanvasView;
class Editor;
class Presenter;
class ShownSelection;
struct Change;

/// Has parts of the overlay painted again. While the selection is dragged, its parts wait for the next frame; where a
/// drag alters few strokes, only these are painted. Areas are in device pixels.
class OverlayRepaint : public QObject {
    Q_OBJECT

public:
    /// `margin` returns how far from the selected strokes' control points the tool draws, in device pixels. No value
    /// means that it may draw anywhere.
    OverlayRepaint(QWidget &canvas, Editor &editor, const CanvasView &view, const ShownSelection &selection,
                   std::function<std::optional<double>()> margin);

    /// Sets the presenter. To be called before anything is painted.
    void setPresenter(Presenter *presenter) { m_presenter = presenter; }

    /// Repaints the whole overlay.
    void all();
    /// Repaints the part of the overlay in an area.
    void part(const QRectF &area);
    void part(const QRegion &area);
    /// Repaints the tiles of a frame that differ from the frame before.
    void tiles(const std::vector<PixelRect> &dirty);
    /// Repaints what stands at the selected strokes, where they were and where they are.
    void selection();
    /// Does the same after a change of the document.
    void follow(const Change &change);
    /// Repaints now what would wait for a frame.
    void flush();
    /// Repaints what waits, since a frame has come with which it is painted.
    void flushWaiting();
    /// Ends the time in which few strokes are altered; all of the selection is painted again.
    void endDrag();
    /// To be called when all that was asked for is on the screen. `anywhere` says that the things at the selected
    /// strokes were painted elsewhere.
    void painted(bool anywhere);

private:
    /// The few strokes that a drag alters.
    struct Altered {
        std::map<StrokeId, Rect> boxes; ///< the strokes' boxes as they were last, canvas units
        double margin = 0;              ///< device pixels around the boxes
        QRegion area;                   ///< the area to be painted
    };

    bool isMoving() const;
    std::optional<QRegion> areaNow() const;
    bool altersFew(const Change &change);
    void flushLater();

    QWidget &m_canvas;
    Editor &m_editor;
    const CanvasView &m_view;
    const ShownSelection &m_selection;
    std::function<std::optional<double>()> m_margin;
    Presenter *m_presenter = nullptr;
    /// where the selection stands on the screen or is to be painted; no value: anywhere
    std::optional<QRegion> m_area;
    bool m_selectionChanged = false; ///< whether more of the selection is to be painted than what was altered
    bool m_all = false;              ///< whether the whole widget is about to be painted
    Altered m_altered;
    QTimer m_waits; ///< waits for a frame, with which the selection is painted
};

} // namespace suffuse

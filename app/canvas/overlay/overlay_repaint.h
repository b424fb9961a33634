// What lies over the picture and is to be painted again, and when.
#pragma once

#include "model/painting/geometry.h"
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

/// Has parts of the overlay painted again. Those of the selection wait for the next frame while it is dragged, and
/// where a drag alters few strokes, only these are painted. Areas are device pixels.
class OverlayRepaint : public QObject {
    Q_OBJECT

public:
    /// `margin`: device pixels around the selected strokes' control points that the tool keeps to; none: it may paint
    /// anywhere.
    OverlayRepaint(QWidget &canvas, Editor &editor, const CanvasView &view, const ShownSelection &selection,
                   std::function<std::optional<double>()> margin);

    /// Set before anything is painted.
    void setPresenter(Presenter *presenter) { m_presenter = presenter; }

    void all();
    void part(const QRectF &area);
    void part(const QRegion &area);
    /// Of a frame, those that differ from the one before.
    void tiles(const std::vector<PixelRect> &dirty);
    /// What stands at the selected strokes, then and now.
    void selection();
    /// The same, after a change of the document.
    void follow(const Change &change);
    /// What waits for a frame is painted now.
    void flush();
    /// A frame has come: what waits is painted with it.
    void flushWaiting();
    /// Few strokes are altered no more: all of the selection is painted again.
    void endDrag();
    /// All that was asked for is on the screen. `anywhere`: what stands at the selected strokes was painted elsewhere.
    void painted(bool anywhere);

private:
    /// Few strokes that a drag alters.
    struct Altered {
        std::map<StrokeId, Rect> boxes; ///< as they were last, canvas units
        double margin = 0;              ///< pixels around them
        QRegion area;                   ///< to be painted
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
    std::optional<QRegion> m_area;   ///< where the selection stands on the screen or is to be painted; none: anywhere
    bool m_selectionChanged = false; ///< more of it than what was altered is to be painted
    bool m_all = false;              ///< the whole widget is about to be painted
    Altered m_altered;
    QTimer m_waits; ///< for a frame, with which the selection is painted
};

} // namespace suffuse

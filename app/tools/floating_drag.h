#pragma once

#include "app/session/selecting/stroke_drag.h"
#include "model/shaping/transform.h"

#include <QObject>

namespace suffuse {

class CanvasWidget;
struct Change;

/// Strokes in a drag that maps them as a whole. Where its frames would be slow they float over the rest of the picture
/// (CanvasWidget::lift), and the document has the map only when the hand rests, a key is pressed, the view or the
/// moment changes, or the drag ends. Who reads it meanwhile finds what was pushed last.
class FloatingDrag : public QObject {
    Q_OBJECT

public:
    explicit FloatingDrag(CanvasWidget &canvas, QObject *parent = nullptr);

    /// A drag of the strokes may follow.
    void prepare(const std::set<StrokeId> &strokes);
    /// As StrokeDrag::begin.
    void begin(const std::set<StrokeId> &strokes, const QString &name) { m_drag.begin(strokes, name); }
    /// Shows the strokes under a map, from where they were at the press.
    void show(const Affine &map, SpreadRule rule);
    void giveUp();
    /// Also of what has only been prepared.
    void end();

    bool isActive() const { return m_drag.isActive(); }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void follow(const Change &change);
    void rest();
    void settle();
    void push();
    bool setPending(bool pending);

    CanvasWidget &m_canvas;
    StrokeDrag m_drag;
    Affine m_map; ///< that is shown
    SpreadRule m_rule = SpreadRule::Scales;
    Affine m_liftedAt;      ///< the map under which the strokes were lifted
    bool m_pending = false; ///< the document does not have it
    bool m_pushing = false;
};

} // namespace suffuse

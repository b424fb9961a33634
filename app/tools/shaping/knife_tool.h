#pragma once

#include "app/tools/canvas_tool.h"
#include "undo/node_edits.h"

#include <QPointer>

namespace suffuse {

/// Cuts strokes where a line crosses them: the selected strokes or, without a selection, all.
class KnifeTool : public CanvasTool {
    Q_OBJECT

public:
    explicit KnifeTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QWidget *options() override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_busy; }
    void cancel() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

private:
    void cut();
    void aim(const PointerEvent &event);
    PlacesOfStrokes cuts(bool *endsWithin = nullptr) const;

    bool m_busy = false;
    std::set<StrokeId> m_selected; ///< when the drag began: what a command selects meanwhile is not meant
    Point m_from, m_to;            ///< canvas units
    bool m_splits = false;
    QPointer<QWidget> m_options; ///< belongs to the row over the canvas
};

} // namespace suffuse

#pragma once

#include "app/tools/canvas_tool.h"
#include "model/brush/stroke_builder.h"
#include "model/shaping/nodes/redraw.h"

#include <QPointer>

#include <memory>

class QComboBox;

namespace suffuse {

/// Draws a part of a stroke anew: of a selected stroke or, without a selection, of the nearest. The part between the
/// ends of the drawn line follows the line, with the values that it had or with those of the brush in hand.
class RedrawTool : public CanvasTool {
    Q_OBJECT

public:
    explicit RedrawTool(CanvasWidget &canvas, QObject *parent = nullptr);
    ~RedrawTool() override;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return bool(m_builder); }
    void cancel() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    void setValues(RedrawValues values);

private:
    void add(const PointerEvent &event);
    /// The stroke that the line would redraw; 0 if there is none.
    StrokeId strokeUnder(const std::vector<Point> &line) const;
    double reach() const; ///< canvas units

    std::unique_ptr<StrokeBuilder> m_builder;
    std::vector<Point> m_line; ///< canvas units
    Microseconds m_lastTime = 0;
    RedrawValues m_values = RedrawValues::Kept;
    QPointer<QWidget> m_options;
    QPointer<QComboBox> m_choice; ///< one of the fields of the options
};

} // namespace suffuse

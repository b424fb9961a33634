#pragma once

#include "app/tools/canvas_tool.h"
#include "model/painting/style.h"

#include <optional>

class QPainter;

namespace suffuse {

/// The picture's colour at a point of the canvas: red, yellow and blue as they are mixed there, opacity 1.
std::optional<Colour> pictureColourAt(Editor &editor, Point point);
/// The own colour of the stroke that is seen there on top: that of the segment with the largest share.
std::optional<Colour> strokeColourAt(Editor &editor, Point point, double tolerance);

/// Picks while the pointer is down: the picture's colour, or with Shift the stroke's own, becomes the current colour.
class ColourPicker {
public:
    explicit ColourPicker(CanvasWidget &canvas);

    void begin(const PointerEvent &event);
    void move(const PointerEvent &event);
    void end();
    /// Gives the colour back that was the current one.
    void giveUp();
    bool isActive() const { return m_active; }
    /// A ring around the pointer: the picked colour above, the one before below.
    void paint(QPainter &painter, double dpr) const;

private:
    CanvasWidget &m_canvas;
    Editor &m_editor;
    bool m_active = false;
    Colour m_before;
    Point m_pixel;
};

/// Picks the current colour from the canvas.
class EyedropperTool : public CanvasTool {
    Q_OBJECT

public:
    explicit EyedropperTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    void press(const PointerEvent &event) override { m_picker.begin(event); }
    void move(const PointerEvent &event) override { m_picker.move(event); }
    void release(const PointerEvent &) override { m_picker.end(); }
    bool isBusy() const override { return m_picker.isActive(); }
    void cancel() override { m_picker.giveUp(); }
    void paint(QPainter &painter, const View &view, double dpr) const override;

private:
    ColourPicker m_picker;
};

} // namespace suffuse

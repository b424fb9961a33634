#pragma once

#include "app/tools/brush/match_picker.h"
#include "app/tools/canvas_tool.h"
#include "model/painting/style.h"

#include <QPointer>

#include <optional>

class QComboBox;
class QPainter;

namespace suffuse {

/// The picture's colour at a point of the canvas: red, yellow and blue as they are mixed there, opacity 1.
std::optional<Colour> pictureColourAt(Editor &editor, Point point);
/// The colour of the topmost stroke that is seen at a point: that of its segment with the largest share there.
std::optional<Colour> strokeColourAt(Editor &editor, Point point, double tolerance);

/// Picks while the pointer is down: the picture's colour or, with Shift, the stroke's own becomes the current colour.
class ColourPicker {
public:
    explicit ColourPicker(CanvasWidget &canvas);

    /// Begins to pick at a press.
    void begin(const PointerEvent &event);
    /// Picks at another place.
    void move(const PointerEvent &event);
    /// Ends picking; the picked colour stays the current one.
    void end();
    /// Makes the colour from before the press the current one again.
    void giveUp();
    bool isActive() const { return m_active; }
    /// Paints a ring around the pointer: the picked colour above, the one before it below.
    void paint(QPainter &painter, double dpr) const;

private:
    CanvasWidget &m_canvas;
    Editor &m_editor;
    bool m_active = false;
    Colour m_before;
    Point m_pixel;
};

/// Picks the current colour from the canvas, or matches the selection to a stroke.
class EyedropperTool : public CanvasTool {
    Q_OBJECT

public:
    explicit EyedropperTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_picker.isActive() || m_match.isActive(); }
    void cancel() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// Whether a click puts the appearance of the stroke on the selection, instead of taking its colour.
    void setMatches(bool matches);

private:
    ColourPicker m_picker;
    MatchPicker m_match;
    bool m_matches = false;
    QPointer<QWidget> m_options;
    QPointer<QComboBox> m_takes; ///< in the options
};

} // namespace suffuse

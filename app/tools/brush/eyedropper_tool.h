#pragma once

#include "app/session/value_entry.h"
#include "app/tools/brush/match_picker.h"
#include "app/tools/canvas_tool.h"
#include "model/painting/painting.h"

#include <QPointer>

#include <optional>

class QComboBox;
class QPainter;

namespace suffuse {

class Commands;

/// The picture's colour at a point of the canvas: red, yellow and blue as they are mixed there, opacity 1.
std::optional<Colour> pictureColourAt(const Painting &painting, Microseconds time, Point point);
/// The colour of the topmost stroke that is seen at a point: that of its segment with the largest share there.
std::optional<Colour> strokeColourAt(const Painting &painting, Microseconds time, Point point, double tolerance);

/// Picks while the pointer is down: the picture's colour or, with Shift, the stroke's own becomes the colour of the
/// brush or of what is selected (ColourTarget). It picks from the picture as it was at the press.
class ColourPicker {
public:
    explicit ColourPicker(CanvasWidget &canvas);

    /// Begins to pick at a press.
    void begin(const PointerEvent &event);
    /// Picks at another place.
    void move(const PointerEvent &event);
    /// Ends picking; the picked colour stays the current one.
    void end();
    /// Gives back the colours from before the press.
    void giveUp();
    bool isActive() const { return m_picture != nullptr; }
    /// Why nothing was picked where the pointer was last: beside the canvas, where no paint is shown. Else empty.
    QString refusal() const;
    /// Paints a ring around the pointer: the picked colour above, the one before it below.
    void paint(QPainter &painter, double dpr) const;

private:
    CanvasWidget &m_canvas;
    Editor &m_editor;
    PaintingPtr m_picture; ///< null: nothing is picked
    Colour m_before;
    Colour m_picked;
    ValueEntry m_entry;
    Point m_pixel;
    bool m_isOnly = false; ///< the picture is that of a layer
    bool m_isBeyond = false;
};

/// Picks a colour from the canvas, for the brush or for what is selected, or matches the selection to a stroke.
class EyedropperTool : public CanvasTool {
    Q_OBJECT

public:
    explicit EyedropperTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    ColourTarget::ToolUse colourUse() const override { return ColourTarget::ToolUse::Either; }
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_picker.isActive() || m_match.isActive(); }
    void cancel() override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// Takes the tool in hand to match the selection; once another tool is taken, a click takes colours again.
    void beginMatching(Commands &commands);
    /// Whether a click puts the appearance of the stroke on the selection, instead of taking its colour.
    void setMatches(bool matches);

private:
    QString colourUseText() const;
    void showTarget();

    ColourPicker m_picker;
    MatchPicker m_match;
    bool m_matches = false;
    bool m_untilNextTool = false; ///< It matches until another tool is taken.
    QPointer<QWidget> m_options;
    QPointer<QComboBox> m_takes; ///< in the options
};

} // namespace suffuse

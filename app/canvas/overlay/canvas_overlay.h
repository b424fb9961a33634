// What lies over the picture on a canvas, and when.
#pragma once

#include "app/canvas/overlay/canvas_note.h"
#include "app/canvas/overlay/erasure_lines.h"
#include "app/canvas/overlay/missing_pictures.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/selecting/snapping.h"

class QPalette;

namespace suffuse {

class CanvasHandles;
class CanvasInput;
class CanvasLift;
class CanvasView;
class Editor;
class ShownSelection;
class Tool;
struct RulerUnit;

/// Paints pasteboard, grid, assistants, handles, selection, erasures and rulers, and what the tool in use shows. It
/// keeps what people have chosen to see, and the colours of all that, which follow the palette.
class CanvasOverlay {
public:
    CanvasOverlay(Editor &editor, const CanvasView &view, CanvasInput &input, CanvasHandles &handles,
                  ShownSelection &selected, CanvasLift &lift);

    /// Covers what lies outside of the canvas; before `paint`.
    void paintAround(QPainter &painter, double dpr) const;
    /// Paints all that lies over the picture. The painter's unit is a device pixel.
    void paint(QPainter &painter, double dpr);

    /// Whether nothing of the selection or of the tool lies over the picture. It is so while the key for it is held,
    /// and while another state of the painting is shown.
    bool isBare() const;
    /// Whether lines are drawn through the selected strokes.
    bool showsOutlines() const;
    /// Whether erasures of all strokes are shown, by the command.
    bool showsErasures() const;
    /// Whether lines are drawn through the selection though the tool in use shows none. `reveal` returns true where
    /// that changes what is painted.
    bool isRevealed() const { return m_revealed; }
    bool reveal(bool revealed);

    /// Whether what is painted follows the strokes themselves, not only what is selected of them.
    bool followsPaint() const { return m_aids.showErasures || m_missing.any(); }
    /// Whether what is painted would be another at the moment T.
    bool changesUntil(Microseconds T) const { return m_aids.showErasures && !m_erasures.holds(T); }

    const CanvasAids &aids() const { return m_aids; }
    void setAids(const CanvasAids &aids) { m_aids = aids; }
    /// What the rulers count.
    RulerUnit rulerUnit() const;
    const OverlayColours &colours() const { return m_colours; }
    void readPalette(const QPalette &palette);
    /// What is written over the picture for a moment.
    CanvasNote &note() { return m_note; }

private:
    Tool *tool() const;
    void paintSelection(QPainter &painter, double dpr);
    void paintErasures(QPainter &painter, double dpr);
    void paintAngle(QPainter &painter, double dpr) const;

    Editor &m_editor;
    const CanvasView &m_view;
    CanvasInput &m_input;
    CanvasHandles &m_handles;
    ShownSelection &m_selected;
    CanvasLift &m_lift;
    OverlayColours m_colours;
    CanvasAids m_aids;
    ErasureLines m_erasures, m_selectedErasures; ///< of all strokes, and of those that are selected
    MissingPictures m_missing;
    CanvasNote m_note;
    bool m_revealed = false; ///< the selection, though the tool shows no outlines
};

} // namespace suffuse

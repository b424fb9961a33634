// The palette that opens where the hand is.
#pragma once

#include "app/widgets/habits/floating_card.h"
#include "model/brush/brush.h"

#include <functional>

class QLabel;

namespace suffuse {

class BrushGrid;
class CanvasWidget;
class ColourChips;
class ColourSwatch;
class Commands;
class Editor;
class SliderField;

/// Brushes with their pictures, the favourites first; colours near the one in hand, and those that were painted with
/// last; size, flow, opacity and zoom. What is chosen works at once, and the palette stays until Esc, Return or the
/// next press on the canvas. Colour and opacity are those that the Colour dock shows and changes: the brush's, or those
/// of what is selected.
class BrushPalette : public FloatingCard {
    Q_OBJECT

public:
    BrushPalette(CanvasWidget &canvas, const Commands &commands);

    /// The middle of the colours lies under the pointer, so that any part is as near as another.
    void openAt(QPoint global);

    BrushGrid *grid() const { return m_grid; }
    /// Says whose colour it is.
    QLabel *whose() const { return m_whose; }
    ColourChips *nearChips() const { return m_near; }
    ColourChips *recentChips() const { return m_recent; }
    SliderField *size() const { return m_size; }
    SliderField *opacity() const { return m_opacity; }
    SliderField *zoom() const { return m_zoom; }

private:
    QWidget *makeBrushes();
    QWidget *makeColours();
    QWidget *makeNumbers();
    void fillBrushes();
    void take(const QString &brush);
    void edit(const std::function<void(Brush &)> &change);
    void refresh();
    void refreshNear();

    CanvasWidget &m_canvas;
    Editor &m_editor;
    const Commands &m_commands;
    BrushGrid *m_grid = nullptr;
    QLabel *m_whose = nullptr;
    ColourSwatch *m_colour = nullptr;
    ColourChips *m_near = nullptr;
    ColourChips *m_recent = nullptr;
    SliderField *m_size = nullptr;
    SliderField *m_flow = nullptr;
    SliderField *m_opacity = nullptr;
    SliderField *m_zoom = nullptr;
    bool m_picking = false; ///< a near colour was picked: the others stay where they are
};

} // namespace suffuse

#pragma once

#include "app/canvas/input/pointer_event.h"
#include "model/painting/painting.h"
#include "model/painting/selection.h"

#include <QObject>

namespace suffuse {

class Editor;
class Hand;

/// Says on the canvas that tools reach one layer only, where a press did nothing and would have met paint of others.
class LayerNote : public QObject {
public:
    LayerNote(Editor &editor, Hand &hand, QObject *parent = nullptr);

    /// Canvas units around the pointer in which hairlines are found.
    void setTolerance(double tolerance) { m_tolerance = tolerance; }

private:
    void begin(const PointerEvent &event);
    void end();
    bool meets(const PaintingPtr &painting) const;

    Editor &m_editor;
    double m_tolerance = 0;
    PaintingPtr m_before; ///< at the press; null: nothing is pressed, or all is reached
    Selection m_selected;
    std::vector<Point> m_path; ///< of the pointer, canvas units
};

} // namespace suffuse

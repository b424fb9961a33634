#pragma once

#include "app/panels/inspected.h"
#include "app/panels/slider_field.h"

namespace suffuse {

class ColourRows;
class ColourSwatch;
class Editor;

/// D, φ, ω, t_max and colour of the selected segments.
class SegmentSection : public QWidget {
    Q_OBJECT

public:
    explicit SegmentSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    SliderField *diffusion() const { return m_diffusion; }
    SliderField *density() const { return m_density; }
    SliderField *granulation() const { return m_granulation; }
    SliderField *maxAge() const { return m_maxAge; }
    ColourRows *colour() const { return m_colour; }

signals:
    void refused(const QString &hint);

private:
    SliderField *addRow(const FieldSpec &spec, QGridLayout &grid, float Segment::*member, const QString &undoText);
    void changeColour(int channel, double value, EditRun run);
    void takeCurrentColour();

    Editor &m_editor;
    SliderField *m_diffusion = nullptr;
    SliderField *m_density = nullptr;
    SliderField *m_granulation = nullptr;
    SliderField *m_maxAge = nullptr;
    ColourSwatch *m_swatch = nullptr;
    ColourRows *m_colour = nullptr;
};

} // namespace suffuse

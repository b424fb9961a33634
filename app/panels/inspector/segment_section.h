#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/numbers/slider_field.h"
#include "model/painting/fields.h"

namespace suffuse {

class ColourRows;
class ColourSwatch;
class Editor;
class ErasureRows;
class RewetRows;

/// Shows and changes D, φ, ω, t_max, birth, anisotropy and colour of the selected segments.
class SegmentSection : public QWidget {
    Q_OBJECT

public:
    explicit SegmentSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    SliderField *diffusion() const { return m_diffusion; }
    SliderField *density() const { return m_density; }
    SliderField *granulation() const { return m_granulation; }
    SliderField *maxAge() const { return m_maxAge; }
    SliderField *born() const { return m_born; }             ///< birth of each stroke's first selected segment, seconds
    SliderField *anisotropy() const { return m_anisotropy; } ///< ratio
    SliderField *angle() const { return m_angle; }           ///< radians
    /// The row of a number of segments that does not belong to their colour.
    SliderField *row(float Segment::*member) const;
    ColourRows *colour() const { return m_colour; }
    RewetRows *rewet() const { return m_rewet; }
    ErasureRows *erasure() const { return m_erasure; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addBorn(QGridLayout &grid);
    void changeBorn(const ValueMap &map, ValueEntry *entry);
    void showBorn(const Inspected &inspected);
    void refuse();
    SliderField *addRow(const FieldSpec &spec, QGridLayout &grid, float Segment::*member, const QString &undoText);
    /// Changes each of the values by the map, or none if one of them has no result.
    void changeEach(const std::function<float &(Segment &)> &member, const ValueMap &map, const QString &undoText);
    /// Changes each of the values from what it was when the entry began.
    void changeTogether(const Number<Segment> &number, const ValueChange &change, const QString &undoText,
                        ValueEntry *entry);
    void changeBornTogether(const ValueChange &change, ValueEntry *entry);
    void changeColour(int channel, double value, ValueEntry *entry);
    void takeCurrentColour();
    void nameForErasure(bool erasure);

    Editor &m_editor;
    /// one for each number that does not belong to the colour
    std::vector<std::pair<float Segment::*, SliderField *>> m_rows;
    SliderField *m_diffusion = nullptr;
    SliderField *m_density = nullptr;
    SliderField *m_granulation = nullptr;
    SliderField *m_maxAge = nullptr;
    SliderField *m_born = nullptr;
    SliderField *m_anisotropy = nullptr;
    SliderField *m_angle = nullptr;
    ErasureRows *m_erasure = nullptr;
    RewetRows *m_rewet = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_colourTitle = nullptr;
    ColourSwatch *m_swatch = nullptr;
    ColourRows *m_colour = nullptr;
    bool m_namesErasure = false; ///< the rows have the names that they have for erasures
};

} // namespace suffuse

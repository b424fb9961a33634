#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/panels/inspector/rows/combo_row.h"
#include "app/widgets/numbers/slider_field.h"
#include "undo/edits.h"

#include <QObject>

class QGridLayout;

namespace suffuse {

class Editor;

/// What an erasure is: whether it fades or lifts, how large the eraser was, and its strength, the share of the paint
/// that a fading one takes, or the density that others do. They are rows of a grid, and shown where all that is
/// inspected takes paint away.
class ErasureRows : public QObject {
    Q_OBJECT

public:
    ErasureRows(Editor &editor, QGridLayout &grid, QWidget *parent);

    void refresh(const Inspected &inspected);

    QComboBox *kind() const { return m_kind.box; }
    SliderField *size() const { return m_size; }
    SliderField *share() const { return m_share; } ///< where all of it fades
    SliderField *taken() const { return m_taken; } ///< where some of it lifts: the peak of the density

signals:
    void refused(const QString &hint);

private:
    /// Makes an edit by which each of the numbers becomes what the map gives; they are counted from a painting.
    using Setter = Edit (ErasureRows::*)(const Painting &from, const ValueMap &map);
    SliderField *addRow(const FieldSpec &spec, QGridLayout &grid, Setter set, const QString &undoText, QWidget *parent);
    void setFade(bool fade);
    Edit setSizes(const Painting &from, const ValueMap &map);
    Edit setShares(const Painting &from, const ValueMap &map);
    Edit setTaken(const Painting &from, const ValueMap &map);

    Editor &m_editor;
    ComboRow m_kind;
    SliderField *m_size = nullptr;
    SliderField *m_share = nullptr;
    SliderField *m_taken = nullptr;
};

} // namespace suffuse

#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/numbers/slider_field.h"

class QComboBox;

namespace suffuse {

class Editor;

/// Shows and changes name, mixing and β of the selected strokes.
class StrokeSection : public QWidget {
    Q_OBJECT

public:
    explicit StrokeSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    EntryField *name() const { return m_name; }
    QComboBox *mode() const { return m_mode; }
    SliderField *beta() const { return m_beta; }
    /// Says that mixing is not seen, since all that is selected lies in washes.
    QLabel *washNote() const { return m_washNote; }

    /// The mixing with which a mode begins.
    static Mix usualMix(MixMode mode);

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addName(QGridLayout &grid);
    void addMixing(QGridLayout &grid);
    void chooseMode(MixMode mode);

    Editor &m_editor;
    EntryField *m_name = nullptr;
    QComboBox *m_mode = nullptr;
    SliderField *m_beta = nullptr;
    QLabel *m_washNote = nullptr;
};

} // namespace suffuse

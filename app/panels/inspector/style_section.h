#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/panels/inspector/rows/xi_fields.h"

#include <functional>

class QComboBox;

namespace suffuse {

class Editor;

/// Shows and changes the style of the selected segments, with its ξ. A segment may have a style of its own, or that of
/// its stroke. A change goes where each segment's style is kept: into the segment or into the stroke.
class StyleSection : public QWidget {
    Q_OBJECT

public:
    explicit StyleSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    QComboBox *source() const { return m_source; }
    QComboBox *kind() const { return m_kind; }
    SliderField *xi(int index) const { return m_xi[std::size_t(index)]; }
    /// Says that none of this is seen, since all that is selected lies in washes.
    QLabel *washNote() const { return m_washNote; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addCombos(QGridLayout &grid);
    void connectXi();
    void chooseSource(bool own);
    void changeStyles(const std::function<void(Style &)> &change, const QString &text, ValueEntry *entry);
    /// Changes ξ `index` of each style from what it was when the entry began.
    void changeXiTogether(int index, const ValueChange &change, ValueEntry *entry);

    Editor &m_editor;
    QLabel *m_washNote = nullptr;
    QComboBox *m_source = nullptr;
    QComboBox *m_kind = nullptr;
    XiFields m_xi;
};

} // namespace suffuse

// The rows of a section that are about the washes among the selected groups.
#pragma once

#include "app/panels/inspector/rows/combo_row.h"
#include "app/panels/inspector/rows/xi_fields.h"
#include "model/painting/painting.h"

#include <functional>

namespace suffuse {

class Editor;

/// Shows and changes style and mixing of the washes among the groups that are selected as a whole. The rows are there
/// only while there is one.
class WashRows : public QObject {
    Q_OBJECT

public:
    /// Adds its rows to a grid of fields, behind those that are there.
    WashRows(Editor &editor, QGridLayout &grid, QWidget *parent);

    void refresh(const std::vector<const Group *> &groups);

    QComboBox *kind() const { return m_kind.box; }
    SliderField *xi(int index) const { return m_xi[std::size_t(index)]; }
    QComboBox *mode() const { return m_mode.box; }
    SliderField *beta() const { return m_beta; }

signals:
    /// Emitted when a value is none for all of the washes; says why.
    void refused(const QString &hint);

private:
    using Change = std::function<void(Wash &now, const Wash &then)>;
    /// A number of a wash; null if this one has none.
    using Member = std::function<float *(Wash &)>;

    void addNumber(SliderField &field, const Member &member);
    void keepChange(SliderField &field, const std::vector<const Group *> &groups, const Member &member);
    /// `before` is where `then` is counted from.
    void change(const Painting &before, const Change &change, ValueEntry *entry = nullptr);

    Editor &m_editor;
    ComboRow m_kind, m_mode;
    XiFields m_xi;
    SliderField *m_beta = nullptr;
};

} // namespace suffuse

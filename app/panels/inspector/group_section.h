#pragma once

#include "app/panels/inspector/rows/combo_row.h"
#include "app/panels/inspector/rows/wash_rows.h"
#include "undo/layers/group_roles.h"

#include <array>

class QCheckBox;
class QComboBox;
class QLabel;

namespace suffuse {

class Editor;

/// Shows and changes how the groups that are selected as a whole are put on what lies below (opacity, mode, whether
/// they mix by themselves, are clipped, or are masks), whether each is a wash, and the colour that marks them. The
/// section is there only while nothing but whole groups is selected.
class GroupSection : public QWidget {
    Q_OBJECT

public:
    explicit GroupSection(Editor &editor, QWidget *parent = nullptr);

    void refresh();

    SliderField *opacity() const { return m_opacity; }
    QComboBox *mode() const { return m_mode.box; }
    QCheckBox *isolated() const { return m_isolated; }
    QCheckBox *roleSwitch(GroupRole role) const { return m_roles[std::size_t(role)]; }
    QComboBox *tag() const { return m_tag.box; }
    WashRows *wash() const { return m_wash; }
    QLabel *title() const { return m_title; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addOpacity(QGridLayout &grid);
    void addMode(QGridLayout &grid);
    void addIsolated(QGridLayout &grid);
    void addRole(QGridLayout &grid, GroupRole role);
    void addTag(QGridLayout &grid);
    void isolate(bool on);
    void showMode(const std::vector<const Group *> &groups);
    void showIsolated(const std::vector<const Group *> &groups);
    void showRole(GroupRole role, const GroupRoles::State &state);
    void keepChange(const std::vector<const Group *> &groups);

    Editor &m_editor;
    QLabel *m_title = nullptr;
    SliderField *m_opacity = nullptr;
    ComboRow m_mode;
    QCheckBox *m_isolated = nullptr;
    std::array<QCheckBox *, groupRoles.size()> m_roles{}; ///< by GroupRole
    ComboRow m_tag;
    WashRows *m_wash = nullptr;
};

} // namespace suffuse

#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/painting.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace suffuse {

class Editor;

/// Shows and changes how the groups that are selected as a whole are put on what lies below: opacity, mode, and whether
/// they mix by themselves. The section is there only while nothing but whole groups is selected.
class GroupSection : public QWidget {
    Q_OBJECT

public:
    explicit GroupSection(Editor &editor, QWidget *parent = nullptr);

    void refresh();

    SliderField *opacity() const { return m_opacity; }
    QComboBox *mode() const { return m_mode; }
    QCheckBox *isolated() const { return m_isolated; }
    QLabel *title() const { return m_title; }

signals:
    /// Emitted when a text that was typed is no value; says why.
    void refused(const QString &hint);

private:
    void addOpacity(QGridLayout &grid);
    void addMode(QGridLayout &grid);
    void addIsolated(QGridLayout &grid);
    void isolate(bool on);
    void showMode(const std::vector<const Group *> &groups);
    void showIsolated(const std::vector<const Group *> &groups);
    void keepChange(const std::vector<const Group *> &groups);

    Editor &m_editor;
    QLabel *m_title = nullptr;
    SliderField *m_opacity = nullptr;
    QComboBox *m_mode = nullptr;
    QCheckBox *m_isolated = nullptr;
};

} // namespace suffuse

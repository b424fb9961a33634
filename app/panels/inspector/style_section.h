#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/numbers/slider_field.h"

#include <array>
#include <functional>

class QComboBox;

namespace suffuse {

class Editor;

/// Style of the selected segments (the stroke's or their own) with its ξ.
/// A change goes to where each segment's style lives: to the segment where it has its own, else to its stroke.
class StyleSection : public QWidget {
    Q_OBJECT

public:
    explicit StyleSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    QComboBox *source() const { return m_source; }
    QComboBox *kind() const { return m_kind; }
    SliderField *xi(int index) const { return m_xi[std::size_t(index)]; }

    /// A style of that kind to begin with.
    static Style defaultStyle(StyleKind kind);

signals:
    void refused(const QString &hint);

private:
    void addCombos(QGridLayout &grid);
    void addXiRows(QGridLayout &grid);
    void chooseSource(bool own);
    void changeStyles(const std::function<void(Style &)> &change, const QString &text, ValueEntry *entry);
    void refreshXi(const Inspected &inspected, std::optional<StyleKind> kind);
    void nameXi(StyleKind kind);
    void limitXi(const Inspected &inspected, StyleKind kind);

    Editor &m_editor;
    QComboBox *m_source = nullptr;
    QComboBox *m_kind = nullptr;
    std::array<SliderField *, 3> m_xi{};
};

} // namespace suffuse

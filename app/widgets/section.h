// The small parts that all panels are put together from, so that they look alike.
#pragma once

#include <QLabel>

class QGridLayout;
class QVBoxLayout;

namespace suffuse {

/// A section's heading.
QLabel *sectionTitle(const QString &text, QWidget *parent);

/// Three columns: label, slider, number; appended to the column.
QGridLayout *addFieldGrid(QVBoxLayout &column);

/// A line of text that wraps, in the palette's quieter colour.
QLabel *quietLabel(const QString &text, QWidget *parent);
/// For what changes with every frame: the label grows where it has to, and otherwise nothing is laid out anew.
void showInPlace(QLabel &label, const QString &text);

/// A line that appears while something typed was refused, in the warning colour.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    explicit HintLabel(QWidget *parent = nullptr);

    /// Empty: hides it.
    void showHint(const QString &hint);

protected:
    void changeEvent(QEvent *event) override;

private:
    void takeColour();
    bool m_takingColour = false;
};

/// Gives the first columns of all field grids below `parent` one width.
void alignFieldLabels(QWidget &parent);

} // namespace suffuse

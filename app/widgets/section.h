// The small parts that all panels are put together from, so that they look alike.
#pragma once

#include <QLabel>
#include <QScrollArea>

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

/// A line in the warning colour, there as long as it says something.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    explicit HintLabel(QWidget *parent = nullptr);

    /// Empty: hides it.
    void showHint(const QString &hint);
    /// Why something typed was refused: goes by itself when people go on to another place.
    void showRefusal(const QString &hint);

protected:
    void changeEvent(QEvent *event) override;

private:
    void takeColour();
    bool m_takingColour = false;
    bool m_passing = false; ///< goes with the next change of the focus
};

/// Scrolls what a panel holds up and down, and is never narrower than that needs.
class PanelScroll : public QScrollArea {
public:
    explicit PanelScroll(QWidget *parent = nullptr);
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

/// Gives the first columns of all field grids below `parent` one width.
void alignFieldLabels(QWidget &parent);

} // namespace suffuse

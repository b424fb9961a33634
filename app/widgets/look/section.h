// The small parts of which all panels are made, so that they look alike.
#pragma once

#include <QLabel>
#include <QScrollArea>

class QGridLayout;
class QVBoxLayout;

namespace suffuse {

/// Makes the heading of a section.
QLabel *sectionTitle(const QString &text, QWidget *parent);

/// Appends a grid of three columns to the column: label, slider, number.
QGridLayout *addFieldGrid(QVBoxLayout &column);

/// Makes a text that wraps, in the palette's quieter colour.
QLabel *quietLabel(const QString &text, QWidget *parent);
/// Shows a text that changes with every frame. The label grows where it has to; otherwise nothing is laid out anew.
void showInPlace(QLabel &label, const QString &text);

/// Scrolls the panels around the widget, so that it is seen once all has its new place. For fields whose number was
/// refused: the hint that says why may take their room.
void keepInSight(QWidget &widget);

/// A line in the warning colour. It is there only while it says something.
class HintLabel : public QLabel {
    Q_OBJECT

public:
    explicit HintLabel(QWidget *parent = nullptr);

    /// Says something; an empty text hides the line.
    void showHint(const QString &hint);
    /// Says why something typed was refused, and scrolls to it in a low panel. The text disappears by itself when the
    /// user goes on to another place.
    void showRefusal(const QString &hint);

private:
    bool m_passing = false; ///< the text disappears with the next change of the focus
};

/// Scrolls the contents of a panel up and down, and is never narrower than they need.
class PanelScroll : public QScrollArea {
public:
    explicit PanelScroll(QWidget *parent = nullptr);
    QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

/// Gives the first columns of all field grids below `parent` the same width.
void alignFieldLabels(QWidget &parent);

} // namespace suffuse

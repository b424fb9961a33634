// The brush in hand in a row of fields, with all others to choose from.
#pragma once

#include <QComboBox>
#include <QPointer>

class QFrame;
class QLineEdit;

namespace suffuse {

class BrushGrid;

/// A combo box of brushes: it shows the picture and the name of one, and drops down all of them as pictures in their
/// groups, with a field to search. The items' data are the brushes' names. Arrow keys step from brush to brush while it
/// is closed; `activated` tells of a choice, as of any combo box.
class BrushCombo : public QComboBox {
    Q_OBJECT

public:
    explicit BrushCombo(QWidget *parent = nullptr);

    /// The brushes of the library as they are now.
    void fill();
    void showPopup() override;
    void hidePopup() override;
    /// What is dropped down; null while it is closed.
    BrushGrid *grid() const;
    QLineEdit *search() const { return m_search; }

    QSize sizeHint() const override;
    /// With room for the picture and the beginning of a name: in a narrow row the name gives way.
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QSize sizeFor(int name) const;
    void makePopup();
    void choose(const QString &name);
    void placePopup();
    void filter();

    QPointer<QFrame> m_popup;
    QPointer<BrushGrid> m_grid;
    QPointer<QLineEdit> m_search;
    bool m_started = false;
};

} // namespace suffuse

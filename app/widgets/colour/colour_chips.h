// Rows of colours to take one from.
#pragma once

#include "model/painting/style.h"

#include <QWidget>

#include <vector>

namespace suffuse {

/// Colours in rows of a given length, none of which can be changed. Keys: arrows go from one to the other, Return and
/// Space take it.
class ColourChips : public QWidget {
    Q_OBJECT

public:
    explicit ColourChips(int columns, QWidget *parent = nullptr);

    void setColours(std::vector<Colour> colours);
    /// Colours that are not opaque are shown over checks, too, in one half.
    void showOpacity() { m_showsOpacity = true; }
    const std::vector<Colour> &colours() const { return m_colours; }
    /// The one that Return takes; from the first on.
    int current() const { return m_current; }
    QRect cell(int index) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void picked(const suffuse::Colour &colour);

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;

private:
    int indexAt(QPoint at) const; ///< −1: none
    int rows() const;
    void setCurrent(int index);

    int m_columns;
    std::vector<Colour> m_colours;
    int m_current = 0;
    int m_pressed = -1;
    bool m_showsOpacity = false;
};

/// Colours around one, in rows of seven that go through it: from lighter to darker, from one neighbouring hue to the
/// other, and from grey to full. Their opacity is that of the colour.
std::vector<Colour> nearColours(const Colour &colour);

} // namespace suffuse

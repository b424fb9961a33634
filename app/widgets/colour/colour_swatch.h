#pragma once

#include "model/painting/style.h"

#include <QAbstractButton>

#include <optional>

class QPainterPath;

namespace suffuse {

/// Fills a shape with a colour. If the colour is not opaque, the right half shows how much it lets through.
void paintColour(QPainter &painter, const QPainterPath &shape, const Colour &colour);

/// A button that is filled with a colour, over a checked ground where it is not opaque, and shows "—" where colours are
/// mixed. The colour can be dragged to any place that takes colours.
class ColourSwatch : public QAbstractButton {
    Q_OBJECT

public:
    explicit ColourSwatch(QWidget *parent = nullptr);

    void setColour(std::optional<Colour> colour);
    /// A second one, which has the lower right half: the first is one of several.
    void setOther(std::optional<Colour> other);
    const std::optional<Colour> &other() const { return m_other; }
    const std::optional<Colour> &colour() const { return m_colour; }
    void setSide(int pixels);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    std::optional<Colour> m_colour;
    std::optional<Colour> m_other;
    int m_side = 24;
    QPoint m_pressed;
};

} // namespace suffuse

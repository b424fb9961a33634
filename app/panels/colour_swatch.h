#pragma once

#include "model/style.h"

#include <QAbstractButton>

#include <optional>

namespace suffuse {

/// A button filled with a colour, over a checked ground where it is not opaque; "—" where colours are mixed.
class ColourSwatch : public QAbstractButton {
    Q_OBJECT

public:
    explicit ColourSwatch(QWidget *parent = nullptr);

    void setColour(std::optional<Colour> colour);
    const std::optional<Colour> &colour() const { return m_colour; }
    void setSide(int pixels);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::optional<Colour> m_colour;
    int m_side = 24;
};

} // namespace suffuse

#pragma once

#include "app/session/value_entry.h"
#include "model/colour/hue_shares.h"

#include <QImage>
#include <QWidget>

namespace suffuse {

/// A ring of the RYB hues around a triangle from the pure hue to white and black.
/// Keys: left and right turn the hue, up and down lighten and darken. Esc gives a drag up.
class ColourWheel : public QWidget {
    Q_OBJECT

public:
    explicit ColourWheel(QWidget *parent = nullptr);

    /// Shows a colour, and emits nothing. For a grey the ring keeps its hue. The opacity is kept for `colour()`. One of
    /// several has no marks: keys go on from it, and what is picked is that of all.
    void setColour(const Colour &colour, bool isOneOfSeveral = false);
    Colour colour() const { return fromShares(m_shares, m_opacity); }

    /// Where a hue lies on the ring, and a mixture in the triangle, in pixels of the widget.
    QPointF ringPoint(double hue) const;
    QPointF trianglePoint(double chroma, double black) const;

    QSize sizeHint() const override;
    int heightForWidth(int width) const override;
    QSize minimumSizeHint() const override;

signals:
    /// To be pushed with the entry: a drag is one gesture, and quick steps by keys are one step.
    void picked(const suffuse::Colour &colour, suffuse::ValueEntry *entry);
    /// The mouse was let go after picking, or the drag was given up.
    void finished();

protected:
    /// During a drag it filters the events of the whole program, since the keyboard may be elsewhere.
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    enum class Part { None, Ring, Triangle };
    QPointF centre() const;
    double outerRadius() const;
    double innerRadius() const;
    void pick(QPointF at);
    void pickInTriangle(QPointF at);
    void giveUp();
    ValueEntry *entryOfStep();
    void paintFocus(QPainter &painter);
    void paintRing(QPainter &painter);
    void paintTriangle(QPainter &painter);

    HueShares m_shares{0, 1, 0};
    float m_opacity = 1;
    bool m_isOneOfSeveral = false;
    Part m_part = Part::None;
    HueShares m_pressed; ///< what was shown when the drag began
    ValueEntry m_entry;
    QImage m_triangle;
    double m_triangleHue = -1;
};

} // namespace suffuse

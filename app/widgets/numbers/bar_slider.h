#pragma once

#include <QSlider>

#include <functional>

namespace suffuse {

/// A slim horizontal slider. A press on the handle takes hold of it where it is; one elsewhere jumps there and drags on, but
/// where values are mixed it takes hold of the handle from there, so that a touch changes nothing. The bar is filled up to
/// the handle or shows a gradient. Positions are 0 … steps. Esc gives a drag up.
class BarSlider : public QSlider {
    Q_OBJECT

public:
    static constexpr int steps = 1000;

    explicit BarSlider(QWidget *parent = nullptr);

    /// Sets the colour along the bar at positions 0 … 1; null: a plain bar.
    void setGradient(std::function<QColor(double)> gradient);
    /// The values are mixed: the handle stands for a change of all of them, which begins in the middle.
    void setMixed(bool mixed);
    bool isMixed() const { return m_mixed; }
    /// Ctrl was held at the press: mixed values are to become one, that of the place under the pointer.
    bool makesOne() const { return m_makesOne; }

    /// Ends a drag as the release would; the pointer moves nothing more then.
    void letGo();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void givenUp(); ///< by Esc or Undo; emitted before sliderReleased

protected:
    /// During a drag it filters the events of the whole program, since the keyboard may be elsewhere.
    bool eventFilter(QObject *watched, QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    int positionAt(double x) const;
    QRectF track() const;

    std::function<QColor(double)> m_gradient;
    bool m_mixed = false;
    bool m_makesOne = false;
    double m_grip = 0; ///< how far right of the handle's middle the pointer holds it, logical pixels
};

} // namespace suffuse

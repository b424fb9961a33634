#pragma once

#include <QImage>
#include <QTransform>
#include <QWidget>

#include <functional>
#include <optional>

namespace suffuse {

/// Shows a picture that one looks at while painting. The wheel zooms at the pointer, a drag moves the picture. Where
/// one picks, a press and its moves pick the colour under the pointer instead. By the keyboard, arrow keys move a cross
/// and Return picks there; + and − zoom, 0 shows the whole picture.
class ReferenceView : public QWidget {
    Q_OBJECT

public:
    explicit ReferenceView(QWidget *parent = nullptr);

    /// A null picture: none.
    void setPicture(const QImage &picture);
    const QImage &picture() const { return m_picture; }
    /// Asked at each press: whether it picks. Ctrl and Alt pick in any case.
    void setPicks(std::function<bool()> picks) { m_picks = std::move(picks); }

    /// Shows all of the picture, also after the widget changes its size.
    void fit();
    /// Zooms by a factor; the pixel of the picture at a place of the widget stays there.
    void zoomBy(double factor, QPointF at);
    /// Logical pixels of the widget for each pixel of the picture.
    double scale() const { return m_scale; }
    /// From the picture's pixels to the widget's.
    QTransform toWidget() const;
    /// The colour of the picture at a place of the widget; no value beside it, and where it is clear.
    std::optional<QColor> colourAt(QPointF at) const;

    QSize sizeHint() const override { return {280, 240}; }

signals:
    void picked(const QColor &colour);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void enterEvent(QEnterEvent *event) override;

private:
    enum class Held { Nothing, Picture, Colour };
    bool picksWith(Qt::KeyboardModifiers modifiers) const;
    void pickAt(QPointF at);
    void moveCross(QPointF by);

    QImage m_picture;
    std::function<bool()> m_picks;
    double m_scale = 1;
    QPointF m_middle; ///< the pixel of the picture in the middle of the widget
    bool m_isFitted = true;
    Held m_held = Held::Nothing;
    QPointF m_last;
    std::optional<QPointF> m_cross; ///< of the keyboard, pixels of the widget
};

} // namespace suffuse

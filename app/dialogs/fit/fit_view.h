#pragma once

#include <QImage>
#include <QWidget>

namespace suffuse {

/// Shows the picture that strokes make, as large as it fits, and in its place the original while a mouse button is
/// held on it or somebody asks for that.
class FitView : public QWidget {
    Q_OBJECT

public:
    explicit FitView(QWidget *parent);

    /// Both may be null: nothing is there to be seen.
    void show(const QImage &picture, const QImage &original);
    void showOriginal(bool shown);
    /// What is seen at the moment.
    const QImage &shown() const { return (m_original || m_held) && !m_images[1].isNull() ? m_images[1] : m_images[0]; }

    QSize sizeHint() const override { return {560, 420}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;

private:
    void hold(bool held);

    QImage m_images[2]; ///< of the strokes, and the original
    bool m_original = false, m_held = false;
};

} // namespace suffuse

#pragma once

#include <QWidget>

#include <vector>

namespace suffuse {

/// The density φ at a place over document time, with the moment shown and the density from which a stroke is seen.
class AgePlot : public QWidget {
    Q_OBJECT

public:
    explicit AgePlot(QWidget *parent = nullptr);

    /// `points`: seconds since the stroke began, φ; empty: nothing to plot. `now` in the same seconds.
    void show(std::vector<QPointF> points, double now, double cut);
    using QWidget::show;
    const std::vector<QPointF> &points() const { return m_points; }

    QSize sizeHint() const override { return {200, 96}; }
    QSize minimumSizeHint() const override { return {120, 96}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::vector<QPointF> m_points;
    double m_now = 0;
    double m_cut = 0;
};

} // namespace suffuse

#pragma once

#include <QWidget>

#include <vector>

namespace suffuse {

/// Plots the density φ at a place over document time, with the moment that is shown and the density from which on a
/// stroke is seen.
class AgePlot : public QWidget {
    Q_OBJECT

public:
    explicit AgePlot(QWidget *parent = nullptr);

    /// `points` are pairs of the seconds since the stroke began and φ; if there are none, nothing is plotted. `now`
    /// counts the same seconds.
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

#pragma once

#include "app/widgets/curves/cross_section.h"

#include <QWidget>

namespace suffuse {

/// Shows the cut through a stroke: how strongly it covers across its width, in the colours that it has on the
/// background.
class CrossSectionPlot : public QWidget {
    Q_OBJECT

public:
    static constexpr int samples = 121;

    explicit CrossSectionPlot(QWidget *parent = nullptr);

    void show(std::vector<CrossSectionPoint> points);
    using QWidget::show;
    const std::vector<CrossSectionPoint> &points() const { return m_points; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::vector<CrossSectionPoint> m_points;
};

} // namespace suffuse

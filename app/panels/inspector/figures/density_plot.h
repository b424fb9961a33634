#pragma once

#include "model/painting/style.h"

#include <QWidget>

#include <optional>

namespace suffuse {

/// Shows the curve of F over the density φ′, and marks the peak densities of the selected segments.
class DensityPlot : public QWidget {
    Q_OBJECT

public:
    explicit DensityPlot(QWidget *parent = nullptr);

    /// Shows the style of the first selected segment, and the lowest and highest peak of all; `several` tells that
    /// other styles are selected, too.
    void show(const Style &style, double lowestPeak, double highestPeak, bool several);
    using QWidget::show;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    double horizontalRange() const;

    std::optional<Style> m_style;
    double m_lowestPeak = 0;
    double m_highestPeak = 0;
    bool m_several = false;
};

} // namespace suffuse

#pragma once

#include "app/panels/inspector/figures/figures_summary.h"

#include <QTimer>
#include <QWidget>

#include <array>

class QLabel;
class QVBoxLayout;

namespace suffuse {

class CrossSectionPlot;
class DensityPlot;
class Editor;
class HintLabel;

/// Shows what follows from the selected segments' values: the density function, the cut through the stroke, derived
/// figures, and warnings where values defeat their purpose.
class FiguresSection : public QWidget {
    Q_OBJECT

public:
    explicit FiguresSection(Editor &editor, QWidget *parent = nullptr);

    void refresh(const Inspected &inspected);

    DensityPlot *densityPlot() const { return m_plot; }
    CrossSectionPlot *crossSection() const { return m_cut; }
    HintLabel *warnings() const { return m_warnings; }
    /// What stands here instead of all that where only fills are seen.
    QLabel *fillAlone() const { return m_fillAlone; }
    /// The labels of spread, spread along, peak, half-width and fading, in this order, and, where all that is selected
    /// takes paint away, instead of them those of its spread and of what it takes. The second is shown only where
    /// spread is uneven.
    QLabel *figure(int index) const { return m_figures[std::size_t(index)]; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    static constexpr int figureCount = 7, firstOfErasures = 5;
    void addFigures(QVBoxLayout &column);
    void showFigures();
    void refreshCutSoon();
    void refreshCut();

    Editor &m_editor;
    FiguresKeeper m_keeper;
    FiguresSummary m_shown;
    SegmentRef m_cutAt; ///< the segment at which the stroke is cut
    QTimer m_later;     ///< The cut takes longer than the rest, so the picture is drawn first.
    DensityPlot *m_plot = nullptr;
    CrossSectionPlot *m_cut = nullptr;
    HintLabel *m_warnings = nullptr;
    QLabel *m_fillAlone = nullptr;
    std::array<QLabel *, figureCount> m_figures{};
    std::array<QLabel *, figureCount> m_names{};
};

} // namespace suffuse

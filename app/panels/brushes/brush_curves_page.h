#pragma once

#include "app/panels/brushes/brush_page.h"

class QTableWidget;
class QTableWidgetItem;

namespace suffuse {

class ResponseEditor;

/// Says which input of the pen changes which number of the brush: a table of switches, and the curve of the current
/// one.
class BrushCurvesPage : public BrushPage {
    Q_OBJECT

public:
    explicit BrushCurvesPage(QWidget *parent);
    void showBrush(const Brush &brush) override;
    QTableWidget *curves() const { return m_curves; }
    ResponseEditor *curve() const { return m_curve; }

private:
    void makeTable();
    void cellChanged(QTableWidgetItem *item);
    void showCell();

    Brush m_brush; ///< the brush that is shown
    QTableWidget *m_curves = nullptr;
    ResponseEditor *m_curve = nullptr;
};

} // namespace suffuse

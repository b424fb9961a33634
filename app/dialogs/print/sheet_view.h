#pragma once

#include "app/dialogs/print/page_plan.h"

#include <QImage>
#include <QWidget>

namespace suffuse {

/// Shows a sheet of paper with its margins, and what will be printed on it.
class SheetView : public QWidget {
    Q_OBJECT

public:
    explicit SheetView(QWidget *parent = nullptr);

    void showPlan(const PagePlan &plan);
    /// The picture of the whole sheet; it is stretched where the sheet is shown larger or smaller.
    void showSheet(const QImage &sheet);
    const QImage &sheet() const { return m_sheet; }
    /// Where the paper lies, in logical pixels.
    QRectF paperRect() const;
    /// As fine as the screen shows the sheet, dots an inch of paper.
    double dpi() const;
    QSize sizeHint() const override { return {300, 380}; }
    QSize minimumSizeHint() const override { return {150, 200}; }

signals:
    void resized();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    PagePlan m_plan;
    QImage m_sheet;
};

} // namespace suffuse

#include "app/dialogs/print/sheet_view.h"

#include "app/widgets/look/theme.h"
#include "model/painting/resolution.h"

#include <QPainter>

namespace suffuse {

namespace {

constexpr double aroundSheet = 8; ///< logical pixels between the paper and the edge

} // namespace

SheetView::SheetView(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
}

void SheetView::showPlan(const PagePlan &plan)
{
    if (plan.paper != m_plan.paper)
        m_sheet = {}; // A picture of other paper would be out of shape.
    m_plan = plan;
    update();
}

void SheetView::showSheet(const QImage &sheet)
{
    m_sheet = sheet;
    update();
}

QRectF SheetView::paperRect() const
{
    if (m_plan.paper.isEmpty())
        return {};
    const QRectF room = QRectF(rect()).adjusted(aroundSheet, aroundSheet, -aroundSheet, -aroundSheet);
    QRectF paper(QPointF(), m_plan.paper.scaled(room.size(), Qt::KeepAspectRatio));
    paper.moveCenter(room.center());
    return paper;
}

double SheetView::dpi() const
{
    return m_plan.paper.isEmpty() ? 0 : paperRect().width() * devicePixelRatioF() / m_plan.paper.width() * millimetresOfInch;
}

void SheetView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    emit resized();
}

void SheetView::paintEvent(QPaintEvent *)
{
    const QRectF paper = paperRect();
    if (paper.isEmpty())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(paper, Qt::white); // whatever the palette is: this is paper
    if (!m_sheet.isNull())
        painter.drawImage(paper, m_sheet);
    const double pixels = paper.width() / m_plan.paper.width(); // a millimetre
    painter.setPen(QPen(Qt::gray, 0, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    if (!m_plan.room.isEmpty())
        painter.drawRect(QRectF(paper.topLeft() + pixels * m_plan.room.topLeft(), pixels * m_plan.room.size()));
    painter.setPen(QPen(edgeOfColours(), 0));
    painter.drawRect(paper);
}

} // namespace suffuse

#include "app/widgets/colour/swatch_grid.h"

#include "app/session/colour_convert.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDrag>
#include <QHelpEvent>
#include <QInputDialog>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <memory>

namespace suffuse {

namespace {
constexpr int cellSide = 20;
constexpr int swatchGap = 3;
constexpr int cellStep = cellSide + swatchGap;

/// A white corner with a dark edge, to be seen on every colour.
void paintLink(QPainter &painter, const QPainterPath &swatch, const QRect &cell)
{
    constexpr int leg = 9;
    const QPointF corner = QRectF(cell).bottomRight();
    painter.save();
    painter.setClipPath(swatch);
    painter.setPen(QPen(QColor(0x1E, 0x1F, 0x22), 1));
    painter.setBrush(Qt::white);
    painter.drawPolygon(QPolygonF{corner, corner - QPointF(leg, 0), corner - QPointF(0, leg)});
    painter.restore();
}
} // namespace

SwatchGrid::SwatchGrid(bool editable, QWidget *parent) : QWidget(parent), m_editable(editable), m_rows(editable)
{
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(editable);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(editable);
    setSizePolicy(policy);
    if (!editable)
        setFixedHeight(cellSide);
}

void SwatchGrid::setSwatches(std::vector<Swatch> swatches)
{
    if (swatches == m_swatches)
        return;
    m_swatches = std::move(swatches);
    m_current = std::clamp(m_current, 0, std::max(0, size() - 1));
    updateGeometry();
    update();
}

void SwatchGrid::showAll()
{
    m_rows = true;
    QSizePolicy policy = sizePolicy();
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setMinimumHeight(cellSide);
    setMaximumHeight(QWIDGETSIZE_MAX);
}

void SwatchGrid::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

void SwatchGrid::insert(int index, const Colour &colour)
{
    std::vector<Swatch> swatches = m_swatches;
    swatches.insert(swatches.begin() + std::clamp(index, 0, size()), Swatch{{}, colour});
    emit edited(swatches, tr("Add swatch"));
}

void SwatchGrid::move(int from, int to)
{
    if (to == from || to == from + 1)
        return;
    std::vector<Swatch> swatches = m_swatches;
    const auto at = swatches.begin();
    if (to > from)
        std::rotate(at + from, at + from + 1, at + to);
    else
        std::rotate(at + to, at + from, at + from + 1);
    emit edited(swatches, tr("Move swatch"));
}

void SwatchGrid::rename(int index, const QString &name)
{
    std::vector<Swatch> swatches = m_swatches;
    swatches[std::size_t(index)].name = name;
    emit edited(swatches, tr("Rename swatch"));
}

void SwatchGrid::remove(int index)
{
    std::vector<Swatch> swatches = m_swatches;
    swatches.erase(swatches.begin() + index);
    emit edited(swatches, tr("Remove swatch"));
}

void SwatchGrid::setLinked(int index, bool linked)
{
    std::vector<Swatch> swatches = m_swatches;
    swatches[std::size_t(index)].linked = linked;
    emit edited(swatches, linked ? tr("Link swatch") : tr("Unlink swatch"));
}

void SwatchGrid::setEdited(int index)
{
    m_edited = index;
    update();
}

int SwatchGrid::columns(int width) const
{
    return std::max(1, (width + swatchGap) / cellStep);
}

int SwatchGrid::shown(int width) const
{
    return m_rows ? size() : std::min(size(), columns(width));
}

int SwatchGrid::heightForWidth(int width) const
{
    const int across = columns(width);
    return std::max(1, (shown(width) + across - 1) / across) * cellStep - swatchGap;
}

QSize SwatchGrid::sizeHint() const
{
    return {8 * cellStep - swatchGap, heightForWidth(8 * cellStep - swatchGap)};
}

QSize SwatchGrid::minimumSizeHint() const
{
    return {4 * cellStep - swatchGap, cellSide};
}

QRect SwatchGrid::cell(int index) const
{
    const int across = columns(width());
    return {index % across * cellStep, index / across * cellStep, cellSide, cellSide};
}

int SwatchGrid::indexAt(QPoint at) const
{
    const int across = columns(width());
    const int column = at.x() / cellStep, row = at.y() / cellStep, index = row * across + column;
    const bool inside = at.x() >= 0 && at.y() >= 0 && column < across && index < shown(width());
    return inside && cell(index).contains(at) ? index : -1;
}

int SwatchGrid::gapAt(QPoint at) const
{
    const int across = columns(width());
    const int column = std::clamp((at.x() + cellStep / 2) / cellStep, 0, across);
    return std::clamp(std::max(0, at.y() / cellStep) * across + column, 0, size());
}

void SwatchGrid::setCurrent(int index)
{
    m_current = std::clamp(index, 0, std::max(0, shown(width()) - 1));
    update();
}

void SwatchGrid::setGap(int at)
{
    if (at == m_gap)
        return;
    m_gap = at;
    update();
}

bool SwatchGrid::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        if (const int index = indexAt(help->pos()); index >= 0) {
            const Swatch &swatch = m_swatches[std::size_t(index)];
            const QString hex = toOpaqueScreen(swatch.colour).name();
            QString text = swatch.name.isEmpty() ? hex : swatch.name + QStringLiteral(" · ") + hex;
            if (swatch.linked)
                text += QStringLiteral(" · ") + tr("linked");
            QToolTip::showText(help->globalPos(), text, this, cell(index));
            return true;
        }
    }
    return QWidget::event(event);
}

void SwatchGrid::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_swatches.empty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        if (height() > 2 * cellSide)
            painter.drawText(rect(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_emptyText);
        else
            painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                             fontMetrics().elidedText(m_emptyText, Qt::ElideRight, width()));
        if (hasFocus()) {
            painter.setPen(QPen(focusFrame(), 2));
            painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
        }
    }
    for (int i = 0; i < shown(width()); ++i) {
        QPainterPath shape;
        shape.addRoundedRect(QRectF(cell(i)).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        paintColour(painter, shape, m_swatches[std::size_t(i)].colour);
        if (m_swatches[std::size_t(i)].linked)
            paintLink(painter, shape, cell(i));
        const bool marked = (hasFocus() && i == m_current) || i == m_edited;
        painter.strokePath(shape, QPen(marked ? focusFrame() : edgeOfColours(), marked ? 2 : 1));
    }
    if (m_gap >= 0) {
        const QRect at = cell(m_gap);
        const bool atEnd = m_gap > 0 && m_gap == size() && at.x() == 0;
        const double x = atEnd ? cell(m_gap - 1).right() + 2.5 : at.x() - 1;
        const double y = atEnd ? cell(m_gap - 1).y() : at.y();
        painter.fillRect(QRectF(std::max(0.0, x - 1), y, 2, cellSide), focusFrame());
    }
}

void SwatchGrid::mousePressEvent(QMouseEvent *event)
{
    m_pressed = event->button() == Qt::LeftButton ? indexAt(event->pos()) : -1;
    m_pressedAt = event->pos();
    if (m_pressed >= 0)
        setCurrent(m_pressed);
}

void SwatchGrid::mouseMoveEvent(QMouseEvent *event)
{
    const bool far = (event->pos() - m_pressedAt).manhattanLength() >= QApplication::startDragDistance();
    if (m_pressed >= 0 && far && event->buttons() & Qt::LeftButton)
        startDrag(std::exchange(m_pressed, -1));
}

void SwatchGrid::mouseReleaseEvent(QMouseEvent *event)
{
    const int index = std::exchange(m_pressed, -1);
    if (event->button() == Qt::LeftButton && index >= 0 && index == indexAt(event->pos()))
        emit picked(m_swatches[std::size_t(index)].colour);
}

void SwatchGrid::startDrag(int index)
{
    auto *drag = new QDrag(this);
    drag->setMimeData(dragDataOf(m_swatches[std::size_t(index)].colour));
    drag->setPixmap(grab(cell(index)));
    drag->setHotSpot({cellSide / 2, cellSide / 2});
    const KeysEndDrag ends;
    drag->exec(Qt::CopyAction);
}

void SwatchGrid::contextMenuEvent(QContextMenuEvent *event)
{
    const int index = event->reason() == QContextMenuEvent::Keyboard ? m_current : indexAt(event->pos());
    if (!m_editable || index < 0 || index >= size())
        return;
    setCurrent(index);
    const std::unique_ptr<QMenu> menu(menuFor(index));
    menu->exec(event->reason() == QContextMenuEvent::Keyboard ? mapToGlobal(cell(index).bottomLeft())
                                                              : event->globalPos());
}

QMenu *SwatchGrid::menuFor(int index)
{
    auto *menu = new QMenu(this);
    menu->addAction(tr("Change the Colour"), this, [this, index] { emit changeWanted(index); });
    QAction *link = menu->addAction(tr("Linked to What Is Painted with It"));
    link->setCheckable(true);
    link->setChecked(m_swatches[std::size_t(index)].linked);
    connect(link, &QAction::triggered, this, [this, index](bool on) { setLinked(index, on); });
    menu->addAction(tr("Select What Has This Colour"), this, [this, index] { emit usersWanted(index); });
    menu->addSeparator();
    menu->addAction(tr("Rename…"), this, [this, index] { askName(index); });
    menu->addAction(tr("Remove"), this, [this, index] { remove(index); });
    return menu;
}

void SwatchGrid::askName(int index)
{
    bool ok = false;
    const QString name = QInputDialog::getText(this, tr("Rename swatch"), tr("Name"), QLineEdit::Normal,
                                               m_swatches[std::size_t(index)].name, &ok);
    if (ok && index < size())
        rename(index, name.trimmed());
}

void SwatchGrid::keyPressEvent(QKeyEvent *event)
{
    const int across = columns(width());
    if (m_swatches.empty())
        return QWidget::keyPressEvent(event);
    switch (event->key()) {
    case Qt::Key_Left:
        return setCurrent(m_current - 1);
    case Qt::Key_Right:
        return setCurrent(m_current + 1);
    case Qt::Key_Up:
        return setCurrent(m_current >= across ? m_current - across : m_current);
    case Qt::Key_Down:
        return setCurrent(m_current + across < shown(width()) ? m_current + across : m_current);
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
        emit picked(m_swatches[std::size_t(m_current)].colour);
        return;
    case Qt::Key_Delete:
        return m_editable ? remove(m_current) : QWidget::keyPressEvent(event);
    case Qt::Key_F2:
        return m_editable ? askName(m_current) : QWidget::keyPressEvent(event);
    default:
        QWidget::keyPressEvent(event);
    }
}

void SwatchGrid::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasColor())
        event->acceptProposedAction();
}

void SwatchGrid::dragMoveEvent(QDragMoveEvent *event)
{
    setGap(gapAt(event->position().toPoint()));
    event->acceptProposedAction();
}

void SwatchGrid::dragLeaveEvent(QDragLeaveEvent *)
{
    setGap(-1);
}

void SwatchGrid::dropEvent(QDropEvent *event)
{
    setGap(-1);
    const int to = gapAt(event->position().toPoint());
    if (event->source() == this)
        move(m_current, to); // The current swatch is the one that the drag began with.
    else if (const auto colour = colourOf(*event->mimeData()))
        insert(to, *colour);
    event->acceptProposedAction();
}

} // namespace suffuse

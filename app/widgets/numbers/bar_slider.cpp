#include "app/widgets/numbers/bar_slider.h"

#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QCoreApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double sliderHandleRadius = 6.5;
constexpr int leastWidth = 90; // a narrower bar cannot be dragged finely

void paintChecks(QPainter &painter, const QRectF &rect)
{
    painter.fillRect(rect, QColor(0xFF, 0xFF, 0xFF));
    const double side = 4;
    for (int row = 0; row * side < rect.height(); ++row)
        for (int column = row % 2; column * side < rect.width(); column += 2)
            painter.fillRect(QRectF(rect.left() + column * side, rect.top() + row * side, side, side).intersected(rect),
                             QColor(0xCC, 0xCC, 0xCC));
}

} // namespace

BarSlider::BarSlider(QWidget *parent) : QSlider(Qt::Horizontal, parent)
{
    endDragsWhenCovered(*this);
    setRange(0, steps);
    setSingleStep(steps / 100);
    setPageStep(steps / 10);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::ClickFocus); // Tab goes from number to number; the number beside the slider does by keys all
                                    // that the slider does
}

void BarSlider::setGradient(std::function<QColor(double)> gradient)
{
    m_gradient = std::move(gradient);
    update();
}

void BarSlider::setMixed(bool mixed)
{
    m_mixed = mixed;
    update();
}

QSize BarSlider::sizeHint() const
{
    return {120, 22};
}

QSize BarSlider::minimumSizeHint() const
{
    return {leastWidth, 22};
}

QRectF BarSlider::track() const
{
    const double thickness = m_gradient ? 10 : 4;
    return {sliderHandleRadius + 1, 0.5 * (height() - thickness), width() - 2 * sliderHandleRadius - 2, thickness};
}

int BarSlider::positionAt(double x) const
{
    const QRectF bar = track();
    return int(std::lround(std::clamp((x - bar.left()) / std::max(bar.width(), 1.0), 0.0, 1.0) * steps));
}

void BarSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_makesOne = event->modifiers() & Qt::ControlModifier;
    m_grip = 0;
    const bool wasMixed = m_mixed;
    setSliderDown(true);
    qApp->installEventFilter(this);
    // A press on the handle takes hold of it without a jump; a press elsewhere jumps there. What stands for a change of mixed
    // values never jumps: a touch of the bar's end would be a tenth of each of them.
    const QRectF bar = track();
    const double handle = bar.left() + bar.width() * sliderPosition() / steps;
    const int position = positionAt(event->position().x());
    if (wasMixed && m_makesOne && position == sliderPosition())
        emit valueChanged(position); // the handle stood there for something else
    else if (wasMixed ? m_makesOne : std::abs(event->position().x() - handle) > sliderHandleRadius)
        setSliderPosition(position);
    else
        m_grip = event->position().x() - handle;
}

void BarSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        setSliderPosition(positionAt(event->position().x() - m_grip));
}

void BarSlider::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        letGo();
}

void BarSlider::letGo()
{
    if (!isSliderDown())
        return;
    qApp->removeEventFilter(this);
    setSliderDown(false);
}

bool BarSlider::eventFilter(QObject *watched, QEvent *event)
{
    const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!key || !givesUpDrag(*static_cast<QKeyEvent *>(event)))
        return QSlider::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        emit givenUp();
        letGo();
    }
    return true;
}

void BarSlider::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = track();
    const double x = bar.left() + bar.width() * sliderPosition() / steps;
    const QPalette &colours = palette();
    QPainterPath shape;
    shape.addRoundedRect(bar, bar.height() / 2, bar.height() / 2);
    if (m_gradient && isEnabled()) {
        QLinearGradient gradient(bar.topLeft(), bar.topRight());
        for (int i = 0; i <= 16; ++i)
            gradient.setColorAt(i / 16.0, m_gradient(i / 16.0));
        painter.save();
        painter.setClipPath(shape);
        paintChecks(painter, bar);
        painter.restore();
        painter.fillPath(shape, gradient);
        painter.strokePath(shape, QPen(hairline(), 1));
    } else {
        painter.fillPath(shape, colours.color(QPalette::Mid));
        if (isEnabled()) {
            QPainterPath filled;
            const double from = m_mixed ? bar.center().x() : bar.left();
            filled.addRoundedRect(QRectF(QPointF(from, bar.top()), QPointF(x, bar.bottom())).normalized(),
                                  bar.height() / 2, bar.height() / 2);
            painter.fillPath(filled, colours.color(QPalette::Highlight));
        }
    }
    if (!isEnabled())
        return;
    if (m_mixed) { // a change is measured from the middle
        painter.setPen(QPen(colours.color(QPalette::PlaceholderText), 1));
        painter.drawLine(QPointF(bar.center().x(), 2), QPointF(bar.center().x(), height() - 2.0));
    }
    const bool strong = hasFocus() || isSliderDown();
    painter.setPen(QPen(strong ? colours.color(QPalette::Highlight) : colours.color(QPalette::Dark), strong ? 2 : 1.2));
    painter.setBrush(isDarkTheme() ? QColor(0xE3, 0xE4, 0xE6) : QColor(Qt::white));
    painter.drawEllipse(QPointF(x, 0.5 * height()), sliderHandleRadius - 0.5, sliderHandleRadius - 0.5);
}

} // namespace suffuse

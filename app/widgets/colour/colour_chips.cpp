#include "app/widgets/colour/colour_chips.h"

#include "app/session/colour_convert.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int side = 22;
constexpr int nearCount = 7; ///< in a row, the colour itself in the middle

/// As people read it, with its opacity where it is not opaque.
QString chipText(const Colour &colour)
{
    const QString name = toOpaqueScreen(colour).name();
    return colour.opacity == 1
               ? name
               : ColourChips::tr("%1, opacity %2 %").arg(name, QLocale().toString(100 * double(colour.opacity), 'f', 0));
}

} // namespace

std::vector<Colour> nearColours(const Colour &colour)
{
    const HueShares own = toShares(colour, 0);
    const double white = std::max(0.0, 1 - own.chroma - own.black);
    std::vector<Colour> colours;
    const auto add = [&](double hue, double chroma, double black) {
        colours.push_back(fromShares({hue - std::floor(hue), chroma, black}, colour.opacity));
    };
    constexpr int middle = nearCount / 2;
    for (int i = 0; i < nearCount; ++i) { // lighter to darker: towards white, then towards black
        const double t = double(std::abs(i - middle)) / (middle + 0.6);
        const double towards = i < middle ? 0 : t;
        add(own.hue, own.chroma * (1 - t), own.black * (1 - t) + towards);
    }
    const double tint = std::max(own.chroma, std::min(0.2, 1 - own.black)); // greys have neighbours that are tinted
    for (int i = 0; i < nearCount; ++i)
        add(own.hue + 0.045 * (i - middle), i == middle ? own.chroma : tint,
            i == middle ? own.black : std::min(own.black, 1 - tint));
    for (int i = 0; i < nearCount; ++i) { // grey of the same lightness to full
        const double t = double(i - middle) / middle;
        const double chroma = t < 0 ? own.chroma * (1 + t) : own.chroma + (1 - own.chroma) * t;
        const double rest = own.black + white;
        const double share = rest > 0 ? own.black / rest : 0;
        add(own.hue, chroma, (1 - chroma) * share);
    }
    return colours;
}

ColourChips::ColourChips(int columns, QWidget *parent) : QWidget(parent), m_columns(columns)
{
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ColourChips::setColours(std::vector<Colour> colours)
{
    const bool grows = colours.size() != m_colours.size();
    m_colours = std::move(colours);
    m_current = std::clamp(m_current, 0, std::max(0, int(m_colours.size()) - 1));
    if (grows)
        updateGeometry();
    update();
}

int ColourChips::rows() const
{
    return std::max(1, (int(m_colours.size()) + m_columns - 1) / m_columns);
}

QSize ColourChips::sizeHint() const
{
    return {m_columns * side, rows() * side};
}

QRect ColourChips::cell(int index) const
{
    return {index % m_columns * side, index / m_columns * side, side, side};
}

int ColourChips::indexAt(QPoint at) const
{
    for (int i = 0; i < int(m_colours.size()); ++i)
        if (cell(i).contains(at))
            return i;
    return -1;
}

void ColourChips::setCurrent(int index)
{
    m_current = std::clamp(index, 0, std::max(0, int(m_colours.size()) - 1));
    update();
}

void ColourChips::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < int(m_colours.size()); ++i) {
        QPainterPath shape;
        shape.addRoundedRect(QRectF(cell(i)).adjusted(1.5, 1.5, -1.5, -1.5), 3, 3);
        const Colour &colour = m_colours[std::size_t(i)];
        if (m_showsOpacity)
            paintColour(painter, shape, colour);
        else
            painter.fillPath(shape, toOpaqueScreen(colour));
        const bool marked = (hasFocus() && i == m_current) || i == m_pressed;
        painter.strokePath(shape, QPen(marked ? focusFrame() : edgeOfColours(), marked ? 3 : 1));
    }
}

bool ColourChips::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const int index = indexAt(help->pos());
    const QString tip = index < 0 ? toolTip() : chipText(m_colours[std::size_t(index)]);
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
}

void ColourChips::mousePressEvent(QMouseEvent *event)
{
    m_pressed = event->button() == Qt::LeftButton ? indexAt(event->position().toPoint()) : -1;
    update();
}

void ColourChips::mouseReleaseEvent(QMouseEvent *event)
{
    const int pressed = std::exchange(m_pressed, -1);
    update();
    if (pressed < 0 || indexAt(event->position().toPoint()) != pressed)
        return;
    setCurrent(pressed);
    emit picked(Colour(m_colours[std::size_t(pressed)])); // what hears of it may bring other colours
}

void ColourChips::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        return setCurrent(m_current - 1);
    case Qt::Key_Right:
        return setCurrent(m_current + 1);
    case Qt::Key_Up:
        return setCurrent(m_current >= m_columns ? m_current - m_columns : m_current);
    case Qt::Key_Down:
        return setCurrent(m_current + m_columns < int(m_colours.size()) ? m_current + m_columns : m_current);
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!m_colours.empty())
            emit picked(Colour(m_colours[std::size_t(m_current)]));
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void ColourChips::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    update();
}

} // namespace suffuse

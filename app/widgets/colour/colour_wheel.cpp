#include "app/widgets/colour/colour_wheel.h"

#include "app/session/colour_convert.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/look/theme.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double ringShare = 0.16; ///< thickness of the ring as a share of the radius

void paintMarker(QPainter &painter, QPointF at, const QColor &fill, double radius, bool focus)
{
    painter.setBrush(fill);
    painter.setPen(QPen(QColor(0x1E, 0x1F, 0x22), focus ? 4 : 3));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(Qt::white, focus ? 2 : 1.5));
    painter.drawEllipse(at, radius, radius);
}

} // namespace

ColourWheel::ColourWheel(QWidget *parent) : QWidget(parent)
{
    endDragsWhenCovered(*this);
    setFocusPolicy(Qt::StrongFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(tr("Colour wheel"));
    setToolTip(tr("Ring: hue in the order of pigments. Triangle: pure, white and black.\nArrow keys work too."));
}

QSize ColourWheel::sizeHint() const
{
    return {184, heightForWidth(184)};
}

int ColourWheel::heightForWidth(int width) const
{
    return std::clamp(width, 120, 200);
}

QSize ColourWheel::minimumSizeHint() const
{
    return {120, 120};
}

void ColourWheel::setColour(const Colour &colour, bool isOneOfSeveral)
{
    if (m_part != Part::None)
        return; // The wheel itself is being dragged.
    m_isOneOfSeveral = isOneOfSeveral;
    m_shares = toShares(colour, m_shares.hue);
    m_opacity = colour.opacity;
    update();
}

QPointF ColourWheel::centre() const
{
    return QRectF(rect()).center();
}

double ColourWheel::outerRadius() const
{
    return std::max(20.0, 0.5 * std::min(width(), height()) - 4);
}

double ColourWheel::innerRadius() const
{
    return outerRadius() * (1 - ringShare);
}

QPointF ColourWheel::ringPoint(double hue) const
{
    const double radius = 0.5 * (outerRadius() + innerRadius()), angle = 2 * pi * hue - pi / 2;
    return centre() + radius * QPointF(std::cos(angle), std::sin(angle));
}

QPointF ColourWheel::trianglePoint(double chroma, double black) const
{
    // The pure hue is the corner on top, white the lower left one, black the lower right one.
    const double radius = innerRadius() - 5, white = 1 - chroma - black;
    const auto corner = [&](double angle) { return centre() + radius * QPointF(std::cos(angle), std::sin(angle)); };
    return chroma * corner(-pi / 2) + white * corner(5 * pi / 6) + black * corner(pi / 6);
}

void ColourWheel::pick(QPointF at)
{
    if (m_part == Part::Triangle) {
        pickInTriangle(at);
    } else {
        const QPointF d = at - centre();
        const double hue = (std::atan2(d.y(), d.x()) + pi / 2) / (2 * pi);
        m_shares.hue = hue - std::floor(hue);
    }
    update();
    emit picked(colour(), &m_entry);
}

void ColourWheel::pickInTriangle(QPointF at)
{
    const QPointF w = trianglePoint(0, 0), p = trianglePoint(1, 0) - w, k = trianglePoint(0, 1) - w, d = at - w;
    const double area = p.x() * k.y() - p.y() * k.x();
    double chroma = (d.x() * k.y() - d.y() * k.x()) / area;
    double black = (p.x() * d.y() - p.y() * d.x()) / area;
    double white = 1 - chroma - black;
    // Outside of the triangle the nearest mixture is taken, along the lines to the far corners.
    chroma = std::max(chroma, 0.0);
    black = std::max(black, 0.0);
    white = std::max(white, 0.0);
    const double sum = chroma + black + white;
    m_shares.chroma = chroma / sum;
    m_shares.black = black / sum;
}

void ColourWheel::mousePressEvent(QMouseEvent *event)
{
    const QPointF d = event->position() - centre();
    const double distance = std::hypot(d.x(), d.y());
    if (event->button() != Qt::LeftButton || distance > outerRadius() + 4) {
        event->ignore();
        return;
    }
    m_pressed = m_shares;
    m_part = distance >= innerRadius() - 2 ? Part::Ring : Part::Triangle;
    m_entry.beginDrag();
    qApp->installEventFilter(this);
    pick(event->position());
}

void ColourWheel::mouseMoveEvent(QMouseEvent *event)
{
    if (m_part != Part::None)
        pick(event->position());
}

void ColourWheel::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || m_part == Part::None)
        return;
    qApp->removeEventFilter(this);
    m_part = Part::None;
    m_entry.commitDrag();
    emit finished();
}

void ColourWheel::giveUp()
{
    qApp->removeEventFilter(this);
    m_part = Part::None;
    m_shares = m_pressed;
    emit picked(colour(), &m_entry); // for whoever keeps the colour without an editor
    m_entry.giveUpDrag();
    update();
    emit finished();
}

bool ColourWheel::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
        return QWidget::eventFilter(watched, event);
    if (!givesUpDrag(static_cast<const QKeyEvent &>(*event)))
        return QWidget::eventFilter(watched, event);
    event->accept();
    if (event->type() == QEvent::KeyPress)
        giveUp();
    return true;
}

/// The entry for a step by a key.
ValueEntry *ColourWheel::entryOfStep()
{
    m_entry.noteStep();
    return &m_entry;
}

void ColourWheel::keyPressEvent(QKeyEvent *event)
{
    const double step = event->modifiers() & Qt::ShiftModifier ? 0.05 : 0.01;
    switch (event->key()) {
    case Qt::Key_Left:
        m_shares.hue = std::fmod(m_shares.hue + 1 - step, 1.0);
        break;
    case Qt::Key_Right:
        m_shares.hue = std::fmod(m_shares.hue + step, 1.0);
        break;
    case Qt::Key_Up:
        m_shares.black = std::max(0.0, m_shares.black - step);
        break;
    case Qt::Key_Down:
        m_shares.black = std::min(1.0, m_shares.black + step);
        m_shares.chroma = std::min(m_shares.chroma, 1 - m_shares.black);
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    update();
    emit picked(colour(), entryOfStep());
    emit finished();
}

void ColourWheel::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    paintRing(painter);
    paintTriangle(painter);
    if (hasFocus())
        paintFocus(painter);
    if (m_isOneOfSeveral && m_part == Part::None)
        return;
    const double radius = 0.5 * (outerRadius() - innerRadius());
    paintMarker(painter, ringPoint(m_shares.hue), toOpaqueScreen(pureHue(m_shares.hue)), radius - 2, hasFocus());
    paintMarker(painter, trianglePoint(m_shares.chroma, m_shares.black), toOpaqueScreen(colour()), 5.5, hasFocus());
}

/// Around the ring, in the room that markers leave: the ring itself has every colour.
void ColourWheel::paintFocus(QPainter &painter)
{
    constexpr double gap = 2.5, width = 2;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(focusFrame(), width));
    painter.drawEllipse(centre(), outerRadius() + gap, outerRadius() + gap);
}

void ColourWheel::paintRing(QPainter &painter)
{
    QConicalGradient gradient(centre(), 90);
    for (int i = 0; i <= 48; ++i)
        gradient.setColorAt(1 - i / 48.0, toOpaqueScreen(pureHue(i / 48.0)));
    QPainterPath ring;
    ring.addEllipse(centre(), outerRadius(), outerRadius());
    ring.addEllipse(centre(), innerRadius(), innerRadius());
    painter.fillPath(ring, gradient);
    painter.strokePath(ring, QPen(hairline(), 1));
}

void ColourWheel::paintTriangle(QPainter &painter)
{
    // The way from RYB to RGB is not linear, so a small picture of the mixtures is stretched to the triangle.
    constexpr int side = 64;
    if (m_triangle.isNull() || m_triangleHue != m_shares.hue) {
        m_triangleHue = m_shares.hue;
        m_triangle = QImage(side, side, QImage::Format_RGB32);
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double chroma = double(row) / (side - 1);
                const double black = std::min(double(column) / (side - 1), 1 - chroma);
                m_triangle.setPixelColor(column, row, toOpaqueScreen(fromShares({m_shares.hue, chroma, black}, 1)));
            }
    }
    const QPointF white = trianglePoint(0, 0), pure = trianglePoint(1, 0), black = trianglePoint(0, 1);
    const QPointF x = (black - white) / (side - 1), y = (pure - white) / (side - 1);
    // Pixel (0, 0) has its centre at (½, ½).
    const QPointF origin = white - 0.5 * x - 0.5 * y;
    QBrush brush(m_triangle);
    brush.setTransform(QTransform(x.x(), x.y(), y.x(), y.y(), origin.x(), origin.y()));
    const QPolygonF triangle{white, pure, black};
    painter.setPen(QPen(hairline(), 1));
    painter.setBrush(brush);
    painter.drawPolygon(triangle);
}

} // namespace suffuse

#include "app/canvas/handles/guide_handle.h"

#include "app/canvas/canvas_view.h"
#include "app/canvas/handles/rulers.h"
#include "app/canvas/overlay/overlay.h"
#include "app/session/drawing_aids.h"

#include <QLocale>

#include <cmath>

namespace suffuse {

namespace {

constexpr double guideReach = 4; ///< logical pixels beside a guide in which a press takes it
constexpr double rulerReach = 6; ///< the same on a ruler
constexpr double usualTickSpacing = 56;

Point axisOfGuide(bool upright)
{
    return upright ? Point{0, 1} : Point{1, 0};
}

/// A point of the guide, beside the middle of the view so that a deep zoom keeps its digits.
Point pointOfGuide(const Guide &guide, const View &view)
{
    return guide.upright ? Point{guide.place, view.centre.y} : Point{view.centre.x, guide.place};
}

Point directionOfGuide(const Guide &guide, const View &view)
{
    const Point from = pointOfGuide(guide, view);
    const Point way = view.toPixels(from + (1 / view.scale) * axisOfGuide(guide.upright)) - view.toPixels(from);
    return 1 / std::max(length(way), 1e-300) * way;
}

double distanceToGuide(const Guide &guide, Point pixel, const View &view)
{
    return std::abs(cross(directionOfGuide(guide, view), pixel - view.toPixels(pointOfGuide(guide, view))));
}

/// Whether it runs more across the view than down.
bool runsAcross(const Guide &guide, const View &view)
{
    const Point way = directionOfGuide(guide, view);
    return std::abs(way.x) > std::abs(way.y);
}

} // namespace

GuideHandle::GuideHandle(DrawingAids &aids, const CanvasView &view, Surroundings around)
    : m_aids(aids), m_view(view), m_around(std::move(around))
{}

bool GuideHandle::isOnRuler(Point pixel) const
{
    return m_around.aids().showRulers && suffuse::isOnRuler(pixel, m_around.dpr());
}

std::optional<GuideHandle::Hit> GuideHandle::hitAt(Point pixel) const
{
    const CanvasAids aids = m_around.aids();
    const View &view = m_view.view();
    const double dpr = m_around.dpr(), width = rulerWidth * dpr;
    const bool onRuler = isOnRuler(pixel);
    const bool onLeft = pixel.x < width; // the ruler there, which counts down
    if (onRuler && onLeft && pixel.y < width)
        return std::nullopt; // The corner belongs to both.
    const std::vector<Guide> &guides = m_aids.guides();
    const bool mayTake = aids.showGuides && !aids.lockGuides && !m_around.isBare();
    double nearest = (onRuler ? rulerReach : guideReach) * dpr;
    std::optional<Hit> hit;
    for (int i = 0; mayTake && i < int(guides.size()); ++i) {
        const Guide &guide = guides[std::size_t(i)];
        const double distance = distanceToGuide(guide, pixel, view);
        const bool endsHere = !onRuler || runsAcross(guide, view) == onLeft;
        if (endsHere && distance <= nearest) {
            nearest = distance;
            hit = Hit{i, guide.upright};
        }
    }
    if (hit && !onRuler && !m_around.isFree(pixel))
        return std::nullopt;
    if (!hit && onRuler) // It is parallel to its ruler.
        hit = Hit{-1, runsAcross({true, 0}, view) != onLeft};
    return hit;
}

std::optional<QCursor> GuideHandle::cursorAt(Point pixel) const
{
    const std::vector<Guide> &guides = m_aids.guides();
    if (m_held >= 0 && m_held < int(guides.size()))
        return QCursor(runsAcross(guides[std::size_t(m_held)], m_view.view()) ? Qt::SplitVCursor : Qt::SplitHCursor);
    if (const std::optional<Hit> hit = hitAt(pixel))
        return QCursor(runsAcross({hit->upright, 0}, m_view.view()) ? Qt::SplitVCursor : Qt::SplitHCursor);
    return isOnRuler(pixel) ? std::optional(QCursor(Qt::ArrowCursor)) : std::nullopt;
}

void GuideHandle::press(const PointerEvent &event)
{
    m_held = -1;
    const std::optional<Hit> hit = hitAt(event.pixel);
    if (!hit)
        return;
    if (event.doubleClick && hit->guide >= 0)
        return m_around.askPlace(hit->guide);
    m_before = m_aids.guides();
    m_isNew = hit->guide < 0;
    m_held = hit->guide;
    m_pixel = event.pixel;
    if (m_isNew) {
        std::vector<Guide> guides = m_before;
        guides.push_back({hit->upright, hit->upright ? event.point.x : event.point.y});
        m_aids.setGuides(std::move(guides));
        m_held = int(m_before.size()) < int(m_aids.guides().size()) ? int(m_before.size()) : -1;
    }
}

void GuideHandle::move(const PointerEvent &event)
{
    std::vector<Guide> guides = m_aids.guides();
    if (m_held < 0 || m_held >= int(guides.size()))
        return;
    m_pixel = event.pixel;
    Guide &guide = guides[std::size_t(m_held)];
    double place = guide.upright ? event.point.x : event.point.y;
    if (event.modifiers & Qt::ShiftModifier) {
        const View &view = m_view.view();
        const bool alongTop = !runsAcross(guide, view);
        const double tick = rulerScale(view, !alongTop, m_around.rulerUnit(), usualTickSpacing * m_around.dpr()).tick;
        place = tick * std::round(place / tick);
    } else { // as fine as a pixel, without digits beyond it
        const double fine = std::pow(10, std::floor(std::log10(1 / m_view.view().scale)));
        place = fine * std::round(place / fine);
    }
    guide.place = place;
    m_aids.setGuides(std::move(guides));
}

bool GuideHandle::mayGo(Point pixel) const
{
    const View &view = m_view.view();
    return isOnRuler(pixel) || !Rect::of(0, 0, view.width, view.height).contains(pixel);
}

void GuideHandle::release(const PointerEvent &event)
{
    const int held = m_held;
    move(event);
    m_held = -1;
    std::vector<Guide> guides = m_aids.guides();
    if (held < 0 || held >= int(guides.size()) || !mayGo(event.pixel))
        return;
    const bool wentAway = m_isNew || !(guides[std::size_t(held)] == m_before[std::size_t(held)]);
    if (wentAway) { // A click on its end lets it stay.
        guides.erase(guides.begin() + held);
        m_aids.setGuides(std::move(guides));
    }
}

void GuideHandle::cancel()
{
    if (m_held >= 0)
        m_aids.setGuides(m_before);
    m_held = -1;
}

void GuideHandle::paint(QPainter &painter, const View &view, const OverlayColours &colours, double dpr) const
{
    const CanvasAids aids = m_around.aids();
    const std::vector<Guide> &guides = m_aids.guides();
    if ((!aids.showGuides && m_held < 0) || m_around.isBare())
        return;
    const double far = 2.0 * (view.width + view.height);
    QPainterPath lines;
    for (const Guide &guide : guides) {
        const Point at = view.toPixels(pointOfGuide(guide, view)), way = directionOfGuide(guide, view);
        Point a = at - far * way, b = at + far * way;
        if (clipLine(a, b, Rect::of(0, 0, view.width, view.height).grown(dpr))) {
            lines.moveTo(a.x, a.y);
            lines.lineTo(b.x, b.y);
        }
    }
    strokeTwoTone(painter, lines, colours.guide, dpr, Qt::SolidLine, 0.75);
    if (m_held >= 0 && m_held < int(guides.size()))
        paintBadge(painter, placeInWords(guides[std::size_t(m_held)], m_around.rulerUnit(), view.scale), m_pixel, 0,
                   view, dpr);
}

QString placeInWords(const Guide &guide, const RulerUnit &unit, double scale)
{
    const int decimals = std::clamp(int(std::ceil(std::log10(scale * unit.units) - 1e-9)), 0, 9);
    QString words = (guide.upright ? QStringLiteral("x ") : QStringLiteral("y ")) +
                    QLocale().toString(guide.place / unit.units, 'f', decimals).replace('-', QChar(0x2212));
    if (!unit.name.isEmpty())
        words += QLatin1Char(' ') + unit.name;
    return words;
}

} // namespace suffuse

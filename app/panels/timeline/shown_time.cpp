#include "app/panels/timeline/shown_time.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double endMargin = 12; ///< logical pixels at both ends when all is shown
constexpr double finest = 20; ///< microseconds a pixel
/// The whole length has no more pixels than these, so that scroll bars can count them.
constexpr double mostPixels = 1e9;
constexpr Microseconds shortest = 1'000'000; ///< So much of the time of an empty painting is shown.

/// The room that is left after what is painted, in microseconds.
Microseconds roomFor(const TimeSpan &span)
{
    return (span.end - span.begin) / 16;
}

double lengthOf(const TimeSpan &span)
{
    return double(span.end - span.begin);
}

/// The microseconds a pixel at which all is shown.
double fittedScale(const TimeSpan &span, double width)
{
    return std::max(lengthOf(span) / std::max(width - 2 * endMargin, 1.0), finest);
}

} // namespace

void ShownTime::fit()
{
    m_fitted = true;
    m_room = 0;
}

TimeSpan ShownTime::spanOf(const TimeSpan &painted, Microseconds now) const
{
    TimeSpan span = painted;
    span.begin = std::min<Microseconds>(span.begin, 0);
    span.end = std::max({span.end, now, span.begin + shortest});
    if (m_room < span.end + 2 * roomFor(span)) // Otherwise strokes have been undone since the room was made.
        span.end = std::max(span.end, m_room);
    return span;
}

void ShownTime::makeRoomAfter(Microseconds now, const TimeSpan &span)
{
    m_room = now + roomFor(span);
}

void ShownTime::follow(const TimeSpan &span, double width)
{
    if (m_fitted) {
        m_scale = fittedScale(span, width);
        m_from = span.begin - Microseconds(endMargin * m_scale);
    }
    m_scale = std::max(m_scale, lengthOf(span) / mostPixels);
}

void ShownTime::zoomAt(double x, double factor, const TimeSpan &span, double width)
{
    const Microseconds fixed = m_from + Microseconds(std::llround(x * m_scale));
    const double widest = lengthOf(span) / std::max(width - 2 * endMargin, 1.0);
    m_scale = std::clamp(m_scale / factor, finest, std::max(widest, finest));
    m_fitted = m_scale >= widest;
    const Microseconds edge = Microseconds(endMargin * m_scale);
    const Microseconds last = span.end + edge - Microseconds(width * m_scale);
    m_from = std::max(span.begin - edge, std::min(fixed - Microseconds(std::llround(x * m_scale)), last));
}

void ShownTime::scrollTo(double pixels, const TimeSpan &span)
{
    m_from = span.begin + Microseconds(std::llround((pixels - endMargin) * m_scale));
    m_fitted = false;
}

void ShownTime::turnPageTo(Microseconds time)
{
    m_from = time - Microseconds(endMargin * m_scale);
}

double ShownTime::pixelsBefore(const TimeSpan &span) const
{
    return endMargin + double(m_from - span.begin) / m_scale;
}

double ShownTime::pixelsBeyond(const TimeSpan &span, double width) const
{
    return std::max(0.0, std::ceil(lengthOf(span) / m_scale + 2 * endMargin - width));
}

} // namespace suffuse

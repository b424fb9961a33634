// The part of the time that the Timeline shows.
#pragma once

#include "model/document/timelapse.h"

namespace suffuse {

/// Knows the moment at the left edge and the scale, after fitting, zooming and scrolling. Widths and distances are
/// logical pixels; a span is all the time that there is to show.
class ShownTime {
public:
    Microseconds from() const { return m_from; }
    /// microseconds a pixel
    double scale() const { return m_scale; }
    bool isFitted() const { return m_fitted; }

    /// Shows all of the time from now on, also when the painting grows.
    void fit();
    /// The span to show of a painting at a moment, with room for what is being painted.
    TimeSpan spanOf(const TimeSpan &painted, Microseconds now) const;
    /// Makes room ahead when time goes on beyond what is painted, so that bars do not move at each moment.
    void makeRoomAfter(Microseconds now, const TimeSpan &span);
    /// Takes another span or width.
    void follow(const TimeSpan &span, double width);
    /// Zooms by a factor; the moment at x stays there. Neither end of the span moves further in than its margin.
    void zoomAt(double x, double factor, const TimeSpan &span, double width);
    /// Scrolls by hand, so that so many pixels lie to the left of the view.
    void scrollTo(double pixels, const TimeSpan &span);
    /// Moves a moment to the left edge.
    void turnPageTo(Microseconds time);

    /// The number of pixels to the left of the view.
    double pixelsBefore(const TimeSpan &span) const;
    /// The number of pixels of the span for which a view of this width has no room.
    double pixelsBeyond(const TimeSpan &span, double width) const;

private:
    bool m_fitted = true;
    Microseconds m_from = 0;
    double m_scale = 10'000;
    Microseconds m_room = 0; ///< The view shows the time up to here.
};

} // namespace suffuse

// Which part of the time the timeline shows.
#pragma once

#include "model/document/timelapse.h"

namespace suffuse {

/// The moment at the left edge and the scale, as they are fitted, zoomed and scrolled. Widths and distances are logical
/// pixels; a span is all the time that there is to show.
class ShownTime {
public:
    Microseconds from() const { return m_from; }
    /// Microseconds a pixel.
    double scale() const { return m_scale; }
    bool isFitted() const { return m_fitted; }

    /// All of it is shown from now on, also when the painting grows.
    void fit();
    /// What there is to show of a painting at a moment, with room for what is being painted.
    TimeSpan spanOf(const TimeSpan &painted, Microseconds now) const;
    /// Time goes on beyond what is painted: there is room ahead, so that not every moment moves all bars.
    void makeRoomAfter(Microseconds now, const TimeSpan &span);
    /// The span or the width is another one.
    void follow(const TimeSpan &span, double width);
    /// What is at x stays there; neither end of the span comes further in than its margin.
    void zoomAt(double x, double factor, const TimeSpan &span, double width);
    /// By hand, so that so many pixels lie left of the view.
    void scrollTo(double pixels, const TimeSpan &span);
    /// The moment stands at the left.
    void turnPageTo(Microseconds time);

    /// Left of the view.
    double pixelsBefore(const TimeSpan &span) const;
    /// Of the span that have no place in a view of this width.
    double pixelsBeyond(const TimeSpan &span, double width) const;

private:
    bool m_fitted = true;
    Microseconds m_from = 0;
    double m_scale = 10'000;
    Microseconds m_room = 0; ///< shown up to here
};

} // namespace suffuse

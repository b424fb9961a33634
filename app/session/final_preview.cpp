#include "app/session/final_preview.h"

namespace suffuse {

namespace {

/// Makes every segment that is born by T as old as it ever gets, at T and ever after.
StrokePtr driedBy(const Stroke &stroke, Microseconds T)
{
    auto dried = std::make_shared<Stroke>(stroke);
    for (Segment &s : dried->segments) {
        if (s.born > T)
            continue;
        s.born = std::min(s.born, T - Microseconds(std::ceil(double(s.maxAge) * 1e6)));
        for (Rewet &r : s.rewet)
            r.time = std::min(r.time, T - r.extra);
    }
    return dried;
}

Microseconds paintedAt(const Stroke &stroke)
{
    Microseconds t = stroke.born();
    for (const Segment &s : stroke.segments)
        t = std::max(t, s.born);
    return t;
}

} // namespace

PaintingPtr FinalPreview::of(const PaintingPtr &painting, Microseconds T)
{
    std::unordered_map<StrokePtr, StrokePtr> kept;
    std::shared_ptr<Painting> result;
    for (std::size_t i = 0; i < painting->strokes.size(); ++i) {
        const StrokePtr &stroke = painting->strokes[i];
        if (stroke->driesAt() <= T || stroke->born() > T)
            continue;
        const auto known = m_dried.find(stroke);
        StrokePtr dried = known != m_dried.end() ? known->second : driedBy(*stroke, T);
        // It must be the same value from frame to frame, so that the renderer sees that nothing changed.
        if (paintedAt(*stroke) <= T)
            kept.emplace(stroke, dried);
        if (!result)
            result = std::make_shared<Painting>(*painting);
        result->strokes[i] = std::move(dried);
    }
    m_dried = std::move(kept);
    return result ? PaintingPtr(std::move(result)) : painting;
}

} // namespace suffuse

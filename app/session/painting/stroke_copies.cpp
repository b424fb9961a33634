#include "app/session/painting/stroke_copies.h"

#include "model/document/document.h"
#include "model/shaping/transform.h"

#include <algorithm>

namespace suffuse {

void StrokeCopies::begin(Document &document, const Symmetry &symmetry)
{
    clear();
    for (const Affine &map : symmetry.copies())
        m_copies.push_back({document.takeStrokeId(), map, nullptr});
}

void StrokeCopies::clear()
{
    m_copies.clear();
    m_last.reset();
}

std::size_t StrokeCopies::unchanged(const Stroke &stroke) const
{
    if (!m_last || m_last->id != stroke.id || m_last->origin != stroke.origin || stroke.segments.empty())
        return 0;
    const auto [a, b] =
        std::mismatch(m_last->segments.begin(), m_last->segments.end(), stroke.segments.begin(), stroke.segments.end());
    return std::min(std::size_t(b - stroke.segments.begin()), stroke.segments.size() - 1);
}

std::vector<StrokePtr> StrokeCopies::of(const StrokePtr &stroke)
{
    if (!stroke)
        return {};
    std::vector<StrokePtr> all;
    const std::size_t same = unchanged(*stroke);
    const auto begin = stroke->segments.begin() + std::ptrdiff_t(same);
    Stroke tail = *stroke;
    tail.segments.assign(begin, stroke->segments.end());
    for (Copy &copy : m_copies) {
        const bool goesOn = same > 0 && copy.last; // The maps keep lengths, so each segment becomes one segment.
        std::optional<Stroke> mapped = tryTransformed(goesOn ? tail : *stroke, copy.map, SpreadRule::Scales);
        if (mapped && goesOn) {
            const auto kept = copy.last->segments.begin();
            mapped->segments.insert(mapped->segments.begin(), kept, kept + std::ptrdiff_t(same));
        }
        copy.last.reset();
        if (!mapped)
            continue;
        mapped->id = copy.id;
        copy.last = std::make_shared<const Stroke>(std::move(*mapped));
        all.push_back(copy.last);
    }
    m_last = stroke;
    return all;
}

std::vector<StrokePtr> StrokeCopies::with(const StrokePtr &stroke)
{
    std::vector<StrokePtr> all = of(stroke);
    all.insert(all.begin(), stroke);
    return all;
}

} // namespace suffuse

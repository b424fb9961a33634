#include "undo/lettering/letter_erasures.h"

#include "model/painting/validate.h"
#include "model/shaping/curves/chains.h"
#include "model/shaping/curves/split.h"

#include <algorithm>

namespace suffuse {

namespace {

constexpr double longestPiece = 0.5; ///< ems; a cubic that is no longer follows the line by its control points
constexpr double rounding = 1e-6;    ///< ems; what moves by no more stays

/// Whether letters stand upright below each other, or turned on a straight line from top to bottom.
bool isColumn(const Text &text)
{
    return text.vertical && text.curve.empty();
}

double emOf(const Text &text)
{
    return text.size * std::sqrt(std::abs(text.place.determinant()));
}

} // namespace

LetterErasures::LetterErasures(const Text &before, const Text &after)
    : m_before(before), m_after(after), m_bends(before.curve != after.curve && !isColumn(before) && !isColumn(after)),
      m_lineBefore(m_bends ? before.curve : std::vector<Cubic>()),
      m_lineAfter(m_bends ? after.curve : std::vector<Cubic>())
{}

void LetterErasures::note(const Stroke &letter)
{
    if (!m_bends || !letter.hasErasure())
        return;
    for (const Chain &chain : chainsOf(letter)) {
        Part part{letter.id, std::numeric_limits<Microseconds>::max(), 0};
        for (int k = chain.first; k <= chain.last; ++k)
            if (const Segment &segment = letter.segments[std::size_t(k)]; segment.takesPaint()) {
                part.from = std::min(part.from, segment.born);
                part.to = std::max(part.to, segment.driesAt());
            }
        if (part.from < part.to)
            m_parts.push_back(part);
    }
}

void LetterErasures::findLong()
{
    std::ranges::sort(m_parts, {}, &Part::from);
    for (std::size_t begin = 0, end = 0; begin < m_parts.size(); begin = end) {
        bool isOfSeveral = false;
        Microseconds until = m_parts[begin].to;
        for (; end < m_parts.size() && (end == begin || m_parts[end].from < until); ++end) {
            isOfSeveral = isOfSeveral || m_parts[end].letter != m_parts[begin].letter;
            until = std::max(until, m_parts[end].to);
        }
        if (isOfSeveral)
            m_long.emplace_back(m_parts[begin].from, until);
    }
}

bool LetterErasures::isLong(const Segment &segment) const
{
    return segment.takesPaint() && std::ranges::any_of(m_long, [&segment](const auto &when) {
               return when.first <= segment.born && segment.born < when.second;
           });
}

StrokePtr LetterErasures::bent(const StrokePtr &moved, const Step &step) const
{
    const auto takes = [this](const Segment &segment) { return isLong(segment); };
    if (m_long.empty() || !moved || std::ranges::none_of(moved->segments, takes))
        return moved;
    const std::optional<Affine> back = step.map.inverse(), toLine = m_before.place.inverse();
    if (!back || !toLine)
        return moved;
    const Affine before = *toLine * *back;
    const double larger = m_after.size / m_before.size, em = emOf(m_after);
    double near = step.alongBefore, farthest = 0;
    const auto bend = [&](Point p) {
        const Point q = before(p);
        near = m_lineBefore.besides(q, near);
        const BaselineCurve::Place from = m_lineBefore.at(near);
        const BaselineCurve::Place to = m_lineAfter.at(step.alongAfter + larger * (near - step.alongBefore));
        const Point off = q - from.point, d = to.direction, down{-d.y, d.x};
        const double ahead = larger * dot(off, from.direction), below = larger * cross(from.direction, off);
        const Point bent = m_after.place(to.point + ahead * d + below * down);
        farthest = std::max(farthest, length(bent - p));
        return bent;
    };

    std::vector<std::vector<double>> splits(moved->segments.size());
    for (std::size_t k = 0; k < splits.size(); ++k)
        if (const Segment &segment = moved->segments[k]; isLong(segment)) {
            const Cubic curve = moved->cubicOf(segment);
            const int pieces = int(std::min(1000.0, std::ceil(polygonLength(curve) / (longestPiece * em))));
            for (int i = 1; i < pieces; ++i)
                splits[k].push_back(double(i) / pieces);
            splits[k] = distinct(std::move(splits[k]), curve);
        }
    auto result = std::make_shared<Stroke>(*moved);
    result->segments.clear();
    for (Piece &piece : piecesOf(*moved, splits)) {
        if (isLong(piece.segment)) {
            const bool goesOn = !piece.segment.start && !result->segments.empty();
            for (Offset &p : piece.segment.bezier)
                p = toOffset(bend(moved->origin + p), moved->origin);
            if (goesOn)
                piece.segment.bezier[0] = result->segments.back().bezier[3];
        }
        result->segments.push_back(std::move(piece.segment));
    }
    return farthest <= rounding * em || !problemOf(*result).isEmpty() ? moved : result;
}

} // namespace suffuse

#include "model/colour/one_colour.h"

#include "model/area/outline.h"
#include "model/colour/colour_shift.h"
#include "model/colour/perceived.h"

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

/// How far apart red, yellow and blue can be within a stroke of a brush that strays, as the liveliest one that comes with
/// the program does. Half of it is on each side of the brush's colour.
constexpr float widestStray = 0.22f + 1e-4f;

/// The colours of a stroke's own paint, from the least to the greatest of each channel.
class StrayBox {
public:
    explicit StrayBox(const ColourPart &part)
    {
        const std::vector<Segment> &segments = part.stroke->segments;
        for (std::size_t k = 0; k < segments.size(); ++k)
            if (part.has(k) && !onlyBounds(*part.stroke, k))
                include(segments[k].colour);
    }

    bool isEmpty() const { return m_isEmpty; }
    /// Whether a brush that strays has all of these colours by itself.
    bool isOfOneBrush() const
    {
        return m_greatest.red - m_least.red <= widestStray && m_greatest.yellow - m_least.yellow <= widestStray &&
               m_greatest.blue - m_least.blue <= widestStray;
    }
    bool has(const Colour &colour) const
    {
        const auto within = [](float low, float value, float high) { return low <= value && value <= high; };
        return !m_isEmpty && within(m_least.red, colour.red, m_greatest.red) &&
               within(m_least.yellow, colour.yellow, m_greatest.yellow) &&
               within(m_least.blue, colour.blue, m_greatest.blue);
    }
    /// About the brush's own colour; exactly that of a stroke which has no other.
    Colour middle() const
    {
        const auto between = [](float low, float high) { return low + 0.5f * (high - low); };
        return {between(m_least.red, m_greatest.red), between(m_least.yellow, m_greatest.yellow),
                between(m_least.blue, m_greatest.blue), 1};
    }

private:
    void include(const Colour &colour)
    {
        if (std::exchange(m_isEmpty, false))
            m_least = m_greatest = colour;
        m_least = {std::min(m_least.red, colour.red), std::min(m_least.yellow, colour.yellow),
                   std::min(m_least.blue, colour.blue), 1};
        m_greatest = {std::max(m_greatest.red, colour.red), std::max(m_greatest.yellow, colour.yellow),
                      std::max(m_greatest.blue, colour.blue), 1};
    }

    Colour m_least, m_greatest;
    bool m_isEmpty = true;
};

/// Asks whether colours look like one; neighbours mostly are the same.
class Likeness {
public:
    explicit Likeness(const Colour &one) : m_seen(perceivedOf(one)), m_last(one) {}

    bool has(const Colour &colour)
    {
        if (!samePaint(std::exchange(m_last, colour), colour))
            m_isLike = looksLike(perceivedOf(colour), m_seen);
        return m_isLike;
    }

private:
    Perceived m_seen;
    Colour m_last;
    bool m_isLike = true;
};

bool allLook(const ColourPart &part, Likeness &like)
{
    const std::vector<Segment> &segments = part.stroke->segments;
    for (std::size_t k = 0; k < segments.size(); ++k)
        if (part.has(k) && !onlyBounds(*part.stroke, k) && !like.has(segments[k].colour))
            return false;
    return true;
}

} // namespace

bool looksLikeOne(const ColourParts &parts, const Colour &usual)
{
    std::vector<StrayBox> boxes;
    Colour middle = usual;
    bool isFound = false;
    for (const ColourPart &part : parts) {
        const StrayBox &box = boxes.emplace_back(part);
        if (!isFound && box.isOfOneBrush() && box.has(usual)) {
            middle = box.middle();
            isFound = true;
        }
    }
    Likeness toUsual(usual), toMiddle(middle);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const ColourPart &part = parts[i];
        const bool strays = boxes[i].isEmpty() || (boxes[i].isOfOneBrush() && toMiddle.has(boxes[i].middle()));
        if (!strays && !allLook(part, toUsual))
            return false;
        const auto fillDiffers = [&](const Colour &colour) { return !toUsual.has(colour) && !toMiddle.has(colour); };
        if ((part.fill && fillDiffers(part.stroke->fill->colour)) ||
            (part.gradient && fillDiffers(part.stroke->fill->gradient->colour)))
            return false;
    }
    return true;
}

} // namespace suffuse

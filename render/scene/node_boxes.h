// The nodes of strokes in pixels of a picture, as every backend takes them. Beside them, in separate arrays, is what is
// needed to choose among them: where they reach and how dense they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace suffuse {

/// A node in pixels of the picture. If it is separable, b = 0.
struct ViewNode {
    double x = 0, y = 0;
    float a = 0, b = 0, c = 0; ///< metric, px⁻²
    float weight = 0;          ///< density at its centre
    float cut = 0;             ///< e^(−R²)
    std::uint32_t row = 0;     ///< its row in the stroke's channel values
    friend bool operator==(const ViewNode &, const ViewNode &) = default;
};

/// Boxes are read and written in runs of so many.
inline constexpr std::size_t boxRun = 16;
/// Positions are floats, so they are wrong by less than this, px.
inline constexpr double boxMargin = 0.05;

template <class F, class I>
struct BoxPlanes {
    F *x = nullptr, *y = nullptr;           ///< centre, px
    F *reachX = nullptr, *reachY = nullptr; ///< half-sizes, px
    F *weight = nullptr;                    ///< density at the centre
    F *slowest = nullptr;                   ///< least eigenvalue of the metric, px⁻²: q ≥ slowest·d²
    F *steepest = nullptr; ///< weight times the root of the greatest, px⁻¹: weight·|∇q| ≤ 2·steepest·√q
    I *node = nullptr;     ///< weight times the root of the greatest eigenvalue, px⁻¹: weight·|∇q| ≤ 2·steepest·√q

    /// The boxes from the one at `first` on.
    BoxPlanes from(std::size_t first) const
    {
        return {x + first,      y + first,       reachX + first,   reachY + first,
                weight + first, slowest + first, steepest + first, node + first};
    }
};
using NodeBoxes = BoxPlanes<const float, const std::uint32_t>;
/// Boxes to be written. If x is null, only `node` is written.
using NodeBoxSink = BoxPlanes<float, std::uint32_t>;

/// Boxes with their memory.
class NodeBoxStore {
public:
    /// Makes room for `count` boxes. If it grows, what was there is lost.
    void reserve(std::size_t count)
    {
        const std::size_t padded = (count + boxRun - 1) / boxRun * boxRun + boxRun;
        if (padded <= m_room)
            return;
        m_room = padded;
        m_planes.resize(7 * m_room);
        m_nodes.resize(m_room);
    }
    NodeBoxSink sink() { return planes<float, std::uint32_t>(m_planes.data(), m_nodes.data()); }
    NodeBoxes boxes() const { return planes<const float, const std::uint32_t>(m_planes.data(), m_nodes.data()); }

private:
    template <class F, class I>
    BoxPlanes<F, I> planes(F *p, I *node) const
    {
        const std::size_t n = m_room;
        return {p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n, p + 6 * n, node};
    }

    std::size_t m_room = 0;
    std::vector<float> m_planes;
    std::vector<std::uint32_t> m_nodes;
};

} // namespace suffuse

// The outline of a filled stroke as closed rings that can be cut open and put together anew.
#pragma once

#include "model/shaping/nodes/reshape.h"

#include <functional>
#include <set>

namespace suffuse {

/// A curve of a ring: that of a segment of the stroke, or a straight line that bridges a gap or closes the ring.
struct RingCurve {
    int segment = -1; ///< −1 for such a line
    Cubic curve;      ///< offsets from the stroke's origin
};

/// What a chain encloses: its segments that lay paint, closed by straight lines (as `closedOutline` has it).
struct Ring {
    Chain chain;
    std::vector<RingCurve> curves;
    bool isOpen = false; ///< whether its last curve is a line that closes it
};
std::vector<Ring> ringsOf(const Stroke &stroke);

/// How often rings run around a point, counted from the x axis towards the y axis.
int windingOf(const std::vector<Ring> &rings, Point at);

/// A place where rings are cut open.
struct RingGate {
    int ring = 0, curve = 0;
    double p = 0;     ///< in [0, 1)
    int sign = 0;     ///< to which side of the cut the ring goes here
    double place = 0; ///< along the cut
    int partner = -1; ///< the gate with which the ring goes on here, on the same side of the cut; −1: it is not cut
    Offset at;        ///< where it is, in the numbers of segments; known when rings are cut
};

/// A curve that is put into an outline.
struct NewCurve {
    Cubic curve;
    bool isLine = false;
};

/// Makes the stroke of rings that were cut.
class RingCutter {
public:
    RingCutter(const Stroke &stroke, std::vector<Ring> rings, std::vector<RingGate> gates);

    const std::vector<RingGate> &gates() const { return m_gates; }

    /// Follows the rings from gate to gate, with the curves of `bridge` from each gate at which a part ends to its
    /// partner. Parts begin at gates to the sides that `keeps`; of rings that no gate cuts, those stay that `stays`.
    void follow(const std::function<bool(int sign)> &keeps, const std::function<bool(int ring)> &stays,
                const std::function<std::vector<NewCurve>(const RingGate &, const RingGate &)> &bridge);
    /// Opens each ring at all of its gates: each part is a chain, and the last one goes on around the polygon of the
    /// gates, which is all that the others leave of the area.
    void open();
    /// Leaves segments out of the rings, which straight lines close instead, and out of what takes paint away.
    void leaveOut(const std::set<int> &segments);
    /// Adds a closed loop of new curves.
    void addLoop(const std::vector<NewCurve> &curves);

    /// The stroke, with what takes paint away behind the rings that were cut. It has no segments if nothing is left.
    Stroke result(std::vector<int> *sources);

private:
    struct Element {
        int source = -1;
        Segment segment;
        int gate = -1; ///< the gate at its start
        bool isLine = false;
    };
    using Elements = std::vector<Element>;

    void cut();
    void keepWhole(const Ring &ring);
    void append(Elements elements);
    void appendNew(Elements &elements, const std::vector<NewCurve> &curves, Offset from, Offset to) const;
    std::size_t firstAtGate(std::size_t ring, int gate) const;

    const Stroke &m_stroke;
    std::vector<Ring> m_rings;
    std::vector<RingGate> m_gates;
    std::vector<Elements> m_elements; ///< of each ring
    Segment m_model;                  ///< the values of what is new: it lays no paint
    Stroke m_result;
    std::vector<int> m_sources;
    std::vector<int> m_lifts; ///< segments of cut rings that take paint away
    std::set<int> m_left;     ///< segments that were left out
};

} // namespace suffuse

// How large the eraser was that left an erasure, and erasures of another size or strength.
#pragma once

#include "model/painting/stroke.h"

#include <map>

namespace suffuse {

/// The sizes of erasures. That of a fading one depends a little on the greatest share that its eraser took, which is
/// found among the segments that are added: all of its strokes should be.
class ErasureSizes {
public:
    void add(const Stroke &stroke);
    void add(const Segment &segment);
    /// The diameter of the eraser that left a segment, canvas units. Erasures do not keep how soft it was, so it is
    /// that of one of the usual softness: 2s/0.6, or s(1 + ln 11) where it has faded all of the paint
    /// (`SoftTip::spread`).
    double of(const Segment &segment) const;

private:
    std::map<float, double> m_peaks; ///< for each D·t_max, the greatest peak of what fades
};

/// How far an erasure spreads beside its curve, s, canvas units.
double erasureSpread(const Segment &segment);
/// Makes an erasure wider by a factor. What it takes in its middle stays.
void widenErasure(Segment &segment, double factor);

} // namespace suffuse

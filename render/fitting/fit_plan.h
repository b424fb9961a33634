// In which steps a fit goes: few strokes at a small picture first.
#pragma once

#include <vector>

namespace suffuse::fitting {

/// A part of a fit with one size of the picture.
struct FitPhase {
    int strokes = 0;    ///< There are so many when it has begun.
    bool grows = false; ///< whether it has more strokes than the one before
    int halvings = 0;   ///< how often the picture is halved
    int steps = 0;
    /// Before it begins, so great a share of the strokes, those that do the least, are taken away and put where the
    /// picture lacks most.
    double moved = 0;
    double firstRate = 1, lastRate = 1; ///< of the sizes of steps; between them it falls evenly in its logarithm
};

/// The phases of a fit that has `have` strokes and is to have `strokes`, with so many steps in all, of which
/// a phase may have none. With `byError` the number of strokes grows little by little, until the fit says that it is enough,
/// so that there are fewer steps in all, or more.
std::vector<FitPhase> planOf(int have, int strokes, bool byError, int steps, int width, int height);

/// So many steps a fit takes, unless the caller says otherwise.
inline constexpr int usualFitSteps = 1200;

} // namespace suffuse::fitting

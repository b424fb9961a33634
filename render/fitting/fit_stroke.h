// A stroke as the 27 numbers that a fit moves.
#pragma once

#include "model/painting/style.h"
#include "render/fitting/fit_picture.h"
#include "render/gradient/flat_scene.h"

#include <array>
#include <numbers>
#include <vector>

namespace suffuse::fitting {

/// A stroke is three cubics that join each other, of one width, style and colour.
inline constexpr int strokeCubics = 3, strokePoints = 3 * strokeCubics + 1;

/// Where its numbers stand. Those that must be positive are logarithms; the opacity is 1/(1 + e^(−v)).
enum StrokeNumber : std::size_t {
    FirstPoint = 0,               ///< x and y of each control point, pixels of the picture that is fitted
    LogSpread = 2 * strokePoints, ///< ln s, s in such pixels
    LogPeak,                      ///< ln of the peak φˢ/(√π s ξ1) that a long stroke has; ξ1 is 1
    LogSteepness,                 ///< ln ξ2
    Red,                          ///< R, Y, B, [0, 1]
    Yellow,
    Blue,
    Opacity,
    strokeNumbers
};
static_assert(strokeNumbers == 27);

/// √π: a long stroke has the peak φˢ/(√π s).
inline constexpr double rootPi = 1 / std::numbers::inv_sqrtpi;

using FitStroke = std::array<double, strokeNumbers>;
/// A derivative, or a step, by each number.
using StrokeSlope = FitStroke;

/// What is given, and no number.
struct FitLimits {
    StyleKind style = StyleKind::Feathering;
    double leastWidth = 0;    ///< pixels; 0: none. The width is where half of the paint is
    double greatestWidth = 0; ///< pixels; 0: none
    double leastSpread = 1;   ///< pixels; below 1, a renderer takes more samples than a fit does
    double greatestSpread = 1e4;
    /// Size of the picture, pixels. Control points lie no farther beyond it than paint beside it is seen in it, so that what is
    /// fitted can be taken hold of; 0: anywhere.
    double width = 0, height = 0;
};

/// Where F is half of what it is at the middle, or ½ where it saturates: the width of what is seen, pixels.
double widthOf(const FitStroke &stroke, StyleKind style);
/// Brings all numbers back to where they may be.
void keepWithin(FitStroke &stroke, const FitLimits &limits);

/// The strokes as a scene whose picture shows `width` × `height` of their pixels in `view` × … pixels.
gradient::FlatScene sceneOf(const std::vector<FitStroke> &strokes, StyleKind style, const Colour &background,
                            const View &view);
/// Writes new numbers of the same strokes into a scene.
void setNumbers(const std::vector<FitStroke> &strokes, StyleKind style, gradient::FlatScene &scene);
/// The derivatives by the strokes' numbers from those by the scene's.
std::vector<StrokeSlope> slopesOf(const gradient::FlatGradient &by, const gradient::FlatScene &scene,
                                  const std::vector<FitStroke> &strokes);

} // namespace suffuse::fitting

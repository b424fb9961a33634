// The paper's method on a CUDA device, as it is written and as well as we can port it. Measurements only. C++17, no Qt.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace suffuse::baseline {

inline constexpr int mostPoints = 8; ///< of the quadrature

/// A segment as the paper's kernel reads it, in pixels.
struct CurveRecord {
    float x[4], y[4]; ///< the cubic in powers of p, constant first
    float middleX, middleY, reach;
    float spread;  ///< s
    float density; ///< φˢ
    float colour[4];
};

/// The same prepared for the port.
struct QuadratureRecord {
    float middleX, middleY, reach;
    float scale;                        ///< √(log₂e)/s
    float x[mostPoints], y[mostPoints]; ///< of the quadrature's points
    float exponent[mostPoints];         ///< log₂ of their densities
    float colour[4];
    std::uint32_t stroke;
};

/// How one stroke shows: eq 17-19 with the edges that the renderer gives them, at a pixel's centre; eq 20-23.
struct ShadeRecord {
    std::int32_t kind; ///< 0 to 2: eq 17 to 19
    float xi1, xi2, xi3;
    float f0, gain, cut; ///< (17): F(φ₀) and 1/(1 − F₀); (19): φ_e
    float keep;          ///< eq 23: 1 − β
    float colour[4];     ///< where `varies` is 0
    std::uint32_t varies;
    std::uint32_t firstSegment, segments;
};

struct PaperScene {
    int width = 0, height = 0; ///< pixels
    int points = mostPoints;   ///< of the quadrature: 5 or 8
    float background[3] = {0, 0, 0};
    float ruleX[mostPoints] = {}, ruleWeight[mostPoints] = {};
    std::vector<CurveRecord> curves;           ///< of all strokes, in document order
    std::vector<QuadratureRecord> quadratures; ///< the same segments
    std::vector<ShadeRecord> strokes;
};

enum class PaperKernel {
    AsWritten, ///< a launch a stroke, a thread a pixel of the whole canvas; curves evaluated in the thread
    Port ///< one launch: macro-tile lists, tiles of 16 × 16 in document order, points staged in shared memory, sums and
         ///< colours in registers. Each pixel still sums each point's own exponential.
};

/// A scene resident on the first device.
class PaperOnDevice {
public:
    virtual ~PaperOnDevice() = default;
    virtual std::string deviceName() const = 0;
    /// Draws the scene; milliseconds on the device's clock, from an empty canvas to RGBA. Negative: `why` says why it
    /// failed. Of each segment's points the port evaluates `polynomials` (0 to 2) exponentials in the multiply-add
    /// units, and the rest in the special function units, which are its limit.
    virtual double draw(PaperKernel kernel, int polynomials, std::string &why) = 0;
    /// What was drawn last: 4 floats a pixel. Empty: `why` says why it failed.
    virtual std::vector<float> picture(std::string &why) = 0;
};

/// Null where there is no device, with the reason.
std::unique_ptr<PaperOnDevice> paperOnDevice(const PaperScene &scene, std::string &why);

} // namespace suffuse::baseline

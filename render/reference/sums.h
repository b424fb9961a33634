// Sums over the segments of a stroke at a block of sample points.
#pragma once

#include "render/reference/local_paint.h"
#include "render/reference/stroke_source.h"

namespace suffuse::reference {

/// Sample (i, j) lies at first + step·(i, j), in pixels.
struct SampleBlock {
    Point first;
    double step = 1;
    int nx = 0;
    int ny = 0;

    Rect area() const { return {first.x, first.y, first.x + step * (nx - 1), first.y + step * (ny - 1)}; }
    /// The samples i with lo ≤ x_i ≤ hi: [from, to).
    struct Range {
        int from = 0;
        int to = 0;
        bool isEmpty() const { return from >= to; }
    };
    Range columns(double lo, double hi) const { return range(lo, hi, first.x, nx); }
    Range rows(double lo, double hi) const { return range(lo, hi, first.y, ny); }

private:
    Range range(double lo, double hi, double start, int n) const;
};

/// φ⁺, φ⁻, ∇(φ⁺ − φ⁻), and Σφ_k·value over the segments that lay paint for every channel, at every sample of a block.
/// Its memory is used again and again.
class StrokeSums {
public:
    /// Adds up all segments of the stroke that reach the block.
    void evaluate(const StrokeSource &stroke, const SampleBlock &block);

    /// Whether φ⁺ = 0 at a sample, so that the stroke shows nothing there.
    bool isEmpty(int i, int j) const { return !(m_density[index(i, j)] > 0) && !(covered(i, j) > 0); }
    /// What the stroke is at a sample. The slope is per pixel. A crisp fill counts if `inside`.
    LocalDensity at(const StrokeSource &stroke, int i, int j, bool inside) const;
    /// Whether φ⁺ > 0 at a sample beside what a crisp fill lays.
    bool laysOutside(int i, int j) const { return m_density[index(i, j)] > 0; }
    /// How much of a sample a crisp fill covers.
    double covered(int i, int j) const { return m_covered.empty() ? 0 : m_covered[index(i, j)]; }

private:
    std::size_t index(int i, int j) const { return std::size_t(j) * std::size_t(m_block.nx) + std::size_t(i); }
    void addSegment(const SegmentSource &segment);
    void addFill(const FillSource &fill);
    void addNode(const Node &node, const SegmentSource &segment);
    void addAnisotropicNode(const Node &node, const SegmentSource &segment);

    SampleBlock m_block;
    std::vector<double> m_density, m_lifted, m_faded, m_gradientX, m_gradientY;
    std::vector<std::vector<double>> m_channels;
    std::vector<double> m_covered; ///< empty without a crisp fill
    std::vector<double> m_own, m_ownX, m_ownY; ///< of the present segment
    std::vector<double> m_column, m_columnX;   ///< the factors of the present node
    std::vector<Panel> m_panels;
};

} // namespace suffuse::reference

// A stroke's fill in one tile.
#pragma once

#include "render/cpu/kernels.h"
#include "render/scene/scene_fill.h"

namespace suffuse::cpu {

/// What there is of a fill in an area.
enum class FillPresence : std::uint8_t { Nothing, Inside, Outline };

/// The panels of a fill that count in a tile, and what is computed from them in its cells. Each cell takes what counts
/// there, whatever the tile, so its bits do not depend on the tile.
///
/// What counts in a cell is decided by the ends of panels alone, with the cell grown by the reach as the region. A
/// level line is crossed by panels left of the region, and by those that meet it, which are summed up by their nodes.
/// The first are counted on the region's upper border. Further down their number changes only where a summed panel ends
/// left of the region, since there its neighbour goes on (docs/solver.md, "Fills").
class TileFill {
public:
    /// Begins a tile. It keeps its memory.
    void begin(const SceneFill &fill, const PixelRect &tile);

    const SceneFill &fill() const { return *m_fill; }
    /// In a block of the tile whose corner lies at a pixel, as far as the density goes.
    FillPresence presence(int x, int y);

    /// Adds the fill to the sums at a block of the tile, which may have smaller samples than pixels. Neither deep nor
    /// crisp.
    void addTo(const Kernels &kernels, const Block &block, int channels, Sums &sums);
    /// How much of each sample of a block a crisp fill covers.
    void cover(const Block &block, float *covered);
    /// Adds what a crisp fill lays where it covers a sample.
    void addInside(const Block &block, int channels, Sums &sums) const;

    /// Whether a stroke that has nothing but the fill is the same at all samples within it.
    bool isLevel(int channels) const;
    /// Sets the sums of one vector of samples to those within a level fill.
    void setInside(int channels, Sums &sums) const;

    /// Calls raise(column, row) for the pixels of a block near the boundary, in pixels from its corner. What only
    /// touches a square, but for rounding, does not lie in it.
    template <class Raise>
    void forEachNear(int x, int y, Raise raise) const
    {
        constexpr double touches = 1e-9;
        const double more = m_fill->nearby - touches;
        const auto visit = [&](const Rect &box, auto isMet) {
            // Pixel i is the square from i to i + 1.
            const int left = int(std::max(0.0, std::ceil(box.left - more - 1 - x)));
            const int top = int(std::max(0.0, std::ceil(box.top - more - 1 - y)));
            const int right = int(std::min(blockSide - 1.0, std::floor(box.right + more - x)));
            const int bottom = int(std::min(blockSide - 1.0, std::floor(box.bottom + more - y)));
            for (int row = top; row <= bottom; ++row)
                for (int column = left; column <= right; ++column)
                    if (isMet(Rect::of(x + column, y + row, 1, 1).grown(more)))
                        raise(column, row);
        };
        for (const FillPanel *panel : m_panels)
            visit(panel->box, [panel](const Rect &square) { return meets(panel->part.arc, square); });
        for (const BoundaryFlat *flat : m_flats)
            visit({flat->left, flat->y, flat->right, flat->y}, [flat](const Rect &square) {
                return flat->y > square.top && flat->y < square.bottom && flat->left < square.right &&
                       flat->right > square.left;
            });
    }

private:
    /// Panels and flats that count in a square of the plane.
    struct Near {
        std::vector<const FillPanel *> panels;
        std::vector<const BoundaryFlat *> flats;
        bool isEmpty() const { return panels.empty() && flats.empty(); }
    };

    /// A panel by its ends, the upper one first.
    struct Ends {
        double x0, y0, x1, y1;
        int enters;
        std::uint32_t firstNode, endNode;
    };
    /// What may count in a block.
    struct BlockList {
        std::vector<Ends> panels;
        std::vector<const BoundaryFlat *> flats;
        bool isMade = false;
    };
    /// What panels and flats are in a region.
    struct Region {
        int base = 0; ///< how often the area is entered left of it at its upper border, by what does not meet it
        bool isMet = false;
    };

    /// Collects the ends of panels that may count in the tile.
    void collectEnds(const Rect &counted);
    /// The list of the block in which a place lies.
    const BlockList &listAt(double x, double y);
    /// How often the area is entered left of what counts in the tile.
    int leftOfTile(double y);
    /// Looks at what counts in a region. If `collect`, nodes and events are collected, relative to a centre.
    Region look(const BlockList &list, const Rect &region, bool collect, Point centre = {});

    /// Whether an arc runs through the inside of a square.
    static bool meets(const RisingArc &arc, const Rect &square);
    int entered(Point at);
    /// The arcs that have a part between two heights, and may lie left of something there.
    const std::vector<const BoundaryArc *> &arcsBetween(double top, double bottom);
    const Near &near(const Rect &counted);
    void coverCell(Point corner, double step, float *covered, int stride);
    void addConstant(const Block &block, int i0, int j0, int channels, Sums &sums) const;
    void addCell(const Block &block, int i0, int j0, int channels, const FillCellSums &cell, Sums &sums) const;

    const SceneFill *m_fill = nullptr;
    PixelRect m_tile;
    int m_columns = 0; ///< of blocks
    std::vector<BlockList> m_lists;
    BlockList m_all; ///< what meets the tile's region; its flats only where it stands for all blocks
    std::vector<FillLeft> m_lefts;
    std::vector<std::pair<double, int>> m_leftAt; ///< what leftOfTile has found for some heights
    std::vector<const FillPanel *> m_panels;
    std::vector<const BoundaryFlat *> m_flats;
    std::vector<BoundaryArc> m_arcs;
    Near m_near;
    /// Where levels that were asked for are entered and left.
    struct Level {
        double y;
        std::vector<std::pair<double, int>> crossings;
    };
    std::vector<Level> m_levels;
    std::size_t m_levelCount = 0;
    /// What arcsBetween has found for some rows of cells.
    struct Row {
        double top, bottom;
        std::vector<const BoundaryArc *> arcs;
    };
    std::vector<Row> m_rows;
    std::size_t m_rowCount = 0;
    std::size_t m_nodeCount = 0; ///< of m_x, m_y and m_weight
    std::vector<float> m_x, m_y, m_weight, m_eventY, m_eventJump;
    std::vector<double> m_cuts; ///< of an arc, by the borders of samples
};

} // namespace suffuse::cpu

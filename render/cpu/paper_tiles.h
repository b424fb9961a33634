// The paper η under the tiles of a picture. It is computed once for all strokes and kept while the view stays.
#pragma once

#include "render/cpu/kernels.h"
#include "render/cpu/paper_plan.h"
#include "render/picture_grid.h"
#include "render/scene/paper.h"
#include "render/threads/unset_vector.h"

#include <array>
#include <memory>
#include <vector>

namespace suffuse::cpu {

class PaperTiles {
public:
    explicit PaperTiles(std::size_t blocksPerTile) : m_blocksPerTile(blocksPerTile) {}

    /// Begins a frame. What is known of the paper stays if the picture's place and the paper do. One thread may call it
    /// while none paints.
    void begin(const Kernels &kernels, const PictureGrid &grid, const Paper &paper,
               std::shared_ptr<const PaperTexture> image, std::size_t tiles);

    /// Whether η differs from 1 anywhere.
    bool isThere() const { return m_paper.kind != PaperKind::None && m_paper.strength > 0; }

    /// η at the pixels of a block of a tile. `room` is used where nothing is kept. Several threads may ask for
    /// different tiles.
    const float *at(std::size_t tile, std::size_t index, const Block &block, float *room);

    /// Computes η at samples, 2^-level pixels apart, whose cells lie on the grid of such cells.
    void fill(const Block &block, int level, float *eta) const;

private:
    static constexpr int levels = 7; // A pixel has up to 2^6 samples along a side.
    struct alignas(64) BlockEta {
        float v[blockSize];
    };
    struct Tile {
        UnsetVector<BlockEta> blocks;
        std::uint32_t known = 0; ///< a bit for each block that was computed
    };

    const std::size_t m_blocksPerTile;
    const Kernels *m_kernels = nullptr;
    PictureGrid m_grid;
    Paper m_paper;
    std::shared_ptr<const PaperTexture> m_image;
    std::array<PaperPlan, levels> m_plans; ///< for procedural papers
    std::vector<Tile> m_tiles;             ///< none where they would take too much memory
};

} // namespace suffuse::cpu

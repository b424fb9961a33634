#include "render/cpu/paper_tiles.h"

#include "render/math/paper.h"

#include <algorithm>
#include <cmath>

namespace suffuse::cpu {

namespace {

constexpr std::size_t mostBytes = std::size_t(32) << 20; // That is enough for 3840 × 2160 pixels.

void fillImagePaper(const PaperTexture &image, const Paper &paper, const View &view, const Block &block, float *eta)
{
    const double cosine = std::cos(view.rotation), sine = std::sin(view.rotation);
    for (int j = 0; j < blockSide; ++j)
        for (int i = 0; i < blockSide; ++i) {
            const Point at =
                view.toCanvas({block.x + (i + 0.5) * block.step, block.y + (j + 0.5) * block.step}, cosine, sine);
            *eta++ = float(math::imagePaper(at.x, at.y, image.grey.data(), image.width, image.height,
                                            double(paper.scale), double(paper.strength)));
        }
}

} // namespace

void PaperTiles::begin(const Kernels &kernels, const PictureGrid &grid, const Paper &paper,
                       std::shared_ptr<const PaperTexture> image, std::size_t tiles)
{
    m_kernels = &kernels;
    const bool same = grid.sameGrid(m_grid) && paper == m_paper && image == m_image;
    const bool sameTiles = same && grid.picture == m_grid.picture;
    m_grid = grid;
    if (!same) {
        m_paper = paper;
        m_image = std::move(image);
        for (int level = 0; level < levels && isThere() && paper.kind == PaperKind::Procedural; ++level)
            m_plans[std::size_t(level)] = planPaper(paper, grid.view, std::ldexp(1.0, -level));
    }
    if (!isThere() || tiles * m_blocksPerTile * sizeof(BlockEta) > mostBytes)
        tiles = 0;
    if (m_tiles.size() != tiles)
        m_tiles = std::vector<Tile>(tiles);
    else if (!sameTiles)
        for (Tile &tile : m_tiles)
            tile.known = 0; // Its memory is used again.
}

const float *PaperTiles::at(std::size_t tile, std::size_t index, const Block &block, float *room)
{
    if (m_tiles.empty()) {
        fill(block, 0, room);
        return room;
    }
    Tile &kept = m_tiles[tile];
    if (kept.blocks.empty())
        kept.blocks.resize(m_blocksPerTile);
    float *eta = kept.blocks[index].v;
    if (!(kept.known >> index & 1))
        fill(block, 0, eta);
    kept.known |= 1u << index;
    return eta;
}

void PaperTiles::fill(const Block &block, int level, float *eta) const
{
    if (m_paper.kind == PaperKind::Procedural)
        m_kernels->paper(m_plans[std::size_t(level)], block, eta);
    else if (m_image)
        fillImagePaper(*m_image, m_paper, m_grid.view, block, eta);
    else
        std::fill_n(eta, blockSize, 1.0f);
}

} // namespace suffuse::cpu

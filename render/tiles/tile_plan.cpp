#include "render/tiles/tile_plan.h"

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int usualSheet = 2048;
constexpr int together = 8; ///< Strokes are prepared for so many sheets along each side.

int partsOf(qint64 all, qint64 each)
{
    return int((all + each - 1) / each);
}

PixelRect clipped(qint64 left, qint64 top, qint64 right, qint64 bottom, const View &view)
{
    left = std::max<qint64>(left, 0), top = std::max<qint64>(top, 0);
    right = std::min<qint64>(right, view.width), bottom = std::min<qint64>(bottom, view.height);
    return {int(left), int(top), int(right - left), int(bottom - top)};
}

} // namespace

TilePlan::TilePlan(const View &view, const TileOptions &options)
    : m_options(options), m_side(std::max(1, (options.sheet > 0 ? options.sheet : usualSheet) / options.tile))
{
    const Point corner = view.toCanvas({0, 0});
    const int smallest = options.toOne ? 1 : options.tile;
    for (int k = 0;; ++k) {
        TileLevel level;
        level.view = view;
        level.view.width = partsOf(view.width, qint64(1) << k);
        level.view.height = partsOf(view.height, qint64(1) << k);
        if (k > 0) {
            level.view.scale = std::ldexp(view.scale, -k);
            level.view.centre = {corner.x + 0.5 * level.view.width / level.view.scale,
                                 corner.y + 0.5 * level.view.height / level.view.scale};
        }
        level.columns = partsOf(level.view.width, options.tile);
        level.rows = partsOf(level.view.height, options.tile);
        level.sheetColumns = partsOf(level.columns, m_side);
        level.sheetRows = partsOf(level.rows, m_side);
        m_levels.insert(m_levels.begin(), level);
        if (std::max(level.view.width, level.view.height) <= smallest)
            break;
    }
    for (std::size_t i = 1; i < m_levels.size(); ++i) {
        m_levels[i].firstSheet = m_levels[i - 1].firstSheet + m_levels[i - 1].sheets();
        m_levels[i].firstTile = m_levels[i - 1].firstTile + m_levels[i - 1].tiles();
    }
}

TileSheet TilePlan::sheet(qint64 number) const
{
    std::size_t at = m_levels.size() - 1;
    while (m_levels[at].firstSheet > number)
        --at;
    const TileLevel &level = m_levels[at];
    qint64 rest = number - level.firstSheet;
    // Bands of blocks of sheets, blocks in a band, rows of sheets in a block.
    const int band = int(rest / (qint64(together) * level.sheetColumns));
    rest -= qint64(band) * together * level.sheetColumns;
    const int height = std::min(together, level.sheetRows - band * together);
    const int block = int(rest / (qint64(together) * height));
    rest -= qint64(block) * together * height;
    const int width = std::min(together, level.sheetColumns - block * together);
    const int row = band * together + int(rest / width), column = block * together + int(rest % width);

    TileSheet sheet;
    sheet.level = int(at);
    sheet.column = column * m_side;
    sheet.row = row * m_side;
    sheet.columns = std::min(m_side, level.columns - sheet.column);
    sheet.rows = std::min(m_side, level.rows - sheet.row);
    const qint64 side = qint64(m_side) * m_options.tile, more = m_options.overlap;
    sheet.pixels = clipped(column * side - more, row * side - more, (column + 1) * side + more, (row + 1) * side + more,
                           level.view);
    const qint64 blockSide = together * side;
    sheet.near = clipped(block * blockSide - more, band * blockSide - more, (block + 1) * blockSide + more,
                         (band + 1) * blockSide + more, level.view);
    return sheet;
}

PixelRect TilePlan::tile(int level, int column, int row) const
{
    const qint64 side = m_options.tile, more = m_options.overlap;
    return clipped(column * side - more, row * side - more, (column + 1) * side + more, (row + 1) * side + more,
                   m_levels[std::size_t(level)].view);
}

double TilePlan::pixels() const
{
    double all = 0;
    for (const TileLevel &level : m_levels)
        all += double(level.view.width) * level.view.height;
    return all;
}

} // namespace suffuse

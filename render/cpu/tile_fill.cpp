#include "render/cpu/tile_fill.h"

#include "render/nodes/level0.h"

#include <algorithm>
#include <utility>

namespace suffuse::cpu {

namespace {

Rect grownBy(const Rect &r, Point by)
{
    return {r.left - by.x, r.top - by.y, r.right + by.x, r.bottom + by.y};
}

bool meetsFlat(const Rect &area, const BoundaryFlat &flat)
{
    return flat.y >= area.top && flat.y <= area.bottom && flat.left <= area.right && flat.right >= area.left;
}

/// ∫(right − x) dy and ∫dy along a part of an arc that lies between two parameters, by a rule that is exact for cubics.
struct Swept {
    double area = 0, height = 0;

    Swept(const Cubic &curve, double from, double to, double right)
    {
        const QuadratureRule &rule = gaussLegendre(3);
        for (std::size_t i = 0; i < 3; ++i) {
            const double t = from + (to - from) * rule.x[i];
            const double dy = curve.derivative(t).y * rule.weight[i] * (to - from);
            area += (right - curve.at(t).x) * dy;
            height += dy;
        }
    }
};

} // namespace

void TileFill::begin(const SceneFill &fill, const PixelRect &tile)
{
    m_fill = &fill;
    m_tile = tile;
    m_columns = tile.width / blockSide + 1;
    m_lists.resize(std::max(m_lists.size(), std::size_t(m_columns) * std::size_t(tile.height / blockSide + 1)));
    for (BlockList &list : m_lists)
        list.isMade = false;
    m_panels.clear();
    m_flats.clear();
    m_arcs.clear();
    m_all.panels.clear();
    m_all.isMade = false;
    m_lefts.clear();
    m_leftAt.clear();
    m_levelCount = m_rowCount = 0;
    const double more = std::max({0.0, fill.nearby}) + 1;
    const Rect pixels = Rect::of(tile.x, tile.y, tile.width + blockSide, tile.height + blockSide);
    const Rect counted = grownBy(pixels, {std::max(fill.reach.x, more), std::max(fill.reach.y, more)});
    for (std::size_t run = 0; run < fill.panelRuns.size(); ++run)
        if (fill.panelRuns[run].intersects(counted))
            for (std::size_t i = run * fillRun; i < std::min((run + 1) * fillRun, fill.panels.size()); ++i)
                if (fill.panels[i].box.intersects(counted))
                    m_panels.push_back(&fill.panels[i]);
    for (const BoundaryFlat &flat : fill.flats)
        if (meetsFlat(counted, flat))
            m_flats.push_back(&flat);
    if (!fill.crisp && !fill.deep) {
        collectEnds(counted);
        return;
    }
    for (std::size_t run = 0; run < fill.arcRuns.size(); ++run) {
        const Rect &box = fill.arcRuns[run];
        if (box.bottom < counted.top || box.top > counted.bottom || box.left > counted.right)
            continue;
        for (std::size_t i = run * fillRun; i < std::min((run + 1) * fillRun, fill.arcs.size()); ++i) {
            const RisingArc &arc = fill.arcs[i].arc;
            if (arc.bottom() >= counted.top && arc.top() <= counted.bottom && arc.left() <= counted.right)
                m_arcs.push_back(fill.arcs[i]);
        }
    }
}

void TileFill::collectEnds(const Rect &counted)
{
    const SceneFill &fill = *m_fill;
    for (std::size_t run = 0; run < fill.panelRuns.size(); ++run) {
        const Rect &box = fill.panelRuns[run];
        if (box.bottom <= counted.top || box.top > counted.bottom || box.left > counted.right)
            continue;
        for (std::size_t i = run * fillRun; i < std::min((run + 1) * fillRun, fill.panels.size()); ++i) {
            const FillPanel &panel = fill.panels[i];
            if (panel.box.bottom <= counted.top || panel.box.top > counted.bottom || panel.box.left > counted.right)
                continue;
            const auto &p = panel.part.arc.curve.p;
            if (panel.box.right < counted.left)
                m_lefts.push_back({p[0].y, p[3].y, panel.part.enters});
            else
                m_all.panels.push_back({p[0].x, p[0].y, p[3].x, p[3].y, panel.part.enters, panel.begin, panel.end});
        }
    }
    for (const FillLeft &left : fill.lefts)
        if (left.bottom > counted.top && left.top <= counted.bottom)
            m_lefts.push_back(left);
}

int TileFill::leftOfTile(double y)
{
    for (const auto &[height, entered] : m_leftAt)
        if (height == y)
            return entered;
    int entered = 0;
    for (const FillLeft &left : m_lefts)
        entered += left.top <= y && y < left.bottom ? left.enters : 0;
    constexpr std::size_t most = 64;
    if (m_leftAt.size() == most)
        m_leftAt.clear();
    m_leftAt.emplace_back(y, entered);
    return entered;
}

const TileFill::BlockList &TileFill::listAt(double x, double y)
{
    // Lists of so many panels would take gigabytes; most of these count in all blocks anyhow.
    constexpr std::size_t mostListed = 20'000;
    if (m_all.panels.size() > mostListed) {
        if (!std::exchange(m_all.isMade, true))
            m_all.flats = m_flats;
        return m_all;
    }
    const int column = int(x - m_tile.x) / blockSide, row = int(y - m_tile.y) / blockSide;
    BlockList &list = m_lists[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)];
    if (list.isMade)
        return list;
    list.isMade = true;
    list.panels.clear(), list.flats.clear();
    const Rect region = grownBy(
        Rect::of(m_tile.x + column * blockSide, m_tile.y + row * blockSide, blockSide, blockSide), m_fill->reach);
    for (const Ends &ends : m_all.panels)
        if (ends.y1 > region.top && ends.y0 <= region.bottom && std::min(ends.x0, ends.x1) <= region.right)
            list.panels.push_back(ends);
    for (const BoundaryFlat *flat : m_flats)
        if (flat->y > region.top && flat->y <= region.bottom && flat->left <= region.right)
            list.flats.push_back(flat);
    return list;
}

TileFill::Region TileFill::look(const BlockList &list, const Rect &region, bool collect, Point centre)
{
    Region found;
    found.base = leftOfTile(region.top);
    const auto event = [&](double y, int jump) {
        m_eventY.push_back(float(y - centre.y));
        m_eventJump.push_back(float(jump));
    };
    for (const Ends &p : list.panels) {
        if (p.y1 <= region.top || p.y0 > region.bottom || std::min(p.x0, p.x1) > region.right)
            continue;
        if (std::max(p.x0, p.x1) < region.left) {
            found.base += p.y0 <= region.top ? p.enters : 0;
            continue;
        }
        found.isMet = true;
        if (!collect)
            continue;
        if (p.x0 < region.left && p.y0 > region.top)
            event(p.y0, -p.enters);
        else if (p.x1 < region.left)
            event(p.y1, p.enters);
        const std::size_t most = m_nodeCount + (p.endNode - p.firstNode);
        if (most > m_x.size())
            m_x.resize(2 * most), m_y.resize(2 * most), m_weight.resize(2 * most);
        for (std::uint32_t k = p.firstNode; k < p.endNode; ++k) {
            const FillNode &node = m_fill->nodes[k];
            m_x[m_nodeCount] = float(node.x - centre.x);
            m_y[m_nodeCount] = float(node.y - centre.y);
            m_weight[m_nodeCount] = float(node.weight);
            // Beyond the region it would add nothing. Left of it, it belongs to its panel.
            m_nodeCount += (node.y >= region.top) & (node.y <= region.bottom) & (node.x <= region.right);
        }
    }
    for (const BoundaryFlat *flat : list.flats) {
        if (flat->y <= region.top || flat->y > region.bottom || flat->left > region.right || flat->right < region.left)
            continue;
        found.isMet = true;
        if (collect && flat->left < region.left)
            event(flat->y, flat->jump);
    }
    return found;
}

bool TileFill::meets(const RisingArc &arc, const Rect &square)
{
    if (!(arc.top() < square.bottom && arc.bottom() > square.top && arc.left() < square.right &&
          arc.right() > square.left))
        return false;
    const double a = arc.top() >= square.top ? arc.curve.p[0].x : arc.xAt(square.top);
    const double b = arc.bottom() <= square.bottom ? arc.curve.p[3].x : arc.xAt(square.bottom);
    return std::max(a, b) > square.left && std::min(a, b) < square.right;
}

int TileFill::entered(Point at)
{
    const auto known = std::find_if(m_levels.begin(), m_levels.begin() + std::ptrdiff_t(m_levelCount),
                                    [at](const Level &level) { return level.y == at.y; });
    Level *level = nullptr;
    if (known != m_levels.begin() + std::ptrdiff_t(m_levelCount)) {
        level = &*known;
    } else {
        constexpr std::size_t most = 64;
        if (m_levelCount == most)
            m_levelCount = 0;
        if (m_levels.size() == m_levelCount)
            m_levels.emplace_back();
        level = &m_levels[m_levelCount++];
        level->y = at.y;
        level->crossings.clear();
        for (const BoundaryArc &part : m_arcs)
            if (part.arc.top() <= at.y && at.y < part.arc.bottom())
                level->crossings.emplace_back(part.arc.xAt(at.y), part.enters);
    }
    int entered = 0;
    for (const auto &[x, enters] : level->crossings)
        entered += x < at.x ? enters : 0;
    return std::clamp(entered, 0, 1);
}

const std::vector<const BoundaryArc *> &TileFill::arcsBetween(double top, double bottom)
{
    for (std::size_t k = 0; k < m_rowCount; ++k)
        if (m_rows[k].top == top && m_rows[k].bottom == bottom)
            return m_rows[k].arcs;
    constexpr std::size_t most = 64;
    if (m_rowCount == most)
        m_rowCount = 0;
    if (m_rows.size() == m_rowCount)
        m_rows.emplace_back();
    Row &row = m_rows[m_rowCount++];
    row.top = top, row.bottom = bottom;
    row.arcs.clear();
    for (const BoundaryArc &part : m_arcs)
        if (part.arc.top() < bottom && part.arc.bottom() > top)
            row.arcs.push_back(&part);
    return row.arcs;
}

const TileFill::Near &TileFill::near(const Rect &counted)
{
    m_near.panels.clear();
    m_near.flats.clear();
    for (const FillPanel *panel : m_panels)
        if (panel->box.intersects(counted))
            m_near.panels.push_back(panel);
    for (const BoundaryFlat *flat : m_flats)
        if (meetsFlat(counted, *flat))
            m_near.flats.push_back(flat);
    return m_near;
}

FillPresence TileFill::presence(int x, int y)
{
    if (m_fill->deep)
        return FillPresence::Outline;
    const Rect area = Rect::of(x, y, blockSide, blockSide);
    if (m_fill->crisp) {
        if (!near(area).isEmpty())
            return FillPresence::Outline;
        return entered(area.centre()) ? FillPresence::Inside : FillPresence::Nothing;
    }
    const Region found = look(listAt(x, y), grownBy(area, m_fill->reach), false);
    return found.isMet ? FillPresence::Outline : found.base ? FillPresence::Inside : FillPresence::Nothing;
}

/// Loops over a row of a cell, one for each thing, so that compilers make vectors of them.
void TileFill::addCell(const Block &block, int i0, int j0, int channels, const FillCellSums &cell, Sums &sums) const
{
    const float density = float(m_fill->density), half = -0.5f * density;
    const auto &h = m_fill->half;
    const Point s = m_fill->placeSlope;
    const double pullX = s.x * h[0] + s.y * h[1], pullY = s.x * h[1] + s.y * h[2]; // of the slopes on the mean place
    std::array<float, cellSide> own, place{};
    for (int j = 0; j < cellSide; ++j) {
        const int at = (j0 + j) * blockSide + i0;
        const float *const share = cell.density + j * cellSide, *const slopeX = cell.slopeX + j * cellSide,
                           *const slopeY = cell.slopeY + j * cellSide;
        for (std::size_t i = 0; i < cellSide; ++i)
            own[i] = density * share[i];
        float *const sum = sums.v[0] + at, *const sumX = sums.v[1] + at, *const sumY = sums.v[2] + at;
        for (std::size_t i = 0; i < cellSide; ++i)
            sum[i] += own[i];
        for (std::size_t i = 0; i < cellSide; ++i)
            sumX[i] += half * slopeX[i];
        for (std::size_t i = 0; i < cellSide; ++i)
            sumY[i] += half * slopeY[i];
        if (channels > 0 && m_fill->hasGradient) {
            const double first =
                m_fill->placeAt(block.x + (i0 + 0.5) * block.step, block.y + (j0 + j + 0.5) * block.step);
            for (std::size_t i = 0; i < cellSide; ++i) {
                const double pull = pullX * double(slopeX[i]) + pullY * double(slopeY[i]);
                const double mean = first + double(i) * (s.x * block.step) + pull / std::max(double(share[i]), 1e-30);
                place[i] = float(std::min(std::max(mean, 0.0), 1.0));
            }
        }
        for (int c = 0; c < channels; ++c) {
            const float from = m_fill->from[std::size_t(c)], step = m_fill->step[std::size_t(c)];
            float *const channel = sums.v[fixedSums + c] + at;
            for (std::size_t i = 0; i < cellSide; ++i)
                channel[i] += own[i] * (from + place[i] * step);
        }
    }
}

void TileFill::addConstant(const Block &block, int i0, int j0, int channels, Sums &sums) const
{
    const float density = float(m_fill->density);
    std::array<float, cellSide> place{}; // on the gradient
    for (int j = j0; j < j0 + cellSide; ++j) {
        const int at = j * blockSide + i0;
        for (int i = 0; i < cellSide; ++i)
            sums.v[0][at + i] += density;
        if (m_fill->hasGradient && channels > 0) {
            const double first = m_fill->placeAt(block.x + (i0 + 0.5) * block.step, block.y + (j + 0.5) * block.step);
            for (std::size_t i = 0; i < cellSide; ++i) {
                const double along = first + double(i) * (m_fill->placeSlope.x * block.step);
                place[i] = float(std::min(std::max(along, 0.0), 1.0));
            }
        }
        for (int c = 0; c < channels; ++c) {
            const float from = m_fill->from[std::size_t(c)], step = m_fill->step[std::size_t(c)];
            for (int i = 0; i < cellSide; ++i)
                sums.v[fixedSums + c][at + i] += density * (from + place[std::size_t(i)] * step);
        }
    }
}

void TileFill::addTo(const Kernels &kernels, const Block &block, int channels, Sums &sums)
{
    const double side = cellSide * block.step;
    const BlockList &list = listAt(block.x, block.y);
    for (int j0 = 0; j0 < blockSide; j0 += cellSide)
        for (int i0 = 0; i0 < blockSide; i0 += cellSide) {
            const double x = block.x + i0 * block.step, y = block.y + j0 * block.step;
            const Rect region = grownBy(Rect::of(x, y, side, side), m_fill->reach);
            const Point centre{x + 0.5 * side, y + 0.5 * side};
            m_nodeCount = 0, m_eventY.clear(), m_eventJump.clear();
            const Region found = look(list, region, true, centre);
            if (!found.isMet) {
                if (found.base)
                    addConstant(block, i0, j0, channels, sums);
                continue;
            }
            const FillCell cell{float(m_fill->a),  float(m_fill->b), float(m_fill->c),   float(block.step),
                                float(found.base), m_eventY.data(),  m_eventJump.data(), int(m_eventY.size()),
                                m_x.data(),        m_y.data(),       m_weight.data(),    int(m_nodeCount)};
            FillCellSums own;
            kernels.fillCell(cell, own);
            addCell(block, i0, j0, channels, own, sums);
        }
}

bool TileFill::isLevel(int channels) const
{
    return !m_fill->hasGradient || channels == 0;
}

void TileFill::setInside(int channels, Sums &sums) const
{
    const float density = float(m_fill->density);
    for (int i = 0; i < int(boxRun); ++i) {
        sums.v[0][i] = density, sums.v[1][i] = sums.v[2][i] = 0;
        for (int c = 0; c < channels; ++c)
            sums.v[fixedSums + c][i] = density * m_fill->from[std::size_t(c)];
    }
}

void TileFill::addInside(const Block &block, int channels, Sums &sums) const
{
    for (int j0 = 0; j0 < blockSide; j0 += cellSide)
        for (int i0 = 0; i0 < blockSide; i0 += cellSide)
            addConstant(block, i0, j0, channels, sums);
}

void TileFill::cover(const Block &block, float *covered)
{
    for (int j0 = 0; j0 < blockSide; j0 += cellSide)
        for (int i0 = 0; i0 < blockSide; i0 += cellSide)
            coverCell({block.x + i0 * block.step, block.y + j0 * block.step}, block.step, covered + j0 * blockSide + i0,
                      blockSide);
}

/// The area of each sample that lies right of what enters and left of what leaves, in samples. What lies left of the
/// cell counts by the heights that it takes there, and what lies in the cell by its areas. So an outline through a
/// corner of the cell, whose side is a matter of rounding, moves next to nothing from one sum to the other.
void TileFill::coverCell(Point corner, double step, float *covered, int stride)
{
    const double side = cellSide * step;
    const Rect area = Rect::of(corner.x, corner.y, side, side);
    const Near &near = this->near(area);
    if (near.isEmpty()) {
        const auto inside = float(entered(area.centre()));
        for (int row = 0; row < cellSide; ++row)
            std::fill_n(covered + row * stride, cellSide, inside);
        return;
    }
    std::array<std::array<double, cellSide>, cellSide> cover{}; // by row and column
    std::array<double, cellSide> base{};                        // of each row
    const auto inRow = [&](double y, int row) { return std::clamp((y - corner.y) / step - row, 0.0, 1.0); };
    for (const BoundaryArc *part : arcsBetween(area.top, area.bottom)) {
        const RisingArc &arc = part->arc;
        if (arc.left() >= area.left)
            continue;
        double from = std::max(arc.top(), area.top), to = std::min(arc.bottom(), area.bottom);
        if (arc.right() > area.left) {
            const double crossing = std::clamp(arc.curve.at(arc.parameterAtX(area.left)).y, from, to);
            (arc.curve.p[0].x < arc.curve.p[3].x ? to : from) = crossing;
        }
        for (int row = 0; row < cellSide; ++row)
            base[std::size_t(row)] += part->enters * (inRow(to, row) - inRow(from, row));
    }
    for (const FillPanel *panel : near.panels) {
        const RisingArc &arc = panel->part.arc;
        const double from = std::max(arc.top(), area.top), to = std::min(arc.bottom(), area.bottom);
        if (!(from < to))
            continue;
        // Where it crosses the borders of samples, between which it is integrated.
        std::vector<double> &cuts = m_cuts;
        cuts.assign({arc.parameterAtY(from), arc.parameterAtY(to)});
        for (int k = 0; k <= cellSide; ++k) {
            if (const double y = corner.y + k * step; y > from && y < to)
                cuts.push_back(arc.parameterAtY(y));
            if (const double x = corner.x + k * step; x > arc.left() && x < arc.right())
                if (const double t = arc.parameterAtX(x); t > cuts[0] && t < cuts[1])
                    cuts.push_back(t);
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const Point middle = arc.curve.at(0.5 * (cuts[k] + cuts[k + 1]));
            // An upright arc on a border must not be on either side of it by rounding.
            const double column = (std::clamp(middle.x, arc.left(), arc.right()) - corner.x) / step;
            if (column < 0 || column >= cellSide)
                continue; // What lies left of the cell is in the base.
            const int row = std::clamp(int((middle.y - corner.y) / step), 0, cellSide - 1), first = int(column);
            const Swept swept(arc.curve, cuts[k], cuts[k + 1], corner.x + (first + 1) * step);
            cover[std::size_t(row)][std::size_t(first)] += panel->part.enters * swept.area / (step * step);
            for (int right = first + 1; right < cellSide; ++right)
                cover[std::size_t(row)][std::size_t(right)] += panel->part.enters * swept.height / step;
        }
    }
    for (int row = 0; row < cellSide; ++row)
        for (int column = 0; column < cellSide; ++column) {
            constexpr double rounding = 1e-9; // Beside the outline nothing is covered, or everything.
            const double sum = base[std::size_t(row)] + cover[std::size_t(row)][std::size_t(column)];
            covered[row * stride + column] = sum < rounding ? 0.0f : sum > 1 - rounding ? 1.0f : float(sum);
        }
}

} // namespace suffuse::cpu

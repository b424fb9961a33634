#include "render/cuda/fill_records.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace suffuse::cuda {

namespace {

constexpr std::int32_t farLeft = -(std::int32_t(1) << 30) - (std::int32_t(1) << 29);

/// Returns a coordinate in 1/fillUnits px. What is far beyond any picture is cut off.
std::int32_t inUnits(double pixels)
{
    constexpr double limit = double(farLeft);
    return std::int32_t(std::clamp(std::floor(pixels * fillUnits), limit, -limit));
}

FillRecord placed(Point at)
{
    FillRecord r;
    const auto cell = [](double v) { return std::int32_t(std::floor(std::clamp(v, -1e9, 1e9) / tileSide)); };
    r.cellX = cell(at.x), r.cellY = cell(at.y);
    r.x = float(at.x - double(tileSide) * r.cellX), r.y = float(at.y - double(tileSide) * r.cellY);
    return r;
}

std::int32_t kindOf(int jump, std::int32_t flags)
{
    return jump * 256 + flags;
}

void setEnds(FillRecord &r, Point from, Point to, double y)
{
    r.x0 = inUnits(from.x), r.y0 = inUnits(from.y), r.x1 = inUnits(to.x), r.y1 = inUnits(to.y);
    r.up = float(from.y - y), r.down = float(to.y - y);
}

class FillRecordMaker {
public:
    explicit FillRecordMaker(const SceneFill &fill) : m_fill(fill) {}

    std::vector<NodeRecord> make()
    {
        m_out.reserve(m_fill.nodes.size() + m_fill.flats.size() + m_fill.lefts.size() +
                      (hasCurves() ? 2 * m_fill.panels.size() : 0));
        if (hasCurves())
            for (const FillPanel &panel : m_fill.panels)
                addCurve(panel);
        for (const FillPanel &panel : m_fill.panels)
            addNodes(panel);
        for (const BoundaryFlat &flat : m_fill.flats) {
            FillRecord r = placed({std::max(flat.left, -1e9), flat.y});
            setEnds(r, {flat.left, flat.y}, {flat.right, flat.y}, flat.y);
            r.kind = kindOf(flat.jump, fillTells | fillFlat);
            add(r);
        }
        for (const FillLeft &left : m_fill.lefts) {
            FillRecord r;
            r.x0 = r.x1 = farLeft;
            r.y0 = inUnits(left.top), r.y1 = inUnits(left.bottom);
            r.kind = kindOf(left.enters, fillTells);
            add(r);
        }
        return std::move(m_out);
    }

private:
    bool hasCurves() const { return m_fill.crisp || m_fill.level > 0; }

    template <class Record>
    void add(const Record &record)
    {
        m_out.push_back(std::bit_cast<NodeRecord>(record));
    }

    void addCurve(const FillPanel &panel)
    {
        const auto &p = panel.part.arc.curve.p;
        FillRecord r = placed(p[0]);
        setEnds(r, p[0], p[3], p[0].y);
        r.kind = kindOf(panel.part.enters, std::int32_t(fillShape) + (m_fill.crisp ? std::int32_t(fillTells) : 0));
        add(r);
        FillCurveRecord c;
        c.x1 = float(p[1].x - p[0].x), c.y1 = float(p[1].y - p[0].y);
        c.x2 = float(p[2].x - p[0].x), c.y2 = float(p[2].y - p[0].y);
        c.x3 = float(p[3].x - p[0].x), c.y3 = float(p[3].y - p[0].y);
        add(c);
    }

    void addNodes(const FillPanel &panel)
    {
        const auto &p = panel.part.arc.curve.p;
        for (std::uint32_t i = panel.begin; i < panel.end; ++i) {
            const FillNode &node = m_fill.nodes[i];
            FillRecord r = placed({node.x, node.y});
            r.weight = float(node.weight);
            setEnds(r, p[0], p[3], node.y);
            r.kind =
                kindOf(panel.part.enters, std::int32_t(fillNode) + (i == panel.begin ? std::int32_t(fillTells) : 0));
            add(r);
        }
    }

    const SceneFill &m_fill;
    std::vector<NodeRecord> m_out;
};

/// Returns how far the fill counts along each axis, px. The places of nodes and samples are off by less than what is
/// added.
Point countedReach(const SceneFill &fill)
{
    const double near = fill.level > 0 ? fill.nearby : 0;
    return {std::max(fill.reach.x, near) + 2.0 / fillUnits, std::max(fill.reach.y, near) + 2.0 / fillUnits};
}

} // namespace

std::vector<NodeRecord> fillRecords(const SceneFill &fill)
{
    return FillRecordMaker(fill).make();
}

ChunkRecord fillChunkOf(const SceneFill &fill, const std::vector<NodeRecord> &records, std::size_t begin,
                        std::size_t end, int width, int height)
{
    double left = 1e30, top = 1e30, bottom = -1e30;
    for (std::size_t i = begin; i < end; ++i) {
        const FillRecord r = std::bit_cast<FillRecord>(records[i]);
        if (r.kind == 0)
            continue;
        left = std::min(left, double(std::min(r.x0, r.x1)) / fillUnits);
        top = std::min(top, double(r.y0) / fillUnits), bottom = std::max(bottom, double(r.y1) / fillUnits);
    }
    const Point reach = countedReach(fill);
    const auto cut = [](double v, int size) { return std::int32_t(std::clamp(v, 0.0, double(size))); };
    ChunkRecord chunk;
    chunk.left = cut(std::floor(left - reach.x - 1), width);
    // Right of a part of the boundary it tells what is inside, as far as the fill goes.
    chunk.right = cut(fill.bounds.x + fill.bounds.width, width);
    chunk.top = cut(std::floor(top - reach.y - 1), height);
    chunk.bottom = cut(std::ceil(bottom + reach.y + 1), height);
    chunk.firstNode = std::uint32_t(begin);
    chunk.nodes = std::uint32_t(end - begin) | fillChunk;
    return chunk;
}

FillValues fillValues(const SceneFill &fill)
{
    FillValues v;
    const Point reach = countedReach(fill);
    v.reachX = inUnits(reach.x) + 1, v.reachY = inUnits(reach.y) + 1;
    v.along = float(fill.a), v.down = float(fill.c);
    v.a = fill.a, v.b = fill.b, v.c = fill.c;
    v.density = fill.density;
    if (fill.hasGradient)
        v.place = fill.place, v.placeX = fill.placeSlope.x, v.placeY = fill.placeSlope.y;
    std::copy(fill.half.begin(), fill.half.end(), v.half);
    std::copy(fill.from.begin(), fill.from.end(), v.from);
    std::copy(fill.step.begin(), fill.step.end(), v.step);
    v.nearby = fill.nearby;
    if (fill.deep) {
        v.deepColumn = fill.deepColumn, v.deepRow = fill.deepRow, v.deepColumns = fill.deepColumns;
        v.deepRows = std::int32_t(fill.deepSquares.size()) / std::max(fill.deepColumns, 1);
    }
    return v;
}

std::vector<DeepRecord> deepFillRecords(const SceneFill &fill)
{
    std::vector<DeepRecord> out(fill.deepSquares.size());
    for (std::size_t i = 0; i < fill.deepSquares.size(); ++i) {
        const DeepFillSquare &square = fill.deepSquares[i];
        out[i].x = double(out.size());
        out[i].y = double(square.events.size() + square.nodes.size());
        out[i].weight = square.entered;
        for (const FillEvent &event : square.events)
            out.push_back({0, event.y, 0, 0, 0, double(event.jump), 1, 0});
        for (const FillNode &node : square.nodes)
            out.push_back({node.x, node.y, 0, 0, 0, node.weight, 0, 0});
    }
    return out;
}

void noteFill(const SceneFill &fill, StrokeRecord &record)
{
    const auto flag = [](bool is, FillFlag value) { return is ? std::uint32_t(value) : 0; };
    record.fill = haveFill | flag(fill.crisp, crispFill) | flag(fill.level > 0, thinFill) | flag(fill.deep, deepFill) |
                  flag(fill.hasGradient, gradientFill) | std::uint32_t(fill.level) * fillLevel;
    record.fillDensity = float(fill.density);
    record.fillSteepest = fill.crisp ? 0 : float(fill.steepest);
}

} // namespace suffuse::cuda

#include "render/reference/sums.h"

#include <cmath>

namespace suffuse::reference {

namespace {

/// out += k·in. It is separate from its caller so that the compiler sees that nothing overlaps.
void addScaled(double *__restrict out, const double *__restrict in, double k, int n)
{
    for (int i = 0; i < n; ++i)
        out[i] += k * in[i];
}

void addSeparable(double *__restrict density, double *__restrict gradientX, double *__restrict gradientY,
                  const double *__restrict column, const double *__restrict columnX, double row, double rowY, int n)
{
    for (int i = 0; i < n; ++i) {
        density[i] += column[i] * row;
        gradientX[i] += columnX[i] * row;
        gradientY[i] += column[i] * rowY;
    }
}

} // namespace

SampleBlock::Range SampleBlock::range(double lo, double hi, double start, int n) const
{
    // They are compared before they become integers, which could not hold them far away.
    const double from = std::clamp(std::ceil((lo - start) / step), 0.0, double(n));
    const double to = std::clamp(std::floor((hi - start) / step) + 1, 0.0, double(n));
    return {int(from), int(to)};
}

void StrokeSums::evaluate(const StrokeSource &stroke, const SampleBlock &block)
{
    m_block = block;
    const std::size_t samples = std::size_t(block.nx) * std::size_t(block.ny);
    for (auto *sum : {&m_density, &m_lifted, &m_faded, &m_gradientX, &m_gradientY})
        sum->assign(samples, 0.0);
    m_channels.resize(std::max(m_channels.size(), stroke.channels));
    for (std::size_t c = 0; c < stroke.channels; ++c)
        m_channels[c].assign(samples, 0.0);
    for (auto *own : {&m_own, &m_ownX, &m_ownY})
        own->resize(samples);
    m_column.resize(std::size_t(block.nx));
    m_columnX.resize(std::size_t(block.nx));
    for (const SegmentSource &segment : stroke.segments)
        if (segment.factor > 0 && segment.box.intersects(block.area()))
            addSegment(segment);
    m_covered.clear();
    if (stroke.fill)
        addFill(*stroke.fill);
}

void StrokeSums::addFill(const FillSource &fill)
{
    if (fill.crisp())
        m_covered.assign(m_density.size(), 0.0);
    for (int j = 0; j < m_block.ny; ++j)
        for (int i = 0; i < m_block.nx; ++i) {
            const Point x = m_block.first + m_block.step * Point{double(i), double(j)};
            const std::size_t s = index(i, j);
            if (fill.crisp()) {
                m_covered[s] = fill.covered(x, m_block.step);
                continue;
            }
            const FillSample sample = fill.at(x);
            m_density[s] += sample.density;
            m_gradientX[s] += sample.gradient.x;
            m_gradientY[s] += sample.gradient.y;
            for (std::size_t c = 0; c < fill.channels().size(); ++c)
                m_channels[c][s] += sample.density * fill.channelAt(c, sample.place);
        }
}

void StrokeSums::addSegment(const SegmentSource &segment)
{
    const auto columns = m_block.columns(segment.box.left, segment.box.right);
    const auto rows = m_block.rows(segment.box.top, segment.box.bottom);
    if (columns.isEmpty() || rows.isEmpty())
        return;
    const int n = columns.to - columns.from;
    for (int j = rows.from; j < rows.to; ++j)
        for (auto *own : {&m_own, &m_ownX, &m_ownY})
            std::fill_n(own->begin() + std::ptrdiff_t(index(columns.from, j)), n, 0.0);

    const auto missesBlock = [&](const Rect &box) {
        const Rect reached = box.grown(segment.reach);
        return m_block.columns(reached.left, reached.right).isEmpty() ||
               m_block.rows(reached.top, reached.bottom).isEmpty();
    };
    const std::vector<Panel> *panels = &segment.panels;
    if (segment.onTheFly) {
        m_panels.clear();
        appendPanels(segment.curve, segment.kernel, missesBlock, m_panels);
        panels = &m_panels;
    }
    for (const Panel &panel : *panels) {
        if (missesBlock(panel.box))
            continue;
        for (const Node &node : nodesOf(panel))
            segment.kernel.isotropic ? addNode(node, segment) : addAnisotropicNode(node, segment);
    }

    for (int j = rows.from; j < rows.to; ++j) {
        const std::size_t start = index(columns.from, j);
        if (segment.fades) {
            addScaled(&m_faded[start], &m_own[start], 1, n);
            continue;
        }
        const double sign = segment.lifts ? -1 : 1;
        addScaled(segment.lifts ? &m_lifted[start] : &m_density[start], &m_own[start], 1, n);
        addScaled(&m_gradientX[start], &m_ownX[start], sign, n);
        addScaled(&m_gradientY[start], &m_ownY[start], sign, n);
        if (segment.lifts)
            continue;
        for (std::size_t c = 0; c < segment.channels.size(); ++c)
            if (segment.channels[c] != 0)
                addScaled(&m_channels[c][start], &m_own[start], segment.channels[c], n);
    }
}

void StrokeSums::addNode(const Node &node, const SegmentSource &segment)
{
    // e^(−(dx² + dy²)/s²) = e^(−dx²/s²) · e^(−dy²/s²) is exact, and needs an exponential for each row and column
    // instead of one for each pixel.
    const double inverse = 1 / segment.kernel.smallerSpread;
    const auto columns = m_block.columns(node.at.x - segment.reach, node.at.x + segment.reach);
    const auto rows = m_block.rows(node.at.y - segment.reach, node.at.y + segment.reach);
    if (columns.isEmpty() || rows.isEmpty())
        return;
    for (int i = columns.from; i < columns.to; ++i) {
        const double d = (m_block.first.x + m_block.step * i - node.at.x) * inverse;
        const double e = segment.factor * node.weight * std::exp(-d * d);
        m_column[std::size_t(i)] = e;
        m_columnX[std::size_t(i)] = -2 * d * inverse * e;
    }
    const std::size_t from = std::size_t(columns.from);
    for (int j = rows.from; j < rows.to; ++j) {
        const double d = (m_block.first.y + m_block.step * j - node.at.y) * inverse;
        const double e = std::exp(-d * d);
        const std::size_t start = index(columns.from, j);
        addSeparable(&m_own[start], &m_ownX[start], &m_ownY[start], &m_column[from], &m_columnX[from], e,
                     -2 * d * inverse * e, columns.to - columns.from);
    }
}

void StrokeSums::addAnisotropicNode(const Node &node, const SegmentSource &segment)
{
    const auto columns = m_block.columns(node.at.x - segment.reach, node.at.x + segment.reach);
    const auto rows = m_block.rows(node.at.y - segment.reach, node.at.y + segment.reach);
    const Kernel &k = segment.kernel;
    for (int j = rows.from; j < rows.to; ++j) {
        for (int i = columns.from; i < columns.to; ++i) {
            const Point x{m_block.first.x + m_block.step * i, m_block.first.y + m_block.step * j};
            const Point q = k.whiten(x - node.at);
            const double f = segment.factor * node.weight * std::exp(-dot(q, q));
            m_own[index(i, j)] += f;
            m_ownX[index(i, j)] += -2 * f * (k.a11 * q.x + k.a21 * q.y);
            m_ownY[index(i, j)] += -2 * f * (k.a12 * q.x + k.a22 * q.y);
        }
    }
}

LocalDensity StrokeSums::at(const StrokeSource &stroke, int i, int j, bool inside) const
{
    const std::size_t s = index(i, j);
    LocalDensity local;
    FillSample area;
    if (inside)
        area = stroke.fill->inside(m_block.first + m_block.step * Point{double(i), double(j)});
    const auto channelSum = [&](std::size_t c) {
        return m_channels[c][s] + (inside ? area.density * stroke.fill->channelAt(c, area.place) : 0);
    };
    const double laid = m_density[s] + area.density;
    local.density = laid - m_lifted[s];
    local.lifted = m_lifted[s] / laid;
    local.faded = m_faded[s];
    local.slope = std::hypot(m_gradientX[s], m_gradientY[s]);
    local.granulation = channelSum(GranulationChannel) / laid;
    for (std::size_t c = 0; c < 4; ++c)
        local.colour[c] = channelSum(ColourChannel + c) / laid;
    if (stroke.kinds.empty()) {
        local.styleCount = 1;
        local.styles[0] = {stroke.style.kind, 1, {stroke.style.xi[0], stroke.style.xi[1], stroke.style.xi[2]}};
        return local;
    }
    for (std::size_t n = 0; n < stroke.kinds.size(); ++n) {
        const std::size_t channel = FirstStyleChannel + 4 * n;
        const double sum = channelSum(channel);
        if (!(sum > 0))
            continue;
        StyleShare &style = local.styles[std::size_t(local.styleCount++)];
        style.kind = stroke.kinds[n];
        style.share = sum / laid;
        for (std::size_t x = 0; x < 3; ++x)
            style.xi[x] = channelSum(channel + 1 + x) / sum;
    }
    return local;
}

} // namespace suffuse::reference

#include "app/session/frames/floating_layers.h"

#include "render/threads/parallel.h"

#include <QImage>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace suffuse {

namespace {

constexpr int squareSide = 64; ///< pixels of the frame
constexpr int cellSide = 32;   ///< pixels of the layer

/// A premultiplied pixel over an opaque one, within a level. Compilers make vectors of it.
std::uint32_t laidOver(std::uint32_t below, std::uint32_t above)
{
    constexpr std::uint32_t redBlue = 0x00FF00FF, green = 0x0000FF00, opaque = 0xFF000000;
    std::uint32_t through = 255 - (above >> 24);
    through += through >> 7; // of 256
    return (above + (((below & redBlue) * through >> 8) & redBlue) + (((below & green) * through >> 8) & green)) |
           opaque;
}

std::uint32_t premultiplied(std::uint32_t argb)
{
    const std::uint32_t alpha = argb >> 24;
    if (alpha == 255)
        return argb;
    const auto scaled = [&](int shift) { return ((argb >> shift & 255) * alpha + 127) / 255 << shift; };
    return alpha << 24 | scaled(16) | scaled(8) | scaled(0);
}

/// The larger view that the layer shows, `factor` times coarser.
View viewOfLayer(View view, int factor)
{
    view.width = (view.width + 2 * FloatingLayers::margin + factor - 1) / factor;
    view.height = (view.height + 2 * FloatingLayers::margin + factor - 1) / factor;
    view.scale /= factor;
    return view;
}

} // namespace

void FloatingLayers::setRest(const LiftPtr &lift, Picture8 rest, bool fine)
{
    m_rest = std::move(rest);
    m_restOf = lift;
    m_restIsFine = fine;
}

Result<bool> FloatingLayers::draw(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel)
{
    const RenderRequest request{lift->lifted, lift->time, viewOfLayer(lift->view, factor), true};
    const Result<RenderStats> stats = m_renderer->render(request, m_drawn, cancel);
    if (!stats)
        return Error{stats.error()};
    if (stats->cancelled)
        return false;
    m_of = lift;
    m_factor = factor;
    m_layerIsFine = factor == 1;
    takeOver(m_drawn);
    return true;
}

void FloatingLayers::take(const LiftPtr &lift, const Picture8 &picture, std::uint32_t paper, bool fine)
{
    const View around = viewOfLayer(lift->view, 1);
    Picture8 layer;
    layer.resize(around.width, around.height);
    std::fill(layer.argb.begin(), layer.argb.end(), 0);
    for (int y = 0; y < picture.height; ++y) {
        const auto row = picture.argb.begin() + std::ptrdiff_t(y) * picture.width;
        std::replace_copy(row, row + picture.width,
                          layer.argb.begin() + std::ptrdiff_t(y + margin) * around.width + margin, paper, 0u);
    }
    m_of = lift;
    m_factor = 1;
    m_layerIsFine = fine;
    takeOver(layer);
}

void FloatingLayers::takeOver(const Picture8 &drawn)
{
    m_width = drawn.width;
    m_height = drawn.height;
    m_columns = (m_width + cellSide - 1) / cellSide;
    m_rows = (m_height + cellSide - 1) / cellSide;
    m_layer.resize(drawn.argb.size());
    m_painted.assign(std::size_t(m_columns) * std::size_t(m_rows), 0);
    for (int y = 0; y < m_height; ++y)
        for (int x = 0; x < m_width; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(m_width) + std::size_t(x);
            m_layer[at] = premultiplied(drawn.argb[at]);
            if (m_layer[at] != 0)
                m_painted[std::size_t(y / cellSide * m_columns + x / cellSide)] = 1;
        }
}

FloatingLayers::Placing FloatingLayers::placingUnder(const Affine &map) const
{
    const View &view = m_of->view;
    const View layer = viewOfLayer(view, m_factor);
    const Affine back = map.inverse().value_or(Affine());
    const auto at = [&](double x, double y) { // pixels by their middles, as indices
        return layer.toPixels(back(view.toCanvas({x + 0.5, y + 0.5}))) - Point{0.5, 0.5};
    };
    const double w = view.width, h = view.height; // far apart, for precision
    const Point base = at(0, 0);
    Placing placing{base, (1 / w) * (at(w, 0) - base), (1 / h) * (at(0, h) - base)};
    if (isWholePixels(placing))
        placing.base = {std::round(base.x), std::round(base.y)};
    return placing;
}

/// Moved alone: a picture on whole pixels stays sharp.
bool FloatingLayers::isWholePixels(const Placing &placing) const
{
    constexpr double tiny = 1e-6;
    return m_factor == 1 && length(placing.right - Point{1, 0}) < tiny && length(placing.down - Point{0, 1}) < tiny;
}

PixelRect FloatingLayers::square(std::size_t i) const
{
    const int columns = (m_rest.width + squareSide - 1) / squareSide;
    const int x = int(i) % columns * squareSide, y = int(i) / columns * squareSide;
    return {x, y, std::min(squareSide, m_rest.width - x), std::min(squareSide, m_rest.height - y)};
}

/// Whether a box of layer pixels has any.
bool FloatingLayers::hasPaint(double left, double top, double right, double bottom) const
{
    const auto cell = [](double pixel, int count) {
        return int(std::clamp(std::floor(pixel / cellSide), -1.0, double(count)));
    };
    const int x0 = std::max(cell(left, m_columns), 0), x1 = std::min(cell(right, m_columns), m_columns - 1);
    const int y0 = std::max(cell(top, m_rows), 0), y1 = std::min(cell(bottom, m_rows), m_rows - 1);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            if (m_painted[std::size_t(y * m_columns + x)])
                return true;
    return false;
}

std::vector<char> FloatingLayers::squaresUnder(const Placing &placing) const
{
    const int columns = (m_rest.width + squareSide - 1) / squareSide;
    const int rows = (m_rest.height + squareSide - 1) / squareSide;
    std::vector<char> covered(std::size_t(columns) * std::size_t(rows));
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const PixelRect r = square(i);
        Rect box;
        for (const int x : {r.x, r.x + r.width})
            for (const int y : {r.y, r.y + r.height})
                box.include(placing(x, y));
        covered[i] = hasPaint(box.left - 1, box.top - 1, box.right + 1, box.bottom + 1);
    }
    return covered;
}

void FloatingLayers::restoreRest(const PixelRect &r, Picture8 &picture) const
{
    for (int y = r.y; y < r.y + r.height; ++y) {
        const std::size_t at = std::size_t(y) * std::size_t(m_rest.width) + std::size_t(r.x);
        std::memcpy(picture.argb.data() + at, m_rest.argb.data() + at, std::size_t(r.width) * sizeof(std::uint32_t));
    }
}

/// By whole pixels: from (x + dx, y + dy) of the layer.
void FloatingLayers::shiftOver(const PixelRect &r, int dx, int dy, Picture8 &picture) const
{
    const int left = std::max(r.x, -dx), right = std::min(r.x + r.width, m_width - dx);
    const int top = std::max(r.y, -dy), bottom = std::min(r.y + r.height, m_height - dy);
    for (int y = top; y < bottom; ++y) {
        const std::uint32_t *from = m_layer.data() + std::ptrdiff_t(y + dy) * m_width + dx;
        std::uint32_t *to = picture.argb.data() + std::ptrdiff_t(y) * picture.width;
        for (int x = left; x < right; ++x)
            to[x] = laidOver(to[x], from[x]);
    }
}

/// Between four pixels of the layer each.
void FloatingLayers::mapOver(const PixelRect &r, const Placing &placing, Picture8 &picture) const
{
    const auto pixels = [](std::uint32_t *argb) { return reinterpret_cast<uchar *>(argb); };
    std::uint32_t *corner = picture.argb.data() + std::size_t(r.y) * std::size_t(picture.width) + std::size_t(r.x);
    QImage to(pixels(corner), r.width, r.height, 4 * qsizetype(picture.width), QImage::Format_RGB32);
    const QImage from(reinterpret_cast<const uchar *>(m_layer.data()), m_width, m_height, 4 * qsizetype(m_width),
                      QImage::Format_ARGB32_Premultiplied);
    const Point right = placing.right, down = placing.down; // to the layer, from corners in place of middles
    const Point base = placing(r.x - 0.5, r.y - 0.5) + Point{0.5, 0.5};
    bool possible = false;
    const QTransform map = QTransform(right.x, right.y, down.x, down.y, base.x, base.y).inverted(&possible);
    if (!possible)
        return;
    QPainter painter(&to);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(map);
    painter.drawImage(0, 0, from);
}

std::vector<PixelRect> FloatingLayers::compose(const Affine &map, bool whole, Picture8 &picture, int threads)
{
    const Placing placing = placingUnder(map);
    const bool shifts = isWholePixels(placing);
    std::vector<char> covered = squaresUnder(placing);
    whole = whole || m_covered.size() != covered.size();
    std::vector<PixelRect> rects; // neighbours as one
    for (std::size_t i = 0; i < covered.size(); ++i) {
        if (!whole && !covered[i] && !m_covered[i])
            continue;
        const PixelRect r = square(i);
        if (!rects.empty() && rects.back().y == r.y && rects.back().x + rects.back().width == r.x)
            rects.back().width += r.width;
        else
            rects.push_back(r);
    }
    parallelFor(rects.size(), threads, [&](std::size_t i) {
        restoreRest(rects[i], picture);
        if (shifts)
            shiftOver(rects[i], int(placing.base.x), int(placing.base.y), picture);
        else
            mapOver(rects[i], placing, picture);
    });
    m_covered = std::move(covered);
    return rects;
}

} // namespace suffuse

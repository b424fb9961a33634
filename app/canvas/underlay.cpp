#include "app/canvas/underlay.h"

#include "app/canvas/view_transform.h"
#include "render/threads/parallel.h"

#include <QPainter>

#include <cmath>
#include <utility>

namespace suffuse {

namespace {

/// Mixes two premultiplied colours, `share` of 256 parts from the second.
QRgb mixed(QRgb a, QRgb b, unsigned share)
{
    constexpr QRgb odd = 0x00ff00ff;
    const unsigned rest = 256 - share;
    const QRgb low = ((a & odd) * rest + (b & odd) * share) >> 8;
    const QRgb high = ((a >> 8) & odd) * rest + ((b >> 8) & odd) * share;
    return (low & odd) | (high & ~odd);
}

/// One level of the picture, read between its pixels. Beyond its border the picture goes on with the colour of the
/// border. Points are in pixels of the level, whose centres are whole numbers.
class Sampler {
public:
    explicit Sampler(const QImage &level)
        : m_pixels(reinterpret_cast<const QRgb *>(level.constBits())), m_width(level.width()), m_height(level.height())
    {}
    Point size() const { return {double(m_width), double(m_height)}; }

    QRgb at(Point p) const
    {
        const double x = std::clamp(p.x, 0.0, m_width - 1.0), y = std::clamp(p.y, 0.0, m_height - 1.0);
        const int i = int(x), j = int(y);
        const QRgb *row = m_pixels + std::size_t(j) * m_width + i;
        const unsigned a = unsigned((x - i) * 256), b = unsigned((y - j) * 256);
        const int on = i + 1 < m_width ? 1 : 0, below = j + 1 < m_height ? m_width : 0;
        return mixed(mixed(row[0], row[on], a), mixed(row[below], row[below + on], a), b);
    }
    /// Writes a run of pixels which lie wholly between the centres of the level's outer pixels.
    void run(QRgb *out, int count, Point start, Point step) const
    {
        constexpr double one = 4294967296.0;
        std::int64_t x = std::int64_t(start.x * one), y = std::int64_t(start.y * one);
        const std::int64_t dx = std::int64_t(step.x * one), dy = std::int64_t(step.y * one);
        for (int k = 0; k < count; ++k, x += dx, y += dy) {
            const QRgb *row = m_pixels + std::size_t(y >> 32) * m_width + (x >> 32);
            const unsigned a = unsigned(x >> 24) & 255, b = unsigned(y >> 24) & 255;
            out[k] = mixed(mixed(row[0], row[1], a), mixed(row[m_width], row[m_width + 1], a), b);
        }
    }

private:
    const QRgb *m_pixels;
    int m_width, m_height;
};

/// The first step k, and the one after the last, for which start + k·step is in [low, high]; both are from 0 to
/// `count`.
std::pair<int, int> stepsWithin(double start, double step, double low, double high, int count)
{
    double first = 0, last = count - 1.0;
    if (step == 0)
        return start >= low && start <= high ? std::pair{0, count} : std::pair{0, 0};
    const double a = (low - start) / step, b = (high - start) / step;
    first = std::max(first, std::ceil(std::min(a, b)));
    last = std::min(last, std::floor(std::max(a, b)));
    return first <= last ? std::pair{int(first), int(last) + 1} : std::pair{0, 0};
}

/// The level whose pixels come nearest to the view's in size.
const QImage &levelFor(const UnderlayImage &image, const UnderlayMap &map)
{
    const QSize size = image.size();
    const double across = std::hypot(map.right().x, map.down().x) * size.width();
    const double down = std::hypot(map.right().y, map.down().y) * size.height();
    const double level = std::round(std::log2(std::max(across, down)));
    return image.levels[std::size_t(std::clamp(level, 0.0, double(image.levels.size() - 1)))];
}

/// How much of a pixel of width `size` lies between 0 and 1.
double coverage(double share, double size)
{
    return std::clamp(std::min(share, 1 - share) / size + 0.5, 0.0, 1.0);
}

void drawRow(QRgb *out, int count, Point pixel, const UnderlayMap &map, const Sampler &sampler)
{
    const Point size = sampler.size(), share = map(pixel);
    const Point start{share.x * size.x - 0.5, share.y * size.y - 0.5};
    const Point step{map.right().x * size.x, map.right().y * size.y};
    // The width and height of a pixel, as shares of the picture. The border may be turned, so both directions count.
    const double across = std::hypot(map.right().x, map.down().x), down = std::hypot(map.right().y, map.down().y);
    const auto borders = [&](int from, int to) {
        for (int x = from; x < to; ++x) {
            const double covered =
                coverage(share.x + x * map.right().x, across) * coverage(share.y + x * map.right().y, down);
            const QRgb colour = covered > 0 ? sampler.at(start + double(x) * step) : 0;
            out[x] = covered < 1 ? mixed(0, colour, unsigned(covered * 256)) : colour;
        }
    };
    const double mx = std::max(0.01, 0.5 * across * size.x - 0.5), my = std::max(0.01, 0.5 * down * size.y - 0.5);
    const auto [left, right] = stepsWithin(start.x, step.x, mx, size.x - 1 - mx, count);
    const auto [above, below] = stepsWithin(start.y, step.y, my, size.y - 1 - my, count);
    const int from = std::max(left, above), to = std::max(from, std::min(right, below));
    borders(0, from);
    sampler.run(out + from, to - from, start + double(from) * step, step);
    borders(to, count);
}

} // namespace

UnderlayMap::UnderlayMap(const ShownUnderlay &shown, const View &view)
{
    const Rect &area = shown.area;
    const auto share = [&](Point p) {
        return Point{(p.x - area.left) / area.width(), (p.y - area.top) / area.height()};
    };
    View turned = view; // Without the centre, which may be far away, differences keep their digits at deep zoom.
    turned.centre = {};
    const Point origin = turned.toCanvas({});
    const Point right = turned.toCanvas({1, 0}) - origin, down = turned.toCanvas({0, 1}) - origin;
    m_base = share(view.toCanvas({}));
    m_right = {right.x / area.width(), right.y / area.height()};
    m_down = {down.x / area.width(), down.y / area.height()};
}

QRect underlayBounds(const ShownUnderlay &shown, const View &view)
{
    const Rect window = Rect::of(0, 0, view.width, view.height);
    const QRectF box = clippedCorners(view, shown.area, window.grown(1)).boundingRect();
    return box.adjusted(-0.5, -0.5, 0.5, 0.5).toAlignedRect() & QRect(0, 0, view.width, view.height);
}

void UnderlaySheet::draw(const ShownUnderlay &shown, const View &view)
{
    const QRect bounds = underlayBounds(shown, view);
    m_shown = shown;
    m_view = view;
    m_at = bounds.topLeft();
    if (m_sheet.size() != bounds.size())
        m_sheet = QImage(bounds.size(), QImage::Format_ARGB32_Premultiplied);
    if (m_sheet.isNull())
        return;
    const UnderlayMap map(shown, view);
    const Sampler sampler(levelFor(*shown.image, map));
    uchar *bits = m_sheet.bits();
    const qsizetype stride = m_sheet.bytesPerLine();
    constexpr int rows = 32;
    parallelFor(std::size_t((bounds.height() + rows - 1) / rows), 0, [&](std::size_t block) {
        const int end = std::min(bounds.height(), int(block + 1) * rows);
        for (int y = int(block) * rows; y < end; ++y)
            drawRow(reinterpret_cast<QRgb *>(bits + y * stride), bounds.width(),
                    {bounds.x() + 0.5, bounds.y() + y + 0.5}, map, sampler);
    });
}

void UnderlaySheet::paint(QPainter &painter, const ShownUnderlay &shown, const View &view, const QRect &part)
{
    if (m_sheet.isNull() || view != m_view || shown.image != m_shown.image || shown.area != m_shown.area)
        draw(shown, view);
    const QRect seen = part & QRect(m_at, m_sheet.size());
    if (seen.isEmpty())
        return;
    painter.save();
    painter.setOpacity(shown.opacity);
    painter.setCompositionMode(shown.brightens ? QPainter::CompositionMode_Screen : QPainter::CompositionMode_Multiply);
    painter.drawImage(seen.topLeft(), m_sheet, seen.translated(-m_at));
    painter.restore();
}

UnderlayLoader::UnderlayLoader(QObject *parent) : QObject(parent)
{
    m_thread.setMaxThreadCount(1);
}

UnderlayLoader::~UnderlayLoader()
{
    m_thread.waitForDone();
}

void UnderlayLoader::want(const EncodedImage &encoded)
{
    if (encoded == m_wanted)
        return;
    m_wanted = encoded;
    m_image = decodedUnderlay(encoded);
    if (m_image || !encoded)
        return;
    m_thread.start([this, encoded] {
        const Result<UnderlayImagePtr> image = decodeUnderlay(encoded, tr("Underlay"));
        QMetaObject::invokeMethod(
            this, [this, encoded, image] { take(encoded, image); }, Qt::QueuedConnection);
    });
}

void UnderlayLoader::take(const EncodedImage &encoded, const Result<UnderlayImagePtr> &image)
{
    if (encoded != m_wanted)
        return; // Another picture has been wanted since.
    if (!image) {
        emit failed(image.error());
        return;
    }
    m_image = *image;
    emit loaded();
}

} // namespace suffuse

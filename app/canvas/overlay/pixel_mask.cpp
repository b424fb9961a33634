#include "app/canvas/overlay/pixel_mask.h"

#include <QPaintEngine>

#include <algorithm>
#include <bit>

namespace suffuse {

void PixelMask::clear(int width, int height)
{
    m_width = width;
    m_height = height;
    m_stride = std::size_t(width + 63) / 64;
    m_words.assign(m_stride * std::size_t(height), 0);
    m_filled = {};
}

void PixelMask::clear(const QRect &part)
{
    const QRect inside = part & QRect(0, 0, m_width, m_height);
    for (int y = inside.top(); y <= inside.bottom(); ++y)
        for (int x = inside.left(); x <= inside.right(); ++x)
            m_words[std::size_t(y) * m_stride + std::size_t(x >> 6)] &= ~(quint64(1) << (x & 63));
    m_filled = {};
}

void PixelMask::paint(QPainter &painter, QPoint corner, const QRect &part, const std::vector<Ink> &inks)
{
    QRect seen = part & QRect(0, 0, m_width, m_height);
    if (painter.hasClipping())
        seen &= painter.clipBoundingRect().toAlignedRect().adjusted(-1, -1, 1, 1).translated(-corner);
    if (seen.isEmpty())
        return;
    // A few rows at a time stay in the cache. Where each picture becomes a texture, or is turned, all rows are painted
    // at once.
    const bool inMemory = painter.paintEngine()->type() == QPaintEngine::Raster;
    const int rows = inMemory && painter.deviceTransform().type() <= QTransform::TxTranslate ? 32 : seen.height();
    const int from = seen.left() / 64, to = seen.right() / 64 + 1; // counted in words
    for (int top = seen.top(); top <= seen.bottom(); top += rows) {
        const QRect strip(seen.left(), top, seen.width(), std::min(rows, seen.bottom() + 1 - top));
        fillStrip({from, top, to - from, strip.height()}, inks);
        painter.drawImage(corner + strip.topLeft(), m_strip, strip.translated(-64 * from, -top));
    }
}

/// Combines the bits of a row with those of the rows up to `reach` above and below it.
void PixelMask::gatherColumns(int y, int reach)
{
    m_columns.assign(m_stride + 2, 0);
    for (int row = std::max(y - reach, 0); row <= std::min(y + reach, m_height - 1); ++row)
        for (std::size_t i = 0; i < m_stride; ++i)
            m_columns[i + 1] |= m_words[std::size_t(row) * m_stride + i];
}

/// A word of the combined row in which the pixels up to `reach` beside a set one are set, too.
quint64 PixelMask::spread(int word, int reach) const
{
    const quint64 *at = m_columns.data() + word + 1;
    quint64 bits = at[0];
    if ((at[-1] | at[0] | at[1]) == 0)
        return 0;
    for (int k = 1; k <= reach; ++k)
        bits |= at[0] << k | at[0] >> k | at[-1] >> (64 - k) | at[1] << (64 - k);
    return bits;
}

void PixelMask::fillStrip(const QRect &words, const std::vector<Ink> &inks)
{
    if (words == m_filled && inks == m_inks)
        return; // The strip is unchanged, so a texture that was made of it remains valid.
    m_filled = words;
    m_inks = inks;
    const QSize size(64 * words.width(), words.height());
    if (m_strip.size() != size)
        m_strip = QImage(size, QImage::Format_ARGB32_Premultiplied);
    m_strip.fill(Qt::transparent);
    for (const Ink &ink : inks) {
        const QRgb colour = qPremultiply(ink.colour.rgba());
        for (int y = 0; y < words.height(); ++y) {
            gatherColumns(words.top() + y, ink.reach);
            auto *out = reinterpret_cast<QRgb *>(m_strip.scanLine(y));
            for (int i = 0; i < words.width(); ++i, out += 64)
                for (quint64 word = spread(words.left() + i, ink.reach); word != 0; word &= word - 1)
                    out[std::countr_zero(word)] = colour;
        }
    }
}

} // namespace suffuse

#include "app/canvas/pixel_mask.h"

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

void PixelMask::paint(QPainter &painter, QPoint corner, const QRect &part, const QColor &colour)
{
    QRect seen = part & QRect(0, 0, m_width, m_height);
    if (painter.hasClipping())
        seen &= painter.clipBoundingRect().toAlignedRect().adjusted(-1, -1, 1, 1).translated(-corner);
    if (seen.isEmpty())
        return;
    // A few rows after the other stay in the cache; where each becomes a texture, or is turned, all at once.
    const bool inMemory = painter.paintEngine()->type() == QPaintEngine::Raster;
    const int rows = inMemory && painter.deviceTransform().type() <= QTransform::TxTranslate ? 32 : seen.height();
    const int from = seen.left() / 64, to = seen.right() / 64 + 1; // words
    for (int top = seen.top(); top <= seen.bottom(); top += rows) {
        const QRect strip(seen.left(), top, seen.width(), std::min(rows, seen.bottom() + 1 - top));
        fillStrip({from, top, to - from, strip.height()}, qPremultiply(colour.rgba()));
        painter.drawImage(corner + strip.topLeft(), m_strip, strip.translated(-64 * from, -top));
    }
}

void PixelMask::fillStrip(const QRect &words, QRgb colour)
{
    if (words == m_filled && colour == m_colour)
        return; // a texture of it lasts
    m_filled = words;
    m_colour = colour;
    const QSize size(64 * words.width(), words.height());
    if (m_strip.size() != size)
        m_strip = QImage(size, QImage::Format_ARGB32_Premultiplied);
    m_strip.fill(Qt::transparent);
    for (int y = 0; y < words.height(); ++y) {
        auto *out = reinterpret_cast<QRgb *>(m_strip.scanLine(y));
        const quint64 *row = m_words.data() + std::size_t(words.top() + y) * m_stride + words.left();
        for (int i = 0; i < words.width(); ++i, out += 64)
            for (quint64 word = row[i]; word != 0; word &= word - 1)
                out[std::countr_zero(word)] = colour;
    }
}

} // namespace suffuse

#pragma once

#include <QImage>
#include <QPainter>

#include <vector>

namespace suffuse {

/// One bit a pixel, to be painted in one colour: so small that drawing into it and wiping it stay in the cache, which a
/// picture of the size of the window does not.
class PixelMask {
public:
    int width() const { return m_width; }
    int height() const { return m_height; }
    /// Of this size, nothing set.
    void clear(int width, int height);
    void set(int x, int y) { m_words[std::size_t(y) * m_stride + std::size_t(x >> 6)] |= quint64(1) << (x & 63); }
    /// What is set of `part`, with the mask's corner at `corner`.
    void paint(QPainter &painter, QPoint corner, const QRect &part, const QColor &colour);

private:
    void fillStrip(const QRect &words, QRgb colour);

    int m_width = 0, m_height = 0;
    std::size_t m_stride = 0; ///< words
    std::vector<quint64> m_words;
    QImage m_strip; ///< rows that are being painted
    QRect m_filled; ///< what it shows: words across, rows down
    QRgb m_colour = 0;
};

} // namespace suffuse

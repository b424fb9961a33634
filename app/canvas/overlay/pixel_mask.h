#pragma once

#include <QImage>
#include <QPainter>

#include <vector>

namespace suffuse {

/// A picture of one bit a pixel, which is painted in one colour. It is so small that it stays in the cache while it is
/// drawn and wiped, which a picture of the size of the window does not.
class PixelMask {
public:
    int width() const { return m_width; }
    int height() const { return m_height; }
    /// Gives the mask a size, and sets none of its pixels.
    void clear(int width, int height);
    /// Sets none of the pixels in this part.
    void clear(const QRect &part);
    void set(int x, int y) { m_words[std::size_t(y) * m_stride + std::size_t(x >> 6)] |= quint64(1) << (x & 63); }
    /// A colour for the pixels that are set and those at most `reach` pixels beside one.
    struct Ink {
        QColor colour;
        int reach = 0;
        friend bool operator==(const Ink &, const Ink &) = default;
    };
    /// Paints the set pixels of `part`, with the mask's corner at `corner`. Each ink replaces the inks before it.
    void paint(QPainter &painter, QPoint corner, const QRect &part, const std::vector<Ink> &inks);

private:
    void fillStrip(const QRect &words, const std::vector<Ink> &inks);
    void gatherColumns(int y, int reach);
    quint64 spread(int word, int reach) const;

    int m_width = 0, m_height = 0;
    std::size_t m_stride = 0; ///< words in a row
    std::vector<quint64> m_words;
    QImage m_strip; ///< the rows that are being painted
    QRect m_filled; ///< what the strip shows: words across, rows down
    std::vector<Ink> m_inks;
    /// the combined bits of a row and the rows beside it, with a word before and one after
    std::vector<quint64> m_columns;
};

} // namespace suffuse

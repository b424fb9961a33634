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
    /// Nothing set in this part.
    void clear(const QRect &part);
    void set(int x, int y) { m_words[std::size_t(y) * m_stride + std::size_t(x >> 6)] |= quint64(1) << (x & 63); }
    /// A colour for what is set and what lies at most `reach` pixels beside it.
    struct Ink {
        QColor colour;
        int reach = 0;
        friend bool operator==(const Ink &, const Ink &) = default;
    };
    /// What is set of `part`, with the mask's corner at `corner`. Each ink takes the place of those before.
    void paint(QPainter &painter, QPoint corner, const QRect &part, const std::vector<Ink> &inks);

private:
    void fillStrip(const QRect &words, const std::vector<Ink> &inks);
    void gatherColumns(int y, int reach);
    quint64 spread(int word, int reach) const;

    int m_width = 0, m_height = 0;
    std::size_t m_stride = 0; ///< words
    std::vector<quint64> m_words;
    QImage m_strip; ///< rows that are being painted
    QRect m_filled; ///< what it shows: words across, rows down
    std::vector<Ink> m_inks;
    std::vector<quint64> m_columns; ///< of a row and those beside it, with a word before and after
};

} // namespace suffuse

// The fills of a stroke chunk as columns of a document (docs/file-format.md).
#pragma once

#include "model/formats/suffuse/field_columns.h"

namespace suffuse {

/// One column says which strokes have a fill, and of what kind; the others have a number for each fill, or for each
/// gradient.
class FillColumns {
public:
    void add(const Stroke &stroke);
    bool isUsed() const { return !m_born.empty(); }
    void put(ColumnWriter &out) const;

    /// Reads the columns of so many strokes. Returns false if they are not what the format allows.
    bool get(ColumnReader &in, std::size_t strokes);
    /// Gives a stroke, which has its segments, the fill at its place among the strokes. The strokes come in order.
    void set(Stroke &stroke, std::size_t place);

private:
    enum Mark : std::uint8_t { IsFilled = 1, IsEvenOdd = 2, HasGradient = 4 };

    std::vector<std::uint8_t> m_marks; ///< by stroke
    PlainColumns<Fill> m_numbers;
    std::vector<std::uint64_t> m_born;                ///< after that of the stroke's first segment
    std::array<std::vector<std::uint32_t>, 4> m_ends; ///< bits of from x, y and to x, y
    PlainColumns<Gradient> m_gradientNumbers;
    std::size_t m_fill = 0, m_gradient = 0; ///< places in the columns that are read next
};

} // namespace suffuse

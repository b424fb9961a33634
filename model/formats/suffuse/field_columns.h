// Numbers of a type as columns of a document, each by itself (docs/file-format.md).
#pragma once

#include "model/formats/suffuse/suffuse_columns.h"
#include "model/painting/fields.h"

#include <bit>

namespace suffuse {

/// For each of `numbers` a column of the differences of its bits from the default's: 0 where it is as usual.
template <class Owner, const auto &numbers>
class NumberColumns {
public:
    void add(const Owner &owner)
    {
        for (std::size_t k = 0; k < m_columns.size(); ++k)
            m_columns[k].push_back(bitsOf(numbers[k].of(owner)) - m_usual[k]);
    }
    /// Sets the numbers to what the columns have at a place.
    void set(Owner &owner, std::size_t place) const
    {
        for (std::size_t k = 0; k < m_columns.size(); ++k)
            numbers[k].of(owner) = std::bit_cast<float>(m_columns[k][place] + m_usual[k]);
    }

    void put(ColumnWriter &out) const
    {
        for (const Column &column : m_columns)
            out.put(column);
    }
    void get(ColumnReader &in, std::size_t count)
    {
        for (Column &column : m_columns)
            column = in.get<std::uint32_t>(count);
    }

    /// Up to the last column that has a number which is not as usual.
    void putUsed(ColumnWriter &out) const
    {
        std::size_t used = m_columns.size();
        while (used > 0 && std::ranges::count(m_columns[used - 1], 0u) == std::ptrdiff_t(m_columns[used - 1].size()))
            --used;
        for (std::size_t k = 0; k < used; ++k)
            out.put(m_columns[k]);
    }
    /// What the columns lack is as usual.
    void getUsed(ColumnReader &in, std::size_t count)
    {
        for (Column &column : m_columns)
            column = in.atEnd() ? Column(count) : in.get<std::uint32_t>(count);
    }

private:
    using Column = std::vector<std::uint32_t>;

    static std::uint32_t bitsOf(float value) { return std::bit_cast<std::uint32_t>(value); }
    static std::array<std::uint32_t, numbers.size()> usualBits()
    {
        std::array<std::uint32_t, numbers.size()> bits{};
        for (std::size_t k = 0; k < bits.size(); ++k)
            bits[k] = bitsOf(numbers[k].usual());
        return bits;
    }

    std::array<Column, numbers.size()> m_columns;
    std::array<std::uint32_t, numbers.size()> m_usual = usualBits();
};

/// Those of version 1 that nothing predicts.
template <class Owner>
using PlainColumns = NumberColumns<Owner, plainNumbersOf<Owner>>;
/// Those of later versions.
template <class Owner>
using LaterColumns = NumberColumns<Owner, laterNumbersOf<Owner>>;

/// The least version of a reader that understands a value's numbers.
template <class Owner>
int versionNeededBy(const Owner &owner)
{
    int version = suffuseLeastReader;
    for (const Number<Owner> &number : laterNumbersOf<Owner>)
        if (number.of(owner) != number.usual())
            version = std::max(version, number.traits.since);
    return version;
}

} // namespace suffuse

// The numbers of a type as columns of a document, each by itself (docs/file-format.md).
#pragma once

#include "model/formats/suffuse/suffuse_columns.h"
#include "model/painting/fields.h"

#include <bit>

namespace suffuse {

/// Has a column for each of `numbers`. An element is the difference of a number's bits from those of the default, so it
/// is 0 where the number has its default.
template <class Owner, const auto &numbers>
class NumberColumns {
public:
    void add(const Owner &owner)
    {
        for (std::size_t k = 0; k < m_columns.size(); ++k)
            m_columns[k].push_back(bitsOf(numbers[k].of(owner)) - m_usual[k]);
    }
    /// Sets the numbers of `owner` to the elements at a place.
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

    bool isUsed() const { return usedColumns() > 0; }
    /// Writes the columns up to the last one that has a number other than its default.
    void putUsed(ColumnWriter &out) const
    {
        const std::size_t used = usedColumns();
        for (std::size_t k = 0; k < used; ++k)
            out.put(m_columns[k]);
    }
    /// Reads columns. Numbers of columns that are missing have their defaults.
    void getUsed(ColumnReader &in, std::size_t count)
    {
        for (Column &column : m_columns)
            column = in.atEnd() ? Column(count) : in.get<std::uint32_t>(count);
    }

private:
    using Column = std::vector<std::uint32_t>;

    std::size_t usedColumns() const
    {
        std::size_t used = m_columns.size();
        while (used > 0 && std::ranges::count(m_columns[used - 1], 0u) == std::ptrdiff_t(m_columns[used - 1].size()))
            --used;
        return used;
    }
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

/// The numbers of version 1 that are not predicted.
template <class Owner>
using PlainColumns = NumberColumns<Owner, plainNumbersOf<Owner>>;
/// The numbers of later versions.
template <class Owner>
using LaterColumns = NumberColumns<Owner, laterNumbersOf<Owner>>;

/// The flags of a type that later versions brought, in one column: the first is bit 0. Flags are usually false.
template <class Owner>
class FlagColumn {
public:
    void add(const Owner &owner)
    {
        std::uint8_t bits = 0;
        forEachFlag([&](bool Owner::*flag, int bit) { bits |= std::uint8_t(owner.*flag << bit); });
        m_bits.push_back(bits);
    }
    /// Sets the flags to those at a place of the column. Returns false if there is an unknown one. Does nothing where
    /// no column was read.
    bool set(Owner &owner, std::size_t place) const
    {
        if (m_bits.empty())
            return true;
        int known = 0;
        forEachFlag([&](bool Owner::*flag, int bit) { owner.*flag = m_bits[place] >> bit & 1, ++known; });
        return m_bits[place] >> known == 0;
    }
    bool has(bool Owner::*wanted, std::size_t place) const
    {
        return !m_bits.empty() && (m_bits[place] & maskOf(wanted));
    }
    std::size_t count(bool Owner::*wanted) const
    {
        const std::uint8_t mask = maskOf(wanted);
        return std::size_t(std::ranges::count_if(m_bits, [mask](std::uint8_t bits) { return bits & mask; }));
    }
    bool isUsed() const
    {
        return std::ranges::any_of(m_bits, [](std::uint8_t bits) { return bits != 0; });
    }
    void put(ColumnWriter &out) const { out.put(m_bits); }
    void get(ColumnReader &in, std::size_t size) { m_bits = in.get<std::uint8_t>(size); }

private:
    /// Calls use(flag, bit) for each flag.
    template <class Use>
    static void forEachFlag(Use use)
    {
        int bit = 0;
        forEachFieldOf<Owner>([&]<class Declarer, class Value>(const Field<Declarer, Value> &f) {
            if constexpr (std::is_same_v<Value, bool>)
                if (f.traits.since > 1)
                    use(static_cast<bool Owner::*>(f.member), bit++);
        });
    }
    static std::uint8_t maskOf(bool Owner::*wanted)
    {
        std::uint8_t mask = 0;
        forEachFlag([&](bool Owner::*flag, int bit) { mask |= std::uint8_t((flag == wanted) << bit); });
        return mask;
    }

    std::vector<std::uint8_t> m_bits;
};

} // namespace suffuse

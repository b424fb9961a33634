// The values of a painting as rows of structured arrays: one walk over the fields (model/painting/fields.h) gives the
// columns, writes a row and reads a row. So a number that is added to a segment is a column by itself.
#pragma once

#include "model/painting/fields.h"

#include <cstring>
#include <string>
#include <vector>

namespace suffuse::python {

/// A column of a table.
struct TableColumn {
    std::string name;
    std::string format;     ///< numpy's, of one number: "<f4"
    std::vector<int> shape; ///< of what a row has in it; empty: one number
    std::size_t offset = 0;
    std::size_t itemSize = 0; ///< of one number
    FieldTraits traits;
    std::string words; ///< of an enumeration, with commas
    bool isSeconds = false;
};

/// Lists and shared parts, which have tables of their own.
template <class V>
inline constexpr bool isTable = std::is_same_v<V, std::vector<Segment>> || std::is_same_v<V, std::vector<Rewet>> ||
                                std::is_same_v<V, std::vector<Cubic>> || std::is_same_v<V, SharedFill> ||
                                std::is_same_v<V, SharedText> || std::is_same_v<V, SharedPicture>;

template <class V>
inline constexpr bool isOptional = false;
template <class V>
inline constexpr bool isOptional<std::optional<V>> = true;

/// Walks over the columns of a value. `sink` gets enter(name, traits) and leave() around each field, leaf(value) for
/// what is a column, and maybe(optional, walk) for what may be missing.
template <class V, class Sink>
void walkColumns(V &value, Sink &sink)
{
    using Value = std::remove_const_t<V>;
    if constexpr (isTable<Value>) {
        return;
    } else if constexpr (isOptional<Value>) {
        sink.maybe(value, [&sink](auto &present) { walkColumns(present, sink); });
    } else if constexpr (HasFields<Value> && !std::is_same_v<Value, Colour> && !std::is_same_v<Value, Rewet>) {
        forEachField(value, [&](const auto &field, auto &member) {
            if constexpr (!isTable<std::remove_cvref_t<decltype(member)>>) {
                sink.enter(field.name, field.traits);
                walkColumns(member, sink);
                sink.leave();
            }
        });
    } else {
        sink.leaf(value);
    }
}

/// The place of a row in another table, or of an image in the list of images; −1: none.
struct RowNumber {
    std::int64_t value = -1;
};

/// What the shape of a column is, and the type of its numbers.
template <class V>
struct LeafOf {
    using Number = V;
    static constexpr std::array<int, 0> shape{};
};
template <class V>
requires std::is_enum_v<V>
struct LeafOf<V> {
    using Number = std::uint8_t;
    static constexpr std::array<int, 0> shape{};
};
template <>
struct LeafOf<Microseconds> {
    using Number = double; ///< seconds
    static constexpr std::array<int, 0> shape{};
};
template <>
struct LeafOf<RowNumber> {
    using Number = std::int64_t;
    static constexpr std::array<int, 0> shape{};
};
template <>
struct LeafOf<std::uint64_t> {
    using Number = std::int64_t; ///< which numpy mixes with other whole numbers
    static constexpr std::array<int, 0> shape{};
};
template <>
struct LeafOf<Offset> {
    using Number = float;
    static constexpr std::array<int, 1> shape{2};
};
template <>
struct LeafOf<Point> {
    using Number = double;
    static constexpr std::array<int, 1> shape{2};
};
template <>
struct LeafOf<Colour> {
    using Number = float;
    static constexpr std::array<int, 1> shape{4};
};
template <>
struct LeafOf<std::array<float, 3>> {
    using Number = float;
    static constexpr std::array<int, 1> shape{3};
};
template <>
struct LeafOf<std::array<Offset, 4>> {
    using Number = float;
    static constexpr std::array<int, 2> shape{4, 2};
};
template <>
struct LeafOf<Cubic> {
    using Number = double;
    static constexpr std::array<int, 2> shape{4, 2};
};
template <>
struct LeafOf<Rect> {
    using Number = double;
    static constexpr std::array<int, 1> shape{4};
};
template <>
struct LeafOf<Affine> {
    using Number = double;
    static constexpr std::array<int, 1> shape{6};
};
/// From when on, and for how long.
template <>
struct LeafOf<Rewet> {
    using Number = double;
    static constexpr std::array<int, 1> shape{2};
};

/// Texts, whose columns are as wide as the longest, and images, whose columns have their places in a list.
template <class V>
inline constexpr bool isText = std::is_same_v<std::remove_const_t<V>, QString>;
template <class V>
inline constexpr bool isImage = std::is_same_v<std::remove_const_t<V>, EncodedImage>;

template <class Number>
constexpr const char *formatOf()
{
    if constexpr (std::is_same_v<Number, bool>)
        return "?";
    else if constexpr (std::is_same_v<Number, float>)
        return "<f4";
    else if constexpr (std::is_same_v<Number, double>)
        return "<f8";
    else if constexpr (std::is_same_v<Number, std::uint8_t>)
        return "|u1";
    else if constexpr (std::is_same_v<Number, std::uint32_t>)
        return "<u4";
    else if constexpr (std::is_same_v<Number, std::int64_t>)
        return "<i8";
    else
        static_assert(sizeof(Number) == 0, "a column of this type is not known");
}

/// Puts the numbers of a leaf to `to`.
template <class V>
void putLeaf(const V &value, char *to)
{
    using Number = typename LeafOf<V>::Number;
    const auto put = [to](const auto &...numbers) {
        const Number list[] = {Number(numbers)...};
        std::memcpy(to, list, sizeof list);
    };
    if constexpr (std::is_same_v<V, Microseconds>)
        put(toSeconds(value));
    else if constexpr (std::is_same_v<V, Rewet>)
        put(toSeconds(value.time), toSeconds(value.extra));
    else if constexpr (std::is_same_v<V, Affine>)
        put(value.a, value.b, value.c, value.d, value.offset.x, value.offset.y);
    else if constexpr (std::is_arithmetic_v<V> || std::is_enum_v<V>)
        put(value);
    else
        std::memcpy(to, &value, sizeof value); // nothing but numbers in their order
}

/// The microseconds of seconds; what is no moment becomes one that no painting may have.
inline Microseconds microsecondsOf(double seconds)
{
    return std::abs(seconds) <= 1e12 ? toMicroseconds(seconds) : std::numeric_limits<Microseconds>::max();
}

/// Takes the numbers of a leaf from `from`.
template <class V>
void takeLeaf(V &value, const char *from)
{
    using Number = typename LeafOf<V>::Number;
    constexpr std::size_t count = [] {
        std::size_t n = 1;
        for (const int extent : LeafOf<V>::shape)
            n *= std::size_t(extent);
        return n;
    }();
    Number list[count];
    std::memcpy(list, from, sizeof list);
    if constexpr (std::is_same_v<V, Microseconds>)
        value = microsecondsOf(list[0]);
    else if constexpr (std::is_same_v<V, Rewet>)
        value = {microsecondsOf(list[0]), microsecondsOf(list[1])};
    else if constexpr (std::is_same_v<V, Affine>)
        value = {list[0], list[1], list[2], list[3], {list[4], list[5]}};
    else if constexpr (std::is_arithmetic_v<V> || std::is_enum_v<V>)
        value = V(list[0]);
    else
        std::memcpy(&value, list, sizeof value);
}

/// Lists the columns of a type, each where its numbers are aligned.
class ColumnList {
public:
    /// `widths`: of the text columns in their order, code points.
    explicit ColumnList(std::vector<std::size_t> widths = {}) : m_widths(std::move(widths)) {}

    /// A number of the table itself, such as the row of the stroke that a segment belongs to.
    template <class V>
    void add(const char *name, const V &value, const FieldTraits &traits = {})
    {
        enter(name, traits);
        leaf(value);
        leave();
    }
    void enter(const char *name, const FieldTraits &traits)
    {
        m_names.push_back(name);
        m_traits = traits;
    }
    void leave() { m_names.pop_back(); }
    template <class V, class Walk>
    void maybe(std::optional<V> &, Walk walk)
    {
        put("has_" + pathOf(m_names), "?", {}, 1);
        V usual{};
        walk(usual);
    }
    template <class V>
    void leaf(const V &)
    {
        if constexpr (isText<V>) {
            const std::size_t width = m_texts < m_widths.size() ? std::max<std::size_t>(m_widths[m_texts], 1) : 1;
            ++m_texts;
            put(pathOf(m_names), "<U" + std::to_string(width), {}, 4 * width, 4);
        } else if constexpr (isImage<V>) {
            put(pathOf(m_names), "<i8", {}, 8);
        } else {
            using Leaf = LeafOf<std::remove_const_t<V>>;
            using Number = typename Leaf::Number;
            put(pathOf(m_names), formatOf<Number>(), {Leaf::shape.begin(), Leaf::shape.end()}, sizeof(Number));
            m_columns.back().isSeconds =
                std::is_same_v<std::remove_const_t<V>, Microseconds> || std::is_same_v<std::remove_const_t<V>, Rewet>;
            if constexpr (std::is_enum_v<V>)
                for (const std::string_view word : WordsOf<V>::list)
                    m_columns.back().words += (m_columns.back().words.empty() ? "" : ", ") + std::string(word);
        }
    }
    const std::vector<TableColumn> &columns() const { return m_columns; }
    std::size_t rowSize() const { return (m_end + 7) / 8 * 8; }
    bool hasTexts() const { return m_texts > 0; }

private:
    /// "maxAge" becomes "max_age", "anisotropy.ratio" "anisotropy_ratio", and parts are joined.
    static std::string pathOf(const std::vector<const char *> &names)
    {
        std::string path;
        for (const char *name : names) {
            path += path.empty() ? "" : "_";
            for (const char *c = name; *c; ++c)
                if (*c >= 'A' && *c <= 'Z')
                    path += {'_', char(*c - 'A' + 'a')};
                else
                    path += *c == '.' ? '_' : *c;
        }
        return path;
    }
    void put(const std::string &name, const std::string &format, std::vector<int> shape, std::size_t itemSize,
             std::size_t alignment = 0)
    {
        const std::size_t align = alignment ? alignment : itemSize;
        m_end = (m_end + align - 1) / align * align;
        std::size_t count = 1;
        for (const int extent : shape)
            count *= std::size_t(extent);
        m_columns.push_back({name, format, std::move(shape), m_end, itemSize, m_traits, {}, false});
        m_end += count * itemSize;
    }

    std::vector<std::size_t> m_widths;
    std::size_t m_texts = 0;
    std::vector<const char *> m_names;
    FieldTraits m_traits;
    std::vector<TableColumn> m_columns;
    std::size_t m_end = 0;
};

/// Finds how wide the texts of a table are.
class TextWidths {
public:
    std::vector<std::size_t> widths;

    void beginRow() { m_next = 0; }
    void enter(const char *, const FieldTraits &) {}
    void leave() {}
    template <class V, class Walk>
    void maybe(const std::optional<V> &value, Walk walk)
    {
        const V usual{};
        walk(value ? *value : usual);
    }
    template <class V>
    void leaf(const V &value)
    {
        if constexpr (isText<V>) {
            if (m_next == widths.size())
                widths.push_back(1);
            widths[m_next] = std::max(widths[m_next], std::size_t(value.size()));
            ++m_next;
        }
    }

private:
    std::size_t m_next = 0;
};

/// The images of a painting, each once, by their places.
class ImageList {
public:
    std::vector<EncodedImage> images;
    RowNumber placeOf(const EncodedImage &image)
    {
        if (!image)
            return {};
        for (std::size_t i = 0; i < images.size(); ++i)
            if (images[i] == image || *images[i] == *image)
                return {std::int64_t(i)};
        images.push_back(image);
        return {std::int64_t(images.size()) - 1};
    }
};

/// Writes rows. The columns are those of the list.
class RowWriter {
public:
    RowWriter(const ColumnList &list, char *rows, ImageList &images) : m_list(list), m_row(rows), m_images(images) {}

    void nextRow() { m_row += m_list.rowSize(), m_column = 0; }
    void enter(const char *, const FieldTraits &) {}
    void leave() {}
    template <class V, class Walk>
    void maybe(const std::optional<V> &value, Walk walk)
    {
        leaf(value.has_value());
        const V usual{};
        walk(value ? *value : usual);
    }
    template <class V>
    void leaf(const V &value)
    {
        const TableColumn &column = m_list.columns()[m_column++];
        char *const to = m_row + column.offset;
        if constexpr (isText<V>)
            putText(value, to, column.itemSize);
        else if constexpr (isImage<V>)
            putLeaf(m_images.placeOf(value), to);
        else
            putLeaf(value, to);
    }

private:
    static void putText(const QString &text, char *to, std::size_t bytes);

    const ColumnList &m_list;
    char *m_row;
    ImageList &m_images;
    std::size_t m_column = 0;
};

/// Where a column of an array lies; null: the array does not have it, and defaults stay.
struct ColumnData {
    const char *data = nullptr;
    std::ptrdiff_t stride = 0;
    std::size_t itemSize = 0;
};

/// Reads rows.
class RowReader {
public:
    RowReader(const std::vector<ColumnData> &columns, const std::vector<EncodedImage> &images)
        : m_columns(columns), m_images(images)
    {}

    void goTo(std::size_t row) { m_row = std::ptrdiff_t(row), m_column = 0; }
    void enter(const char *, const FieldTraits &) {}
    void leave() {}
    template <class V, class Walk>
    void maybe(std::optional<V> &value, Walk walk)
    {
        bool isThere = value.has_value();
        leaf(isThere);
        V present = value.value_or(V{});
        walk(present);
        value = isThere ? std::optional<V>(std::move(present)) : std::nullopt;
    }
    template <class V>
    void leaf(V &value)
    {
        const ColumnData &column = m_columns[m_column++];
        if (!column.data)
            return;
        const char *const from = column.data + m_row * column.stride;
        if constexpr (isText<V>)
            value = textAt(from, column.itemSize);
        else if constexpr (isImage<V>)
            value = imageAt(from);
        else
            takeLeaf(value, from);
    }

private:
    static QString textAt(const char *from, std::size_t bytes);
    EncodedImage imageAt(const char *from) const;

    const std::vector<ColumnData> &m_columns;
    const std::vector<EncodedImage> &m_images;
    std::ptrdiff_t m_row = 0;
    std::size_t m_column = 0;
};

} // namespace suffuse::python

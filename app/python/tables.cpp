#include "app/python/tables.h"

#include "app/python/table_kinds.h"

namespace suffuse::python {

namespace {

template <class T>
struct Row {
    std::int64_t owner = 0;
    const T *value = nullptr;
};

template <class T>
void addRows(const Painting &painting, std::vector<Row<T>> &rows)
{
    std::int64_t place = 0;
    if constexpr (std::is_same_v<T, Canvas>) {
        rows.push_back({0, &painting.canvas});
    } else if constexpr (std::is_same_v<T, Underlay>) {
        if (painting.underlay)
            rows.push_back({0, painting.underlay.get()});
    } else if constexpr (std::is_same_v<T, Group> || std::is_same_v<T, Swatch>) {
        const auto &list = [&]() -> const std::vector<T> & {
            if constexpr (std::is_same_v<T, Group>)
                return painting.groups;
            else
                return painting.swatches;
        }();
        for (const T &value : list)
            rows.push_back({0, &value});
    } else if constexpr (std::is_same_v<T, Text> || std::is_same_v<T, Cubic>) {
        std::int64_t texts = 0;
        for (const Group &group : painting.groups) {
            if (group.text) {
                if constexpr (std::is_same_v<T, Text>)
                    rows.push_back({place, &*group.text});
                else
                    for (const Cubic &cubic : group.text->curve)
                        rows.push_back({texts, &cubic});
                ++texts;
            }
            ++place;
        }
    } else {
        for (const StrokePtr &stroke : painting.strokes) {
            if constexpr (std::is_same_v<T, Stroke>)
                rows.push_back({0, stroke.get()});
            if constexpr (std::is_same_v<T, Segment>)
                for (const Segment &segment : stroke->segments)
                    rows.push_back({place, &segment});
            if constexpr (std::is_same_v<T, Rewet>)
                for (const Segment &segment : stroke->segments) {
                    for (const Rewet &rewet : segment.rewet)
                        rows.push_back({place, &rewet});
                    ++place;
                }
            if constexpr (std::is_same_v<T, Fill>)
                if (stroke->fill)
                    rows.push_back({place, &*stroke->fill});
            if constexpr (std::is_same_v<T, Picture>)
                if (stroke->picture)
                    rows.push_back({place, &*stroke->picture});
            if constexpr (!std::is_same_v<T, Rewet>)
                ++place;
        }
    }
}

template <class T>
void walkRow(const T &value, auto &sink)
{
    if constexpr (TableOf<T>::lone != nullptr)
        sink.leaf(value);
    else
        walkColumns(value, sink);
}

py::dtype typeOf(const ColumnList &list)
{
    py::list names, formats, offsets;
    for (const TableColumn &column : list.columns()) {
        std::string format;
        for (const int extent : column.shape)
            format += (format.empty() ? "(" : ",") + std::to_string(extent);
        if (!format.empty())
            format += column.shape.size() == 1 ? ",)" : ")";
        names.append(column.name);
        formats.append(format + column.format);
        offsets.append(column.offset);
    }
    return py::dtype(std::move(names), std::move(formats), std::move(offsets), py::ssize_t(list.rowSize()));
}

/// Makes the array of some rows.
template <class T>
py::array arrayOf(const std::vector<Row<T>> &rows, ImageList &images)
{
    std::vector<std::size_t> widths;
    if (columnListOf<T>().hasTexts()) {
        TextWidths sink;
        for (const Row<T> &row : rows) {
            sink.beginRow();
            walkRow(*row.value, sink);
        }
        widths = std::move(sink.widths);
    }
    const ColumnList list = columnListOf<T>(widths);
    py::array array(typeOf(list), py::ssize_t(rows.size()));
    auto *const bytes = static_cast<char *>(array.mutable_data());
    const py::gil_scoped_release released;
    std::memset(bytes, 0, list.rowSize() * rows.size());
    RowWriter writer(list, bytes, images);
    for (const Row<T> &row : rows) {
        if constexpr (TableOf<T>::owner != nullptr)
            writer.leaf(RowNumber{row.owner});
        walkRow(*row.value, writer);
        writer.nextRow();
    }
    return array;
}

/// The images in the order in which the tables name them.
ImageList imagesOf(const Painting &painting)
{
    ImageList images;
    images.placeOf(painting.canvas.paper.image);
    for (const StrokePtr &stroke : painting.strokes)
        if (stroke->picture)
            images.placeOf(stroke->picture->image);
    if (painting.underlay)
        images.placeOf(painting.underlay->image);
    return images;
}

const char *textOf(Unit unit)
{
    switch (unit) {
    case Unit::Length:
        return "unit";
    case Unit::Diffusion:
        return "unit²/s";
    case Unit::Seconds:
        return "s";
    case Unit::Share:
        return "share";
    case Unit::Radians:
        return "rad";
    case Unit::None:
        break;
    }
    return "";
}

} // namespace

const std::vector<std::string> &tableNames()
{
    static const std::vector<std::string> names = {"canvas",      "strokes",  "segments", "rewets",
                                                   "fills",       "pictures", "groups",   "texts",
                                                   "text_curves", "swatches", "underlay"};
    return names;
}

py::object tableOf(PaintingValue &value, const std::string &name)
{
    if (!value.tables.contains(name)) {
        ImageList images = imagesOf(*value.painting);
        if (name == "images") {
            py::list list;
            for (const EncodedImage &image : images.images)
                list.append(py::bytes(image->constData(), std::size_t(image->size())));
            value.tables["images"] = py::tuple(list);
        } else {
            py::array made = withTable(name, [&](auto usual) {
                std::vector<Row<decltype(usual)>> rows;
                addRows(*value.painting, rows);
                return arrayOf(rows, images);
            });
            made.attr("setflags")(py::arg("write") = false);
            value.tables[py::str(name)] = made;
        }
    }
    return value.tables[py::str(name)];
}

py::array newTable(const std::string &name, std::size_t count)
{
    return withTable(name, [&](auto usual) {
        const std::vector<Row<decltype(usual)>> rows(count, {0, &usual});
        ImageList images;
        return arrayOf(rows, images);
    });
}

py::list columnsOf(const std::string &name)
{
    const ColumnList list = withTable(name, [](auto usual) { return columnListOf<decltype(usual)>(); });
    py::list out;
    for (const TableColumn &column : list.columns()) {
        const bool hasDomain = column.words.empty() && column.format[1] == 'f';
        py::dict row;
        row["name"] = column.name;
        row["type"] = column.format[1] == 'U' ? "<U" : column.format;
        row["shape"] = py::tuple(py::cast(column.shape));
        row["unit"] = textOf(column.isSeconds ? Unit::Seconds : column.traits.unit);
        row["domain"] = hasDomain ? column.traits.domain.text() : QString();
        row["words"] = column.words;
        out.append(row);
    }
    return out;
}

} // namespace suffuse::python

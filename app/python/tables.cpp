#include "app/python/tables.h"

#include "app/python/columns.h"
#include "model/painting/validate.h"

#include <QStringList>

#include <unordered_map>

namespace suffuse::python {

namespace {

/// How the rows of a table say what they belong to, and how a column is called whose type has no fields.
template <class T>
struct TableOf;
template <>
struct TableOf<Canvas> {
    static constexpr const char *name = "canvas", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Stroke> {
    static constexpr const char *name = "strokes", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Segment> {
    static constexpr const char *name = "segments", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Rewet> {
    static constexpr const char *name = "rewets", *owner = "segment", *lone = "wetting";
};
template <>
struct TableOf<Fill> {
    static constexpr const char *name = "fills", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Picture> {
    static constexpr const char *name = "pictures", *owner = "stroke", *lone = nullptr;
};
template <>
struct TableOf<Group> {
    static constexpr const char *name = "groups", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Text> {
    static constexpr const char *name = "texts", *owner = "group", *lone = nullptr;
};
template <>
struct TableOf<Cubic> {
    static constexpr const char *name = "text_curves", *owner = "text", *lone = "bezier";
};
template <>
struct TableOf<Swatch> {
    static constexpr const char *name = "swatches", *owner = nullptr, *lone = nullptr;
};
template <>
struct TableOf<Underlay> {
    static constexpr const char *name = "underlay", *owner = nullptr, *lone = nullptr;
};

/// Calls use(T()) with the type of the rows of a table.
template <class Use>
auto withTable(const std::string &name, Use use)
{
    using Result = decltype(use(Canvas()));
    std::optional<Result> result;
    const auto tryType = [&](auto usual) {
        if (!result && name == TableOf<decltype(usual)>::name)
            result.emplace(use(usual));
    };
    tryType(Canvas()), tryType(Stroke()), tryType(Segment()), tryType(Rewet()), tryType(Fill()), tryType(Picture());
    tryType(Group()), tryType(Text()), tryType(Cubic()), tryType(Swatch()), tryType(Underlay());
    if (!result) {
        QStringList names;
        for (const std::string &known : tableNames())
            names.append(QString::fromStdString(known));
        raise(Raised::Value, QStringLiteral("%1: there is no such table; give one of %2")
                                 .arg(QString::fromStdString(name), names.join(QStringLiteral(", "))));
    }
    return *result;
}

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

template <class T>
ColumnList columnListOf(const std::vector<std::size_t> &widths = {})
{
    ColumnList list(widths);
    if constexpr (TableOf<T>::owner != nullptr)
        list.add(TableOf<T>::owner, RowNumber());
    T usual{};
    if constexpr (TableOf<T>::lone != nullptr)
        list.add(TableOf<T>::lone, usual, {.unit = std::is_same_v<T, Rewet> ? Unit::Seconds : Unit::Length});
    else
        walkColumns(usual, list);
    return list;
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

/// A table that is read: where its columns are, and what keeps them there.
struct ReadColumns {
    std::size_t rows = 0;
    bool isGiven = false;
    std::vector<ColumnData> data;
    std::vector<py::array> keep;
};

QString placeText(const char *table, const std::string &column)
{
    return QStringLiteral("%1.%2").arg(QLatin1String(table), QString::fromStdString(column));
}

/// The numbers that words stand for: "feathering" is 1.
py::array numbersOfWords(const char *table, const TableColumn &column, const py::array &words)
{
    const QStringList known = QString::fromStdString(column.words).split(QStringLiteral(", "));
    py::list numbers;
    for (const py::handle word : words.attr("ravel")()) {
        const qsizetype place = known.indexOf(py::str(word).cast<QString>());
        if (place < 0)
            raise(Raised::Value, QStringLiteral("%1: give one of %2")
                                     .arg(placeText(table, column.name), known.join(QStringLiteral(", "))));
        numbers.append(place);
    }
    return py::module_::import("numpy").attr("array")(numbers, "u1").attr("reshape")(words.attr("shape"));
}

/// Numbers without a sign of whole ones that fit, which numpy would not convert by itself.
py::array unsignedOf(const char *table, const TableColumn &column, const py::array &array)
{
    const double most = column.itemSize == 1 ? 255 : 4'294'967'295.0;
    if (array.size() > 0 && (array.attr("min")().cast<double>() < 0 || array.attr("max")().cast<double>() > most))
        raise(Raised::Value, QStringLiteral("%1: give whole numbers from 0 to %2")
                                 .arg(placeText(table, column.name))
                                 .arg(most, 0, 'f', 0));
    return array.attr("astype")(column.format);
}

/// The column as the reader wants it. Numbers of other types are converted as numpy does for "same_kind".
py::array converted(const char *table, const TableColumn &column, const py::object &given, std::size_t &itemSize)
{
    py::array array = py::array::ensure(given);
    if (!array)
        raise(Raised::Value, placeText(table, column.name) + QStringLiteral(": is no array"));
    const bool isText = column.format[1] == 'U';
    if (array.dtype().kind() == 'U' && !column.words.empty())
        array = numbersOfWords(table, column, array);
    if (array.dtype().kind() == 'i' && column.format[1] == 'u')
        array = unsignedOf(table, column, array);
    const auto wanted = py::dtype(isText ? "<U" : column.format);
    if (isText ? array.dtype().kind() != 'U' : !array.dtype().equal(wanted))
        array = array.attr("astype")(wanted, py::arg("casting") = isText ? "unsafe" : "same_kind").cast<py::array>();
    itemSize = isText ? std::size_t(array.itemsize()) : column.itemSize;
    bool fits = array.ndim() == py::ssize_t(column.shape.size()) + 1;
    for (std::size_t d = 0; fits && d < column.shape.size(); ++d)
        fits = array.shape(py::ssize_t(d) + 1) == column.shape[d];
    if (!fits) {
        QString shape = QStringLiteral("rows");
        for (const int extent : column.shape)
            shape += QStringLiteral(", %1").arg(extent);
        raise(Raised::Value, placeText(table, column.name) + QStringLiteral(": give it the shape (%1)").arg(shape));
    }
    py::ssize_t stride = py::ssize_t(itemSize);
    for (py::ssize_t d = array.ndim() - 1; d > 0; --d) {
        if (array.strides(d) != stride)
            return py::module_::import("numpy").attr("ascontiguousarray")(array).cast<py::array>();
        stride *= array.shape(d);
    }
    return array;
}

/// Finds the columns of a table: of a structured array, or of a mapping from names to arrays.
template <class T>
ReadColumns readColumns(const py::object &given)
{
    ReadColumns out;
    const ColumnList list = columnListOf<T>();
    out.data.resize(list.columns().size());
    out.keep.resize(list.columns().size());
    if (given.is_none())
        return out;
    out.isGiven = true;
    const char *const table = TableOf<T>::name;
    const bool isArray = py::isinstance<py::array>(given);
    const py::object names = isArray ? py::object(given.attr("dtype").attr("names")) : py::object(given.attr("keys")());
    if (names.is_none())
        raise(
            Raised::Value,
            QStringLiteral("%1: give a structured array, or a mapping from names to arrays").arg(QLatin1String(table)));
    std::size_t found = 0;
    for (const py::handle name : names) {
        const auto text = py::cast<std::string>(py::str(name));
        std::size_t k = 0;
        while (k < out.data.size() && list.columns()[k].name != text)
            ++k;
        if (k == out.data.size())
            raise(Raised::Value,
                  QStringLiteral("%1: there is no such column; suffuse.columns(\"%2\") lists those that there are")
                      .arg(placeText(table, text), QLatin1String(table)));
        py::array &array = out.keep[k];
        std::size_t itemSize = 0;
        array = converted(table, list.columns()[k], given[name], itemSize);
        const auto rows = std::size_t(array.shape(0));
        if (found++ > 0 && rows != out.rows)
            raise(Raised::Value,
                  placeText(table, text) +
                      QStringLiteral(": has %1 rows, and the columns before it have %2").arg(rows).arg(out.rows));
        out.rows = rows;
        out.data[k] = {static_cast<const char *>(array.data()), array.strides(0), itemSize};
        if (rows == 0) // The address of nothing may be null.
            out.data[k].data = nullptr;
    }
    return out;
}

using Images = std::vector<EncodedImage>;

/// Reads all rows. The row's owner comes with each.
template <class T>
std::vector<std::pair<std::int64_t, T>> rowsOf(const ReadColumns &columns, const Images &images)
{
    std::vector<std::pair<std::int64_t, T>> rows(columns.rows);
    RowReader reader(columns.data, images);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        reader.goTo(i);
        if constexpr (TableOf<T>::owner != nullptr) {
            RowNumber owner{0};
            reader.leaf(owner);
            rows[i].first = owner.value;
        }
        if constexpr (TableOf<T>::lone != nullptr)
            reader.leaf(rows[i].second);
        else
            walkColumns(rows[i].second, reader);
    }
    return rows;
}

/// What is wrong with the rows that others are said to belong to; or empty.
template <class T>
QString problemOfOwners(const std::vector<std::pair<std::int64_t, T>> &rows, std::size_t owners, const char *of)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].first < 0 || std::size_t(rows[i].first) >= owners)
            return QStringLiteral("%1[%2].%3: there is no row %4 in %5, which has %6")
                .arg(QLatin1String(TableOf<T>::name))
                .arg(i)
                .arg(QLatin1String(TableOf<T>::owner))
                .arg(rows[i].first)
                .arg(QLatin1String(of))
                .arg(owners);
    return {};
}

/// All tables, and what they are put together to.
class Assembly {
public:
    ReadColumns canvas, strokes, segments, rewets, fills, pictures, groups, texts, curves, swatches, underlay;
    Images images;
    PaintingPtr base; ///< whose strokes are shared where they are equal; may be null

    /// Puts the painting together; it touches nothing of Python.
    Result<PaintingPtr> painting() const
    {
        auto out = std::make_shared<Painting>();
        for (auto &[owner, value] : rowsOf<Canvas>(canvas, images))
            out->canvas = std::move(value);
        for (auto &[owner, value] : rowsOf<Swatch>(swatches, images))
            out->swatches.push_back(std::move(value));
        for (auto &[owner, value] : rowsOf<Underlay>(underlay, images))
            out->underlay = std::make_shared<const Underlay>(std::move(value));
        if (QString problem = addGroups(*out); !problem.isEmpty())
            return Error{problem};
        if (QString problem = addStrokes(*out); !problem.isEmpty())
            return Error{problem};
        if (const QString problem = problemOf(*out); !problem.isEmpty())
            return Error{problem};
        return PaintingPtr(std::move(out));
    }

private:
    QString addGroups(Painting &out) const
    {
        for (auto &[owner, value] : rowsOf<Group>(groups, images))
            out.groups.push_back(std::move(value));
        auto texted = rowsOf<Text>(texts, images);
        const auto curved = rowsOf<Cubic>(curves, images);
        if (QString problem = problemOfOwners(texted, out.groups.size(), "groups"); !problem.isEmpty())
            return problem;
        if (QString problem = problemOfOwners(curved, texted.size(), "texts"); !problem.isEmpty())
            return problem;
        for (const auto &[owner, cubic] : curved)
            texted[std::size_t(owner)].second.curve.push_back(cubic);
        for (auto &[owner, text] : texted)
            out.groups[std::size_t(owner)].text = std::move(text);
        return {};
    }

    QString addStrokes(Painting &out) const
    {
        auto segmented = rowsOf<Segment>(segments, images);
        auto made = rowsOf<Stroke>(strokes, images);
        if (!strokes.isGiven) // Each number among the segments is a usual stroke.
            for (const auto &[owner, segment] : segmented)
                if (owner >= std::int64_t(made.size()) && owner < std::int64_t(segmented.size()))
                    made.resize(std::size_t(owner) + 1);
        if (!strokes.isGiven || !hasIds())
            for (std::size_t i = 0; i < made.size(); ++i)
                made[i].second.id = i + 1;
        const auto wetted = rowsOf<Rewet>(rewets, images);
        const auto filled = rowsOf<Fill>(fills, images);
        auto pictured = rowsOf<Picture>(pictures, images);
        for (const QString &problem :
             {problemOfOwners(segmented, made.size(), "strokes"), problemOfOwners(wetted, segmented.size(), "segments"),
              problemOfOwners(filled, made.size(), "strokes"), problemOfOwners(pictured, made.size(), "strokes")})
            if (!problem.isEmpty())
                return problem;
        for (const auto &[owner, rewet] : wetted)
            segmented[std::size_t(owner)].second.rewet.push_back(rewet);
        std::vector<std::size_t> counts(made.size());
        for (const auto &[owner, segment] : segmented)
            ++counts[std::size_t(owner)];
        for (std::size_t i = 0; i < made.size(); ++i)
            made[i].second.segments.reserve(counts[i]);
        for (auto &[owner, segment] : segmented)
            made[std::size_t(owner)].second.segments.push_back(std::move(segment));
        for (const auto &[owner, fill] : filled)
            made[std::size_t(owner)].second.fill = fill;
        for (auto &[owner, picture] : pictured) {
            if (picture.image && picture.sha256.isEmpty())
                picture.sha256 = sha256Of(*picture.image);
            made[std::size_t(owner)].second.picture = std::move(picture);
        }
        std::unordered_map<StrokeId, StrokePtr> known;
        if (base)
            for (const StrokePtr &stroke : base->strokes)
                known.emplace(stroke->id, stroke);
        for (auto &[owner, stroke] : made) {
            const auto same = known.find(stroke.id);
            out.strokes.push_back(same != known.end() && *same->second == stroke
                                      ? same->second
                                      : std::make_shared<const Stroke>(std::move(stroke)));
        }
        return {};
    }

    bool hasIds() const
    {
        const ColumnList list = columnListOf<Stroke>();
        for (std::size_t k = 0; k < strokes.data.size(); ++k)
            if (list.columns()[k].name == "id")
                return strokes.data[k].data != nullptr || strokes.rows == 0;
        return false;
    }
};

Images imagesFrom(const py::object &list)
{
    Images images;
    for (const py::handle bytes : list) {
        const auto view = py::cast<std::string_view>(bytes);
        images.push_back(std::make_shared<const QByteArray>(view.data(), qsizetype(view.size())));
    }
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

PaintingPtr paintingOf(const py::dict &tables, PaintingValue *base)
{
    for (const auto &[name, table] : tables)
        if (const auto text = py::cast<std::string>(name); text != "images")
            withTable(text, [](auto) { return true; }); // It raises where there is none of that name.
    const auto given = [&](const char *name) -> py::object {
        if (tables.contains(name))
            return tables[name];
        return base ? tableOf(*base, name) : py::none();
    };
    Assembly assembly;
    assembly.canvas = readColumns<Canvas>(given("canvas"));
    assembly.strokes = readColumns<Stroke>(given("strokes"));
    assembly.segments = readColumns<Segment>(given("segments"));
    assembly.rewets = readColumns<Rewet>(given("rewets"));
    assembly.fills = readColumns<Fill>(given("fills"));
    assembly.pictures = readColumns<Picture>(given("pictures"));
    assembly.groups = readColumns<Group>(given("groups"));
    assembly.texts = readColumns<Text>(given("texts"));
    assembly.curves = readColumns<Cubic>(given("text_curves"));
    assembly.swatches = readColumns<Swatch>(given("swatches"));
    assembly.underlay = readColumns<Underlay>(given("underlay"));
    if (const py::object list = given("images"); !list.is_none())
        assembly.images = imagesFrom(list);
    if (base)
        assembly.base = base->painting;
    Result<PaintingPtr> made = Error{};
    {
        const py::gil_scoped_release released;
        made = assembly.painting();
    }
    return valueOf(std::move(made), Raised::Value);
}

py::array newTable(const std::string &name, std::size_t count)
{
    return withTable(name, [&](auto usual) {
        const std::vector<Row<decltype(usual)>> rows(count, {0, &usual});
        ImageList images;
        return arrayOf(rows, images);
    });
}

template <class T>
SetValues<T> changeOf(const py::dict &values)
{
    const py::module_ numpy = py::module_::import("numpy");
    py::dict rows;
    const ColumnList list = columnListOf<T>();
    for (const auto &[name, value] : values) {
        std::vector<int> shape{1};
        for (const TableColumn &column : list.columns())
            if (column.name == py::cast<std::string>(name))
                shape.insert(shape.end(), column.shape.begin(), column.shape.end());
        rows[name] = numpy.attr("broadcast_to")(value, py::tuple(py::cast(shape)));
    }
    // The arrays stay until the last copy of the change has gone, wherever that is.
    const std::shared_ptr<ReadColumns> columns(new ReadColumns(readColumns<T>(rows)), [](ReadColumns *old) {
        const py::gil_scoped_acquire locked;
        delete old;
    });
    return [columns](T &value) {
        static const std::vector<EncodedImage> none;
        RowReader reader(columns->data, none);
        reader.goTo(0);
        if constexpr (TableOf<T>::owner != nullptr) {
            RowNumber ignored;
            reader.leaf(ignored);
        }
        walkColumns(value, reader);
    };
}
template SetValues<Segment> changeOf(const py::dict &);
template SetValues<Stroke> changeOf(const py::dict &);
template SetValues<Fill> changeOf(const py::dict &);
template SetValues<Group> changeOf(const py::dict &);
template SetValues<Canvas> changeOf(const py::dict &);

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

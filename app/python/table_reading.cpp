// Tables become paintings.
#include "app/python/table_kinds.h"
#include "model/painting/validate.h"

#include <unordered_map>

namespace suffuse::python {

namespace {

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

} // namespace

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

} // namespace suffuse::python

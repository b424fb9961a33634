// Paintings: opened, saved, and as tables.
#include "app/python/bindings.h"
#include "app/python/tables.h"
#include "model/document/difference.h"
#include "model/formats/brushes/brush_file.h"
#include "model/formats/picture_links.h"
#include "model/painting/validate.h"
#include "render/backends.h"
#include "render/drawing/drawing_file.h"

#include <QDir>
#include <QFileInfo>
#include <QStringList>

namespace suffuse::python {

namespace {

/// A built-in brush by its name, or the brush of a file; none without a name.
std::optional<Brush> brushOf(const py::object &name)
{
    if (name.is_none())
        return {};
    const QString value = pathOf(name);
    if (const Brush *builtin = findBrush(value))
        return *builtin;
    if (QFileInfo(value).isFile())
        return valueOf(loadBrush(value), Raised::Value).brush;
    QStringList names;
    for (const Brush &b : builtinBrushes())
        names.append(b.name);
    raise(Raised::Value, QStringLiteral("brush %1: there is no such brush nor file; choose a file or one of %2")
                             .arg(value, names.join(QStringLiteral(", "))));
}

/// Makes a value of a document that was read: what is damaged is refused, or told.
PaintingValue valueOfDocument(LoadedDocument document, const QString &name, bool salvage)
{
    if (!document.losses.empty() && !salvage)
        raise(Raised::Value, QStringLiteral("%1: is damaged; salvage=True takes what is whole of it: %2")
                                 .arg(name, document.losses.front()));
    if (document.lostStrokes > 0 && document.painting.strokes.empty())
        raise(Raised::Value, QStringLiteral("%1: none of its %2 stroke(s) is whole; open a backup of it")
                                 .arg(name)
                                 .arg(document.lostStrokes));
    for (const QString &loss : document.losses)
        warnLeftOut(QStringLiteral("%1: %2").arg(name, loss));
    for (const QString &said : {document.leftOut, document.missing})
        if (!said.isEmpty())
            warnLeftOut(QStringLiteral("%1: %2").arg(name, said));
    return {std::make_shared<const Painting>(std::move(document.painting)),
            std::make_shared<const DocumentExtras>(std::move(document.extras)),
            {}};
}

PaintingValue open(const py::object &path, const py::object &brushName, bool salvage)
{
    const QString name = pathOf(path);
    const std::optional<Brush> brush = brushOf(brushName);
    Result<LoadedDocument> read = Error{};
    {
        const py::gil_scoped_release released;
        read = loadDocument(name, brush ? &*brush : nullptr);
        if (read)
            read->painting = withAbsoluteLinks(std::move(read->painting), QFileInfo(name).absolutePath());
    }
    const QFileInfo file(name);
    const bool isRead = file.isFile() && file.isReadable();
    return valueOfDocument(valueOf(std::move(read), isRead ? Raised::Value : Raised::File), name, salvage);
}

PaintingValue loads(const py::buffer &bytes, const QString &name, const py::object &brushName, bool salvage)
{
    const py::buffer_info info = bytes.request();
    if (info.itemsize != 1 || info.ndim != 1 || info.strides[0] != 1)
        raise(Raised::Value, QStringLiteral("data: give bytes, one after another"));
    const auto content = QByteArray::fromRawData(static_cast<const char *>(info.ptr), qsizetype(info.size));
    const std::optional<Brush> brush = brushOf(brushName);
    Result<LoadedDocument> read = Error{};
    {
        const py::gil_scoped_release released;
        read = readDocument(content, name, brush ? &*brush : nullptr);
        if (read)
            read->painting = withAbsoluteLinks(std::move(read->painting), QFileInfo(name).absolutePath());
    }
    return valueOfDocument(valueOf(std::move(read), Raised::Value), name, salvage);
}

/// What a drawing is to be.
struct DrawingWish {
    QString kind;
    int bands;
    std::optional<double> time;
    std::optional<QString> page;
};

DrawingOptions optionsOf(const DrawingWish &wish, DrawingFormat format, const Painting &painting)
{
    DrawingOptions options;
    options.format = format;
    if (wish.kind == QLatin1String("outlines"))
        options.kind = DrawingKind::Outlines;
    else if (wish.kind == QLatin1String("hybrid"))
        options.kind = DrawingKind::Hybrid;
    else if (wish.kind != QLatin1String("bands"))
        raise(Raised::Value, QStringLiteral("kind %1: give outlines, bands or hybrid").arg(wish.kind));
    if (wish.bands < 1 || wish.bands > mostBands)
        raise(Raised::Value,
              QStringLiteral("bands %1: give a whole number from 1 to %2").arg(wish.bands).arg(mostBands));
    options.bands = wish.bands;
    options.time = wish.time ? toMicroseconds(*wish.time) : painting.end();
    return options;
}

QByteArray drawingBytes(const PaintingValue &value, const DrawingWish &wish, DrawingFormat format, const QString &name)
{
    DrawingOptions options = optionsOf(wish, format, *value.painting);
    std::optional<PageSize> page;
    if (wish.page) {
        page = pageSizeFrom(*wish.page);
        if (!page || format != DrawingFormat::Pdf)
            raise(Raised::Value,
                  QStringLiteral("page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, "
                                 "and the ending .pdf")
                      .arg(*wish.page));
    }
    Result<QByteArray> bytes = Error{};
    withoutLock([&](std::atomic<bool> &cancel) {
        options.cancel = &cancel;
        const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({Backend::Cpu});
        Result<PreparedDrawing> prepared =
            renderer ? prepareDrawing(value.painting, options, **renderer) : Error{renderer.error()};
        if (!prepared) {
            bytes = Error{QStringLiteral("%1: %2").arg(name, prepared.error())};
            return;
        }
        prepared->paper = page;
        prepared->about = {QFileInfo(name).completeBaseName(), value.extras->profile};
        bytes = bytesOf(*prepared, *value.painting, name, &cancel);
    });
    return valueOf(std::move(bytes), Raised::Plain);
}

void save(const PaintingValue &value, const py::object &path, const DrawingWish &wish)
{
    const QString name = pathOf(path);
    Result<void> saved;
    if (const auto format = drawingFormatFor(name)) {
        const QByteArray bytes = drawingBytes(value, wish, *format, name);
        const py::gil_scoped_release released;
        saved = writeFileAtomically(name, bytes);
    } else if (formatForSaving(name) == FileFormat::Unknown) {
        raise(Raised::Value, QStringLiteral("%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf").arg(name));
    } else {
        const py::gil_scoped_release released;
        saved = saveDocument(withRelativeLinks(*value.painting, QFileInfo(name).absolutePath()), *value.extras, name);
    }
    if (!saved)
        raise(Raised::File, saved.error());
}

py::bytes dumps(const PaintingValue &value, const QString &format, const DrawingWish &wish)
{
    const QString name = QLatin1Char('.') + format;
    QByteArray bytes;
    if (const auto drawing = drawingFormatFor(name)) {
        bytes = drawingBytes(value, wish, *drawing, name);
    } else if (const FileFormat known = formatForSaving(name); known != FileFormat::Unknown) {
        const py::gil_scoped_release released;
        bytes = writeDocument(*value.painting, *value.extras, known);
    } else {
        raise(Raised::Value, QStringLiteral("format %1: give suffuse, json, svg or pdf").arg(format));
    }
    return {bytes.constData(), std::size_t(bytes.size())};
}

std::string hashText(const PaintingValue &value)
{
    const py::gil_scoped_release released;
    return hashOf(*value.painting).toHex().toStdString();
}

py::list valuesOf(const std::vector<ValueDifference> &values)
{
    py::list list;
    for (const ValueDifference &v : values) {
        py::dict row;
        row["path"] = v.path;
        row["before"] = v.before;
        row["after"] = v.after;
        list.append(row);
    }
    return list;
}

/// What differs, as `suffuse-cli diff --json` has it.
py::dict diff(const PaintingValue &a, const PaintingValue &b)
{
    PaintingDifference d;
    std::vector<ValueDifference> values;
    std::vector<StrokeDifference> strokes;
    {
        const py::gil_scoped_release released;
        d = differenceOf(*a.painting, *b.painting);
        values = valuesThatDiffer(*a.painting, *b.painting);
        for (const StrokeId id : d.changed)
            strokes.push_back(differenceOf(*a.painting->find(id), *b.painting->find(id)));
    }
    py::list changed;
    for (std::size_t i = 0; i < d.changed.size(); ++i) {
        py::dict row;
        row["id"] = d.changed[i];
        row["segments_added"] = strokes[i].added;
        row["segments_removed"] = strokes[i].removed;
        row["segments_changed"] = strokes[i].changed;
        row["values"] = valuesOf(strokes[i].values);
        changed.append(row);
    }
    py::dict out;
    out["same"] = d.isEmpty();
    out["added"] = d.added;
    out["removed"] = d.removed;
    out["changed"] = changed;
    out["moved"] = d.moved;
    out["values"] = valuesOf(values);
    return out;
}

bool areEqual(const PaintingValue &a, const PaintingValue &b)
{
    const py::gil_scoped_release released;
    return a.painting == b.painting || *a.painting == *b.painting;
}

DrawingWish wishOf(const QString &kind, int bands, std::optional<double> time, std::optional<QString> page)
{
    return {kind, bands, time, std::move(page)};
}

} // namespace

void addPaintings(py::module_ &module)
{
    using namespace py::literals;
    py::class_<PaintingValue> painting(module, "Painting");
    painting
        .def(py::init([](double width, double height) {
                 auto made = std::make_shared<Painting>();
                 made->canvas.width = width;
                 made->canvas.height = height;
                 if (const QString problem = problemOf(made->canvas); !problem.isEmpty())
                     raise(Raised::Value, problem);
                 return PaintingValue{std::move(made), std::make_shared<const DocumentExtras>(), {}};
             }),
             "width"_a = 1024.0, "height"_a = 768.0)
        .def(
            "save",
            [](const PaintingValue &self, const py::object &path, const QString &kind, int bands,
               std::optional<double> time,
               std::optional<QString> page) { save(self, path, wishOf(kind, bands, time, std::move(page))); },
            "path"_a, py::kw_only(), "kind"_a = "bands", "bands"_a = 16, "time"_a = py::none(), "page"_a = py::none())
        .def(
            "dumps",
            [](const PaintingValue &self, const QString &format, const QString &kind, int bands,
               std::optional<double> time,
               std::optional<QString> page) { return dumps(self, format, wishOf(kind, bands, time, std::move(page))); },
            "format"_a = "suffuse", py::kw_only(), "kind"_a = "bands", "bands"_a = 16, "time"_a = py::none(),
            "page"_a = py::none())
        .def("replaced",
             [](PaintingValue &self, const py::kwargs &tables) { return derivedFrom(self, paintingOf(tables, &self)); })
        .def_static("from_tables",
                    [](const py::kwargs &tables) {
                        return PaintingValue{paintingOf(tables, nullptr), std::make_shared<const DocumentExtras>(), {}};
                    })
        .def("table", &tableOf, "name"_a)
        .def("without_extras",
             [](const PaintingValue &self) {
                 return PaintingValue{self.painting, std::make_shared<const DocumentExtras>(), {}};
             })
        .def("__eq__", &areEqual, py::is_operator())
        .def("__hash__", [](const PaintingValue &self) { return py::hash(py::str(hashText(self))); })
        .def("__repr__",
             [](const PaintingValue &self) {
                 const Painting &p = *self.painting;
                 return inPython(QStringLiteral("<suffuse.Painting of %1 × %2 units: %3 stroke(s), %4 segment(s)>")
                                     .arg(p.canvas.width)
                                     .arg(p.canvas.height)
                                     .arg(p.strokes.size())
                                     .arg(p.segmentCount()));
             })
        .def("__len__", [](const PaintingValue &self) { return self.painting->strokes.size(); })
        .def_property_readonly("hash", &hashText)
        .def_property_readonly("size",
                               [](const PaintingValue &self) {
                                   return std::pair(self.painting->canvas.width, self.painting->canvas.height);
                               })
        .def_property_readonly("begin",
                               [](const PaintingValue &self) {
                                   Microseconds begin = 0;
                                   for (const StrokePtr &s : self.painting->strokes)
                                       begin = std::min(begin, s->born());
                                   return toSeconds(begin);
                               })
        .def_property_readonly("end", [](const PaintingValue &self) { return toSeconds(self.painting->end()); })
        .def_property_readonly("segment_count", [](const PaintingValue &self) { return self.painting->segmentCount(); })
        .def(py::pickle([](const PaintingValue &self) { return dumps(self, QStringLiteral("suffuse"), {}); },
                        [](const py::bytes &bytes) {
                            return loads(py::buffer(bytes), QStringLiteral("pickle"), py::none(), false);
                        }));
    for (const std::string &name : tableNames())
        painting.def_property_readonly(name.c_str(), [name](PaintingValue &self) { return tableOf(self, name); });
    painting.def_property_readonly("images", [](PaintingValue &self) { return tableOf(self, "images"); });
    module.def("open", &open, "path"_a, py::kw_only(), "brush"_a = py::none(), "salvage"_a = false);
    module.def("loads", &loads, "data"_a, py::kw_only(), "name"_a = "data", "brush"_a = py::none(),
               "salvage"_a = false);
    module.def("diff", &diff, "before"_a, "after"_a);
    module.def("new_table", &newTable, "table"_a, "rows"_a);
    module.def("columns", &columnsOf, "table"_a);
    module.def("table_names", [] { return py::tuple(py::cast(tableNames())); });
    module.def("brushes", [] {
        py::list names;
        for (const Brush &brush : builtinBrushes())
            names.append(brush.name);
        return py::tuple(names);
    });
}

} // namespace suffuse::python

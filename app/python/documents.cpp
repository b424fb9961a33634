// Edits with undo steps: the steps, what is selected, and edits of values.
#include "app/python/document_edits.h"
#include "app/python/tables.h"
#include "model/painting/validate.h"
#include "undo/edits.h"
#include "undo/fill_edits.h"
#include "undo/history/restore_edit.h"
#include "undo/layers/group_edits.h"

namespace suffuse::python {

namespace {

using Make = std::function<Edit(Document &)>;

/// A change of values, and what was wrong with the first value that cannot be.
template <class T>
class CheckedChange {
public:
    explicit CheckedChange(const py::dict &values) : m_change(changeOf<T>(values)) {}
    void operator()(T &value)
    {
        m_change(value);
        if (m_problem.isEmpty())
            m_problem = problemOfValue(value);
    }
    const QString &problem() const { return m_problem; }

private:
    static QString problemOfValue(const Fill &fill)
    {
        Stroke stroke; // A fill is checked with the stroke that it is in.
        stroke.id = 1;
        stroke.segments.emplace_back().bezier = {Offset{0, 0}, Offset{1, 0}, Offset{1, 1}, Offset{0, 1}};
        stroke.fill = fill;
        return problemOf(stroke);
    }
    static QString problemOfValue(const Group &group)
    {
        Painting painting;
        Group alone = group;
        alone.parent = 0;
        painting.groups = {alone};
        return problemOf(painting);
    }
    static QString problemOfValue(const Segment &segment) { return problemOf(segment); }
    static QString problemOfValue(const Stroke &stroke) { return problemOf(stroke); }
    static QString problemOfValue(const Canvas &canvas) { return problemOf(canvas); }

    SetValues<T> m_change;
    QString m_problem;
};

/// Does an edit of values: where one of them cannot be, nothing changes and DataError is raised.
template <class T>
bool pushChange(EditedPainting &self, const char *name, CheckedChange<T> &change, const Make &make)
{
    const bool isDone = push(self, name, [&](Document &document) {
        Edit edit = make(document);
        return change.problem().isEmpty() ? std::move(edit) : Edit();
    });
    if (!change.problem().isEmpty())
        raise(Raised::Value, change.problem());
    return isDone;
}

std::vector<GroupId> groupsOf(const std::set<GroupId> &ids, const Document &document)
{
    for (const GroupId id : ids)
        if (!document.painting()->findGroup(id))
            return {};
    return {ids.begin(), ids.end()};
}

void addSteps(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(py::init([](const PaintingValue &painting) {
                 return std::make_unique<EditedPainting>(painting.painting, painting.extras);
             }),
             "painting"_a)
        .def_property_readonly("painting",
                               [](const EditedPainting &self) {
                                   const PaintingPtr now = self.painting();
                                   const PaintingValue begun{self.begun(), self.extras(), {}};
                                   return now == begun.painting ? begun : derivedFrom(begun, now);
                               })
        .def_property_readonly("steps",
                               [](const EditedPainting &self) { return py::tuple(py::cast(self.steps().names)); })
        .def_property_readonly("done", [](const EditedPainting &self) { return self.steps().done; })
        .def("undo", &EditedPainting::undo, py::call_guard<py::gil_scoped_release>())
        .def("redo", &EditedPainting::redo, py::call_guard<py::gil_scoped_release>())
        .def("begin_step", &EditedPainting::beginStep, "name"_a)
        .def("end_step", &EditedPainting::endStep, "keep"_a = true)
        .def(
            "apply",
            [](EditedPainting &self, const PaintingValue &painting, const QString &name) {
                const py::gil_scoped_release released;
                return self.push(name,
                                 [&](Document &document) { return restorePainting(document, *painting.painting); });
            },
            "painting"_a, "name"_a = "Apply");
}

void addSelecting(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(
            "select",
            [](EditedPainting &self, const py::iterable &strokes, const py::iterable &segments) {
                Selection selection{idsOf(strokes), {}};
                for (const py::handle pair : segments) {
                    const auto [stroke, segment] = pair.cast<std::pair<StrokeId, int>>();
                    selection.segments.insert({stroke, segment});
                }
                self.select(selection);
            },
            "strokes"_a = py::tuple(), "segments"_a = py::tuple())
        .def("select_all",
             [](EditedPainting &self) {
                 Selection selection;
                 for (const StrokePtr &stroke : self.painting()->strokes)
                     selection.strokes.insert(stroke->id);
                 self.select(selection);
             })
        .def_property_readonly("selected_strokes",
                               [](const EditedPainting &self) {
                                   const std::set<StrokeId> ids = self.selection().strokes;
                                   return std::vector<StrokeId>(ids.begin(), ids.end());
                               })
        .def_property_readonly("selected_segments", [](const EditedPainting &self) {
            std::vector<std::pair<StrokeId, int>> segments;
            for (const SegmentRef &ref : self.selection().segments)
                segments.emplace_back(ref.stroke, ref.segment);
            return segments;
        });
}

void addValueEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def("change_segments",
             [](EditedPainting &self, const py::kwargs &values) {
                 CheckedChange<Segment> change(values);
                 return pushChange(self, "Change Segments", change,
                                   [&](Document &d) { return changeSegments(d, targetSegments(d), std::ref(change)); });
             })
        .def("change_strokes",
             [](EditedPainting &self, const py::kwargs &values) {
                 for (const char *name : {"id", "group"})
                     if (values.contains(name))
                         raise(Raised::Value, QStringLiteral("%1: cannot be changed so; use group, ungroup or apply")
                                                  .arg(QLatin1String(name)));
                 CheckedChange<Stroke> change(values);
                 return pushChange(self, "Change Strokes", change, [&](Document &d) {
                     return changeStrokes(d, d.selection().strokes, std::ref(change));
                 });
             })
        .def("change_fills",
             [](EditedPainting &self, const py::kwargs &values) {
                 CheckedChange<Fill> change(values);
                 return pushChange(self, "Change Fills", change, [&](Document &d) {
                     return changeFills(d, *d.painting(), d.selection().strokes,
                                        [&](Fill &now, const Fill &) { change(now); });
                 });
             })
        .def(
            "change_groups",
            [](EditedPainting &self, const py::iterable &ids, const py::kwargs &values) {
                const std::set<GroupId> groups = idsOf(ids);
                for (const char *name : {"id", "parent", "name", "visible", "locked"})
                    if (values.contains(name))
                        raise(Raised::Value, QStringLiteral("%1: cannot be changed so; use set_group or apply")
                                                 .arg(QLatin1String(name)));
                CheckedChange<Group> change(values);
                return pushChange(self, "Change Groups", change, [&](Document &d) {
                    return changeBlending(d, *d.painting(), groupsOf(groups, d),
                                          [&](Group &now, const Group &) { change(now); });
                });
            },
            "groups"_a)
        .def("change_canvas", [](EditedPainting &self, const py::kwargs &values) {
            CheckedChange<Canvas> change(values);
            return pushChange(self, "Change Canvas", change, [&](Document &d) {
                Canvas canvas = d.painting()->canvas;
                change(canvas);
                return setCanvas(d, canvas);
            });
        });
}

} // namespace

void addDocuments(py::module_ &module)
{
    DocumentClass document(module, "Document");
    addSteps(document);
    addSelecting(document);
    addValueEdits(document);
    addStrokeEdits(document);
    addShapeEdits(document);
    addGroupEdits(document);
    addTimeEdits(document);
}

} // namespace suffuse::python

// Edits of curves, areas and fills.
#include "app/python/document_edits.h"
#include "model/shaping/curves/fairing.h"
#include "model/shaping/curves/simplify.h"
#include "undo/area_edits.h"
#include "undo/fill_edits.h"
#include "undo/node_edits.h"
#include "undo/run_edits.h"

namespace suffuse::python {

namespace {

/// Raises why an edit of areas came to nothing.
bool checked(bool isDone, AreaProblem problem)
{
    switch (problem) {
    case AreaProblem::None:
        break;
    case AreaProblem::TooFew:
        raise(Raised::Value, QStringLiteral("too few areas, or no lines, are selected; select more"));
    case AreaProblem::Empty:
        raise(Raised::Value, QStringLiteral("nothing would be left that can be stored"));
    case AreaProblem::TooMuch:
        raise(Raised::Plain, QStringLiteral("the outlines meet so often that it would take minutes; select fewer"));
    case AreaProblem::Uncertain:
        raise(Raised::Plain,
              QStringLiteral("the outlines lie on each other in such a way that no result can be trusted; "
                             "move one of them a little"));
    }
    return isDone;
}

std::vector<Point> pathOf(const py::array_t<double, py::array::c_style | py::array::forcecast> &points)
{
    if (points.ndim() != 2 || points.shape(1) != 2)
        raise(Raised::Value, QStringLiteral("path: give it the shape (points, 2): x and y, units"));
    std::vector<Point> path;
    for (py::ssize_t i = 0; i < points.shape(0); ++i)
        path.push_back({points.at(i, 0), points.at(i, 1)});
    return path;
}

void addCurveEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(
            "simplify",
            [](EditedPainting &self, double distance, double values) {
                return push(self, "Simplify", [=](Document &d) {
                    return reshapeSelection(
                        d, *d.painting(), d.selection(),
                        [=](const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *sources) {
                            return simplified(stroke, {distance, values}, chosen, sources);
                        });
                });
            },
            "distance"_a = 0.5, "values"_a = 0.3)
        .def(
            "smooth",
            [](EditedPainting &self, double length) {
                return push(self, "Smooth", [=](Document &d) {
                    return reshapeSelection(d, *d.painting(), d.selection(),
                                            [=](const Stroke &stroke, const std::vector<bool> &chosen,
                                                std::vector<int> *) { return smoothed(stroke, length, chosen); });
                });
            },
            "length"_a)
        .def(
            "reverse",
            [](EditedPainting &self) { return push(self, "Reverse", [](Document &d) { return reverseSelection(d); }); })
        .def("join",
             [](EditedPainting &self) { return push(self, "Join", [](Document &d) { return joinSelection(d); }); })
        .def(
            "combine",
            [](EditedPainting &self) { return push(self, "Combine", [](Document &d) { return combineSelection(d); }); })
        .def("break_apart",
             [](EditedPainting &self) { return push(self, "Break Apart", [](Document &d) { return breakApart(d); }); })
        .def(
            "erase",
            [](EditedPainting &self, const py::array_t<double, py::array::c_style | py::array::forcecast> &path,
               double radius) {
                const std::vector<Point> points = pathOf(path);
                return push(self, "Erase", [&](Document &d) {
                    return eraseAlong(d, d.selection().strokes, points, radius,
                                      std::numeric_limits<Microseconds>::max(), Leaves::Chains);
                });
            },
            "path"_a, "radius"_a);
}

void addAreaEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def("fill",
             [](EditedPainting &self) {
                 return push(self, "Fill", [](Document &d) { return addFills(d, d.selection().strokes); });
             })
        .def("unfill",
             [](EditedPainting &self) {
                 return push(self, "Remove Fill", [](Document &d) { return removeFills(d, d.selection().strokes); });
             })
        .def(
            "combine_areas",
            [](EditedPainting &self, const QString &how) {
                const auto set = AreaSet(
                    choice("how", how, std::array{"union", "difference", "intersection", "exclusion", "division"}));
                AreaProblem problem = AreaProblem::None;
                const bool isDone =
                    push(self, "Combine Areas", [&](Document &d) { return combineAreas(d, set, &problem); });
                return checked(isDone, problem);
            },
            "how"_a)
        .def(
            "offset_areas",
            [](EditedPainting &self, double by) {
                AreaProblem problem = AreaProblem::None;
                const bool isDone =
                    push(self, "Offset Areas", [&](Document &d) { return offsetAreas(d, by, &problem); });
                return checked(isDone, problem);
            },
            "by"_a);
}

} // namespace

void addShapeEdits(DocumentClass &document)
{
    addCurveEdits(document);
    addAreaEdits(document);
}

} // namespace suffuse::python

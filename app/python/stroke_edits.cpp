// Edits of whole strokes, of their colours and of what they look like.
#include "app/python/document_edits.h"
#include "model/painting/validate.h"
#include "undo/colour_edits.h"
#include "undo/restyle_edits.h"
#include "undo/transform_edits.h"

#include <map>

namespace suffuse::python {

namespace {

using Ids = std::optional<std::set<StrokeId>>; ///< none: the selected ones

/// The strokes that are meant: those that are named, else the selected ones.
std::set<StrokeId> meant(const Ids &ids, const Document &document)
{
    return ids ? *ids : document.selection().strokes;
}

/// Strokes of another painting, with ids of this document and in none of its groups.
Edit added(Document &document, const Painting &other, bool select)
{
    std::vector<StrokePtr> strokes;
    for (const StrokePtr &stroke : other.strokes) {
        auto copy = std::make_shared<Stroke>(*stroke);
        copy->id = document.takeStrokeId();
        copy->group = 0;
        strokes.push_back(std::move(copy));
    }
    return strokes.empty() ? Edit() : addStrokes(document, strokes, select);
}

using ColourNumbers = std::array<float, 4>;

ColourNumbers numbersOf(const Colour &colour)
{
    return {colour.red, colour.yellow, colour.blue, colour.opacity};
}

/// Gives each colour of the selection the one that Python makes of it, which is asked once for each.
bool recolourBy(EditedPainting &self, const std::function<ColourNumbers(ColourNumbers)> &map)
{
    const ColourParts parts = partsToColour(*self.painting(), self.selection());
    std::map<ColourNumbers, Colour> made;
    const auto ask = [&](const Colour &colour) {
        const ColourNumbers before = numbersOf(colour);
        if (made.contains(before))
            return;
        const ColourNumbers to = map(before);
        const Colour after{to[0], to[1], to[2], to[3]};
        if (const QString problem = problemOf(after); !problem.isEmpty())
            raise(Raised::Value, problem);
        made.emplace(before, after);
    };
    for (const ColourPart &part : parts) {
        for (std::size_t k = 0; k < part.stroke->segments.size(); ++k)
            if (part.has(k))
                ask(part.stroke->segments[k].colour);
        if (part.fill && part.stroke->fill)
            ask(part.stroke->fill->colour);
        if (part.gradient && part.stroke->fill && part.stroke->fill->gradient)
            ask(part.stroke->fill->gradient->colour);
    }
    return push(self, "Recolour", [&](Document &d) {
        return recolour(d, parts, [&](const Colour &colour) { return made.at(numbersOf(colour)); });
    });
}

} // namespace

void addStrokeEdits(DocumentClass &document)
{
    using namespace py::literals;
    document
        .def(
            "add",
            [](EditedPainting &self, const PaintingValue &painting, bool select) {
                return push(self, "Add Strokes", [&](Document &d) { return added(d, *painting.painting, select); });
            },
            "painting"_a, "select"_a = true)
        .def("delete",
             [](EditedPainting &self) { return push(self, "Delete", [](Document &d) { return deleteSelection(d); }); })
        .def(
            "duplicate",
            [](EditedPainting &self, double dx, double dy) {
                return push(self, "Duplicate", [=](Document &d) { return duplicateSelection(d, {dx, dy}); });
            },
            "dx"_a = 0.0, "dy"_a = 0.0)
        .def(
            "arrange",
            [](EditedPainting &self, const QString &how) {
                const auto arrange = Arrange(choice("how", how, std::array{"raise", "lower", "top", "bottom"}));
                return push(self, "Arrange", [=](Document &d) { return arrangeSelection(d, arrange); });
            },
            "how"_a)
        .def(
            "reorder",
            [](EditedPainting &self, StrokeId before, const std::optional<py::iterable> &ids) {
                const Ids strokes = ids ? Ids(idsOf(*ids)) : std::nullopt;
                return push(self, "Reorder", [&](Document &d) { return reorder(d, meant(strokes, d), before); });
            },
            "before"_a = 0, "strokes"_a = py::none())
        .def(
            "transform",
            [](EditedPainting &self, const std::array<double, 6> &matrix, bool scaleSpread) {
                const SpreadRule rule = scaleSpread ? SpreadRule::Scales : SpreadRule::Stays;
                return push(self, "Transform", [&](Document &d) {
                    return transformSelection(
                        d, Affine{matrix[0], matrix[1], matrix[2], matrix[3], {matrix[4], matrix[5]}}, rule);
                });
            },
            "matrix"_a, "scale_spread"_a = true)
        .def(
            "align",
            [](EditedPainting &self, const QString &how, const QString &to) {
                const auto side =
                    Align(choice("how", how, std::array{"left", "centre", "right", "top", "middle", "bottom"}));
                const auto anchor = AlignTo(choice("to", to, std::array{"selection", "anchor", "biggest", "canvas"}));
                return push(self, "Align", [=](Document &d) { return align(d, side, anchor); });
            },
            "how"_a, "to"_a = "selection")
        .def(
            "distribute",
            [](EditedPainting &self, const QString &axis, const QString &spacing) {
                const auto along = Axis(choice("axis", axis, std::array{"horizontal", "vertical"}));
                const auto even = Spacing(choice("spacing", spacing, std::array{"gaps", "centres"}));
                return push(self, "Distribute", [=](Document &d) { return distribute(d, along, even); });
            },
            "axis"_a, "spacing"_a = "gaps")
        .def(
            "recolour",
            [](EditedPainting &self, const std::function<std::array<float, 4>(std::array<float, 4>)> &map) {
                return recolourBy(self, map);
            },
            "map"_a)
        .def(
            "apply_brush",
            [](EditedPainting &self, const QString &name, const QString &part) {
                const auto what = BrushPart(choice("part", part, std::array{"whole", "form", "colour", "texture"}));
                const Brush *brush = findBrush(name);
                if (!brush)
                    raise(Raised::Value,
                          QStringLiteral("brush %1: there is no such brush; brushes() names them").arg(name));
                return push(self, "Apply Brush", [=](Document &d) {
                    return applyBrush(d, *brush, what, [](const QString &known) { return findBrush(known); });
                });
            },
            "brush"_a, "part"_a = "whole");
}

} // namespace suffuse::python

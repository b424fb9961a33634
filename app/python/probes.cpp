// Numbers at points of a painting.
#include "app/python/views.h"

#include "model/paint/fill_density.h"
#include "model/paint/point_density.h"
#include "render/probe.h"

namespace suffuse::python {

namespace {

py::dict dictOf(const ProbeStroke &s)
{
    py::list segments;
    for (const ProbeShare &k : s.shares) {
        py::dict row;
        row["segment"] = k.segment;
        row["density"] = k.density;
        row["share"] = k.share;
        row["lift"] = k.lifts;
        row["fade"] = k.fades;
        segments.append(row);
    }
    py::dict fill;
    fill["density"] = s.fillDensity;
    fill["share"] = s.fillShare;
    py::dict out;
    out["id"] = s.id;
    out["name"] = s.name;
    out["density"] = s.density;
    out["lifted"] = s.lifted;
    out["faded"] = s.faded;
    out["granulation"] = s.granulation;
    out["modulated_density"] = s.modulated;
    out["density_function"] = s.densityFunction;
    out["colour"] = py::tuple(py::cast(s.colour));
    out["opacity"] = s.opacity;
    out["segments"] = segments;
    out["fill"] = fill;
    out["ryb_after"] = py::tuple(py::cast(s.rybAfter));
    out["rgb_after"] = py::tuple(py::cast(s.rgbAfter));
    out["colour_share"] = s.colourShare;
    return out;
}

py::dict probeAt(const PaintingValue &value, double x, double y, std::optional<double> time)
{
    const Microseconds moment = momentOf(time, *value.painting);
    Result<Probe> found = Error{};
    {
        const py::gil_scoped_release released;
        found = probe(*value.painting, moment, x, y);
    }
    const Probe result = valueOf(std::move(found), Raised::Plain);
    py::list strokes;
    for (const ProbeStroke &s : result.strokes)
        strokes.append(dictOf(s));
    py::dict out;
    out["x"] = x;
    out["y"] = y;
    out["time"] = toSeconds(moment);
    out["paper"] = result.paper;
    out["ryb_before"] = py::tuple(py::cast(result.rybBefore));
    out["rgb_before"] = py::tuple(py::cast(result.rgbBefore));
    out["strokes"] = strokes;
    out["ryb_after"] = py::tuple(py::cast(result.rybAfter));
    out["rgb_after"] = py::tuple(py::cast(result.rgbAfter));
    out["canvas_share"] = result.canvasShare;
    return out;
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// φ of one stroke: max(0, φ⁺ + φ_fill − φ⁻).
double densityAt(const Stroke &stroke, Microseconds time, Point point)
{
    double sum = stroke.fill ? fillDensityAt(stroke, time, point) : 0;
    for (const Segment &segment : stroke.segments) {
        if (segment.fade) // It is no density of paint.
            continue;
        const double density = segmentDensityAt(stroke, segment, time, point);
        sum += segment.lift ? -density : density;
    }
    return std::max(0.0, sum);
}

py::array density(const PaintingValue &value, std::uint64_t id, const Numbers &points, const py::object &time)
{
    const StrokePtr stroke = value.painting->find(id);
    if (!stroke)
        raise(Raised::Value, QStringLiteral("stroke %1: there is no such stroke").arg(id));
    if (points.ndim() < 1 || points.shape(points.ndim() - 1) != 2)
        raise(Raised::Value, QStringLiteral("points: give it the shape (…, 2): x and y, units"));
    const Numbers times =
        time.is_none() ? Numbers(py::array(py::float_(toSeconds(value.painting->end())))) : Numbers::ensure(time);
    if (!times)
        raise(Raised::Value, QStringLiteral("time: give seconds, or an array of them"));
    std::vector<py::ssize_t> shape(times.shape(), times.shape() + times.ndim());
    shape.insert(shape.end(), points.shape(), points.shape() + points.ndim() - 1);
    py::array_t<double> out(shape);
    const double *const at = points.data(), *const moments = times.data();
    double *to = out.mutable_data();
    const py::ssize_t pointCount = points.size() / 2, timeCount = times.size();
    for (py::ssize_t t = 0; t < timeCount; ++t)
        if (!(std::abs(moments[t]) <= 1e12))
            raise(Raised::Value, QStringLiteral("time %1: give a moment in seconds, e.g. 1.5").arg(moments[t]));
    const py::gil_scoped_release released;
    for (py::ssize_t t = 0; t < timeCount; ++t)
        for (py::ssize_t i = 0; i < pointCount; ++i)
            *to++ = densityAt(*stroke, toMicroseconds(moments[t]), {at[2 * i], at[2 * i + 1]});
    return out;
}

} // namespace

void addProbes(py::module_ &module)
{
    using namespace py::literals;
    module.def("probe", &probeAt, "painting"_a, "x"_a, "y"_a, py::kw_only(), "time"_a = py::none());
    module.def("density", &density, "painting"_a, "stroke"_a, "points"_a, py::kw_only(), "time"_a = py::none());
}

} // namespace suffuse::python

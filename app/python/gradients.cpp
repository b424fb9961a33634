// The derivatives of a loss by the numbers of a painting.
#include "app/python/views.h"

#include "render/gradient/picture_gradient.h"

#include <mutex>

namespace suffuse::python {

namespace {

using gradient::DifferentiablePicture;

/// Rows as numpy sees them: nothing but doubles, in this order.
struct SegmentSlopesRow {
    double bezier[8], density, diffusion, colour[3], opacity, granulation;
};
struct FillSlopesRow {
    std::int64_t stroke;
    double density, diffusion, colour[3], opacity, granulation;
};
struct StrokeSlopesRow {
    double xi[3];
};

py::dtype typeOf(const char *text)
{
    return py::dtype::from_args(py::module_::import("ast").attr("literal_eval")(text));
}

template <class Slopes, class To>
void putPaint(const Slopes &slopes, To &row)
{
    row.density = slopes.density;
    row.diffusion = slopes.diffusion;
    std::copy(slopes.colour, slopes.colour + 3, row.colour);
    row.opacity = slopes.opacity;
    row.granulation = slopes.granulation;
}

template <class T>
py::array arrayOfRows(const std::vector<T> &rows, const char *type)
{
    py::array array(typeOf(type), py::ssize_t(rows.size()));
    if (!rows.empty())
        std::memcpy(array.mutable_data(), rows.data(), rows.size() * sizeof(T));
    return array;
}

py::dict dictOf(const gradient::PictureGradient &slopes)
{
    std::vector<SegmentSlopesRow> segments;
    std::vector<FillSlopesRow> fills;
    std::vector<StrokeSlopesRow> strokes;
    for (const gradient::StrokeGradient &stroke : slopes.strokes) {
        for (const gradient::SegmentSlopes &s : stroke.segments) {
            SegmentSlopesRow &row = segments.emplace_back();
            for (int i = 0; i < 4; ++i)
                row.bezier[2 * i] = s.bezier[i].x, row.bezier[2 * i + 1] = s.bezier[i].y;
            putPaint(s, row);
        }
        if (stroke.fill) {
            FillSlopesRow &row = fills.emplace_back();
            row.stroke = std::int64_t(strokes.size());
            putPaint(*stroke.fill, row);
        }
        std::copy(stroke.xi, stroke.xi + 3, strokes.emplace_back().xi);
    }
    py::dict out;
    out["segments"] = arrayOfRows(segments, "[('bezier','<f8',(4,2)),('density','<f8'),('diffusion','<f8'),"
                                            "('ryb','<f8',(3,)),('opacity','<f8'),('granulation','<f8')]");
    out["fills"] = arrayOfRows(fills, "[('stroke','<i8'),('density','<f8'),('diffusion','<f8'),"
                                      "('ryb','<f8',(3,)),('opacity','<f8'),('granulation','<f8')]");
    out["strokes"] = arrayOfRows(strokes, "[('style_xi','<f8',(3,))]");
    return out;
}

/// A picture that was drawn, and waits for a loss.
class GradientPicture {
public:
    GradientPicture(const PaintingValue &value, const ViewWish &wish, int threads)
    {
        const cli::PictureOptions options = pictureOptionsOf(wish, *value.painting);
        const RendererOptions checked = rendererOptionsOf(QStringLiteral("cpu"), threads, py::none());
        m_width = options.width, m_height = options.height;
        Result<DifferentiablePicture> drawn = Error{};
        {
            const py::gil_scoped_release released;
            drawn = DifferentiablePicture::draw(
                value.painting, options.time, View::ofArea(options.area, m_width, m_height), Threads(checked.threads));
        }
        m_picture.emplace(valueOf(std::move(drawn), Raised::Value));
    }

    /// A view of the picture's own numbers, which `self` keeps.
    py::array picture(const py::object &self) const
    {
        py::array_t<float> array({py::ssize_t(m_height), py::ssize_t(m_width), py::ssize_t(3)},
                                 m_picture->picture().data(), self);
        array.attr("setflags")(py::arg("write") = false);
        return array;
    }

    py::dict backward(const py::array_t<float, py::array::c_style | py::array::forcecast> &loss)
    {
        if (loss.ndim() != 3 || loss.shape(0) != m_height || loss.shape(1) != m_width || loss.shape(2) != 3)
            raise(Raised::Value, QStringLiteral("loss_by_rgb: give it the shape (%1, %2, 3), that of the picture")
                                     .arg(m_height)
                                     .arg(m_width));
        const std::span<const float> slopes(loss.data(), std::size_t(loss.size()));
        gradient::PictureGradient out;
        {
            const py::gil_scoped_release released;
            const std::lock_guard lock(m_mutex);
            out = m_picture->backward(slopes);
        }
        return dictOf(out);
    }

private:
    int m_width = 0, m_height = 0;
    std::optional<DifferentiablePicture> m_picture;
    std::mutex m_mutex;
};

using Area = std::optional<std::array<double, 4>>;

} // namespace

void addGradients(py::module_ &module)
{
    using namespace py::literals;
    py::class_<GradientPicture>(module, "DifferentiablePicture")
        .def(py::init([](const PaintingValue &painting, const py::object &size, std::optional<double> scale,
                         const Area &area, std::optional<double> time, int threads) {
                 return std::make_unique<GradientPicture>(painting, ViewWish{size, scale, area, time}, threads);
             }),
             "painting"_a, py::kw_only(), "size"_a = py::none(), "scale"_a = py::none(), "area"_a = py::none(),
             "time"_a = py::none(), "threads"_a = 0)
        .def_property_readonly(
            "picture", [](const py::object &self) { return self.cast<const GradientPicture &>().picture(self); })
        .def("backward", &GradientPicture::backward, "loss_by_rgb"_a);
}

} // namespace suffuse::python

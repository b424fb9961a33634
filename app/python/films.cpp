// A painting being painted: as a film on the disk, and frame by frame as arrays.
#include "app/python/pictures.h"
#include "app/python/views.h"

#include "app/cli/pictures/film_work.h"
#include "render/backends.h"

namespace suffuse::python {

namespace {

using Area = std::optional<std::array<double, 4>>;

/// How a film runs, as Python says it.
struct FilmWish {
    double fps, duration, idle;
    bool transparent, once;
};

cli::Film filmOf(const FilmWish &wish)
{
    Asked asked("timelapse", {"fps", "duration", "idle"});
    asked.set("fps", py::object(py::float_(wish.fps)));
    asked.set("duration", py::object(py::float_(wish.duration)));
    asked.set("idle", py::object(py::float_(wish.idle)));
    if (wish.transparent)
        asked.set("transparent");
    if (wish.once)
        asked.set("once");
    return valueOf(cli::filmOf(asked.line()), Raised::Value);
}

py::dict timelapse(const PaintingValue &painting, const QString &path, const FilmWish &wish, const ViewWish &view,
                   const RendererOptions &options, const py::object &progress)
{
    cli::Film film = filmOf(wish);
    const cli::PictureOptions picture = pictureOptionsOf(view, *painting.painting);
    film.file.path = path;
    film.file.width = picture.width;
    film.file.height = picture.height;
    if (const QString problem = problemOf(film.file); !problem.isEmpty())
        raise(Raised::Value, QStringLiteral("%1: %2").arg(path, problem));
    WorkShare share(progress);
    Result<cli::FilmTask> work = Error{};
    Result<SequenceStats> stats = Error{};
    withoutLock(
        [&](std::atomic<bool> &cancel) {
            work = cli::filmTaskOf(painting.painting, film, picture, options);
            if (work)
                stats = cli::writeFilm(*work, options.threads, cancel,
                                       [&](qint64 done, qint64 all) { share.set(double(done) / double(all)); });
        },
        share.teller());
    const cli::FilmTask drawn = valueOf(std::move(work), Raised::Plain);
    const SequenceStats counts = valueOf(std::move(stats), Raised::File);
    py::dict out;
    out["backend"] = nameOf(drawn.renderers.front()->backend());
    out["device"] = drawn.renderers.front()->deviceName();
    out["devices"] = drawn.renderers.size();
    out["frames"] = drawn.moments.size();
    out["tiles"] = counts.tiles;
    out["tiles_evaluated"] = counts.tilesEvaluated;
    return out;
}

/// The frames of a film, drawn when they are asked for.
class Frames {
public:
    Frames(const PaintingValue &painting, const FilmWish &wish, const ViewWish &view, const py::object &type,
           RendererOptions options)
        : m_depth(depthOf(type)), m_moments(timelapseMoments(*painting.painting, filmOf(wish).options)),
          m_request(cli::framesRequest(painting.painting, pictureOptionsOf(view, *painting.painting), wish.transparent)),
          m_renderer(chosen(options))
    {}

    std::size_t size() const { return m_moments.size(); }
    py::array at(py::ssize_t i)
    {
        const auto count = py::ssize_t(size());
        if (i < -count || i >= count)
            throw py::index_error("there is no such frame");
        RenderRequest request = m_request;
        request.time = m_moments[std::size_t(i < 0 ? i + count : i)];
        return m_renderer.render(request, m_depth);
    }
    py::array times() const
    {
        const auto count = py::ssize_t(size());
        py::array_t<double> seconds(count);
        for (std::size_t i = 0; i < size(); ++i)
            seconds.mutable_at(i) = double(m_moments[i]) * 1e-6;
        return seconds;
    }

private:
    /// As `timelapse` chooses.
    RendererOptions chosen(RendererOptions options) const
    {
        if (options.backend == Backend::Auto)
            options.backend = quickestBackend(m_request, cli::wholePictures(m_moments.size()), options);
        return options;
    }

    const Depth m_depth;
    const std::vector<Microseconds> m_moments;
    const RenderRequest m_request;
    KeptRenderer m_renderer;
};

} // namespace

void addFilms(py::module_ &module)
{
    using namespace py::literals;
    module.def(
        "timelapse",
        [](const PaintingValue &painting, const py::object &path, double fps, double duration, double idle,
           const py::object &size, std::optional<double> scale, const Area &area, bool transparent, bool once,
           const QString &backend, int threads, const py::object &devices, const py::object &progress) {
            return timelapse(painting, pathOf(path), {fps, duration, idle, transparent, once}, {size, scale, area, {}},
                             rendererOptionsOf(backend, threads, devices), progress);
        },
        "painting"_a, "path"_a, py::kw_only(), "fps"_a = 25.0, "duration"_a = 10.0, "idle"_a = 0.5,
        "size"_a = py::none(), "scale"_a = py::none(), "area"_a = py::none(), "transparent"_a = false,
        "once"_a = false, "backend"_a = "auto", "threads"_a = 0, "devices"_a = py::none(), "progress"_a = py::none());
    py::class_<Frames>(module, "Frames")
        .def(py::init([](const PaintingValue &painting, double fps, double duration, double idle, const py::object &size,
                         std::optional<double> scale, const Area &area, bool transparent, const QString &backend,
                         int threads, const py::object &devices, const py::object &type) {
                 return std::make_unique<Frames>(painting, FilmWish{fps, duration, idle, transparent, false},
                                                 ViewWish{size, scale, area, {}}, type,
                                                 rendererOptionsOf(backend, threads, devices));
             }),
             "painting"_a, py::kw_only(), "fps"_a = 25.0, "duration"_a = 10.0, "idle"_a = 0.5, "size"_a = py::none(),
             "scale"_a = py::none(), "area"_a = py::none(), "transparent"_a = false, "backend"_a = "auto",
             "threads"_a = 0, "devices"_a = py::none(), "dtype"_a = "uint8")
        .def("__len__", &Frames::size)
        .def("__getitem__", &Frames::at, "frame"_a)
        .def("__iter__",
             [](const py::object &self) { return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr())); })
        .def_property_readonly("times", &Frames::times);
}

} // namespace suffuse::python

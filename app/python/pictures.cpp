// Pictures as arrays: rendered, written and read.
#include "app/python/pictures.h"

#include "app/python/pixels.h"
#include "app/python/views.h"

#include "render/backends.h"
#include "render/image_io/image_io.h"

#include <QFile>

#include <map>

namespace suffuse::python {

namespace {

/// As image files have it: rounded to nearest, and what is no colour becomes the nearest one.
template <class Whole>
Whole wholeOf(float v)
{
    constexpr auto most = float(std::numeric_limits<Whole>::max());
    return Whole(most * (v > 0 ? std::min(v, 1.0f) : 0.0f) + 0.5f);
}

template <class Whole>
py::array wholeArray(const FloatPicture &picture, int channels)
{
    py::array_t<Whole> array({py::ssize_t(picture.height), py::ssize_t(picture.width), py::ssize_t(channels)});
    Whole *to = array.mutable_data();
    const py::gil_scoped_release released;
    const float *from = picture.rgba.data();
    for (std::size_t i = std::size_t(picture.width) * std::size_t(picture.height); i > 0; --i, from += 4)
        for (int c = 0; c < channels; ++c)
            *to++ = wholeOf<Whole>(from[c]);
    return array;
}

/// The picture's own memory as an array; without alpha a view of it that leaves every fourth number out.
py::array floatArray(std::shared_ptr<const FloatPicture> picture, int channels)
{
    auto *const kept = new std::shared_ptr<const FloatPicture>(std::move(picture));
    const py::capsule owner(kept, [](void *p) { delete static_cast<std::shared_ptr<const FloatPicture> *>(p); });
    const FloatPicture &p = **kept;
    const py::ssize_t item = sizeof(float);
    return py::array_t<float>({py::ssize_t(p.height), py::ssize_t(p.width), py::ssize_t(channels)},
                              {item * 4 * p.width, item * 4, item}, p.rgba.data(), owner);
}

} // namespace

Depth depthOf(const py::object &type)
{
    const auto wanted = py::dtype::from_args(type);
    const auto is = [&](const char *name) { return wanted.equal(py::dtype(std::string(name))); };
    if (is("uint8"))
        return Depth::Bits8;
    if (is("uint16"))
        return Depth::Bits16;
    if (is("float32"))
        return Depth::Float;
    raise(Raised::Value,
          QStringLiteral("dtype %1: give uint8, uint16 or float32").arg(py::str(py::object(wanted)).cast<QString>()));
}

py::array arrayOfPicture(const std::shared_ptr<const FloatPicture> &picture, Depth depth, bool alpha)
{
    const int channels = alpha ? 4 : 3;
    switch (depth) {
    case Depth::Bits8:
        return wholeArray<std::uint8_t>(*picture, channels);
    case Depth::Bits16:
        return wholeArray<std::uint16_t>(*picture, channels);
    case Depth::Float:
        break;
    }
    return floatArray(picture, channels);
}

namespace {

/// What is drawn.
RenderRequest requestOf(const PaintingValue &value, const ViewWish &wish, bool transparent, bool drafts)
{
    const cli::PictureOptions options = pictureOptionsOf(wish, *value.painting);
    RenderRequest request;
    request.painting = drafts ? value.painting : withoutDrafts(value.painting);
    request.time = options.time;
    request.view = View::ofArea(options.area, options.width, options.height);
    request.transparent = transparent;
    return request;
}

/// Raises what went wrong.
void checkDrawn(const Result<RenderStats> &stats)
{
    if (!stats)
        raise(Raised::Plain, stats.error());
}

Result<RenderStats> drawn(Renderer &renderer, const RenderRequest &request, FloatPicture &picture,
                          const std::atomic<bool> &cancel)
{
    try {
        return renderer.render(request, picture, &cancel);
    } catch (const std::bad_alloc &) {
        return Error{QStringLiteral("there is not enough memory for %1 × %2 pixels. Choose a smaller size.")
                         .arg(request.view.width)
                         .arg(request.view.height)};
    }
}

py::array render(const PaintingValue &value, const ViewWish &wish, bool transparent, bool drafts,
                 RendererOptions options, const py::object &type)
{
    const Depth depth = depthOf(type);
    const RenderRequest request = requestOf(value, wish, transparent, drafts);
    if (options.backend == Backend::Auto)
        options.backend = quickestBackend(request, 1, options);
    auto picture = std::make_shared<FloatPicture>();
    Result<RenderStats> stats = Error{};
    withoutLock([&](std::atomic<bool> &cancel) {
        const Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
        stats = renderer ? drawn(**renderer, request, *picture, cancel) : Error{renderer.error()};
    });
    checkDrawn(stats);
    return arrayOfPicture(picture, depth, transparent);
}

} // namespace

KeptRenderer::KeptRenderer(const RendererOptions &options) : m_renderer(valueOf(makeRenderer(options), Raised::Plain)) {}

py::array KeptRenderer::render(const RenderRequest &request, Depth depth)
{
    auto copy = std::make_shared<FloatPicture>();
    Result<RenderStats> stats = Error{};
    withoutLock([&](std::atomic<bool> &cancel) {
        const std::lock_guard lock(m_mutex);
        stats = drawn(*m_renderer, request, m_picture, cancel);
        if (!stats)
            return;
        copy->resize(m_picture.width, m_picture.height);
        std::copy(m_picture.rgba.begin(), m_picture.rgba.end(), copy->rgba.begin());
    });
    checkDrawn(stats);
    return arrayOfPicture(copy, depth, request.transparent);
}

namespace {

/// Draws again and again, and evaluates only what differs: for films and for what is being changed.
class PictureMaker {
public:
    explicit PictureMaker(const RendererOptions &options) : m_renderer(options) {}

    py::array render(const PaintingValue &value, const ViewWish &wish, bool transparent, bool drafts,
                     const py::object &type)
    {
        const Depth depth = depthOf(type);
        return m_renderer.render(requestOf(value, wish, transparent, drafts), depth);
    }
    QString backend() const { return nameOf(m_renderer.renderer().backend()); }
    QString device() const { return m_renderer.renderer().deviceName(); }

private:
    KeptRenderer m_renderer;
};

/// How an array is to be written.
struct WriteWish {
    std::optional<QString> depth;
    int quality;
    double dpi;
};

ImageOptions imageOptionsOf(const WriteWish &wish, const py::array &pixels, ImageFormat format)
{
    static const std::map<QString, ImageDepth> depths = {
        {"8", ImageDepth::Bits8}, {"16", ImageDepth::Bits16}, {"half", ImageDepth::Half}, {"float", ImageDepth::Float}};
    ImageOptions options;
    options.alpha = pixels.shape(2) == 4;
    options.quality = wish.quality;
    options.dpi = wish.dpi;
    if (wish.depth) {
        const auto depth = depths.find(*wish.depth);
        if (depth == depths.end())
            raise(Raised::Value, QStringLiteral("depth %1: give 8, 16, half or float").arg(*wish.depth));
        options.depth = depth->second;
    } else if (whiteOf(pixels, "pixels") == 65535 &&
               (format == ImageFormat::Png || format == ImageFormat::Tiff)) {
        options.depth = ImageDepth::Bits16;
    }
    return options;
}

} // namespace

FloatPicture pictureOf(const py::array &pixels)
{
    const float most = whiteOf(pixels, "pixels");
    const Floats numbers = finiteFloatsOf(pixels, "pixels");
    FloatPicture picture;
    picture.resize(int(pixels.shape(1)), int(pixels.shape(0)));
    const float *from = numbers.data();
    const auto channels = int(pixels.shape(2));
    const py::gil_scoped_release released;
    float *to = picture.rgba.data();
    for (std::size_t i = picture.rgba.size() / 4; i > 0; --i, from += channels, to += 4) {
        for (int c = 0; c < 3; ++c)
            to[c] = from[c] / most;
        to[3] = channels == 4 ? from[3] / most : 1.0f;
    }
    return picture;
}

namespace {

void writePicture(const py::object &path, const py::array &pixels, const WriteWish &wish)
{
    const QString name = pathOf(path);
    const ImageFormat format = imageFormatForPath(name);
    if (format == ImageFormat::Unknown)
        raise(Raised::Value,
              QStringLiteral("%1: unknown ending; use one of %2").arg(name, imageEndings().join(QStringLiteral(", "))));
    if (pixels.ndim() != 3 || (pixels.shape(2) != 3 && pixels.shape(2) != 4) || pixels.size() == 0)
        raise(Raised::Value, QStringLiteral("pixels: give it the shape (height, width, 3 or 4)"));
    if (double(pixels.shape(0)) * double(pixels.shape(1)) > double(maxPicturePixels))
        raise(Raised::Value,
              QStringLiteral("pixels: at most %1 million pixels can be written").arg(maxPicturePixels / 1'000'000));
    ImageOptions options = imageOptionsOf(wish, pixels, format);
    const FloatPicture picture = pictureOf(pixels);
    if (const QString problem = problemOf(format, options, picture.width, picture.height); !problem.isEmpty())
        raise(Raised::Value, QStringLiteral("%1: %2").arg(name, problem));
    Result<void> written;
    withoutLock([&](std::atomic<bool> &cancel) {
        options.cancel = &cancel;
        written = writeImage(name, picture, options);
    });
    if (!written)
        raise(Raised::File, written.error());
}

py::array readPicture(const py::object &path, const py::object &type)
{
    const Depth depth = depthOf(type);
    const QString name = pathOf(path);
    Result<FloatPicture> read = Error{};
    QString closed;
    {
        const py::gil_scoped_release released;
        QFile file(name);
        if (file.open(QIODevice::ReadOnly))
            read = readImage(file.readAll(), name);
        else
            closed = QStringLiteral("%1: %2").arg(name, file.errorString());
    }
    if (!closed.isEmpty())
        raise(Raised::File, closed);
    return arrayOfPicture(std::make_shared<const FloatPicture>(valueOf(std::move(read), Raised::Value)), depth, true);
}

py::list backendList()
{
    std::vector<BackendInfo> known;
    {
        const py::gil_scoped_release released;
        known = backends();
    }
    py::list list;
    for (const BackendInfo &info : known) {
        py::dict row;
        row["backend"] = nameOf(info.backend);
        row["device"] = info.device;
        row["unavailable"] = info.unavailable;
        list.append(row);
    }
    return list;
}

using Area = std::optional<std::array<double, 4>>;

} // namespace

void addPictures(py::module_ &module)
{
    using namespace py::literals;
    module.def(
        "render",
        [](const PaintingValue &painting, const py::object &size, std::optional<double> scale, const Area &area,
           std::optional<double> time, bool transparent, bool drafts, const QString &backend, int threads,
           const py::object &devices, const py::object &type) {
            return render(painting, {size, scale, area, time}, transparent, drafts,
                          rendererOptionsOf(backend, threads, devices), type);
        },
        "painting"_a, py::kw_only(), "size"_a = py::none(), "scale"_a = py::none(), "area"_a = py::none(),
        "time"_a = py::none(), "transparent"_a = false, "drafts"_a = false, "backend"_a = "auto", "threads"_a = 0,
        "devices"_a = py::none(), "dtype"_a = "uint8");
    py::class_<PictureMaker>(module, "Renderer")
        .def(py::init([](const QString &backend, int threads, const py::object &devices) {
                 RendererOptions options = rendererOptionsOf(backend, threads, devices);
                 return std::make_unique<PictureMaker>(options);
             }),
             py::kw_only(), "backend"_a = "cpu", "threads"_a = 0, "devices"_a = py::none())
        .def(
            "render",
            [](PictureMaker &self, const PaintingValue &painting, const py::object &size, std::optional<double> scale,
               const Area &area, std::optional<double> time, bool transparent, bool drafts, const py::object &type) {
                return self.render(painting, {size, scale, area, time}, transparent, drafts, type);
            },
            "painting"_a, py::kw_only(), "size"_a = py::none(), "scale"_a = py::none(), "area"_a = py::none(),
            "time"_a = py::none(), "transparent"_a = false, "drafts"_a = false, "dtype"_a = "uint8")
        .def_property_readonly("backend", &PictureMaker::backend)
        .def_property_readonly("device", &PictureMaker::device);
    module.def(
        "write_picture",
        [](const py::object &path, const py::array &pixels, std::optional<QString> depth, int quality, double dpi) {
            writePicture(path, pixels, {std::move(depth), quality, dpi});
        },
        "path"_a, "pixels"_a, py::kw_only(), "depth"_a = py::none(), "quality"_a = 92, "dpi"_a = 0.0);
    module.def("read_picture", &readPicture, "path"_a, py::kw_only(), "dtype"_a = "uint8");
    module.def("backends", &backendList);
}

} // namespace suffuse::python

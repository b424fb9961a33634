#include "app/cli/options.h"
#include "render/tiles/tile_plan.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace suffuse::cli {

namespace {

const QString sizeOption = QStringLiteral("size");
const QString scaleOption = QStringLiteral("scale");
const QString areaOption = QStringLiteral("area");

Result<Rect> areaOf(const QString &text)
{
    const QStringList parts = text.split(QLatin1Char(','));
    std::array<double, 4> v{};
    bool good = parts.size() == 4;
    for (int i = 0; good && i < 4; ++i) {
        const std::optional<double> number = toNumber(parts.at(i));
        good = number && std::abs(*number) <= 1e12;
        v[std::size_t(i)] = number.value_or(0);
    }
    if (!good || v[2] <= 0 || v[3] <= 0)
        return Error{
            QCoreApplication::translate("Cli", "--area %1: give X,Y,W,H in canvas units, W and H above 0").arg(text)};
    return Rect::of(v[0], v[1], v[2], v[3]);
}

/// A whole number, at least 1.
std::optional<int> countOf(const QString &text)
{
    bool ok = false;
    const int v = text.toInt(&ok);
    return ok && v >= 1 ? std::optional(v) : std::nullopt;
}

/// What --size or --scale ask for; the height follows unless it is given.
struct Wish {
    int width = 0;
    std::optional<int> height;
};

/// "WxH" or "W".
Result<Wish> sizeOf(const QString &text)
{
    const QStringList parts = text.toLower().split(QLatin1Char('x'));
    const std::optional<int> width = countOf(parts.value(0));
    const std::optional<int> height = parts.size() == 2 ? countOf(parts.at(1)) : std::nullopt;
    if (!width || parts.size() > 2 || (parts.size() == 2 && !height))
        return Error{QCoreApplication::translate("Cli", "--size %1: give WxH or W in pixels, e.g. 1024x768").arg(text)};
    return Wish{*width, height};
}

Result<Wish> scaledBy(const QString &text, const Rect &area)
{
    const std::optional<double> factor = toNumber(text);
    if (!factor || *factor <= 0)
        return Error{QCoreApplication::translate("Cli", "--scale %1: give pixels a unit, above 0, e.g. 2").arg(text)};
    const double width = std::clamp(std::round(area.width() * *factor), 1.0, 2147483647.0);
    return Wish{int(width), std::nullopt};
}

QString limitProblem(const Rect &area, int width, PictureLimit limit)
{
    const double height = area.height() / (area.width() / width); // before it is cut to an int
    if (limit == PictureLimit::Side && std::max(double(width), height) > maxTiledSide)
        return QCoreApplication::translate("Cli", "a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a "
                                                  "smaller --size, --scale or --area")
            .arg(width)
            .arg(height, 0, 'f', 0)
            .arg(maxTiledSide);
    if (limit == PictureLimit::Pixels && double(width) * std::max(height, 1.0) > double(maxPicturePixels))
        return QCoreApplication::translate(
                   "Cli", "a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a "
                          "smaller --size, --scale or --area")
            .arg(width)
            .arg(height, 0, 'f', 0)
            .arg(maxPicturePixels / 1'000'000);
    const double zoom = width / area.width();
    if (!(zoom >= 1e-3 && zoom <= 1e9))
        return QCoreApplication::translate(
                   "Cli", "%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale "
                          "or --area")
            .arg(zoom, 0, 'g', 4);
    return {};
}

} // namespace

void addViewOptions(CommandLine &line)
{
    line.add({"size"}, QCoreApplication::translate("Cli", "Pixels: WxH, or W alone; scales uniformly."), "WxH");
    line.add({"scale"}, QCoreApplication::translate("Cli", "Pixels a canvas unit (default 1)."), "F");
    line.add({"area"}, QCoreApplication::translate("Cli", "Part of the canvas, in canvas units (default: all of it)."),
             "X,Y,W,H");
}

Result<PictureOptions> pictureOptions(const CommandLine &line, const Painting &painting, PictureLimit limit)
{
    PictureOptions out;
    out.area = painting.canvas.area();
    if (line.isSet(areaOption)) {
        const Result<Rect> area = areaOf(line.value(areaOption));
        if (!area)
            return Error{area.error()};
        out.area = *area;
    }
    if (line.isSet(sizeOption) && line.isSet(scaleOption))
        return Error{QCoreApplication::translate("Cli", "give --size or --scale, not both")};
    const QString scale = line.isSet(scaleOption) ? line.value(scaleOption) : QStringLiteral("1");
    const Result<Wish> wish = line.isSet(sizeOption) ? sizeOf(line.value(sizeOption)) : scaledBy(scale, out.area);
    if (!wish)
        return Error{wish.error()};
    out.width = wish->width;
    if (const QString problem = limitProblem(out.area, out.width, limit); !problem.isEmpty())
        return Error{problem};
    out.height = std::max(heightForWidth(out.area, out.width), 1);
    if (wish->height && *wish->height != out.height)
        return Error{QCoreApplication::translate(
                         "Cli", "--size %1: the picture is scaled uniformly, so a width of %2 has the height "
                                "%3: use --size %2x%3")
                         .arg(line.value(sizeOption))
                         .arg(out.width)
                         .arg(out.height)};
    const Result<Microseconds> time = timeOption(line, painting);
    if (!time)
        return Error{time.error()};
    out.time = *time;
    return out;
}

Result<Microseconds> timeOption(const CommandLine &line, const Painting &painting)
{
    const QString option = QStringLiteral("time");
    if (!line.isSet(option))
        return painting.end();
    const std::optional<double> seconds = toNumber(line.value(option));
    if (!seconds || std::abs(*seconds) > 1e12)
        return Error{QCoreApplication::translate("Cli", "--time %1: give a moment in seconds, e.g. 1.5")
                         .arg(line.value(option))};
    Microseconds begin = 0;
    for (const StrokePtr &s : painting.strokes)
        begin = std::min(begin, s->born());
    if (toMicroseconds(*seconds) < begin)
        return Error{QCoreApplication::translate("Cli", "--time %1: nothing is painted before %2 s")
                         .arg(line.value(option))
                         .arg(toSeconds(begin))};
    return toMicroseconds(*seconds);
}

Result<RendererOptions> rendererOptions(const CommandLine &line)
{
    static const std::map<QString, Backend> backends = {
        {"auto", Backend::Auto}, {"cpu", Backend::Cpu}, {"cuda", Backend::Cuda}, {"reference", Backend::Reference}};
    const QString backend = QStringLiteral("backend"), threads = QStringLiteral("threads"),
                  devices = QStringLiteral("devices");
    RendererOptions out;
    if (line.isSet(backend)) {
        const auto named = backends.find(line.value(backend));
        if (named == backends.end())
            return Error{QCoreApplication::translate("Cli", "--backend %1: give auto, cpu, cuda or reference")
                             .arg(line.value(backend))};
        out.backend = named->second;
    }
    if (line.isSet(threads)) {
        out.threads = countOf(line.value(threads)).value_or(0);
        if (out.threads < 1 || out.threads > 1024)
            return Error{QCoreApplication::translate("Cli", "--threads %1: give a number from 1 to 1024")
                             .arg(line.value(threads))};
    }
    if (line.isSet(devices)) {
        const bool all = line.value(devices) == QLatin1String("all");
        out.devices = all ? allDevices : countOf(line.value(devices)).value_or(0);
        if (out.devices == 0)
            return Error{QCoreApplication::translate("Cli", "--devices %1: give all, or a number of GPUs, at least 1")
                             .arg(line.value(devices))};
        if (out.backend == Backend::Cpu || out.backend == Backend::Reference)
            return Error{QCoreApplication::translate("Cli", "--devices is for CUDA: use it with --backend cuda")};
    }
    return out;
}

} // namespace suffuse::cli

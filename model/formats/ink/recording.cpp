#include "model/formats/ink/recording.h"

#include "model/brush/brush_width.h"
#include "model/painting/validate.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

struct TimesAndBox {
    Rect box;
    Microseconds start = std::numeric_limits<Microseconds>::max();
    Microseconds end = std::numeric_limits<Microseconds>::min();
};

TimesAndBox extentOf(const Recording &recording)
{
    TimesAndBox e;
    for (const auto &path : recording.paths) {
        for (const PenSample &s : path.samples) {
            e.box.include(s.position);
            e.start = std::min(e.start, s.time);
            e.end = std::max(e.end, s.time);
        }
    }
    return e;
}

/// Makes brush and samples paint a path of given widths. From then on a sample's pressure means its width: the spread
/// follows it, and the density, which would have followed a curve of the pressure, does not.
void takeWidths(const std::vector<double> &widths, Brush &brush, std::vector<PenSample> &samples)
{
    const double most = widths.size() == samples.size() && !widths.empty() ? *std::ranges::max_element(widths) : 0;
    if (!(most > 0))
        return;
    setVisibleWidth(brush, most);
    brush.tip = {};
    brush.taper = {};
    for (const BrushInput input : {BrushInput::Pressure, BrushInput::Tilt, BrushInput::Speed, BrushInput::Distance,
                                   BrushInput::StrokeRandom, BrushInput::Drift}) {
        brush.removeCurve(BrushQuantity::Size, input);
        if (input == BrushInput::Pressure)
            brush.removeCurve(BrushQuantity::Density, input);
    }
    constexpr double least = 0.02; // Brushes make nothing smaller than this share, and 0 would be a lifted pen.
    brush.setCurve(BrushQuantity::Size, BrushInput::Pressure, {});
    for (std::size_t k = 0; k < samples.size(); ++k)
        samples[k].pressure = float(std::clamp(widths[k] / most, least, 1.0));
}

} // namespace

float tiltOf(double altitude)
{
    constexpr double upright = std::numbers::pi / 2, flat = std::numbers::pi / 3;
    return float(std::clamp((upright - altitude) / flat, 0.0, 1.0));
}

Result<Painting> paintRecording(const Recording &recording, const Brush &brush, const QString &fileName)
{
    const TimesAndBox extent = extentOf(recording);
    if (extent.box.isEmpty())
        return fileError(fileName, FileMessages::tr("holds no pen strokes; there is nothing to paint"));
    constexpr double largestCanvas = 1e6;
    const double margin = 2 * brush.spread();
    Painting painting;
    painting.canvas.width = std::max(1.0, std::ceil(extent.box.width() + 2 * margin));
    painting.canvas.height = std::max(1.0, std::ceil(extent.box.height() + 2 * margin));
    if (!(painting.canvas.width <= largestCanvas && painting.canvas.height <= largestCanvas))
        return fileError(fileName,
                         FileMessages::tr("the strokes span %1 × %2 units; at most 1e6 are possible, scale them down")
                             .arg(extent.box.width())
                             .arg(extent.box.height()));
    const Point shift{margin - extent.box.left, margin - extent.box.top};
    StrokeId id = 0;
    for (const auto &path : recording.paths) {
        Brush own = brush;
        if (path.colour)
            own.colour = *path.colour;
        std::vector<PenSample> samples = path.samples;
        for (PenSample &s : samples) {
            s.position = s.position + shift;
            s.time -= extent.start;
        }
        takeWidths(path.widths, own, samples);
        if (StrokePtr stroke = buildStroke(own, id + 1, samples)) {
            painting.strokes.push_back(std::move(stroke));
            ++id;
        }
    }
    if (painting.strokes.empty())
        return fileError(fileName, FileMessages::tr("holds no pen strokes; there is nothing to paint"));
    if (const QString problem = problemOf(painting); !problem.isEmpty())
        return fileError(fileName, problem);
    return painting;
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view space = " \t\r\n\f\v";
    const std::size_t from = text.find_first_not_of(space);
    return from == text.npos ? std::string_view() : text.substr(from, text.find_last_not_of(space) - from + 1);
}

std::optional<double> numberIn(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

QString placeOf(const QByteArray &bytes, qsizetype position)
{
    const QByteArrayView before = QByteArrayView(bytes).first(std::clamp<qsizetype>(position, 0, bytes.size()));
    const qsizetype line = std::count(before.begin(), before.end(), '\n') + 1;
    const qsizetype column = QString::fromUtf8(before.sliced(before.lastIndexOf('\n') + 1)).size() + 1;
    return FileMessages::tr("line %1, column %2").arg(line).arg(column);
}

} // namespace suffuse

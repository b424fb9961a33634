#include "model/formats/ink/recording.h"

#include "model/brush/brush_width.h"
#include "model/painting/validate.h"
#include "model/shaping/picture_stroke.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>

namespace suffuse {

namespace {

constexpr Microseconds denseStep = 8'000, sparseStep = 17'000; ///< the latter takes a knot of the spline
constexpr double besideCorner = 4; ///< how far the points next to a corner lie from it at most, units
constexpr double longest = 24;     ///< pens that move fast have points so far apart on a curve
constexpr double cornersCosine = 0.7;

/// Whether the way turns by more than 45° at a sample.
bool isCorner(const std::vector<PenSample> &samples, std::size_t k)
{
    if (k == 0 || k + 1 >= samples.size())
        return false;
    const Point before = samples[k].position - samples[k - 1].position;
    const Point after = samples[k + 1].position - samples[k].position;
    return dot(before, after) < cornersCosine * length(before) * length(after);
}

/// How a line between points far apart is cut: into pieces that double from both ends to its middle, the outermost of
/// which are not longer than `besideCorner`.
std::vector<double> sharesAlong(double length)
{
    int doublings = 0;
    double pieces = 1; // as many of the outermost ones as the line is long: 2 (2^m − 1) + 2^m
    while (length > besideCorner * pieces && doublings < 40)
        pieces = 3 * std::ldexp(1, ++doublings) - 2;
    std::vector<double> shares;
    double at = 0;
    for (int k = -doublings; k <= doublings; ++k) {
        at += std::ldexp(1, doublings - std::abs(k));
        shares.push_back(at / pieces);
    }
    shares.back() = 1;
    return shares;
}

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
    for (const auto &image : recording.images) {
        e.box.include({image.area.left, image.area.top});
        e.box.include({image.area.right, image.area.bottom});
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

class RecordingPainter {
public:
    RecordingPainter(const Recording &recording, const Brush &brush) : m_recording(recording), m_brush(brush) {}

    Result<Painting> paint(const QString &fileName)
    {
        const TimesAndBox extent = extentOf(m_recording);
        const Error empty = fileError(fileName, FileMessages::tr("holds no pen strokes; there is nothing to paint"));
        if (extent.box.isEmpty())
            return empty;
        const double margin = m_recording.area ? 0 : 2 * m_brush.spread();
        const Rect box = m_recording.area.value_or(extent.box);
        constexpr double largestCanvas = 1e6;
        Canvas &canvas = m_painting.canvas;
        canvas.width = std::max(1.0, std::ceil(box.width() + 2 * margin));
        canvas.height = std::max(1.0, std::ceil(box.height() + 2 * margin));
        canvas.background = m_recording.background.value_or(canvas.background);
        if (!(canvas.width <= largestCanvas && canvas.height <= largestCanvas))
            return fileError(
                fileName, FileMessages::tr("the strokes span %1 × %2 units; at most 1e6 are possible, scale them down")
                              .arg(box.width())
                              .arg(box.height()));
        m_shift = {margin - box.left, margin - box.top};
        m_start = m_recording.paths.empty() ? 0 : extent.start;
        takeAll();
        if (m_painting.strokes.empty())
            return empty;
        if (const QString problem = problemOf(m_painting); !problem.isEmpty())
            return fileError(fileName, problem);
        return std::move(m_painting);
    }

private:
    void takeAll()
    {
        auto image = m_recording.images.begin();
        for (std::size_t k = 0; k <= m_recording.paths.size(); ++k) {
            for (; image != m_recording.images.end() && image->below <= k; ++image)
                take(*image);
            if (k < m_recording.paths.size())
                take(m_recording.paths[k]);
        }
        for (std::size_t k = 0; k < m_recording.groups.size(); ++k)
            if (m_used.contains(int(k))) {
                const Recording::Group &group = m_recording.groups[k];
                Group &own = m_painting.groups.emplace_back();
                own.id = GroupId(k + 1);
                own.parent = GroupId(group.parent + 1);
                own.name = group.name;
            }
    }

    void take(const Recording::Path &path)
    {
        Brush own = m_brush;
        if (path.colour)
            own.colour = *path.colour;
        std::vector<PenSample> samples = path.samples;
        for (PenSample &s : samples) {
            s.position = s.position + m_shift;
            s.time -= m_start;
        }
        takeWidths(path.widths, own, samples);
        const StrokePtr stroke = buildStroke(own, StrokeId(m_painting.strokes.size() + 1), samples);
        if (!stroke || path.group < 0) {
            if (stroke)
                m_painting.strokes.push_back(stroke);
            return;
        }
        auto grouped = std::make_shared<Stroke>(*stroke);
        grouped->group = use(path.group);
        m_painting.strokes.push_back(std::move(grouped));
    }

    void take(const Recording::Image &image)
    {
        const Rect area =
            Rect::of(image.area.left + m_shift.x, image.area.top + m_shift.y, image.area.width(), image.area.height());
        auto stroke =
            std::make_shared<Stroke>(pictureStroke(embeddedPicture(image.bytes, image.width, image.height), area, 0));
        stroke->id = StrokeId(m_painting.strokes.size() + 1);
        stroke->group = use(image.group);
        m_painting.strokes.push_back(std::move(stroke));
    }

    /// Notes that a group and those that it is in have something.
    GroupId use(int group)
    {
        for (int k = group; k >= 0 && m_used.insert(k).second;)
            k = m_recording.groups[std::size_t(k)].parent;
        return GroupId(group + 1);
    }

    const Recording &m_recording;
    const Brush &m_brush;
    Painting m_painting;
    Point m_shift;
    Microseconds m_start = 0;
    std::set<int> m_used;
};

} // namespace

void AssumedTimes::give(Recording::Path &path)
{
    const bool hasWidths = path.widths.size() == path.samples.size();
    std::vector<PenSample> samples;
    std::vector<double> widths;
    for (std::size_t k = 0; k < path.samples.size(); ++k) {
        const PenSample here = path.samples[k];
        const PenSample before = k > 0 ? path.samples[k - 1] : here;
        const double way = length(here.position - before.position);
        std::vector<double> shares{1};
        if (way > longest || isCorner(path.samples, k) || (k > 0 && isCorner(path.samples, k - 1)))
            shares = sharesAlong(way);
        if (shares.size() - 1 > m_spare)
            shares = {1};
        m_spare -= shares.size() - 1;
        for (const double share : shares) {
            if (k > 0)
                m_now += shares.size() > 1 ? sparseStep : denseStep;
            PenSample sample = here;
            if (share < 1)
                sample.position = before.position + share * (here.position - before.position);
            sample.pressure = std::lerp(before.pressure, here.pressure, float(share));
            sample.tilt = std::lerp(before.tilt, here.tilt, float(share));
            sample.time = m_now;
            samples.push_back(sample);
            if (hasWidths)
                widths.push_back(std::lerp(path.widths[k > 0 ? k - 1 : 0], path.widths[k], share));
        }
    }
    path.samples = std::move(samples);
    if (hasWidths)
        path.widths = std::move(widths);
    m_now += denseStep + assumedPause;
}

float tiltOf(double altitude)
{
    constexpr double upright = std::numbers::pi / 2, flat = std::numbers::pi / 3;
    return float(std::clamp((upright - altitude) / flat, 0.0, 1.0));
}

Result<Painting> paintRecording(const Recording &recording, const Brush &brush, const QString &fileName)
{
    return RecordingPainter(recording, brush).paint(fileName);
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

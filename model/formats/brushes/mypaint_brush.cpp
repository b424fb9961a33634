#include "model/formats/brushes/mypaint_brush.h"

#include "model/formats/ink/ink_json.h"
#include "model/formats/messages.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <functional>
#include <numbers>

namespace suffuse {

namespace {

constexpr int curvePoints = 5;

/// One of MyPaint's inputs, and its values where our input is 0 and 1.
struct InputMap {
    const char *name;
    BrushInput input;
    double low, high;
};

constexpr InputMap inputMaps[] = {
    {"pressure", BrushInput::Pressure, 0, 1}, {"speed1", BrushInput::Speed, 0, 4},
    {"speed2", BrushInput::Speed, 0, 4},      {"random", BrushInput::Drift, 0, 1},
    {"stroke", BrushInput::Distance, 0, 1},   {"tilt_declination", BrushInput::Tilt, 90, 30},
};

/// Settings that say how dabs are laid out, or that only programs with dabs have. Nothing is lost without them.
constexpr const char *withoutMeaning[] = {
    "dabs_per_actual_radius",
    "dabs_per_basic_radius",
    "dabs_per_second",
    "anti_aliasing",
    "opaque_linearize",
    "speed1_slowness",
    "speed2_slowness",
    "speed1_gamma",
    "speed2_gamma",
    "stroke_threshold",
    "stroke_duration_logarithmic",
    "stroke_holdtime",
    "restore_color",
    "pressure_gain_log",
    "custom_input_slowness",
    "custom_input", // what uses it is named itself, as "radius_logarithmic × custom"
    "direction_filter",
    "snap_to_pixel",
};

/// Settings that only say how another one works, with that one. If the other one is not used, nothing is lost without
/// them.
constexpr std::pair<const char *, const char *> helpers[] = {
    {"offset_by_speed_slowness", "offset_by_speed"},
    {"smudge_length", "smudge"},
    {"smudge_length_log", "smudge"},
    {"smudge_radius_log", "smudge"},
    {"smudge_bucket", "smudge"},
    {"smudge_transparency", "smudge"},
    {"posterize_num", "posterize"},
};

struct Setting {
    double base = 0;
    QJsonObject inputs;
};

/// The value of a setting's curve at x: straight lines through its points, constant beyond them.
double valueAt(const QJsonArray &points, double x)
{
    const auto at = [&points](qsizetype i, int axis) { return points.at(i).toArray().at(axis).toDouble(); };
    const qsizetype n = points.size();
    if (n == 0)
        return 0;
    if (x <= at(0, 0))
        return at(0, 1);
    for (qsizetype i = 1; i < n; ++i)
        if (x <= at(i, 0))
            return std::lerp(at(i - 1, 1), at(i, 1), (x - at(i - 1, 0)) / std::max(at(i, 0) - at(i - 1, 0), 1e-9));
    return at(n - 1, 1);
}

class MyPaintReader {
public:
    MyPaintReader(const QJsonObject &settings) : m_settings(settings)
    {
        for (const char *name : withoutMeaning)
            m_used.append(QLatin1String(name));
    }

    LoadedBrush read()
    {
        Brush &b = m_loaded.brush;
        b.dynamics.clear();
        b.maxAge = 0.25f;
        const double radius = apply("radius_logarithmic", BrushQuantity::Size, 2, [](double v) { return std::exp(v); });
        const double opacity =
            apply("opaque", BrushQuantity::Opacity, 1, [](double v) { return std::max(v, 0.0); }) *
            apply("opaque_multiply", BrushQuantity::Opacity, 1, [](double v) { return std::max(v, 0.0); });
        shape(std::clamp(radius, 0.1, 1e4));
        const Setting h = setting("color_h"), s = setting("color_s"), v = setting("color_v");
        b.colour = colourOf(h.base, s.base, v.base);
        b.colour.opacity = float(std::clamp(opacity, 0.0, 1.0));
        if (const double slow = setting("slow_tracking").base; slow > 0) {
            b.stabiliser.kind = Stabiliser::Kind::Weighted;
            b.stabiliser.strength = float(std::min(1.0, slow / 10));
        }
        noteTheRest();
        return std::move(m_loaded);
    }

private:
    Setting setting(const char *name)
    {
        const QString key = QLatin1String(name);
        m_used.append(key);
        const QJsonObject o = m_settings.value(key).toObject();
        return {o.value(QLatin1String("base_value")).toDouble(), o.value(QLatin1String("inputs")).toObject()};
    }

    /// Converts a setting's curves, which add up and then go through `map`, to shares of their greatest value. Returns
    /// that value.
    double apply(const char *name, BrushQuantity quantity, double fallback, const std::function<double(double)> &map)
    {
        const bool given = m_settings.contains(QLatin1String(name));
        const Setting s = setting(name);
        if (!given)
            return map(fallback);
        struct Part {
            BrushInput input;
            std::array<double, curvePoints> values{};
            double greatest = 0;
        };
        std::vector<Part> parts;
        double sum = s.base;
        for (const InputMap &m : inputMaps) {
            const QJsonArray points = s.inputs.value(QLatin1String(m.name)).toArray();
            const auto same = [&m](const Part &p) { return p.input == m.input; };
            if (points.isEmpty() || std::any_of(parts.begin(), parts.end(), same))
                continue;
            Part part{m.input, {}, -1e9};
            for (int i = 0; i < curvePoints; ++i) {
                const double x = std::lerp(m.low, m.high, i / (curvePoints - 1.0));
                part.values[std::size_t(i)] = std::clamp(valueAt(points, x), -1e3, 1e3);
                part.greatest = std::max(part.greatest, part.values[std::size_t(i)]);
            }
            sum += part.greatest;
            parts.push_back(part);
        }
        const double whole = map(std::clamp(sum, -20.0, 20.0));
        for (const Part &part : parts) {
            ResponseCurve curve;
            curve.points.clear();
            for (int i = 0; i < curvePoints; ++i) {
                const double share =
                    whole > 0 ? map(std::clamp(sum - part.greatest + part.values[std::size_t(i)], -20.0, 20.0)) / whole
                              : 1;
                curve.points.push_back({float(i) / (curvePoints - 1), float(std::clamp(share, 0.0, 1.0))});
            }
            if (!m_loaded.brush.curve(quantity, part.input))
                m_loaded.brush.setCurve(quantity, part.input, curve);
        }
        for (const QString &input : s.inputs.keys())
            if (std::none_of(std::begin(inputMaps), std::end(inputMaps),
                             [&input](const InputMap &m) { return input == QLatin1String(m.name); }) &&
                !s.inputs.value(input).toArray().isEmpty())
                m_loaded.left.append(QLatin1String(name) + QLatin1String(" × ") + input);
        return whole;
    }

    /// Sets style, spread and ellipse so that paint reaches `radius` units to each side. Soft dabs fade, hard ones have
    /// an edge.
    void shape(double radius)
    {
        Brush &b = m_loaded.brush;
        const bool given = m_settings.contains(QLatin1String("hardness"));
        const double hardness = std::clamp(given ? setting("hardness").base : 0.8, 0.0, 1.0);
        if (hardness < 0.5) {
            b.style = {StyleKind::Feathering, {1, float(1 + hardness), 0}};
            b.peak = 1;
            b.setSpread(radius);
        } else {
            b.style = {StyleKind::Uniform, {0.5f, float(0.02 + 0.16 * (1 - hardness)), 0}};
            b.peak = 1.6f;
            b.setSpread(radius / std::sqrt(std::log(b.peak / 0.5)));
        }
        const double ratio = std::clamp(setting("elliptical_dab_ratio").base, 1.0, 10.0);
        const Setting angle = setting("elliptical_dab_angle");
        if (ratio > 1) {
            b.setSpread(b.spread() / ratio);
            b.tip.ratio = float(ratio * ratio);
            b.tip.followsPath = angle.inputs.contains(QLatin1String("direction"));
            b.tip.angle = b.tip.followsPath ? 0 : float(-angle.base * std::numbers::pi / 180);
        }
    }

    static Colour colourOf(double h, double s, double v)
    {
        h = 6 * (h - std::floor(h));
        s = std::clamp(s, 0.0, 1.0);
        v = std::clamp(v, 0.0, 1.0);
        const auto channel = [=](double shift) {
            const double k = std::fmod(shift + h, 6.0);
            return v * (1 - s * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
        };
        return rybFromSrgb(channel(5), channel(3), channel(1));
    }

    void noteTheRest()
    {
        for (auto it = m_settings.begin(); it != m_settings.end(); ++it) {
            if (m_used.contains(it.key()))
                continue;
            const auto helper =
                std::ranges::find_if(helpers, [&it](const auto &h) { return it.key() == QLatin1String(h.first); });
            if (does(it.key()) && (helper == std::end(helpers) || does(QLatin1String(helper->second))))
                m_loaded.left.append(it.key());
        }
    }

    /// Whether a setting exists and is not 0.
    bool does(const QString &name) const
    {
        const QJsonObject o = m_settings.value(name).toObject();
        const QJsonObject inputs = o.value(QLatin1String("inputs")).toObject();
        const bool curved = std::any_of(inputs.begin(), inputs.end(),
                                        [](const QJsonValue &points) { return !points.toArray().isEmpty(); });
        return o.value(QLatin1String("base_value")).toDouble() != 0 || curved;
    }

    QJsonObject m_settings;
    QStringList m_used;
    LoadedBrush m_loaded;
};

} // namespace

bool isMyPaintBrush(const QByteArray &bytes)
{
    return bytes.contains("\"settings\"") && bytes.contains("\"base_value\"");
}

Result<LoadedBrush> readMyPaintBrush(const QByteArray &bytes, const QString &fileName)
{
    const auto top = parseJsonObject(bytes, fileName);
    if (!top)
        return Error{top.error()};
    const QJsonObject settings = top->value(QLatin1String("settings")).toObject();
    if (settings.isEmpty())
        return fileError(fileName, FileMessages::tr("has no settings; it is not a brush"));
    LoadedBrush loaded = MyPaintReader(settings).read();
    loaded.brush.group = top->value(QLatin1String("group")).toString().left(64);
    if (const QString problem = problemOf(loaded.brush); !problem.isEmpty())
        return fileError(fileName, problem);
    return loaded;
}

} // namespace suffuse

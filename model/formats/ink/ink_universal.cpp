// Universal Ink Model 3, as JSON or packed (.uim): paths are splines, times and pressures stand apart as sensor data.
#include "model/formats/ink/ink_json.h"
#include "model/formats/ink/universal_container.h"
#include "model/painting/ryb.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

enum class Channel { Other, Time, Pressure, Altitude, Azimuth };

struct ChannelType {
    Channel kind = Channel::Other;
    double scale = 1; ///< A value is the sum of the deltas times this. Times are in seconds, altitudes in radians.
};

struct Sensor {
    double start = 0; ///< seconds
    std::vector<double> times, pressures, altitudes;
    bool hasAzimuth = false;
};

QHash<QString, ChannelType> channelTypes(const QJsonObject &input)
{
    QHash<QString, ChannelType> types;
    const QJsonArray contexts =
        input.value(QLatin1String("inputContextData")).toObject().value(QLatin1String("sensorContexts")).toArray();
    for (const QJsonValue &context : contexts) {
        for (const QJsonValue &group : context.toObject().value(QLatin1String("sensorChannelsContext")).toArray()) {
            for (const QJsonValue &value : group.toObject().value(QLatin1String("channels")).toArray()) {
                const QJsonObject channel = value.toObject();
                const QString type = channel.value(QLatin1String("type")).toString();
                ChannelType t;
                t.scale = std::pow(10.0, -std::clamp(channel.value(QLatin1String("precision")).toInt(), 0, 15));
                if (type.endsWith(QLatin1String("/Timestamp"))) {
                    const double perSecond = channel.value(QLatin1String("resolution")).toDouble(1000);
                    t = {Channel::Time, t.scale / (perSecond > 0 ? perSecond : 1000)};
                } else if (type.endsWith(QLatin1String("/Pressure"))) {
                    t.kind = Channel::Pressure;
                } else if (type.endsWith(QLatin1String("/Azimuth"))) {
                    t.kind = Channel::Azimuth;
                } else if (type.endsWith(QLatin1String("/Altitude"))) {
                    const double perRadian = channel.value(QLatin1String("resolution")).toDouble(1);
                    t = {Channel::Altitude, t.scale / (perRadian > 0 ? perRadian : 1)};
                }
                types.insert(channel.value(QLatin1String("id")).toString(), t);
            }
        }
    }
    return types;
}

/// The values of a sensor, which are stored as differences of whole numbers.
std::vector<double> summed(const std::vector<double> &deltas, double scale)
{
    std::vector<double> values;
    double sum = 0;
    for (const double d : deltas)
        values.push_back((sum += d) * scale);
    return values;
}

Result<QHash<QString, Sensor>> sensorsOf(const QJsonObject &input, const QString &fileName)
{
    const auto types = channelTypes(input);
    QHash<QString, Sensor> sensors;
    const QJsonArray list = input.value(QLatin1String("sensorData")).toArray();
    for (qsizetype j = 0; j < list.size(); ++j) {
        const QJsonObject data = list.at(j).toObject();
        Sensor sensor;
        const QJsonValue stamp = data.value(QLatin1String("timestamp"));
        const double start = stamp.isString() ? numberIn(stamp.toString().toStdString()).value_or(0) : stamp.toDouble();
        sensor.start = std::clamp(start, -1e15, 1e15) * 1e-3;
        const QJsonArray channels = data.value(QLatin1String("dataChannels")).toArray();
        for (qsizetype k = 0; k < channels.size(); ++k) {
            const QJsonObject channel = channels.at(k).toObject();
            const ChannelType type = types.value(channel.value(QLatin1String("sensorChannelID")).toString());
            sensor.hasAzimuth = sensor.hasAzimuth || type.kind == Channel::Azimuth;
            if (type.kind == Channel::Other || type.kind == Channel::Azimuth)
                continue;
            const auto values =
                numbersIn(channel.value(QLatin1String("values")), fileName,
                          QStringLiteral("inputData.sensorData[%1].dataChannels[%2].values").arg(j).arg(k));
            if (!values)
                return Error{values.error()};
            (type.kind == Channel::Time       ? sensor.times
             : type.kind == Channel::Pressure ? sensor.pressures
                                              : sensor.altitudes) = summed(*values, type.scale);
        }
        if (std::ranges::all_of(sensor.altitudes, [](double a) { return a == 0; }))
            sensor.altitudes.clear(); // Pens that do not measure the altitude write 0.
        sensors.insert(data.value(QLatin1String("id")).toString(), sensor);
    }
    return sensors;
}

/// The value at a place in [0, 1] of the whole list, linear between its values.
double sampled(const std::vector<double> &values, double at)
{
    const double place = at * double(values.size() - 1);
    const std::size_t k = std::min(std::size_t(place), values.size() - 1);
    const double f = place - double(k);
    return k + 1 < values.size() ? values[k] + f * (values[k + 1] - values[k]) : values[k];
}

std::optional<Colour> colourOf(const QJsonObject &stroke)
{
    const QJsonObject properties =
        stroke.value(QLatin1String("style")).toObject().value(QLatin1String("properties")).toObject();
    if (!properties.contains(QLatin1String("red")))
        return {};
    // A channel of 0 is written as an empty object. Alpha then is left to the brush, which means opaque.
    const auto channel = [&](const char *name, double usual) {
        return properties.value(QLatin1String(name)).toObject().value(QLatin1String("value")).toDouble(usual);
    };
    return rybFromSrgb(channel("red", 0), channel("green", 0), channel("blue", 0), channel("alpha", 1));
}

/// The sizes along a stroke, from the stroke itself or from its style; empty where it has none. They scale the brush's
/// shape.
Result<std::vector<double>> sizesOf(const QJsonObject &stroke, const QString &fileName, const QString &path)
{
    if (stroke.contains(QLatin1String("size"))) {
        auto sizes = numbersIn(stroke.value(QLatin1String("size")), fileName, path + QStringLiteral(".size"));
        if (!sizes || !sizes->empty())
            return sizes;
    }
    const QJsonValue size = stroke.value(QLatin1String("style"))
                                .toObject()
                                .value(QLatin1String("properties"))
                                .toObject()
                                .value(QLatin1String("size"))
                                .toObject()
                                .value(QLatin1String("value"));
    return size.toDouble() > 0 ? std::vector<double>{size.toDouble()} : std::vector<double>();
}

/// The radius of each brush's shape at size 1, by the brush's name. Circles ("…/Circle?precision=8&radius=0.5") may
/// have a radius; it is 1 where none is written, and for other shapes.
struct Shapes {
    QHash<QString, double> radii;
    QSet<QString> notRound;
};

Shapes shapesOf(const QJsonObject &brushes)
{
    static const QRegularExpression radius(QStringLiteral("[?&]radius=([0-9.eE+-]+)"));
    Shapes shapes;
    for (const QJsonValue &value : brushes.value(QLatin1String("vectorBrushes")).toArray()) {
        const QJsonObject brush = value.toObject();
        const QString name = brush.value(QLatin1String("name")).toString();
        const QString uri = brush.value(QLatin1String("prototype"))
                                .toArray()
                                .at(0)
                                .toObject()
                                .value(QLatin1String("shapeURI"))
                                .toString();
        const double given = radius.match(uri).captured(1).toDouble();
        if (given > 0 && given < 1e6)
            shapes.radii.insert(name, given);
        if (!uri.isEmpty() && !uri.contains(QLatin1String("/Circle")))
            shapes.notRound.insert(name);
    }
    for (const QJsonValue &value : brushes.value(QLatin1String("rasterBrushes")).toArray())
        shapes.notRound.insert(value.toObject().value(QLatin1String("name")).toString());
    return shapes;
}

/// Counts what is in a file but cannot be shown by strokes.
class Losses {
public:
    void see(const QJsonObject &stroke, const Shapes &shapes, const Sensor *sensor)
    {
        static const QStringList turns{"rotation", "scaleX", "scaleY", "scaleZ", "offsetX", "offsetY", "offsetZ"};
        m_turned +=
            std::ranges::any_of(turns, [&stroke](const QString &name) { return stroke.contains(name); }) ? 1 : 0;
        m_shaped += shapes.notRound.contains(brushOf(stroke)) ? 1 : 0;
        m_hasAzimuth = m_hasAzimuth || (sensor && sensor->hasAzimuth);
    }
    static QString brushOf(const QJsonObject &stroke)
    {
        return stroke.value(QLatin1String("style")).toObject().value(QLatin1String("brushURI")).toString();
    }
    QString sentence(const QJsonObject &top) const
    {
        const int views = int(top.value(QLatin1String("views")).toArray().size());
        return leftOutSentence({
            {m_shaped, FileMessages::tr("%n brush shape(s)", nullptr, m_shaped)},
            {m_turned, FileMessages::tr("%n turned or stretched brush tip(s)", nullptr, m_turned)},
            {m_hasAzimuth ? 2 : 0, FileMessages::tr("the pen's azimuths")},
            {views, FileMessages::tr("%n view(s) of recognised text", nullptr, views)},
        });
    }

private:
    int m_turned = 0, m_shaped = 0;
    bool m_hasAzimuth = false;
};

Result<Recording::Path> pathOf(const QJsonObject &stroke, const Sensor *sensor, double radius, const QString &fileName,
                               const QString &path)
{
    const auto xs = numbersIn(stroke.value(QLatin1String("splineX")), fileName, path + QStringLiteral(".splineX"));
    if (!xs)
        return Error{xs.error()};
    const auto ys = numbersIn(stroke.value(QLatin1String("splineY")), fileName, path + QStringLiteral(".splineY"));
    if (!ys)
        return Error{ys.error()};
    if (xs->size() != ys->size())
        return fileError(
            fileName,
            FileMessages::tr("%1: splineX has %2 numbers, splineY %3").arg(path).arg(xs->size()).arg(ys->size()));
    const auto sizes = sizesOf(stroke, fileName, path);
    if (!sizes)
        return Error{sizes.error()};
    static const std::vector<double> none;
    const std::vector<double> &pressures = sensor ? sensor->pressures : none;
    const double most = pressures.empty() ? 0 : *std::max_element(pressures.begin(), pressures.end());
    const double scale = most > 1 ? 1 / most : 1;
    Recording::Path result;
    const std::size_t count = xs->size();
    for (std::size_t k = 0; k < count; ++k) {
        const double at = count > 1 ? double(k) / double(count - 1) : 0;
        const double pressure = most > 0 ? std::clamp(sampled(pressures, at) * scale, 0.0, 1.0) : 1;
        const double seconds = sensor && !sensor->times.empty() ? std::clamp(sampled(sensor->times, at), 0.0, 1e9) : 0;
        result.samples.push_back({{(*xs)[k], (*ys)[k]},
                                  toMicroseconds(seconds),
                                  float(pressure),
                                  sensor && !sensor->altitudes.empty() ? tiltOf(sampled(sensor->altitudes, at)) : 0});
        if (!sizes->empty())
            result.widths.push_back(2 * radius * std::clamp(sampled(*sizes, at), 0.0, 1e6));
    }
    result.colour = colourOf(stroke);
    return result;
}

} // namespace

Result<Recording> readUniversalInk(const QByteArray &bytes, const QString &fileName)
{
    const bool isPacked = isUniversalContainer(bytes);
    const auto top = isPacked ? unpackedUniversal(bytes) : parseJsonObject(bytes, fileName);
    if (!top)
        return isPacked ? fileError(fileName, top.error()) : Error{top.error()};
    const auto sensors = sensorsOf(top->value(QLatin1String("inputData")).toObject(), fileName);
    if (!sensors)
        return Error{sensors.error()};
    const QJsonArray strokes =
        top->value(QLatin1String("inkData")).toObject().value(QLatin1String("strokes")).toArray();
    const Shapes shapes = shapesOf(top->value(QLatin1String("brushes")).toObject());
    Losses losses;
    Recording recording;
    AssumedTimes times;
    for (qsizetype k = 0; k < strokes.size(); ++k) {
        const QJsonObject stroke = strokes.at(k).toObject();
        const auto found = sensors->constFind(stroke.value(QLatin1String("sensorDataID")).toString());
        const Sensor *sensor = found == sensors->cend() ? nullptr : &*found;
        losses.see(stroke, shapes, sensor);
        const double radius = shapes.radii.value(Losses::brushOf(stroke), 1);
        auto path = pathOf(stroke, sensor, radius, fileName, QStringLiteral("inkData.strokes[%1]").arg(k));
        if (!path)
            return Error{path.error()};
        const bool timed = sensor && !sensor->times.empty();
        if (!timed)
            times.give(*path);
        for (PenSample &s : path->samples)
            s.time += timed ? toMicroseconds(sensor->start) : 0;
        if (timed && !path->samples.empty())
            times.setNow(path->samples.back().time + assumedPause);
        recording.paths.push_back(std::move(*path));
    }
    recording.leftOut = losses.sentence(*top);
    return recording;
}

} // namespace suffuse

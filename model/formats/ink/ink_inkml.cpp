// InkML of the W3C: traces with channels that their contexts describe, and brushes.
#include "model/formats/ink/inkml_trace.h"
#include "model/formats/ink/recording.h"
#include "model/formats/svg/css/css_colours.h"
#include "model/painting/ryb.h"

#include <QHash>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr double unitsOfInch = 96; ///< as for SVG
constexpr std::size_t mostChannels = 64;
constexpr double farthestInk = 1e7; ///< canvas units

/// How many of the house's units one of a file has: canvas units, seconds or radians. Devices' own units are left as
/// they are.
double unitOf(QStringView name)
{
    constexpr double degree = std::numbers::pi / 180;
    static const QHash<QString, double> units{{"m", unitsOfInch / 0.0254},
                                              {"cm", unitsOfInch / 2.54},
                                              {"mm", unitsOfInch / 25.4},
                                              {"in", unitsOfInch},
                                              {"pt", unitsOfInch / 72},
                                              {"pc", unitsOfInch / 6},
                                              {"himetric", unitsOfInch / 2540},
                                              {"s", 1},
                                              {"ms", 1e-3},
                                              {"deg", degree},
                                              {"rad", 1}};
    return units.value(name.toString(), 1);
}

struct InkChannel {
    QString name;
    double unit = 1; ///< of the house's for one of the file's
    std::optional<double> least = {}, most = {};
};

struct InkFormat {
    std::vector<InkChannel> channels{{"X"}, {"Y"}}; ///< what a file without any has
    std::size_t optional = 0;                       ///< how many of them at the end may lack
};

struct InkPen {
    std::optional<Colour> colour;
    double width = 0; ///< canvas units; 0: not told
    bool ignoresPressure = false;
    bool isShaped = false;
};

struct InkContext {
    InkFormat format;
    QString pen;
};

class InkmlReader {
public:
    InkmlReader(const QByteArray &bytes, const QString &fileName) : m_xml(bytes), m_fileName(fileName) {}

    Result<Recording> read()
    {
        if (!m_xml.readNextStartElement() || m_xml.name() != QLatin1String("ink"))
            fail(FileMessages::tr("the first element is not ink"));
        else
            content(-1, 0);
        if (m_xml.hasError())
            return fileError(m_fileName,
                             FileMessages::tr("line %1, column %2").arg(m_xml.lineNumber()).arg(m_xml.columnNumber()) +
                                 QStringLiteral(": ") + m_xml.errorString());
        m_recording.leftOut = leftOutSentence({
            {m_shaped, FileMessages::tr("%n brush shape(s)", nullptr, m_shaped)},
            {m_hasAzimuth ? 2 : 0, FileMessages::tr("the pen's azimuths")},
            {m_hovering, FileMessages::tr("%n way(s) of the pen over the paper", nullptr, m_hovering)},
            {m_maps, FileMessages::tr("%n mapping(s) of channels", nullptr, m_maps)},
        });
        return std::move(m_recording);
    }

private:
    using Path = Recording::Path; // lupdate takes the name before :: for the context of what follows

    void fail(const QString &what)
    {
        if (!m_xml.hasError())
            m_xml.raiseError(what);
    }

    QString attribute(const char *name) const { return m_xml.attributes().value(QLatin1String(name)).toString(); }
    QString id() const
    {
        const QString own = attribute("xml:id");
        return own.isEmpty() ? attribute("id") : own;
    }
    /// What a reference names; those to other files name nothing here.
    QString referred(const char *name) const
    {
        const QString to = attribute(name);
        return to.startsWith(QLatin1Char('#')) ? to.mid(1) : to;
    }
    std::optional<double> number(const char *name) const { return numberOf(attribute(name)); }
    static std::optional<double> numberOf(const QString &text)
    {
        const QByteArray bytes = text.toLatin1();
        const auto value = numberIn({bytes.constData(), std::size_t(bytes.size())});
        return value && std::abs(*value) <= 1e15 ? value : std::nullopt;
    }

    /// What is in the ink, in definitions, and in groups of traces. What is only defined is not taken before somebody
    /// refers to it.
    void content(int group, int depth, bool defines = false)
    {
        constexpr int deepest = 64;
        if (depth > deepest)
            return fail(FileMessages::tr("its groups are too deep"));
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            const QStringView name = m_xml.name();
            if (name == QLatin1String("trace")) {
                trace(group);
            } else if (name == QLatin1String("traceGroup")) {
                traceGroup(group, depth);
            } else if (name == QLatin1String("definitions")) {
                content(group, depth + 1, true);
            } else if (name == QLatin1String("context")) {
                const QString own = id();
                m_contexts.insert(own, context());
                if (!defines)
                    m_current = m_contexts.value(own);
            } else if (name == QLatin1String("traceFormat")) {
                const QString own = id();
                m_formats.insert(own, traceFormat());
                if (!defines)
                    m_current.format = m_formats.value(own);
            } else if (name == QLatin1String("inkSource")) {
                const QString own = id();
                m_sources.insert(own, inkSource());
            } else if (name == QLatin1String("brush")) {
                const QString own = id();
                m_pens.insert(own, brush());
            } else if (name == QLatin1String("annotation") && group >= 0 && !m_isNamed) {
                m_recording.groups[std::size_t(group)].name = m_xml.readElementText().simplified().left(200);
                m_isNamed = true;
            } else {
                m_maps += name == QLatin1String("mapping") || name == QLatin1String("canvasTransform");
                m_xml.skipCurrentElement();
            }
        }
    }

    void traceGroup(int group, int depth)
    {
        if (m_recording.groups.size() >= mostGroups)
            return fail(FileMessages::tr("has more than %1 layers").arg(mostGroups));
        const InkContext outside = m_current;
        chooseContext();
        const int own = int(m_recording.groups.size());
        m_recording.groups.push_back({FileMessages::tr("Layer %1").arg(own + 1), group});
        m_isNamed = false;
        content(own, depth + 1);
        m_isNamed = true;
        m_current = outside;
    }

    /// Takes what the element at hand refers to.
    void chooseContext()
    {
        if (const auto found = m_contexts.constFind(referred("contextRef")); found != m_contexts.cend())
            m_current = *found;
        if (const QString pen = referred("brushRef"); !pen.isEmpty())
            m_current.pen = pen;
    }

    InkContext context()
    {
        const InkContext outside = m_current;
        m_current = {};
        chooseContext();
        InkContext own = m_current;
        m_current = outside;
        if (const auto found = m_formats.constFind(referred("traceFormatRef")); found != m_formats.cend())
            own.format = *found;
        if (const auto found = m_sources.constFind(referred("inkSourceRef")); found != m_sources.cend())
            own.format = *found;
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            const QString element = id();
            if (m_xml.name() == QLatin1String("inkSource")) {
                m_sources.insert(element, own.format = inkSource());
            } else if (m_xml.name() == QLatin1String("traceFormat")) {
                m_formats.insert(element, own.format = traceFormat());
            } else if (m_xml.name() == QLatin1String("brush")) {
                m_pens.insert(element, brush());
                own.pen = element;
            } else {
                m_xml.skipCurrentElement();
            }
        }
        return own;
    }

    InkFormat inkSource()
    {
        InkFormat format;
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("traceFormat"))
                format = traceFormat();
            else if (m_xml.name() == QLatin1String("channelProperties"))
                channelProperties(format);
            else
                m_xml.skipCurrentElement();
        }
        return format;
    }

    /// How many steps of a channel a unit has.
    void channelProperties(InkFormat &format)
    {
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            const QString units = attribute("units");
            const std::optional<double> value = number("value");
            if (attribute("name") == QLatin1String("resolution") && value && *value > 0 &&
                units.startsWith(QLatin1String("1/")))
                for (InkChannel &channel : format.channels)
                    if (channel.name == attribute("channel"))
                        channel.unit = unitOf(QStringView(units).mid(2)) / *value;
            m_xml.skipCurrentElement();
        }
    }

    InkFormat traceFormat()
    {
        InkFormat format;
        format.channels.clear();
        channels(format, false);
        if (format.channels.empty())
            format = {};
        return format;
    }

    void channels(InkFormat &format, bool mayLack)
    {
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("intermittentChannels") && !mayLack) {
                channels(format, true);
                continue;
            }
            if (m_xml.name() == QLatin1String("channel")) {
                if (format.channels.size() >= mostChannels)
                    return fail(FileMessages::tr("a point has more than %1 values").arg(mostChannels));
                InkChannel channel{attribute("name")};
                const QString units = attribute("units");
                channel.unit = channel.name == QLatin1String("T") && units.isEmpty() ? 1e-3 : unitOf(units);
                channel.least = number("min");
                channel.most = number("max");
                format.channels.push_back(channel);
                format.optional += mayLack;
            }
            m_xml.skipCurrentElement();
        }
    }

    InkPen brush()
    {
        InkPen pen;
        double opacity = 1;
        std::optional<std::array<double, 4>> rgba;
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            const QString name = attribute("name"), value = attribute("value"), units = attribute("units");
            const double amount = numberOf(value).value_or(0);
            if (name == QLatin1String("color"))
                rgba = cssColour(value);
            else if (name == QLatin1String("transparency"))
                opacity = 1 - std::clamp(amount, 0.0, 255.0) / 255;
            else if (name == QLatin1String("width") || (name == QLatin1String("height") && pen.width == 0))
                pen.width = std::clamp(amount * unitOf(units), 0.0, 1e6);
            else if (name == QLatin1String("ignorePressure"))
                pen.ignoresPressure = value == QLatin1String("1") || value == QLatin1String("true");
            else if (name == QLatin1String("tip"))
                pen.isShaped = value != QLatin1String("ellipse");
            m_xml.skipCurrentElement();
        }
        if (rgba)
            pen.colour = rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3] * opacity);
        return pen;
    }

    void trace(int group)
    {
        const InkContext outside = m_current;
        chooseContext();
        const InkContext context = m_current;
        m_current = outside;
        const QString own = id(), prior = referred("priorRef"), goesOn = attribute("continuation");
        const double offset = std::clamp(number("timeOffset").value_or(0) * 1e-3, -1e9, 1e9); // ms
        const bool isUp = attribute("type") == QLatin1String("penUp");
        const QByteArray text = m_xml.readElementText(QXmlStreamReader::SkipChildElements).toLatin1();
        m_hovering += isUp;
        if (isUp || m_xml.hasError())
            return;
        const std::size_t count = context.format.channels.size();
        const auto values = traceValues({text.constData(), std::size_t(text.size())}, count, context.format.optional,
                                        mostSamples - m_samples);
        if (!values)
            return fail(
                FileMessages::tr("the trace is not a list of points with %1 numbers each, or there are more than "
                                 "%2 points")
                    .arg(count)
                    .arg(mostSamples));
        m_samples += values->size() / count;
        Path path = pathOf(*values, context, offset);
        path.group = group;
        if (path.samples.empty() || m_xml.hasError())
            return;
        const auto before = m_paths.constFind(prior);
        if ((goesOn == QLatin1String("middle") || goesOn == QLatin1String("end")) && before != m_paths.cend()) {
            append(path, m_recording.paths[*before]);
            m_paths.insert(own, *before);
            return;
        }
        m_paths.insert(own, m_recording.paths.size());
        m_recording.paths.push_back(std::move(path));
    }

    /// What goes on with a path is a part of it.
    static void append(const Path &more, Path &path)
    {
        if (path.widths.size() == path.samples.size() && more.widths.size() == more.samples.size())
            path.widths.insert(path.widths.end(), more.widths.begin(), more.widths.end());
        else
            path.widths.clear();
        path.samples.insert(path.samples.end(), more.samples.begin(), more.samples.end());
    }

    static int indexOf(const InkFormat &format, const char *name)
    {
        const auto found =
            std::ranges::find_if(format.channels, [&](const InkChannel &c) { return c.name == QLatin1String(name); });
        return found == format.channels.end() ? -1 : int(found - format.channels.begin());
    }

    /// The values of a channel in the house's units; empty where it is not there.
    static std::vector<double> column(const std::vector<double> &values, const InkFormat &format, const char *name)
    {
        std::vector<double> column;
        const int at = indexOf(format, name);
        const std::size_t count = format.channels.size();
        for (std::size_t k = std::size_t(std::max(at, 0)); at >= 0 && k < values.size(); k += count)
            column.push_back(values[k] * format.channels[std::size_t(at)].unit);
        return column;
    }

    /// Pressures from 0 to 1. Where a file does not tell how far they go, they go as far as they are.
    static std::vector<double> pressuresOf(const std::vector<double> &values, const InkFormat &format)
    {
        std::vector<double> pressures = column(values, format, "F");
        if (pressures.empty())
            return {};
        const InkChannel &channel = format.channels[std::size_t(indexOf(format, "F"))];
        const double least = channel.least.value_or(0);
        double most = channel.most.value_or(1);
        for (double &pressure : pressures)
            pressure /= channel.unit;
        if (!channel.most)
            most = std::max(most, *std::ranges::max_element(pressures));
        if (std::ranges::all_of(pressures, [&](double p) { return p <= least; }) || !(most > least))
            return {}; // the pen does not feel any
        for (double &pressure : pressures)
            pressure = std::clamp((pressure - least) / (most - least), 0.0, 1.0);
        return pressures;
    }

    Path pathOf(const std::vector<double> &values, const InkContext &context, double offset)
    {
        const InkPen pen = m_pens.value(context.pen);
        const std::vector<double> xs = column(values, context.format, "X"), ys = column(values, context.format, "Y"),
                                  times = column(values, context.format, "T"),
                                  pressures = pressuresOf(values, context.format);
        std::vector<double> altitudes = column(values, context.format, "OE");
        if (std::ranges::all_of(altitudes, [](double a) { return a == 0; }))
            altitudes.clear(); // Pens that do not measure the altitude write 0.
        const std::vector<double> azimuths = column(values, context.format, "OA");
        m_hasAzimuth = m_hasAzimuth || std::ranges::any_of(azimuths, [](double a) { return a != 0; });
        m_shaped += pen.isShaped;
        Path path;
        if (xs.size() != ys.size() || xs.empty()) {
            if (!values.empty())
                fail(FileMessages::tr("the trace has no X and Y"));
            return path;
        }
        for (std::size_t k = 0; k < xs.size(); ++k) {
            if (!(std::abs(xs[k]) <= farthestInk && std::abs(ys[k]) <= farthestInk))
                fail(FileMessages::tr("a point is farther than 1e7 units away"));
            const double pressure = pressures.empty() ? 1 : pressures[k];
            const double seconds = times.empty() ? 0 : std::clamp(times[k], -1e9, 1e9) + offset;
            path.samples.push_back({{xs[k], ys[k]},
                                    toMicroseconds(seconds),
                                    float(pressure),
                                    altitudes.empty() ? 0 : tiltOf(altitudes[k])});
            // Half of the pressure gives the pen's own width.
            if (pen.width > 0)
                path.widths.push_back(pen.width * (pressures.empty() || pen.ignoresPressure ? 1 : 0.5 + pressure));
        }
        path.colour = pen.colour;
        if (times.empty())
            m_times.give(path);
        else
            m_times.setNow(path.samples.back().time + assumedPause);
        return path;
    }

    QXmlStreamReader m_xml;
    const QString &m_fileName;
    Recording m_recording;
    QHash<QString, InkContext> m_contexts;
    QHash<QString, InkFormat> m_formats, m_sources;
    QHash<QString, InkPen> m_pens;
    QHash<QString, std::size_t> m_paths;
    InkContext m_current;
    AssumedTimes m_times;
    std::size_t m_samples = 0;
    bool m_isNamed = true; ///< whether the group at hand has its name
    bool m_hasAzimuth = false;
    int m_shaped = 0, m_hovering = 0, m_maps = 0;
};

} // namespace

Result<Recording> readInkml(const QByteArray &bytes, const QString &fileName)
{
    return InkmlReader(bytes, fileName).read();
}

} // namespace suffuse

#include "model/formats/brushes/brush_file.h"

#include "model/formats/messages.h"
#include "model/formats/brushes/mypaint_brush.h"
#include "model/formats/text/text_numbers.h"
#include "model/formats/text/value_json.h"
#include "model/painting/validate.h"

#include <QFile>
#include <QFileInfo>

namespace suffuse {

namespace {

using Names = std::string_view;

constexpr qint64 largestBrushFile = 1 << 20;
constexpr Names quantityNames[] = {"size", "density", "granulation", "opacity", "maxAge", "colourMix"};
constexpr Names inputNames[] = {"pressure", "tilt", "speed", "distance", "strokeRandom", "drift"};
constexpr Names stabiliserNames[] = {"off", "weighted", "string"};

class BrushReader {
public:
    BrushReader(const QByteArray &bytes, const QString &fileName) : m_json(bytes, fileName), m_fileName(fileName) {}

    Result<Brush> read()
    {
        m_brush.dynamics.clear();
        members();
        m_json.finish();
        if (!m_json.ok())
            return Error{m_json.error()};
        if (const QString problem = problemOf(m_brush); !problem.isEmpty())
            return fileError(m_fileName, problem);
        return std::move(m_brush);
    }

private:
    void members()
    {
        static constexpr Names names[] = {
            "format", "version",     "name",     "group",     "style",        "mix",         "diffusion",
            "peak",   "granulation", "maxAge",   "colour",    "second",       "jitter",      "tip",
            "taper",  "stabiliser",  "dynamics", "fullSpeed", "fullDistance", "driftLength", "interval"};
        Brush &b = m_brush;
        const auto found = m_json.object(names, [&](int k) {
            switch (k) {
            case 0:
                return format();
            case 1:
                return version();
            case 2:
                return m_json.read(b.name);
            case 3:
                return m_json.read(b.group);
            case 4:
                return readJson(m_json, b.style);
            case 5:
                return readJson(m_json, b.mix);
            case 6:
                return m_json.read(b.diffusion);
            case 7:
                return m_json.read(b.peak);
            case 8:
                return m_json.read(b.granulation);
            case 9:
                return m_json.read(b.maxAge);
            case 10:
                return readJson(m_json, b.colour);
            case 11:
                return readJson(m_json, b.secondColour);
            case 12:
                return jitter(b.jitter);
            case 13:
                return tip(b.tip);
            case 14:
                return taper(b.taper);
            case 15:
                return stabiliser(b.stabiliser);
            case 16:
                m_json.array([&](std::size_t i) { dynamic(i); });
                return;
            case 17:
                return m_json.read(b.fullSpeed);
            case 18:
                return m_json.read(b.fullDistance);
            case 19:
                return m_json.read(b.driftLength);
            default:
                return m_json.readSeconds(b.interval);
            }
        });
        requireMembers(m_json, found, names, memberBit(0) | memberBit(1) | memberBit(4));
    }

    void format()
    {
        static constexpr Names formats[] = {"suffuse-brush"};
        readChoice(m_json, formats);
    }

    void version()
    {
        std::uint64_t value = 0;
        m_json.read(value);
        if (m_json.ok() && value != 1)
            m_json.fail(FileMessages::tr("%1 is not a version that this program reads; it reads 1").arg(value));
    }

    void jitter(ColourJitter &j)
    {
        static constexpr Names names[] = {"red", "yellow", "blue", "lightness", "along"};
        m_json.object(names, [&](int k) {
            if (k == 4)
                return m_json.read(j.along);
            m_json.read(k == 0 ? j.red : k == 1 ? j.yellow : k == 2 ? j.blue : j.lightness);
        });
    }

    void tip(TipShape &t)
    {
        static constexpr Names names[] = {"ratio", "angle", "followsPath"};
        m_json.object(names, [&](int k) {
            if (k == 2)
                return m_json.read(t.followsPath);
            m_json.read(k == 0 ? t.ratio : t.angle);
        });
    }

    void taper(Taper &t)
    {
        static constexpr Names names[] = {"in", "out", "tip"};
        m_json.object(names, [&](int k) { m_json.read(k == 0 ? t.in : k == 1 ? t.out : t.tip); });
    }

    void stabiliser(Stabiliser &s)
    {
        static constexpr Names names[] = {"kind", "strength", "length"};
        m_json.object(names, [&](int k) {
            if (k == 0)
                s.kind = Stabiliser::Kind(readChoice(m_json, stabiliserNames));
            else
                m_json.read(k == 1 ? s.strength : s.length);
        });
    }

    void dynamic(std::size_t index)
    {
        static constexpr Names names[] = {"quantity", "input", "curve"};
        BrushDynamic d;
        d.curve.points.clear();
        const auto found = m_json.object(names, [&](int k) {
            if (k == 0)
                d.quantity = BrushQuantity(readChoice(m_json, quantityNames));
            else if (k == 1)
                d.input = BrushInput(readChoice(m_json, inputNames));
            else
                curve(d.curve);
        });
        requireMembers(m_json, found, names, memberBit(0) | memberBit(1) | memberBit(2));
        if (!m_json.ok())
            return;
        if (m_brush.curve(d.quantity, d.input) || index >= std::size_t(brushQuantities * brushInputs))
            m_json.fail(FileMessages::tr("another curve is of the same quantity and input; keep one of them"));
        else
            m_brush.setCurve(d.quantity, d.input, d.curve);
    }

    void curve(ResponseCurve &curve)
    {
        m_json.array([&](std::size_t i) {
            std::array<float, 2> point{};
            m_json.readAll(point);
            if (i < ResponseCurve::mostPoints)
                curve.points.push_back({point[0], point[1]});
        });
        if (m_json.ok() && !curve.isValid())
            m_json.fail(FileMessages::tr("needs 2 to 16 points [x, y] in [0, 1], from left to right"));
    }

    JsonReader m_json;
    QString m_fileName;
    Brush m_brush;
};

QByteArray quoted(std::string_view text)
{
    return '"' + QByteArray(text.data(), qsizetype(text.size())) + '"';
}

/// Appends one line of numbers with their names.
void appendNumbers(QByteArray &out, std::initializer_list<std::pair<const char *, float>> members)
{
    for (bool first = true; const auto &[name, value] : members) {
        appendNumber(out.append(first ? "\"" : ", \"").append(name).append("\": "), value);
        first = false;
    }
}

void append(QByteArray &out, const BrushDynamic &d)
{
    out.append("{\"quantity\": ").append(quoted(quantityNames[int(d.quantity)]));
    out.append(", \"input\": ").append(quoted(inputNames[int(d.input)])).append(", \"curve\": [");
    for (std::size_t i = 0; i < d.curve.points.size(); ++i) {
        appendNumber(out.append(i ? ", [" : "["), d.curve.points[i].x);
        appendNumber(out.append(", "), d.curve.points[i].y);
        out.append(']');
    }
    out.append("]}");
}

Result<QByteArray> bytesOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fileError(path, FileMessages::tr("could not be opened: %1").arg(file.errorString()));
    const QByteArray bytes = file.read(largestBrushFile + 1);
    if (bytes.size() > largestBrushFile)
        return fileError(path, FileMessages::tr("has more than 1 MB; it is not a brush"));
    return bytes;
}

} // namespace

Result<Brush> readBrush(const QByteArray &bytes, const QString &fileName)
{
    return BrushReader(bytes, fileName).read();
}

QByteArray writeBrush(const Brush &b)
{
    QByteArray out = "{\"format\": \"suffuse-brush\", \"version\": 1,\n ";
    appendString(out.append("\"name\": "), b.name);
    appendString(out.append(", \"group\": "), b.group);
    appendJson(out.append(",\n \"style\": "), b.style);
    appendJson(out.append(", \"mix\": "), b.mix);
    appendNumbers(out.append(",\n "),
                  {{"diffusion", b.diffusion}, {"peak", b.peak}, {"granulation", b.granulation}, {"maxAge", b.maxAge}});
    appendJson(out.append(",\n \"colour\": "), b.colour);
    appendJson(out.append(", \"second\": "), b.secondColour);
    appendNumbers(out.append(",\n \"jitter\": {"), {{"red", b.jitter.red},
                                                    {"yellow", b.jitter.yellow},
                                                    {"blue", b.jitter.blue},
                                                    {"lightness", b.jitter.lightness}});
    out.append(b.jitter.along ? ", \"along\": true}" : ", \"along\": false}");
    appendNumbers(out.append(",\n \"tip\": {"), {{"ratio", b.tip.ratio}, {"angle", b.tip.angle}});
    out.append(b.tip.followsPath ? ", \"followsPath\": true}" : ", \"followsPath\": false}");
    appendNumbers(out.append(",\n \"taper\": {"), {{"in", b.taper.in}, {"out", b.taper.out}, {"tip", b.taper.tip}});
    out.append("},\n \"stabiliser\": {\"kind\": ").append(quoted(stabiliserNames[int(b.stabiliser.kind)])).append(", ");
    appendNumbers(out, {{"strength", b.stabiliser.strength}, {"length", b.stabiliser.length}});
    out.append("},\n \"dynamics\": [");
    for (std::size_t i = 0; i < b.dynamics.size(); ++i)
        append(out.append(i ? ",\n  " : "\n  "), b.dynamics[i]);
    appendNumbers(out.append("],\n "),
                  {{"fullSpeed", b.fullSpeed}, {"fullDistance", b.fullDistance}, {"driftLength", b.driftLength}});
    appendSeconds(out.append(", \"interval\": "), b.interval);
    out.append("}\n");
    return out;
}

Result<LoadedBrush> loadBrush(const QString &path)
{
    const auto bytes = bytesOf(path);
    if (!bytes)
        return Error{bytes.error()};
    LoadedBrush loaded;
    if (isMyPaintBrush(*bytes)) {
        auto read = readMyPaintBrush(*bytes, path);
        if (!read)
            return read;
        loaded = std::move(*read);
    } else {
        auto brush = readBrush(*bytes, path);
        if (!brush)
            return Error{brush.error()};
        loaded.brush = std::move(*brush);
    }
    if (loaded.brush.name.trimmed().isEmpty())
        loaded.brush.name = QFileInfo(path).completeBaseName();
    return loaded;
}

} // namespace suffuse

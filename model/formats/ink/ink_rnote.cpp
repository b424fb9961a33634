// Notebooks of Rnote (.rnote) from version 0.5 on: JSON that is packed by gzip. They hold no times. Strokes lie in the
// order of their layers and, within one, of a counter.
#include "model/formats/gzip.h"
#include "model/formats/ink/ink_json.h"
#include "model/painting/ryb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse {

namespace {

constexpr qsizetype mostRnoteValues = qsizetype(1) << 23; ///< in the text; each takes more memory than there
constexpr double farthestRnote = 1e7;                     ///< canvas units

/// The pieces into which a curve between two points of older notebooks is cut.
constexpr int piecesOfCurve = 4;

std::optional<std::array<double, 4>> rgbaOf(const QJsonValue &value)
{
    if (!value.isObject())
        return std::nullopt;
    const QJsonObject colour = value.toObject();
    const auto channel = [&](const char *name) {
        return std::clamp(colour.value(QLatin1String(name)).toDouble(), 0.0, 1.0);
    };
    return std::array{channel("r"), channel("g"), channel("b"), channel("a")};
}

/// How wide the pen is at a pressure.
double widthByCurve(const QString &curve, double width, double pressure)
{
    if (curve == QLatin1String("linear"))
        return width * pressure;
    if (curve == QLatin1String("sqrt"))
        return width * std::sqrt(pressure);
    if (curve == QLatin1String("cbrt"))
        return width * std::cbrt(pressure);
    if (curve == QLatin1String("pow2"))
        return width * pressure * pressure;
    return curve == QLatin1String("pow3") ? width * pressure * pressure * pressure : width;
}

class RnoteReader {
public:
    RnoteReader(const QJsonObject &top, const QString &fileName) : m_fileName(fileName)
    {
        const QJsonObject data = top.value(QLatin1String("data")).toObject();
        m_snapshot = data.value(QLatin1String("engine_snapshot")).toObject();
        m_document = m_snapshot.value(QLatin1String("document")).toObject();
        if (m_snapshot.isEmpty()) { // before version 0.5.9
            m_snapshot = data.value(QLatin1String("store_snapshot")).toObject();
            m_document = data.value(QLatin1String("document")).toObject();
        }
    }

    Result<Recording> read()
    {
        if (m_snapshot.isEmpty())
            return fileError(m_fileName, FileMessages::tr("holds no notebook that can be read; save it with Rnote 0.5 "
                                                          "or later"));
        const QJsonArray strokes = m_snapshot.value(QLatin1String("stroke_components")).toArray();
        for (const RnotePlace &place : orderOf(strokes)) {
            const QJsonObject value = strokes.at(place.index).toObject().value(QLatin1String("value")).toObject();
            const QJsonValue stroke = value.value(QLatin1String("brushstroke"));
            if (stroke.isObject())
                take(stroke.toObject(), place.index);
            m_texts += value.contains(QLatin1String("textstroke"));
            m_shapes += value.contains(QLatin1String("shapestroke"));
            m_images += value.contains(QLatin1String("bitmapimage")) || value.contains(QLatin1String("vectorimage"));
            if (!m_error.isEmpty())
                return fileError(m_fileName, m_error);
        }
        takeDocument();
        m_recording.leftOut = leftOutSentence({
            {m_texts, FileMessages::tr("%n text(s)", nullptr, m_texts)},
            {m_shapes, FileMessages::tr("%n shape(s)", nullptr, m_shapes)},
            {m_images, FileMessages::tr("%n image(s)", nullptr, m_images)},
            {m_papers, FileMessages::tr("%n ruled or printed paper(s)", nullptr, m_papers)},
        });
        return std::move(m_recording);
    }

private:
    struct RnotePlace {
        int layer = 0;
        double counter = 0;
        qsizetype index = 0;
    };

    /// Documents lie lowest, then images, then markers, then what was written. Names were other letters once.
    static int heightOf(const QJsonValue &layer)
    {
        const QString name = layer.toString().toLower();
        if (name == QLatin1String("document"))
            return 0;
        if (name == QLatin1String("image"))
            return 1;
        if (name == QLatin1String("highlighter"))
            return 2;
        const QJsonObject own = layer.toObject();
        const QJsonValue number = own.value(QLatin1String("user_layer"));
        return 3 +
               std::clamp((number.isUndefined() ? own.value(QLatin1String("UserLayer")) : number).toInt(), 0, 1 << 20);
    }

    std::vector<RnotePlace> orderOf(const QJsonArray &strokes) const
    {
        const QJsonArray chrono = m_snapshot.value(QLatin1String("chrono_components")).toArray(),
                         trash = m_snapshot.value(QLatin1String("trash_components")).toArray();
        const auto of = [](const QJsonArray &components, qsizetype k) {
            return components.at(k).toObject().value(QLatin1String("value")).toObject();
        };
        std::vector<RnotePlace> order;
        for (qsizetype k = 0; k < strokes.size(); ++k) {
            if (!strokes.at(k).toObject().value(QLatin1String("value")).isObject() ||
                of(trash, k).value(QLatin1String("trashed")).toBool()) // what was deleted leaves its place
                continue;
            const QJsonObject when = of(chrono, k);
            order.push_back(
                {heightOf(when.value(QLatin1String("layer"))), when.value(QLatin1String("t")).toDouble(), k});
        }
        std::ranges::stable_sort(order, [](const RnotePlace &a, const RnotePlace &b) {
            return a.layer != b.layer ? a.layer < b.layer : a.counter < b.counter;
        });
        return order;
    }

    void fail(const QString &what)
    {
        if (m_error.isEmpty())
            m_error = what;
    }

    Point pointOf(const QJsonValue &value)
    {
        const QJsonArray xy = value.toArray();
        const Point point{xy.at(0).toDouble(std::nan("")), xy.at(1).toDouble(std::nan(""))};
        if (std::abs(point.x) <= farthestRnote && std::abs(point.y) <= farthestRnote)
            return point;
        fail(m_where + FileMessages::tr("a point is not two numbers within ±1e7"));
        return {};
    }

    static double pressureOf(const QJsonObject &element)
    {
        return std::clamp(element.value(QLatin1String("pressure")).toDouble(1), 0.0, 1.0);
    }

    void add(Recording::Path &path, Point point, double pressure)
    {
        if (++m_samples > mostSamples)
            return fail(FileMessages::tr("has more than %1 points").arg(mostSamples));
        path.samples.push_back({point, 0, float(pressure)});
    }

    void addElement(Recording::Path &path, const QJsonValue &value)
    {
        const QJsonObject element = value.toObject();
        add(path, pointOf(element.value(QLatin1String("pos"))), pressureOf(element));
    }

    /// A piece of a path. Curves are cut into lines, which are as short as those that newer notebooks have.
    void addPiece(Recording::Path &path, const QJsonValue &value)
    {
        const QJsonObject piece = value.toObject();
        if (piece.isEmpty())
            return;
        const QString kind = piece.begin().key();
        const QJsonObject parts = piece.begin().value().toObject();
        const QJsonValue end = parts.value(QLatin1String("end"));
        if (kind == QLatin1String("dot"))
            return addElement(path, parts.value(QLatin1String("element")));
        if (path.samples.empty() && parts.contains(QLatin1String("start")))
            addElement(path, parts.value(QLatin1String("start")));
        const bool hasTwo = parts.contains(QLatin1String("cp1"));
        if (path.samples.empty() || !(hasTwo || parts.contains(QLatin1String("cp"))))
            return addElement(path, end);
        const PenSample from = path.samples.back();
        const Point to = pointOf(end.toObject().value(QLatin1String("pos")));
        const double pressure = pressureOf(end.toObject());
        Cubic cubic;
        if (hasTwo) {
            cubic = {{from.position, pointOf(parts.value(QLatin1String("cp1"))),
                      pointOf(parts.value(QLatin1String("cp2"))), to}};
        } else {
            const Point between = pointOf(parts.value(QLatin1String("cp")));
            cubic = {{from.position, from.position + 2.0 / 3 * (between - from.position), to + 2.0 / 3 * (between - to),
                      to}};
        }
        for (int k = 1; k <= piecesOfCurve; ++k) {
            const double at = double(k) / piecesOfCurve;
            add(path, cubic.at(at), std::lerp(double(from.pressure), pressure, at));
        }
    }

    /// What is drawn by a brush has neither a fill nor dashes there, whatever its style says.
    void take(const QJsonObject &stroke, qsizetype index)
    {
        m_where = QStringLiteral("stroke_components[%1]: ").arg(index);
        Recording::Path path;
        const QJsonValue pieces = stroke.value(QLatin1String("path"));
        if (pieces.isObject())
            addElement(path, pieces.toObject().value(QLatin1String("start")));
        for (const QJsonValue &piece :
             pieces.isObject() ? pieces.toObject().value(QLatin1String("segments")).toArray() : pieces.toArray())
            if (m_error.isEmpty())
                addPiece(path, piece);
        const QJsonObject styles = stroke.value(QLatin1String("style")).toObject();
        const QJsonObject style = styles.isEmpty() ? QJsonObject() : styles.begin().value().toObject();
        if (const auto rgba = rgbaOf(style.value(QLatin1String("stroke_color"))))
            path.colour = rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3]);
        const double width = std::clamp(style.value(QLatin1String("stroke_width")).toDouble(), 0.0, 1e6);
        const QString curve = style.value(QLatin1String("pressure_curve")).toString();
        if (width > 0)
            for (const PenSample &sample : path.samples)
                path.widths.push_back(widthByCurve(curve, width, double(sample.pressure)));
        m_times.give(path);
        if (!path.samples.empty() && m_error.isEmpty())
            m_recording.paths.push_back(std::move(path));
    }

    /// The paper. One without an end is as large as what is on it.
    void takeDocument()
    {
        const QJsonObject config = m_document.value(QLatin1String("config")).toObject();
        const auto value = [&](const char *name) {
            const QJsonValue own = m_document.value(QLatin1String(name));
            return own.isUndefined() ? config.value(QLatin1String(name)) : own;
        };
        const auto number = [&](const char *name) { return value(name).toDouble(std::nan("")); };
        const QJsonObject background = value("background").toObject();
        if (const auto rgba = rgbaOf(background.value(QLatin1String("color"))))
            m_recording.background = rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], 1);
        const QString pattern = background.value(QLatin1String("pattern")).toString();
        m_papers += !pattern.isEmpty() && pattern != QLatin1String("none");
        const double x = number("x"), y = number("y"), width = number("width"), height = number("height");
        const bool isSheet = std::abs(x) <= farthestRnote && std::abs(y) <= farthestRnote && width >= 1 &&
                             height >= 1 && width <= 1e6 && height <= 1e6;
        if (isSheet && value("layout").toString() != QLatin1String("infinite"))
            m_recording.area = Rect::of(x, y, width, height);
    }

    const QString &m_fileName;
    QJsonObject m_snapshot, m_document;
    Recording m_recording;
    AssumedTimes m_times;
    QString m_where, m_error;
    std::size_t m_samples = 0;
    int m_texts = 0, m_shapes = 0, m_images = 0, m_papers = 0;
};

} // namespace

bool isRnote(std::string_view text)
{
    const std::string_view beginning = text.substr(0, 4096);
    return beginning.find("\"version\"") != text.npos && beginning.find("\"data\"") != text.npos &&
           (beginning.find("\"engine_snapshot\"") != text.npos || beginning.find("\"document\"") != text.npos);
}

Result<Recording> readRnote(const QByteArray &bytes, const QString &fileName)
{
    const Result<QByteArray> text = isGzip(bytes) ? unpackedGzip(bytes, largestInk) : Result<QByteArray>(bytes);
    if (!text)
        return fileError(fileName, text.error());
    if (text->count(',') > mostRnoteValues)
        return fileError(fileName, FileMessages::tr("has more than %1 numbers").arg(mostRnoteValues));
    const auto top = parseJsonObject(*text, fileName);
    return top ? RnoteReader(*top, fileName).read() : Error{top.error()};
}

} // namespace suffuse

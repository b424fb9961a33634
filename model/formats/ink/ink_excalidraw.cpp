// Excalidraw's drawings and libraries: their freedraw elements. They hold no times.
#include "model/formats/ink/ink_json.h"
#include "model/formats/svg/css/css_colours.h"
#include "model/painting/ryb.h"

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

std::optional<Colour> colourOfElement(const QJsonObject &element)
{
    const auto rgba = cssColour(element.value(QLatin1String("strokeColor")).toString());
    if (!rgba)
        return {};
    const double opacity = std::clamp(element.value(QLatin1String("opacity")).toDouble(100) / 100, 0.0, 1.0);
    return rybFromSrgb((*rgba)[0], (*rgba)[1], (*rgba)[2], (*rgba)[3] * opacity);
}

/// Turns a point around the middle of its element's box, as Excalidraw does.
Point turned(Point p, Point centre, double angle)
{
    const Point d = p - centre;
    const double c = std::cos(angle), s = std::sin(angle);
    return centre + Point{c * d.x - s * d.y, s * d.x + c * d.y};
}

/// The width of a freehand stroke as Excalidraw draws it (with perfect-freehand). Its size is 4.25 times the stroke's
/// width. Pressure makes it thinner by up to 0.6, eased by a quarter of a sine. The size is a radius.
double widthAt(double strokeWidth, double pressure)
{
    const double radius = 4.25 * strokeWidth * std::sin(0.5 * std::numbers::pi * (0.5 - 0.6 * (0.5 - pressure)));
    return 2 * radius;
}

Result<Recording::Path> pathOf(const QJsonObject &element, const QString &fileName, const QString &path)
{
    const auto placed = numbersIn(QJsonArray{element.value(QLatin1String("x")), element.value(QLatin1String("y")),
                                             element.value(QLatin1String("angle")).toDouble()},
                                  fileName, path + QStringLiteral(".(x, y)"));
    if (!placed)
        return Error{placed.error()};
    const Point corner{(*placed)[0], (*placed)[1]};
    const QJsonArray points = element.value(QLatin1String("points")).toArray();
    const QJsonArray pressures = element.value(QLatin1String("pressures")).toArray();
    const double strokeWidth = std::clamp(element.value(QLatin1String("strokeWidth")).toDouble(), 0.0, 1e6);
    const bool isSimulated = element.value(QLatin1String("simulatePressure")).toBool();
    Recording::Path result;
    Rect box;
    for (qsizetype k = 0; k < points.size(); ++k) {
        const QString place = QStringLiteral("%1.points[%2]").arg(path).arg(k);
        const auto xy = numbersIn(points.at(k), fileName, place);
        if (!xy)
            return Error{xy.error()};
        if (xy->size() < 2)
            return fileError(fileName, FileMessages::tr("%1: has less than 2 numbers").arg(place));
        // If there is no pressure, or 0 throughout in older files, the device had none.
        const double pressure = pressures.at(k).toDouble(1);
        const Point p = corner + Point{(*xy)[0], (*xy)[1]};
        box.include(p);
        result.samples.push_back({p, 0, float(pressure > 0 ? std::min(pressure, 1.0) : 1.0)});
        if (strokeWidth > 0) {
            const bool isMeasured = !isSimulated && k < pressures.size() && pressure > 0;
            result.widths.push_back(widthAt(strokeWidth, isMeasured ? std::min(pressure, 1.0) : 0.5));
        }
    }
    const double angle = (*placed)[2];
    for (PenSample &s : result.samples)
        s.position = angle != 0 ? turned(s.position, box.centre(), angle) : s.position;
    result.colour = colourOfElement(element);
    return result;
}

/// Whether Excalidraw fills a freehand stroke, which it does if the stroke ends where it began.
bool isFilled(const QJsonObject &element, const Recording::Path &path)
{
    const auto rgba = cssColour(element.value(QLatin1String("backgroundColor")).toString());
    constexpr double loop = 8; // canvas units
    return rgba && (*rgba)[3] > 0 && path.samples.size() > 2 &&
           length(path.samples.front().position - path.samples.back().position) <= loop;
}

/// The lists of elements of a drawing ("elements") or of a library ("library" in version 1, "libraryItems" in version
/// 2).
std::vector<std::pair<QString, QJsonArray>> elementLists(const QJsonObject &top)
{
    std::vector<std::pair<QString, QJsonArray>> lists;
    if (top.contains(QLatin1String("elements")))
        lists.emplace_back(QStringLiteral("elements"), top.value(QLatin1String("elements")).toArray());
    for (const QString &name : {QStringLiteral("libraryItems"), QStringLiteral("library")}) {
        const QJsonArray items = top.value(name).toArray();
        for (qsizetype k = 0; k < items.size(); ++k) {
            const QJsonValue item = items.at(k);
            const QString path = QStringLiteral("%1[%2]").arg(name).arg(k);
            if (item.isArray())
                lists.emplace_back(path, item.toArray());
            else
                lists.emplace_back(path + QStringLiteral(".elements"),
                                   item.toObject().value(QLatin1String("elements")).toArray());
        }
    }
    return lists;
}

} // namespace

Result<Recording> readExcalidraw(const QByteArray &bytes, const QString &fileName)
{
    const auto top = parseJsonObject(bytes, fileName);
    if (!top)
        return Error{top.error()};
    Recording recording;
    AssumedTimes times;
    int others = 0, fills = 0;
    for (const auto &[listPath, elements] : elementLists(*top)) {
        for (qsizetype k = 0; k < elements.size(); ++k) {
            const QJsonObject element = elements.at(k).toObject();
            if (element.value(QLatin1String("isDeleted")).toBool())
                continue;
            if (element.value(QLatin1String("type")) != QLatin1String("freedraw")) {
                ++others;
                continue;
            }
            auto path = pathOf(element, fileName, QStringLiteral("%1[%2]").arg(listPath).arg(k));
            if (!path)
                return Error{path.error()};
            fills += isFilled(element, *path) ? 1 : 0;
            times.give(*path);
            recording.paths.push_back(std::move(*path));
        }
    }
    if (recording.paths.empty())
        return fileError(fileName, FileMessages::tr("holds no freedraw elements; only those become strokes"));
    recording.leftOut =
        leftOutSentence({{fills, FileMessages::tr("%n fill(s)", nullptr, fills)},
                         {others, FileMessages::tr("%n element(s) not drawn freehand", nullptr, others)}});
    return recording;
}

} // namespace suffuse

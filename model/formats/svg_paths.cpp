#include "model/formats/svg_paths.h"

#include "model/formats/css_colours.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <cmath>
#include <numbers>
#include <set>

namespace suffuse {

namespace {

constexpr int deepestNesting = 256;

/// x′ = a x + c y + e, y′ = b x + d y + f, as SVG writes it.
struct Matrix {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point map(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    Matrix operator*(const Matrix &o) const
    {
        return {a * o.a + c * o.b, b * o.a + d * o.b,     a * o.c + c * o.d,
                b * o.c + d * o.d, a * o.e + c * o.f + e, b * o.e + d * o.f + f};
    }
    double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

Matrix oneTransform(const QString &name, const std::vector<double> &v)
{
    const auto at = [&v](std::size_t i, double otherwise) { return i < v.size() ? v[i] : otherwise; };
    constexpr double degree = std::numbers::pi / 180;
    if (name == "matrix" && v.size() == 6)
        return {v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate")
        return {1, 0, 0, 1, at(0, 0), at(1, 0)};
    if (name == "scale")
        return {at(0, 1), 0, 0, at(1, at(0, 1)), 0, 0};
    if (name == "rotate") {
        const double c = std::cos(at(0, 0) * degree), s = std::sin(at(0, 0) * degree);
        const Matrix there{1, 0, 0, 1, at(1, 0), at(2, 0)}, back{1, 0, 0, 1, -at(1, 0), -at(2, 0)};
        return there * Matrix{c, s, -s, c, 0, 0} * back;
    }
    if (name == "skewX")
        return {1, 0, std::tan(at(0, 0) * degree), 1, 0, 0};
    if (name == "skewY")
        return {1, std::tan(at(0, 0) * degree), 0, 1, 0, 0};
    return {};
}

Matrix transformOf(const QString &text)
{
    static const QRegularExpression call("([a-zA-Z]+)\\s*\\(([^)]*)\\)"), separator("[\\s,]+");
    Matrix result;
    for (auto it = call.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        std::vector<double> values;
        for (const QString &number : match.captured(2).split(separator, Qt::SkipEmptyParts))
            values.push_back(number.toDouble());
        result = result * oneTransform(match.captured(1), values);
    }
    return result;
}

/// What children inherit.
struct State {
    Matrix matrix;
    QString fill = "black", stroke = "none";
    double fillOpacity = 1, strokeOpacity = 1, opacity = 1, strokeWidth = 1;
    bool visible = true;
};

double shareOf(const QString &text, double otherwise)
{
    bool ok = false;
    QString number = text.trimmed();
    const bool percent = number.endsWith('%');
    if (percent)
        number.chop(1);
    const double value = number.toDouble(&ok) / (percent ? 100 : 1);
    return ok && std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : otherwise;
}

double lengthOf(const QString &text, double otherwise)
{
    static const QRegularExpression form("^\\s*([-+0-9.eE]+)\\s*(px)?\\s*$");
    bool ok = false;
    const double value = form.match(text).captured(1).toDouble(&ok);
    return ok && std::isfinite(value) && value >= 0 ? value : otherwise;
}

void setProperty(State &state, const QString &name, const QString &value)
{
    if (value.isEmpty() || value == "inherit")
        return;
    if (name == "fill")
        state.fill = value;
    else if (name == "stroke")
        state.stroke = value;
    else if (name == "fill-opacity")
        state.fillOpacity = shareOf(value, state.fillOpacity);
    else if (name == "stroke-opacity")
        state.strokeOpacity = shareOf(value, state.strokeOpacity);
    else if (name == "opacity")
        state.opacity *= shareOf(value, 1);
    else if (name == "stroke-width")
        state.strokeWidth = lengthOf(value, state.strokeWidth);
    else if (name == "visibility")
        state.visible = value == "visible";
    else if (name == "display" && value == "none")
        state.visible = false;
}

/// Attributes first, then the style attribute, which goes before them.
State inherited(const State &parent, const QXmlStreamAttributes &attributes)
{
    State state = parent;
    if (attributes.hasAttribute("transform"))
        state.matrix = parent.matrix * transformOf(attributes.value("transform").toString());
    for (const QXmlStreamAttribute &a : attributes)
        setProperty(state, a.name().toString(), a.value().toString().trimmed());
    for (const QString &entry : attributes.value("style").toString().split(';', Qt::SkipEmptyParts)) {
        const qsizetype colon = entry.indexOf(':');
        setProperty(state, entry.left(colon).trimmed(), colon < 0 ? QString() : entry.mid(colon + 1).trimmed());
    }
    return state;
}

std::optional<std::array<double, 4>> paintOf(const QString &text, double opacity)
{
    if (text == "none")
        return {};
    std::optional<std::array<double, 4>> colour = cssColour(text);
    if (!colour) // a gradient, or the like
        colour = {0, 0, 0, 1};
    (*colour)[3] *= opacity;
    return (*colour)[3] > 0 ? colour : std::nullopt;
}

void addPaths(const State &state, const QString &data, std::vector<SvgPath> &paths)
{
    SvgPath style;
    style.stroke = paintOf(state.stroke, state.strokeOpacity * state.opacity);
    style.fill = paintOf(state.fill, state.fillOpacity * state.opacity);
    style.strokeWidth = state.strokeWidth * state.matrix.scale();
    if (!state.visible || (!style.stroke && !style.fill))
        return;
    for (std::vector<Cubic> &curves : parsePathData(data)) {
        bool finite = true;
        for (Cubic &cubic : curves)
            for (Point &p : cubic.p) {
                p = state.matrix.map(p);
                finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
            }
        if (!finite)
            continue;
        paths.push_back(style);
        paths.back().curves = std::move(curves);
    }
}

bool isOnlyDefined(QStringView element)
{
    static const std::set<QString> names{"defs", "clipPath", "mask", "pattern", "marker", "symbol", "metadata"};
    return names.contains(element.toString());
}

} // namespace

Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes)
{
    QXmlStreamReader xml(bytes);
    std::vector<SvgPath> paths;
    std::vector<State> open{State()};
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement) {
            if (isOnlyDefined(xml.name()) || int(open.size()) > deepestNesting) {
                xml.skipCurrentElement();
                continue;
            }
            open.push_back(inherited(open.back(), xml.attributes()));
            if (xml.name() == QLatin1String("path"))
                addPaths(open.back(), xml.attributes().value("d").toString(), paths);
        } else if (token == QXmlStreamReader::EndElement && open.size() > 1) {
            open.pop_back();
        }
    }
    if (xml.hasError())
        return Error{
            QCoreApplication::translate("SvgPaths", "SVG, line %1: %2").arg(xml.lineNumber()).arg(xml.errorString())};
    return paths;
}

} // namespace suffuse

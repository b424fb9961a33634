#include "model/formats/svg_paths.h"

#include "model/formats/svg/css_colours.h"
#include "model/formats/svg/svg_shapes.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>

namespace suffuse {

namespace {

constexpr int deepestNesting = 256;
constexpr int mostDrawn = 200'000; ///< elements, those of every <use> counted
constexpr std::size_t mostCurves = 2'000'000;

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
        state.strokeWidth = std::max(0.0, svgLength(value).value_or(state.strokeWidth));
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

/// Not all on one straight line.
bool enclosesArea(const std::vector<Cubic> &curves)
{
    const Point from = curves.front().p[0];
    Point farthest;
    const auto visit = [&](auto see) {
        for (const Cubic &cubic : curves)
            for (const Point &p : cubic.p)
                see(p - from);
    };
    visit([&](Point arm) { farthest = length(arm) > length(farthest) ? arm : farthest; });
    double widest = 0;
    visit([&](Point arm) { widest = std::max(widest, std::abs(farthest.x * arm.y - farthest.y * arm.x)); });
    return widest > 1e-9 * (farthest.x * farthest.x + farthest.y * farthest.y);
}

bool isOnlyDefined(const QString &element)
{
    static const std::set<QString> names{"defs", "clipPath", "mask", "pattern", "marker", "symbol", "metadata"};
    return names.contains(element);
}

struct Element {
    QString name;
    QXmlStreamAttributes attributes;
    std::vector<std::unique_ptr<Element>> children;
};

/// A document's elements, and what they draw.
class Drawing {
public:
    /// What lies deeper than the deepest nesting is left out. Empty, or what is wrong with the document.
    QString read(QXmlStreamReader &xml)
    {
        std::vector<Element *> open{&m_root};
        while (!xml.atEnd()) {
            const auto token = xml.readNext();
            if (token == QXmlStreamReader::EndElement)
                open.pop_back();
            if (token != QXmlStreamReader::StartElement)
                continue;
            if (int(open.size()) > deepestNesting) {
                xml.skipCurrentElement();
                continue;
            }
            auto element = std::make_unique<Element>();
            element->name = xml.name().toString();
            element->attributes = xml.attributes();
            if (const QString id = element->attributes.value("id").toString(); !id.isEmpty())
                m_named.emplace(id, element.get());
            open.back()->children.push_back(std::move(element));
            open.push_back(open.back()->children.back().get());
        }
        return xml.hasError() ? xml.errorString() : QString();
    }

    /// The outermost element's attributes.
    QXmlStreamAttributes root() const
    {
        return m_root.children.empty() ? QXmlStreamAttributes() : m_root.children.front()->attributes;
    }

    /// Of what was drawn.
    int leftOut() const { return m_leftOut; }
    int fills() const { return m_fills; }

    std::vector<SvgPath> paths()
    {
        drawChildren(m_root, State(), 0);
        return std::move(m_paths);
    }

private:
    void drawChildren(const Element &element, const State &state, int depth)
    {
        for (const std::unique_ptr<Element> &child : element.children)
            if (!isOnlyDefined(child->name))
                draw(*child, state, depth + 1);
    }

    void draw(const Element &element, const State &parent, int depth)
    {
        if (depth > deepestNesting || ++m_drawn > mostDrawn || m_curves > mostCurves) // a <use> may be about itself
            return;
        const State state = inherited(parent, element.attributes);
        if (element.name == QLatin1String("use"))
            use(element, state, depth);
        else if (element.name == QLatin1String("text") || element.name == QLatin1String("image"))
            m_leftOut += state.visible ? 1 : 0;
        else if (const QString data = svgPathData(element.name, element.attributes); !data.isEmpty())
            addPaths(state, data);
        else
            drawChildren(element, state, depth);
    }

    void use(const Element &element, State state, int depth)
    {
        const QXmlStreamAttributes &a = element.attributes;
        QString target = a.value("href").toString();
        if (target.isEmpty())
            target = a.value(QLatin1String("http://www.w3.org/1999/xlink"), QLatin1String("href")).toString();
        const auto it = target.startsWith('#') ? m_named.find(target.mid(1)) : m_named.end();
        if (it == m_named.end())
            return;
        const auto place = [&a](const char *name) { return svgLength(a.value(QLatin1String(name)).toString()); };
        state.matrix = state.matrix * Matrix{1, 0, 0, 1, place("x").value_or(0), place("y").value_or(0)};
        if (it->second->name == QLatin1String("symbol"))
            drawChildren(*it->second, inherited(state, it->second->attributes), depth + 1);
        else
            draw(*it->second, state, depth + 1);
    }

    void addPaths(const State &state, const QString &data)
    {
        const std::size_t before = m_paths.size();
        suffuse::addPaths(state, data, m_paths);
        m_fills += int(std::count_if(m_paths.begin() + std::ptrdiff_t(before), m_paths.end(),
                                     [](const SvgPath &path) { return path.fill && enclosesArea(path.curves); }));
        for (std::size_t i = before; i < m_paths.size(); ++i)
            m_curves += m_paths[i].curves.size();
        if (m_curves > mostCurves)
            m_paths.erase(m_paths.begin() + std::ptrdiff_t(before), m_paths.end());
    }

    Element m_root;
    std::map<QString, const Element *> m_named; ///< by id, the first of each
    std::vector<SvgPath> m_paths;
    int m_drawn = 0, m_leftOut = 0, m_fills = 0;
    std::size_t m_curves = 0;
};

/// A size of the document; nothing for per cents and what is no size.
std::optional<double> sizeOf(const QXmlStreamAttributes &root, const char *name)
{
    const std::optional<double> size = svgLength(root.value(QLatin1String(name)).toString());
    return size && *size > 0 ? size : std::nullopt;
}

/// Empty where there is none.
Rect viewBoxOf(const QXmlStreamAttributes &root)
{
    static const QRegularExpression separator("[\\s,]+");
    std::vector<double> v;
    for (const QString &number : root.value(QLatin1String("viewBox")).toString().split(separator, Qt::SkipEmptyParts)) {
        bool ok = false;
        v.push_back(number.toDouble(&ok));
        if (!ok || !std::isfinite(v.back()))
            return {};
    }
    return v.size() == 4 && v[2] > 0 && v[3] > 0 ? Rect::of(v[0], v[1], v[2], v[3]) : Rect();
}

/// Area and scale; the sides' ratio is the view box's, however it is to be placed in width × height.
void takeSize(SvgDrawing &drawing, const QXmlStreamAttributes &root)
{
    const std::optional<double> width = sizeOf(root, "width"), height = sizeOf(root, "height");
    drawing.area = viewBoxOf(root);
    if (drawing.area.isEmpty()) {
        if (width && height)
            drawing.area = Rect::of(0, 0, *width, *height);
        return;
    }
    const double byWidth = width.value_or(HUGE_VAL) / drawing.area.width();
    const double byHeight = height.value_or(HUGE_VAL) / drawing.area.height();
    const double scale = std::min(byWidth, byHeight);
    drawing.scale = std::isfinite(scale) ? scale : 1;
}

} // namespace

Result<SvgDrawing> readSvgDrawing(const QByteArray &bytes)
{
    QXmlStreamReader xml(bytes);
    Drawing drawn;
    if (const QString problem = drawn.read(xml); !problem.isEmpty())
        return Error{QCoreApplication::translate("SvgPaths", "SVG, line %1: %2").arg(xml.lineNumber()).arg(problem)};
    SvgDrawing drawing;
    takeSize(drawing, drawn.root());
    drawing.paths = drawn.paths();
    drawing.leftOut = drawn.leftOut();
    drawing.fills = drawn.fills();
    return drawing;
}

Result<std::vector<SvgPath>> readSvgPaths(const QByteArray &bytes)
{
    Result<SvgDrawing> drawing = readSvgDrawing(bytes);
    if (!drawing)
        return Error{drawing.error()};
    return std::move(drawing->paths);
}

} // namespace suffuse

#include "model/formats/svg/svg_style.h"

#include "model/formats/svg/css/css_blending.h"
#include "model/formats/svg/css/css_colours.h"
#include "model/formats/svg/paths/svg_shapes.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

std::optional<double> shareOf(const QString &text)
{
    bool ok = false;
    QString number = text;
    const bool percent = number.endsWith('%');
    if (percent)
        number.chop(1);
    const double value = number.toDouble(&ok) / (percent ? 100 : 1);
    return ok && std::isfinite(value) ? std::optional(std::clamp(value, 0.0, 1.0)) : std::nullopt;
}

bool isPaint(const QString &text)
{
    return text == QLatin1String("none") || text.startsWith(QLatin1String("context-")) ||
           text.compare(QLatin1String("currentcolor"), Qt::CaseInsensitive) == 0 || !svgReference(text).isEmpty() ||
           cssColour(text);
}

/// Lengths of dashes and gaps; none if one of them is negative, or if the text is none.
std::vector<double> dashesFrom(const QString &text, const SvgUnits &units)
{
    static const QRegularExpression separator(QStringLiteral("[\\s,]+"));
    std::vector<double> dashes;
    for (const QString &length : text.split(separator, Qt::SkipEmptyParts)) {
        dashes.push_back(svgLength(length, units, SvgAxis::Any).value_or(-1));
        if (!(dashes.back() >= 0) || dashes.size() > 1000)
            return {};
    }
    return dashes;
}

const QSet<QString> &knownProperties()
{
    static const QStringList list =
        QStringLiteral("fill stroke fill-opacity stroke-opacity opacity stroke-width stroke-linecap stroke-linejoin "
                       "stroke-miterlimit stroke-dasharray stroke-dashoffset visibility display color stop-color "
                       "stop-opacity fill-rule clip-rule marker marker-start marker-mid marker-end clip-path mask "
                       "filter mix-blend-mode isolation transform vector-effect overflow paint-order font-size "
                       "font-family font-weight "
                       "font-style font-stretch font-width font-variant font-variant-caps text-anchor letter-spacing word-spacing baseline-shift dominant-baseline "
                       "alignment-baseline text-decoration text-decoration-line direction writing-mode white-space")
            .split(u' ');
    static const QSet<QString> names(list.begin(), list.end());
    return names;
}

/// Whether a value makes sense for a property, so that it may replace a weaker one.
bool isValid(const QString &property, const QString &value)
{
    if (value == QLatin1String("inherit"))
        return true;
    if (property == QLatin1String("fill") || property == QLatin1String("stroke"))
        return isPaint(value);
    if (property == QLatin1String("color") || property == QLatin1String("stop-color"))
        return cssColour(value) || value.compare(QLatin1String("currentcolor"), Qt::CaseInsensitive) == 0;
    if (property.endsWith(QLatin1String("opacity")))
        return shareOf(value).has_value();
    if (property == QLatin1String("stroke-width"))
        return svgLength(value, {}, SvgAxis::Any).value_or(-1) >= 0;
    if (property == QLatin1String("stroke-miterlimit"))
        return value.toDouble() >= 1;
    return true;
}

using Properties = SvgProperties;

/// The properties of an element: the strongest declaration of each.
Properties propertiesOf(const SvgElement &element, CssSheet &sheet)
{
    Properties properties;
    const auto set = [&properties](const QString &name, const QString &value) {
        if (knownProperties().contains(name) && isValid(name, value))
            properties.insert(name, value);
        else if (name == QLatin1String("font"))
            properties.insert(svgFontShorthand(value));
    };
    for (const QXmlStreamAttribute &a : element.attributes)
        if (a.namespaceUri().isEmpty())
            set(a.name().toString(), a.value().trimmed().toString());
    const std::vector<CssDeclaration> own = cssDeclarations(element.attribute("style"));
    const CssSheet::Declarations &ruled = sheet.matching(element);
    for (const bool important : {false, true}) {
        for (const CssDeclaration *d : ruled)
            if (d->important == important)
                set(d->property, d->value);
        for (const CssDeclaration &d : own)
            if (d.important == important)
                set(d.property, d.value);
    }
    return properties;
}

void takePen(const Properties &all, const SvgUnits &units, Pen &pen)
{
    const auto take = [&all](const char *name, auto use) { svgTake(all, name, use); };
    const auto length = [&units](const QString &v) { return svgLength(v, units, SvgAxis::Any); };
    take("stroke-width", [&](const QString &v) { pen.width = *length(v); });
    take("stroke-linecap", [&](const QString &v) {
        pen.cap = v == QLatin1String("round")    ? LineCap::Round
                  : v == QLatin1String("square") ? LineCap::Square
                                                 : LineCap::Butt;
    });
    take("stroke-linejoin", [&](const QString &v) {
        pen.join = v == QLatin1String("round")   ? LineJoin::Round
                   : v == QLatin1String("bevel") ? LineJoin::Bevel
                                                 : LineJoin::Miter;
    });
    take("stroke-miterlimit", [&](const QString &v) { pen.miterLimit = v.toDouble(); });
    take("stroke-dasharray", [&](const QString &v) { pen.dashes = dashesFrom(v, units); });
    take("stroke-dashoffset", [&](const QString &v) { pen.dashOffset = length(v).value_or(0); });
}

SvgColour colourFrom(const QString &text, const SvgColour &current)
{
    return cssColour(text).value_or(current); // It is currentColor.
}

/// Whether an element paints an area and nothing over it, so that its opacity can be that of its paint.
bool paintsOnce(const SvgElement &element, const SvgStyle &style)
{
    static const QSet<QString> shapes{"path", "rect", "circle", "ellipse", "polyline", "polygon"};
    return shapes.contains(element.name) && style.stroke == QLatin1String("none") &&
           std::ranges::all_of(style.markers, [](const QString &marker) { return marker == QLatin1String("none"); });
}

} // namespace

SvgStyle SvgStyle::of(const SvgElement &element, const SvgStyle &parent, CssSheet &sheet)
{
    SvgStyle style = parent;
    style.isDisplayed = true, style.keepsWidth = style.overflows = false;
    style.blend = BlendMode::Normal, style.isBlendUnknown = style.isIsolated = false;
    style.clipPath.clear(), style.mask.clear(), style.filter.clear();
    const Properties all = propertiesOf(element, sheet);
    const auto take = [&all](const char *name, auto use) { svgTake(all, name, use); };
    const auto share = [&take](const char *name, double &value) {
        take(name, [&value](const QString &text) { value = *shareOf(text); });
    };
    const auto text = [&take](const char *name, QString &value) {
        take(name, [&value](const QString &given) { value = given; });
    };
    take("color", [&](const QString &v) { style.current = colourFrom(v, parent.current); });
    text("fill", style.fill), text("stroke", style.stroke);
    share("fill-opacity", style.fillOpacity), share("stroke-opacity", style.strokeOpacity);
    style.opacity = 1;
    share("opacity", style.opacity);
    style.isFaded = parent.isFaded || style.opacity < 1;
    take("font-size", [&](const QString &v) { style.units.fontSize = svgFontSize(v, parent.units); });
    style.font = SvgFont::of(all, parent.font, style.units);
    if (const QStringView space =
            element.attributes.value(QLatin1String("http://www.w3.org/XML/1998/namespace"), QLatin1String("space"));
        !space.isEmpty() && !all.contains(QLatin1String("white-space")))
        style.font.keepsSpace = space == QLatin1String("preserve");
    takePen(all, style.units, style.pen);
    take("fill-rule", [&](const QString &v) { style.isEvenOdd = v == QLatin1String("evenodd"); });
    take("clip-rule", [&](const QString &v) { style.isClipEvenOdd = v == QLatin1String("evenodd"); });
    take("paint-order", [&](const QString &v) { style.order = v; });
    take("overflow",
         [&](const QString &v) { style.overflows = v == QLatin1String("visible") || v == QLatin1String("auto"); });
    take("visibility", [&](const QString &v) { style.isVisible = v == QLatin1String("visible"); });
    take("display", [&](const QString &v) { style.isDisplayed = v != QLatin1String("none"); });
    take("vector-effect",
         [&](const QString &v) { style.keepsWidth = v.contains(QLatin1String("non-scaling-stroke")); });
    take("transform", [&](const QString &v) { style.matrix = parent.matrix * svgTransform(v); });
    for (QString &marker : style.markers)
        text("marker", marker);
    text("marker-start", style.markers[0]), text("marker-mid", style.markers[1]), text("marker-end", style.markers[2]);
    text("clip-path", style.clipPath), text("mask", style.mask), text("filter", style.filter);
    take("mix-blend-mode", [&](const QString &v) {
        const std::optional<BlendMode> mode = blendModeFrom(v);
        style.blend = mode.value_or(BlendMode::Normal);
        style.isBlendUnknown = !mode;
    });
    take("isolation", [&](const QString &v) { style.isIsolated = v == QLatin1String("isolate"); });
    if (paintsOnce(element, style)) {
        style.fillOpacity *= std::exchange(style.opacity, 1.0);
        style.isFaded = parent.isFaded;
    }
    return style;
}

QString svgReference(const QString &paint)
{
    static const QRegularExpression form(QStringLiteral("^url\\(\\s*[\"']?(#[^\"')]*?)[\"']?\\s*\\)"));
    return paint.startsWith(QLatin1String("url")) ? form.match(paint).captured(1) : QString();
}

SvgStyle SvgStyle::ofDefinition(const SvgElement &element, CssSheet &sheet)
{
    const auto *parent = static_cast<const SvgElement *>(element.parent);
    return of(element, parent ? ofDefinition(*parent, sheet) : SvgStyle(), sheet);
}

std::vector<SvgStop> svgStops(const SvgElement *gradient, SvgTree &tree)
{
    std::vector<SvgStop> stops;
    for (int hops = 0; gradient && gradient->name.endsWith(QLatin1String("Gradient")) && stops.empty() && hops < 32;
         ++hops, gradient = tree.target(*gradient)) {
        const SvgStyle around = SvgStyle::ofDefinition(*gradient, tree.sheet());
        const Properties outer = propertiesOf(*gradient, tree.sheet());
        for (const auto &child : gradient->children) {
            const QString offset = child->attribute("offset").trimmed();
            const std::optional<double> place = offset.isEmpty() ? 0 : shareOf(offset);
            if (child->name != QLatin1String("stop") || stops.size() >= 1000 || !place)
                continue;
            const Properties p = propertiesOf(*child, tree.sheet());
            const auto value = [&](const char *name, const char *usual) {
                const QString given = p.value(name, usual);
                return given == QLatin1String("inherit") ? outer.value(name, usual) : given;
            };
            SvgStop stop;
            stop.colour = colourFrom(value("stop-color", "black"), SvgStyle::of(*child, around, tree.sheet()).current);
            stop.colour[3] *= shareOf(value("stop-opacity", "1")).value_or(1);
            stop.offset = stops.empty() ? *place : std::max(*place, stops.back().offset);
            stops.push_back(stop);
        }
    }
    return stops;
}

QString SvgStyle::inContext(const QString &paint) const
{
    return paint == QLatin1String("context-fill")     ? contextFill
           : paint == QLatin1String("context-stroke") ? contextStroke
                                                      : paint;
}

SvgPaint svgPaint(const QString &paint, double opacity, const SvgColour &current, SvgTree &tree)
{
    SvgPaint result;
    const QString reference = svgReference(paint);
    const SvgElement *server = tree.find(reference);
    if (server && server->name.endsWith(QLatin1String("Gradient"))) {
        const std::vector<SvgStop> stops = svgStops(server, tree);
        SvgColour mean{};
        for (const SvgStop &stop : stops)
            for (std::size_t i = 0; i < 4; ++i)
                mean[i] += stop.colour[i] / double(stops.size());
        if (!stops.empty())
            result.colour = mean;
        result.gradient = server;
        if (std::ranges::any_of(stops, [&](const SvgStop &stop) { return stop.colour != stops.front().colour; }))
            result.replaced = server;
    } else if (!reference.isEmpty()) {
        const QString instead = paint.mid(paint.indexOf(u')') + 1).trimmed();
        const bool isPattern = server && server->name == QLatin1String("pattern");
        result.colour = cssColour(instead);
        if (instead.compare(QLatin1String("currentColor"), Qt::CaseInsensitive) == 0)
            result.colour = current;
        result.replaced = isPattern ? server : nullptr;
    } else if (paint != QLatin1String("none")) {
        result.colour = colourFrom(paint, current);
    }
    if (!(opacity > 0) || (result.colour && !(((*result.colour)[3] *= opacity) > 0)))
        result = {};
    return result;
}

} // namespace suffuse

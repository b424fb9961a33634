#include "model/formats/svg/paths/svg_markers.h"

#include "model/shaping/curves/split.h"

#include <numbers>

namespace suffuse {

std::vector<SvgMarkerPlace> svgMarkerPlaces(const std::vector<PenLine> &lines)
{
    std::vector<SvgMarkerPlace> places;
    const auto add = [&places](Point at, Point comes, Point goes) {
        const Point both = comes + goes;
        // Where the line goes back on itself, halfway is across it.
        places.push_back({SvgMarkerPlace::Kind::Mid, at, length(both) > 1e-9 ? both : Point{-comes.y, comes.x}});
    };
    for (const PenLine &line : lines) {
        const std::vector<Cubic> &curves = line.curves;
        if (curves.empty()) {
            add(line.point, line.direction, line.direction);
            continue;
        }
        const Point first = startDirection(curves.front()), last = endDirection(curves.back());
        add(curves.front().p[0], line.isClosed ? last : first, first);
        for (std::size_t k = 1; k < curves.size(); ++k)
            add(curves[k].p[0], endDirection(curves[k - 1]), startDirection(curves[k]));
        add(curves.back().p[3], last, line.isClosed ? first : last);
    }
    if (!places.empty()) {
        places.front().kind = SvgMarkerPlace::Kind::Start;
        SvgMarkerPlace end = places.back();
        end.kind = SvgMarkerPlace::Kind::End;
        if (places.size() > 1)
            places.pop_back();
        places.push_back(end);
    }
    return places;
}

std::optional<SvgMarkerView> svgMarkerView(const SvgElement &marker, const SvgMarkerPlace &place, const SvgStyle &shape,
                                           CssSheet &sheet)
{
    SvgMarkerView view{SvgStyle::ofDefinition(marker, sheet), {}};
    SvgStyle &style = view.style;
    style.units.width = shape.units.width, style.units.height = shape.units.height;
    const auto length = [&](const char *name, SvgAxis axis, double usual) {
        return svgLength(marker.attribute(name), style.units, axis).value_or(usual);
    };
    const double width = length("markerWidth", SvgAxis::Across, 3), height = length("markerHeight", SvgAxis::Down, 3);
    if (!(width > 0 && height > 0) || !style.isDisplayed)
        return {};
    const QString orient = marker.attribute("orient").trimmed();
    const bool isReversed = orient == QLatin1String("auto-start-reverse") && place.kind == SvgMarkerPlace::Kind::Start;
    double angle = orient.toDouble() * std::numbers::pi / 180;
    if (orient.startsWith(QLatin1String("auto")))
        angle = std::atan2(place.direction.y, place.direction.x) + (isReversed ? std::numbers::pi : 0);
    const double size = marker.attribute("markerUnits") == QLatin1String("userSpaceOnUse") ? 1 : shape.pen.width;
    const double c = size * std::cos(angle), s = size * std::sin(angle);
    style.matrix = shape.matrix * SvgMatrix{c, s, -s, c, place.at.x, place.at.y};
    const Rect box = svgViewBox(marker.attributes);
    const Rect port = Rect::of(0, 0, width, height);
    const SvgMatrix fit = box.isEmpty() ? SvgMatrix() : svgViewport(box, port, marker.attribute("preserveAspectRatio"));
    if (!box.isEmpty())
        style.units.width = box.width(), style.units.height = box.height();
    const Point reference = fit.map({length("refX", SvgAxis::Across, 0), length("refY", SvgAxis::Down, 0)});
    style.matrix = style.matrix * SvgMatrix{1, 0, 0, 1, -reference.x, -reference.y} * fit;
    // The port, seen from what is drawn in it.
    view.port = Rect::of(-fit.e / fit.a, -fit.f / fit.d, width / fit.a, height / fit.d);
    style.contextFill = shape.inContext(shape.fill), style.contextStroke = shape.inContext(shape.stroke);
    style.isFaded = style.isFaded || shape.isFaded;
    return view;
}

} // namespace suffuse

#include "app/session/painting/attribute_brush.h"

#include "model/painting/validate.h"

#include <numbers>

namespace suffuse {

namespace {

float Segment::*memberOf(Attribute attribute)
{
    switch (attribute) {
    case Attribute::Diffusion:
        return &Segment::diffusion;
    case Attribute::Density:
        return &Segment::density;
    case Attribute::Granulation:
        return &Segment::granulation;
    default:
        return &Segment::maxAge;
    }
}

/// Goes from `from` to `to` by a share, evenly in the logarithm where both have one.
double between(double from, double to, double share, bool ratio)
{
    return ratio && from > 0 && to > 0 ? from * std::pow(to / from, share) : from + share * (to - from);
}

float inUnit(double value)
{
    return float(std::clamp(value, 0.0, 1.0));
}

float channelWith(float channel, float wished, const AttributeWish &wish, double share)
{
    return inUnit(wish.relative ? channel + share * wish.value * wished : between(channel, wished, share, false));
}

} // namespace

bool isRatio(Attribute attribute)
{
    return attribute == Attribute::Diffusion || attribute == Attribute::Density || attribute == Attribute::MaxAge;
}

double falloff(double distance, double radius)
{
    return distance < radius ? 0.5 * (1 + std::cos(std::numbers::pi * distance / radius)) : 0;
}

Segment withAttribute(const Segment &segment, const AttributeWish &wish, double share)
{
    Segment changed = segment;
    if (share <= 0)
        return changed;
    const bool ratio = isRatio(wish.attribute);
    const auto wished = [&](double value) {
        if (!wish.relative)
            return between(value, wish.value, share, ratio);
        return ratio ? value * std::pow(wish.value, share) : value + share * wish.value;
    };
    switch (wish.attribute) {
    case Attribute::Colour:
        changed.colour.red = channelWith(segment.colour.red, wish.colour.red, wish, share);
        changed.colour.yellow = channelWith(segment.colour.yellow, wish.colour.yellow, wish, share);
        changed.colour.blue = channelWith(segment.colour.blue, wish.colour.blue, wish, share);
        break;
    case Attribute::Opacity:
        changed.colour.opacity = inUnit(wished(segment.colour.opacity));
        break;
    case Attribute::Granulation:
        changed.granulation = inUnit(wished(segment.granulation));
        break;
    default: {
        float Segment::*member = memberOf(wish.attribute);
        changed.*member = float(wished(segment.*member));
    }
    }
    return problemOf(changed).isEmpty() ? changed : segment;
}

Fill withAttribute(const Fill &fill, const AttributeWish &wish, double share)
{
    if (wish.attribute == Attribute::Density && !wish.relative)
        return fill;
    Segment like;
    like.diffusion = fill.diffusion > 0 ? fill.diffusion : 1; // A crisp edge has none, which no segment may have.
    like.density = fill.density;
    like.granulation = fill.granulation;
    like.maxAge = fill.maxAge;
    like.colour = fill.colour;
    const Segment painted = withAttribute(like, wish, share);
    Fill result = fill;
    if (fill.diffusion > 0)
        result.diffusion = painted.diffusion;
    else if (wish.attribute == Attribute::Diffusion && !wish.relative)
        result.diffusion = float(share * wish.value);
    result.density = painted.density;
    result.granulation = painted.granulation;
    result.maxAge = painted.maxAge;
    result.colour = painted.colour;
    if (fill.gradient) {
        like.colour = fill.gradient->colour;
        result.gradient->colour = withAttribute(like, wish, share).colour;
    }
    return result;
}

} // namespace suffuse

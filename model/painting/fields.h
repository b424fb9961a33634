// The one list of the fields that the values of a painting have, with names, units and domains.
//
// A field's default is the one that its struct gives it. Hash, validation, the text form, the document's columns, the
// difference of two paintings, means of segments and the inspector walk through these lists. So a number that is added
// to a struct is one row here (CONTRIBUTING.md, "A number of a segment").
#pragma once

#include "model/paint/style_function.h"
#include "model/painting/painting.h"

#include <QString>

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace suffuse {

/// The unit of a number. A length is in canvas units.
enum class Unit : std::uint8_t { None, Length, Diffusion, Seconds, Share, Radians };

/// The numbers that are allowed, from `least` to `greatest`. In an open domain `least` itself is not allowed.
struct Domain {
    double least = -double(std::numeric_limits<float>::max());
    double greatest = double(std::numeric_limits<float>::max());
    bool open = false;

    /// Whether a number is allowed; NaN never is.
    constexpr bool contains(double value) const { return (open ? value > least : value >= least) && value <= greatest; }
    /// The same for float32, where the bounds are rounded as values are.
    constexpr bool contains(float value) const
    {
        return (open ? value > float(least) : value >= float(least)) && value <= float(greatest);
    }
    /// "(0, 1e12]"
    QString text() const;
    /// The least allowed number that float32 can hold: `least` or, in an open domain, the number after it.
    double leastFloat() const;
};

inline constexpr Domain anyNumber{};
inline constexpr Domain positive{0, anyNumber.greatest, true};
inline constexpr Domain share{0, 1};
inline constexpr Domain coordinate{-1e12, 1e12};
inline constexpr Domain moment{-1e9, 1e9};                  ///< seconds of document time
inline constexpr Domain identity{1, 9'007'199'254'740'991}; ///< up to 2^53 − 1, which is exact in every JSON reader

/// When a field is in the text form.
enum class Presence : std::uint8_t {
    Required, ///< It is always written, and a reader refuses a value without it.
    Written,  ///< It is always written; a reader takes the default where it is missing.
    Unusual   ///< It is written only where it differs from the default.
};

/// How the columns of a document store a number (docs/file-format.md).
enum class Column : std::uint8_t {
    /// relative to a prediction from what comes before it in the stroke, for numbers that mostly change slowly
    Predicted,
    Plain ///< as the difference of its bits from the default's
};

struct FieldTraits {
    Unit unit = Unit::None;
    Domain domain = anyNumber;
    Presence presence = Presence::Written;
    Column column = Column::Plain;
    /// The first version of documents that has the number. Numbers of later versions stand behind the columns of
    /// version 1, and only in documents that use them.
    int since = 1;
    /// whether it is averaged by length where segments become one; other numbers have rules of their own
    bool averages = true;
    bool nullable = false; ///< whether 0 means "none"
    /// whether a reader of documents that does not know it may leave it out, since the picture is the same without it
    bool mayBeSkipped = false;
};

/// One member of a struct.
template <class Owner, class Value>
struct Field {
    const char *name; ///< its path in the text form; members of one part stand together, as "anisotropy.ratio"
    Value Owner::*member;
    FieldTraits traits;
};

template <class Owner, class Value>
constexpr Field<Owner, Value> field(const char *name, Value Owner::*member, FieldTraits traits = {})
{
    return {name, member, traits};
}

/// The fields of a type in the order in which the text form writes them: `list` is a tuple of Field.
template <class T>
struct FieldsOf;

template <class T>
concept HasFields = requires
{
    FieldsOf<T>::list;
};

/// Calls f(field) for each field of a type.
template <HasFields T, class F>
constexpr void forEachFieldOf(F f)
{
    std::apply([&](const auto &...fields) { (f(fields), ...); }, FieldsOf<T>::list);
}

/// Calls f(field, member) for each field of a value, which may be constant.
template <class T, class F>
requires HasFields<std::remove_const_t<T>>
constexpr void forEachField(T &value, F f)
{
    forEachFieldOf<std::remove_const_t<T>>([&](const auto &field) { f(field, value.*field.member); });
}

/// The words for an enumeration's values in files, in the order of the values.
template <class Enum>
struct WordsOf;

template <>
struct WordsOf<StyleKind> {
    static constexpr std::array<std::string_view, 3> list{"uniform", "feathering", "edge"};
};
template <>
struct WordsOf<MixMode> {
    static constexpr std::array<std::string_view, 2> list{"alpha", "beta"};
};
template <>
struct WordsOf<NodeKind> {
    static constexpr std::array<std::string_view, 3> list{"smooth", "symmetric", "corner"};
};
template <>
struct WordsOf<FillRule> {
    static constexpr std::array<std::string_view, 2> list{"nonzero", "evenodd"};
};
template <>
struct WordsOf<TextAlignment> {
    static constexpr std::array<std::string_view, 3> list{"start", "centre", "end"};
};
/// The names of W3C Compositing and Blending.
template <>
struct WordsOf<BlendMode> {
    static constexpr std::array<std::string_view, 20> list{
        "normal",     "multiply",   "screen",     "overlay",        "darken",          "lighten",    "color-dodge",
        "color-burn", "hard-light", "soft-light", "difference",     "exclusion",       "hue",        "saturation",
        "color",      "luminosity", "plus",       "destination-in", "destination-out", "source-atop"};
};
template <>
struct WordsOf<GroupTag> {
    static constexpr std::array<std::string_view, 9> list{"none", "red",    "orange", "yellow", "green",
                                                          "blue", "violet", "brown",  "grey"};
};
template <>
struct WordsOf<PaperKind> {
    static constexpr std::array<std::string_view, 3> list{"none", "procedural", "image"};
};
template <>
struct WordsOf<PaperGrain> {
    static constexpr std::array<std::string_view, 3> list{"tooth", "fibres", "weave"};
};

/// The domain of ξ1, ξ2 or ξ3 (`index` 0 … 2) of a kind of style by itself. Those that a kind does not have are 0.
constexpr Domain domainOfXi(StyleKind kind, int index)
{
    if (index >= xiCount(kind))
        return {0, 0};
    if (kind == StyleKind::Feathering && index == 1)
        return {0.5, 64};
    return index == 2 ? Domain{0, 1, true} : positive;
}
/// The ξ2 of edge darkening is at most so many times its ξ1: 2^(1/3). Beyond that the inside of the stroke would become
/// negative.
double greatestLightening();

template <>
struct FieldsOf<Colour> {
    static constexpr std::tuple list{field("[0]", &Colour::red, {.unit = Unit::Share, .domain = share}),
                                     field("[1]", &Colour::yellow, {.unit = Unit::Share, .domain = share}),
                                     field("[2]", &Colour::blue, {.unit = Unit::Share, .domain = share}),
                                     field("[3]", &Colour::opacity, {.unit = Unit::Share, .domain = share})};
};

/// The domains of ξ depend on the kind (see domainOfXi).
template <>
struct FieldsOf<Style> {
    static constexpr std::tuple list{field("kind", &Style::kind, {.presence = Presence::Required}),
                                     field("xi", &Style::xi, {.presence = Presence::Required})};
};

template <>
struct FieldsOf<Mix> {
    static constexpr std::tuple list{
        field("mode", &Mix::mode, {.presence = Presence::Required}),
        field("beta", &Mix::beta, {.unit = Unit::Share, .domain = share, .presence = Presence::Unusual})};
};

template <>
struct FieldsOf<Rewet> {
    static constexpr std::tuple list{field("[0]", &Rewet::time, {.unit = Unit::Seconds, .domain = moment}),
                                     field("[1]", &Rewet::extra, {.unit = Unit::Seconds, .domain = {0, 1e9}})};
};

template <>
struct FieldsOf<Segment> {
    static constexpr std::tuple list{
        field("bezier", &Segment::bezier, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("diffusion", &Segment::diffusion,
              {.unit = Unit::Diffusion,
               .domain = {0, 1e12, true},
               .presence = Presence::Required,
               .column = Column::Predicted}),
        field("density", &Segment::density,
              {.unit = Unit::Length, .domain = {0, 1e12}, .presence = Presence::Required, .column = Column::Predicted}),
        field("granulation", &Segment::granulation,
              {.unit = Unit::Share, .domain = share, .column = Column::Predicted}),
        field("maxAge", &Segment::maxAge,
              {.unit = Unit::Seconds, .domain = {0, 1e6, true}, .column = Column::Predicted}),
        field("born", &Segment::born, {.unit = Unit::Seconds, .domain = moment}),
        field("colour", &Segment::colour, {.unit = Unit::Share, .domain = share, .column = Column::Predicted}),
        field("style", &Segment::style, {.presence = Presence::Unusual}),
        field("anisotropy.ratio", &Segment::anisotropyRatio,
              {.domain = {1e-6, 1e6}, .presence = Presence::Unusual, .averages = false}),
        field("anisotropy.angle", &Segment::anisotropyAngle,
              {.unit = Unit::Radians, .presence = Presence::Unusual, .averages = false}),
        field("node", &Segment::node, {.presence = Presence::Unusual}),
        field("rewet", &Segment::rewet, {.presence = Presence::Unusual}),
        field("start", &Segment::start, {.presence = Presence::Unusual, .since = 2, .averages = false}),
        field("lift", &Segment::lift, {.presence = Presence::Unusual, .since = 2, .averages = false}),
        field("fade", &Segment::fade, {.presence = Presence::Unusual, .since = 4, .averages = false})};
};

template <>
struct FieldsOf<Gradient> {
    static constexpr std::tuple list{
        field("from", &Gradient::from, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("to", &Gradient::to, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("colour", &Gradient::colour, {.unit = Unit::Share, .domain = share, .presence = Presence::Required})};
};

template <>
struct FieldsOf<Fill> {
    static constexpr std::tuple list{
        field("diffusion", &Fill::diffusion,
              {.unit = Unit::Diffusion, .domain = {0, 1e12}, .presence = Presence::Required}),
        field("density", &Fill::density, {.domain = {0, 1e12}, .presence = Presence::Required}),
        field("granulation", &Fill::granulation, {.unit = Unit::Share, .domain = share}),
        field("maxAge", &Fill::maxAge, {.unit = Unit::Seconds, .domain = {0, 1e6, true}}),
        field("born", &Fill::born, {.unit = Unit::Seconds, .domain = moment}),
        field("colour", &Fill::colour, {.unit = Unit::Share, .domain = share}),
        field("rule", &Fill::rule),
        field("gradient", &Fill::gradient, {.presence = Presence::Unusual}),
        field("anisotropy.ratio", &Fill::anisotropyRatio, {.domain = {1e-6, 1e6}, .presence = Presence::Unusual}),
        field("anisotropy.angle", &Fill::anisotropyAngle, {.unit = Unit::Radians, .presence = Presence::Unusual})};
};

/// Of an image in the painting the text form has the bytes, of a linked one their SHA-256.
template <>
struct FieldsOf<Picture> {
    static constexpr std::tuple list{
        field("image", &Picture::image, {.presence = Presence::Unusual}),
        field("link", &Picture::link, {.presence = Presence::Unusual}),
        field("sha256", &Picture::sha256, {.presence = Presence::Unusual}),
        field("width", &Picture::width, {.domain = {1, Picture::mostSide}, .presence = Presence::Required}),
        field("height", &Picture::height, {.domain = {1, Picture::mostSide}, .presence = Presence::Required}),
        field("corner", &Picture::corner, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("right", &Picture::right, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("down", &Picture::down, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required})};
};

template <>
struct FieldsOf<Stroke> {
    static constexpr std::tuple list{
        field("id", &Stroke::id, {.domain = identity}),
        field("name", &Stroke::name),
        field("group", &Stroke::group, {.nullable = true}),
        field("visible", &Stroke::visible),
        field("locked", &Stroke::locked),
        field("style", &Stroke::style),
        field("mix", &Stroke::mix),
        field("origin", &Stroke::origin, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Unusual}),
        field("brush", &Stroke::brush, {.presence = Presence::Unusual}),
        field("fill", &Stroke::fill, {.presence = Presence::Unusual, .since = 2}),
        field("picture", &Stroke::picture, {.presence = Presence::Unusual, .since = 3}),
        field("segments", &Stroke::segments, {.presence = Presence::Required})};
};

template <>
struct FieldsOf<Paper> {
    static constexpr std::tuple list{field("kind", &Paper::kind, {.presence = Presence::Required}),
                                     field("grain", &Paper::grain, {.presence = Presence::Unusual}),
                                     field("seed", &Paper::seed, {.domain = {0, 4'294'967'295}}),
                                     field("scale", &Paper::scale, {.unit = Unit::Length, .domain = {0, 1e6, true}}),
                                     field("strength", &Paper::strength, {.unit = Unit::Share, .domain = share}),
                                     field("image", &Paper::image, {.presence = Presence::Unusual})};
};

template <>
struct FieldsOf<Canvas> {
    static constexpr std::tuple list{field("width", &Canvas::width, {.unit = Unit::Length, .domain = {0, 1e6, true}}),
                                     field("height", &Canvas::height, {.unit = Unit::Length, .domain = {0, 1e6, true}}),
                                     field("background", &Canvas::background, {.unit = Unit::Share, .domain = share}),
                                     field("paper", &Canvas::paper)};
};

template <>
struct FieldsOf<Text> {
    static constexpr std::tuple list{
        field("string", &Text::string, {.presence = Presence::Required}),
        field("family", &Text::family, {.presence = Presence::Required}),
        field("weight", &Text::weight, {.domain = {1, 1000}}),
        field("italic", &Text::italic, {.presence = Presence::Unusual}),
        field("size", &Text::size, {.unit = Unit::Length, .domain = {0, 1e6, true}, .presence = Presence::Required}),
        field("letterSpacing", &Text::letterSpacing, {.domain = {-10, 100}, .presence = Presence::Unusual}),
        field("lineHeight", &Text::lineHeight, {.domain = {-100, 100}}),
        field("alignment", &Text::alignment),
        field("vertical", &Text::vertical, {.presence = Presence::Unusual}),
        field("place", &Text::place, {.domain = coordinate}),
        field("curve", &Text::curve, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Unusual}),
        field("follows", &Text::follows,
              {.presence = Presence::Unusual, .since = 5, .nullable = true, .mayBeSkipped = true}),
        field("followMap", &Text::followMap,
              {.domain = coordinate, .presence = Presence::Unusual, .since = 5, .mayBeSkipped = true})};
};

template <>
struct FieldsOf<Wash> {
    static constexpr std::tuple list{field("style", &Wash::style, {.presence = Presence::Required}),
                                     field("mix", &Wash::mix, {.presence = Presence::Required})};
};

template <>
struct FieldsOf<Group> {
    static constexpr std::tuple list{
        field("id", &Group::id, {.domain = identity, .presence = Presence::Required}),
        field("name", &Group::name),
        field("parent", &Group::parent, {.nullable = true}),
        field("visible", &Group::visible),
        field("locked", &Group::locked),
        field("text", &Group::text, {.presence = Presence::Unusual, .since = 2, .mayBeSkipped = true}),
        field("opacity", &Group::opacity,
              {.unit = Unit::Share, .domain = share, .presence = Presence::Unusual, .since = 3}),
        field("blend", &Group::blend, {.presence = Presence::Unusual, .since = 3}),
        field("isolated", &Group::isolated, {.presence = Presence::Unusual, .since = 3}),
        field("clips", &Group::clips, {.presence = Presence::Unusual, .since = 3}),
        field("mask", &Group::mask, {.presence = Presence::Unusual, .since = 3}),
        field("wash", &Group::wash, {.presence = Presence::Unusual, .since = 3}),
        field("solo", &Group::solo, {.presence = Presence::Unusual, .since = 3}),
        field("tag", &Group::tag, {.presence = Presence::Unusual, .since = 3, .mayBeSkipped = true}),
        field("draft", &Group::draft, {.presence = Presence::Unusual, .since = 3})};
};

template <>
struct FieldsOf<Swatch> {
    static constexpr std::tuple list{
        field("name", &Swatch::name),
        field("colour", &Swatch::colour, {.unit = Unit::Share, .domain = share, .presence = Presence::Required}),
        field("linked", &Swatch::linked, {.presence = Presence::Unusual, .since = 2})};
};

template <>
struct FieldsOf<Underlay> {
    static constexpr std::tuple list{
        field("image", &Underlay::image, {.presence = Presence::Required}),
        field("area", &Underlay::area, {.unit = Unit::Length, .domain = coordinate, .presence = Presence::Required}),
        field("opacity", &Underlay::opacity, {.unit = Unit::Share, .domain = share}),
        field("visible", &Underlay::visible)};
};

/// A float32 of a value: a member, or a channel of a member that is a colour.
template <class Owner>
struct Number {
    const char *name; ///< the field's name
    FieldTraits traits;
    float Owner::*member = nullptr;
    Colour Owner::*colour = nullptr; ///< set where `member` is not
    float Colour::*channel = nullptr;

    constexpr float &of(Owner &owner) const { return member ? owner.*member : (owner.*colour).*channel; }
    constexpr float of(const Owner &owner) const { return member ? owner.*member : (owner.*colour).*channel; }
    float usual() const { return of(Owner{}); }
};

namespace fields {

template <class Owner>
struct NumberSink {
    std::array<Number<Owner>, 32> list{};
    std::size_t count = 0;

    template <class Declarer, class Value>
    constexpr void operator()(const Field<Declarer, Value> &f)
    {
        if constexpr (std::is_same_v<Value, float>)
            list[count++] = {f.name, f.traits, f.member};
        else if constexpr (std::is_same_v<Value, Colour>)
            forEachFieldOf<Colour>([&](const auto &c) {
                list[count++] = {f.name, f.traits, nullptr, f.member, c.member};
            });
    }
};

template <class Owner, class Chosen>
constexpr auto numbers(Chosen chosen)
{
    NumberSink<Owner> all, some;
    forEachFieldOf<Owner>([&](const auto &f) { all(f); });
    for (std::size_t k = 0; k < all.count; ++k)
        if (chosen(all.list[k].traits))
            some.list[some.count++] = all.list[k];
    return some;
}

template <auto &Sink, class Owner>
constexpr auto packed()
{
    std::array<Number<Owner>, Sink.count> out{};
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = Sink.list[k];
    return out;
}

template <class Owner>
inline constexpr auto allSink = numbers<Owner>([](const FieldTraits &) { return true; });
template <class Owner>
inline constexpr auto predictedSink = numbers<Owner>([](const FieldTraits &t) {
    return t.column == Column::Predicted;
});
template <class Owner>
inline constexpr auto plainSink = numbers<Owner>([](const FieldTraits &t) {
    return t.column == Column::Plain && t.since == 1;
});
template <class Owner>
inline constexpr auto laterSink = numbers<Owner>([](const FieldTraits &t) { return t.since > 1; });

} // namespace fields

/// The numbers of a type in the order of its fields: all of them, or those that a document stores in one way.
template <class Owner>
inline constexpr auto numbersOf = fields::packed<fields::allSink<Owner>, Owner>();
template <class Owner>
inline constexpr auto predictedNumbersOf = fields::packed<fields::predictedSink<Owner>, Owner>();
template <class Owner>
inline constexpr auto plainNumbersOf = fields::packed<fields::plainSink<Owner>, Owner>();
template <class Owner>
inline constexpr auto laterNumbersOf = fields::packed<fields::laterSink<Owner>, Owner>();

/// Sets the numbers of `result` that can be averaged to their means over some values, by weights (> 0).
template <class Owner>
void setMeanNumbers(Owner &result, const std::vector<const Owner *> &of, const std::vector<double> &weights)
{
    std::array<double, numbersOf<Owner>.size()> sums{};
    double weight = 0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += weights[i] * double(numbersOf<Owner>[k].of(*of[i]));
        weight += weights[i];
    }
    for (std::size_t k = 0; k < sums.size(); ++k)
        if (numbersOf<Owner>[k].traits.averages)
            numbersOf<Owner>[k].of(result) = float(sums[k] / weight);
}

/// The least version of files that can hold a value: the greatest version that brought a field which differs from its
/// default. `skips`: fields that readers may skip do not count.
template <HasFields T>
int versionNeededBy(const T &value, bool skips = false)
{
    static const T usual;
    int version = 1;
    forEachField(value, [&](const auto &field, const auto &member) {
        if (field.traits.since > version && !(skips && field.traits.mayBeSkipped) && member != usual.*field.member)
            version = field.traits.since;
    });
    return version;
}
/// The same for all strokes, segments, groups, texts and swatches of a painting.
int versionNeededBy(const Painting &painting);

/// The description of a segment's number, given as a member; the member must be one of its numbers.
const Number<Segment> &numberOf(float Segment::*member);
/// The same for a channel of its colour.
const Number<Segment> &numberOf(float Colour::*channel);

} // namespace suffuse

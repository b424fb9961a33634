#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/formats/suffuse/suffuse_strokes.h"
#include "model/painting/fields.h"

#include <algorithm>

namespace suffuse {

namespace {

QCborArray toCbor(const Colour &c)
{
    return {double(c.red), double(c.yellow), double(c.blue), double(c.opacity)};
}

/// Ids use all 64 bits, so they are stored as the signed integers with the same bits.
qint64 toCbor(std::uint64_t id)
{
    return qint64(id);
}

int placeOfImage(const EncodedImage &image, std::vector<EncodedImage> &images)
{
    const auto same = [&](const EncodedImage &other) { return other == image || *other == *image; };
    const auto place = std::find_if(images.begin(), images.end(), same) - images.begin();
    if (std::size_t(place) == images.size())
        images.push_back(image);
    return int(place);
}

using Images = std::vector<EncodedImage>;

/// The numbers of a map of the plane: its matrix by rows, then its offset.
QCborArray toCbor(const Affine &map)
{
    return {map.a, map.b, map.c, map.d, map.offset.x, map.offset.y};
}

/// Eight numbers for each curve: x and y of its points.
QCborArray toCbor(const std::vector<Cubic> &curves)
{
    QCborArray numbers;
    for (const Cubic &curve : curves)
        for (const Point p : curve.p) {
            numbers.append(p.x);
            numbers.append(p.y);
        }
    return numbers;
}

QCborArray toCbor(const std::array<float, 3> &numbers)
{
    return {double(numbers[0]), double(numbers[1]), double(numbers[2])};
}

template <HasFields T>
QCborMap toCbor(const T &value, Images &images);

template <class Value>
QCborValue cborOf(const Value &value, Images &images)
{
    if constexpr (std::is_enum_v<Value>)
        return int(value);
    else if constexpr (std::is_same_v<Value, Rect>)
        return QCborArray{value.left, value.top, value.right, value.bottom};
    else if constexpr (std::is_same_v<Value, EncodedImage>)
        return placeOfImage(value, images);
    else if constexpr (std::is_same_v<Value, float>)
        return double(value);
    else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>)
        return toCbor(std::uint64_t(value));
    else if constexpr (std::is_same_v<Value, Colour> || std::is_same_v<Value, Affine> ||
                       std::is_same_v<Value, std::vector<Cubic>> || std::is_same_v<Value, std::array<float, 3>>)
        return toCbor(value);
    else if constexpr (std::is_same_v<Value, SharedText> || std::is_same_v<Value, std::optional<Wash>>)
        return toCbor(*value, images); // It is written only where there is one.
    else if constexpr (HasFields<Value>)
        return toCbor(value, images);
    else
        return value;
}

/// The members that are always there, then those that differ from their defaults, and images if there are any.
template <HasFields T>
QCborMap toCbor(const T &value, Images &images)
{
    static const T usual;
    QCborMap map;
    for (const bool unusual : {false, true}) {
        forEachField(value, [&](const auto &field, const auto &member) {
            using Value = std::decay_t<decltype(member)>;
            constexpr bool isImage = std::is_same_v<Value, EncodedImage>;
            if (unusual != (isImage || field.traits.presence == Presence::Unusual))
                return;
            if constexpr (isImage) {
                if (!member)
                    return;
            }
            if (!unusual || !(member == usual.*field.member))
                map.insert(QLatin1String(field.name), cborOf(member, images));
        });
    }
    return map;
}

void readNumbers(const QCborValue &value, Affine &map, bool &ok)
{
    const QCborArray n = value.toArray();
    ok = ok && n.size() == 6;
    map = {n.at(0).toDouble(),
           n.at(1).toDouble(),
           n.at(2).toDouble(),
           n.at(3).toDouble(),
           {n.at(4).toDouble(), n.at(5).toDouble()}};
}

void readNumbers(const QCborValue &value, std::vector<Cubic> &curves, bool &ok)
{
    const QCborArray numbers = value.toArray();
    ok = ok && value.isArray() && numbers.size() % 8 == 0;
    for (qsizetype k = 0; k + 8 <= numbers.size(); k += 8) {
        Cubic &curve = curves.emplace_back();
        for (qsizetype i = 0; i < 4; ++i)
            curve.p[std::size_t(i)] = {numbers.at(k + 2 * i).toDouble(), numbers.at(k + 2 * i + 1).toDouble()};
    }
}

void readNumbers(const QCborValue &value, std::array<float, 3> &numbers, bool &ok)
{
    const QCborArray all = value.toArray();
    ok = ok && all.size() == 3;
    for (qsizetype i = 0; i < 3; ++i)
        numbers[std::size_t(i)] = float(all.at(i).toDouble());
}

template <HasFields T>
void readMap(const QCborValue &value, const Images &images, T &target, bool &ok);

template <class Value>
void readMember(const MapReader &in, const FieldTraits &traits, const char *name, const Images &images, Value &member,
                bool &ok)
{
    if constexpr (std::is_enum_v<Value> || std::is_same_v<Value, std::uint32_t>) {
        auto number = std::uint64_t(member);
        in.read(name, number);
        if constexpr (std::is_enum_v<Value>)
            ok = ok && number < WordsOf<Value>::list.size();
        else
            ok = ok && traits.domain.contains(double(number));
        member = Value(number);
    } else if constexpr (std::is_same_v<Value, Rect>) {
        const QCborArray area = in.take(name).toArray();
        ok = ok && area.size() == 4;
        member = {area.at(0).toDouble(), area.at(1).toDouble(), area.at(2).toDouble(), area.at(3).toDouble()};
    } else if constexpr (std::is_same_v<Value, EncodedImage>) {
        in.read(name, member, images);
    } else if constexpr (std::is_same_v<Value, Affine> || std::is_same_v<Value, std::vector<Cubic>> ||
                         std::is_same_v<Value, std::array<float, 3>>) {
        if (const QCborValue numbers = in.take(name); !numbers.isUndefined())
            readNumbers(numbers, member, ok);
    } else if constexpr (std::is_same_v<Value, SharedText>) {
        if (const QCborValue text = in.take(name); !text.isUndefined()) {
            Text own;
            readMap(text, images, own, ok);
            member = std::move(own);
        }
    } else if constexpr (std::is_same_v<Value, std::optional<Wash>>) {
        if (const QCborValue wash = in.take(name); !wash.isUndefined())
            readMap(wash, images, member.emplace(), ok);
    } else if constexpr (HasFields<Value> && !std::is_same_v<Value, Colour>) {
        readMap(in.take(name), images, member, ok);
    } else {
        in.read(name, member);
    }
}

template <HasFields T>
void readMap(const QCborValue &value, const Images &images, T &target, bool &ok)
{
    const MapReader in(value, ok);
    forEachField(
        target, [&](const auto &field, auto &member) { readMember(in, field.traits, field.name, images, member, ok); });
}

template <class T>
void readList(const QCborValue &value, const Images &images, std::vector<T> &list, bool &ok)
{
    for (const QCborValue &item : value.toArray())
        readMap(item, images, list.emplace_back(), ok);
}

} // namespace

QByteArray writeProperties(const Painting &painting, Images &images)
{
    QCborMap map{{QLatin1String("canvas"), toCbor(painting.canvas, images)}};
    QCborArray groups, swatches;
    for (const Group &g : painting.groups)
        groups.append(toCbor(g, images));
    for (const Swatch &s : painting.swatches)
        swatches.append(toCbor(s, images));
    if (!groups.isEmpty())
        map.insert(QLatin1String("groups"), groups);
    if (!swatches.isEmpty())
        map.insert(QLatin1String("swatches"), swatches);
    if (painting.underlay)
        map.insert(QLatin1String("underlay"), toCbor(*painting.underlay, images));
    return QCborValue(map).toCbor();
}

QString readProperties(QByteArrayView payload, const Images &images, Painting &painting)
{
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(payload.data(), payload.size(), &problem);
    if (problem.error != QCborError::NoError)
        return problem.errorString();
    bool ok = true;
    MapReader in(value, ok);
    readMap(in.take("canvas"), images, painting.canvas, ok);
    readList(in.take("groups"), images, painting.groups, ok);
    readList(in.take("swatches"), images, painting.swatches, ok);
    if (const QCborValue underlay = in.take("underlay"); !underlay.isUndefined()) {
        auto own = std::make_shared<Underlay>();
        readMap(underlay, images, *own, ok);
        painting.underlay = std::move(own);
    }
    return ok ? QString() : FileMessages::tr("a value has the wrong type");
}

} // namespace suffuse

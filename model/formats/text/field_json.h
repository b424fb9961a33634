// Values as JSON, field by field. The text form is made of it (docs/text-form.md), and single values are printed with
// it.
#pragma once

#include "model/formats/text/json_reader.h"
#include "model/formats/text/text_numbers.h"
#include "model/formats/text/value_json.h"
#include "model/painting/fields.h"

#include <optional>

namespace suffuse {

namespace field_json {

/// Arranges fields as members of JSON objects. "anisotropy.ratio" becomes the member `ratio` of a member `anisotropy`.
struct MemberNames {
    static constexpr std::size_t most = 32;
    std::array<std::string_view, most> heads{}; ///< the members of the object, each once
    std::array<int, most> first{};              ///< the field that a head is, or the first field of its part
    std::array<int, most> parts{};              ///< the number of fields of a part; 0: the head is a field itself
    std::array<int, most> headOf{};             ///< the head of each field
    std::array<std::string_view, most> tails{}; ///< the name of each field within its part
    std::size_t headCount = 0;
    std::uint32_t required = 0; ///< a bit for each head

    constexpr void add(std::string_view name, bool isRequired, int field)
    {
        const std::size_t dot = name.find('.');
        const std::string_view head = name.substr(0, dot);
        if (headCount == 0 || heads[headCount - 1] != head) {
            heads[headCount] = head;
            first[headCount] = field;
            ++headCount;
        }
        headOf[std::size_t(field)] = int(headCount) - 1;
        if (dot != name.npos) {
            tails[std::size_t(field)] = name.substr(dot + 1);
            ++parts[headCount - 1];
        }
        if (isRequired)
            required |= memberBit(int(headCount) - 1);
    }
    constexpr std::uint32_t bitOf(std::string_view head) const
    {
        std::uint32_t bit = 0;
        for (std::size_t k = 0; k < headCount; ++k)
            bit |= heads[k] == head ? memberBit(int(k)) : 0;
        return bit;
    }
};

template <class T>
inline constexpr MemberNames namesOf = [] {
    MemberNames names;
    int index = 0;
    forEachFieldOf<T>(
        [&](const auto &field) { names.add(field.name, field.traits.presence == Presence::Required, index++); });
    return names;
}();

/// Whether the text form writes a field of a value.
template <class T, class Value>
bool isWritten(const T &value, const FieldTraits &traits, const Value &member, const Value &usual)
{
    if constexpr (std::is_same_v<T, Picture>) {
        // Of what is linked, or missing, the SHA-256 is written.
        const bool isThere = value.image && !value.isLinked();
        if constexpr (std::is_same_v<Value, EncodedImage>)
            return isThere;
        if constexpr (std::is_same_v<Value, QString>)
            return !isThere && !member.isEmpty();
    }
    if constexpr (std::is_same_v<Value, EncodedImage>)
        return bool(member);
    if (traits.presence == Presence::Required)
        return true;
    bool isUnusual = traits.presence == Presence::Unusual;
    if constexpr (std::is_same_v<T, Paper>)
        // What a paper without a kind would be like is written only where it was changed.
        isUnusual = isUnusual || value.kind == PaperKind::None;
    return !isUnusual || !(member == usual);
}

} // namespace field_json

/// Reads an image of the text form, or makes the reader fail.
void readImage(JsonReader &json, EncodedImage &image);
void readBezier(JsonReader &json, std::array<Offset, 4> &points);
void readRewet(JsonReader &json, std::vector<Rewet> &list);
void readArea(JsonReader &json, Rect &area);
void readSeed(JsonReader &json, std::uint32_t &seed);
void readOffset(JsonReader &json, Offset &offset);
void readMatrix(JsonReader &json, Affine &map);
void readCurves(JsonReader &json, std::vector<Cubic> &curves);
void readPicture(JsonReader &json, SharedPicture &picture);

void appendImage(QByteArray &out, const EncodedImage &image);
/// Writes [left, top, width, height] with extents from which right and bottom follow to the last bit.
void appendArea(QByteArray &out, const Rect &area);
/// Writes a map of the plane as the rows of its matrix and its offset: [a,b,c,d,x,y].
void appendMatrix(QByteArray &out, const Affine &map);

/// Reads an object. Returns which members it has, as bits of the fields' heads in their order. It fails if a required
/// member is missing.
template <HasFields T>
std::uint32_t readObject(JsonReader &json, T &value);
/// Writes `{"name": value, …}`. The text `between(name)` stands before each member except the first.
template <HasFields T, class Between>
void appendObject(QByteArray &out, const T &value, Between between);
template <HasFields T>
void appendObject(QByteArray &out, const T &value)
{
    appendObject(out, value, [](std::string_view) { return ", "; });
}

/// Reads the value of a field.
template <class Value>
void readMember(JsonReader &json, Value &value, const FieldTraits &traits)
{
    if constexpr (std::is_same_v<Value, Microseconds>) {
        json.readSeconds(value);
    } else if constexpr (std::is_same_v<Value, std::uint64_t>) {
        if (!traits.nullable || !json.skipNull())
            json.read(value);
    } else if constexpr (std::is_same_v<Value, std::uint32_t>) {
        readSeed(json, value);
    } else if constexpr (std::is_enum_v<Value>) {
        value = Value(readChoice(json, WordsOf<Value>::list));
    } else if constexpr (std::is_same_v<Value, Point>) {
        std::array<double, 2> xy{};
        json.readAll(xy);
        value = {xy[0], xy[1]};
    } else if constexpr (std::is_same_v<Value, Offset>) {
        readOffset(json, value);
    } else if constexpr (std::is_same_v<Value, std::array<Offset, 4>>) {
        readBezier(json, value);
    } else if constexpr (std::is_same_v<Value, std::optional<Style>>) {
        readJson(json, value.emplace());
    } else if constexpr (std::is_same_v<Value, std::optional<Gradient>> || std::is_same_v<Value, std::optional<Wash>>) {
        readObject(json, value.emplace());
    } else if constexpr (std::is_same_v<Value, SharedFill>) {
        Fill fill;
        readObject(json, fill);
        value = fill;
    } else if constexpr (std::is_same_v<Value, SharedText>) {
        Text text;
        readObject(json, text);
        value = std::move(text);
    } else if constexpr (std::is_same_v<Value, SharedPicture>) {
        readPicture(json, value);
    } else if constexpr (std::is_same_v<Value, Affine>) {
        readMatrix(json, value);
    } else if constexpr (std::is_same_v<Value, std::vector<Cubic>>) {
        readCurves(json, value);
    } else if constexpr (std::is_same_v<Value, std::vector<Rewet>>) {
        readRewet(json, value);
    } else if constexpr (std::is_same_v<Value, std::vector<Segment>>) {
        json.array([&](std::size_t) { readObject(json, value.emplace_back()); });
    } else if constexpr (std::is_same_v<Value, EncodedImage>) {
        readImage(json, value);
    } else if constexpr (std::is_same_v<Value, Rect>) {
        readArea(json, value);
    } else if constexpr (std::is_same_v<Value, Colour> || std::is_same_v<Value, Style> || std::is_same_v<Value, Mix>) {
        readJson(json, value);
    } else if constexpr (HasFields<Value>) {
        readObject(json, value);
    } else {
        json.read(value);
    }
}

template <class Value>
void appendMember(QByteArray &out, const Value &value, const FieldTraits &traits)
{
    if constexpr (std::is_same_v<Value, bool>) {
        out.append(value ? "true" : "false");
    } else if constexpr (std::is_same_v<Value, Microseconds>) {
        appendSeconds(out, value);
    } else if constexpr (std::is_floating_point_v<Value>) {
        appendNumber(out, value);
    } else if constexpr (std::is_unsigned_v<Value>) {
        if (traits.nullable && value == 0)
            out.append("null");
        else
            appendNumber(out, std::uint64_t(value));
    } else if constexpr (std::is_enum_v<Value>) {
        const std::string_view word = WordsOf<Value>::list[std::size_t(value)];
        out.append('"').append(word.data(), qsizetype(word.size())).append('"');
    } else if constexpr (std::is_same_v<Value, QString>) {
        appendString(out, value);
    } else if constexpr (std::is_same_v<Value, Point> || std::is_same_v<Value, Offset>) {
        appendNumber(out.append('['), value.x);
        appendNumber(out.append(','), value.y);
        out.append(']');
    } else if constexpr (std::is_same_v<Value, std::array<Offset, 4>>) {
        for (std::size_t k = 0; k < value.size(); ++k)
            appendMember(out.append(k ? ',' : '['), value[k], traits);
        out.append(']');
    } else if constexpr (std::is_same_v<Value, std::optional<Style>>) {
        if (value)
            appendJson(out, *value);
        else
            out.append("null");
    } else if constexpr (std::is_same_v<Value, Affine>) {
        appendMatrix(out, value);
    } else if constexpr (std::is_same_v<Value, std::vector<Cubic>>) {
        out.append('[');
        for (std::size_t k = 0; k < value.size(); ++k)
            for (std::size_t i = 0; i < 4; ++i) {
                appendMember(out.append(i ? "," : k ? ",[" : "["), value[k].p[i], traits);
                out.append(i == 3 ? "]" : "");
            }
        out.append(']');
    } else if constexpr (std::is_same_v<Value, std::optional<Gradient>> || std::is_same_v<Value, std::optional<Wash>> ||
                         std::is_same_v<Value, SharedFill> || std::is_same_v<Value, SharedText> ||
                         std::is_same_v<Value, SharedPicture>) {
        if (value)
            appendObject(out, *value);
        else
            out.append("null");
    } else if constexpr (std::is_same_v<Value, std::vector<Rewet>>) {
        out.append('[');
        for (std::size_t k = 0; k < value.size(); ++k) {
            appendSeconds(out.append(k ? ",[" : "["), value[k].time);
            appendSeconds(out.append(','), value[k].extra);
            out.append(']');
        }
        out.append(']');
    } else if constexpr (std::is_same_v<Value, std::vector<Segment>>) {
        out.append('[');
        for (std::size_t k = 0; k < value.size(); ++k) // one on each line
            appendObject(out.append(k ? ",\n    " : "\n    "), value[k]);
        out.append(']');
    } else if constexpr (std::is_same_v<Value, EncodedImage>) {
        appendImage(out, value);
    } else if constexpr (std::is_same_v<Value, Rect>) {
        appendArea(out, value);
    } else if constexpr (std::is_same_v<Value, Colour> || std::is_same_v<Value, Style> || std::is_same_v<Value, Mix>) {
        appendJson(out, value);
    } else {
        appendObject(out, value);
    }
}

template <HasFields T>
std::uint32_t readObject(JsonReader &json, T &value)
{
    static constexpr const field_json::MemberNames &names = field_json::namesOf<T>;
    const auto readField = [&](int wanted) {
        int index = 0;
        forEachField(value, [&](const auto &field, auto &member) {
            if (index++ == wanted)
                readMember(json, member, field.traits);
        });
    };
    const std::span heads = std::span(names.heads).first(names.headCount);
    const std::uint32_t found = json.object(heads, [&](int head) {
        const int first = names.first[std::size_t(head)], parts = names.parts[std::size_t(head)];
        if (parts == 0)
            return readField(first);
        json.object(std::span(names.tails).subspan(std::size_t(first), std::size_t(parts)),
                    [&](int part) { readField(first + part); });
    });
    std::uint32_t required = names.required;
    if constexpr (std::is_same_v<T, Paper>)
        if (value.kind == PaperKind::Image)
            required |= names.bitOf("image");
    requireMembers(json, found, heads, required);
    return found;
}

template <HasFields T, class Between>
void appendObject(QByteArray &out, const T &value, Between between)
{
    static constexpr const field_json::MemberNames &names = field_json::namesOf<T>;
    static const T usual;
    std::uint32_t written = 0; // a bit for each head, since a part is written as a whole
    std::size_t index = 0;
    forEachField(value, [&](const auto &field, const auto &member) {
        if (field_json::isWritten(value, field.traits, member, usual.*field.member))
            written |= memberBit(names.headOf[index]);
        ++index;
    });
    const auto appendName = [&](std::string_view name) {
        out.append('"').append(name.data(), qsizetype(name.size())).append("\": ");
    };
    out.append('{');
    index = 0;
    bool isFirst = true;
    forEachField(value, [&](const auto &field, const auto &member) {
        const int at = int(index), head = names.headOf[index++];
        if (!(written & memberBit(head)))
            return;
        const int first = names.first[std::size_t(head)], parts = names.parts[std::size_t(head)];
        if (at == first) {
            out.append(isFirst ? "" : between(names.heads[std::size_t(head)]));
            appendName(names.heads[std::size_t(head)]);
            isFirst = false;
        }
        if (parts > 0) {
            out.append(at == first ? "{" : ", ");
            appendName(names.tails[std::size_t(at)]);
        }
        appendMember(out, member, field.traits);
        if (parts > 0 && at + 1 == first + parts)
            out.append('}');
    });
    out.append('}');
}

/// The names and values of a thing's fields as the text form writes them. Control points come one by one, images by
/// their size and hash. Ids, and the segments of a stroke, are left out.
using FieldTexts = std::vector<std::pair<QByteArray, QByteArray>>;
QByteArray imageSummary(const EncodedImage &image);

template <HasFields T>
FieldTexts fieldTextsOf(const T &value)
{
    FieldTexts out;
    forEachField(value, [&](const auto &field, const auto &member) {
        using Value = std::decay_t<decltype(member)>;
        const QByteArray name(field.name);
        QByteArray text;
        if constexpr (std::is_same_v<Value, std::vector<Segment>>) {
            return;
        } else if constexpr (std::is_same_v<Value, std::array<Offset, 4>>) {
            for (std::size_t k = 0; k < member.size(); ++k) {
                text.clear();
                appendMember(text, member[k], field.traits);
                out.emplace_back(name + '[' + QByteArray::number(int(k)) + ']', text);
            }
            return;
        } else if constexpr (std::is_same_v<Value, Paper>) {
            for (const auto &[part, partText] : fieldTextsOf(member))
                out.emplace_back(name + '.' + part, partText);
            return;
        } else if constexpr (std::is_same_v<Value, SharedFill>) {
            for (const auto &[part, partText] : fieldTextsOf(member ? *member : Fill()))
                out.emplace_back(name + '.' + part, member ? partText : QByteArray("null"));
            return;
        } else if constexpr (std::is_same_v<Value, SharedText>) {
            for (const auto &[part, partText] : fieldTextsOf(member ? *member : Text()))
                out.emplace_back(name + '.' + part, member ? partText : QByteArray("null"));
            return;
        } else if constexpr (std::is_same_v<Value, SharedPicture>) {
            for (const auto &[part, partText] : fieldTextsOf(member ? *member : Picture()))
                out.emplace_back(name + '.' + part, member ? partText : QByteArray("null"));
            return;
        } else if constexpr (std::is_same_v<Value, EncodedImage>) {
            if constexpr (std::is_same_v<T, Picture>)
                return; // Its SHA-256 tells it.
            text = imageSummary(member);
        } else {
            appendMember(text, member, field.traits);
        }
        if (name != "id")
            out.emplace_back(name, text);
    });
    return out;
}

} // namespace suffuse

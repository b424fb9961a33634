// Checks whether the fields of a value are in their domains. model/painting/validate.cpp also checks what fields demand
// of each other.
#pragma once

#include "model/painting/fields.h"
#include "model/painting/validate.h"

#include <cstdlib>
#include <optional>

namespace suffuse {

/// The place of a value, as the text form names it. It is written out only where something is wrong.
struct FieldPath {
    const FieldPath *parent = nullptr;
    const char *name = ""; ///< "[2]" stands behind what it belongs to without a dot
    int index = -1;        ///< the index of an element, which has no name

    QString text() const;
};

/// Whether all fields of a value are in their domains. It is quick, since files have many segments, and does not know
/// every kind of field: where it returns false, DomainCheck finds what is wrong, if anything is.
template <HasFields T>
constexpr bool fits(const T &value);

template <class Value>
constexpr bool fits(const Value &value, const FieldTraits &traits)
{
    const auto all = [&](const auto &...parts) { return (fits(parts, traits) & ...); };
    if constexpr (std::is_floating_point_v<Value>)
        return traits.domain.contains(value);
    else if constexpr (std::is_same_v<Value, Microseconds>)
        return (double(value) >= 1e6 * traits.domain.least) & (double(value) <= 1e6 * traits.domain.greatest);
    else if constexpr (std::is_enum_v<Value>)
        return std::size_t(value) < WordsOf<Value>::list.size();
    else if constexpr (std::is_same_v<Value, Offset> || std::is_same_v<Value, Point>)
        return all(value.x, value.y);
    else if constexpr (requires { std::tuple_size<Value>::value; })
        return std::apply(all, value);
    else if constexpr (requires { value.has_value(); })
        return !value.has_value();
    else if constexpr (std::is_same_v<Value, std::vector<Rewet>>)
        return value.empty();
    else if constexpr (HasFields<Value>)
        return fits(value);
    else
        return std::is_same_v<Value, bool> || std::is_same_v<Value, std::uint32_t>; // which hold nothing else
}

template <HasFields T>
constexpr bool fits(const T &value)
{
    bool good = true;
    forEachField(value, [&](const auto &field, const auto &member) { good &= fits(member, field.traits); });
    return good;
}

/// Finds the first field that is not in its domain.
class DomainCheck {
public:
    /// Empty, or a text such as "diffusion: -3 is not in (0, 1e12]".
    const QString &problem() const { return m_problem; }
    bool ok() const { return m_problem.isEmpty(); }
    void fail(const QString &problem) { m_problem = problem; }

    /// Checks all fields of a value. Strings, images and the segments of a stroke have no domain.
    template <HasFields T>
    void checkFields(const T &value, const FieldPath &path = {})
    {
        forEachField(value, [&](const auto &field, const auto &member) {
            if (ok())
                check(member, field.traits, FieldPath{&path, field.name});
        });
    }

    /// Checks a text, and that it is no longer than texts may be.
    void checkText(const Text &text, const FieldPath &path);
    /// Checks a picture, its number of pixels, and that it is an area.
    void checkPicture(const Picture &picture, const FieldPath &path);

private:
    template <class Value>
    void check(const Value &value, const FieldTraits &traits, const FieldPath &path)
    {
        if constexpr (std::is_floating_point_v<Value>)
            require(traits.domain.contains(value), path, double(value), traits.domain);
        else if constexpr (std::is_same_v<Value, Microseconds>)
            require(double(value) >= 1e6 * traits.domain.least && double(value) <= 1e6 * traits.domain.greatest, path,
                    toSeconds(value), traits.domain);
        else if constexpr (std::is_enum_v<Value>)
            requireKnown(std::size_t(value) < WordsOf<Value>::list.size(), path, noSuch(value));
        else if constexpr (std::is_same_v<Value, std::uint64_t>)
            require(traits.nullable || traits.domain.contains(double(value)), path, double(value), traits.domain);
        else if constexpr (std::is_same_v<Value, Style> || std::is_same_v<Value, Mix>)
            m_problem = problemOf(value);
        else if constexpr (HasFields<Value>)
            checkFields(value, path);
        else
            checkParts(value, traits, path);
    }
    template <class V>
    void check(const std::optional<V> &value, const FieldTraits &traits, const FieldPath &path)
    {
        if (value)
            check(*value, traits, path);
    }
    template <class V, std::size_t N>
    void check(const std::array<V, N> &values, const FieldTraits &traits, const FieldPath &path)
    {
        for (std::size_t i = 0; i < N && ok(); ++i)
            check(values[i], traits, FieldPath{&path, nullptr, int(i)});
    }
    template <class Pair>
    requires std::is_same_v<Pair, Offset> || std::is_same_v<Pair, Point>
    void checkParts(const Pair &p, const FieldTraits &traits, const FieldPath &path)
    {
        check(p.x, traits, FieldPath{&path, "[0]"});
        if (ok())
            check(p.y, traits, FieldPath{&path, "[1]"});
    }
    void checkParts(const Rect &r, const FieldTraits &traits, const FieldPath &path)
    {
        for (const double v : {r.left, r.top, r.right, r.bottom})
            if (ok())
                check(v, traits, path);
    }
    void checkParts(const std::vector<Rewet> &list, const FieldTraits &traits, const FieldPath &path);
    void checkParts(const SharedFill &fill, const FieldTraits &, const FieldPath &path)
    {
        if (fill)
            checkFields(*fill, path);
    }
    void checkParts(const SharedPicture &picture, const FieldTraits &, const FieldPath &path)
    {
        if (picture)
            checkPicture(*picture, path);
    }
    void checkParts(const SharedText &text, const FieldTraits &, const FieldPath &path)
    {
        if (text)
            checkText(*text, path);
    }
    void checkParts(const Affine &map, const FieldTraits &traits, const FieldPath &path);
    void checkParts(const std::vector<Cubic> &curves, const FieldTraits &traits, const FieldPath &path);
    void checkParts(const std::vector<Segment> &, const FieldTraits &, const FieldPath &) {}
    void checkParts(const QString &, const FieldTraits &, const FieldPath &) {}
    void checkParts(const EncodedImage &, const FieldTraits &, const FieldPath &) {}
    void checkParts(bool, const FieldTraits &, const FieldPath &) {}
    // its type allows no other values than its domain
    void checkParts(std::uint32_t, const FieldTraits &, const FieldPath &) {}

    static const char *noSuch(NodeKind);
    static const char *noSuch(FillRule);
    static const char *noSuch(BlendMode);
    static const char *noSuch(GroupTag);
    static const char *noSuch(PaperKind);
    static const char *noSuch(PaperGrain);
    static const char *noSuch(TextAlignment);
    void require(bool inDomain, const FieldPath &path, double value, const Domain &domain)
    {
        if (!inDomain)
            failDomain(path, value, domain);
    }
    void requireKnown(bool known, const FieldPath &path, const char *translatable)
    {
        if (!known)
            failText(path, translatable);
    }
    void failDomain(const FieldPath &path, double value, const Domain &domain);
    void failText(const FieldPath &path, const char *translatable);

    QString m_problem;
};

/// A text such as "diffusion: -3 is not in (0, 1e12]".
QString outsideText(const QString &path, double value, const Domain &domain);

} // namespace suffuse

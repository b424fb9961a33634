#include "model/painting/fields.h"

#include <QCryptographicHash>

#include <cmath>

namespace suffuse {

namespace {

/// A bound with as few digits as tell it from others: 1e12, 0.5, 3.4e38, and whole numbers in full.
QString boundText(double value)
{
    if (std::abs(value) < 1e16 && std::abs(value) > 1e9 && std::fmod(value, 1e6) != 0)
        return QString::number(value, 'f', 0);
    QString text = QString::number(value, 'g', 2);
    const qsizetype exponent = text.indexOf(QLatin1Char('e'));
    if (exponent < 0)
        return text;
    const int power = QStringView(text).sliced(exponent + 1).toInt();
    return text.first(exponent + 1) + QString::number(power);
}

bool equalImages(const EncodedImage &a, const EncodedImage &b)
{
    return a == b || (a && b && *a == *b);
}

/// Whether all fields are equal; images are compared by their bytes.
template <HasFields T>
bool equalFields(const T &a, const T &b)
{
    bool equal = true;
    forEachFieldOf<T>([&](const auto &field) {
        const auto &x = a.*field.member, &y = b.*field.member;
        if constexpr (std::is_same_v<std::decay_t<decltype(x)>, EncodedImage>)
            equal = equal && equalImages(x, y);
        else
            equal = equal && x == y;
    });
    return equal;
}

template <class Chosen>
const Number<Segment> &findNumber(Chosen chosen)
{
    for (const Number<Segment> &number : numbersOf<Segment>)
        if (chosen(number))
            return number;
    Q_UNREACHABLE();
}

} // namespace

QString Domain::text() const
{
    return (open ? QStringLiteral("(%1, %2]") : QStringLiteral("[%1, %2]")).arg(boundText(least), boundText(greatest));
}

double Domain::leastFloat() const
{
    if (!open)
        return least;
    return std::max(double(std::nextafter(float(least), std::numeric_limits<float>::infinity())),
                    least + double(std::numeric_limits<float>::min()));
}

double greatestLightening()
{
    return std::cbrt(2.0);
}

int versionNeededBy(const Painting &painting)
{
    int version = 1;
    for (const StrokePtr &stroke : painting.strokes) {
        version = std::max(version, versionNeededBy(*stroke));
        for (const Segment &segment : stroke->segments)
            version = std::max(version, versionNeededBy(segment));
    }
    for (const Group &group : painting.groups)
        version = std::max({version, versionNeededBy(group), group.text ? versionNeededBy(*group.text) : 1});
    for (const Swatch &swatch : painting.swatches)
        version = std::max(version, versionNeededBy(swatch));
    return version;
}

const Number<Segment> &numberOf(float Segment::*member)
{
    return findNumber([&](const Number<Segment> &n) { return n.member == member; });
}

const Number<Segment> &numberOf(float Colour::*channel)
{
    return findNumber([&](const Number<Segment> &n) { return !n.member && n.channel == channel; });
}

bool operator==(const Picture &a, const Picture &b)
{
    bool equal = true;
    forEachFieldOf<Picture>([&]<class Value>(const Field<Picture, Value> &field) {
        if constexpr (!std::is_same_v<Value, EncodedImage>)
            equal = equal && a.*field.member == b.*field.member;
    });
    return equal;
}

QString sha256Of(const QByteArray &bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

bool operator==(const Paper &a, const Paper &b)
{
    return equalFields(a, b);
}

bool operator==(const Underlay &a, const Underlay &b)
{
    return equalFields(a, b);
}

} // namespace suffuse

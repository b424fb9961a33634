#include "model/formats/text/field_json.h"

#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"

#include <QCryptographicHash>

namespace suffuse {

namespace {

/// The extent that gives exactly `to` when it is added to `from`. The plain difference may be wrong by one rounding.
double extentTo(double from, double to)
{
    const double plain = to - from;
    for (const double extent : {plain, std::nextafter(plain, HUGE_VAL), std::nextafter(plain, -HUGE_VAL)}) {
        if (from + extent == to)
            return extent;
    }
    return plain;
}

} // namespace

void readImage(JsonReader &json, EncodedImage &target)
{
    QString text;
    json.read(text);
    if (!json.ok())
        return;
    auto image = imageFromText(text, json.fileName());
    if (image)
        target = *image;
    else
        json.fail(image.error());
}

void readPicture(JsonReader &json, SharedPicture &target)
{
    Picture picture;
    readObject(json, picture);
    if (picture.image)
        picture.sha256 = sha256Of(*picture.image);
    target = std::move(picture);
}

void readBezier(JsonReader &json, std::array<Offset, 4> &points)
{
    const std::size_t count = json.array([&](std::size_t i) {
        std::array<float, 2> xy{};
        json.readAll(xy);
        if (i < 4)
            points[i] = {xy[0], xy[1]};
    });
    if (json.ok() && count != 4)
        json.fail(FileMessages::tr("has %1 points instead of 4").arg(count));
}

void readOffset(JsonReader &json, Offset &offset)
{
    std::array<float, 2> xy{};
    json.readAll(xy);
    offset = {xy[0], xy[1]};
}

void readMatrix(JsonReader &json, Affine &map)
{
    std::array<double, 6> n{};
    json.readAll(n);
    map = {n[0], n[1], n[2], n[3], {n[4], n[5]}};
}

void readCurves(JsonReader &json, std::vector<Cubic> &curves)
{
    json.array([&](std::size_t) {
        Cubic &curve = curves.emplace_back();
        const std::size_t count = json.array([&](std::size_t i) {
            std::array<double, 2> xy{};
            json.readAll(xy);
            if (i < 4)
                curve.p[i] = {xy[0], xy[1]};
        });
        if (json.ok() && count != 4)
            json.fail(FileMessages::tr("has %1 points instead of 4").arg(count));
    });
}

void readRewet(JsonReader &json, std::vector<Rewet> &list)
{
    json.array([&](std::size_t) {
        Rewet r;
        const std::size_t count = json.array([&](std::size_t i) {
            Microseconds ignored = 0;
            json.readSeconds(i == 0 ? r.time : i == 1 ? r.extra : ignored);
        });
        if (json.ok() && count != 2)
            json.fail(FileMessages::tr("has %1 numbers instead of 2").arg(count));
        list.push_back(r);
    });
}

void readArea(JsonReader &json, Rect &target)
{
    std::array<double, 4> area{};
    json.readAll(area);
    if (json.ok() && !(area[2] >= 0 && area[3] >= 0))
        json.fail(FileMessages::tr("width and height must not be negative"));
    target = Rect::of(area[0], area[1], area[2], area[3]);
}

void readSeed(JsonReader &json, std::uint32_t &target)
{
    std::uint64_t seed = 0;
    json.read(seed);
    if (json.ok() && seed > 0xffffffffu)
        json.fail(FileMessages::tr("%1 is not in [0, 4294967295]").arg(seed));
    target = std::uint32_t(seed);
}

void appendImage(QByteArray &out, const EncodedImage &image)
{
    out.append('"').append(imageToText(*image)).append('"');
}

void appendArea(QByteArray &out, const Rect &area)
{
    appendNumber(out.append('['), area.left);
    appendNumber(out.append(','), area.top);
    appendNumber(out.append(','), extentTo(area.left, area.right));
    appendNumber(out.append(','), extentTo(area.top, area.bottom));
    out.append(']');
}

void appendMatrix(QByteArray &out, const Affine &map)
{
    const std::array<double, 6> numbers{map.a, map.b, map.c, map.d, map.offset.x, map.offset.y};
    for (std::size_t k = 0; k < numbers.size(); ++k)
        appendNumber(out.append(k ? ',' : '['), numbers[k]);
    out.append(']');
}

QByteArray imageSummary(const EncodedImage &image)
{
    if (!image)
        return "null";
    QByteArray out;
    appendString(out,
                 QStringLiteral("%1 bytes, SHA-256 %2")
                     .arg(image->size())
                     .arg(QString::fromLatin1(QCryptographicHash::hash(*image, QCryptographicHash::Sha256).toHex())));
    return out;
}

} // namespace suffuse

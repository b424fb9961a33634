#include "app/dialogs/export/export_settings.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "render/layered/layered_file.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int mostDocuments = 50;

QString stored(const QJsonObject &object)
{
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

QJsonObject objectIn(const QString &key)
{
    return QJsonDocument::fromJson(settings::store().value(key).toString().toUtf8()).object();
}

/// Makes a key of a name. Some names are paths, which have characters that keys cannot have.
QString settingOf(const QString &group, const QString &name)
{
    return group + QLatin1Char('/') +
           QString::fromLatin1(QCryptographicHash::hash(name.toUtf8(), QCryptographicHash::Sha1).toHex().left(16));
}

QStringList keysOf(const QString &group)
{
    QSettings &store = settings::store();
    store.beginGroup(group);
    QStringList keys = store.childKeys();
    store.endGroup();
    for (QString &key : keys)
        key.prepend(group + QLatin1Char('/'));
    return keys;
}

const QString documentsGroup = QStringLiteral("exports"), presetsGroup = QStringLiteral("exportPresets"),
              lastKey = QStringLiteral("lastExport");

} // namespace

ImageOptions ExportSettings::image(const QByteArray &profile) const
{
    ImageOptions options;
    options.depth = depth;
    options.alpha = transparent;
    options.quality = quality;
    options.dpi = dpi;
    if (usesProfile && hasProfile(format()))
        options.profile = profile;
    return options;
}

QStringList exportEndings()
{
    return imageEndings() << QStringLiteral("ora") << QStringLiteral("psd");
}

ImageFormat pixelFormatFor(const QString &path)
{
    return layeredFormatFor(path) != LayeredFormat::None ? ImageFormat::Png : imageFormatForPath(path);
}

bool ExportSettings::writesAs(const ExportSettings &other) const
{
    ExportSettings same = other;
    same.path = path, same.scale = scale; // the scale is what the width and the area make it
    if (area != AreaRow::Choice::Numbers)
        same.numbers = numbers;
    if (moment != MomentRow::Choice::Time)
        same.time = time;
    return same == *this && format() == other.format() && layeredFormatFor(path) == layeredFormatFor(other.path);
}

QJsonObject ExportSettings::toJson() const
{
    return {{"path", path},
            {"depth", nameOf(depth)},
            {"quality", quality},
            {"transparent", transparent},
            {"usesProfile", usesProfile},
            {"dpi", dpi},
            {"area", int(area)},
            {"numbers", QJsonArray{numbers.left, numbers.top, numbers.right, numbers.bottom}},
            {"width", width},
            {"scale", scale},
            {"moment", int(moment)},
            {"time", double(time)}};
}

std::optional<ExportSettings> ExportSettings::fromJson(const QJsonObject &object)
{
    ExportSettings s;
    s.path = object["path"].toString();
    for (const ImageDepth depth : {ImageDepth::Bits8, ImageDepth::Bits16, ImageDepth::Half, ImageDepth::Float})
        if (object["depth"].toString() == nameOf(depth))
            s.depth = depth;
    s.quality = object["quality"].toInt();
    s.transparent = object["transparent"].toBool();
    s.usesProfile = object["usesProfile"].toBool();
    s.dpi = object["dpi"].toDouble();
    s.area = AreaRow::Choice(object["area"].toInt(-1));
    const QJsonArray numbers = object["numbers"].toArray();
    s.numbers = {numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble(), numbers[3].toDouble()};
    s.width = object["width"].toInt();
    s.scale = object["scale"].toDouble();
    s.moment = MomentRow::Choice(object["moment"].toInt(-1));
    s.time = Microseconds(std::clamp(object["time"].toDouble(), -1e15, 1e15));
    const bool sound = s.format() != ImageFormat::Unknown && s.quality >= 1 && s.quality <= 100 && s.dpi >= 1 &&
                       s.dpi <= 10'000 && s.area >= AreaRow::Choice::Canvas && s.area <= AreaRow::Choice::Numbers &&
                       s.moment >= MomentRow::Choice::Dried && s.moment <= MomentRow::Choice::Time && s.width >= 1 &&
                       s.scale > 0 && s.numbers.width() > 0 && s.numbers.height() > 0;
    return sound ? std::optional(s) : std::nullopt;
}

Result<ExportOrder> exportOrder(const ExportSettings &settings, Editor &editor, const Rect &shown)
{
    ExportOrder order;
    order.path = settings.path;
    order.painting = editor.document().painting();
    order.area =
        settings.area == AreaRow::Choice::Numbers ? settings.numbers : exportArea(settings.area, editor, shown);
    if (order.area.isEmpty())
        return Error{settings.area == AreaRow::Choice::Selected
                         ? QCoreApplication::translate("Export", "The selected strokes were exported last, and nothing "
                                                                 "is selected. Select strokes, or choose Export…")
                         : QCoreApplication::translate("Export", "There is nothing to export. Choose Export…")};
    order.time = settings.moment == MomentRow::Choice::Time  ? settings.time
                 : settings.moment == MomentRow::Choice::Now ? editor.clock().time()
                                                             : order.painting->end();
    order.width = int(std::clamp(std::round(order.area.width() * settings.scale), 1.0, 1e9));
    order.height = std::max(suffuse::heightForWidth(order.area, order.width), 1);
    order.image = settings.image(editor.extras().profile);
    order.transparent = order.image.alpha;
    order.threads = settings::threads();
    if (const QString problem = problemOf(settings.format(), order.image, order.width, order.height);
        !problem.isEmpty())
        return Error{problem};
    return order;
}

namespace exports {

std::optional<ExportSettings> last()
{
    return ExportSettings::fromJson(objectIn(lastKey));
}

std::optional<ExportSettings> lastOf(const QString &document)
{
    return document.isEmpty() ? std::nullopt : ExportSettings::fromJson(objectIn(settingOf(documentsGroup, document)));
}

void remember(const QString &document, const ExportSettings &settings)
{
    QJsonObject object = settings.toJson();
    settings::store().setValue(lastKey, stored(object));
    if (document.isEmpty())
        return;
    object["at"] = QDateTime::currentSecsSinceEpoch();
    settings::store().setValue(settingOf(documentsGroup, document), stored(object));
    QStringList keys = keysOf(documentsGroup);
    if (keys.size() <= mostDocuments)
        return;
    const auto oldest =
        std::ranges::min_element(keys, {}, [](const QString &key) { return objectIn(key)["at"].toDouble(); });
    settings::store().remove(*oldest);
}

QStringList presets()
{
    QStringList names;
    for (const QString &key : keysOf(presetsGroup))
        if (const QJsonObject object = objectIn(key); ExportSettings::fromJson(object))
            names << object["name"].toString();
    names.sort(Qt::CaseInsensitive);
    return names;
}

std::optional<ExportSettings> preset(const QString &name)
{
    return ExportSettings::fromJson(objectIn(settingOf(presetsGroup, name)));
}

void setPreset(const QString &name, const ExportSettings &settings)
{
    QJsonObject object = settings.toJson();
    object["name"] = name;
    object["path"] = QStringLiteral("picture.") + settings.path.section(QLatin1Char('.'), -1);
    settings::store().setValue(settingOf(presetsGroup, name), stored(object));
}

void removePreset(const QString &name)
{
    settings::store().remove(settingOf(presetsGroup, name));
}

} // namespace exports

} // namespace suffuse

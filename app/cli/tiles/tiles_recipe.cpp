#include "app/cli/tiles/tiles_recipe.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>
#include <cstring>

#include <link.h>

namespace suffuse::cli {

namespace {

constexpr int usualTile = 254, usualOverlap = 1, usualTiffTile = 512, usualQuality = 85;

const QStringList formatNames{QStringLiteral("jpg"), QStringLiteral("png"), QStringLiteral("tif")};

/// A whole number from `least` to `most`.
Result<int> numberOf(const CommandLine &line, const QString &option, int usual, int least, int most)
{
    if (!line.isSet(option))
        return usual;
    bool ok = false;
    const int value = line.value(option).toInt(&ok);
    if (ok && value >= least && value <= most)
        return value;
    return Error{QCoreApplication::translate("Cli", "--%1 %2: give a whole number from %3 to %4")
                     .arg(option, line.value(option))
                     .arg(least)
                     .arg(most)};
}

/// The format by the ending and --format.
Result<TileFormat> tileFormatOf(const CommandLine &line, const QString &out)
{
    const ImageFormat ending = imageFormatForPath(out);
    if (ending != ImageFormat::Unknown && ending != ImageFormat::Tiff)
        return Error{
            QCoreApplication::translate("Cli", "--tiles %1: give a name that ends in .dzi or .tif, or a folder")
                .arg(out)};
    const QString format = line.value(QStringLiteral("format")).toLower();
    if (ending == ImageFormat::Tiff) {
        if (!format.isEmpty())
            return Error{
                QCoreApplication::translate("Cli", "--format is for Deep Zoom: the tiles of a TIFF are packed in it")};
        return TileFormat::Tiff;
    }
    if (format.isEmpty())
        return line.isSet(QStringLiteral("transparent")) || line.isSet(QStringLiteral("depth")) ? TileFormat::Png
                                                                                                : TileFormat::Jpeg;
    if (format == QLatin1String("jpg") || format == QLatin1String("jpeg"))
        return TileFormat::Jpeg;
    if (format == QLatin1String("png"))
        return TileFormat::Png;
    return Error{QCoreApplication::translate("Cli", "--format %1: tiles of a Deep Zoom are jpg or png").arg(format)};
}

Result<TileEncoding> encodingOf(const CommandLine &line, const QString &out)
{
    const Result<TileFormat> format = tileFormatOf(line, out);
    if (!format)
        return Error{format.error()};
    TileEncoding encoding;
    encoding.format = *format;
    encoding.image.alpha = line.isSet(QStringLiteral("transparent"));
    const QString depth =
        line.isSet(QStringLiteral("depth")) ? line.value(QStringLiteral("depth")) : QStringLiteral("8");
    if (depth != QLatin1String("8") && depth != QLatin1String("16"))
        return Error{QCoreApplication::translate("Cli", "--depth %1: tiles have 8 or 16 bits").arg(depth)};
    encoding.image.depth = depth == QLatin1String("16") ? ImageDepth::Bits16 : ImageDepth::Bits8;
    if (*format == TileFormat::Jpeg && (encoding.image.alpha || encoding.bits() > 8))
        return Error{QCoreApplication::translate(
            "Cli", "tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif")};
    const Result<int> quality = numberOf(line, QStringLiteral("quality"), usualQuality, 1, 100);
    if (!quality)
        return Error{quality.error()};
    encoding.image.quality = *quality;
    return encoding;
}

/// Whether code lies in a program or a library that is loaded.
bool holds(const dl_phdr_info &file, ElfW(Addr) code)
{
    for (int i = 0; i < file.dlpi_phnum; ++i)
        if (const auto &part = file.dlpi_phdr[i];
            part.p_type == PT_LOAD && code - (file.dlpi_addr + part.p_vaddr) < part.p_memsz)
            return true;
    return false;
}

/// The build id that the linker put into the file with this code, the program or Python's module; without one, its version
/// has to do.
QByteArray buildId()
{
    QByteArray id;
    dl_iterate_phdr(
        [](dl_phdr_info *info, std::size_t, void *to) {
            if (!holds(*info, reinterpret_cast<ElfW(Addr)>(&buildId)))
                return 0;
            for (int i = 0; i < info->dlpi_phnum; ++i) {
                if (info->dlpi_phdr[i].p_type != PT_NOTE)
                    continue;
                const char *note = reinterpret_cast<const char *>(info->dlpi_addr + info->dlpi_phdr[i].p_vaddr);
                const char *const end = note + info->dlpi_phdr[i].p_memsz;
                while (note + sizeof(ElfW(Nhdr)) < end) {
                    ElfW(Nhdr) head;
                    std::memcpy(&head, note, sizeof head);
                    const char *name = note + sizeof head, *value = name + (head.n_namesz + 3) / 4 * 4;
                    if (head.n_type == NT_GNU_BUILD_ID && std::memcmp(name, "GNU", 4) == 0)
                        *static_cast<QByteArray *>(to) = QByteArray(value, int(head.n_descsz)).toHex();
                    note = value + (head.n_descsz + 3) / 4 * 4;
                }
            }
            return 1;
        },
        &id);
    return id;
}

/// What is made of a small tile: other libraries may encode it otherwise.
QByteArray encodedTile(const TileEncoding &encoding)
{
    SheetPicture sheet;
    sheet.isDeep = encoding.bits() > 8;
    sheet.bits8.resize(16, 16);
    sheet.floats.resize(16, 16);
    for (std::size_t i = 0; i < sheet.floats.rgba.size(); ++i)
        sheet.floats.rgba[i] = float(i * i % 251) / 250;
    sheet.bits8.store({0, 0, 16, 16}, sheet.floats.rgba.data(), 16);
    const Result<QByteArray> bytes = encodeTile(sheet, {0, 0, 16, 16}, encoding);
    return bytes ? QByteArray::number(tileHash(*bytes), 16) : QByteArray();
}

} // namespace

QString TilesRecipe::path() const
{
    const bool isFile = isTiff() || out.endsWith(QLatin1String(".dzi"), Qt::CaseInsensitive);
    return isFile ? out : out + (out.endsWith('/') ? QStringLiteral("index.dzi") : QStringLiteral("/index.dzi"));
}

QJsonObject TilesRecipe::json() const
{
    return {{"area", QJsonArray{area.left, area.top, area.width(), area.height()}},
            {"width", width},
            {"height", height},
            {"time", QString::number(time)},
            {"drafts", drafts},
            {"tile", tiles.tile},
            {"overlap", tiles.overlap},
            {"sheet", tiles.sheet},
            {"format", formatNames[int(encoding.format)]},
            {"transparent", encoding.image.alpha},
            {"bits", encoding.bits()},
            {"quality", encoding.image.quality}};
}

Result<TilesRecipe> TilesRecipe::ofJson(const QJsonObject &json, const QString &out)
{
    TilesRecipe recipe;
    recipe.out = out;
    const QJsonArray area = json["area"].toArray();
    recipe.area = Rect::of(area[0].toDouble(), area[1].toDouble(), area[2].toDouble(), area[3].toDouble());
    recipe.width = json["width"].toInt();
    recipe.height = json["height"].toInt();
    recipe.time = json["time"].toString().toLongLong();
    recipe.drafts = json["drafts"].toBool();
    recipe.tiles.tile = json["tile"].toInt();
    recipe.tiles.overlap = json["overlap"].toInt();
    recipe.tiles.sheet = json["sheet"].toInt();
    const qsizetype format = formatNames.indexOf(json["format"].toString());
    recipe.encoding.format = TileFormat(std::max<qsizetype>(format, 0));
    recipe.encoding.side = recipe.tiles.tile;
    recipe.encoding.image.alpha = json["transparent"].toBool();
    recipe.encoding.image.depth = json["bits"].toInt() == 16 ? ImageDepth::Bits16 : ImageDepth::Bits8;
    recipe.encoding.image.quality = json["quality"].toInt();
    recipe.tiles.toOne = !recipe.isTiff();
    const bool isGood = format >= 0 && recipe.width > 0 && recipe.width <= maxTiledSide && recipe.height > 0 &&
                        recipe.height <= maxTiledSide && recipe.tiles.tile >= 16 && recipe.tiles.tile <= 4096 &&
                        recipe.tiles.overlap >= 0 && recipe.tiles.overlap <= 64 && recipe.area.width() > 0;
    if (!isGood)
        return Error{QCoreApplication::translate("Cli", "the plan is damaged; make it anew")};
    return recipe;
}

QString problemOfTilesName(const QString &out)
{
    const QString name = QFileInfo(out).fileName().toLower();
    const bool isBareEnding =
        name == QLatin1String(".dzi") || name == QLatin1String(".tif") || name == QLatin1String(".tiff");
    return out.isEmpty() || isBareEnding
               ? QCoreApplication::translate("Cli",
                                             "--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder")
                     .arg(out)
               : QString();
}

Result<TilesRecipe> tilesRecipe(const CommandLine &line, const Painting &painting)
{
    TilesRecipe recipe;
    recipe.out = line.value(QStringLiteral("tiles"));
    if (const QString problem = problemOfTilesName(recipe.out); !problem.isEmpty())
        return Error{problem};
    const Result<TileEncoding> encoding = encodingOf(line, recipe.out);
    if (!encoding)
        return Error{encoding.error()};
    recipe.encoding = *encoding;
    const Result<int> tile =
                          numberOf(line, QStringLiteral("tile"), recipe.isTiff() ? usualTiffTile : usualTile, 16, 4096),
                      overlap = numberOf(line, QStringLiteral("overlap"), recipe.isTiff() ? 0 : usualOverlap, 0, 64),
                      sheet = numberOf(line, QStringLiteral("sheet"), 0, 16, 8192);
    for (const Result<int> *number : {&tile, &overlap, &sheet})
        if (!*number)
            return Error{number->error()};
    if (recipe.isTiff() && (*tile % 16 != 0 || *overlap != 0))
        return Error{
            QCoreApplication::translate("Cli", "tiles of a TIFF do not overlap, and have sides of a multiple of 16")};
    recipe.tiles = {*tile, *overlap, *sheet, !recipe.isTiff()};
    recipe.encoding.side = *tile;
    const Result<PictureOptions> picture = pictureOptions(line, painting, PictureLimit::Side);
    if (!picture)
        return Error{picture.error()};
    recipe.area = picture->area;
    recipe.width = picture->width;
    recipe.height = picture->height;
    recipe.time = picture->time;
    recipe.drafts = line.isSet(QStringLiteral("drafts"));
    return recipe;
}

int usualSheet(Backend backend)
{
    return backend == Backend::Cuda ? 8192 : 2048;
}

QJsonObject drawnBy(const Renderer &renderer, const TileEncoding *encoding)
{
    // "2 threads · AVX2": the number of threads changes no bit.
    QString device = renderer.deviceName();
    if (renderer.backend() == Backend::Cpu)
        device = device.section(QStringLiteral(" · "), -1);
    if (renderer.backend() == Backend::Reference)
        device.clear();
    QJsonObject by{{"build", QString::fromLatin1(SUFFUSE_VERSION " " + buildId())},
                   {"backend", nameOf(renderer.backend())},
                   {"device", device}};
    if (encoding)
        by["encoder"] = QString::fromLatin1(encodedTile(*encoding));
    return by;
}

QByteArray identityOf(const QByteArray &paintingHash, const QJsonObject &recipe, const QJsonObject &drawnBy)
{
    const QJsonObject all{{"painting", QString::fromLatin1(paintingHash.toHex())}, {"recipe", recipe}, {"by", drawnBy}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

RenderRequest requestOf(const PaintingPtr &painting, const TilesRecipe &recipe)
{
    RenderRequest request;
    request.painting = recipe.drafts ? painting : withoutDrafts(painting);
    request.time = recipe.time;
    request.view = recipe.view();
    request.transparent = recipe.encoding.image.alpha;
    return request;
}

} // namespace suffuse::cli

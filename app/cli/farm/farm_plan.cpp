#include "app/cli/farm/farm_plan.h"

#include "app/cli/farm/farm_claim.h"
#include "render/film/film_writer.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRandomGenerator>
#include <QSysInfo>

#include <algorithm>

namespace suffuse::cli {

namespace {

constexpr int version = 1;
const QString fileName = QStringLiteral("plan.json");

QByteArray bytesOf(const FarmPlan &plan)
{
    QJsonArray paintings;
    for (const FarmPainting &p : plan.paintings)
        paintings.append(QJsonObject{{"path", p.path},
                                     {"hash", QString::fromLatin1(p.hash.toHex())},
                                     {"out", p.out()},
                                     {"pieces", p.pieces},
                                     {"kind", p.isFrames ? "frames" : "tiles"},
                                     {"recipe", p.isFrames ? p.frames.json() : p.tiles.json()}});
    return QJsonDocument(
               QJsonObject{{"format", "suffuse-farm"}, {"version", version}, {"by", plan.by}, {"paintings", paintings}})
        .toJson();
}

Error damaged(const QString &path)
{
    return Error{
        QCoreApplication::translate("Cli", "%1: the plan is damaged, or of another version; make it anew").arg(path)};
}

Result<FarmPainting> paintingOfJson(const QJsonObject &json)
{
    FarmPainting p;
    p.path = json["path"].toString();
    p.hash = QByteArray::fromHex(json["hash"].toString().toLatin1());
    p.isFrames = json["kind"].toString() == QLatin1String("frames");
    if (p.isFrames) {
        const auto recipe = FramesRecipe::ofJson(json["recipe"].toObject(), json["out"].toString());
        if (!recipe)
            return Error{recipe.error()};
        p.frames = *recipe;
        p.pieces = p.frames.frames;
    } else {
        const auto recipe = TilesRecipe::ofJson(json["recipe"].toObject(), json["out"].toString());
        if (!recipe)
            return Error{recipe.error()};
        p.tiles = *recipe;
        p.pieces = TilePlan(p.tiles.view(), p.tiles.tiles).sheets();
    }
    if (double(p.pieces) != json["pieces"].toDouble())
        return Error{QCoreApplication::translate("Cli", "the plan is damaged; make it anew")};
    return p;
}

} // namespace

QJsonObject FramesRecipe::json() const
{
    return {{"area", QJsonArray{area.left, area.top, area.width(), area.height()}},
            {"width", width},
            {"height", height},
            {"frames", frames},
            {"idle", idle},
            {"transparent", transparent},
            {"drafts", drafts},
            {"bits", bits},
            {"quality", quality}};
}

Result<FramesRecipe> FramesRecipe::ofJson(const QJsonObject &json, const QString &out)
{
    const QJsonArray area = json["area"].toArray();
    FramesRecipe recipe{out,
                        Rect::of(area[0].toDouble(), area[1].toDouble(), area[2].toDouble(), area[3].toDouble()),
                        json["width"].toInt(),
                        json["height"].toInt(),
                        json["frames"].toInt(),
                        json["idle"].toDouble(),
                        json["transparent"].toBool(),
                        json["drafts"].toBool(),
                        json["bits"].toInt(),
                        json["quality"].toInt()};
    if (recipe.width < 1 || recipe.height < 1 || recipe.frames < 1 || recipe.area.width() <= 0 ||
        qint64(recipe.width) * recipe.height > maxPicturePixels)
        return Error{QCoreApplication::translate("Cli", "the plan is damaged; make it anew")};
    return recipe;
}

ImageOptions FramesRecipe::image() const
{
    ImageOptions options;
    options.alpha = transparent;
    options.quality = quality;
    options.depth = bits == 16 ? std::optional(ImageDepth::Bits16) : std::nullopt;
    options.quick = true;
    return options;
}

QString FramesRecipe::pathOf(qint64 frame) const
{
    return frameName(out, std::size_t(frame) + 1);
}

const FarmPainting &FarmPlan::paintingOf(qint64 piece) const
{
    const auto after = std::upper_bound(paintings.begin(), paintings.end(), piece,
                                        [](qint64 at, const FarmPainting &p) { return at < p.first; });
    return *std::prev(after);
}

Result<FarmPlan> writePlan(const FarmPlan &plan)
{
    const QString path = QDir(plan.folder).filePath(fileName);
    const QByteArray bytes = bytesOf(plan);
    if (QFile there(path); there.exists()) {
        if (there.open(QIODevice::ReadOnly) && there.readAll() == bytes)
            return readPlan(plan.folder);
        return Error{QCoreApplication::translate(
                         "Cli", "%1: there is another plan already. Remove the folder, or choose another one.")
                         .arg(plan.folder)};
    }
    if (const QString problem = problemOfClaims(plan); !problem.isEmpty())
        return Error{problem};
    for (const QString &folder : {plan.folder, plan.journals(), plan.packs()})
        if (!QDir().mkpath(folder))
            return Error{QCoreApplication::translate("Cli",
                                                     "%1: the folder cannot be made. Choose another one, or change "
                                                     "its permissions.")
                             .arg(folder)};
    for (const FarmPainting &p : plan.paintings) {
        const QString folder = p.isFrames         ? QFileInfo(p.frames.out).path()
                               : p.tiles.isTiff() ? QFileInfo(p.tiles.path()).path()
                                                  : DeepZoomStore::filesOf(p.tiles.path());
        const bool isDeepZoom = !p.isFrames && !p.tiles.isTiff();
        const bool isFolderTaken = isDeepZoom && QFileInfo::exists(folder) && !QDir(folder).isEmpty();
        if (isFolderTaken || (isDeepZoom && DeepZoomStore::isPageTaken(p.tiles.path())))
            return Error{QCoreApplication::translate(
                             "Cli", "%1: there is something else already. Remove it, or choose another name.")
                             .arg(isFolderTaken ? folder : DeepZoomStore::pageOf(p.tiles.path()))};
        if (!QDir().mkpath(folder))
            return Error{QCoreApplication::translate("Cli",
                                                     "%1: the folder cannot be made. Choose another one, or change "
                                                     "its permissions.")
                             .arg(folder)};
    }
    if (const Result<void> written = replaceFile(path, bytes, true); !written)
        return Error{written.error()};
    if (const Result<void> claimed = claimOuts(plan); !claimed) {
        QFile::remove(path);
        return Error{claimed.error()};
    }
    return readPlan(plan.folder);
}

Result<FarmPlan> readPlan(const QString &folder)
{
    FarmPlan plan;
    plan.folder = QDir(folder).absolutePath();
    const QString path = QDir(plan.folder).filePath(fileName);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{QCoreApplication::translate(
                         "Cli", "%1: there is no plan (%2). Is the shared folder there? farm plan makes one.")
                         .arg(path, file.errorString())};
    const QByteArray bytes = file.readAll();
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    if (json["format"].toString() != QLatin1String("suffuse-farm") || json["version"].toInt() != version)
        return damaged(path);
    plan.by = json["by"].toObject();
    plan.identity = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
    for (const auto &each : json["paintings"].toArray()) {
        Result<FarmPainting> p = paintingOfJson(each.toObject());
        if (!p)
            return damaged(path);
        p->first = plan.pieces();
        plan.paintings.push_back(std::move(*p));
    }
    if (plan.paintings.empty())
        return damaged(path);
    return plan;
}

QString FarmPlan::workerName(qint64 from, qint64 to)
{
    return QStringLiteral("%1-%2-%3-%4")
        .arg(from)
        .arg(to)
        .arg(QSysInfo::machineHostName())
        .arg(QRandomGenerator::system()->generate64(), 0, 16);
}

Result<FarmRecords> readRecords(const FarmPlan &plan, qint64 from, qint64 to, std::vector<DamagedJournal> *damaged)
{
    FarmRecords all;
    const QDir folder(plan.journals());
    if (!folder.exists())
        return Error{QCoreApplication::translate("Cli", "%1: the folder is gone. Is the shared folder there?")
                         .arg(folder.path())};
    for (const QString &name : folder.entryList({QStringLiteral("*.journal")}, QDir::Files, QDir::Name)) {
        const qint64 first = name.section('-', 0, 0).toLongLong(), end = name.section('-', 1, 1).toLongLong();
        if (first >= to || end <= from)
            continue;
        int lines = 0;
        const auto records = TileJournal::read(folder.filePath(name), plan.identity, &lines);
        if (!records)
            return Error{records.error()};
        if (damaged && lines > 0)
            damaged->push_back({folder.filePath(name), lines, first, end});
        const QString pack = plan.packs() + '/' + name.chopped(8) + QStringLiteral(".pack");
        for (const SheetRecord &record : *records)
            if (record.sheet >= from && record.sheet < to)
                all.emplace(record.sheet, std::pair(record, pack));
    }
    return all;
}

bool isPieceWhole(const FarmPlan &plan, const FarmRecords &records, qint64 piece)
{
    const auto [from, to] = records.equal_range(piece);
    if (from == to)
        return false;
    const FarmPainting &painting = plan.paintingOf(piece);
    if (painting.isFrames) {
        QFile file(painting.frames.pathOf(piece - painting.first));
        if (!file.open(QIODevice::ReadOnly))
            return false;
        const QByteArray bytes = file.readAll();
        return std::any_of(from, to, [&](const auto &record) { return isWhole(record.second.first, bytes); });
    }
    TileJournal none;
    const qint64 sheet = piece - painting.first;
    if (painting.tiles.isTiff()) {
        PackRecords own;
        for (auto it = from; it != to; ++it)
            own.emplace(sheet, it->second);
        PackFile file;
        return PackStore(own, none, file).whole(sheet).has_value();
    }
    SheetRecords own;
    for (auto it = from; it != to; ++it)
        own.emplace(sheet, it->second.first);
    const TiledPicture picture = painting.picture();
    return DeepZoomStore(picture, own, none).has(sheet);
}

std::vector<LostFile> lostFilesOf(const FarmPlan &plan, const FarmRecords &records, qint64 piece)
{
    const auto [from, to] = records.equal_range(piece);
    if (from == to)
        return {};
    const FarmPainting &painting = plan.paintingOf(piece);
    const qint64 own = piece - painting.first;
    if (!painting.isFrames && !painting.tiles.isTiff()) {
        SheetRecords sheets;
        for (auto it = from; it != to; ++it)
            sheets.emplace(own, it->second.first);
        TileJournal none;
        const TiledPicture picture = painting.picture();
        return DeepZoomStore(picture, std::move(sheets), none).lost(own);
    }
    if (painting.isFrames) {
        const auto isGood = [&, from = from, to = to](const QByteArray &bytes) {
            return std::any_of(from, to, [&](const auto &record) { return isWhole(record.second.first, bytes); });
        };
        const auto file = lostFile(painting.frames.pathOf(own), isGood);
        return file ? std::vector{*file} : std::vector<LostFile>();
    }
    std::vector<LostFile> packs;
    for (auto it = from; it != to; ++it)
        packs.push_back({it->second.second, QFileInfo::exists(it->second.second)});
    return packs;
}

QString rangesOf(const std::vector<qint64> &numbers)
{
    QStringList parts;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1)
            ++end;
        const QString first = QString::number(numbers[i]), last = QString::number(numbers[end - 1]);
        if (end - i == 2)
            parts << first << last;
        else
            parts << (end - i == 1 ? first : first + '-' + last);
        i = end;
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace suffuse::cli

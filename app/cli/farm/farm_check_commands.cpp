// What is there of a farm: status, verify, join.
#include "app/cli/farm/farm_claim.h"
#include "app/cli/farm/farm_commands.h"
#include "app/cli/progress.h"
#include "render/threads/parallel.h"
#include "render/tiles/big_tiff.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <atomic>
#include <functional>

namespace suffuse::cli {

namespace {

constexpr std::size_t mostFilesShown = 20;

/// What is not there of a plan, or not whole.
struct Missing {
    std::vector<qint64> pieces;
    std::vector<LostFile> files;           ///< that were finished once
    std::vector<DamagedJournal> journals; ///< that lost what they said of pieces that are missing

    bool isEmpty() const { return pieces.empty(); }
};

/// Those of a painting, as people count them.
QString numbersOf(const FarmPainting &p, const Missing &missing)
{
    std::vector<qint64> own;
    for (const qint64 piece : missing.pieces)
        if (piece >= p.first && piece < p.first + p.pieces)
            own.push_back(piece - p.first + 1);
    return rangesOf(own);
}

QJsonObject jsonOf(const FarmPlan &plan, const Missing &missing)
{
    QJsonArray paintings;
    for (const FarmPainting &p : plan.paintings)
        paintings.append(
            QJsonObject{{"path", p.path}, {"out", p.out()}, {"pieces", p.pieces}, {"missing", numbersOf(p, missing)}});
    QJsonArray files, journals;
    for (const LostFile &file : missing.files)
        files.append(QJsonObject{{"path", file.path}, {"state", file.isThere ? "damaged" : "missing"}});
    for (const DamagedJournal &journal : missing.journals)
        journals.append(QJsonObject{{"path", journal.path}, {"lines", journal.lines}});
    return {{"pieces", plan.pieces()}, {"missing", qint64(missing.pieces.size())},
            {"by", plan.by},           {"paintings", paintings},
            {"files", files},          {"journals", journals}};
}

QString textOf(const FarmPlan &plan, const Missing &missing)
{
    QString text = QCoreApplication::translate("Cli", "%1 of %2 pieces are there")
                       .arg(plan.pieces() - qint64(missing.pieces.size()))
                       .arg(plan.pieces()) +
                   '\n';
    for (const FarmPainting &p : plan.paintings)
        if (const QString numbers = numbersOf(p, missing); !numbers.isEmpty())
            text += (p.isFrames ? QCoreApplication::translate("Cli", "%1: frames %2 are missing")
                                : QCoreApplication::translate("Cli", "%1: sheets %2 are missing"))
                        .arg(p.out(), numbers) +
                    '\n';
    const std::size_t shown = std::min<std::size_t>(missing.files.size(), mostFilesShown);
    for (std::size_t i = 0; i < shown; ++i)
        text += (missing.files[i].isThere ? QCoreApplication::translate("Cli", "%1: is damaged")
                                          : QCoreApplication::translate("Cli", "%1: is missing"))
                    .arg(missing.files[i].path) +
                '\n';
    if (shown < missing.files.size())
        text += QCoreApplication::translate("Cli", "%n more file(s) are missing or damaged; farm verify --json names all.",
                                            nullptr, int(missing.files.size() - shown)) +
                '\n';
    for (const DamagedJournal &journal : missing.journals)
        text += QCoreApplication::translate("Cli",
                                            "%1: %n line(s) of this journal are damaged, so nobody knows what was "
                                            "finished. Run the tasks again: they draw what is missing.",
                                            nullptr, journal.lines)
                    .arg(journal.path) +
                '\n';
    return text;
}

/// Pieces without a record.
Missing unrecorded(const FarmPlan &plan, const FarmRecords &records)
{
    Missing missing;
    for (qint64 piece = 0; piece < plan.pieces(); ++piece)
        if (records.find(piece) == records.end())
            missing.pieces.push_back(piece);
    return missing;
}

/// Those of the journals whose tasks have missing pieces: what others lost was drawn again.
std::vector<DamagedJournal> journalsOf(const Missing &missing, const std::vector<DamagedJournal> &damaged)
{
    std::vector<DamagedJournal> journals;
    for (const DamagedJournal &journal : damaged)
        if (const auto at = std::lower_bound(missing.pieces.begin(), missing.pieces.end(), journal.from);
            at != missing.pieces.end() && *at < journal.to)
            journals.push_back(journal);
    return journals;
}

/// A piece for which workers made different bits; −1 if there is none.
qint64 disputed(const FarmRecords &records)
{
    for (auto it = records.begin(); it != records.end(); ++it)
        if (const auto next = std::next(it);
            next != records.end() && next->first == it->first && next->second.first.hashes != it->second.first.hashes)
            return it->first;
    return -1;
}

/// Pieces that are not whole, by reading all of them.
Result<Missing> damagedPieces(const FarmPlan &plan, const FarmRecords &records)
{
    if (const qint64 piece = disputed(records); piece >= 0)
        return Error{QCoreApplication::translate(
                         "Cli", "%1: two workers made different bits of piece %2. One of the machines is "
                                "faulty: find it by the names in %3, remove its journal there, and run "
                                "the tasks again.")
                         .arg(plan.paintingOf(piece).out())
                         .arg(piece - plan.paintingOf(piece).first + 1)
                         .arg(plan.journals())};
    ProgressLine progress(QCoreApplication::translate("Cli", "reading"), true);
    std::vector<char> whole(std::size_t(plan.pieces()), 0);
    std::atomic<qint64> done{0};
    parallelFor(whole.size(), Threads(), [&](std::size_t piece) {
        whole[piece] = !interrupted() && isPieceWhole(plan, records, qint64(piece));
        progress.show(++done, plan.pieces());
    });
    if (interrupted())
        return Error{QCoreApplication::translate("Cli", "stopped")};
    Missing missing;
    for (std::size_t piece = 0; piece < whole.size(); ++piece) {
        if (whole[piece])
            continue;
        missing.pieces.push_back(qint64(piece));
        for (LostFile &file : lostFilesOf(plan, records, qint64(piece)))
            if (missing.files.empty() || missing.files.back().path != file.path) // Many pieces have one pack.
                missing.files.push_back(std::move(file));
    }
    return missing;
}

Result<void> joinTiff(const FarmPlan &plan, const FarmRecords &records, const FarmPainting &p)
{
    const TiledPicture picture = p.picture();
    const QString part = picture.path + QStringLiteral(".part");
    QFile::remove(part);
    PackFile file;
    if (const Result<void> opened = file.open(part, bigTiffHead); !opened)
        return opened;
    PackRecords own;
    for (auto it = records.lower_bound(p.first); it != records.end() && it->first < p.first + p.pieces; ++it)
        own.emplace(it->first - p.first, it->second);
    TileJournal none;
    PackFile unused;
    const PackStore store(std::move(own), none, unused);
    ProgressLine progress(QCoreApplication::translate("Cli", "joining"), true);
    std::vector<SheetRecord> joined;
    for (qint64 sheet = 0; sheet < p.pieces; ++sheet) {
        auto whole = store.whole(sheet);
        if (interrupted() || !whole) {
            QFile::remove(part);
            return interrupted() ? Error{QCoreApplication::translate("Cli", "stopped")}
                                 : Error{QCoreApplication::translate(
                                             "Cli", "%1: sheet %2 cannot be read any more. Run the tasks again.")
                                             .arg(plan.folder)
                                             .arg(sheet + 1)};
        }
        const Result<qint64> at = file.add(whole->second);
        if (!at) {
            QFile::remove(part);
            return Error{at.error()};
        }
        whole->first.sheet = sheet;
        whole->first.offset = *at;
        joined.push_back(std::move(whole->first));
        progress.show(sheet + 1, p.pieces);
    }
    return frameBigTiff(picture, part, file.end(), joined);
}

Result<void> join(const FarmPlan &plan, const FarmRecords &records)
{
    for (const FarmPainting &p : plan.paintings) {
        Result<void> joined;
        TileJournal none;
        if (!p.isFrames && p.tiles.isTiff()) {
            joined = joinTiff(plan, records, p);
        } else if (!p.isFrames) {
            const TiledPicture picture = p.picture();
            joined = DeepZoomStore(picture, {}, none).finish();
        }
        if (!joined)
            return joined;
    }
    return {};
}

/// What status and verify have in common: `look` finds what is missing.
int report(const char *command, const QString &description, const QStringList &arguments,
           const std::function<Result<Missing>(const FarmPlan &, const FarmRecords &)> &look)
{
    CommandLine line(QLatin1String(command), description, {"FOLDER"});
    line.add({"json"}, QCoreApplication::translate("Cli", "Prints JSON (docs/cli.md)."));
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const Result<FarmPlan> plan = readPlan(line.argument(0));
    if (!plan)
        return fail(plan.error());
    std::vector<DamagedJournal> damaged;
    const Result<FarmRecords> records = readRecords(*plan, 0, plan->pieces(), &damaged);
    if (!records)
        return fail(records.error());
    Result<Missing> missing = look(*plan, *records);
    if (!missing)
        return fail(missing.error());
    missing->journals = journalsOf(*missing, damaged);
    const int printed = line.isSet("json") ? printJson(jsonOf(*plan, *missing)) : print(textOf(*plan, *missing));
    return printed == Done && !missing->isEmpty() ? int(Failed) : printed;
}

} // namespace

int farmStatusCommand(const QStringList &arguments)
{
    return report(
        "farm status", QCoreApplication::translate("Cli", "Says what is missing, by what workers wrote down."),
        arguments,
        [](const FarmPlan &plan, const FarmRecords &records) { return Result<Missing>(unrecorded(plan, records)); });
}

int farmVerifyCommand(const QStringList &arguments)
{
    return report("farm verify",
                  QCoreApplication::translate("Cli", "Says what is missing or damaged, by reading all of it."),
                  arguments, damagedPieces);
}

int farmJoinCommand(const QStringList &arguments)
{
    CommandLine line("farm join",
                     QCoreApplication::translate("Cli", "Puts the pictures together, once all is there and whole."),
                     {"FOLDER"});
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const Result<FarmPlan> plan = readPlan(line.argument(0));
    if (!plan)
        return fail(plan.error());
    if (const QString problem = problemOfClaims(*plan); !problem.isEmpty())
        return fail(problem);
    std::vector<DamagedJournal> damaged;
    const Result<FarmRecords> records = readRecords(*plan, 0, plan->pieces(), &damaged);
    if (!records)
        return fail(records.error());
    Result<Missing> missing = damagedPieces(*plan, *records);
    if (!missing)
        return fail(missing.error());
    missing->journals = journalsOf(*missing, damaged);
    if (!missing->isEmpty())
        return fail(
            textOf(*plan, *missing) +
            QCoreApplication::translate("Cli", "Nothing was joined. Run the tasks again: they draw what is missing."));
    if (const Result<void> joined = join(*plan, *records); !joined)
        return fail(joined.error());
    releaseOuts(*plan);
    QString text;
    for (const FarmPainting &p : plan->paintings)
        text += (p.isFrames ? p.frames.out : p.tiles.path()) + '\n';
    return print(text);
}

} // namespace suffuse::cli

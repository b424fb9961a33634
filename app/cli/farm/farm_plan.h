// What a farm is to draw: a folder that all machines share, with a plan in it.
#pragma once

#include "app/cli/tiles/tiles_recipe.h"

#include <map>

namespace suffuse::cli {

/// The frames of a painting that is being painted, as `timelapse` draws them.
struct FramesRecipe {
    QString out; ///< name%05d.png
    Rect area;
    int width = 0, height = 0;
    int frames = 0;
    double idle = 0.5;
    bool transparent = false, drafts = false;
    int bits = 8;
    int quality = 92;

    QJsonObject json() const;
    static Result<FramesRecipe> ofJson(const QJsonObject &json, const QString &out);
    ImageOptions image() const;
    QString pathOf(qint64 frame) const; ///< from 0; names count from 1
};

/// One painting of a plan. Its pieces are sheets of tiles, or frames.
struct FarmPainting {
    QString path;
    QByteArray hash;
    bool isFrames = false;
    TilesRecipe tiles;
    FramesRecipe frames;
    qint64 first = 0, pieces = 0; ///< among all pieces of the plan

    QString out() const { return isFrames ? frames.out : tiles.out; }
    TiledPicture picture() const { return {{tiles.view(), tiles.tiles}, tiles.encoding, tiles.path(), {}}; }
};

struct FarmPlan {
    QString folder;
    QJsonObject by; ///< which build and backend draws it (drawnBy)
    std::vector<FarmPainting> paintings;
    QByteArray identity; ///< the hash of the plan, which stands in journals

    qint64 pieces() const { return paintings.empty() ? 0 : paintings.back().first + paintings.back().pieces; }
    bool isFrames() const { return !paintings.empty() && paintings.front().isFrames; }
    /// The painting of a piece.
    const FarmPainting &paintingOf(qint64 piece) const;
    /// The name of the files of a worker that draws the pieces [from, to), without ending. No two workers have the same
    /// one.
    static QString workerName(qint64 from, qint64 to);
    QString journals() const { return folder + QStringLiteral("/journals"); }
    QString packs() const { return folder + QStringLiteral("/packs"); }
};

/// Writes the plan, which is there whole or not at all. The folder must be new, or have the same plan.
Result<FarmPlan> writePlan(const FarmPlan &plan);
Result<FarmPlan> readPlan(const QString &folder);

/// What workers say that they finished, with the file in which tiles of a pack lie.
using FarmRecords = std::multimap<qint64, std::pair<SheetRecord, QString>>;
/// A journal of a worker of which lines are lost.
struct DamagedJournal {
    QString path;
    int lines = 0;
    qint64 from = 0, to = 0; ///< the pieces of its task
};
/// Those of the pieces [from, to). Only journals of workers that drew some of them are read.
Result<FarmRecords> readRecords(const FarmPlan &plan, qint64 from, qint64 to,
                                std::vector<DamagedJournal> *damaged = nullptr);

/// Reads what a piece became, and compares the hashes.
bool isPieceWhole(const FarmPlan &plan, const FarmRecords &records, qint64 piece);
/// Files of a piece that workers finished and that are not whole any more: tiles, a frame, or the pack in which tiles lie.
/// None of a piece that nobody finished.
std::vector<LostFile> lostFilesOf(const FarmPlan &plan, const FarmRecords &records, qint64 piece);

/// Numbers as people write them: "3, 5-10".
QString rangesOf(const std::vector<qint64> &ascending);

} // namespace suffuse::cli

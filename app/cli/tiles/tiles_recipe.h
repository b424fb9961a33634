// A picture in tiles as the command line and the plan of a farm say it.
#pragma once

#include "app/cli/options.h"
#include "render/tiles/tile_store.h"

namespace suffuse::cli {

/// All that the picture of a painting depends on, but for the painting and what draws it.
struct TilesRecipe {
    QString out; ///< as it was given: picture.dzi, picture.tif or a folder
    Rect area;
    int width = 0, height = 0;
    Microseconds time = 0;
    bool drafts = false;
    TileOptions tiles;
    TileEncoding encoding;

    bool isTiff() const { return encoding.format == TileFormat::Tiff; }
    /// The file that is written last: the picture, or the description of its tiles.
    QString path() const;
    View view() const { return View::ofArea(area, width, height); }
    /// Without the path, which may change.
    QJsonObject json() const;
    static Result<TilesRecipe> ofJson(const QJsonObject &json, const QString &out);
};

/// What is wrong with OUT of --tiles: without a name it would be the root of the file system, or hidden files.
QString problemOfTilesName(const QString &out);
/// --tiles, --tile, --overlap, --format, --quality, --depth, --transparent, --drafts, --size, --scale, --area and
/// --time. Errors are usage errors.
Result<TilesRecipe> tilesRecipe(const CommandLine &line, const Painting &painting);

/// The sides of sheets where none was asked for. A GPU draws larger ones, since it prepares the strokes for each of
/// them.
int usualSheet(Backend backend);

/// What the bits of a picture depend on beside the painting and the recipe: this build, the backend with its
/// instructions or its chip, and the libraries that encode, by what they make of a small tile.
QJsonObject drawnBy(const Renderer &renderer, const TileEncoding *encoding);

/// One line of all of that.
QByteArray identityOf(const QByteArray &paintingHash, const QJsonObject &recipe, const QJsonObject &drawnBy);

/// The request for the whole picture of a recipe.
RenderRequest requestOf(const PaintingPtr &painting, const TilesRecipe &recipe);

} // namespace suffuse::cli

#include "app/cli/farm/farm_commands.h"
#include "app/cli/tiles/tiles_command.h"
#include "render/backends.h"
#include "render/film/film_writer.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse::cli {

namespace {

constexpr qint64 mostPieces = 100'000'000;

void addPlanOptions(CommandLine &line)
{
    line.allowSeveral();
    line.add({"o", "output"}, QCoreApplication::translate("Cli", "The folder of the farm, which all machines share."),
             "FOLDER");
    line.add({"frames"},
             QCoreApplication::translate("Cli",
                                         "Frames of the paintings being painted: name%05d.png; of several, %s is the "
                                         "painting's name."),
             "OUT");
    addTilesOptions(line);
    line.add({"format"}, QCoreApplication::translate("Cli", "Tiles of a Deep Zoom: jpg or png."), "FORMAT");
    addViewOptions(line);
    line.add({"time"}, QCoreApplication::translate("Cli", "The moment that is drawn, in seconds (default: the end)."),
             "T");
    line.add({"transparent"}, QCoreApplication::translate("Cli", "No background: alpha holds the coverage."));
    line.add({"drafts"}, QCoreApplication::translate("Cli", "Draws groups that are drafts, too."));
    line.add({"depth"}, QCoreApplication::translate("Cli", "8 or 16 bits (default 8)."), "DEPTH");
    line.add({"quality"}, QCoreApplication::translate("Cli", "Of JPEG and WebP, 1 to 100."), "N");
    line.add({"fps"}, QCoreApplication::translate("Cli", "Frames a second (default 25)."), "F");
    line.add({"duration"}, QCoreApplication::translate("Cli", "Length in seconds (default 10)."), "S");
    line.add({"idle"},
             QCoreApplication::translate("Cli", "Seconds that are kept of a pause in the painting (default 0.5)."),
             "S");
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
}

Result<double> numberOf(const CommandLine &line, const QString &option, double usual, double least)
{
    if (!line.isSet(option))
        return usual;
    const std::optional<double> value = toNumber(line.value(option));
    if (value && *value >= least && *value <= 1e6)
        return *value;
    return Error{QCoreApplication::translate("Cli", "--%1 %2: give a number from %3 to 1000000")
                     .arg(option, line.value(option))
                     .arg(least)};
}

Result<FramesRecipe> framesRecipe(const CommandLine &line, const Painting &painting)
{
    const Result<double> fps = numberOf(line, "fps", 25, 0.001), duration = numberOf(line, "duration", 10, 0.001),
                         idle = numberOf(line, "idle", 0.5, 0), quality = numberOf(line, "quality", 92, 1);
    for (const Result<double> *value : {&fps, &duration, &idle, &quality})
        if (!*value)
            return Error{value->error()};
    const Result<PictureOptions> picture = pictureOptions(line, painting);
    if (!picture)
        return Error{picture.error()};
    FramesRecipe recipe;
    recipe.out = line.value("frames");
    recipe.area = picture->area;
    recipe.width = picture->width;
    recipe.height = picture->height;
    recipe.frames = int(std::clamp(std::round(*fps * *duration), 1.0, 1e6));
    recipe.idle = *idle;
    recipe.transparent = line.isSet("transparent");
    recipe.drafts = line.isSet("drafts");
    recipe.bits = line.value("depth") == QLatin1String("16") ? 16 : 8;
    recipe.quality = int(std::min(*quality, 100.0));
    return recipe;
}

/// What is wrong with the name of frames, once it is a painting's.
QString problemOfFrames(const FramesRecipe &recipe)
{
    FilmOptions film;
    film.path = recipe.out;
    film.frames = std::size_t(recipe.frames);
    film.width = recipe.width;
    film.height = recipe.height;
    film.image = recipe.image();
    if (filmKindOf(recipe.out) != FilmKind::Frames)
        return QCoreApplication::translate("Cli", "a farm draws numbered frames, name%05d.png");
    return problemOf(film);
}

/// A painting with its place; the error is one of usage.
Result<FarmPainting> paintingFor(const CommandLine &line, const QString &path, Backend backend)
{
    Result<Painting> painting = paintingOf(path);
    if (!painting)
        return Error{painting.error()};
    FarmPainting p;
    p.path = QFileInfo(path).absoluteFilePath();
    p.isFrames = line.isSet("frames");
    const auto place = [&](QString out) {
        return QFileInfo(out.replace(QLatin1String("%s"), QFileInfo(path).completeBaseName())).absoluteFilePath();
    };
    if (p.isFrames) {
        const Result<FramesRecipe> recipe = framesRecipe(line, *painting);
        if (!recipe)
            return Error{recipe.error()};
        p.frames = *recipe;
        p.frames.out = place(p.frames.out);
        if (const QString problem = problemOfFrames(p.frames); !problem.isEmpty())
            return Error{QStringLiteral("--frames %1: %2").arg(line.value("frames"), problem)};
        p.pieces = p.frames.frames;
    } else {
        const Result<TilesRecipe> recipe = tilesRecipe(line, *painting);
        if (!recipe)
            return Error{recipe.error()};
        p.tiles = *recipe;
        if (p.tiles.tiles.sheet == 0)
            p.tiles.tiles.sheet = usualSheet(backend);
        p.tiles.out = place(p.tiles.out);
        p.pieces = TilePlan(p.tiles.view(), p.tiles.tiles).sheets();
    }
    const auto shared = std::make_shared<const Painting>(std::move(*painting));
    p.hash = hashOf(*(p.tiles.drafts || p.frames.drafts ? shared : withoutDrafts(shared)));
    return p;
}

} // namespace

int farmPlanCommand(const QStringList &arguments)
{
    CommandLine line("farm plan",
                     QCoreApplication::translate("Cli", "Plans the drawing of paintings by many machines."), {"IN"});
    addPlanOptions(line);
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const auto usage = [](const QString &message) { return failUsage("farm plan", message); };
    if (line.value("output").isEmpty())
        return usage(
            QCoreApplication::translate("Cli", "-o FOLDER is missing: name the folder that all machines share"));
    if (line.isSet("tiles") == line.isSet("frames"))
        return usage(QCoreApplication::translate("Cli", "give --tiles or --frames"));
    if (line.isSet("tiles"))
        if (const QString problem = problemOfTilesName(line.value("tiles")); !problem.isEmpty())
            return usage(problem);
    if (line.several().contains(QLatin1String("-")))
        return usage(QCoreApplication::translate("Cli", "other machines cannot read this standard input: give files"));
    const QString out = line.value(line.isSet("tiles") ? "tiles" : "frames");
    if (line.several().size() > 1 && !out.contains(QLatin1String("%s")))
        return usage(QCoreApplication::translate("Cli",
                                                 "several paintings need several names: put %s where the painting's "
                                                 "name is to stand, as in out/%s.dzi"));
    const Result<RendererOptions> options = rendererOptions(line);
    if (!options)
        return usage(options.error());
    const auto renderer = makeRenderer(*options);
    if (!renderer)
        return fail(renderer.error());
    FarmPlan plan;
    plan.folder = QDir(line.value("output")).absolutePath();
    std::set<QString> names;
    for (const QString &path : line.several()) {
        Result<FarmPainting> p = paintingFor(line, path, (*renderer)->backend());
        if (!p)
            return fail(QStringLiteral("%1: %2").arg(path, p.error()));
        if (!names.insert(p->out()).second)
            return fail(QCoreApplication::translate("Cli", "%1: two paintings would become the same file. Rename one.")
                            .arg(p->out()));
        p->first = plan.pieces();
        plan.paintings.push_back(std::move(*p));
        if (plan.pieces() > mostPieces)
            return fail(QCoreApplication::translate(
                            "Cli", "these are more than %1 pieces. Choose a greater --sheet, a smaller picture, "
                                   "or several plans.")
                            .arg(mostPieces));
    }
    plan.by = drawnBy(**renderer, plan.isFrames() ? nullptr : &plan.paintings.front().tiles.encoding);
    const Result<FarmPlan> written = writePlan(plan);
    if (!written)
        return fail(written.error());
    return print(
        QCoreApplication::translate("Cli", "%1: %2 pieces of %n painting(s)", nullptr, int(written->paintings.size()))
            .arg(written->folder)
            .arg(written->pieces()) +
        '\n');
}

} // namespace suffuse::cli

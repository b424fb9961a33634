#include "app/cli/documents/diff_picture.h"

#include "render/backends.h"
#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <array>
#include <unordered_set>

namespace suffuse::cli {

namespace {

using Pixel = std::array<float, 3>;             // sRGB
constexpr Pixel addedColour{0.0f, 0.55f, 0.3f}; // bluish green, vermilion and blue are told apart by everybody
constexpr Pixel removedColour{0.84f, 0.3f, 0.0f};
constexpr Pixel changedColour{0.0f, 0.4f, 0.75f};

/// The painting with only these strokes, each as it is there; no paper, no background.
PaintingPtr only(const PaintingPtr &painting, const std::vector<StrokeId> &ids)
{
    const std::unordered_set<StrokeId> wanted(ids.begin(), ids.end());
    auto out = std::make_shared<Painting>(*painting);
    out->canvas.paper = {};
    out->strokes.clear();
    for (const StrokePtr &stroke : painting->strokes)
        if (wanted.count(stroke->id))
            out->strokes.push_back(stroke);
    return out;
}

void lay(const Pixel &colour, float opacity, float *pixel)
{
    for (std::size_t c = 0; c < 3; ++c)
        pixel[c] += (colour[c] - pixel[c]) * opacity;
}

/// What is left of B: grey, its darkest parts still light.
void makePale(FloatPicture &picture)
{
    for (std::size_t k = 0; k < picture.rgba.size(); k += 4) {
        float *p = picture.rgba.data() + k;
        const float grey = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
        p[0] = p[1] = p[2] = 0.62f + 0.36f * grey;
        p[3] = 1;
    }
}

} // namespace

void addDiffPictureOptions(CommandLine &line)
{
    line.add({"o", "output"},
             QCoreApplication::translate("Cli", "A picture that shows where: B pale, added strokes green, removed ones "
                                                "orange, changed and moved ones blue."),
             "OUT");
    addViewOptions(line);
    line.add({"backend"}, QCoreApplication::translate("Cli", "auto, cpu, cuda or reference."), "BACKEND");
}

Result<void> checkDiffPictureOptions(const CommandLine &line)
{
    const QString out = line.value("output");
    if (out.isEmpty()) {
        for (const char *option : {"size", "scale", "area", "backend"})
            if (line.isSet(option))
                return Error{
                    QCoreApplication::translate("Cli", "--%1 is for the picture; give -o OUT too").arg(option)};
        return {};
    }
    if (const QString problem = problemOf(imageFormatForPath(out), {}, 1, 1); !problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(out, problem)};
    if (const Result<RendererOptions> options = rendererOptions(line); !options)
        return Error{options.error()};
    return {};
}

Result<void> writeDiffPicture(const CommandLine &line, const PaintingPtr &a, const PaintingPtr &b,
                              const PaintingDifference &difference)
{
    const Result<PictureOptions> size = pictureOptions(line, *b);
    if (!size)
        return Error{size.error()};
    const QString out = line.value("output");
    if (const QString problem = problemOf(imageFormatForPath(out), {}, size->width, size->height); !problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(out, problem)};
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer(*rendererOptions(line));
    if (!renderer)
        return Error{renderer.error()};
    const auto draw = [&](const PaintingPtr &painting, bool transparent, FloatPicture &picture) -> Result<void> {
        RenderRequest request;
        request.painting = painting;
        request.time = painting->end();
        request.view = View::ofArea(size->area, size->width, size->height);
        request.transparent = transparent;
        const Result<RenderStats> stats = renderPicture(**renderer, request, picture);
        return stats ? Result<void>() : Result<void>(Error{stats.error()});
    };
    FloatPicture picture;
    if (const Result<void> drawn = draw(b, false, picture); !drawn)
        return drawn;
    makePale(picture);
    std::vector<StrokeId> changed = difference.changed;
    changed.insert(changed.end(), difference.moved.begin(), difference.moved.end());
    const struct {
        PaintingPtr painting;
        Pixel colour;
    } layers[] = {{only(a, difference.removed), removedColour},
                  {only(a, changed), changedColour},
                  {only(b, changed), changedColour},
                  {only(b, difference.added), addedColour}};
    for (const auto &layer : layers) {
        if (layer.painting->strokes.empty())
            continue;
        FloatPicture mask;
        if (const Result<void> drawn = draw(layer.painting, true, mask); !drawn)
            return drawn;
        for (std::size_t k = 0; k < picture.rgba.size(); k += 4)
            lay(layer.colour, 0.85f * mask.rgba[k + 3], picture.rgba.data() + k);
    }
    ImageOptions image;
    image.cancel = &interrupted();
    return writeImage(out, picture, image);
}

} // namespace suffuse::cli

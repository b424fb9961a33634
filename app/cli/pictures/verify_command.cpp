#include "app/cli/options.h"
#include "render/backends.h"
#include "render/compare.h"

#include <QCoreApplication>

#include <cmath>

namespace suffuse::cli {

namespace {

struct Drawn {
    QString name; ///< backend and device
    FloatPicture picture;
};

Result<Drawn> draw(Backend backend, const RenderRequest &request)
{
    RendererOptions options;
    options.backend = backend;
    Result<std::unique_ptr<Renderer>> renderer = makeRenderer(options);
    if (!renderer)
        return Error{renderer.error()};
    Drawn out;
    out.name = QStringLiteral("%1 (%2)").arg(nameOf((*renderer)->backend()), (*renderer)->deviceName());
    const Result<RenderStats> stats = renderPicture(**renderer, request, out.picture);
    if (!stats)
        return Error{QStringLiteral("%1: %2").arg(nameOf((*renderer)->backend()), stats.error())};
    if (const QString notice = (*renderer)->notice(); !notice.isEmpty()) // this is another backend's picture
        return Error{notice};
    return out;
}

/// The backends other than the reference that can run here.
std::vector<Backend> available()
{
    std::vector<Backend> out;
    for (Backend backend : {Backend::Cpu, Backend::Cuda}) {
        RendererOptions options;
        options.backend = backend;
        if (makeRenderer(options))
            out.push_back(backend);
    }
    return out;
}

QString rgbText(const std::array<float, 4> &c)
{
    return QStringLiteral("%1 %2 %3").arg(c[0], 0, 'f', 5).arg(c[1], 0, 'f', 5).arg(c[2], 0, 'f', 5);
}

/// Prints how far a backend is from the reference; true if within the contract.
bool reportAgainstReference(const Drawn &backend, const Drawn &reference, const PictureDifference &d, QString &text)
{
    text += QCoreApplication::translate("Cli", "%1 and %2: largest difference R %3, G %4, B %5")
                .arg(backend.name, reference.name)
                .arg(d.maximum[0], 0, 'f', 6)
                .arg(d.maximum[1], 0, 'f', 6)
                .arg(d.maximum[2], 0, 'f', 6);
    text += '\n' + QCoreApplication::translate("Cli", "  at pixel %1, %2: RGB %3 and %4")
                       .arg(d.x)
                       .arg(d.y)
                       .arg(rgbText(d.first), rgbText(d.second));
    text += '\n' + QCoreApplication::translate("Cli", "  %1 of %2 pixels over 1/512").arg(d.over).arg(d.pixels);
    if (d.notFinite > 0)
        text += '\n' + QCoreApplication::translate("Cli", "  %1 pixels that are no numbers").arg(d.notFinite);
    text += '\n';
    return d.isWithinTolerance();
}

int level(float v)
{
    return int(std::lround(255 * std::clamp(v, 0.0f, 1.0f)));
}

/// Prints how far two backends are apart in 8 bits; true if within the contract.
bool reportBackends(const Drawn &a, const Drawn &b, QString &text)
{
    int largest = 0, x = 0, y = 0;
    for (int j = 0; j < a.picture.height; ++j)
        for (int i = 0; i < a.picture.width; ++i)
            for (int c = 0; c < 3; ++c)
                if (const int d = std::abs(level(a.picture.at(i, j)[c]) - level(b.picture.at(i, j)[c])); d > largest)
                    largest = d, x = i, y = j;
    text += QCoreApplication::translate("Cli", "%1 and %2: largest difference in 8 bits %3, at pixel %4, %5")
                .arg(a.name, b.name)
                .arg(largest)
                .arg(x)
                .arg(y) +
            '\n';
    return largest <= 1;
}

int verify(const QString &file, const RenderRequest &request)
{
    const Result<Drawn> reference = draw(Backend::Reference, request);
    if (!reference)
        return fail(QStringLiteral("%1: %2").arg(file, reference.error()));
    std::vector<Drawn> drawn;
    QString text = QCoreApplication::translate("Cli", "%1, %2 × %3 pixels, at %4 s")
                       .arg(file)
                       .arg(request.view.width)
                       .arg(request.view.height)
                       .arg(toSeconds(request.time)) +
                   '\n';
    bool good = true;
    for (Backend backend : available()) {
        Result<Drawn> picture = draw(backend, request);
        if (!picture)
            return fail(QStringLiteral("%1: %2").arg(file, picture.error()));
        const Result<PictureDifference> difference = compare(picture->picture, reference->picture);
        if (!difference)
            return fail(QStringLiteral("%1: %2").arg(file, difference.error()));
        good = reportAgainstReference(*picture, *reference, *difference, text) && good;
        for (const Drawn &other : drawn)
            good = reportBackends(other, *picture, text) && good;
        drawn.push_back(std::move(*picture));
    }
    text += good ? QCoreApplication::translate("Cli", "within the contract")
                 : QCoreApplication::translate(
                       "Cli", "OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends");
    const int printed = print(text + '\n');
    return good ? printed : Failed;
}

} // namespace

int verifyCommand(const QStringList &arguments)
{
    CommandLine line("verify",
                     QCoreApplication::translate("Cli",
                                                 "Draws a painting on every backend there is and on the reference, and "
                                                 "compares the pictures."),
                     {"IN"});
    line.add({"size"}, QCoreApplication::translate("Cli", "Pixels: WxH, or W alone; scales uniformly."), "WxH");
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<PictureOptions> picture = pictureOptions(line, *painting);
    if (!picture)
        return failUsage("verify", picture.error());
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(std::move(*painting));
    request.time = picture->time;
    request.view = View::ofArea(picture->area, picture->width, picture->height);
    return verify(line.argument(0), request);
}

} // namespace suffuse::cli

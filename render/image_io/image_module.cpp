#include "render/image_io/image_module.h"

#include "model/module_path.h"
#include "render/image_io/file_replacement.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLibrary>

namespace suffuse {

namespace {

Result<ImageModule> load(const QString &name)
{
    const QString path = modulePath(name);
    const auto problem = [&](const QString &what) {
        return Error{QCoreApplication::translate("ImageModule",
                                                 "a part of Suffuse, %1, %2; install Suffuse again, with what "
                                                 "suffuse-cli recommends. Pictures "
                                                 "ending in .pfm work without it")
                         .arg(path, what)};
    };
    if (!QFileInfo::exists(path))
        return problem(QCoreApplication::translate("ImageModule", "is missing"));
    QLibrary library(path);
    if (!library.load())
        return problem(QCoreApplication::translate("ImageModule", "cannot be loaded (%1)").arg(library.errorString()));
    const auto version = reinterpret_cast<ImageModuleVersionFunction>(library.resolve("suffuse_image_module_version"));
    ImageModule module;
    module.write = reinterpret_cast<ImageModuleWriteFunction>(library.resolve("suffuse_image_write"));
    module.read = reinterpret_cast<ImageModuleReadFunction>(library.resolve("suffuse_image_read"));
    module.tile = reinterpret_cast<ImageModuleTileFunction>(library.resolve("suffuse_image_tile"));
    module.filmAdd = reinterpret_cast<ImageModuleFilmAddFunction>(library.resolve("suffuse_image_film_add"));
    module.filmEnd = reinterpret_cast<ImageModuleFilmEndFunction>(library.resolve("suffuse_image_film_end"));
    module.profile = reinterpret_cast<ImageModuleProfileFunction>(library.resolve("suffuse_image_profile"));
    module.coloursName = reinterpret_cast<ImageModuleColoursNameFunction>(library.resolve("suffuse_colours_name"));
    module.coloursOpen = reinterpret_cast<ImageModuleColoursOpenFunction>(library.resolve("suffuse_colours_open"));
    module.coloursApply = reinterpret_cast<ImageModuleColoursApplyFunction>(library.resolve("suffuse_colours_apply"));
    module.coloursClose = reinterpret_cast<ImageModuleColoursCloseFunction>(library.resolve("suffuse_colours_close"));
    if (!version || version() != imageModuleVersion || !module.write || !module.read)
        return problem(QCoreApplication::translate("ImageModule", "is of another version of Suffuse"));
    return module;
}

/// The module for PNG, TIFF, JPEG and WebP.
const Result<ImageModule> &smallModule()
{
    static const Result<ImageModule> module = load(QStringLiteral("suffuse_image_io"));
    return module;
}

const Result<ImageModule> &largeModule()
{
    static const Result<ImageModule> module = load(QStringLiteral("suffuse_openimageio"));
    return module;
}

constexpr qint64 mostPngBytes = qint64(1) << 28; ///< The small module makes the stream of a PNG as a whole.

} // namespace

const Result<ImageModule> &readingModule(ImageFormat format)
{
    return format == ImageFormat::WebP ? smallModule() : largeModule();
}

const Result<ImageModule> &writingModule(ImageFormat format, qint64 bytes)
{
    const bool isLarge = format == ImageFormat::Exr || (format == ImageFormat::Png && bytes > mostPngBytes);
    return isLarge ? largeModule() : smallModule();
}

const Result<ImageModule> &colourModule()
{
    return smallModule();
}

ImageModuleFile moduleFile(FileReplacement &file)
{
    ImageModuleFile out{};
    out.context = &file;
    out.read = [](void *c, void *to, std::size_t n, std::int64_t at) {
        return static_cast<FileReplacement *>(c)->read(to, n, at);
    };
    out.write = [](void *c, const void *from, std::size_t n, std::int64_t at) {
        return static_cast<FileReplacement *>(c)->write(from, n, at);
    };
    out.size = [](void *c) { return static_cast<FileReplacement *>(c)->size(); };
    return out;
}

const char *imageModuleName(ImageFormat format)
{
    switch (format) {
    case ImageFormat::Tiff:
        return "tiff";
    case ImageFormat::Exr:
        return "openexr";
    case ImageFormat::Jpeg:
        return "jpeg";
    case ImageFormat::WebP:
        return "webp";
    default:
        return "png";
    }
}

} // namespace suffuse

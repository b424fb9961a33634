#include "render/image_io/image_module.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLibrary>

namespace suffuse {

namespace {

QString modulePath()
{
    const QString folder = qEnvironmentVariable("SUFFUSE_MODULE_DIR");
    const QDir dir(folder.isEmpty() ? QCoreApplication::applicationDirPath() + QStringLiteral("/../lib/suffuse")
                                    : folder);
    return QDir::cleanPath(dir.absoluteFilePath(QStringLiteral("suffuse_image_io.so")));
}

Result<ImageModule> load()
{
    const QString path = modulePath();
    const auto problem = [&path](const QString &what) {
        return Error{QCoreApplication::translate("ImageModule",
                                                 "the image module %1 %2; install or build Suffuse again (target "
                                                 "suffuse_image_io). Pictures ending in .pfm work without it")
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
    if (!version || version() != imageModuleVersion || !module.write || !module.read)
        return problem(QCoreApplication::translate("ImageModule", "is of another version of Suffuse"));
    return module;
}

} // namespace

const Result<ImageModule> &imageModule()
{
    static const Result<ImageModule> module = load();
    return module;
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

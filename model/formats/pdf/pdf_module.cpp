#include "model/formats/pdf/pdf_module.h"

#include "model/formats/messages.h"
#include "model/module_path.h"

#include <QFileInfo>
#include <QLibrary>

namespace suffuse {

namespace {

Result<PdfModule> loadPdfModule()
{
    const QString path = modulePath(QStringLiteral("suffuse_pdf"));
    const auto problem = [&](const QString &what) {
        return Error{FileMessages::tr("a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone")
                         .arg(path, what)};
    };
    if (!QFileInfo::exists(path))
        return problem(FileMessages::tr("is missing"));
    QLibrary library(path);
    if (!library.load())
        return problem(FileMessages::tr("cannot be loaded (%1)").arg(library.errorString()));
    const auto version = reinterpret_cast<PdfModuleVersionFunction>(library.resolve("suffuse_pdf_module_version"));
    PdfModule module;
    module.write = reinterpret_cast<PdfModuleWriteFunction>(library.resolve("suffuse_pdf_write"));
    module.read = reinterpret_cast<PdfModuleReadFunction>(library.resolve("suffuse_pdf_read"));
    if (!version || version() != pdfModuleVersion || !module.write || !module.read)
        return problem(FileMessages::tr("is of another version of Suffuse"));
    return module;
}

} // namespace

const Result<PdfModule> &pdfModule()
{
    static const Result<PdfModule> module = loadPdfModule();
    return module;
}

} // namespace suffuse

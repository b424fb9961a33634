#include "app/python/fonts.h"

#include "model/module_path.h"
#include "undo/lettering/module_api.h"
#include "undo/lettering/text_setter.h"

#include <QCoreApplication>
#include <QLibrary>

#include <clocale>

namespace suffuse::python {

namespace {

/// Makes an application object that knows fonts, where there is none at all. Python's numbers are not written as the
/// person's language has it, which Qt sets otherwise.
bool hasApplication(LetteringApplicationFunction make)
{
    if (const QCoreApplication *application = QCoreApplication::instance())
        return application->inherits("QGuiApplication");
    static char name[] = "suffuse";
    static char *arguments[] = {name, nullptr};
    static int count = 1;
    const std::string locale = std::setlocale(LC_ALL, nullptr);
    make(count, arguments); // It stays until the process ends.
    std::setlocale(LC_ALL, locale.c_str());
    return true;
}

/// What makes shapers, or null.
LetteringShaperFunction shaperFunction()
{
    QLibrary library(modulePath(QStringLiteral("suffuse_lettering")));
    const auto version = reinterpret_cast<LetteringVersionFunction>(library.resolve("suffuse_lettering_version"));
    const auto application =
        reinterpret_cast<LetteringApplicationFunction>(library.resolve("suffuse_lettering_application"));
    const auto shaper = reinterpret_cast<LetteringShaperFunction>(library.resolve("suffuse_lettering_shaper"));
    const bool isThere = version && version() == letteringModuleVersion && application && shaper;
    return isThere && hasApplication(application) ? shaper : nullptr;
}

} // namespace

std::optional<LaidText> layByFonts(const Text &text)
{
    static const LetteringShaperFunction make = shaperFunction();
    if (!make)
        return {};
    thread_local const std::unique_ptr<LetterShaper> shaper(make()); // Qt's fonts belong to a thread.
    return layText(text, *shaper);
}

} // namespace suffuse::python

#include "app/cli/application.h"

#include "app/cli/options.h"
#include "model/module_path.h"
#include "undo/lettering/module_api.h"

#include <QCoreApplication>
#include <QLibrary>

namespace suffuse::cli {

Application::Application(int &argc, char **argv)
    : m_argc(argc), m_argv(argv), m_application(std::make_unique<QCoreApplication>(argc, argv))
{
    prepare();
    setLetterShaper(this);
}

Application::~Application()
{
    setLetterShaper(nullptr);
    m_shaper.reset();
}

void Application::prepare()
{
    QCoreApplication::setApplicationName(QStringLiteral("suffuse-cli"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SUFFUSE_VERSION));
    if (m_plurals.load(QStringLiteral(":/i18n/suffuse_en.qm")))
        QCoreApplication::installTranslator(&m_plurals);
}

/// Null where the module is missing: texts are left out then, which is said once.
LetterShaper *Application::shaper()
{
    if (std::exchange(m_isAsked, true))
        return m_shaper.get();
    QLibrary library(modulePath(QStringLiteral("suffuse_lettering")));
    const auto version = reinterpret_cast<LetteringVersionFunction>(library.resolve("suffuse_lettering_version"));
    const auto application =
        reinterpret_cast<LetteringApplicationFunction>(library.resolve("suffuse_lettering_application"));
    const auto letters = reinterpret_cast<LetteringShaperFunction>(library.resolve("suffuse_lettering_shaper"));
    if (!version || version() != letteringModuleVersion || !application || !letters) {
        warn(QCoreApplication::translate("Cli", "a part of Suffuse, %1, is missing or of another version, so texts are "
                                                "left out; install Suffuse again, with what suffuse-cli "
                                                "recommends")
                 .arg(library.fileName()));
        return nullptr;
    }
    m_application.reset(); // There can be one only.
    m_application.reset(application(m_argc, m_argv));
    prepare();
    m_shaper.reset(letters());
    return m_shaper.get();
}

std::shared_ptr<const ShapedLine> Application::shape(const QString &line, const Face &face)
{
    LetterShaper *letters = shaper();
    return letters ? letters->shape(line, face) : nullptr;
}

bool Application::hasFamily(const QString &family)
{
    LetterShaper *letters = shaper();
    return letters && letters->hasFamily(family);
}

QString Application::familyFor(const QString &family)
{
    LetterShaper *letters = shaper();
    return letters ? letters->familyFor(family) : family;
}

} // namespace suffuse::cli

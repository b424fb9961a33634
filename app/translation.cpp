#include "app/translation.h"

#include "app/settings.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace suffuse {

namespace {

/// Of the system's languages in order of preference, the first that we speak.
QString systemLanguage()
{
    for (const QString &name : QLocale::system().uiLanguages()) {
        const QLocale locale(name);
        if (locale.language() == QLocale::Chinese && locale.script() != QLocale::TraditionalHanScript)
            return "zh_CN";
        if (locale.language() == QLocale::German)
            return "de";
        if (locale.language() == QLocale::English)
            return "en";
    }
    return "en";
}

} // namespace

QStringList translationCodes()
{
    return {"en", "zh_CN", "de"};
}

void installTranslators()
{
    static QTranslator qtTexts;
    static QTranslator ownTexts;
    QCoreApplication::removeTranslator(&qtTexts);
    QCoreApplication::removeTranslator(&ownTexts);

    const QString chosen = settings::language();
    const QString code = chosen.isEmpty() ? systemLanguage() : chosen;
    // Numbers as the texts: the system's own ways where they are of the same language.
    const QLocale language(code), system = QLocale::system();
    QLocale::setDefault(system.language() == language.language() ? system : language);
    // English too: it holds the plural forms.
    if (ownTexts.load(":/i18n/suffuse_" + code + ".qm"))
        QCoreApplication::installTranslator(&ownTexts);
    if (code != "en" && qtTexts.load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qtTexts);
}

} // namespace suffuse

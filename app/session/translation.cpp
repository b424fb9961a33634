#include "app/session/translation.h"

#include "app/session/settings/languages.h"
#include "app/session/settings/settings.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace suffuse {

namespace {

/// The first of the system's languages, in order of preference, for which there is a translation.
QString systemLanguage()
{
    for (const QString &name : QLocale::system().uiLanguages()) {
        const QLocale locale(name);
        if (locale.language() == QLocale::Chinese && locale.script() == QLocale::TraditionalHanScript)
            continue; // The translation is into simplified Chinese.
        for (const Language &each : languages())
            if (each.language == locale.language())
                return each.code;
    }
    return "en";
}

/// Translates the texts of Qt's own buttons, each with a mnemonic: Qt has them without mnemonics, or with others on
/// each desktop.
constexpr const char *buttonTexts[] = {
    QT_TRANSLATE_NOOP("Buttons", "&OK"),
    QT_TRANSLATE_NOOP("Buttons", "&Cancel"),
    QT_TRANSLATE_NOOP("Buttons", "&Save"),
    QT_TRANSLATE_NOOP("Buttons", "&Discard"),
    QT_TRANSLATE_NOOP("Buttons", "&Close"),
    QT_TRANSLATE_NOOP("Buttons", "&Open"),
    QT_TRANSLATE_NOOP("Buttons", "&Yes"),
    QT_TRANSLATE_NOOP("Buttons", "&No"),
    QT_TRANSLATE_NOOP("Buttons", "&Apply"),
    QT_TRANSLATE_NOOP("Buttons", "&Reset"),
    QT_TRANSLATE_NOOP("Buttons", "&Help"),
    QT_TRANSLATE_NOOP("Buttons", "&Retry"),
    QT_TRANSLATE_NOOP("Buttons", "Restore &Defaults"),
    QT_TRANSLATE_NOOP("Buttons", "&Show Details..."),
    QT_TRANSLATE_NOOP("Buttons", "&Hide Details..."),
};

QString &inUse()
{
    static QString code = QStringLiteral("en");
    return code;
}

class ButtonTexts : public QTranslator {
public:
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        const QByteArrayView place(context);
        //: the key, as it is called on keyboards
        if (place == "QShortcut" && QByteArrayView(source) == "Return")
            return QCoreApplication::translate("Keys", "Return");
        if (place != "QPlatformTheme" && place != "QGnomeTheme" && place != "QMessageBox")
            return {};
        const auto plain = [](QByteArray text) { return text.replace('&', ""); };
        const QByteArray wanted = place == "QGnomeTheme" && QByteArrayView(source) == "Close without Saving"
                                      ? QByteArray("Discard")
                                      : plain(source);
        for (const char *text : buttonTexts)
            if (plain(text) == wanted)
                return QCoreApplication::translate("Buttons", text);
        return {};
    }
    bool isEmpty() const override { return false; }
};

} // namespace

QStringList translationCodes()
{
    QStringList codes;
    for (const Language &each : languages())
        codes << each.code;
    return codes;
}

QString languageInUse()
{
    return inUse();
}

void installTranslators()
{
    static QTranslator qtTexts;
    static QTranslator ownTexts;
    static ButtonTexts ofButtons;
    QCoreApplication::removeTranslator(&qtTexts);
    QCoreApplication::removeTranslator(&ownTexts);
    QCoreApplication::removeTranslator(&ofButtons);

    const QString chosen = settings::language();
    const QString code = chosen.isEmpty() ? systemLanguage() : chosen;
    inUse() = code;
    // Numbers follow the language of the texts. Where the system's locale is of the same language, its own ways count.
    const QLocale language(code), system = QLocale::system();
    QLocale::setDefault(system.language() == language.language() ? system : language);
    // English is loaded, too: its file holds the plural forms.
    if (ownTexts.load(":/i18n/suffuse_" + code + ".qm"))
        QCoreApplication::installTranslator(&ownTexts);
    if (code != "en" && qtTexts.load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&qtTexts);
    QCoreApplication::installTranslator(&ofButtons); // the translator that was installed last is asked first
}

} // namespace suffuse

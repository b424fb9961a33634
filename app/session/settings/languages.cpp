#include "app/session/settings/languages.h"

namespace suffuse {

const QList<Language> &languages()
{
    static const QList<Language> all{
        {QStringLiteral("en"), QStringLiteral("English"), QLocale::English},
        {QStringLiteral("zh_CN"), QStringLiteral("简体中文 (Chinese, simplified)"), QLocale::Chinese},
        {QStringLiteral("de"), QStringLiteral("Deutsch (German)"), QLocale::German},
        {QStringLiteral("fr"), QStringLiteral("Français (French)"), QLocale::French},
        {QStringLiteral("es"), QStringLiteral("Español (Spanish)"), QLocale::Spanish},
        {QStringLiteral("ja"), QStringLiteral("日本語 (Japanese)"), QLocale::Japanese},
    };
    return all;
}

} // namespace suffuse

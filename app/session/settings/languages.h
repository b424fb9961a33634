#pragma once

#include <QList>
#include <QLocale>
#include <QString>

namespace suffuse {

/// A language of the window.
struct Language {
    QString code;               ///< of its file of translations, as in "i18n/suffuse_de.ts"
    QString name;               ///< as those who speak it call it, with its English name for those who do not
    QLocale::Language language; ///< which of the system's languages it serves
};

/// All of them, English first. A new one is a row here, its file in i18n/CMakeLists.txt, and its name in those texts
/// that are files of their own: packaging's desktop entry, metainfo, MIME type and extensions.
const QList<Language> &languages();

} // namespace suffuse

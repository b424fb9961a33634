#pragma once

#include <QString>
#include <QStringList>

namespace suffuse {

/// Puts the translations of the language in the settings (or the system's) on the application, Qt's own texts included.
/// Call it before windows are made; calling it again replaces the language.
void installTranslators();

/// Codes of the languages there are translations for ("en", "zh_CN", "de").
QStringList translationCodes();

} // namespace suffuse

#pragma once

#include <QString>
#include <QStringList>

namespace suffuse {

/// Installs the translations of the language in the settings (or of the system's) in the application, those of Qt's own
/// texts included. Call it before windows are made; calling it again replaces the language.
void installTranslators();

/// Codes of the languages for which there are translations (`languages()`).
QStringList translationCodes();

/// The one of them that `installTranslators` installed last; English before that.
QString languageInUse();

} // namespace suffuse

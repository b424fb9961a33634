// Finds the extensions that there are, and what their programs need.
#pragma once

#include "app/extensions/extension.h"
#include "model/result.h"

#include <QProcessEnvironment>

#include <optional>

namespace suffuse {

/// A folder with a manifest.
struct FoundExtension {
    QString folder;
    bool isOwn = false;                 ///< of the user, and not one that came along
    std::optional<Extension> extension; ///< none where the manifest cannot be used
    QString problem;                    ///< why not
};

/// The user's folder of extensions, which may not be there yet.
QString ownExtensionsFolder();
/// The folder of those that came along; empty where there are none.
QString shippedExtensionsFolder();

/// Those of both folders, by their names in a language. One of the user takes the place of one that came along with
/// the same id; of two of one folder the second has a problem.
std::vector<FoundExtension> findExtensions(const QString &language = QStringLiteral("en"));
/// The same in folders of one's own, of which the last one is the user's.
std::vector<FoundExtension> findExtensions(const QStringList &folders, const QString &language);

/// The interpreter that {python3} stands for: Debian's, for which `import suffuse` is made, else the first in the path.
/// Empty where there is none.
QString python3();
/// Lets Python find the modules that it finds for the person who runs Suffuse, whatever home the environment names, and
/// `import suffuse`, where that is not installed as Debian's modules are.
void addPythonPlaces(QProcessEnvironment &environment);
/// Empty if the program of an extension can be started: it is there, and so is each Python module that it imports.
/// Otherwise it is a sentence that says what to install.
QString problemOfNeeds(const Extension &extension);
/// The program and its arguments, with what placeholders stand for.
QStringList commandOf(const Extension &extension);

} // namespace suffuse

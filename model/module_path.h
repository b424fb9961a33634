// Where the modules lie: parts of the program with libraries that are loaded only when they are needed.
#pragma once

#include <QString>

namespace suffuse {

/// The file of a module: in the folder SUFFUSE_MODULE_DIR if that is set; else in that of `setModuleFolder`; else in
/// ../lib/suffuse beside the program's folder, as in a build and in a folder that runs in place, or, where there is none,
/// where `cmake --install` puts the modules.
QString modulePath(const QString &name);
/// Names the folder, where the program that runs is not one of ours (Python). It is called once, before all else.
void setModuleFolder(const QString &folder);

} // namespace suffuse

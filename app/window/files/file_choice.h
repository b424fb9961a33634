// Among which files people look for one to open.
#pragma once

#include <QString>

namespace suffuse {

/// Of file dialogs: all that can be opened, and each kind of it.
QString openFilter();

} // namespace suffuse

#pragma once

#include <QByteArray>

class QScreen;

namespace suffuse {

/// The ICC profile that the desktop has given to a screen ("ICC Profiles in X", the root window's _ICC_PROFILE); empty
/// if it has none, or where there is no X: a Wayland compositor converts colours by itself.
QByteArray systemProfileOf(const QScreen *screen);

} // namespace suffuse

// Icons drawn from outlines of our own (app/icons/outlines), in the palette's text colour, sharp at every scale.
#pragma once

#include <QIcon>
#include <QStringList>

namespace suffuse {

/// The icon of a name in iconNames(); follows the palette, so it needs no renewal when the theme changes. A null icon
/// for other names.
QIcon icon(const QString &name);

/// All names there are.
QStringList iconNames();

/// The program's own icon.
QIcon applicationIcon();

} // namespace suffuse

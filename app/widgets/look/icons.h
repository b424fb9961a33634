// Icons, drawn from our own outlines (app/icons) in the palette's text colour, sharp at every scale.
#pragma once

#include <QIcon>
#include <QStringList>

namespace suffuse {

/// The icon of a name in iconNames(). It follows the palette, so it needs no renewal when the theme changes. Other
/// names give a null icon.
QIcon icon(const QString &name);

/// The names of all icons.
QStringList iconNames();

/// The program's own icon.
QIcon applicationIcon();

} // namespace suffuse

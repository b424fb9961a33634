// Small pictures of paintings in lists.
#pragma once

#include <QIcon>
#include <QImage>
#include <QPalette>
#include <QSize>

namespace suffuse {

/// The size of every picture in a list, logical pixels.
inline constexpr QSize pictureSize(128, 96);

/// An icon with a picture in the middle of a frame's place, or an empty frame for a null picture. All icons are of one
/// size, so that names stand below each other, and the selection tints none of them.
QIcon pictureIcon(const QImage &image, const QPalette &palette, qreal ratio);

} // namespace suffuse

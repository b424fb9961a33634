// Small pictures of paintings in lists.
#pragma once

#include <QIcon>
#include <QImage>
#include <QPalette>
#include <QSize>

namespace suffuse {

/// Of every picture in a list, logical pixels.
inline constexpr QSize pictureSize(128, 96);

/// A picture in the middle of a frame's place, or an empty frame for a null one. All are of one size, so that names
/// stand below each other, and none is tinted by the selection.
QIcon pictureIcon(const QImage &image, const QPalette &palette, qreal ratio);

} // namespace suffuse

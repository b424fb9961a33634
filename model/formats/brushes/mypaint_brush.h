#pragma once

#include "model/formats/brushes/brush_file.h"

namespace suffuse {

/// Whether the bytes look like a MyPaint brush (.myb, in its JSON form).
bool isMyPaintBrush(const QByteArray &bytes);

/// Converts a MyPaint brush (version 3) to one of ours, as near as the two models come: radius, hardness, opacity,
/// colour, the dab's ellipse, slow tracking, and their curves over pressure, speed, tilt, stroke and random
/// (docs/brushes.md).
Result<LoadedBrush> readMyPaintBrush(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse

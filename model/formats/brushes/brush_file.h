// Brushes as files, one brush in each (docs/brushes.md).
#pragma once

#include "model/brush/brush.h"
#include "model/result.h"

#include <QByteArray>
#include <QStringList>

namespace suffuse {

/// The ending of brush files, without the dot.
inline constexpr const char *brushFileEnding = "suffuse-brush";

Result<Brush> readBrush(const QByteArray &bytes, const QString &fileName);
QByteArray writeBrush(const Brush &brush);

/// A brush from a file of any kind, and what of it has no counterpart here.
struct LoadedBrush {
    Brush brush;
    QStringList left; ///< the names of a MyPaint brush's settings that have no counterpart
};
/// Reads a brush file or a MyPaint brush (.myb), which are told apart by their content. A brush without a name gets the
/// file's.
Result<LoadedBrush> loadBrush(const QString &path);

} // namespace suffuse

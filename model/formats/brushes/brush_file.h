// Brushes as files, one each (docs/brushes.md).
#pragma once

#include "model/brush/brush.h"
#include "model/result.h"

#include <QByteArray>
#include <QStringList>

namespace suffuse {

/// Ending of brush files, without the dot.
inline constexpr const char *brushFileEnding = "suffuse-brush";

Result<Brush> readBrush(const QByteArray &bytes, const QString &fileName);
QByteArray writeBrush(const Brush &brush);

/// A brush from a file of any kind, and what of it has no counterpart here.
struct LoadedBrush {
    Brush brush;
    QStringList left; ///< names of a MyPaint brush's settings that do not map
};
/// Reads a brush file or a MyPaint brush (.myb), told apart by their content. A brush without a name gets the file's.
Result<LoadedBrush> loadBrush(const QString &path);

} // namespace suffuse

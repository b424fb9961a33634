// Strokes that come into an open painting: from the clipboard and from files.
#pragma once

#include "model/formats/files.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace suffuse {

class Editor;

/// New strokes on top of all, in groups of their own, visible, unlocked and selected; one undo step. They lie with
/// their middle at `centre`, or where they were, and none is born after the moment that is shown. Empty, or what of
/// them could not be added and why.
QString addStrokes(Editor &editor, const Painting &added, std::optional<Point> centre, const QString &undoText);

/// Those that say something, one after the other.
QString joinedSentences(const QStringList &sentences);

struct ImportReport {
    std::vector<QString> losses; ///< of a damaged file: what is missing
    QString leftOut;             ///< what cannot be strokes; empty: nothing
};

/// The strokes of a file of any kind that can be opened, as `addStrokes` adds them, with their middle at `centre` and
/// in one group that has the file's name; drawings and recordings are painted with the brush in hand. Errors name the
/// file, and nothing is added.
Result<ImportReport> importStrokes(Editor &editor, const QString &path, Point centre);

} // namespace suffuse

// Brings strokes into an open painting, from the clipboard and from files.
#pragma once

#include "model/formats/files.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace suffuse {

class Editor;

/// Adds strokes on top of all, in groups of their own, visible, unlocked and selected, as one undo step. Their middle
/// lies at `centre`, or they stay where they were. An empty painting takes over their times, and is then seen at its
/// end; in others none is born after the moment that is shown: all are brought back in time together. Returns an empty
/// string, or which of them could not be added and why, and whether they were brought back.
QString addStrokes(Editor &editor, const Painting &added, std::optional<Point> centre, const QString &undoText);

/// Joins the sentences that are not empty, one after the other.
QString joinedSentences(const QStringList &sentences);

struct ImportReport {
    std::vector<QString> losses; ///< what is missing of a damaged file
    QString leftOut;             ///< what of the file strokes cannot show; empty: nothing
};

/// Adds the strokes of a file, of any kind that can be opened, by `addStrokes`, with their middle at `centre` and in
/// one group that has the file's name. Drawings and recordings are painted with the brush in hand. On an error, which
/// names the file, nothing is added.
Result<ImportReport> importStrokes(Editor &editor, const QString &path, Point centre);

} // namespace suffuse

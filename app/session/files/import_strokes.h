// Brings strokes into an open painting, from the clipboard and from files.
#pragma once

#include "model/formats/files.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace suffuse {

class Editor;

/// Where strokes that come in are to lie, canvas units.
struct Landing {
    std::optional<Point> middle; ///< where their middle is to lie; none: they lie where they were
    Rect seen;                   ///< what can be seen of the canvas; empty: they need not be seen
    bool selects = true;         ///< Whether they are selected; else nothing is.
    bool goesOn = false;         ///< Whether they are painted from now on, and the clock goes on to when all has dried.
    Landing() = default;
    Landing(std::optional<Point> middle, const Rect &seen = {}) : middle(middle), seen(seen) {}
    Landing(Point middle) : middle(middle) {}
};

/// Adds strokes to the layer (`CurrentLayer::takePasted`), or on top of all where there is none, in groups of their
/// own, visible but in groups that are hidden, unlocked and, as `landing` says, selected, as one undo step. They lie
/// where `landing` says; where they would lie wholly outside of what is seen, their middle comes to the middle of that,
/// or, where they are to lie as they were, only the returned string says so. An empty painting takes over their times,
/// and is then seen at its end, and so does one that goes on; in others none is born after the moment that is shown:
/// all are brought back in time together. The step also puts `paints` behind the painting's swatches, but for those
/// that are among them. Returns an empty string, or which of the strokes could not be added and why, and whether they
/// were brought back.
QString addStrokes(Editor &editor, const Painting &added, const Landing &landing, const QString &undoText,
                   const std::vector<Swatch> &paints = {});

/// A painting from where an inch has `from` canvas units, for one where it has `to`: as large on paper. The painting
/// itself where either does not say it (0).
Painting atRealSize(Painting painting, double from, double to);

struct ImportReport {
    std::vector<QString> losses; ///< what is missing of a damaged file
    QString leftOut;             ///< what of the file strokes cannot show; empty: nothing
};

/// Adds the strokes of a file, of any kind that can be opened, by `addStrokes`, with their middle at `centre` and in
/// one group that has the file's name, as large on paper as they were (`atRealSize`). Drawings and recordings are
/// painted with the brush in hand. On an error, which names the file, nothing is added.
Result<ImportReport> importStrokes(Editor &editor, const QString &path, Point centre);

} // namespace suffuse

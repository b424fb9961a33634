// Groups as layers: where what is painted comes, and what is done with a layer as a whole. A function returns an empty
// Edit if there is nothing to do.
#pragma once

#include "undo/edits.h"
#include "undo/painted_layer.h"

namespace suffuse {

enum class LayerEnd { Top, Bottom };

/// The strokes that an edit adds, if it does nothing else and adds them on top of all others; otherwise none. The parts
/// of strokes that are cut stay where the strokes are.
std::vector<StrokeId> addedOnTop(const Painting &painting, const Edit &edit);

/// The group, or the innermost one around it, that can be a layer: texts and what is in them cannot. 0: none can.
GroupId layerAround(const Painting &painting, GroupId group);
/// The group, or the innermost one around it, into which paint can go: neither it nor a group around it is hidden or
/// locked. 0: none.
GroupId groupTakingPaint(const Painting &painting, GroupId group);
/// All groups that can be layers, the topmost first, each before those within it.
std::vector<GroupId> layersOf(const Painting &painting);

/// The edit with the strokes that it adds on top (`addedOnTop`) put into a layer, at one of its ends. New groups, as
/// that of a text, come into it as a whole. With `born` they come above what was begun by then and below the rest. If
/// the layer takes no paint, they come just above it, into the group around it that does.
Edit addedToLayer(const Document &document, Edit edit, const PaintedLayer &layer, LayerEnd end,
                  std::optional<Microseconds> born = {});

/// Whether strokes that come into a group would be hidden since others are solo; 0: into none.
bool isHiddenBySolo(const std::vector<Group> &groups, GroupId group);
/// The edit, which ends that groups are solo where they would hide a stroke that it adds.
Edit endingSolo(const Document &document, Edit edit);

/// Puts a copy of a group, with all that is in it, just above it. `copy` becomes its id.
Edit duplicateGroup(Document &document, GroupId group, GroupId &copy);

/// Why a group is not merged with the one below it.
enum class NotMerged { Merged, NothingBelow, NoGroupBelow, Hidden, Locked };
/// Puts what is in a group into the group just below it, which keeps what it is.
struct MergedDown {
    Edit edit;
    GroupId below = 0; ///< the group that there is then
    NotMerged why = NotMerged::Merged;
};
MergedDown mergeDown(const Document &document, GroupId group);

/// Moves a group past the next thing above or below it in the same group. A locked one stays.
Edit moveGroup(const Document &document, GroupId group, bool up);

/// Makes a group the only one that is solo or, if it is that already, makes none solo.
Edit toggleSolo(const Document &document, GroupId group);

} // namespace suffuse

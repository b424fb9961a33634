// Groups as layers: where what is painted comes, and what is done with a layer as a whole. A function returns an empty
// Edit if there is nothing to do.
#pragma once

#include "undo/edits.h"
#include "undo/layers/painted_layer.h"

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

/// The same for what is pasted: above the topmost selected stroke of the layer, if there is one; groups, if nothing
/// else comes and none is a text, come just above the layer.
Edit pastedToLayer(const Document &document, Edit edit, const PaintedLayer &layer,
                   std::optional<Microseconds> born = {});
/// The groups that an edit adds in no other one, if all strokes that it adds are in groups, and none of them is a text.
std::vector<GroupId> layersAdded(const Painting &painting, const Edit &edit);

/// Whether strokes that come into a group would be hidden since others are solo; 0: into none.
bool isHiddenBySolo(const std::vector<Group> &groups, GroupId group);
/// The edit, which ends that groups are solo where they would hide a stroke that it adds.
Edit endingSolo(const Document &document, Edit edit);

/// Puts a copy of a group, with all that is in it, just above it. `copy` becomes its id. Of what is selected in the
/// group, the copies are selected.
Edit duplicateGroup(Document &document, GroupId group, const QString &name, GroupId &copy);

/// Moves a group past the next thing above or below it in the same group. A locked one stays.
Edit moveGroup(const Document &document, GroupId group, bool up);

/// Makes a group the only one that is solo or, if it is that already, makes none solo.
Edit toggleSolo(const Document &document, GroupId group);

} // namespace suffuse

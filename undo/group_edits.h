// Groups, locks, visibility, names, and selecting by likeness. As in edits.h: an empty Edit where there is nothing to
// do.
#pragma once

#include "undo/edits.h"

namespace suffuse {

/// The selected strokes become a group, where the topmost of them stands; groups selected as a whole go into it as they
/// are. Locked strokes stay out.
Edit groupSelection(Document &document, const QString &name);
/// Dissolves the outermost groups that are selected as a whole, or else the groups in which the selected strokes stand.
Edit ungroupSelection(const Document &document);
/// Whether that dissolves something: a selected stroke that is not locked lies in a group.
bool canUngroup(const Document &document);
/// The outermost group whose strokes are all that is selected; 0 where there is none, or segments are selected.
GroupId selectedGroup(const Document &document);
/// Dissolves one group; what is in it goes to the group around it.
Edit ungroup(const Document &document, GroupId group);

Edit setLocked(const Document &document, const std::set<StrokeId> &strokes, bool locked);
Edit setVisible(const Document &document, const std::set<StrokeId> &strokes, bool visible);
Edit setGroupLocked(const Document &document, GroupId group, bool locked);
Edit setGroupVisible(const Document &document, GroupId group, bool visible);
/// All strokes and groups.
Edit unlockAll(const Document &document);
Edit showAll(const Document &document);
Edit renameStroke(const Document &document, StrokeId stroke, const QString &name);
Edit renameGroup(const Document &document, GroupId group, const QString &name);

enum class Same { Colour, Style, Brush, Name };
/// The selection and all visible, unlocked strokes that are like one of the selected: in mean colour (RYB, within 1/128
/// a channel), in style and mixing, in the name of their brush, or in their own name, if they have one.
Selection selectSame(const Document &document, Same what);

} // namespace suffuse

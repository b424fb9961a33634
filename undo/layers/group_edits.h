// Edits of groups, locks, visibility and names, and selecting by likeness. A function returns an empty Edit if there is
// nothing to do.
#pragma once

#include "undo/edits.h"

namespace suffuse {

/// Makes a group of the selected strokes, in the place of the topmost of them. Groups that are selected as a whole go
/// into it unchanged. Locked strokes stay out.
Edit groupSelection(Document &document, const QString &name);
/// Dissolves the outermost groups that are selected as a whole. If there are none, it dissolves the groups that the
/// selected strokes are in.
Edit ungroupSelection(const Document &document);
/// Whether that would dissolve something: whether a selected stroke that is not locked is in a group.
bool canUngroup(const Document &document);
/// The outermost group whose strokes are all that is selected. It is 0 if there is none, or if segments are selected.
GroupId selectedGroup(const Document &document);
/// The outermost groups whose strokes are all that is selected, from bottom to top. There are none if anything else is
/// selected, too, or if segments are.
std::vector<GroupId> selectedGroups(const Document &document);
/// Dissolves one group. What is in it goes to the group around it.
Edit ungroup(const Document &document, GroupId group);

/// These lock or unlock, and show or hide, strokes or a group.
Edit setLocked(const Document &document, const std::set<StrokeId> &strokes, bool locked);
Edit setVisible(const Document &document, const std::set<StrokeId> &strokes, bool visible);
/// The same of what is selected. Of a group that is selected as a whole, but for what is hidden or locked in it already,
/// the group is, so that what comes into it later is, too; nothing is selected any more.
Edit lockSelection(const Document &document);
Edit hideSelection(const Document &document);
Edit setGroupLocked(const Document &document, GroupId group, bool locked);
Edit setGroupVisible(const Document &document, GroupId group, bool visible);
/// Unlocks, and shows, all strokes and groups. None is solo any more.
Edit unlockAll(const Document &document);
Edit showAll(const Document &document);
Edit renameStroke(const Document &document, StrokeId stroke, const QString &name);
Edit renameGroup(const Document &document, GroupId group, const QString &name);

/// Applies `change` to how groups blend (opacity, mode, isolation, what group_roles.h has) or to the colour that marks
/// them, of those of the groups that are neither locked nor in a locked one.
/// `then` is the group in `before`, or the present one where it was not there. A group that becomes invalid stays as it
/// was.
Edit changeBlending(const Document &document, const Painting &before, const std::vector<GroupId> &groups,
                    const std::function<void(Group &now, const Group &then)> &change);
/// These set one of the first three.
Edit setGroupOpacity(const Document &document, const std::vector<GroupId> &groups, float opacity);
Edit setGroupBlend(const Document &document, const std::vector<GroupId> &groups, BlendMode blend);
Edit setGroupIsolated(const Document &document, const std::vector<GroupId> &groups, bool isolated);

enum class Same { Colour, Style, Brush, Name };
/// The selection and all visible, unlocked strokes that resemble one of the selected ones: in their mean colour (RYB,
/// within 1/128 a channel), in style and mixing, in the name of their brush, or in their own name, if they have one.
Selection selectSame(const Document &document, Same what);

} // namespace suffuse

// Changes of what a row of the Strokes dock has of its own: name, eye and lock.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <functional>

namespace suffuse {

class Editor;
class ValueEntry;

/// Changes a stroke or group in one undo step with this text. If nothing changes, there is no step. Changes of
/// one entry that follow each other are one step.
void changeStroke(Editor &editor, StrokeId id, const std::function<void(Stroke &)> &change, const QString &text,
                  ValueEntry *entry = nullptr);
void changeGroup(Editor &editor, GroupId id, const std::function<void(Group &)> &change, const QString &text,
                 ValueEntry *entry = nullptr);
/// Changes all strokes and groups in a group, but not the group itself, in one undo step.
void changeWithin(Editor &editor, GroupId id, const std::function<void(Stroke &)> &changeStroke,
                  const std::function<void(Group &)> &changeGroup, const QString &text, ValueEntry *entry = nullptr);

} // namespace suffuse

// One row of the table of commands: what it is called, when it can be used, and what it does.
#pragma once

#include <QString>

namespace suffuse {

class Actions;
class CanvasWidget;
class Editor;
class Playback;
class SelectionOrder;

/// What the rows work on: one window's painting and how it is looked at.
struct CommandTarget {
    Editor &editor;
    Playback &playback;
    SelectionOrder &selectionOrder;
    CanvasWidget &canvas;
    const Actions &actions; ///< the switches that other commands obey
};

/// Every part may be absent (null). What is absent is the window's or a tool's affair: it connects the action itself.
struct CommandRow {
    using Predicate = bool (*)(const CommandTarget &);
    using Words = QString (*)(const CommandTarget &);

    Predicate enabled = nullptr;
    Predicate checked = nullptr;
    Words text = nullptr; ///< where it changes, as that of Undo
    Words icon = nullptr; ///< name of the icon, where it changes
    void (*run)(const CommandTarget &) = nullptr;
    void (*toggled)(const CommandTarget &, bool on) = nullptr;
    bool isHeld = false; ///< works while its key is held, and does nothing when it is triggered

    CommandRow &when(Predicate predicate) { return enabled = predicate, *this; }
    CommandRow &checkedWhen(Predicate predicate) { return checked = predicate, *this; }
    CommandRow &named(Words words) { return text = words, *this; }
    CommandRow &pictured(Words name) { return icon = name, *this; }
    CommandRow &runs(void (*function)(const CommandTarget &)) { return run = function, *this; }
    CommandRow &toggles(void (*function)(const CommandTarget &, bool)) { return toggled = function, *this; }
    CommandRow &held() { return isHeld = true, *this; }
};

/// Something is selected.
bool anySelected(const CommandTarget &target);
/// The painting has a stroke.
bool anyStrokes(const CommandTarget &target);

} // namespace suffuse

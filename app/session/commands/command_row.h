// One row of the table of commands: what it is called, its keys, when it can be used, and what it does.
#pragma once

#include <QKeySequence>
#include <QList>
#include <QString>

#include <functional>

class QAction;

namespace suffuse {

/// Where the keys of a command work. Keys that are held with Ctrl, Alt or Meta, and function keys, work in the whole
/// window; the others are typed (`isTypedKey`), and panels keep what is typed in them to themselves.
enum class CommandScope {
    Window,   ///< typed keys work on the canvas
    Strokes,  ///< and in the Strokes dock
    Timeline, ///< and in the Timeline dock
    Nodes,    ///< typed keys work on the canvas, and are about nodes and segments of the selected strokes
    Canvas,   ///< on the canvas only: it follows the keys themselves, from when they are pressed until they are let go
};

/// Whether a command can be used, and if not, why, in a sentence that says what to do.
struct Usability {
    bool isUsable = true;
    QString whyNot = {}; ///< empty: it goes without saying

    Usability(bool usable) : isUsable(usable) {}
    /// Usable, or else that is why not.
    Usability(bool usable, const QString &whyNot) : isUsable(usable), whyNot(usable ? QString() : whyNot) {}
    explicit operator bool() const { return isUsable; }
};

/// Parts may be absent (null), but every row does something: it runs, it is a switch, or its keys are held.
struct CommandRow {
    using Predicate = std::function<bool()>;
    using Condition = std::function<Usability()>;
    using Words = std::function<QString()>;

    QAction *action = nullptr; ///< that stands for the row in menus and tool bars
    CommandScope scope = CommandScope::Window;
    Condition enabled;
    QString whyNot; ///< of the moment; empty where it is enabled, or where nothing is to be said
    Predicate checked;
    Predicate shown;
    Words text; ///< where it changes, as that of Undo
    Words icon; ///< name of the icon, where it changes
    QString shownIcon; ///< the name of the one that was made last
    std::function<void()> run;
    std::function<void(bool on)> toggled;
    std::function<void(const QList<QKeySequence> &keys)> keysChanged; ///< of a row whose keys are held
    bool isSwitch = false; ///< others look whether it is on, and that is all that it does

    /// It works while its keys are held, and does nothing when it is triggered.
    bool isHeld() const { return bool(keysChanged); }
    bool doesSomething() const { return run || toggled || isSwitch || isHeld(); }

    CommandRow &in(CommandScope where) { return scope = where, *this; }
    CommandRow &when(Condition condition) { return enabled = std::move(condition), *this; }
    /// The same, and else that is why not: a sentence that says what to do.
    CommandRow &when(Predicate predicate, const QString &whyNot)
    {
        return when([predicate = std::move(predicate), whyNot] { return Usability(predicate(), whyNot); });
    }
    CommandRow &checkedWhen(Predicate predicate) { return checked = std::move(predicate), checkable(); }
    CommandRow &shownWhen(Predicate predicate) { return shown = std::move(predicate), *this; }
    CommandRow &named(Words words) { return text = std::move(words), *this; }
    CommandRow &pictured(Words name) { return icon = std::move(name), *this; }
    CommandRow &runs(std::function<void()> function) { return run = std::move(function), *this; }
    /// It can be on and off, and is on from the start or not.
    CommandRow &checkable(bool on = false);
    CommandRow &toggles(std::function<void(bool on)> function)
    {
        return toggled = std::move(function), checkable(isOn());
    }
    CommandRow &switches(bool on = false) { return isSwitch = true, checkable(on); }
    /// Calls the function now, and whenever the keys are others.
    CommandRow &held(std::function<void(const QList<QKeySequence> &keys)> function);

private:
    bool isOn() const;
};

} // namespace suffuse

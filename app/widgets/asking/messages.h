// The messages and questions of the window. Tests put answers in place of the message boxes.
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace suffuse {

enum class SaveAnswer { Save, Discard, Cancel };
/// Answers about a file that another program has changed.
enum class ConflictAnswer { KeepMine, Reload, SaveAs, Cancel };

/// Answers for tests: where one is set, it takes the place of the box.
struct MessageHooks {
    std::function<void(const QString &message)> error = {};
    std::function<SaveAnswer(const QString &name)> unsaved = {};
    std::function<bool(const QString &message)> saveFailed = {};
    std::function<ConflictAnswer(const QString &name, bool saving)> conflict = {};
    std::function<bool(const QString &question)> confirm = {};
};
void setMessageHooks(MessageHooks hooks);

/// Shows an error that names the file, the place and the remedy.
void showError(QWidget *parent, const QString &message);
/// Asks "Save changes to … before closing?".
SaveAnswer askToSave(QWidget *parent, const QString &name);

/// Says something about the work, which goes on meanwhile.
void showNotice(QWidget *parent, const QString &message, const QString &details = {});
/// Says what went wrong when saving. Returns true if the user wants to save under another name.
bool askAfterFailedSave(QWidget *parent, const QString &message);
/// Asks what to do about a file that another program has changed. The change was noticed at some time, or when the file
/// was to be replaced (`saving`). `modified`: reloading would lose work.
ConflictAnswer askAboutConflict(QWidget *parent, const QString &name, bool modified, bool saving);
/// Asks whether to discard something; the button that does it has its own name. False is the usual answer.
bool confirm(QWidget *parent, const QString &question, const QString &information, const QString &button);

} // namespace suffuse

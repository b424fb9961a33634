// What the window says and asks. Tests put answers in place of message boxes.
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace suffuse {

enum class SaveAnswer { Save, Discard, Cancel };
/// Of a file that another program has changed.
enum class ConflictAnswer { KeepMine, Reload, SaveAs, Cancel };

/// Takes the place of the boxes where set.
struct MessageHooks {
    std::function<void(const QString &message)> error = {};
    std::function<SaveAnswer(const QString &name)> unsaved = {};
    std::function<bool(const QString &message)> saveFailed = {};
    std::function<ConflictAnswer(const QString &name, bool saving)> conflict = {};
    std::function<bool(const QString &question)> confirm = {};
};
void setMessageHooks(MessageHooks hooks);

/// An error that names the file, the place and the remedy.
void showError(QWidget *parent, const QString &message);
/// "Save changes to … before closing?"
SaveAnswer askToSave(QWidget *parent, const QString &name);

/// Says something beside the work, which goes on.
void showNotice(QWidget *parent, const QString &message, const QString &details = {});
/// What went wrong when saving; true: save under another name.
bool askAfterFailedSave(QWidget *parent, const QString &message);
/// Another program has changed the file: noticed meanwhile, or when it was to be replaced (`saving`). `modified`: there
/// is work that reloading would lose.
ConflictAnswer askAboutConflict(QWidget *parent, const QString &name, bool modified, bool saving);
/// "Discard?", with the button that does it named; false is the usual answer.
bool confirm(QWidget *parent, const QString &question, const QString &information, const QString &button);

} // namespace suffuse

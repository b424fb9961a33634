// What the window says and asks. Tests put answers in place of message boxes.
#pragma once

#include <QString>

#include <functional>

class QWidget;

namespace suffuse {

enum class SaveAnswer { Save, Discard, Cancel };

/// Takes the place of the boxes where set.
struct MessageHooks {
    std::function<void(const QString &message)> error;
    std::function<SaveAnswer(const QString &name)> unsaved;
};
void setMessageHooks(MessageHooks hooks);

/// An error that names the file, the place and the remedy.
void showError(QWidget *parent, const QString &message);
/// "Save changes to … before closing?"
SaveAnswer askToSave(QWidget *parent, const QString &name);

} // namespace suffuse

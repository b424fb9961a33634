#include "app/messages.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace suffuse {

namespace {

MessageHooks &hooks()
{
    static MessageHooks value;
    return value;
}

} // namespace

void setMessageHooks(MessageHooks value)
{
    hooks() = std::move(value);
}

void showError(QWidget *parent, const QString &message)
{
    if (hooks().error) {
        hooks().error(message);
        return;
    }
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Suffuse"), message, QMessageBox::Ok, parent);
    box.setTextFormat(Qt::PlainText); // file names may look like markup
    box.exec();
}

SaveAnswer askToSave(QWidget *parent, const QString &name)
{
    if (hooks().unsaved)
        return hooks().unsaved(name);
    QMessageBox box(QMessageBox::Question, QStringLiteral("Suffuse"),
                    QCoreApplication::translate("Messages", "Save the changes to “%1” before closing?").arg(name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(
        QCoreApplication::translate("Messages", "Without saving, what was painted since the last save is lost."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return SaveAnswer::Save;
    case QMessageBox::Discard:
        return SaveAnswer::Discard;
    default:
        return SaveAnswer::Cancel;
    }
}

} // namespace suffuse

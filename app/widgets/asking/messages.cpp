#include "app/widgets/asking/messages.h"

#include "app/widgets/look/icons.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace suffuse {

namespace {

constexpr qsizetype shownDetails = 5; // lines that are shown at once; the rest is shown on request

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
    box.setTextFormat(Qt::PlainText); // since file names may look like markup
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
        QCoreApplication::translate("Messages", "Without saving, what has not been saved yet is lost."));
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

void showNotice(QWidget *parent, const QString &message, const QString &details)
{
    if (hooks().error) {
        hooks().error(message);
        return;
    }
    auto *box = new QMessageBox(QMessageBox::Warning, QStringLiteral("Suffuse"), message, QMessageBox::Ok, parent);
    box->setTextFormat(Qt::PlainText);
    const QStringList lines = details.split('\n');
    box->setInformativeText(lines.mid(0, shownDetails).join('\n'));
    if (lines.size() > shownDetails)
        box->setDetailedText(details);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

bool askAfterFailedSave(QWidget *parent, const QString &message)
{
    if (hooks().saveFailed)
        return hooks().saveFailed(message);
    if (hooks().error) {
        hooks().error(message);
        return false;
    }
    QMessageBox box(QMessageBox::Warning, QStringLiteral("Suffuse"), message, QMessageBox::Cancel, parent);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(
        QCoreApplication::translate("Messages", "Nothing is lost: the painting stays open as it is."));
    QPushButton *elsewhere =
        box.addButton(QCoreApplication::translate("Messages", "Save &As…"), QMessageBox::AcceptRole);
    elsewhere->setIcon(icon("save"));
    box.setDefaultButton(elsewhere);
    box.exec();
    return box.clickedButton() == elsewhere;
}

ConflictAnswer askAboutConflict(QWidget *parent, const QString &name, bool modified, bool saving)
{
    if (hooks().conflict)
        return hooks().conflict(name, saving);
    QMessageBox box(QMessageBox::Question, QStringLiteral("Suffuse"),
                    QCoreApplication::translate("Messages", "Another program has changed “%1”.").arg(name),
                    QMessageBox::NoButton, parent);
    box.setTextFormat(Qt::PlainText);
    const QString lost =
        QCoreApplication::translate("Messages",
                                    "Reloading takes away what was painted since the last save; Undo brings it back.");
    const QString kept = QCoreApplication::translate("Messages", "The file stays as it is until you save.");
    const QString replaced =
        QCoreApplication::translate("Messages", "Overwriting gives up what the other program wrote.");
    box.setInformativeText((modified ? lost + ' ' : QString()) + (saving ? replaced : kept));
    const auto add = [&](const char *text, const char *picture, QMessageBox::ButtonRole role) {
        QPushButton *button = box.addButton(QCoreApplication::translate("Messages", text), role);
        button->setIcon(icon(picture));
        return button;
    };
    QPushButton *mine = saving ? add(QT_TRANSLATE_NOOP("Messages", "&Overwrite"), "ok", QMessageBox::DestructiveRole)
                               : add(QT_TRANSLATE_NOOP("Messages", "&Keep Mine"), "ok", QMessageBox::RejectRole);
    QPushButton *reload = add(QT_TRANSLATE_NOOP("Messages", "&Reload"), "reset", QMessageBox::DestructiveRole);
    QPushButton *elsewhere = add(QT_TRANSLATE_NOOP("Messages", "Save &As…"), "save", QMessageBox::AcceptRole);
    if (saving)
        box.setEscapeButton(box.addButton(QMessageBox::Cancel));
    else
        box.setEscapeButton(mine);
    box.setDefaultButton(modified ? elsewhere : reload);
    box.exec();
    return box.clickedButton() == mine        ? ConflictAnswer::KeepMine
           : box.clickedButton() == reload    ? ConflictAnswer::Reload
           : box.clickedButton() == elsewhere ? ConflictAnswer::SaveAs
                                              : ConflictAnswer::Cancel;
}

bool confirm(QWidget *parent, const QString &question, const QString &information, const QString &button)
{
    if (hooks().confirm)
        return hooks().confirm(question);
    QMessageBox box(QMessageBox::Question, QStringLiteral("Suffuse"), question, QMessageBox::Cancel, parent);
    box.setTextFormat(Qt::PlainText);
    box.setInformativeText(information);
    QPushButton *yes = box.addButton(button, QMessageBox::DestructiveRole);
    yes->setIcon(icon("ok"));
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == yes;
}

} // namespace suffuse

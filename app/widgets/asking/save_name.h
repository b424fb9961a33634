// Asks for names of files to write.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

class QLineEdit;
class QWidget;

namespace suffuse {

/// A kind of file and its endings, without dots; the usual ending comes first.
struct FileKind {
    QString title; ///< translated
    QStringList endings;
};

/// The filter of a file dialog: "Suffuse painting (*.suffuse)".
QString filterOf(const FileKind &kind);
/// Returns the path as it is if it has one of the endings, else with `usual` appended: the text after a dot may be part
/// of a name ("edited v1.0").
QString withEnding(const QString &path, const QList<FileKind> &kinds, const QString &usual);
/// Asks for the name of a file to write, beginning with `proposal`. A name that lacks an ending gets that of the chosen
/// kind. An existing file is replaced only if the user says so. Returns an empty path if the user gave up.
QString chooseFileToSave(QWidget *parent, const QString &title, const QString &proposal, const QList<FileKind> &kinds);

/// Call it while a dialog is made: the dialog opens with the keyboard in this field, and with the name selected without
/// folder and ending, so that another name can be typed at once.
void beginWithName(QLineEdit &path);

} // namespace suffuse

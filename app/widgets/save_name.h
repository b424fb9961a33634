// Names of files that are written.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

class QLineEdit;
class QWidget;

namespace suffuse {

/// A kind of file and its endings, without dots, the usual one first.
struct FileKind {
    QString title; ///< translated
    QStringList endings;
};

/// "Suffuse painting (*.suffuse)"
QString filterOf(const FileKind &kind);
/// The path as it is where it has one of the endings; else with `usual` appended: what stands after a dot may be part
/// of a name ("edited v1.0").
QString withEnding(const QString &path, const QList<FileKind> &kinds, const QString &usual);
/// Asks for the name of a file to write, `proposal` to begin with. One that lacks an ending gets that of the kind that
/// is chosen. What is there already is replaced only if the user says so. Empty: given up.
QString chooseFileToSave(QWidget *parent, const QString &title, const QString &proposal, const QList<FileKind> &kinds);

/// For a dialog that is being made: it opens with the keyboard in this field, and the name without folder and ending
/// selected, so that another one can be typed at once.
void beginWithName(QLineEdit &path);

} // namespace suffuse

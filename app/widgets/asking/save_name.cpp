#include "app/widgets/asking/save_name.h"

#include "app/widgets/asking/messages.h"
#include "app/widgets/asking/usual_folder.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>

#include <algorithm>

namespace suffuse {

namespace {

/// The kind that has the file's ending, or the first one if none has.
qsizetype kindOf(const QString &path, const QList<FileKind> &kinds)
{
    const auto it = std::ranges::find_if(kinds, [ending = QFileInfo(path).suffix()](const FileKind &kind) {
        return kind.endings.contains(ending, Qt::CaseInsensitive);
    });
    return it == kinds.end() ? 0 : it - kinds.begin();
}

/// Why a file must not be called so; empty: it may.
QString problemOfName(const QString &typed)
{
    if (typed.contains('"'))
        return QCoreApplication::translate(
            "Messages", "Leave out the quotation marks: file dialogs take them for the borders between several names.");
    const QString name = typed.mid(typed.lastIndexOf('/') + 1);
    if (name.startsWith('.') && QFileInfo(name).completeBaseName().isEmpty())
        return QCoreApplication::translate("Messages", "“%1” is only an ending. Give a name before it.").arg(name);
    return {};
}

/// A dialog for a file to be written, which refuses names that would become others.
class NameDialog : public QFileDialog {
public:
    using QFileDialog::QFileDialog;

protected:
    void accept() override
    {
        const auto *name = findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        const QString problem = name ? problemOfName(name->text()) : QString();
        if (problem.isEmpty())
            QFileDialog::accept();
        else
            showError(this, problem);
    }
};

} // namespace

QString filterOf(const FileKind &kind)
{
    return QStringLiteral("%1 (*.%2)").arg(kind.title, kind.endings.join(QStringLiteral(" *.")));
}

QString withEnding(const QString &path, const QList<FileKind> &kinds, const QString &usual)
{
    const QString ending = QFileInfo(path).suffix();
    const bool isKnown = std::ranges::any_of(
        kinds, [&](const FileKind &kind) { return kind.endings.contains(ending, Qt::CaseInsensitive); });
    return isKnown ? path : path + (path.endsWith('.') ? QString() : QStringLiteral(".")) + usual;
}

QString chooseFileToSave(QWidget *parent, const QString &title, const QString &proposal, const QList<FileKind> &kinds)
{
    const bool hasFolder = proposal.contains('/');
    const QString kind = kinds.front().endings.front();
    QString path = hasFolder ? proposal : usualFolder(kind) + '/' + proposal;
    for (;;) {
        NameDialog dialog(parent, title, QFileInfo(path).absolutePath());
        dialog.setAcceptMode(QFileDialog::AcceptSave);
        QStringList filters;
        for (const FileKind &kind : kinds)
            filters << filterOf(kind);
        dialog.setNameFilters(filters);
        const auto usual = [&] {
            return kinds[std::max<qsizetype>(0, filters.indexOf(dialog.selectedNameFilter()))].endings.front();
        };
        // With it the dialog itself asks about the right file, in most cases, before it is replaced.
        QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&] { dialog.setDefaultSuffix(usual()); });
        dialog.selectNameFilter(filters[kindOf(path, kinds)]);
        dialog.setDefaultSuffix(usual());
        dialog.selectFile(QFileInfo(path).fileName());
        if (dialog.exec() != QDialog::Accepted)
            return {};
        const QString chosen = dialog.selectedFiles().value(0);
        path = withEnding(chosen, kinds, usual());
        if (path == chosen || !QFileInfo::exists(path) ||
            confirm(parent,
                    QCoreApplication::translate("Messages", "“%1” exists. Replace it?").arg(QFileInfo(path).fileName()),
                    {}, QCoreApplication::translate("Messages", "&Replace"))) {
            if (!hasFolder)
                keepUsualFolder(kind, path);
            return path;
        }
    }
}

void beginWithName(QLineEdit &path)
{
    path.setFocus();
    const auto select = [&path] {
        const QString text = path.text();
        const qsizetype name = text.lastIndexOf(QLatin1Char('/')) + 1, dot = text.lastIndexOf(QLatin1Char('.'));
        path.setSelection(int(name), int((dot > name ? dot : text.size()) - name));
    };
    QMetaObject::invokeMethod(&path, select, Qt::QueuedConnection); // later, since showing the dialog selects all
}

} // namespace suffuse

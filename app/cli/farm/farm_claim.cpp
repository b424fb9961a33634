#include "app/cli/farm/farm_claim.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

namespace suffuse::cli {

namespace {

/// The folder of the farm that a mark names; empty: there is no mark.
QString claimant(const QString &mark)
{
    QFile file(mark);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.read(65536)).trimmed() : QString();
}

/// Whether the plan in a folder, as far as it can be read, has that picture.
bool stillPlans(const QString &folder, const QString &out)
{
    QFile file(QDir(folder).filePath(QStringLiteral("plan.json")));
    if (!file.open(QIODevice::ReadOnly))
        return false;
    for (const auto &painting : QJsonDocument::fromJson(file.readAll()).object()["paintings"].toArray())
        if (painting.toObject()["out"].toString() == out)
            return true;
    return false;
}

QString problemOfClaim(const FarmPlan &plan, const FarmPainting &painting)
{
    const QString other = claimant(claimOf(painting));
    if (other.isEmpty() || other == plan.folder || !stillPlans(other, painting.out()))
        return {};
    return QCoreApplication::translate("Cli",
                                       "%1: it belongs to the farm in %2, and two farms would overwrite each other's "
                                       "pieces. Choose another name, or, if that farm is not wanted any more, remove "
                                       "its folder.")
        .arg(painting.out(), other);
}

} // namespace

QString claimOf(const FarmPainting &painting)
{
    const QFileInfo out(painting.out());
    return QStringLiteral("%1/.%2.farm").arg(out.path(), out.fileName());
}

QString problemOfClaims(const FarmPlan &plan)
{
    for (const FarmPainting &painting : plan.paintings)
        if (const QString problem = problemOfClaim(plan, painting); !problem.isEmpty())
            return problem;
    return {};
}

Result<void> claimOuts(const FarmPlan &plan)
{
    for (const FarmPainting &painting : plan.paintings) {
        if (const QString problem = problemOfClaim(plan, painting); !problem.isEmpty())
            return Error{problem};
        const QString mark = claimOf(painting);
        if (!claimant(mark).isEmpty())
            QFile::remove(mark); // of this farm, or of one that is gone
        const QByteArray content = plan.folder.toUtf8() + '\n';
        QFile file(mark);
        if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly) || file.write(content) != content.size() ||
            !file.flush())
            return Error{QCoreApplication::translate("Cli", "%1: cannot be written (%2). Is another farm being planned?")
                             .arg(mark, file.errorString())};
    }
    return {};
}

void releaseOuts(const FarmPlan &plan)
{
    for (const FarmPainting &painting : plan.paintings)
        if (const QString mark = claimOf(painting); claimant(mark) == plan.folder)
            QFile::remove(mark);
}

} // namespace suffuse::cli

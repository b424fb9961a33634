#include "app/widgets/asking/choose_profile.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

namespace suffuse {

namespace {

struct ChooseProfile {
    Q_DECLARE_TR_FUNCTIONS(ChooseProfile)
};

} // namespace

QString askForProfile(QWidget *parent, const QString &title, const QString &before)
{
    const QString shared = QStandardPaths::locate(QStandardPaths::GenericDataLocation, QStringLiteral("color/icc"),
                                                  QStandardPaths::LocateDirectory);
    return QFileDialog::getOpenFileName(parent, title, before.isEmpty() ? shared : before,
                                        ChooseProfile::tr("Colour profiles") + QStringLiteral(" (*.icc *.icm)"));
}

} // namespace suffuse

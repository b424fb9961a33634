#include "app/widgets/asking/choose_picture.h"

#include <QCoreApplication>
#include <QFileDialog>

namespace suffuse {

namespace {

struct ChoosePicture {
    Q_DECLARE_TR_FUNCTIONS(ChoosePicture)
};

} // namespace

QString choosePicture(QWidget *parent, const QString &title)
{
    return QFileDialog::getOpenFileName(parent, title, QString(),
                                        ChoosePicture::tr("Pictures") +
                                            QStringLiteral(" (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr)"));
}

} // namespace suffuse

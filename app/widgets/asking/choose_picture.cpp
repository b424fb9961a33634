#include "app/widgets/asking/choose_picture.h"

#include <QCoreApplication>
#include <QFileDialog>

namespace suffuse {

namespace {

struct ChoosePicture {
    Q_DECLARE_TR_FUNCTIONS(ChoosePicture)
};

constexpr QLatin1String pictureEndings("*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr");

} // namespace

QString choosePicture(QWidget *parent, const QString &title)
{
    return QFileDialog::getOpenFileName(parent, title, QString(),
                                        ChoosePicture::tr("Pictures") + QStringLiteral(" (%1)").arg(pictureEndings));
}

QString choosePictureToFit(QWidget *parent, const QString &title)
{
    return QFileDialog::getOpenFileName(
        parent, title, QString(),
        ChoosePicture::tr("Pictures and diffusion curves") + QStringLiteral(" (%1 *.xml)").arg(pictureEndings));
}

} // namespace suffuse

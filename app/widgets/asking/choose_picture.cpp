#include "app/widgets/asking/choose_picture.h"

#include "app/widgets/asking/usual_folder.h"

#include <QCoreApplication>
#include <QFileDialog>

namespace suffuse {

namespace {

struct ChoosePicture {
    Q_DECLARE_TR_FUNCTIONS(ChoosePicture)
};

constexpr QLatin1String pictureEndings("*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr");

/// Among the files of a filter, in the folder of the picture that was chosen last.
QString choose(QWidget *parent, const QString &title, const QString &filter)
{
    const QString kind = QStringLiteral("picture");
    const QString path = QFileDialog::getOpenFileName(parent, title, usualFolder(kind), filter);
    if (!path.isEmpty())
        keepUsualFolder(kind, path);
    return path;
}

} // namespace

QString choosePicture(QWidget *parent, const QString &title)
{
    return choose(parent, title, ChoosePicture::tr("Pictures") + QStringLiteral(" (%1)").arg(pictureEndings));
}

QString choosePictureToFit(QWidget *parent, const QString &title)
{
    return choose(parent, title,
                  ChoosePicture::tr("Pictures and diffusion curves") + QStringLiteral(" (%1 *.xml)").arg(pictureEndings));
}

} // namespace suffuse

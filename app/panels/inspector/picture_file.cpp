#include "app/panels/inspector/picture_file.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>

namespace suffuse {

namespace {

constexpr qint64 maxBytes = 64 * 1024 * 1024;

struct PictureFile {
    Q_DECLARE_TR_FUNCTIONS(PictureFile)
};

} // namespace

QString choosePictureFile(QWidget *parent, const QString &title)
{
    return QFileDialog::getOpenFileName(parent, title, QString(),
                                        PictureFile::tr("Pictures") +
                                            QStringLiteral(" (*.png *.jpg *.jpeg *.tif *.tiff *.webp *.exr)"));
}

Result<EncodedImage> readPictureFile(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{PictureFile::tr("%1 cannot be read: %2.").arg(path, file.errorString())};
    if (file.size() > maxBytes)
        return Error{PictureFile::tr("%1 is larger than 64 MB: choose a smaller picture.").arg(path)};
    return EncodedImage(std::make_shared<const QByteArray>(file.readAll()));
}

} // namespace suffuse

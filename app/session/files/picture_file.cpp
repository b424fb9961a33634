#include "app/session/files/picture_file.h"

#include <QCoreApplication>
#include <QFile>

namespace suffuse {

namespace {

constexpr qint64 maxBytes = 64 * 1024 * 1024;

struct PictureFile {
    Q_DECLARE_TR_FUNCTIONS(PictureFile)
};

} // namespace

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

#include "model/formats/picture_links.h"

#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <functional>
#include <map>
#include <utility>

namespace suffuse {

namespace {

/// Puts other pictures in place of those that are linked. `change` returns whether it has changed one.
template <class Change>
void changeLinked(Painting &painting, Change change)
{
    for (std::size_t i = 0; i < painting.strokes.size(); ++i) {
        const StrokePtr &stroke = std::as_const(painting.strokes)[i];
        if (!stroke->picture || !stroke->picture->isLinked())
            continue;
        Picture picture = *stroke->picture;
        if (!change(picture))
            continue;
        Stroke changed = *stroke;
        changed.picture = std::move(picture);
        painting.strokes[i] = std::make_shared<const Stroke>(std::move(changed));
    }
}

Painting withLinks(Painting painting, const std::function<QString(const QString &)> &linkOf)
{
    changeLinked(painting, [&](Picture &picture) {
        const QString link = linkOf(picture.link);
        return std::exchange(picture.link, link) != link;
    });
    return painting;
}

} // namespace

Result<EncodedImage> readLinked(const QString &link, const QString &sha256, const QString &folder)
{
    const QFileInfo info(QDir(folder), link);
    const QString shown = QDir::toNativeSeparators(info.filePath());
    QFile file(info.filePath());
    if (!info.isFile() || !file.open(QIODevice::ReadOnly))
        return Error{FileMessages::tr("The linked picture %1 is missing, and is not seen: put its file back, or link "
                                      "another one in the Inspector.")
                         .arg(shown)};
    if (info.size() > largestImage)
        return Error{FileMessages::tr("The linked picture %1 has more than 64 MB, and is not seen.").arg(shown)};
    auto image = std::make_shared<const QByteArray>(file.readAll());
    if (sha256Of(*image) != sha256)
        return Error{FileMessages::tr("The linked picture %1 has changed since it was linked, and is not seen: link it "
                                      "anew in the Inspector.")
                         .arg(shown)};
    return EncodedImage(std::move(image));
}

QString readLinks(Painting &painting, const QString &folder)
{
    std::map<std::pair<QString, QString>, EncodedImage> known; // null: it is told already
    QStringList problems;
    changeLinked(painting, [&](Picture &picture) {
        if (picture.image)
            return false;
        const auto [at, isNew] = known.try_emplace({picture.link, picture.sha256});
        if (isNew) {
            const Result<EncodedImage> image = readLinked(picture.link, picture.sha256, folder);
            if (image)
                at->second = *image;
            else
                problems.append(image.error());
        }
        picture.image = at->second;
        return bool(picture.image);
    });
    if (problems.size() > 1)
        problems = {problems.front(),
                    FileMessages::tr("So it is with %n other picture(s).", nullptr, int(problems.size()) - 1)};
    return problems.join(QLatin1Char(' '));
}

void readLink(StrokePtr &stroke, const QString &folder)
{
    if (!stroke || !stroke->picture || !stroke->picture->isLinked() || stroke->picture->image)
        return;
    Painting alone;
    alone.strokes = {stroke};
    readLinks(alone, folder);
    stroke = alone.strokes.front();
}

Painting withAbsoluteLinks(Painting painting, const QString &folder)
{
    return withLinks(std::move(painting),
                     [dir = QDir(folder)](const QString &link) { return QDir::cleanPath(dir.absoluteFilePath(link)); });
}

Painting withRelativeLinks(Painting painting, const QString &folder)
{
    return withLinks(std::move(painting), [dir = QDir(folder)](const QString &link) {
        const QString relative = dir.relativeFilePath(link);
        return QDir::isAbsolutePath(link) && !relative.startsWith(QLatin1String("..")) ? relative : link;
    });
}

} // namespace suffuse

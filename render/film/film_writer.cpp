#include "render/film/film_writer.h"

#include "render/film/film_kinds.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double slowest = 0.001, fastest = 1000;

QString endingOf(const QString &path)
{
    return QFileInfo(path).suffix().toLower();
}

} // namespace

QStringList filmEndings()
{
    return {QStringLiteral("webp"), QStringLiteral("webm"), QStringLiteral("mp4")};
}

FilmKind filmKindOf(const QString &path)
{
    if (QFileInfo(path).fileName().contains(QLatin1Char('%')) || !filmEndings().contains(endingOf(path)))
        return FilmKind::Frames;
    return endingOf(path) == QLatin1String("webp") ? FilmKind::WebP : FilmKind::Video;
}

QString problemOf(const FilmOptions &options)
{
    if (!(options.fps >= slowest && options.fps <= fastest))
        return QCoreApplication::translate("Film", "a film has %1 to %2 frames a second").arg(slowest).arg(fastest);
    const FilmKind kind = filmKindOf(options.path);
    if (kind == FilmKind::Video) {
        if (options.image.alpha && endingOf(options.path) == QLatin1String("mp4"))
            return QCoreApplication::translate("Film", "MP4 cannot hold transparency. Use WebM, WebP or frames.");
        constexpr int maxSide = 8192;
        if (options.width > maxSide || options.height > maxSide)
            return QCoreApplication::translate("Film", "a video has at most %1 pixels a side").arg(maxSide);
        return {};
    }
    if (kind == FilmKind::Frames)
        if (const QString problem = problemOfFrames(options.path); !problem.isEmpty())
            return problem;
    return problemOf(imageFormatForPath(options.path), options.image, std::max(options.width, 1),
                     std::max(options.height, 1));
}

Result<std::unique_ptr<FilmWriter>> openFilm(const FilmOptions &options)
{
    if (const QString problem = problemOf(options); !problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(options.path, problem)};
    const QString folder = QFileInfo(options.path).absolutePath();
    if (!QFileInfo(folder).isDir())
        return Error{QCoreApplication::translate("FileReplacement", "%1: the folder %2 does not exist. Create it, or "
                                                                    "choose another.")
                         .arg(options.path, folder)};
    switch (filmKindOf(options.path)) {
    case FilmKind::WebP:
        return openWebP(options);
    case FilmKind::Video:
        return openVideo(options);
    case FilmKind::Frames:
        break;
    }
    return openFrames(options);
}

Result<void> OrderedFilm::write(std::size_t i, const FloatPicture &picture)
{
    QByteArray pixels(qsizetype(picture.width) * picture.height * channels(), Qt::Uninitialized);
    auto *to = reinterpret_cast<unsigned char *>(pixels.data());
    for (std::size_t at = 0; at < picture.rgba.size(); at += 4)
        for (int c = 0; c < channels(); ++c)
            *to++ = (unsigned char)(std::lround(255 * std::clamp(picture.rgba[at + std::size_t(c)], 0.0f, 1.0f)));
    const std::lock_guard lock(m_mutex);
    m_waiting.emplace(i, std::move(pixels));
    for (auto it = m_waiting.find(m_next); it != m_waiting.end(); it = m_waiting.find(m_next)) {
        const Result<void> appended = append(std::move(it->second));
        m_waiting.erase(it);
        ++m_next;
        if (!appended)
            return appended;
    }
    return {};
}

} // namespace suffuse

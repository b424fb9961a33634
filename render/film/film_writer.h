// Films on their way to disk: numbered frames, an animated WebP, or a video by way of ffmpeg.
#pragma once

#include "render/image_io/image_io.h"

#include <memory>

namespace suffuse {

enum class FilmKind { Frames, WebP, Video };

struct FilmOptions {
    QString path; ///< film/%05d.png, film.webp, film.webm, film.mp4
    std::size_t frames = 1;
    double fps = 25;
    int width = 0, height = 0;
    ImageOptions image;
    bool loops = true; ///< animated WebP: again and again
};

/// By the path: with a number (%d) frames, else by the ending; what is none of these counts as frames.
FilmKind filmKindOf(const QString &path);
/// Empty, or why such a film cannot be made and what to choose instead.
QString problemOf(const FilmOptions &options);
/// The endings of films that are one file.
QStringList filmEndings();

/// Takes a film's frames. Nothing stands at its place before `commit`; destroyed before that, it leaves all as it was.
class FilmWriter {
public:
    virtual ~FilmWriter() = default;
    /// Frame i, from 0, each of them once. Any thread; frames come in order but for those that are in work at once.
    virtual Result<void> write(std::size_t i, const FloatPicture &picture) = 0;
    /// When all frames are written: puts the film into its place.
    virtual Result<void> commit() = 0;
};

Result<std::unique_ptr<FilmWriter>> openFilm(const FilmOptions &options);

} // namespace suffuse

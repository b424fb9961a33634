// Writes films: numbered frames, an animated WebP, or a video by way of ffmpeg.
#pragma once

#include "render/image_io/image_io.h"

#include <memory>

namespace suffuse {

enum class FilmKind { Frames, WebP, Video };

struct FilmOptions {
    QString path; ///< as film/%05d.png, film.webp, film.webm or film.mp4
    std::size_t frames = 1;
    double fps = 25;
    int width = 0, height = 0;
    ImageOptions image;
    bool loops = true; ///< whether an animated WebP repeats
};

/// The kind by the path: frames if it has a number (%d), otherwise by the ending. A path with neither counts as frames.
FilmKind filmKindOf(const QString &path);
/// Empty, or why such a film cannot be made, and what to choose instead.
QString problemOf(const FilmOptions &options);
/// The path of a numbered frame, whose pattern has been found good by `problemOf`.
QString frameName(const QString &pattern, std::size_t number);
/// The endings of films that are one file.
QStringList filmEndings();

/// Takes the frames of a film. Nothing stands in its place before `commit`. If it is destroyed before that, all is as
/// it was.
class FilmWriter {
public:
    virtual ~FilmWriter() = default;
    /// Takes frame i, counted from 0, each of them once. Any thread may call it. Frames come in order, except for those
    /// that are made at the same time.
    virtual Result<void> write(std::size_t i, const FloatPicture &picture) = 0;
    /// Puts the film into its place. To be called when all frames are written.
    virtual Result<void> commit() = 0;
};

Result<std::unique_ptr<FilmWriter>> openFilm(const FilmOptions &options);

} // namespace suffuse

#pragma once

#include "render/film/film_writer.h"

#include <QByteArray>

#include <map>
#include <mutex>

namespace suffuse {

/// Empty, or what is wrong with the name of numbered frames.
QString problemOfFrames(const QString &pattern);
Result<std::unique_ptr<FilmWriter>> openFrames(const FilmOptions &options);
Result<std::unique_ptr<FilmWriter>> openWebP(const FilmOptions &options);
Result<std::unique_ptr<FilmWriter>> openVideo(const FilmOptions &options);

/// Puts frames into order, as pixels of 8 bits with three channels or, with alpha, four.
class OrderedFilm : public FilmWriter {
public:
    explicit OrderedFilm(const FilmOptions &options) : m_options(options) {}
    Result<void> write(std::size_t i, const FloatPicture &picture) override;

protected:
    /// Appends the next frame. One call is made at a time.
    virtual Result<void> append(QByteArray pixels) = 0;
    int channels() const { return m_options.image.alpha ? 4 : 3; }

    const FilmOptions m_options;

private:
    std::mutex m_mutex;
    std::map<std::size_t, QByteArray> m_waiting;
    std::size_t m_next = 0;
};

} // namespace suffuse

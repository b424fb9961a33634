// Films as animated WebP, made by libwebp in the image module.
#include "render/film/film_kinds.h"
#include "render/image_io/file_replacement.h"
#include "render/image_io/image_module.h"

#include <QCoreApplication>

#include <array>
#include <cmath>
#include <limits>

namespace suffuse {

namespace {

constexpr qint64 mostBytes =
    std::numeric_limits<quint32>::max() - (qint64(1) << 20); ///< without the room that frames need around their pixels

class WebPFilm : public OrderedFilm {
public:
    WebPFilm(const FilmOptions &options, const ImageModule &module)
        : OrderedFilm(options), m_module(module), m_file(options.path), m_film{options.width, options.height,
                                                                               channels(),    options.image.quality,
                                                                               options.loops, 0,
                                                                               nullptr}
    {}
    ~WebPFilm() override { m_module.filmEnd(&m_film, nullptr, 0, nullptr, 0); }

    Result<void> open() { return m_file.open(); }

    Result<void> commit() override
    {
        const ImageModuleFile file = moduleFile(m_file);
        if (Result<void> written =
                said(m_module.filmEnd(&m_film, &file, milliseconds(m_shown), m_error.data(), m_error.size()));
            !written && m_file.problem().isEmpty())
            return written;
        return m_file.commit();
    }

protected:
    Result<void> append(QByteArray pixels) override
    {
        const Result<void> added =
            said(m_module.filmAdd(&m_film, reinterpret_cast<const std::uint8_t *>(pixels.constData()),
                                  milliseconds(m_shown++), m_error.data(), m_error.size()));
        if (added && m_film.bytes > mostBytes)
            return Error{QCoreApplication::translate("Film", "%1: the film is too large for WebP. Choose another "
                                                             "format, a smaller size or fewer frames.")
                             .arg(m_options.path)};
        return added;
    }

private:
    Result<void> said(bool done) const
    {
        if (done)
            return {};
        return Error{QCoreApplication::translate("Film", "%1: the film could not be written (%2).")
                         .arg(m_options.path, QString::fromUtf8(m_error.data()).trimmed())};
    }
    qint64 milliseconds(std::size_t frames) const { return std::llround(double(frames) * 1000 / m_options.fps); }

    const ImageModule m_module;
    FileReplacement m_file;
    ImageModuleFilm m_film;
    std::array<char, 512> m_error{};
    std::size_t m_shown = 0; ///< the number of frames so far
};

} // namespace

Result<std::unique_ptr<FilmWriter>> openWebP(const FilmOptions &options)
{
    const Result<ImageModule> &module = writingModule(ImageFormat::WebP, 0);
    if (!module)
        return Error{QCoreApplication::translate("Film", "%1: the film could not be written (%2).")
                         .arg(options.path, module.error())};
    auto film = std::make_unique<WebPFilm>(options, *module);
    if (const Result<void> opened = film->open(); !opened)
        return Error{opened.error()};
    return std::unique_ptr<FilmWriter>(std::move(film));
}

} // namespace suffuse

#include "render/image_io/colour_conversion.h"
#include "render/image_io/file_replacement.h"
#include "render/image_io/image_io.h"
#include "render/image_io/image_module.h"
#include "render/image_io/srgb.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace suffuse {

namespace {

/// Hands out the rows of the picture as the format stores them.
class RowSource {
public:
    RowSource(const PictureRows &picture, const ImageOptions &options, ImageFormat format, ColourConversion colours)
        : m_picture(picture), m_options(options), m_colours(std::move(colours)), m_linear(format == ImageFormat::Exr),
          m_values(std::size_t(picture.width) * channels())
    {}

    int channels() const { return m_options.alpha ? 4 : 3; }
    bool isCancelled() const { return m_cancelled; }
    /// Whether nobody wants the picture any more. It is remembered.
    bool isStopped()
    {
        m_cancelled = m_cancelled || (m_options.cancel && m_options.cancel->load());
        return m_cancelled;
    }

    /// A row of width·channels values, or null once the writing was cancelled.
    const float *row(int y)
    {
        if (isStopped())
            return nullptr;
        const float *from = converted(m_picture.row(y));
        float *to = m_values.data();
        for (int x = 0; x < m_picture.width; ++x, from += 4, to += channels())
            pixel(from, to);
        if (m_options.progress)
            m_options.progress(++m_done, m_picture.height);
        return m_values.data();
    }

private:
    /// The pixels of a row in the colours that are written.
    const float *converted(const float *row)
    {
        if (m_colours.changesNothing())
            return row;
        m_converted.assign(row, row + std::size_t(m_picture.width) * 4);
        m_colours.apply(m_converted.data(), std::size_t(m_picture.width));
        for (float &v : m_converted)
            v = v > 0 ? std::min(v, 1.0f) : 0;
        return m_converted.data();
    }
    void pixel(const float *from, float *to) const
    {
        for (int c = 0; c < 3; ++c)
            to[c] = m_linear ? linearFromSrgb(from[c]) : from[c];
        if (!m_options.alpha)
            return;
        to[3] = from[3];
        if (m_linear) // In OpenEXR colours are associated with alpha.
            for (int c = 0; c < 3; ++c)
                to[c] *= from[3];
    }

    const PictureRows &m_picture;
    const ImageOptions &m_options;
    ColourConversion m_colours;
    bool m_linear;
    bool m_cancelled = false;
    int m_done = 0;
    std::vector<float> m_values, m_converted;
};

/// A file that is an array of bytes.
ImageModuleFile moduleFile(QByteArray &bytes)
{
    ImageModuleFile out{};
    out.context = &bytes;
    out.read = [](void *c, void *to, std::size_t n, std::int64_t at) {
        const QByteArray &file = *static_cast<QByteArray *>(c);
        const std::size_t there = std::min(n, std::size_t(std::max<qsizetype>(0, file.size() - qsizetype(at))));
        std::memcpy(to, file.constData() + (there > 0 ? at : 0), there);
        return there;
    };
    out.write = [](void *c, const void *from, std::size_t n, std::int64_t at) {
        QByteArray &file = *static_cast<QByteArray *>(c);
        const qsizetype before = file.size(), end = qsizetype(at) + qsizetype(n);
        if (end > file.capacity())
            file.reserve(std::max(end, 2 * before)); // There may be many small writes.
        if (end > before)
            file.resize(end);
        if (at > before)
            std::memset(file.data() + before, 0, std::size_t(at - before));
        std::memcpy(file.data() + at, from, n);
        return n;
    };
    out.size = [](void *c) { return std::int64_t(static_cast<QByteArray *>(c)->size()); };
    return out;
}

/// Writes a portable float map: RGB, rows from bottom to top; the sign of the scale tells the byte order.
void writePfm(const ImageModuleFile &file, RowSource &source, int width, int height)
{
    const char *order = std::endian::native == std::endian::little ? "-1.0" : "1.0";
    const QByteArray header =
        "PF\n" + QByteArray::number(width) + ' ' + QByteArray::number(height) + '\n' + order + '\n';
    const auto size = std::size_t(header.size());
    std::int64_t at = std::int64_t(file.write(file.context, header.constData(), size, 0));
    const std::size_t bytes = std::size_t(width) * 3 * sizeof(float);
    bool whole = std::size_t(at) == size;
    for (int y = height - 1; y >= 0 && whole; --y) {
        const float *row = source.row(y);
        if (!row)
            return;
        whole = file.write(file.context, row, bytes, at) == bytes;
        at += std::int64_t(bytes);
    }
}

/// Writes by a module. Returns an empty text, or what the module said.
QString writeThroughModule(const ImageModule &module, const ImageModuleFile &file, RowSource &source,
                           ImageFormat format, const PictureRows &picture, const ImageOptions &options)
{
    ImageModuleWrite job{};
    job.format = imageModuleName(format);
    job.file = file;
    job.width = picture.width;
    job.height = picture.height;
    job.channels = source.channels();
    job.depth = int(options.depth.value_or(usualDepth(format)));
    job.linear = format == ImageFormat::Exr;
    job.associated = format == ImageFormat::Exr;
    job.quality = std::clamp(options.quality, 1, 100);
    job.quick = options.quick;
    job.dpi = hasResolution(format) && options.dpi > 0 ? std::clamp(options.dpi, 1.0, 10'000.0) : 0;
    job.profile = options.profile.isEmpty() ? nullptr : options.profile.constData();
    job.profileSize = std::size_t(options.profile.size());
    job.context = &source;
    job.row = [](void *c, int y) { return static_cast<RowSource *>(c)->row(y); };
    job.stopped = [](void *c) { return static_cast<RowSource *>(c)->isStopped(); };
    std::array<char, 512> error{};
    if (module.write(&job, error.data(), error.size()))
        return {};
    return QString::fromUtf8(error.data()).trimmed();
}

static_assert(int(ImageDepth::Bits8) == ModuleBits8 && int(ImageDepth::Bits16) == ModuleBits16 &&
              int(ImageDepth::Half) == ModuleHalf && int(ImageDepth::Float) == ModuleFloat);

qint64 bytesOf(const PictureRows &picture, const ImageOptions &options, ImageFormat format)
{
    const ImageDepth depth = options.depth.value_or(usualDepth(format));
    const int each = depth == ImageDepth::Bits8 ? 1 : depth == ImageDepth::Float ? 4 : 2;
    return qint64(picture.width) * picture.height * (options.alpha ? 4 : 3) * each;
}

/// A picture that is being written to a file.
struct Writing {
    QString name; ///< used in messages
    ImageFormat format;
    const PictureRows &picture;
    const ImageOptions &options;
    const ImageModule *module = nullptr; ///< null for PFM
    ColourConversion colours{};          ///< to the profile that is asked for

    /// Checks whether the picture can be written at all. It loads the module.
    Result<void> prepare()
    {
        const QString problem = problemOf(format, options, picture.width, picture.height);
        if (!problem.isEmpty())
            return Error{QStringLiteral("%1: %2").arg(name, problem)};
        if (format == ImageFormat::Pfm)
            return {};
        const Result<ImageModule> &found = writingModule(format, bytesOf(picture, options, format));
        if (!found)
            return Error{QCoreApplication::translate("ImageWriter", "%1: cannot write %2: %3.")
                             .arg(name, nameOf(format), found.error())};
        module = &*found;
        if (options.profile.isEmpty())
            return {};
        const Result<ColourConversion> conversion = ColourConversion::between({{}, options.profile, {}});
        if (!conversion)
            return Error{QCoreApplication::translate("ImageWriter",
                                                     "%1: the colour profile cannot be used: %2. Choose another one.")
                             .arg(name, conversion.error())};
        colours = *conversion;
        return {};
    }

    /// `fileProblem` returns what went wrong with the file itself, or an empty text.
    template <typename Problem>
    Result<void> write(const ImageModuleFile &file, const Problem &fileProblem) const
    {
        RowSource source(picture, options, format, colours);
        QString failure;
        if (module)
            failure = writeThroughModule(*module, file, source, format, picture, options);
        else
            writePfm(file, source, picture.width, picture.height);
        if (source.isCancelled())
            return Error{QCoreApplication::translate("ImageWriter", "%1: writing was cancelled; nothing was changed.")
                             .arg(name)};
        if (const QString problem = fileProblem(); !problem.isEmpty())
            return Error{problem};
        if (!failure.isEmpty())
            return Error{QCoreApplication::translate(
                             "ImageWriter", "%1: %2 could not be written (%3). Choose another format or depth.")
                             .arg(name, nameOf(format), failure)};
        return {};
    }
};

} // namespace

Result<void> writeImage(const QString &path, const PictureRows &picture, const ImageOptions &options)
{
    Writing writing{path, imageFormatForPath(path), picture, options};
    if (Result<void> prepared = writing.prepare(); !prepared)
        return prepared;
    FileReplacement file(path);
    if (Result<void> opened = file.open(); !opened)
        return opened;
    if (Result<void> written = writing.write(moduleFile(file), [&file] { return file.problem(); }); !written)
        return written;
    return file.commit();
}

Result<QByteArray> encodeImage(ImageFormat format, const PictureRows &picture, const ImageOptions &options,
                               const QString &name)
{
    Writing writing{name, format, picture, options};
    if (Result<void> prepared = writing.prepare(); !prepared)
        return Error{prepared.error()};
    QByteArray bytes;
    if (Result<void> written = writing.write(moduleFile(bytes), [] { return QString(); }); !written)
        return Error{written.error()};
    return bytes;
}

} // namespace suffuse

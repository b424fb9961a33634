#include "render/image_io/file_replacement.h"
#include "render/image_io/image_io.h"
#include "render/image_io/image_module.h"
#include "render/image_io/srgb.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <bit>

namespace suffuse {

namespace {

/// Hands out the picture's rows as the format stores them.
class RowSource {
public:
    RowSource(const FloatPicture &picture, const ImageOptions &options, ImageFormat format)
        : m_picture(picture), m_options(options), m_linear(format == ImageFormat::Exr),
          m_values(std::size_t(picture.width) * channels())
    {}

    int channels() const { return m_options.alpha ? 4 : 3; }
    bool isCancelled() const { return m_cancelled; }

    /// width·channels values, or null once the writing was cancelled.
    const float *row(int y)
    {
        if (m_options.cancel && m_options.cancel->load()) {
            m_cancelled = true;
            return nullptr;
        }
        const float *from = m_picture.at(0, y);
        float *to = m_values.data();
        for (int x = 0; x < m_picture.width; ++x, from += 4, to += channels())
            pixel(from, to);
        if (m_options.progress)
            m_options.progress(++m_done, m_picture.height);
        return m_values.data();
    }

private:
    void pixel(const float *from, float *to) const
    {
        for (int c = 0; c < 3; ++c)
            to[c] = m_linear ? linearFromSrgb(from[c]) : from[c];
        if (!m_options.alpha)
            return;
        to[3] = from[3];
        if (m_linear) // OpenEXR's colours are associated with alpha
            for (int c = 0; c < 3; ++c)
                to[c] *= from[3];
    }

    const FloatPicture &m_picture;
    const ImageOptions &m_options;
    bool m_linear;
    bool m_cancelled = false;
    int m_done = 0;
    std::vector<float> m_values;
};

/// Portable float map: RGB, rows from bottom to top, the sign of the scale tells the byte order.
void writePfm(FileReplacement &file, RowSource &source, int width, int height)
{
    const char *order = std::endian::native == std::endian::little ? "-1.0" : "1.0";
    const QByteArray header =
        "PF\n" + QByteArray::number(width) + ' ' + QByteArray::number(height) + '\n' + order + '\n';
    std::int64_t at = std::int64_t(file.write(header.constData(), std::size_t(header.size()), 0));
    const std::size_t bytes = std::size_t(width) * 3 * sizeof(float);
    for (int y = height - 1; y >= 0 && file.problem().isEmpty(); --y) {
        const float *row = source.row(y);
        if (!row)
            return;
        at += std::int64_t(file.write(row, bytes, at));
    }
}

/// Empty, or what the module said.
QString writeThroughModule(const ImageModule &module, FileReplacement &file, RowSource &source, ImageFormat format,
                           const FloatPicture &picture, const ImageOptions &options)
{
    ImageModuleWrite job{};
    job.format = imageModuleName(format);
    job.file.context = &file;
    job.file.read = [](void *c, void *to, std::size_t n, std::int64_t at) {
        return static_cast<FileReplacement *>(c)->read(to, n, at);
    };
    job.file.write = [](void *c, const void *from, std::size_t n, std::int64_t at) {
        return static_cast<FileReplacement *>(c)->write(from, n, at);
    };
    job.file.size = [](void *c) { return static_cast<FileReplacement *>(c)->size(); };
    job.width = picture.width;
    job.height = picture.height;
    job.channels = source.channels();
    job.depth = int(options.depth.value_or(usualDepth(format)));
    job.linear = format == ImageFormat::Exr;
    job.associated = format == ImageFormat::Exr;
    job.quality = std::clamp(options.quality, 1, 100);
    job.quick = options.quick;
    job.context = &source;
    job.row = [](void *c, int y) { return static_cast<RowSource *>(c)->row(y); };
    std::array<char, 512> error{};
    if (module.write(&job, error.data(), error.size()))
        return {};
    return QString::fromUtf8(error.data()).trimmed();
}

static_assert(int(ImageDepth::Bits8) == ModuleBits8 && int(ImageDepth::Bits16) == ModuleBits16 &&
              int(ImageDepth::Half) == ModuleHalf && int(ImageDepth::Float) == ModuleFloat);

} // namespace

Result<void> writeImage(const QString &path, const FloatPicture &picture, const ImageOptions &options)
{
    const ImageFormat format = imageFormatForPath(path);
    const QString problem = problemOf(format, options, picture.width, picture.height);
    if (!problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(path, problem)};
    const ImageModule *module = nullptr;
    if (format != ImageFormat::Pfm) {
        if (!imageModule())
            return Error{QCoreApplication::translate("ImageWriter", "%1: cannot write %2: %3.")
                             .arg(path, nameOf(format), imageModule().error())};
        module = &*imageModule();
    }
    FileReplacement file(path);
    if (Result<void> opened = file.open(); !opened)
        return opened;
    RowSource source(picture, options, format);
    QString failure;
    if (module)
        failure = writeThroughModule(*module, file, source, format, picture, options);
    else
        writePfm(file, source, picture.width, picture.height);
    if (source.isCancelled())
        return Error{
            QCoreApplication::translate("ImageWriter", "%1: writing was cancelled; nothing was changed.").arg(path)};
    if (!file.problem().isEmpty())
        return Error{file.problem()};
    if (!failure.isEmpty())
        return Error{QCoreApplication::translate("ImageWriter",
                                                 "%1: %2 could not be written (%3). Choose another format or depth.")
                         .arg(path, nameOf(format), failure)};
    return file.commit();
}

} // namespace suffuse

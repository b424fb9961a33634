// Animated WebP: the container is written here, its pictures are encoded by libwebp through the image module.
#include "render/film/film_kinds.h"
#include "render/image_io/file_replacement.h"
#include "render/image_io/image_module.h"

#include <QCoreApplication>
#include <QtEndian>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace suffuse {

namespace {

constexpr unsigned animated = 0x02, hasAlpha = 0x10;
constexpr unsigned doNotBlend = 0x02;
constexpr qint64 mostBytes = std::numeric_limits<quint32>::max() - 64;

void append24(QByteArray &to, unsigned value)
{
    for (int shift = 0; shift < 24; shift += 8)
        to.append(char(value >> shift & 0xFF));
}

void append32(QByteArray &to, quint32 value)
{
    std::array<char, 4> bytes{};
    qToLittleEndian(value, bytes.data());
    to.append(bytes.data(), 4);
}

QByteArray chunk(const char *name, const QByteArray &payload)
{
    QByteArray bytes(name, 4);
    append32(bytes, quint32(payload.size()));
    bytes += payload;
    if (payload.size() % 2)
        bytes.append('\0');
    return bytes;
}

/// The chunks of a still picture that hold its pixels.
QByteArray pictureChunks(const QByteArray &still)
{
    QByteArray chunks;
    for (qsizetype at = 12; at + 8 <= still.size();) {
        const QByteArray name = still.mid(at, 4);
        const qsizetype size = 8 + qsizetype(qFromLittleEndian<quint32>(still.constData() + at + 4) + 1) / 2 * 2;
        if (name == "VP8 " || name == "VP8L" || name == "ALPH")
            chunks += still.mid(at, size);
        at += size;
    }
    return chunks;
}

/// Part of a picture of 8 bit pixels.
struct Block {
    const QByteArray &pixels;
    int width, channels;
    PixelRect rect;
};

/// What the module asks for and gives while it encodes a block.
struct Encoding {
    const Block &block;
    std::vector<float> row;
    QByteArray bytes;
};

/// Empty where it failed; then `error` says why.
QByteArray encode(const Block &block, int quality, QString &error)
{
    const Result<ImageModule> &module = imageModule();
    if (!module) {
        error = module.error();
        return {};
    }
    Encoding encoding{block, std::vector<float>(std::size_t(block.rect.width) * std::size_t(block.channels)), {}};
    ImageModuleWrite job{};
    job.format = imageModuleName(ImageFormat::WebP);
    job.file.context = job.context = &encoding;
    job.file.write = [](void *c, const void *from, std::size_t n, std::int64_t at) {
        QByteArray &bytes = static_cast<Encoding *>(c)->bytes;
        bytes.resize(std::max(bytes.size(), qsizetype(at) + qsizetype(n)));
        std::memcpy(bytes.data() + at, from, n);
        return n;
    };
    job.width = block.rect.width;
    job.height = block.rect.height;
    job.channels = block.channels;
    job.depth = ModuleBits8;
    job.quality = quality;
    job.row = [](void *c, int y) -> const float * {
        auto &e = *static_cast<Encoding *>(c);
        const auto *from =
            reinterpret_cast<const unsigned char *>(e.block.pixels.constData()) +
            (std::size_t(e.block.rect.y + y) * std::size_t(e.block.width) + std::size_t(e.block.rect.x)) *
                std::size_t(e.block.channels);
        for (float &value : e.row)
            value = float(*from++) / 255;
        return e.row.data();
    };
    std::array<char, 512> message{};
    if (module->write(&job, message.data(), message.size()))
        return pictureChunks(encoding.bytes);
    error = QString::fromUtf8(message.data()).trimmed();
    return {};
}

/// Where two pictures differ, from even to even coordinates, as the container counts; empty: nowhere.
PixelRect difference(const QByteArray &a, const QByteArray &b, int width, int height, int channels)
{
    int left = width, top = height, right = 0, bottom = 0;
    const qsizetype stride = qsizetype(width) * channels;
    for (int y = 0; y < height; ++y) {
        const char *p = a.constData() + y * stride, *q = b.constData() + y * stride;
        if (std::memcmp(p, q, std::size_t(stride)) == 0)
            continue;
        const auto first = std::mismatch(p, p + stride, q).first - p;
        auto last = stride;
        while (p[last - 1] == q[last - 1])
            --last;
        left = std::min(left, int(first / channels));
        right = std::max(right, int((last - 1) / channels) + 1);
        top = std::min(top, y);
        bottom = y + 1;
    }
    if (right <= left)
        return {};
    left &= ~1;
    top &= ~1;
    return {left, top, right - left, bottom - top};
}

class WebPFilm : public OrderedFilm {
public:
    explicit WebPFilm(const FilmOptions &options) : OrderedFilm(options), m_file(options.path) {}

    Result<void> open()
    {
        if (Result<void> opened = m_file.open(); !opened)
            return opened;
        QByteArray extended(1, char(animated | (m_options.image.alpha ? hasAlpha : 0)));
        append24(extended, 0);
        append24(extended, unsigned(m_options.width - 1));
        append24(extended, unsigned(m_options.height - 1));
        QByteArray animation(4, '\0'); // the ground is transparent
        animation.append(m_options.loops ? '\0' : '\1').append('\0');
        put(QByteArray("RIFF\0\0\0\0WEBP", 12) + chunk("VP8X", extended) + chunk("ANIM", animation));
        return {};
    }

    Result<void> commit() override
    {
        flush();
        QByteArray size;
        append32(size, quint32(m_at - 8));
        m_file.write(size.constData(), 4, 4);
        return m_file.commit();
    }

protected:
    /// A frame is what changed, shown until the next one that changes something.
    Result<void> append(QByteArray pixels) override
    {
        PixelRect rect{0, 0, m_options.width, m_options.height};
        if (!m_before.isEmpty())
            rect = difference(m_before, pixels, m_options.width, m_options.height, channels());
        if (rect.width > 0)
            flush();
        ++m_shown;
        if (rect.width == 0)
            return {};
        QString error;
        m_chunks = encode({pixels, m_options.width, channels(), rect}, m_options.image.quality, error);
        if (m_chunks.isEmpty())
            return Error{QCoreApplication::translate("Film", "%1: the film could not be written (%2).")
                             .arg(m_options.path, error)};
        m_rect = rect;
        m_before = std::move(pixels);
        if (m_at + m_chunks.size() > mostBytes)
            return Error{QCoreApplication::translate("Film", "%1: the film is too large for WebP. Choose another "
                                                             "format, a smaller size or fewer frames.")
                             .arg(m_options.path)};
        return m_file.problem().isEmpty() ? Result<void>() : Error{m_file.problem()};
    }

private:
    void put(const QByteArray &bytes)
    {
        m_at += qint64(m_file.write(bytes.constData(), std::size_t(bytes.size()), m_at));
    }

    /// Writes the frame that waits for its duration.
    void flush()
    {
        if (m_chunks.isEmpty())
            return;
        QByteArray frame;
        append24(frame, unsigned(m_rect.x / 2));
        append24(frame, unsigned(m_rect.y / 2));
        append24(frame, unsigned(m_rect.width - 1));
        append24(frame, unsigned(m_rect.height - 1));
        append24(frame, unsigned(std::min<qint64>(milliseconds(m_shown) - milliseconds(m_begun), 0xFFFFFF)));
        frame.append(char(doNotBlend));
        put(chunk("ANMF", frame + m_chunks));
        m_begun = m_shown;
        m_chunks.clear();
    }
    qint64 milliseconds(std::size_t frames) const { return std::llround(double(frames) * 1000 / m_options.fps); }

    FileReplacement m_file;
    qint64 m_at = 0;
    QByteArray m_before; ///< the picture before
    QByteArray m_chunks; ///< of the frame that waits
    PixelRect m_rect;
    std::size_t m_begun = 0; ///< frames before the one that waits
    std::size_t m_shown = 0; ///< frames so far
};

} // namespace

Result<std::unique_ptr<FilmWriter>> openWebP(const FilmOptions &options)
{
    auto film = std::make_unique<WebPFilm>(options);
    if (const Result<void> opened = film->open(); !opened)
        return Error{opened.error()};
    return std::unique_ptr<FilmWriter>(std::move(film));
}

} // namespace suffuse

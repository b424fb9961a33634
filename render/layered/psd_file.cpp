#include "render/layered/psd_file.h"

#include "model/formats/psd/pack_bits.h"
#include "render/image_io/file_replacement.h"
#include "render/image_io/image_io.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <vector>

namespace suffuse {

namespace {

constexpr std::int64_t mostFileBytes = std::numeric_limits<std::int32_t>::max();

/// The four letters of a mode.
const char *keyOf(BlendMode mode)
{
    switch (mode) {
    case BlendMode::Multiply:
        return "mul ";
    case BlendMode::Screen:
        return "scrn";
    case BlendMode::Overlay:
        return "over";
    case BlendMode::Darken:
        return "dark";
    case BlendMode::Lighten:
        return "lite";
    case BlendMode::HardLight:
        return "hLit";
    case BlendMode::Difference:
        return "diff";
    default: // Only modes that are put alike everywhere are planned (isPutAlike).
        return "norm";
    }
}

/// Big-endian numbers, as all of the file has them.
class Numbers {
public:
    Numbers() { m_stream.setByteOrder(QDataStream::BigEndian); }
    Numbers(const Numbers &) = delete;
    Numbers &operator=(const Numbers &) = delete;

    template <class T>
    Numbers &operator<<(T number)
    {
        m_stream << number;
        return *this;
    }
    Numbers &letters(const char *four)
    {
        m_stream.writeRawData(four, 4);
        return *this;
    }
    Numbers &raw(const QByteArray &bytes)
    {
        m_stream.writeRawData(bytes.constData(), int(bytes.size()));
        return *this;
    }
    const QByteArray &bytes() const { return m_bytes; }

private:
    QByteArray m_bytes;
    QDataStream m_stream{&m_bytes, QIODevice::WriteOnly};
};

/// A block of a layer that has a key: the name in Unicode, and so on. Its size is even.
void addBlock(Numbers &to, const char *key, const QByteArray &content)
{
    to.letters("8BIM").letters(key) << quint32((content.size() + 1) / 2 * 2);
    to.raw(content);
    if (content.size() % 2 != 0)
        to << quint8(0);
}

/// Writes bytes one after another.
class Appender {
public:
    explicit Appender(FileReplacement &file) : m_file(file) {}

    void add(const QByteArray &bytes)
    {
        m_at += std::int64_t(m_file.write(bytes.constData(), std::size_t(bytes.size()), m_at));
    }
    std::int64_t at() const { return m_at; }
    /// The bytes of another file, from its start.
    void add(const FileReplacement &from, std::int64_t bytes)
    {
        QByteArray part(qsizetype(1) << 20, Qt::Uninitialized);
        for (std::int64_t done = 0; done < bytes;) {
            const std::size_t step = std::size_t(std::min<std::int64_t>(part.size(), bytes - done));
            const std::size_t there = from.read(part.data(), step, done);
            if (there == 0)
                break;
            add(part.left(qsizetype(there)));
            done += std::int64_t(there);
        }
    }

private:
    FileReplacement &m_file;
    std::int64_t m_at = 0;
};

/// A channel of pixels, packed: the number of bytes of each row, then the rows.
struct PackedChannel {
    QByteArray counts, rows;

    PackedChannel(const LevelPixels &pixels, int channel)
    {
        const auto width = std::size_t(pixels.rect.width);
        const std::size_t bytes = width * std::size_t(pixels.bits / 8);
        std::vector<std::uint8_t> row(bytes);
        Numbers sizes;
        for (int y = 0; y < pixels.rect.height; ++y) {
            const std::size_t from = std::size_t(y) * pixels.stride + std::size_t(channel);
            for (std::size_t x = 0; x < width; ++x) {
                const std::size_t i = from + x * std::size_t(pixels.channels);
                if (pixels.bits == 8)
                    row[x] = static_cast<const std::uint8_t *>(pixels.row0)[i];
                else
                    qToBigEndian(static_cast<const std::uint16_t *>(pixels.row0)[i], row.data() + 2 * x);
            }
            const qsizetype before = rows.size();
            packBits(row.data(), bytes, rows);
            sizes << quint16(rows.size() - before);
        }
        counts = sizes.bytes();
    }
    qsizetype size() const { return counts.size() + rows.size(); }
};

constexpr quint16 packed = 1;             ///< the code of PackBits
constexpr quint16 profileResource = 1039; ///< without it Krita takes 16 bits for linear light

/// Keeps the layers' packed pixels in a file beside the target: their sizes stand before them all.
class PsdSink : public LayerSink {
public:
    PsdSink(FileReplacement &file, FileReplacement &pixels, const LayeredRequest &request, QByteArray profile,
            QString name)
        : m_file(file), m_pixelFile(pixels), m_pixels(pixels), m_request(request), m_profile(std::move(profile)),
          m_name(std::move(name))
    {}

    Result<void> beginFolder(const PlannedLayer &folder) override
    {
        m_folders.push_back(folder);
        PlannedLayer end;
        end.name = QStringLiteral("</Layer group>");
        addRecord(end, {0, 0, 0, 0}, Divider::End, "norm");
        return {};
    }
    Result<void> endFolder() override
    {
        addRecord(m_folders.back(), {0, 0, 0, 0}, Divider::Open, "pass");
        m_folders.pop_back();
        return {};
    }
    Result<void> layer(const PlannedLayer &layer, const LevelPixels &pixels) override
    {
        std::array<quint32, 4> sizes{};
        for (int i = 0; i < 4; ++i) { // the opacity first
            if (isStopped())
                return stopped();
            const PackedChannel channel(pixels, (i + 3) % 4);
            m_pixels.add(Numbers().operator<<(packed).bytes() + channel.counts);
            m_pixels.add(channel.rows);
            sizes[std::size_t(i)] = quint32(2 + channel.size());
        }
        addRecord(layer, pixels.rect, Divider::None, keyOf(layer.blend), sizes);
        return m_pixels.at() > mostFileBytes ? tooLarge() : state(m_pixelFile);
    }
    Result<void> picture(const LevelPixels &pixels) override
    {
        Numbers head;
        head.letters("8BPS") << quint16(1);
        head.raw(QByteArray(6, '\0'));
        head << quint16(3) << quint32(pixels.rect.height) << quint32(pixels.rect.width) << quint16(pixels.bits);
        head << quint16(3) << quint32(0); // RGB, without a palette
        Numbers resources;
        resources.letters("8BIM") << quint16(profileResource) << quint16(0) << quint32(m_profile.size());
        resources.raw(m_profile);
        if (m_profile.size() % 2 != 0)
            resources << quint8(0);
        head << quint32(resources.bytes().size());
        head.raw(resources.bytes());
        Appender out(m_file);
        out.add(head.bytes());

        // In 8 bits the layers stand in the section's first part, in 16 bits in a block of their own at its end.
        const bool inBlock = pixels.bits == 16;
        const std::int64_t records = 2 + m_records.bytes().size() + m_pixels.at();
        const std::int64_t padding = -records & 3, layers = records + padding;
        if (layers + 64 > mostFileBytes)
            return tooLarge();
        Numbers section;
        if (inBlock) {
            section << quint32(layers + 20) << quint32(0) << quint32(0);
            section.letters("8BIM").letters("Lr16") << quint32(layers);
        } else {
            section << quint32(layers + 8) << quint32(layers);
        }
        section << qint16(m_count);
        out.add(section.bytes());
        out.add(m_records.bytes());
        out.add(m_pixelFile, m_pixels.at());
        out.add(QByteArray(qsizetype(padding) + (inBlock ? 0 : 4), '\0')); // and no mask of all layers

        QByteArray counts = Numbers().operator<<(packed).bytes(), rows;
        const std::int64_t from = out.at();
        for (int c = 0; c < 3; ++c)
            counts += QByteArray(2 * pixels.rect.height, '\0');
        out.add(counts); // takes the place of what is known when the rows are packed
        counts.truncate(2);
        for (int c = 0; c < 3; ++c) {
            if (isStopped())
                return stopped();
            const PackedChannel channel(pixels, c);
            counts += channel.counts;
            out.add(channel.rows);
        }
        m_file.write(counts.constData(), std::size_t(counts.size()), from);
        return out.at() > mostFileBytes ? tooLarge() : state(m_file);
    }

private:
    enum class Divider : quint32 { None = 0, Open = 1, End = 3 };

    void addRecord(const PlannedLayer &layer, const PixelRect &rect, Divider divider, const char *mode,
                   const std::array<quint32, 4> &sizes = {2, 2, 2, 2})
    {
        const QString &name = layer.name;
        ++m_count;
        m_records << qint32(rect.y) << qint32(rect.x) << qint32(rect.y + rect.height) << qint32(rect.x + rect.width);
        m_records << quint16(4);
        for (int i = 0; i < 4; ++i)
            m_records << qint16(i - 1) << sizes[std::size_t(i)];
        constexpr quint8 hidden = 2, hasAppearance = 8, noAppearance = 16;
        const quint8 flags = quint8((layer.visible ? 0 : hidden) | hasAppearance);
        m_records.letters("8BIM").letters(mode)
            << quint8(std::lround(layer.opacity * 255)) << quint8(0)
            << quint8(divider == Divider::None ? flags : flags | noAppearance) << quint8(0);
        Numbers extra;
        extra << quint32(0) << quint32(0); // no mask, no ranges
        QByteArray shortName = name.toLatin1().left(255);
        extra << quint8(shortName.size());
        shortName += QByteArray((4 - (shortName.size() + 1) % 4) % 4, '\0');
        extra.raw(shortName);
        Numbers unicode;
        unicode << quint32(name.size());
        for (const QChar letter : name)
            unicode << quint16(letter.unicode());
        addBlock(extra, "luni", unicode.bytes());
        if (layer.locked) {
            constexpr quint32 all = 0x80000000;
            addBlock(extra, "lspf", Numbers().operator<<(all).bytes());
        }
        if (divider != Divider::None) {
            Numbers section;
            section << quint32(divider);
            section.letters("8BIM").letters(mode);
            addBlock(extra, "lsct", section.bytes());
            for (int i = 0; i < 4; ++i) // A folder has no pixels: each channel is empty, and not packed.
                m_pixels.add(QByteArray(2, '\0'));
        }
        m_records << quint32(extra.bytes().size());
        m_records.raw(extra.bytes());
    }

    bool isStopped() const { return m_request.cancel && *m_request.cancel; }
    static Error stopped() { return {QCoreApplication::translate("LayeredFile", "stopped; nothing was written")}; }
    Error tooLarge() const
    {
        return {QCoreApplication::translate("LayeredFile",
                                            "%1: Photoshop files have at most 2 GB. Choose a smaller size, "
                                            "or OpenRaster.")
                    .arg(m_name)};
    }
    static Result<void> state(const FileReplacement &file)
    {
        const QString problem = file.problem();
        return problem.isEmpty() ? Result<void>() : Result<void>(Error{problem});
    }

    FileReplacement &m_file, &m_pixelFile;
    Appender m_pixels;
    const LayeredRequest &m_request;
    QByteArray m_profile;
    QString m_name;
    Numbers m_records; ///< of the layers so far, the lowest one first
    int m_count = 0;
    std::vector<PlannedLayer> m_folders; ///< that have begun
};

} // namespace

Result<LayeredStats> writePsd(const QString &path, const LayeredRequest &request, Renderer &renderer, Renderer &groups)
{
    if (std::max(request.view.width, request.view.height) > largestPsdSide)
        return Error{QCoreApplication::translate("LayeredFile",
                                                 "%1: Photoshop files have at most %2 pixels a side. Choose "
                                                 "a smaller size, or OpenRaster.")
                         .arg(path)
                         .arg(largestPsdSide)};
    const Result<QByteArray> profile = srgbIccProfile();
    if (!profile)
        return Error{profile.error()};
    FileReplacement file(path), pixels(path); // The second one is never put into the target's place.
    for (FileReplacement *each : {&file, &pixels})
        if (const Result<void> opened = each->open(); !opened)
            return Error{opened.error()};
    PsdSink sink(file, pixels, request, *profile, path);
    LayeredRequest whole = request;
    whole.wholeOpacities = true;
    const Result<LayeredStats> stats = drawLayers(whole, renderer, groups, sink);
    if (!stats)
        return Error{stats.error()};
    if (const Result<void> committed = file.commit(); !committed)
        return Error{committed.error()};
    return stats;
}

} // namespace suffuse

#include "render/layered/ora_file.h"

#include "model/formats/files.h"
#include "model/formats/ora/composite_op.h"
#include "model/formats/ora/ora_parts.h"
#include "render/image_io/image_io.h"
#include "render/layered/zip_writer.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QXmlStreamWriter>

namespace suffuse {

namespace {

/// A picture no larger than 256 pixels a side: means of those of the whole picture.
FloatPicture thumbnailOf(const LevelPixels &picture)
{
    constexpr int most = 256;
    const int width = picture.rect.width, height = picture.rect.height, longer = std::max(width, height);
    const double scale = longer > most ? double(most) / longer : 1;
    FloatPicture out;
    out.resize(std::max(1, int(width * scale)), std::max(1, int(height * scale)));
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int left = int(qint64(x) * width / out.width), right = int(qint64(x + 1) * width / out.width);
            const int top = int(qint64(y) * height / out.height), bottom = int(qint64(y + 1) * height / out.height);
            float *to = out.rgba.data() + (std::size_t(y) * std::size_t(out.width) + std::size_t(x)) * 4;
            for (int c = 0; c < 3; ++c) {
                double sum = 0;
                for (int j = top; j < std::max(bottom, top + 1); ++j)
                    for (int i = left; i < std::max(right, left + 1); ++i)
                        sum += double(picture.at(i, j, c));
                to[c] = float(sum / (std::max(bottom - top, 1) * std::max(right - left, 1)));
            }
            to[3] = 1;
        }
    return out;
}

/// Writes the parts as they come, and the stack in the end, which begins with the topmost layer.
class OraSink : public LayerSink {
public:
    OraSink(ZipWriter &zip, const LayeredRequest &request, QString name)
        : m_zip(zip), m_request(request), m_name(std::move(name))
    {
        m_open.emplace_back();
    }

    Result<void> begin() { return m_zip.add(QStringLiteral("mimetype"), ora::mimeType, false); }

    Result<void> beginFolder(const PlannedLayer &folder) override
    {
        m_open.push_back({folder.name, folder.locked, {}});
        return {};
    }
    Result<void> endFolder() override
    {
        Folder folder = std::move(m_open.back());
        m_open.pop_back();
        if (folder.entries.empty())
            return {};
        Entry entry;
        entry.name = folder.name;
        entry.locked = folder.locked;
        entry.within = std::move(folder.entries);
        m_open.back().entries.push_back(std::move(entry));
        return {};
    }
    Result<void> layer(const PlannedLayer &layer, const LevelPixels &pixels) override
    {
        Entry entry;
        entry.name = layer.name;
        entry.source = QStringLiteral("data/layer%1.png").arg(m_count++);
        entry.place = pixels.rect;
        entry.opacity = layer.opacity;
        entry.blend = layer.blend;
        entry.visible = layer.visible;
        entry.locked = layer.locked;
        const QString source = entry.source;
        m_open.back().entries.push_back(std::move(entry));
        const Result<QByteArray> png = encode(pixels, source);
        return png ? m_zip.add(source, *png, false) : Result<void>(Error{png.error()});
    }
    Result<void> picture(const LevelPixels &pixels) override
    {
        const Result<QByteArray> merged = encode(pixels, QStringLiteral("mergedimage.png"));
        if (!merged)
            return Error{merged.error()};
        if (Result<void> added = m_zip.add(QStringLiteral("mergedimage.png"), *merged, false); !added)
            return added;
        ImageOptions options;
        options.quick = true;
        const Result<QByteArray> thumbnail =
            encodeImage(ImageFormat::Png, thumbnailOf(pixels), options, QStringLiteral("thumbnail.png"));
        if (!thumbnail)
            return Error{thumbnail.error()};
        if (Result<void> added = m_zip.add(QStringLiteral("Thumbnails/thumbnail.png"), *thumbnail, false); !added)
            return added;
        if (Result<void> added = m_zip.add(ora::stackPart, stack(pixels.rect), true); !added)
            return added;
        if (Result<void> added = m_zip.add(ora::paintingPart, writeSuffuseFile(*m_request.painting), false); !added)
            return added;
        return m_zip.add(ora::pictureHashPart, ora::hashOfPicture(*merged), false);
    }

private:
    struct Entry {
        QString name, source;
        PixelRect place{0, 0, 0, 0};
        float opacity = 1;
        BlendMode blend = BlendMode::Normal;
        bool visible = true, locked = false;
        std::vector<Entry> within; ///< of a folder
    };
    struct Folder {
        QString name;
        bool locked = false;
        std::vector<Entry> entries;
    };

    Result<QByteArray> encode(const LevelPixels &pixels, const QString &part) const
    {
        std::vector<float> row(std::size_t(pixels.rect.width) * 4, 1.0f);
        const PictureRows rows(pixels.rect.width, pixels.rect.height, [&](int y) {
            for (int x = 0; x < pixels.rect.width; ++x)
                for (int c = 0; c < pixels.channels; ++c)
                    row[std::size_t(x) * 4 + std::size_t(c)] = pixels.at(x, y, c);
            return row.data();
        });
        ImageOptions options;
        options.depth = pixels.bits == 8 ? ImageDepth::Bits8 : ImageDepth::Bits16;
        options.alpha = pixels.channels == 4;
        options.quick = true;
        options.cancel = m_request.cancel;
        return encodeImage(ImageFormat::Png, rows, options, QStringLiteral("%1 (%2)").arg(m_name, part));
    }

    QByteArray stack(const PixelRect &picture) const
    {
        QByteArray out;
        QXmlStreamWriter xml(&out);
        xml.setAutoFormatting(true);
        xml.writeStartDocument();
        xml.writeStartElement(QStringLiteral("image"));
        xml.writeAttribute(QStringLiteral("version"), QStringLiteral("0.0.5"));
        xml.writeAttribute(QStringLiteral("w"), QString::number(picture.width));
        xml.writeAttribute(QStringLiteral("h"), QString::number(picture.height));
        xml.writeStartElement(QStringLiteral("stack"));
        write(xml, m_open.front().entries);
        xml.writeEndElement();
        xml.writeEndElement();
        xml.writeEndDocument();
        return out;
    }

    static void write(QXmlStreamWriter &xml, const std::vector<Entry> &entries)
    {
        for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
            const bool isFolder = entry->source.isEmpty();
            xml.writeStartElement(isFolder ? QStringLiteral("stack") : QStringLiteral("layer"));
            xml.writeAttribute(QStringLiteral("name"), entry->name);
            xml.writeAttribute(QStringLiteral("visibility"),
                               entry->visible ? QStringLiteral("visible") : QStringLiteral("hidden"));
            if (entry->locked)
                xml.writeAttribute(QStringLiteral("edit-locked"), QStringLiteral("true"));
            xml.writeAttribute(QStringLiteral("opacity"), QString::number(double(entry->opacity)));
            xml.writeAttribute(QStringLiteral("composite-op"), ora::compositeOp(entry->blend));
            if (isFolder) {
                xml.writeAttribute(QStringLiteral("isolation"), QStringLiteral("auto"));
                write(xml, entry->within);
            } else {
                xml.writeAttribute(QStringLiteral("src"), entry->source);
                xml.writeAttribute(QStringLiteral("x"), QString::number(entry->place.x));
                xml.writeAttribute(QStringLiteral("y"), QString::number(entry->place.y));
            }
            xml.writeEndElement();
        }
    }

    ZipWriter &m_zip;
    const LayeredRequest &m_request;
    QString m_name;
    std::vector<Folder> m_open; ///< the stack itself, and the folders that have begun
    int m_count = 0;
};

} // namespace

Result<LayeredStats> writeOpenRaster(const QString &path, const LayeredRequest &request, Renderer &renderer,
                                     Renderer &groups)
{
    FileReplacement file(path);
    if (const Result<void> opened = file.open(); !opened)
        return Error{opened.error()};
    ZipWriter zip(file);
    OraSink sink(zip, request, path);
    if (const Result<void> begun = sink.begin(); !begun)
        return Error{begun.error()};
    const Result<LayeredStats> stats = drawLayers(request, renderer, groups, sink);
    if (!stats)
        return Error{stats.error()};
    if (const Result<void> finished = zip.finish(); !finished)
        return Error{finished.error()};
    if (const Result<void> committed = file.commit(); !committed)
        return Error{committed.error()};
    return stats;
}

} // namespace suffuse

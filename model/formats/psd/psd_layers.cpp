#include "model/formats/psd/psd_layers.h"

#include "model/formats/messages.h"
#include "model/formats/psd/planar_tiff.h"
#include "model/formats/psd/psd_channels.h"
#include "model/shaping/picture_stroke.h"

#include <QtEndian>

#include <algorithm>
#include <array>
#include <map>

namespace suffuse::psd {

namespace {

constexpr qsizetype headBytes = 26;
constexpr std::array blendKeys{std::pair{"norm", BlendMode::Normal},      std::pair{"mul ", BlendMode::Multiply},
                               std::pair{"scrn", BlendMode::Screen},      std::pair{"over", BlendMode::Overlay},
                               std::pair{"dark", BlendMode::Darken},      std::pair{"lite", BlendMode::Lighten},
                               std::pair{"div ", BlendMode::ColourDodge}, std::pair{"idiv", BlendMode::ColourBurn},
                               std::pair{"hLit", BlendMode::HardLight},   std::pair{"sLit", BlendMode::SoftLight},
                               std::pair{"diff", BlendMode::Difference},  std::pair{"smud", BlendMode::Exclusion},
                               std::pair{"hue ", BlendMode::Hue},         std::pair{"sat ", BlendMode::Saturation},
                               std::pair{"colr", BlendMode::Colour},      std::pair{"lum ", BlendMode::Luminosity},
                               std::pair{"lddg", BlendMode::Plus},        std::pair{"pass", BlendMode::Normal}};
/// Keys of what computes its pixels from those below, or fills all of the canvas.
constexpr std::array computedKeys{"brit", "levl", "curv", "expA", "hue2", "hue ", "blnc", "mixr", "clrL", "nvrt",
                                  "post", "thrs", "selc", "grdm", "vibA", "phfl", "blwh", "SoCo", "GdFl", "PtFl"};
constexpr std::array effectKeys{"lfx2", "lrFX", "lmfx"};

template <class List>
bool isAmong(const List &keys, const QByteArray &key)
{
    return std::ranges::any_of(keys, [&](const char *each) { return key == each; });
}

Error damaged()
{
    return {FileMessages::tr("This Photoshop file is damaged.")};
}

struct PixelArea {
    int top = 0, left = 0, bottom = 0, right = 0;

    int width() const { return right - left; }
    int height() const { return bottom - top; }
    bool isEmpty() const { return right <= left || bottom <= top; }
    /// Whether it is one that paintings take.
    bool fits() const
    {
        const auto near = [](int at) { return std::abs(double(at)) <= 1e6; };
        return near(top) && near(left) && near(bottom) && near(right) && width() <= Picture::mostSide &&
               height() <= Picture::mostSide && std::uint64_t(width()) * std::uint64_t(height()) <= Picture::mostPixels;
    }
};

PixelArea areaFrom(Cursor &from)
{
    PixelArea area;
    area.top = from.i32(), area.left = from.i32(), area.bottom = from.i32(), area.right = from.i32();
    return area;
}

/// What begins and ends the layers of a group, from the lowest one on.
enum class Divider : quint32 { None = 0, Open = 1, Closed = 2, End = 3 };

struct Record {
    PixelArea area;
    std::vector<std::pair<int, quint32>> channels; ///< their ids, and their sizes in bytes
    QByteArray mode;
    int opacity = 255;
    bool clips = false, visible = true, locked = false;
    QString name;
    Divider divider = Divider::None;
    PixelArea maskArea;
    int maskOutside = 255; ///< what the mask is beyond its area
    bool hasMask = false;
    bool isComputed = false, hasEffects = false;
    std::map<int, QByteArray> stored; ///< the channels' pixels as the file has them
};

class LayersReader {
public:
    explicit LayersReader(const QByteArray &bytes) : m_file(bytes) {}

    Result<Painting> read()
    {
        m_file.skip(4);
        if (m_file.u16() != 1)
            return Error{
                FileMessages::tr("Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.")};
        m_file.skip(6);
        m_channels = m_file.u16();
        m_height = int(m_file.u32()), m_width = int(m_file.u32());
        m_bits = m_file.u16();
        const int mode = m_file.u16();
        if (!m_file.ok() || !PixelArea{0, 0, m_height, m_width}.fits() || m_width < 1 || m_height < 1)
            return damaged();
        constexpr int grey = 1, rgb = 3;
        if ((mode != grey && mode != rgb) || (m_bits != 8 && m_bits != 16))
            return Error{
                FileMessages::tr("Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.")};
        m_colours = mode == grey ? 1 : 3;
        m_painting.canvas.width = m_width, m_painting.canvas.height = m_height;
        m_painting.canvas.background.opacity = 0; // The file's own lowest layer is its background.
        m_file.skip(m_file.u32());                // a palette
        m_profile = profileIn(m_file.take(m_file.u32()));
        const QByteArray layers = layersOf(m_file.take(m_file.u32()));
        if (!m_file.ok())
            return damaged();
        if (layers.isEmpty() ? !takeMerged() : !takeLayers(layers))
            return damaged();
        return std::move(m_painting);
    }

    QString leftOut() const
    {
        return leftOutSentence({
            {m_missing,
             FileMessages::tr("%n layer(s) whose picture is missing, damaged or too large", nullptr, m_missing)},
            {m_modes, FileMessages::tr("the mode(s) of %n layer(s)", nullptr, m_modes)},
            {m_computed, FileMessages::tr("%n adjustment or fill layer(s)", nullptr, m_computed)},
            {m_effects, FileMessages::tr("the effects of %n layer(s)", nullptr, m_effects)},
            {m_masks, FileMessages::tr("the mask(s) of %n group(s)", nullptr, m_masks)},
        });
    }

private:
    static constexpr std::size_t deepest = 64;
    static constexpr int mostLayers = 1 << 14;

    /// The ICC profile among the file's resources; empty if there is none. Each layer becomes an image that has it, so
    /// a very large one is left out.
    static QByteArray profileIn(const QByteArray &resources)
    {
        constexpr int profileId = 1039;
        constexpr qsizetype most = 1 << 20;
        Cursor cursor(resources);
        while (cursor.ok() && cursor.left() >= 12) {
            cursor.skip(4);
            const int id = cursor.u16(), name = cursor.u8();
            cursor.skip(name + (name + 1) % 2);
            const QByteArray content = cursor.take(cursor.u32());
            if (id == profileId && cursor.ok())
                return content.size() <= most ? content : QByteArray();
            cursor.skip(std::min<qsizetype>(content.size() % 2, cursor.left()));
        }
        return {};
    }

    /// The number of layers, their records and their pixels: the first part of the section, or, of 16 bits, a block
    /// behind it. Empty if there are none.
    static QByteArray layersOf(const QByteArray &section)
    {
        Cursor cursor(section);
        const QByteArray first = cursor.take(cursor.u32());
        if (first.size() > 2)
            return first;
        cursor.skip(cursor.u32()); // a mask of all layers
        while (cursor.ok() && cursor.left() >= 12) {
            cursor.skip(4);
            const QByteArray key = cursor.take(4), content = cursor.take(cursor.u32());
            if (key == "Lr16" || key == "Layr")
                return content;
            cursor.skip(std::min<qsizetype>(-content.size() & 3, cursor.left()));
        }
        return {};
    }

    bool takeLayers(const QByteArray &bytes)
    {
        Cursor cursor(bytes);
        const int count =
            std::abs(int(cursor.i16())); // A negative number says something of the merged picture's alpha.
        if (count > mostLayers)
            return false;
        std::vector<Record> records;
        for (int i = 0; i < count && cursor.ok(); ++i)
            records.push_back(recordFrom(cursor));
        for (Record &record : records)
            for (const auto &[id, size] : record.channels)
                record.stored[id] = cursor.take(size);
        if (!cursor.ok())
            return false;
        for (const Record &record : records)
            if (!take(record))
                return false;
        return m_open.empty();
    }

    static Record recordFrom(Cursor &cursor)
    {
        Record record;
        record.area = areaFrom(cursor);
        const int channels = cursor.u16();
        for (int i = 0; i < channels && cursor.ok(); ++i) {
            const int id = cursor.i16();
            record.channels.emplace_back(id, cursor.u32());
        }
        cursor.skip(4);
        record.mode = cursor.take(4);
        record.opacity = cursor.u8();
        record.clips = cursor.u8() != 0;
        constexpr int hidden = 2;
        record.visible = !(cursor.u8() & hidden);
        cursor.skip(1);
        readExtra(cursor.take(cursor.u32()), record);
        return record;
    }

    static void readExtra(const QByteArray &bytes, Record &record)
    {
        Cursor cursor(bytes);
        if (const QByteArray mask = cursor.take(cursor.u32()); mask.size() >= 18) {
            Cursor from(mask);
            record.maskArea = areaFrom(from);
            record.maskOutside = from.u8();
            constexpr int off = 2;
            record.hasMask = !(from.u8() & off);
        }
        cursor.skip(cursor.u32()); // ranges of blending
        const int letters = cursor.u8();
        record.name = QString::fromLatin1(cursor.take(letters));
        cursor.skip((4 - (letters + 1) % 4) % 4);
        while (cursor.ok() && cursor.left() >= 12) {
            cursor.skip(4);
            const QByteArray key = cursor.take(4), content = cursor.take(cursor.u32());
            cursor.skip(std::min<qsizetype>(content.size() % 2, cursor.left()));
            readBlock(key, content, record);
        }
    }

    static void readBlock(const QByteArray &key, const QByteArray &content, Record &record)
    {
        Cursor cursor(content);
        if (key == "luni") {
            QString name;
            for (quint32 left = cursor.u32(); left > 0 && cursor.left() >= 2; --left)
                name += QChar(cursor.u16());
            record.name = name.remove(QChar(0));
        } else if (key == "lspf") { // what is locked: pixels, or all
            constexpr quint32 pixels = 2, all = 0x80000000;
            record.locked = cursor.u32() & (pixels | all);
        } else if (key == "lsct" || key == "lsdk") {
            record.divider = Divider(std::min(cursor.u32(), quint32(Divider::End)));
            cursor.skip(4);
            if (const QByteArray mode = cursor.take(4); cursor.ok())
                record.mode = mode;
        } else {
            record.isComputed |= isAmong(computedKeys, key);
            record.hasEffects |= isAmong(effectKeys, key);
        }
    }

    /// Takes what a record stands for. Returns false if it ends a group that has not begun, or too many have.
    bool take(const Record &record)
    {
        if (record.divider == Divider::End) {
            m_painting.groups.push_back({});
            m_painting.groups.back().id = GroupId(m_painting.groups.size());
            m_painting.groups.back().parent = m_open.empty() ? 0 : m_open.back();
            m_open.push_back(m_painting.groups.back().id);
            return m_open.size() <= deepest;
        }
        if (record.divider != Divider::None) {
            if (m_open.empty())
                return false;
            Group &group = m_painting.groups[m_open.back() - 1];
            m_open.pop_back();
            describe(group, record);
            group.isolated = record.mode != "pass";
            m_masks += record.hasMask;
            return true;
        }
        m_effects += record.hasEffects;
        if (record.area.isEmpty()) {
            m_computed += record.isComputed;
            return true;
        }
        const std::optional<QByteArray> tiff = record.area.fits() ? imageOf(record) : std::nullopt;
        if (tiff)
            add(record, *tiff);
        m_missing += !tiff;
        return true;
    }

    void describe(Group &group, const Record &record)
    {
        const auto known = std::ranges::find_if(blendKeys, [&](const auto &each) { return record.mode == each.first; });
        m_modes += known == blendKeys.end();
        group.blend = known == blendKeys.end() ? BlendMode::Normal : known->second;
        group.name = record.name;
        group.visible = record.visible;
        group.locked = record.locked;
        group.clips = record.clips;
        group.opacity = float(record.opacity) / 255;
    }

    void add(const Record &record, const QByteArray &tiff)
    {
        Group group;
        group.id = GroupId(m_painting.groups.size() + 1);
        group.parent = m_open.empty() ? 0 : m_open.back();
        describe(group, record);
        group.isolated = true;
        m_painting.groups.push_back(group);
        const PixelArea &area = record.area;
        const Picture picture = embeddedPicture(std::make_shared<const QByteArray>(tiff), area.width(), area.height());
        Stroke stroke = pictureStroke(picture, Rect::of(area.left, area.top, area.width(), area.height()), 0);
        stroke.id = StrokeId(m_painting.strokes.size() + 1);
        stroke.group = group.id;
        m_painting.strokes.push_back(std::make_shared<const Stroke>(std::move(stroke)));
    }

    /// The picture of a layer, with its mask applied.
    std::optional<QByteArray> imageOf(const Record &record) const
    {
        constexpr int alpha = -1, mask = -2;
        const ChannelShape shape{record.area.width(), record.area.height(), m_bits};
        PlanarImage image{shape.width, shape.height, m_bits, m_profile, {}};
        for (int id = 0; id < m_colours; ++id) {
            const auto stored = record.stored.find(id);
            const std::optional<PackedRows> rows =
                stored == record.stored.end() ? std::nullopt : packedRows(stored->second, shape);
            if (!rows)
                return {};
            image.channels.push_back(*rows);
        }
        std::optional<PackedRows> opacity;
        if (const auto stored = record.stored.find(alpha); stored != record.stored.end()) {
            opacity = packedRows(stored->second, shape);
            if (!opacity)
                return {};
        }
        if (const auto stored = record.stored.find(mask); stored != record.stored.end() && record.hasMask) {
            opacity = masked(opacity, shape, record, stored->second);
            if (!opacity)
                return {};
        }
        if (opacity)
            image.channels.push_back(*opacity);
        QByteArray tiff = planarTiff(image);
        return tiff.size() <= largestImage ? std::optional(std::move(tiff)) : std::nullopt;
    }

    /// The opacity of a layer, times its mask.
    std::optional<PackedRows> masked(const std::optional<PackedRows> &opacity, const ChannelShape &shape,
                                     const Record &record, const QByteArray &stored) const
    {
        const PixelArea &area = record.maskArea;
        const ChannelShape maskShape{std::max(0, area.width()), std::max(0, area.height()), m_bits};
        QByteArray mask;
        if (!area.isEmpty()) {
            const std::optional<PackedRows> packed = area.fits() ? packedRows(stored, maskShape) : std::nullopt;
            if (!packed)
                return {};
            mask = unpackedRows(*packed, maskShape);
        }
        QByteArray rows = opacity ? unpackedRows(*opacity, shape) : QByteArray(shape.rowBytes() * shape.height, '\xff');
        const double most = m_bits == 8 ? 255 : 65535;
        const auto at = [&](const QByteArray &from, const ChannelShape &in, int x, int y) {
            const char *pixel = from.constData() + y * in.rowBytes() + qsizetype(x) * (m_bits / 8);
            return double(m_bits == 8 ? quint8(*pixel) : qFromBigEndian<quint16>(pixel)) / most;
        };
        for (int y = 0; y < shape.height; ++y)
            for (int x = 0; x < shape.width; ++x) {
                const int mx = x + record.area.left - area.left, my = y + record.area.top - area.top;
                const bool inside = mx >= 0 && my >= 0 && mx < maskShape.width && my < maskShape.height;
                const double kept = inside ? at(mask, maskShape, mx, my) : record.maskOutside / 255.0;
                const auto value = quint16(std::lround(most * kept * at(rows, shape, x, y)));
                char *pixel = rows.data() + y * shape.rowBytes() + qsizetype(x) * (m_bits / 8);
                if (m_bits == 8)
                    *pixel = char(value);
                else
                    qToBigEndian(value, pixel);
            }
        return packRows(rows, shape);
    }

    /// The merged picture of a file without layers.
    bool takeMerged()
    {
        const ChannelShape shape{m_width, m_height, m_bits};
        const auto packing = Packing(m_file.u16());
        const int channels = std::min(m_channels, m_colours + 1);
        if (channels < m_colours)
            return false;
        PlanarImage image{m_width, m_height, m_bits, m_profile, {}};
        const QByteArray counts =
            packing == Packing::PackBits ? m_file.take(2 * qsizetype(m_height) * m_channels) : QByteArray();
        for (int c = 0; c < channels && m_file.ok(); ++c) {
            std::optional<PackedRows> rows;
            if (packing == Packing::PackBits) {
                const QByteArray own = counts.mid(2 * qsizetype(m_height) * c, 2 * qsizetype(m_height));
                Cursor sizes(own);
                qsizetype bytes = 0;
                for (int y = 0; y < m_height; ++y)
                    bytes += sizes.u16();
                rows = packedRows(own, m_file.take(bytes), shape);
            } else if (packing == Packing::Raw) {
                const QByteArray raw = m_file.take(shape.rowBytes() * m_height);
                if (m_file.ok())
                    rows = packRows(raw, shape);
            }
            if (!rows)
                return false;
            image.channels.push_back(*rows);
        }
        const QByteArray tiff = planarTiff(image);
        if (!m_file.ok() || tiff.size() > largestImage)
            return false;
        Record record;
        record.area = {0, 0, m_height, m_width};
        record.mode = "norm";
        record.name = FileMessages::tr("Background");
        add(record, tiff);
        return true;
    }

    Cursor m_file;
    int m_channels = 0, m_width = 0, m_height = 0, m_bits = 8, m_colours = 3;
    QByteArray m_profile;
    Painting m_painting;
    std::vector<GroupId> m_open;
    int m_missing = 0, m_modes = 0, m_computed = 0, m_effects = 0, m_masks = 0;
};

} // namespace

bool isPsd(const QByteArray &bytes)
{
    return bytes.size() >= headBytes && bytes.startsWith("8BPS");
}

Result<Painting> readLayers(const QByteArray &bytes, QString &leftOut)
{
    LayersReader reader(bytes);
    Result<Painting> painting = reader.read();
    leftOut = reader.leftOut();
    return painting;
}

} // namespace suffuse::psd

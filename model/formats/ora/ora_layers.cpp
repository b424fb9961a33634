#include "model/formats/ora/ora_layers.h"

#include "model/formats/embedded_image.h"
#include "model/formats/messages.h"
#include "model/formats/ora/composite_op.h"
#include "model/formats/ora/ora_parts.h"
#include "model/formats/ora/zip_parts.h"
#include "model/shaping/picture_stroke.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <map>

namespace suffuse::ora {

namespace {

Error damaged(const QString &what)
{
    return {FileMessages::tr("This OpenRaster file is damaged: %1.").arg(what)};
}

/// Reads the stack, which has the topmost layer first.
class StackReader {
public:
    explicit StackReader(const QByteArray &bytes) : m_parts(bytes) {}

    Result<Painting> read()
    {
        if (!m_parts.isOpen())
            return Error{FileMessages::tr("This OpenRaster file is damaged: it has no list of its parts.")};
        const std::optional<QByteArray> stack = m_parts.part(stackPart, mostOfStack);
        if (!stack)
            return damaged(FileMessages::tr("it has no list of its layers"));
        QXmlStreamReader xml(*stack);
        while (!xml.atEnd() && m_isWhole)
            switch (xml.readNext()) {
            case QXmlStreamReader::StartElement:
                begin(xml);
                break;
            case QXmlStreamReader::EndElement:
                if (xml.name() == QLatin1String("stack") && !m_open.empty())
                    m_open.pop_back();
                break;
            default:
                break;
            }
        if (xml.hasError() || !m_isWhole || !(m_painting.canvas.width > 0 && m_painting.canvas.height > 0))
            return damaged(FileMessages::tr("its list of layers cannot be read"));
        finish();
        return std::move(m_painting);
    }

    QString leftOut() const
    {
        return leftOutSentence({
            {m_missing,
             FileMessages::tr("%n layer(s) whose picture is missing, damaged or too large", nullptr, m_missing)},
            {m_modes, FileMessages::tr("the mode(s) of %n layer(s)", nullptr, m_modes)},
        });
    }

private:
    /// A folder that has begun.
    struct Folder {
        GroupId group = 0;
        Point at; ///< what the places of its layers count from
    };
    struct Image {
        EncodedImage bytes;
        int width = 0, height = 0;
    };

    static constexpr qint64 mostOfStack = qint64(16) << 20;
    static constexpr qint64 mostOfAll = qint64(1) << 30; ///< bytes of all pictures
    static constexpr std::size_t mostLayers = std::size_t(1) << 14;
    static constexpr std::size_t deepest = 64;
    static constexpr double farthest = 1e6; ///< pixels

    void begin(const QXmlStreamReader &xml)
    {
        const QXmlStreamAttributes attributes = xml.attributes();
        if (xml.name() == QLatin1String("image")) {
            m_painting.canvas.width = attributes.value(QLatin1String("w")).toDouble();
            m_painting.canvas.height = attributes.value(QLatin1String("h")).toDouble();
            m_painting.canvas.background.opacity = 0; // The file's own lowest layer is its background.
            m_isWhole = m_painting.canvas.width <= farthest && m_painting.canvas.height <= farthest;
        } else if (xml.name() == QLatin1String("stack")) {
            m_isWhole = m_open.size() < deepest;
            if (m_open.empty()) {
                m_open.emplace_back(); // the painting itself
                return;
            }
            const GroupId id = addGroup(attributes);
            Group &group = m_painting.groups.back();
            group.isolated |= attributes.value(QLatin1String("isolation")) == QLatin1String("isolate");
            m_open.push_back({id, placeOf(attributes)});
        } else if (xml.name() == QLatin1String("layer")) {
            addLayer(attributes);
        }
        m_isWhole &= m_painting.groups.size() <= mostLayers;
    }

    static double number(const QXmlStreamAttributes &attributes, const char *name, double usual)
    {
        bool ok = false;
        const double value = attributes.value(QLatin1String(name)).toDouble(&ok);
        return ok && std::abs(value) <= farthest ? value : usual; // NaN is not.
    }

    Point placeOf(const QXmlStreamAttributes &attributes) const
    {
        const Point from = m_open.empty() ? Point() : m_open.back().at;
        return from + Point{number(attributes, "x", 0), number(attributes, "y", 0)};
    }

    GroupId addGroup(const QXmlStreamAttributes &attributes)
    {
        Group group;
        group.id = GroupId(m_painting.groups.size() + 1);
        group.parent = m_open.empty() ? 0 : m_open.back().group;
        group.name = attributes.value(QLatin1String("name")).toString();
        group.visible = attributes.value(QLatin1String("visibility")) != QLatin1String("hidden");
        group.locked = attributes.value(QLatin1String("edit-locked")) == QLatin1String("true");
        group.opacity = float(std::clamp(number(attributes, "opacity", 1), 0.0, 1.0));
        if (const QString op = attributes.value(QLatin1String("composite-op")).toString(); !op.isEmpty()) {
            const std::optional<BlendMode> mode = blendModeFrom(op);
            m_modes += !mode;
            group.blend = mode.value_or(BlendMode::Normal);
        }
        m_painting.groups.push_back(group);
        return group.id;
    }

    void addLayer(const QXmlStreamAttributes &attributes)
    {
        const Image *image = imageOf(attributes.value(QLatin1String("src")).toString());
        const Point at = placeOf(attributes);
        if (!image || std::abs(at.x) > farthest || std::abs(at.y) > farthest) {
            ++m_missing;
            return;
        }
        const GroupId group = addGroup(attributes);
        m_painting.groups.back().isolated = true;
        Stroke stroke = pictureStroke(embeddedPicture(image->bytes, image->width, image->height),
                                      Rect::of(at.x, at.y, image->width, image->height), 0);
        stroke.group = group;
        m_fromTop.push_back(std::move(stroke));
    }

    /// A picture of the file, which layers may share; null if it is missing or no PNG of a size that paintings take.
    const Image *imageOf(const QString &source)
    {
        const auto [known, isNew] = m_images.try_emplace(source);
        Image &image = known->second;
        if (!isNew)
            return image.bytes ? &image : nullptr;
        std::optional<QByteArray> png = m_parts.part(source, std::min(largestImage, mostOfAll - m_taken));
        const auto pixels = png && png->startsWith("\x89PNG") ? pixelsOf(*png) : std::nullopt;
        if (!pixels)
            return nullptr;
        m_taken += png->size();
        image = {std::make_shared<const QByteArray>(std::move(*png)), pixels->first, pixels->second};
        return &image;
    }

    /// Turns the layers over, since a painting has the lowest one first.
    void finish()
    {
        StrokeId id = 0;
        for (auto stroke = m_fromTop.rbegin(); stroke != m_fromTop.rend(); ++stroke) {
            stroke->id = ++id;
            m_painting.strokes.push_back(std::make_shared<const Stroke>(std::move(*stroke)));
        }
        std::ranges::reverse(m_painting.groups);
    }

    ZipParts m_parts;
    Painting m_painting;
    bool m_isWhole = true;
    std::vector<Folder> m_open;
    std::vector<Stroke> m_fromTop;
    std::map<QString, Image> m_images;
    qint64 m_taken = 0; ///< bytes of pictures so far
    int m_missing = 0, m_modes = 0;
};

} // namespace

Result<Painting> readLayers(const QByteArray &bytes, QString &leftOut)
{
    StackReader reader(bytes);
    Result<Painting> painting = reader.read();
    leftOut = reader.leftOut();
    return painting;
}

} // namespace suffuse::ora

#include "render/drawing/drawing_svg.h"

#include "model/formats/svg/svg_group_writer.h"
#include "model/painting/resolution.h"
#include "model/painting/ryb.h"
#include "render/drawing/band_mask.h"
#include "render/drawing/drawn_picture.h"
#include "render/drawing/path_text.h"

#include <cmath>
#include <map>
#include <tuple>

namespace suffuse {

namespace {

QString decimal(double value)
{
    return QString::number(value, 'g', 9);
}

QString hex(const DrawnColour &colour)
{
    QString text = QStringLiteral("#");
    for (std::size_t c = 0; c < 3; ++c)
        text +=
            QStringLiteral("%1").arg(int(std::lround(255 * std::clamp(colour[c], 0.0, 1.0))), 2, 16, QLatin1Char('0'));
    return text;
}

class DrawingWriter {
public:
    DrawingWriter(const PathDrawing &drawing, const QByteArray &png, double resolution, const std::atomic<bool> *cancel)
        : m_drawing(drawing), m_png(png), m_resolution(resolution), m_cancel(cancel), m_xml(&m_bytes),
          m_data(drawing.painting->canvas)
    {}

    QByteArray write()
    {
        const Canvas &canvas = m_drawing.painting->canvas;
        m_xml.writeStartDocument();
        m_xml.writeStartElement("svg");
        m_xml.writeDefaultNamespace(svgNamespace);
        m_xml.writeNamespace(inkscapeNamespace, "inkscape");
        if (!m_png.isEmpty() || std::ranges::any_of(m_drawing.strokes, hasPicture))
            m_xml.writeNamespace(linkNamespace, "xlink");
        m_xml.writeAttribute("width", onPaper(canvas.width));
        m_xml.writeAttribute("height", onPaper(canvas.height));
        m_xml.writeAttribute("viewBox", "0 0 " + decimal(canvas.width) + ' ' + decimal(canvas.height));
        if (std::ranges::any_of(m_drawing.strokes, [](const DrawnStroke &s) { return s.bands.size() > 1; }))
            m_xml.writeTextElement("style", ".step{mix-blend-mode:difference;fill-rule:evenodd}");
        writeBelow(canvas);
        SvgGroupWriter groups(m_xml, *m_drawing.painting, SvgLayers::Inkscape);
        groups.setMasks([this](GroupId group) { return boundId(group); },
                        [this](GroupId group) { writeBounds(group); });
        const QString all = boundId(0);
        if (!all.isEmpty()) {
            m_xml.writeStartElement("g");
            m_xml.writeAttribute("mask", "url(#" + all + ')');
            writeBounds(0);
        }
        for (const DrawnStroke &stroke : m_drawing.strokes) {
            if (m_cancel && m_cancel->load(std::memory_order_relaxed))
                return {};
            groups.goTo(stroke.stroke->group);
            m_xml.writeCharacters("\n");
            writeStroke(stroke, QString::number(stroke.stroke->id));
        }
        groups.goTo(0);
        if (!all.isEmpty())
            m_xml.writeEndElement();
        m_xml.writeEndDocument();
        return m_bytes;
    }

private:
    static inline const QString linkNamespace = QStringLiteral("http://www.w3.org/1999/xlink");

    /// A side of the sheet, in pixels where nothing says how large it is on paper.
    QString onPaper(double side) const
    {
        return isResolution(m_resolution) ? decimal(side / m_resolution * millimetresOfInch) + "mm" : decimal(side);
    }
    /// The picture, or the canvas' colour, which ours and other programs know by its id.
    void writeBelow(const Canvas &canvas)
    {
        if (!m_png.isEmpty()) {
            m_xml.writeEmptyElement("image");
            writeBox(canvas.area());
            writeImage({m_png});
            m_xml.writeAttribute("preserveAspectRatio", "none");
        } else if (canvas.background.opacity > 0) {
            const std::array<double, 3> rgb = srgbFromRyb(canvas.background);
            m_xml.writeEmptyElement("rect");
            m_xml.writeAttribute("id", "background");
            writeBox(canvas.area());
            m_xml.writeAttribute("fill", hex({rgb[0], rgb[1], rgb[2], 1}));
            if (canvas.background.opacity < 1)
                m_xml.writeAttribute("fill-opacity", decimal(double(canvas.background.opacity)));
        }
    }
    void writeImage(const DrawnImage &image)
    {
        m_xml.writeAttribute(linkNamespace, "href",
                             "data:" + QLatin1String(image.type) + ";base64," +
                                 QString::fromLatin1(image.bytes.toBase64()));
    }
    void writeBox(const Rect &box)
    {
        m_xml.writeAttribute("x", decimal(box.left));
        m_xml.writeAttribute("y", decimal(box.top));
        m_xml.writeAttribute("width", decimal(box.width()));
        m_xml.writeAttribute("height", decimal(box.height()));
    }

    static bool hasPicture(const DrawnStroke &drawn) { return bool(drawn.stroke->picture); }

    /// The mask that a group is seen through, which itself is seen through the others that bound the group.
    QString boundId(GroupId group) const
    {
        const auto found = m_drawing.bounds.find(group);
        if (found == m_drawing.bounds.end())
            return {};
        return "bound" + QString::number(group) + '-' + QString::number(found->second.size());
    }

    void writeBounds(GroupId group)
    {
        const QString prefix = "bound" + QString::number(group) + '-';
        int number = 0;
        for (const DrawnBound &bound : m_drawing.bounds.at(group)) {
            m_xml.writeStartElement("mask");
            m_xml.writeAttribute("id", prefix + QString::number(++number));
            m_xml.writeAttribute("maskUnits", "userSpaceOnUse");
            writeBox(m_drawing.painting->canvas.area());
            if (number > 1)
                m_xml.writeAttribute("mask", "url(#" + prefix + QString::number(number - 1) + ')');
            if (bound.opacity < 1) {
                m_xml.writeStartElement("g");
                m_xml.writeAttribute("opacity", decimal(bound.opacity));
            }
            for (const DrawnStroke &stroke : bound.strokes)
                writeStroke(stroke, prefix + QString::number(number) + '-' + QString::number(stroke.stroke->id));
            if (bound.opacity < 1)
                m_xml.writeEndElement();
            m_xml.writeEndElement();
        }
    }

    void writeStroke(const DrawnStroke &drawn, const QString &id)
    {
        const contours::Band &outer = drawn.bands.front();
        const bool masked = drawn.bands.size() > 1, pictured = hasPicture(drawn) && !m_drawing.unpainted;
        if (!m_drawing.unpainted && (masked || pictured || drawn.paint.isGradient())) {
            m_xml.writeStartElement("defs");
            if (masked)
                writeMask(drawn, id);
            if (pictured && !masked)
                writeClip(outer, id);
            if (drawn.paint.isGradient() && !pictured)
                writeGradient(drawn.paint, id);
            m_xml.writeEndElement();
        }
        const QString name = xmlText(drawn.stroke->name);
        m_xml.writeStartElement(pictured ? "g" : "path");
        m_xml.writeAttribute("id", "stroke" + id);
        if (!name.isEmpty())
            m_xml.writeAttribute(inkscapeNamespace, "label", name);
        if (!pictured)
            m_xml.writeAttribute("d", QString::fromLatin1(m_data.svg(outer.loops)));
        if (m_drawing.unpainted)
            m_xml.writeAttribute("fill-opacity", "0");
        else
            writeLook(drawn, id, pictured);
        if (!name.isEmpty())
            m_xml.writeTextElement("title", name);
        if (pictured)
            writePicture(*drawn.stroke);
        m_xml.writeEndElement();
    }

    /// How what is within a stroke's outline looks.
    void writeLook(const DrawnStroke &drawn, const QString &id, bool pictured)
    {
        const bool masked = drawn.bands.size() > 1;
        const double opacity = masked ? 1 : drawn.bands.front().opacity;
        if (masked)
            m_xml.writeAttribute("mask", "url(#bands" + id + ')');
        else if (pictured)
            m_xml.writeAttribute("clip-path", "url(#clip" + id + ')');
        if (!pictured) {
            const QString paint = drawn.paint.isGradient() ? "url(#paint" + id + ')' : hex(drawn.paint.at({}));
            m_xml.writeAttribute("fill", paint);
            if (masked) { // The mask alone says where paint ends.
                m_xml.writeAttribute("stroke", paint);
                m_xml.writeAttribute("stroke-width", decimal(2 * paintMargin));
                m_xml.writeAttribute("stroke-linejoin", "round");
            }
        }
        if (opacity < 1)
            m_xml.writeAttribute(pictured ? "opacity" : "fill-opacity", QString::number(opacity, 'g', 4));
        if (drawn.multiplies)
            m_xml.writeAttribute("style", "mix-blend-mode:multiply");
    }

    /// The picture that a stroke shows. Strokes that show the same image share it.
    void writePicture(const Stroke &stroke)
    {
        const Picture &picture = *stroke.picture;
        const Affine map = Affine::translation(stroke.origin) * mapOf(picture);
        QStringList numbers;
        for (const double number : {map.a, map.c, map.b, map.d, map.offset.x, map.offset.y})
            numbers << decimal(number);
        m_xml.writeStartElement("g");
        m_xml.writeAttribute("transform", "matrix(" + numbers.join(' ') + ')');
        const auto [known, isNew] = m_images.try_emplace(std::tuple(picture.sha256, picture.width, picture.height),
                                                         "image" + QString::number(m_images.size() + 1));
        if (!isNew) {
            m_xml.writeEmptyElement("use");
            m_xml.writeAttribute(linkNamespace, "href", '#' + known->second);
        } else if (const Result<DrawnImage> image = drawnImage(picture, m_cancel)) {
            m_xml.writeEmptyElement("image");
            m_xml.writeAttribute("id", known->second);
            writeBox({0, 0, double(picture.width), double(picture.height)});
            writeImage(*image);
            m_xml.writeAttribute("preserveAspectRatio", "none");
        }
        m_xml.writeEndElement();
    }

    void writeClip(const contours::Band &band, const QString &id)
    {
        m_xml.writeStartElement("clipPath");
        m_xml.writeAttribute("id", "clip" + id);
        m_xml.writeEmptyElement("path");
        m_xml.writeAttribute("d", QString::fromLatin1(m_data.svg(band.loops)));
        m_xml.writeEndElement();
    }

    void writeMask(const DrawnStroke &drawn, const QString &id)
    {
        const BandMask mask = bandMaskOf(drawn, m_drawing.bandCount);
        const Rect &box = mask.box;
        m_xml.writeStartElement("mask");
        m_xml.writeAttribute("id", "bands" + id);
        m_xml.writeAttribute("maskUnits", "userSpaceOnUse");
        writeBox(box);
        const QString sheet = 'M' + decimal(box.left) + ' ' + decimal(box.top) + 'H' + decimal(box.right) + 'V' +
                              decimal(box.bottom) + 'H' + decimal(box.left) + 'z';
        writeGrey(mask.sheet, sheet, false);
        for (const BandMask::Step &step : mask.steps) {
            const QString data = QString::fromLatin1(m_data.svg(*step.loops, step.bend));
            writeGrey(step.level, step.put == BandMask::Put::Outside ? sheet + data : data,
                      step.put != BandMask::Put::Over);
        }
        m_xml.writeEndElement();
    }

    void writeGrey(int level, const QString &data, bool subtracts)
    {
        m_xml.writeEmptyElement("path");
        if (subtracts)
            m_xml.writeAttribute("class", "step");
        m_xml.writeAttribute("fill", hex({level / 255.0, level / 255.0, level / 255.0, 1}));
        m_xml.writeAttribute("d", data);
    }

    void writeGradient(const DrawnPaint &paint, const QString &id)
    {
        m_xml.writeStartElement("linearGradient");
        m_xml.writeAttribute("id", "paint" + id);
        m_xml.writeAttribute("gradientUnits", "userSpaceOnUse");
        m_xml.writeAttribute("x1", decimal(paint.from.x));
        m_xml.writeAttribute("y1", decimal(paint.from.y));
        m_xml.writeAttribute("x2", decimal(paint.to.x));
        m_xml.writeAttribute("y2", decimal(paint.to.y));
        for (const DrawnPaint::Stop &stop : paint.stops) {
            m_xml.writeEmptyElement("stop");
            m_xml.writeAttribute("offset", QString::number(stop.place, 'g', 4));
            m_xml.writeAttribute("stop-color", hex(stop.colour));
            if (stop.colour[3] < 1)
                m_xml.writeAttribute("stop-opacity", QString::number(stop.colour[3], 'g', 4));
        }
        m_xml.writeEndElement();
    }

    const PathDrawing &m_drawing;
    const QByteArray &m_png;
    double m_resolution;
    const std::atomic<bool> *m_cancel;
    std::map<std::tuple<QString, std::uint32_t, std::uint32_t>, QString> m_images; ///< by their ids in the drawing
    QByteArray m_bytes;
    QXmlStreamWriter m_xml;
    PathText m_data;
};

} // namespace

QByteArray svgOf(const PathDrawing &drawing, const QByteArray &png, double resolution, const std::atomic<bool> *cancel)
{
    return DrawingWriter(drawing, png, resolution, cancel).write();
}

} // namespace suffuse

#include "render/drawing/drawing_svg.h"

#include "model/formats/svg/svg_group_writer.h"
#include "model/painting/ryb.h"
#include "render/drawing/drawn_picture.h"

#include <cmath>
#include <map>
#include <tuple>

namespace suffuse {

namespace {

constexpr double coarsestStep = 1e-3; ///< canvas units, of coordinates
/// Renderers take curves for lines to within a tenth of a pixel, which shows where opacity changes steeply. Bands are
/// cut into pieces that lie so near to lines, canvas units: the nearer the more bands there are, as these may lie close
/// together, and where opacity jumps by a step of many levels, so near that it is off by less than half a usual step.
double bendFor(int bands, int step)
{
    return std::min(100.0 / (double(bands) * bands), 100.0 / (double(bands) * std::max(step, 1)));
}

/// What is seen through a mask is so much wider than its paths, and the mask reaches so much farther that its own
/// border is nowhere seen, canvas units.
constexpr double paintMargin = 1, maskMargin = 3;

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

/// Path data in whole steps, from point to point, so that rounding does not add up.
class PathData {
public:
    explicit PathData(int decimals) : m_decimals(decimals), m_steps(std::pow(10.0, decimals)) {}

    /// `bend`: how far curves may lie from straight lines, of which longer ones are cut.
    QString of(const contours::Loops &loops, double bend = std::numeric_limits<double>::infinity())
    {
        m_text.clear();
        for (const std::vector<Cubic> &loop : loops) {
            m_x = m_y = 0;
            m_text += 'M';
            m_pending = false;
            append(loop.front().p[0], true);
            m_text += 'c';
            m_pending = false;
            for (const Cubic &curve : loop)
                append(curve, bend);
            m_text += 'z';
        }
        return QString::fromLatin1(m_text);
    }

private:
    void append(const Cubic &curve, double bend)
    {
        const Point a = curve.p[0] - 2 * curve.p[1] + curve.p[2], b = curve.p[1] - 2 * curve.p[2] + curve.p[3];
        const int parts = std::max(1, int(std::ceil(std::sqrt(0.75 / bend * std::max(length(a), length(b))))));
        Cubic rest = curve;
        for (int k = parts; k > 0; --k) {
            const auto [part, after] = rest.split(1.0 / k);
            append(part.p[1], false);
            append(part.p[2], false);
            append(part.p[3], true);
            rest = after;
        }
    }
    void append(Point p, bool moves)
    {
        const qint64 x = std::llround(p.x * m_steps), y = std::llround(p.y * m_steps);
        append(x - m_x);
        append(y - m_y);
        if (moves)
            m_x = x, m_y = y;
    }
    void append(qint64 steps)
    {
        if (m_pending && steps >= 0)
            m_text += ' ';
        m_pending = true;
        if (steps < 0)
            m_text += '-';
        QByteArray digits = QByteArray::number(qAbs(steps));
        if (digits.size() <= m_decimals)
            digits = QByteArray(m_decimals + 1 - digits.size(), '0') + digits;
        QByteArray whole = digits.first(digits.size() - m_decimals), part = digits.last(m_decimals);
        while (part.endsWith('0'))
            part.chop(1);
        if (whole == "0" && !part.isEmpty())
            whole.clear();
        m_text += whole;
        if (!part.isEmpty())
            m_text += '.' + part;
    }

    int m_decimals;
    double m_steps;
    QByteArray m_text;
    qint64 m_x = 0, m_y = 0;
    bool m_pending = false;
};

class DrawingWriter {
public:
    DrawingWriter(const PathDrawing &drawing, const QByteArray &png, const std::atomic<bool> *cancel)
        : m_drawing(drawing), m_png(png), m_cancel(cancel), m_xml(&m_bytes),
          m_data(decimalsFor(drawing.painting->canvas))
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
        m_xml.writeAttribute("width", decimal(canvas.width));
        m_xml.writeAttribute("height", decimal(canvas.height));
        m_xml.writeAttribute("viewBox", "0 0 " + decimal(canvas.width) + ' ' + decimal(canvas.height));
        if (std::ranges::any_of(m_drawing.strokes, [](const DrawnStroke &s) { return s.bands.size() > 1; }))
            m_xml.writeTextElement("style", ".step{mix-blend-mode:difference;fill-rule:evenodd}");
        writeBelow(canvas);
        SvgGroupWriter groups(m_xml, *m_drawing.painting, SvgLayers::Inkscape);
        for (const DrawnStroke &stroke : m_drawing.strokes) {
            if (m_cancel && m_cancel->load(std::memory_order_relaxed))
                return {};
            groups.goTo(stroke.stroke->group);
            m_xml.writeCharacters("\n");
            writeStroke(stroke);
        }
        groups.goTo(0);
        m_xml.writeEndDocument();
        return m_bytes;
    }

private:
    static inline const QString linkNamespace = QStringLiteral("http://www.w3.org/1999/xlink");

    static int decimalsFor(const Canvas &canvas)
    {
        const double step = std::min(coarsestStep, 1e-6 * std::max(canvas.width, canvas.height));
        return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 3, 9);
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

    void writeStroke(const DrawnStroke &drawn)
    {
        const QString id = QString::number(drawn.stroke->id);
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
            m_xml.writeAttribute("d", m_data.of(outer.loops));
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
        m_xml.writeAttribute("d", m_data.of(band.loops));
        m_xml.writeEndElement();
    }

    void writeMask(const DrawnStroke &drawn, const QString &id)
    {
        Rect box;
        for (const contours::Band &band : drawn.bands)
            for (const std::vector<Cubic> &loop : band.loops)
                for (const Cubic &curve : loop)
                    box = box.united(curve.controlBox());
        box = box.grown(maskMargin);
        box = {std::floor(box.left), std::floor(box.top), std::ceil(box.right), std::ceil(box.bottom)};
        m_xml.writeStartElement("mask");
        m_xml.writeAttribute("id", "bands" + id);
        m_xml.writeAttribute("maskUnits", "userSpaceOnUse");
        writeBox(box);
        // While bands become more opaque, each takes its step outside; where they become fainter, inside. Where they
        // become more opaque again (within a rim) that is gentle, and each may lie over the one around it.
        const std::vector<contours::Band> &bands = drawn.bands;
        std::size_t rising = 1;
        while (rising < bands.size() && bands[rising].opacity > bands[rising - 1].opacity)
            ++rising;
        std::size_t falling = rising;
        while (falling < bands.size() && bands[falling].opacity < bands[falling - 1].opacity)
            ++falling;
        const QString sheet = 'M' + decimal(box.left) + ' ' + decimal(box.top) + 'H' + decimal(box.right) + 'V' +
                              decimal(box.bottom) + 'H' + decimal(box.left) + 'z';
        writeGrey(levelOf(bands[rising - 1]), sheet, false);
        for (std::size_t k = 0; k < bands.size(); ++k) {
            const int level = levelOf(bands[k]), step = level - (k > 0 ? levelOf(bands[k - 1]) : 0);
            if (step == 0)
                continue;
            const QString data = m_data.of(bands[k].loops, bendFor(m_drawing.bandCount, std::abs(step)));
            if (k < rising)
                writeGrey(step, sheet + data, true);
            else
                writeGrey(k < falling ? -step : level, data, k < falling);
        }
        m_xml.writeEndElement();
    }

    static int levelOf(const contours::Band &band)
    {
        return int(std::lround(255 * std::clamp(band.opacity, 0.0, 1.0)));
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
    const std::atomic<bool> *m_cancel;
    std::map<std::tuple<QString, std::uint32_t, std::uint32_t>, QString> m_images; ///< by their ids in the drawing
    QByteArray m_bytes;
    QXmlStreamWriter m_xml;
    PathData m_data;
};

} // namespace

QByteArray svgOf(const PathDrawing &drawing, const QByteArray &png, const std::atomic<bool> *cancel)
{
    return DrawingWriter(drawing, png, cancel).write();
}

} // namespace suffuse

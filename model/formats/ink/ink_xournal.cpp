// Notebooks of Xournal++ (.xopp) and Xournal (.xoj): XML that is packed by gzip, or a zip file with it. Lengths are in
// points. They hold no times.
#include "model/formats/embedded_image.h"
#include "model/formats/gzip.h"
#include "model/formats/ink/recording.h"
#include "model/formats/ora/zip_parts.h"
#include "model/formats/svg/css/css_colours.h"
#include "model/painting/ryb.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr double unitsPerPoint = 4.0 / 3; ///< as for SVG, where 96 units are an inch
constexpr double gapOfPages = 20;         ///< units between two pages
constexpr double farthestPoint = 1e7;     ///< points of the paper

const QString notesPart = QStringLiteral("content.xml");

/// A colour of a stroke: "#rrggbbaa", "#rrggbb", or one of Xournal's names, two of which CSS has otherwise.
std::optional<std::array<double, 4>> colourOfXournal(QString text)
{
    if (text == QLatin1String("green"))
        text = QStringLiteral("#008000");
    else if (text == QLatin1String("lightgreen"))
        text = QStringLiteral("#00ff00");
    else if (text == QLatin1String("lightblue"))
        text = QStringLiteral("#00c0ff");
    return cssColour(text);
}

class XournalReader {
public:
    XournalReader(const QByteArray &xml, const ZipParts *parts, const QString &fileName)
        : m_xml(xml), m_parts(parts), m_fileName(fileName)
    {}

    Result<Recording> read()
    {
        if (!m_xml.readNextStartElement() || m_xml.name() != QLatin1String("xournal"))
            fail(FileMessages::tr("the first element is not xournal"));
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("page"))
                page();
            else
                m_xml.skipCurrentElement();
        }
        if (m_xml.hasError())
            return fileError(m_fileName,
                             FileMessages::tr("line %1, column %2").arg(m_xml.lineNumber()).arg(m_xml.columnNumber()) +
                                 QStringLiteral(": ") + m_xml.errorString());
        if (m_pages == 0)
            return fileError(m_fileName, FileMessages::tr("holds no pages"));
        if (m_pages == 1)
            dissolvePage();
        m_recording.area = Rect::of(0, 0, m_width, m_bottom - gapOfPages);
        m_recording.leftOut = leftOutSentence({
            {m_texts, FileMessages::tr("%n text(s)", nullptr, m_texts)},
            {m_fills, FileMessages::tr("%n fill(s)", nullptr, m_fills)},
            {m_dashes, FileMessages::tr("%n line style(s)", nullptr, m_dashes)},
            {m_images, FileMessages::tr("%n image(s)", nullptr, m_images)},
            {m_sounds, FileMessages::tr("%n recording(s) of sound", nullptr, m_sounds)},
            {m_papers, FileMessages::tr("%n ruled or printed paper(s)", nullptr, m_papers)},
        });
        return std::move(m_recording);
    }

private:
    void fail(const QString &what)
    {
        if (!m_xml.hasError())
            m_xml.raiseError(what);
    }

    double number(const QXmlStreamAttributes &attributes, const char *name)
    {
        const QByteArray text = attributes.value(QLatin1String(name)).toLatin1();
        const std::optional<double> value = numberIn({text.constData(), std::size_t(text.size())});
        if (value && std::abs(*value) <= farthestPoint)
            return *value * unitsPerPoint;
        fail(FileMessages::tr("%1 is no number within ±1e7").arg(QLatin1String(name)));
        return 0;
    }

    int addGroup(const QString &name, int parent)
    {
        if (m_recording.groups.size() >= mostGroups) {
            fail(FileMessages::tr("has more than %1 layers").arg(mostGroups));
            return -1;
        }
        m_recording.groups.push_back({name, parent});
        return int(m_recording.groups.size()) - 1;
    }

    void page()
    {
        const QXmlStreamAttributes attributes = m_xml.attributes();
        const double width = number(attributes, "width"), height = number(attributes, "height");
        if (!(width > 0 && height > 0))
            fail(FileMessages::tr("the page has no size"));
        const int group = addGroup(FileMessages::tr("Page %1").arg(++m_pages), -1);
        int layers = 0;
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("background")) {
                background(Rect::of(0, m_bottom, width, height), group);
            } else if (m_xml.name() == QLatin1String("layer")) {
                const QString name = m_xml.attributes().value(QLatin1String("name")).toString();
                ++layers;
                layer(addGroup(name.isEmpty() ? FileMessages::tr("Layer %1").arg(layers) : name, group));
            } else {
                m_xml.skipCurrentElement();
            }
        }
        m_width = std::max(m_width, width);
        m_bottom += height + gapOfPages;
    }

    /// What a page is printed on: its colour is the canvas's if it is the first page's, and a picture is a picture.
    void background(const Rect &area, int group)
    {
        const QXmlStreamAttributes attributes = m_xml.attributes();
        const QStringView type = attributes.value(QLatin1String("type"));
        if (type == QLatin1String("pixmap")) {
            const QByteArray name = attributes.value(QLatin1String("filename")).toUtf8();
            // Other files are not opened by their paths; only what the notebook has itself is.
            addImage(m_parts ? m_parts->part(QString::fromUtf8(name), largestImage).value_or(QByteArray())
                             : QByteArray(),
                     area, group);
        } else if (type == QLatin1String("solid")) {
            const auto colour = colourOfXournal(attributes.value(QLatin1String("color")).toString());
            if (colour && m_pages == 1)
                m_recording.background = rybFromSrgb((*colour)[0], (*colour)[1], (*colour)[2], 1);
            const QStringView style = attributes.value(QLatin1String("style"));
            m_papers += !style.isEmpty() && style != QLatin1String("plain");
        } else {
            ++m_papers;
        }
        m_xml.skipCurrentElement();
    }

    void layer(int group)
    {
        while (!m_xml.hasError() && m_xml.readNextStartElement()) {
            if (m_xml.name() == QLatin1String("stroke")) {
                stroke(group);
            } else if (m_xml.name() == QLatin1String("image") || m_xml.name() == QLatin1String("teximage")) {
                image(group);
            } else {
                m_texts += m_xml.name() == QLatin1String("text");
                m_xml.skipCurrentElement();
            }
        }
    }

    void stroke(int group)
    {
        const QXmlStreamAttributes attributes = m_xml.attributes();
        Recording::Path path;
        path.group = group;
        const bool isMarker = attributes.value(QLatin1String("tool")) == QLatin1String("highlighter");
        if (const auto colour = colourOfXournal(attributes.value(QLatin1String("color")).toString())) {
            constexpr double markerOpacity = 120.0 / 255; // whatever its colour says
            path.colour =
                rybFromSrgb((*colour)[0], (*colour)[1], (*colour)[2], isMarker ? markerOpacity : (*colour)[3]);
        }
        const QStringView style = attributes.value(QLatin1String("style"));
        m_dashes += !style.isEmpty() && style != QLatin1String("plain");
        m_fills += attributes.hasAttribute(QLatin1String("fill"));
        m_sounds += !attributes.value(QLatin1String("fn")).isEmpty();
        std::vector<double> widths = numbers(attributes.value(QLatin1String("width")).toLatin1(), "width");
        const std::vector<double> rest = numbers(attributes.value(QLatin1String("pressures")).toLatin1(), "pressures");
        const std::vector<double> places = numbers(textOf(), "stroke");
        m_samples += places.size() / 2;
        if (places.size() % 2 != 0)
            fail(FileMessages::tr("the stroke has an x without y"));
        if (m_samples > mostSamples)
            fail(FileMessages::tr("has more than %1 points").arg(mostSamples));
        if (widths.empty())
            fail(FileMessages::tr("the stroke has no width"));
        if (m_xml.hasError())
            return;
        // The first width is that of the pen; where the pen was pressed, one for each piece of the line follows.
        widths.insert(widths.end(), rest.begin(), rest.end());
        const double usual = widths.front();
        if (widths.size() > 1)
            widths.erase(widths.begin());
        for (std::size_t k = 0; k + 1 < places.size(); k += 2) {
            path.samples.push_back({{places[k], places[k + 1] + m_bottom}});
            const double width = widths.size() == 1 ? usual : widths[std::min(k / 2, widths.size() - 1)];
            path.widths.push_back(std::max(width, 0.0));
        }
        m_times.give(path);
        if (!path.samples.empty())
            m_recording.paths.push_back(std::move(path));
    }

    /// Text up to the end of the element, with that of its parts.
    QByteArray textOf() { return m_xml.readElementText(QXmlStreamReader::IncludeChildElements).toLatin1(); }

    /// The lengths in a text, as units.
    std::vector<double> numbers(const QByteArray &text, const char *what)
    {
        std::vector<double> values;
        std::string_view rest(text.constData(), std::size_t(text.size()));
        for (rest = trimmed(rest); !rest.empty() && !m_xml.hasError(); rest = trimmed(rest)) {
            const std::size_t end = std::min(rest.find_first_of(" \t\r\n,"), rest.size());
            const std::optional<double> value = numberIn(rest.substr(0, end));
            if (!value || std::abs(*value) > farthestPoint || values.size() > 2 * mostSamples)
                fail(FileMessages::tr("%1: %2 is no number within ±1e7")
                         .arg(QLatin1String(what), excerpt(rest.substr(0, std::min<std::size_t>(end, 40)))));
            else
                values.push_back(*value * unitsPerPoint);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return values;
    }

    void image(int group)
    {
        const QXmlStreamAttributes attributes = m_xml.attributes();
        const double left = number(attributes, "left"), top = number(attributes, "top");
        const double right = number(attributes, "right"), bottom = number(attributes, "bottom");
        QByteArray bytes;
        QString text;
        while (!m_xml.atEnd() && !m_xml.isEndElement()) {
            m_xml.readNext();
            if (m_xml.isCharacters() && text.size() + m_xml.text().size() <= largestImage / 3 * 4 + 8) {
                text += m_xml.text();
            } else if (m_xml.isStartElement()) {
                const QString name = m_xml.attributes().value(QLatin1String("path")).toString();
                if (m_parts)
                    bytes = m_parts->part(name, largestImage - m_imageBytes).value_or(QByteArray());
                m_xml.skipCurrentElement();
                m_xml.readNext();
            }
        }
        addImage(bytes.isEmpty() ? QByteArray::fromBase64(text.toLatin1()) : bytes,
                 Rect{left, top + m_bottom, right, bottom + m_bottom}, group);
    }

    void addImage(const QByteArray &bytes, const Rect &area, int group)
    {
        const auto pixels = pixelsOf(bytes);
        // All together have no more than one picture may have, since each is a copy.
        if (!pixels || !(area.width() > 0 && area.height() > 0) || m_imageBytes + bytes.size() > largestImage) {
            ++m_images;
            return;
        }
        m_imageBytes += bytes.size();
        m_recording.images.push_back({std::make_shared<const QByteArray>(bytes), pixels->first, pixels->second, area,
                                      m_recording.paths.size(), group});
    }

    /// The only page is the painting: its layers are in no group.
    void dissolvePage()
    {
        const auto up = [](int &group) { group = std::max(group, 0) - 1; };
        m_recording.groups.erase(m_recording.groups.begin());
        for (Recording::Group &group : m_recording.groups)
            group.parent = -1;
        for (Recording::Path &path : m_recording.paths)
            up(path.group);
        for (Recording::Image &image : m_recording.images)
            up(image.group);
    }

    QXmlStreamReader m_xml;
    const ZipParts *m_parts;
    const QString &m_fileName;
    Recording m_recording;
    double m_width = 0, m_bottom = 0; ///< units of the pages so far, and of the gap below them
    int m_pages = 0;
    std::size_t m_samples = 0;
    AssumedTimes m_times;
    qint64 m_imageBytes = 0;
    int m_texts = 0, m_fills = 0, m_dashes = 0, m_images = 0, m_sounds = 0, m_papers = 0;
};

} // namespace

bool isXournalPackage(const QByteArray &bytes)
{
    if (!bytes.startsWith("PK\x03\x04"))
        return false;
    const ZipParts parts(bytes);
    return parts.isOpen() && parts.part(QStringLiteral("mimetype"), 256).value_or("").contains("xournal");
}

Result<Recording> readXournal(const QByteArray &bytes, const QString &fileName)
{
    if (isGzip(bytes)) {
        const Result<QByteArray> xml = unpackedGzip(bytes, largestInk);
        return xml ? XournalReader(*xml, nullptr, fileName).read() : fileError(fileName, xml.error());
    }
    if (!bytes.startsWith("PK"))
        return XournalReader(bytes, nullptr, fileName).read();
    const ZipParts parts(bytes);
    const std::optional<QByteArray> xml = parts.part(notesPart, largestInk);
    if (!xml)
        return fileError(fileName, FileMessages::tr("is damaged: it cannot be unpacked"));
    return XournalReader(*xml, &parts, fileName).read();
}

} // namespace suffuse

// The format of a file, by its first bytes.
#include "model/formats/files.h"
#include "model/formats/gzip.h"
#include "model/formats/ink/diffusion_curves.h"
#include "model/formats/ink/recording.h"
#include "model/formats/ink/universal_container.h"
#include "model/formats/messages.h"
#include "model/formats/ora/ora_parts.h"
#include "model/formats/pdf/pdf_embedding.h"
#include "model/formats/psd/psd_layers.h"
#include "model/formats/suffuse/suffuse_layout.h"

#include <QFileInfo>

#include <algorithm>

namespace suffuse {

namespace {

/// Walks over the top level of a JSON object, however damaged, and finds out what kind of file it is.
class JsonGlance {
public:
    explicit JsonGlance(std::string_view text) : m_text(text) {}

    FileFormat format()
    {
        std::string_view key, word;
        bool value = false; // true after a colon
        for (m_at = m_text.find('{') + 1; m_at < m_text.size(); ++m_at) {
            const char c = m_text[m_at];
            if (c == '"') {
                word = string();
                if (m_depth == 0 && !value)
                    key = word;
                else if (m_depth == 0 && known(key, word) != FileFormat::Unknown)
                    return known(key, word);
            } else if (c == '{' || c == '[') {
                if (m_depth == 0 && key == "inkData" && value)
                    return FileFormat::UniversalInk;
                m_canvas = m_canvas || (m_depth == 0 && value && (key == "canvas" || key == "strokes"));
                ++m_depth;
            } else if (c == '}' || c == ']') {
                if (m_depth-- == 0)
                    break;
            } else if (m_depth == 0 && (c == ':' || c == ',')) {
                value = c == ':';
            }
        }
        // The text is cut off, or it looks like a painting, whose reader says what is wrong, and where.
        return m_canvas || m_at >= m_text.size() ? FileFormat::Text : FileFormat::Unknown;
    }

private:
    static FileFormat known(std::string_view key, std::string_view word)
    {
        if (key == "format" && word == "suffuse-text")
            return FileFormat::Text;
        if (key == "type" && (word == "excalidraw" || word == "excalidrawlib"))
            return FileFormat::Excalidraw;
        return FileFormat::Unknown;
    }

    std::string_view string()
    {
        const std::size_t from = m_at + 1;
        for (m_at = from; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at)
            m_at += m_text[m_at] == '\\';
        return m_text.substr(from, std::min(m_at, m_text.size()) - from);
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    qint64 m_depth = 0;
    bool m_canvas = false;
};

bool isText(std::string_view text)
{
    return std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f';
    });
}

/// Tells recordings made of lines apart by the first line that is neither empty nor a comment.
FileFormat formatOfLines(std::string_view text)
{
    std::string_view line;
    while (!text.empty() && (line.empty() || line.front() == '#')) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (line.empty() || line.size() > 4096 || !isText(line))
        return FileFormat::Unknown;
    std::vector<std::string_view> words;
    for (std::size_t from = 0; from < line.size();) {
        const std::size_t end = std::min(line.find_first_of(" \t", from), line.size());
        if (end > from)
            words.push_back(line.substr(from, end - from));
        from = end + 1;
    }
    const auto isNumber = [](std::string_view word) { return numberIn(word).has_value(); };
    if (words.size() == 4 && line.find_first_of(",;") == line.npos && std::all_of(words.begin(), words.end(), isNumber))
        return FileFormat::MyPaintEvents;
    const std::size_t separator = line.find_first_of(",;\t");
    if (separator == line.npos)
        return FileFormat::Unknown;
    if (isNumber(line.substr(0, separator)))
        return FileFormat::InkCsv;
    QString lower = QString::fromUtf8(line.data(), qsizetype(line.size())).toLower();
    const QStringList cells = lower.replace(QLatin1Char(';'), QLatin1Char(','))
                                  .replace(QLatin1Char('\t'), QLatin1Char(','))
                                  .split(QLatin1Char(','));
    const auto has = [&](QLatin1Char axis) {
        return std::any_of(cells.begin(), cells.end(), [&](QString cell) {
            cell = cell.remove(QLatin1Char('"')).trimmed();
            return cell == axis || cell.endsWith(QString(QLatin1Char('_')) + axis);
        });
    };
    return has(QLatin1Char('x')) && has(QLatin1Char('y')) ? FileFormat::InkCsv : FileFormat::Unknown;
}

FileFormat formatOfText(const QByteArray &bytes)
{
    std::string_view text(bytes.constData(), std::size_t(bytes.size()));
    if (text.starts_with("\xef\xbb\xbf"))
        text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == text.npos)
        return FileFormat::Unknown;
    if (text[first] == '{')
        return isRnote(text) ? FileFormat::Rnote : JsonGlance(text).format();
    if (text[first] == '<' && text.substr(first, 4096).find("<curve_set") != text.npos)
        return FileFormat::DiffusionCurves;
    if (text[first] == '<' && text.substr(first, 4096).find("<xournal") != text.npos)
        return FileFormat::Xournal;
    if (text[first] == '<' && text.substr(first, 4096).find("http://www.w3.org/2003/InkML") != text.npos)
        return FileFormat::InkMl;
    // Some programs put pages of comments and entities before it.
    if (text[first] == '<' && text.substr(first, 65536).find("<svg") != text.npos)
        return FileFormat::Svg;
    return formatOfLines(text);
}

/// What is packed by gzip, by its beginning.
FileFormat packedFormat(const QByteArray &bytes)
{
    const Result<QByteArray> beginning = unpackedGzip(bytes, 65536, true);
    return beginning ? formatOfText(*beginning) : FileFormat::Unknown;
}

} // namespace

FileFormat detectFormat(const QByteArray &bytes)
{
    if (startsAsSuffuse(bytes) || hasFirstChunk(bytes))
        return FileFormat::Suffuse;
    if (pdf::isPdf(bytes))
        return FileFormat::Pdf;
    if (ora::isOpenRaster(bytes))
        return FileFormat::OpenRaster;
    if (isXournalPackage(bytes))
        return FileFormat::Xournal;
    if (isGzip(bytes)) { // Of what is packed, only drawings and notebooks are read.
        const FileFormat packed = packedFormat(bytes);
        const bool isRead =
            packed == FileFormat::Svg || packed == FileFormat::Xournal || packed == FileFormat::Rnote;
        return isRead ? packed : FileFormat::Unknown;
    }
    if (isUniversalContainer(bytes))
        return FileFormat::UniversalInk;
    if (psd::isPsd(bytes))
        return FileFormat::Photoshop;
    const FileFormat format = formatOfText(bytes);
    // Whatever has happened to the start of a document, its whole parts are to be found.
    return format == FileFormat::Unknown && hasAnyChunk(bytes) ? FileFormat::Suffuse : format;
}

FileFormat formatForSaving(const QString &path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("suffuse"))
        return FileFormat::Suffuse;
    return ending == QLatin1String("json") ? FileFormat::Text : FileFormat::Unknown;
}

QString nameOf(FileFormat format)
{
    switch (format) {
    case FileFormat::Suffuse:
        return FileMessages::tr("Suffuse painting");
    case FileFormat::Text:
        return FileMessages::tr("Suffuse text form");
    case FileFormat::InkCsv:
        return FileMessages::tr("Ink recording (CSV)");
    case FileFormat::UniversalInk:
        return FileMessages::tr("Universal Ink");
    case FileFormat::Excalidraw:
        return FileMessages::tr("Excalidraw drawing");
    case FileFormat::MyPaintEvents:
        return FileMessages::tr("MyPaint events");
    case FileFormat::DiffusionCurves:
        return FileMessages::tr("Diffusion curves (XML)");
    case FileFormat::Svg:
        return FileMessages::tr("SVG drawing");
    case FileFormat::OpenRaster:
        return FileMessages::tr("OpenRaster picture");
    case FileFormat::Photoshop:
        return FileMessages::tr("Photoshop picture");
    case FileFormat::Xournal:
        return FileMessages::tr("Xournal++ notebook");
    case FileFormat::Pdf:
        return FileMessages::tr("PDF file");
    case FileFormat::InkMl:
        return FileMessages::tr("InkML recording");
    case FileFormat::Rnote:
        return FileMessages::tr("Rnote notebook");
    case FileFormat::Unknown:
        break;
    }
    return FileMessages::tr("Unknown format");
}

} // namespace suffuse

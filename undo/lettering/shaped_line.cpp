#include "undo/lettering/shaped_line.h"

#include "undo/lettering/vertical_forms.h"

#include <QFontDatabase>
#include <QFontInfo>
#include <QGlyphRun>
#include <QPainterPath>
#include <QRawFont>
#include <QTextBoundaryFinder>
#include <QTextLayout>

namespace suffuse {

namespace {

/// The em in pixels at which lines are shaped. Places are whole 64ths of a pixel, and a line of as many characters as a
/// text may have must fit into Qt's 26 bits before the point.
constexpr double shapedEm = 256;
constexpr qsizetype mostLines = 4'096; ///< that are kept
constexpr qsizetype mostGlyphs = 50'000;

/// Tabs and control characters have no outlines; a tab is as wide as an em.
QString shown(QString line)
{
    for (QChar &c : line)
        if (c == QLatin1Char('\t'))
            c = QChar(0x2003);
        else if (c.category() == QChar::Other_Control)
            c = QChar(0x200b);
    return line;
}

QFont fontOf(const Face &face)
{
    QFont font(face.family);
    font.setPixelSize(int(shapedEm));
    font.setWeight(QFont::Weight(std::clamp(int(std::lround(face.weight)), 1, 1000)));
    font.setItalic(face.italic);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setStyleStrategy(QFont::PreferOutline);
    if (face.hasSmallCaps)
        font.setCapitalization(QFont::SmallCaps);
    if (face.isSpaced) // Qt leaves ligatures out then. The room itself is added where the letters are placed.
        font.setLetterSpacing(QFont::AbsoluteSpacing, 1.0 / 64);
    return font;
}

/// The contours of a path, closed, without those of no length.
void append(LetterOutline &outline, const QPainterPath &path, double scale, Point offset)
{
    const auto at = [&](int i) {
        const QPainterPath::Element e = path.elementAt(i);
        return Point{e.x * scale, e.y * scale} + offset;
    };
    std::vector<Cubic> contour;
    Point start, now;
    const auto lineTo = [&](Point to) {
        if (to != now)
            contour.push_back({{now, now + (1.0 / 3) * (to - now), to - (1.0 / 3) * (to - now), to}});
        now = to;
    };
    const auto close = [&] {
        lineTo(start);
        if (!contour.empty())
            outline.push_back(std::exchange(contour, {}));
    };
    for (int i = 0; i < path.elementCount(); ++i) {
        const QPainterPath::ElementType type = path.elementAt(i).type;
        if (type == QPainterPath::MoveToElement) {
            close();
            start = now = at(i);
        } else if (type == QPainterPath::LineToElement) {
            lineTo(at(i));
        } else if (type == QPainterPath::CurveToElement && i + 2 < path.elementCount()) {
            const Cubic curve{{now, at(i), at(i + 1), at(i + 2)}};
            if (polygonLength(curve) > 0)
                contour.push_back(curve);
            now = curve.p[3];
            i += 2;
        }
    }
    close();
}

} // namespace

/// The outlines of glyphs, by font.
struct LineShaper::Glyphs {
    struct Of {
        QRawFont font; ///< with as many pixels an em as its designer's units, so that outlines are exact
        QHash<QByteArray, std::shared_ptr<const LetterOutline>> outlines;
    };
    QHash<QRawFont, Of> fonts;
    qsizetype count = 0;

    /// The outline of some glyphs of one font, in pixels of `shapedEm` from their left.
    std::shared_ptr<const LetterOutline> outline(const QRawFont &font, const QList<quint32> &glyphs,
                                                 const QList<QPointF> &places, double left)
    {
        if (count > mostGlyphs) {
            fonts.clear();
            count = 0;
        }
        Of &of = fonts[font];
        if (!of.font.isValid()) {
            of.font = font;
            of.font.setPixelSize(font.unitsPerEm());
        }
        QByteArray key;
        for (qsizetype k = 0; k < glyphs.size(); ++k) {
            // Whole 64ths, as they are.
            const qint64 parts[] = {glyphs[k], std::llround(64 * (places[k].x() - left)),
                                    std::llround(64 * places[k].y())};
            key.append(reinterpret_cast<const char *>(parts), sizeof parts);
        }
        const auto known = of.outlines.constFind(key);
        if (known != of.outlines.constEnd())
            return *known;
        auto made = std::make_shared<LetterOutline>();
        for (qsizetype k = 0; k < glyphs.size(); ++k)
            append(*made, of.font.pathForGlyph(glyphs[k]), font.pixelSize() / shapedEm / of.font.unitsPerEm(),
                   {(places[k].x() - left) / shapedEm, places[k].y() / shapedEm});
        ++count;
        return of.outlines[key] = made->empty() ? nullptr : std::move(made);
    }

    /// Gives a letter its form for vertical lines, if the font that it is of has one. Qt reaches none of OpenType's
    /// `vert`, but fonts have most of them under characters of their own, too.
    void makeVertical(ShapedCluster &cluster, QStringView letter, const QRawFont &font)
    {
        const std::optional<QChar> form = verticalFormOf(letter, cluster.width);
        if (!form || !font.supportsCharacter(*form))
            return;
        const QList<quint32> glyphs = font.glyphIndexesForString(QString(*form));
        if (glyphs.size() != 1)
            return;
        const auto made = outline(font, glyphs, {QPointF()}, 0);
        if (!made)
            return;
        cluster.outline = made;
        cluster.width = font.advancesForGlyphIndexes(glyphs, QRawFont::UseDesignMetrics)[0].x() / shapedEm;
        cluster.hasVerticalForm = true;
    }
};

LineShaper::LineShaper() : m_glyphs(std::make_unique<Glyphs>()) {}
LineShaper::~LineShaper() = default;

bool LineShaper::hasFamily(const QString &family)
{
    return QFontDatabase::families().contains(family, Qt::CaseInsensitive);
}

QString LineShaper::familyFor(const QString &family)
{
    return QFontInfo(QFont(family)).family();
}

std::shared_ptr<const ShapedLine> LineShaper::shape(const QString &string, const Face &face)
{
    if (face != m_face || m_lines.size() > mostLines)
        m_lines.clear();
    m_face = face;
    std::shared_ptr<const ShapedLine> &kept = m_lines[string];
    if (kept)
        return kept;
    auto out = std::make_shared<ShapedLine>();
    const QFont font = fontOf(face);
    const QRawFont metrics = QRawFont::fromFont(font);
    out->ascent = metrics.isValid() ? metrics.ascent() / shapedEm : 0.8;
    out->descent = metrics.isValid() ? metrics.descent() / shapedEm : 0.2;
    out->xHeight = metrics.isValid() ? metrics.xHeight() / shapedEm : 0.5;
    out->underline = metrics.isValid() ? metrics.underlinePosition() / shapedEm : 0.1;
    out->lineThickness = metrics.isValid() ? metrics.lineThickness() / shapedEm : 0.05;
    out->rightToLeft = string.isRightToLeft();

    QTextLayout layout(shown(string), font);
    QTextOption option(Qt::AlignLeft | Qt::AlignAbsolute);
    option.setUseDesignMetrics(true);
    option.setWrapMode(QTextOption::NoWrap);
    option.setTextDirection(out->rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
    layout.setTextOption(option);
    layout.setCacheEnabled(true);
    layout.beginLayout();
    QTextLine line = layout.createLine();
    if (line.isValid())
        line.setLineWidth(3e7);
    layout.endLayout();
    if (!line.isValid() || string.isEmpty())
        return kept = out;

    const double baseline = line.ascent();
    QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, string);
    std::pair<quint32, QPointF> lastGlyph{};
    for (qsizetype from = 0; from < string.size();) {
        const qsizetype next = finder.toNextBoundary(), to = next < 0 ? string.size() : next;
        QList<quint32> glyphs;
        QList<QPointF> places;
        QRawFont raw;
        double left = std::numeric_limits<double>::infinity(), right = -left;
        bool rightToLeft = false;
        for (const QGlyphRun &run : line.glyphRuns(int(from), int(to - from))) {
            raw = glyphs.isEmpty() ? run.rawFont() : raw;
            rightToLeft = run.isRightToLeft();
            const QList<quint32> indexes = run.glyphIndexes();
            const QList<QPointF> at = run.positions();
            const QList<QPointF> steps = run.rawFont().advancesForGlyphIndexes(indexes, QRawFont::UseDesignMetrics);
            for (qsizetype k = 0; k < indexes.size(); ++k) {
                left = std::min(left, at[k].x());
                right = std::max(right, at[k].x() + steps[k].x());
                if (run.rawFont() == raw) { // A mark of another font than its letter is left to that letter's font.
                    glyphs << indexes[k];
                    places << at[k] - QPointF(0, baseline);
                }
            }
        }
        // A ligature's glyph is told for each of its characters, or for the first one alone.
        const bool goesOn =
            !out->clusters.empty() && (glyphs.isEmpty() || lastGlyph == std::pair(glyphs.front(), places.front()));
        if (goesOn) {
            out->clusters.back().to = to;
        } else {
            ShapedCluster cluster{from, to, 0, 0, 0, rightToLeft, nullptr};
            if (!glyphs.isEmpty()) {
                cluster.left = left / shapedEm;
                cluster.width = std::max(0.0, right - left) / shapedEm;
                cluster.outline = m_glyphs->outline(raw, glyphs, places, left);
                lastGlyph = {glyphs.front(), places.front()};
                if (face.isVertical)
                    m_glyphs->makeVertical(cluster, QStringView(string).sliced(from, to - from), raw);
            }
            out->clusters.push_back(std::move(cluster));
        }
        from = to;
    }
    std::vector<ShapedCluster *> byPlace;
    for (ShapedCluster &cluster : out->clusters)
        byPlace.push_back(&cluster);
    std::ranges::stable_sort(byPlace, {}, [](const ShapedCluster *c) { return c->left; });
    double first = byPlace.empty() ? 0 : byPlace.front()->left;
    for (std::size_t k = 0; k < byPlace.size(); ++k) {
        ShapedCluster &cluster = *byPlace[k];
        cluster.left -= first;
        cluster.visual = int(k);
        out->width = std::max(out->width, cluster.left + cluster.width);
    }
    return kept = out;
}

} // namespace suffuse

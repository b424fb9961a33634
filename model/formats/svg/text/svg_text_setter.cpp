#include "model/formats/svg/text/svg_text_setter.h"

#include "model/area/offset_curve.h"
#include "model/geometry/affine.h"
#include "model/painting/validate.h"
#include "model/shaping/baseline_curve.h"
#include "model/shaping/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

/// A cluster that is being placed, user units.
struct Placed {
    qsizetype from = 0, to = 0; ///< in the text's string
    std::size_t run = 0;
    double width = 0;     ///< without what is added behind it
    double base = 0;      ///< where it begins on one line with all others
    Point at;             ///< where it begins
    double stretched = 1; ///< how much wider it is than the font says
    const ShapedCluster *shaped = nullptr;
};

/// Characters that are shaped together.
struct Run {
    qsizetype from = 0, to = 0;
    std::size_t style = 0;
    int path = -1;
    std::size_t chunk = 0;
    std::shared_ptr<const ShapedLine> line;
    std::size_t first = 0, end = 0; ///< its clusters
    double base = 0;                ///< where it begins on one line with all others
};

/// How far below the given baseline the letters' own one lies, user units.
double loweredBy(const SvgStyle &style, const ShapedLine &line)
{
    const QString &name = style.font.ownBaseline.isEmpty() ? style.font.baseline : style.font.ownBaseline;
    const auto is = [&name](const char *one) { return name == QLatin1String(one); };
    const double ems = is("middle")         ? 0.5 * line.xHeight
                       : is("central")      ? 0.5 * (line.ascent - line.descent)
                       : is("hanging")      ? 0.8 * line.ascent
                       : is("mathematical") ? 0.5 * line.ascent
                       : is("text-before-edge") || is("text-top") || is("before-edge") ? line.ascent
                       : is("text-after-edge") || is("text-bottom") || is("after-edge") || is("ideographic")
                           ? -line.descent
                           : 0;
    return ems * style.units.fontSize - style.font.raised;
}

class TextSetter {
public:
    TextSetter(SvgCharacters characters, LetterShaper &shaper, std::vector<QString> families)
        : m_in(std::move(characters)), m_shaper(shaper), m_families(std::move(families))
    {}

    /// No value if nothing can be shaped.
    std::optional<SvgSetText> set()
    {
        divide();
        if (!shape())
            return {};
        shift();
        for (const SvgStretch &stretch : m_in.stretches)
            this->stretch(stretch);
        anchor();
        SvgSetText out;
        place(out);
        out.text = asText();
        if (out.text && !out.text->curve.empty())
            out.shape = m_in.lines.front().shape;
        out.words = words();
        out.styles = std::move(m_in.styles); // A deque's elements stay where they are.
        return out;
    }

private:
    const SvgStyle &styleOf(const Run &run) const { return m_in.styles[run.style]; }
    const SvgCharacter &said(const Placed &cluster) const { return m_in.characters[std::size_t(cluster.from)]; }
    static bool isOfChunk(const SvgCharacter &c) { return c.x || c.y || c.begins; }

    /// What the text says, for people. Words at places of their own are apart, though no space may be between them;
    /// letters of a word that have their places one by one are not.
    QString words() const
    {
        QString all;
        std::optional<double> line;
        for (qsizetype i = 0; i < m_in.string.size(); ++i) {
            const SvgCharacter &c = m_in.characters[std::size_t(i)];
            const bool isOtherLine = (c.y && line && *c.y != *line) || (c.x && c.dy.value_or(0) != 0);
            if (i > 0 && isOfChunk(c) && (isOtherLine || c.begins || !isOfChunk(m_in.characters[std::size_t(i - 1)])))
                all += u' ';
            line = c.y ? c.y : line;
            all += m_in.string[i];
        }
        return all.simplified();
    }

    /// Runs end where the style, the line or the chunk does: at a place of its own a text begins anew.
    void divide()
    {
        std::size_t chunk = 0;
        for (qsizetype i = 0; i < m_in.string.size(); ++i) {
            const SvgCharacter &c = m_in.characters[std::size_t(i)];
            const bool begins = isOfChunk(c) || (!m_runs.empty() && c.path != m_runs.back().path);
            chunk += begins && i > 0 ? 1 : 0;
            if (m_runs.empty() || begins || c.style != m_runs.back().style)
                m_runs.push_back({i, i, c.style, c.path, chunk, nullptr, 0, 0, 0});
            m_runs.back().to = i + 1;
        }
    }

    bool shape()
    {
        double pen = 0;
        for (std::size_t r = 0; r < m_runs.size(); ++r) {
            Run &run = m_runs[r];
            const SvgStyle &style = styleOf(run);
            const double size = style.units.fontSize;
            const Face face{
                m_families[run.style],  style.font.weight, style.font.italic, style.font.letterSpacing != 0, false,
                style.font.hasSmallCaps};
            run.line = m_shaper.shape(m_in.string.mid(run.from, run.to - run.from), face);
            if (!run.line)
                return false;
            std::vector<const ShapedCluster *> visual(run.line->clusters.size());
            for (const ShapedCluster &cluster : run.line->clusters)
                visual[std::size_t(cluster.visual)] = &cluster;
            std::vector<double> from(visual.size());
            double added = 0;
            for (std::size_t k = 0; k < visual.size(); ++k) {
                from[k] = pen + visual[k]->left * size + added;
                added += style.font.letterSpacing;
                if (m_in.string[run.from + visual[k]->from] == u' ')
                    added += style.font.wordSpacing;
            }
            run.base = pen;
            run.first = m_clusters.size();
            for (const ShapedCluster &cluster : run.line->clusters) {
                const double at = from[std::size_t(cluster.visual)];
                m_clusters.push_back({run.from + cluster.from,
                                      run.from + cluster.to,
                                      r,
                                      cluster.width * size,
                                      at,
                                      {at, 0},
                                      1,
                                      &cluster});
            }
            run.end = m_clusters.size();
            pen += run.line->width * size + added;
        }
        return true;
    }

    /// dx and dy move what follows, x and y begin anew.
    void shift()
    {
        Point moved;
        for (Placed &cluster : m_clusters) {
            const SvgCharacter &c = said(cluster);
            const int path = c.path;
            const bool begins = m_runs[cluster.run].from == cluster.from && isOfChunk(c);
            std::optional<double> x = c.x, y = c.y;
            if (path >= 0 && c.begins)
                x = x.value_or(0) + m_in.lines[std::size_t(path)].start, y = 0;
            if (&cluster != m_clusters.data() && path < 0 && said(*(&cluster - 1)).path >= 0 && !x) {
                // Behind a line it goes on from its end.
                const auto &line = m_in.lines[std::size_t(said(*(&cluster - 1)).path)];
                x = line.curves.back().p[3].x, y = y.value_or(line.curves.back().p[3].y);
                moved.x = *x - m_runs[cluster.run].base;
            }
            if (begins && x)
                moved.x = *x - m_runs[cluster.run].base;
            if ((begins || x) && y)
                moved.y = *y;
            moved = moved + Point{c.dx.value_or(0), c.dy.value_or(0)};
            cluster.at = Point{cluster.base, 0} + moved;
            if (m_starts.size() == m_runs[cluster.run].chunk)
                m_starts.push_back(m_runs[cluster.run].base + moved.x);
        }
    }

    /// Gives characters a length together, by the room between them or by their own widths. What follows moves on.
    void stretch(const SvgStretch &stretch)
    {
        const auto first = std::ranges::find_if(m_clusters, [&](const Placed &c) { return c.from >= stretch.from; });
        const auto end = std::find_if(first, m_clusters.end(), [&](const Placed &c) { return c.from >= stretch.to; });
        if (first == end)
            return;
        double left = first->at.x, right = left;
        for (auto it = first; it != end; ++it) {
            left = std::min(left, it->at.x);
            right = std::max(right, it->at.x + it->width);
        }
        const double length = right - left;
        if (!(length > 0))
            return;
        std::vector<Placed *> byPlace;
        for (auto it = first; it != end; ++it)
            byPlace.push_back(&*it);
        std::ranges::stable_sort(byPlace, {}, [](const Placed *c) { return c->at.x; });
        const double factor = stretch.length / length;
        const double room = byPlace.size() > 1 ? (stretch.length - length) / double(byPlace.size() - 1) : 0;
        for (std::size_t k = 0; k < byPlace.size(); ++k) {
            Placed &c = *byPlace[k];
            if (stretch.isOfGlyphs) {
                c.at.x = left + factor * (c.at.x - left);
                c.width *= factor, c.stretched *= factor;
            } else {
                c.at.x += double(k) * room;
            }
        }
        for (auto it = end; it != m_clusters.end() && !(m_runs[it->run].from == it->from && isOfChunk(said(*it))); ++it)
            it->at.x += stretch.length - length;
    }

    template <class Use>
    void forEachChunk(Use use)
    {
        for (std::size_t i = 0; i < m_clusters.size();) {
            std::size_t end = i + 1;
            const std::size_t chunk = m_runs[m_clusters[i].run].chunk;
            while (end < m_clusters.size() && m_runs[m_clusters[end].run].chunk == chunk)
                ++end;
            use(std::span(m_clusters).subspan(i, end - i));
            i = end;
        }
    }

    void anchor()
    {
        forEachChunk([this](std::span<Placed> chunk) {
            const SvgFont &font = styleOf(m_runs[chunk.front().run]).font;
            double left = std::numeric_limits<double>::infinity(), right = -left;
            for (const Placed &c : chunk) {
                left = std::min(left, c.at.x);
                right = std::max(right, c.at.x + c.width);
            }
            TextAlignment to = font.anchor;
            if (font.isRightToLeft && to != TextAlignment::Centre)
                to = to == TextAlignment::Start ? TextAlignment::End : TextAlignment::Start;
            const double place = m_starts[m_runs[chunk.front().run].chunk];
            const double by = to == TextAlignment::Start    ? place - left
                              : to == TextAlignment::Centre ? place - 0.5 * (left + right)
                                                            : place - right;
            for (Placed &c : chunk)
                c.at.x += by;
        });
    }

    /// From ems of a letter to where it stands; no value beyond the ends of its line.
    std::optional<Affine> placeOf(const Placed &c)
    {
        const Run &run = m_runs[c.run];
        const SvgStyle &style = styleOf(run);
        const double size = style.units.fontSize, lowered = loweredBy(style, *run.line);
        const double angle = said(c).rotate * std::numbers::pi / 180;
        const Affine letter = Affine::rotation({}, angle) * Affine{size * c.stretched, 0, 0, size, {}};
        if (run.path < 0)
            return Affine::translation({c.at.x, c.at.y + lowered}) * letter;
        while (std::ssize(m_curves) <= run.path)
            m_curves.emplace_back(m_in.lines[m_curves.size()].curves);
        const BaselineCurve &curve = m_curves[std::size_t(run.path)];
        const double middle = c.at.x + 0.5 * c.width;
        if (middle < 0 || middle > curve.length())
            return {};
        const BaselineCurve::Place at = curve.at(middle);
        const Point d = at.direction;
        const Affine turned{d.x, -d.y, d.y, d.x, at.point};
        return turned * Affine::translation({-0.5 * c.width, c.at.y + lowered}) * letter;
    }

    static PenLine closed(std::vector<Cubic> curves)
    {
        PenLine line;
        line.curves = std::move(curves), line.isClosed = true;
        return line;
    }

    void place(SvgSetText &out)
    {
        for (const Run &run : m_runs) {
            const SvgStyle &style = styleOf(run);
            for (std::size_t i = run.first; i < run.end; ++i) {
                const Placed &c = m_clusters[i];
                const std::optional<Affine> place = placeOf(c);
                m_isWhole = m_isWhole && place;
                if (!place)
                    continue;
                for (const double x : {0.0, c.shaped->width})
                    for (const double y : {-run.line->ascent, run.line->descent})
                        out.box.include((*place)({x, y}));
                if (!c.shaped->outline)
                    continue;
                SvgLetter letter{m_in.string.mid(c.from, c.to - c.from), {}, &style};
                for (const std::vector<Cubic> &contour : *c.shaped->outline) {
                    std::vector<Cubic> curves = contour;
                    for (Cubic &curve : curves)
                        for (Point &p : curve.p)
                            p = (*place)(p);
                    letter.lines.push_back(closed(std::move(curves)));
                }
                out.letters.push_back(std::move(letter));
            }
            const SvgFont &font = style.font;
            const ShapedLine &line = *run.line;
            if (font.isUnderlined)
                rule(out, run, line.underline);
            if (font.isOverlined)
                rule(out, run, -line.ascent);
            if (font.isStruck)
                rule(out, run, -0.5 * line.xHeight);
        }
    }

    /// A line along a run, as far below its baseline, ems. It does not follow letters that are turned or on a curve.
    void rule(SvgSetText &out, const Run &run, double below)
    {
        if (run.path >= 0)
            return;
        const SvgStyle &style = styleOf(run);
        const double size = style.units.fontSize, thick = run.line->lineThickness * size;
        for (std::size_t i = run.first; i < run.end;) {
            const double height = m_clusters[i].at.y;
            double left = m_clusters[i].at.x, right = left;
            for (; i < run.end && m_clusters[i].at.y == height; ++i) {
                left = std::min(left, m_clusters[i].at.x);
                right = std::max(right, m_clusters[i].at.x + m_clusters[i].width);
            }
            const double y = height + loweredBy(style, *run.line) + below * size;
            const Point a{left, y - 0.5 * thick}, b{right, y - 0.5 * thick}, c{right, y + 0.5 * thick},
                d{left, y + 0.5 * thick};
            out.letters.push_back(
                {{},
                 {closed({straightCubic(a, b), straightCubic(b, c), straightCubic(c, d), straightCubic(d, a)})},
                 &style});
        }
    }

    /// Whether all that is said of places is where lines begin.
    bool isPlain() const
    {
        const bool hasOneLook =
            std::ranges::all_of(m_runs, [this](const Run &run) { return run.style == m_runs.front().style; });
        if (m_runs.empty() || !hasOneLook || !m_isWhole || !m_in.stretches.empty() || m_in.lines.size() > 1 ||
            m_in.isCut)
            return false;
        const SvgFont &font = styleOf(m_runs.front()).font;
        if (font.wordSpacing != 0 || font.hasSmallCaps || font.isUnderlined || font.isOverlined || font.isStruck)
            return false;
        return std::ranges::all_of(m_runs, [this](const Run &run) { return run.path == m_runs.front().path; }) &&
               std::ranges::all_of(m_in.characters, [](const SvgCharacter &c) {
                   return c.dx.value_or(0) == 0 && c.dy.value_or(0) == 0 && c.rotate == 0;
               });
    }

    /// Where the lines of a plain text begin, from top to bottom; none if they begin at different sides or are unevenly
    /// far from each other. `step` is how far they are from each other.
    std::vector<double> linesOf(double &step) const
    {
        std::vector<double> lines;
        const double size = styleOf(m_runs.front()).units.fontSize, alike = 1e-3 * size;
        const std::optional<double> x = m_in.characters.front().x;
        for (const Run &run : m_runs) {
            const SvgCharacter &c = m_in.characters[std::size_t(run.from)];
            const double y = m_clusters[run.first].at.y;
            if (!lines.empty() && (!c.x || !x || std::abs(*c.x - *x) > alike || y <= lines.back() + alike))
                return {};
            lines.push_back(y);
        }
        step = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k < lines.size(); ++k)
            step = std::min(step, lines[k] - lines[k - 1]);
        for (std::size_t k = 1; k < lines.size(); ++k) {
            const double steps = (lines[k] - lines[k - 1]) / step;
            if (std::abs(steps - std::round(steps)) * step > alike || steps > 100)
                return {};
        }
        return lines;
    }

    /// The part of the line along which a text stands as it is aligned: all of it, unless it starts elsewhere. It is
    /// empty where letters stand beyond it.
    std::vector<Cubic> curveOf(const Text &text) const
    {
        const Run &run = m_runs.front();
        const SvgTextLine &line = m_in.lines.front();
        const BaselineCurve curve(line.curves);
        const double whole = curve.length();
        const double start = line.start + m_in.characters.front().x.value_or(0);
        TextAlignment side = text.alignment;
        if (run.line->rightToLeft && side != TextAlignment::Centre)
            side = side == TextAlignment::Start ? TextAlignment::End : TextAlignment::Start;
        double from = side == TextAlignment::Start ? start : 0, to = side == TextAlignment::End ? start : whole;
        if (side == TextAlignment::Centre)
            from = std::max(0.0, 2 * start - whole), to = std::min(whole, 2 * start);
        const double rounding = 1e-3 * text.size;
        if (std::abs(from) <= rounding && std::abs(to - whole) <= rounding)
            return line.curves;
        const auto isOn = [&](const Placed &c) {
            const double middle = c.at.x + 0.5 * c.width;
            return middle >= from && middle <= to;
        };
        if (!(from >= 0 && from < to && to <= whole) || !std::ranges::all_of(m_clusters, isOn))
            return {};
        return curve.between(from, to);
    }

    std::optional<Text> asText() const
    {
        double step = 0;
        const std::vector<double> lines = !m_runs.empty() && isPlain() ? linesOf(step) : std::vector<double>();
        if (lines.empty())
            return {};
        const Run &first = m_runs.front();
        const SvgStyle &style = styleOf(first);
        Text text;
        text.family = m_families[first.style];
        text.weight = style.font.weight;
        text.italic = style.font.italic;
        text.size = style.units.fontSize;
        text.letterSpacing = float(style.font.letterSpacing / text.size);
        text.alignment = style.font.anchor;
        // Here texts begin on the side on which their writing does.
        const bool isOther = first.line->rightToLeft != style.font.isRightToLeft;
        if (isOther && text.alignment != TextAlignment::Centre)
            text.alignment = text.alignment == TextAlignment::Start ? TextAlignment::End : TextAlignment::Start;
        for (const Run &run : m_runs)
            if (run.line->rightToLeft != first.line->rightToLeft && text.alignment != TextAlignment::Centre)
                return {};
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (k > 0)
                text.string += QString(qsizetype(std::round((lines[k] - lines[k - 1]) / step)), u'\n');
            text.string += m_in.string.mid(m_runs[k].from, m_runs[k].to - m_runs[k].from);
        }
        if (lines.size() > 1)
            text.lineHeight = float(step / text.size);
        const double lowered = loweredBy(style, *first.line);
        if (first.path < 0) {
            text.place.offset = {m_in.characters.front().x.value_or(0), lines.front() + lowered};
        } else {
            text.curve = lowered == 0 ? curveOf(text) : std::vector<Cubic>();
            if (text.curve.empty())
                return {};
            text.followMap = Affine(m_in.lines.front().own);
        }
        return problemOf(text).isEmpty() ? std::optional(std::move(text)) : std::nullopt;
    }

    SvgCharacters m_in;
    LetterShaper &m_shaper;
    const std::vector<QString> m_families; ///< by style
    std::vector<Run> m_runs;
    std::vector<Placed> m_clusters; ///< in logical order
    std::vector<double> m_starts;   ///< of chunks
    std::vector<BaselineCurve> m_curves;
    bool m_isWhole = true; ///< whether all letters are seen
};

} // namespace

std::optional<SvgSetText> svgSetText(SvgCharacters characters, LetterShaper &shaper, std::vector<QString> families)
{
    return TextSetter(std::move(characters), shaper, std::move(families)).set();
}

} // namespace suffuse

#include "model/formats/svg/text/svg_characters.h"

#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/paths/svg_shapes.h"
#include "model/shaping/baseline_curve.h"

#include <QRegularExpression>

#include <algorithm>

namespace suffuse {

namespace {

std::vector<double> lengthsFrom(const QString &text, const SvgUnits &units, SvgAxis axis)
{
    static const QRegularExpression separator(QStringLiteral("[\\s,]+"));
    std::vector<double> lengths;
    for (const QString &length : text.split(separator, Qt::SkipEmptyParts)) {
        const std::optional<double> value = svgLength(length, units, axis);
        if (!value || std::ssize(lengths) >= Text::mostCharacters)
            break;
        lengths.push_back(*value);
    }
    return lengths;
}

bool isSameLook(const SvgStyle &a, const SvgStyle &b)
{
    const auto look = [](const SvgStyle &s) {
        const SvgFont &f = s.font;
        return std::tuple(s.units.fontSize, s.fill, s.stroke, s.fillOpacity, s.strokeOpacity, s.current, s.isVisible,
                          s.order, f.families, f.weight, f.italic, f.letterSpacing, f.wordSpacing, f.anchor,
                          f.isRightToLeft, f.isVertical, f.raised, f.baseline, f.ownBaseline, f.isUnderlined,
                          f.isOverlined, f.isStruck);
    };
    const auto pen = [](const Pen &p) {
        return std::tuple(p.width, p.cap, p.join, p.miterLimit, p.dashes, p.dashOffset);
    };
    return look(a) == look(b) && pen(a.pen) == pen(b.pen) && a.keepsWidth == b.keepsWidth;
}

/// Goes through a text, its spans and what lies along lines.
class Walk {
public:
    Walk(SvgTree &tree, qsizetype most, const SvgMatrix &matrix) : m_tree(tree), m_most(most), m_matrix(matrix) {}

    SvgCharacters of(const SvgElement &text, const SvgStyle &style)
    {
        enter(text, style);
        QString &s = m_out.string;
        if (s.endsWith(u' ') && !m_out.styles[m_out.characters.back().style].font.keepsSpace) {
            s.chop(1);
            m_out.characters.pop_back();
        }
        return std::move(m_out);
    }

private:
    /// The lists of places of an element that is open.
    struct Lists {
        std::vector<double> x, y, dx, dy, rotate;
        std::size_t used = 0; ///< characters so far
    };

    void enter(const SvgElement &element, const SvgStyle &style)
    {
        const SvgUnits &units = style.units;
        Lists lists;
        lists.x = lengthsFrom(element.attribute("x"), units, SvgAxis::Across);
        lists.y = lengthsFrom(element.attribute("y"), units, SvgAxis::Down);
        lists.dx = lengthsFrom(element.attribute("dx"), units, SvgAxis::Across);
        lists.dy = lengthsFrom(element.attribute("dy"), units, SvgAxis::Down);
        lists.rotate = lengthsFrom(element.attribute("rotate"), {}, SvgAxis::Any);
        if (element.name == QLatin1String("textPath"))
            lists.x.clear(), lists.y.clear(); // It has none.
        m_open.push_back(std::move(lists));
        const qsizetype from = m_out.string.size();
        const std::size_t index = indexOf(style);
        for (const auto &child : element.children)
            if (child->name == SvgElement::characterData)
                add(child->characters, index);
            else if (child->name == QLatin1String("tspan") || child->name == QLatin1String("a"))
                enterSpan(*child, style);
            else if (child->name == QLatin1String("textPath"))
                enterPath(*child, style);
        if (const std::optional<double> length = svgLength(element.attribute("textLength"), units, SvgAxis::Across);
            length && *length > 0 && m_out.string.size() > from)
            m_out.stretches.push_back({from, m_out.string.size(), *length,
                                       element.attribute("lengthAdjust") == QLatin1String("spacingAndGlyphs")});
        m_open.pop_back();
    }

    void enterSpan(const SvgElement &span, const SvgStyle &parent)
    {
        SvgStyle style = SvgStyle::of(span, parent, m_tree.sheet());
        style.matrix = m_matrix; // Spans cannot be moved so.
        style.isEvenOdd = false;
        if (style.isDisplayed)
            enter(span, style);
    }

    /// Text along what is no line is not seen.
    void enterPath(const SvgElement &element, const SvgStyle &parent)
    {
        const SvgElement *shape = m_tree.target(element);
        if (!shape || m_path >= 0)
            return;
        SvgTextLine line;
        const SvgMatrix own = svgTransform(shape->attribute("transform"));
        for (const PenLine &part : svgMapped(svgLines(svgPathData(shape->name, shape->attributes, parent.units)), own))
            line.curves.insert(line.curves.end(), part.curves.begin(), part.curves.end());
        const double whole = BaselineCurve(line.curves).length();
        if (!(whole > 0))
            return;
        SvgUnits units = parent.units;
        units.width = whole;
        line.shape = shape, line.own = own;
        line.start = svgLength(element.attribute("startOffset"), units, SvgAxis::Across).value_or(0);
        m_out.lines.push_back(std::move(line));
        m_path = int(m_out.lines.size()) - 1;
        m_begins = true;
        enterSpan(element, parent);
        m_path = -1;
    }

    std::size_t indexOf(const SvgStyle &style)
    {
        for (std::size_t i = m_out.styles.size(); i-- > 0 && i + 16 > m_out.styles.size();)
            if (isSameLook(m_out.styles[i], style))
                return i;
        m_out.styles.push_back(style);
        return m_out.styles.size() - 1;
    }

    void add(const QString &characters, std::size_t style)
    {
        const bool keepsSpace = m_out.styles[style].font.keepsSpace;
        for (qsizetype i = 0; i < characters.size(); ++i) {
            QChar c = characters[i];
            if (c == u'\n' || c == u'\t' || c == u'\r')
                c = u' ';
            if (c == u' ' && !keepsSpace && (m_out.string.isEmpty() || m_out.string.endsWith(u' ')))
                continue;
            if (m_out.string.size() >= m_most) {
                m_out.isCut = true;
                return;
            }
            const bool isSecond = c.isLowSurrogate() && i > 0 && characters[i - 1].isHighSurrogate();
            m_out.string += c;
            m_out.characters.push_back(isSecond ? SvgCharacter{.style = style, .path = m_path} : next(style));
        }
    }

    /// What the innermost element that says something says of the next character.
    SvgCharacter next(std::size_t style)
    {
        SvgCharacter out{.style = style, .path = m_path, .begins = std::exchange(m_begins, false)};
        bool isTurned = false;
        for (std::size_t i = m_open.size(); i-- > 0;) {
            Lists &lists = m_open[i];
            const std::size_t at = lists.used++;
            const auto take = [at](std::optional<double> &value, const std::vector<double> &list) {
                if (!value && at < list.size())
                    value = list[at];
            };
            take(out.x, lists.x), take(out.y, lists.y), take(out.dx, lists.dx), take(out.dy, lists.dy);
            if (!isTurned && !lists.rotate.empty()) {
                out.rotate = lists.rotate[std::min(at, lists.rotate.size() - 1)];
                isTurned = true;
            }
        }
        if (m_path >= 0 && !out.begins)
            out.y.reset();
        return out;
    }

    SvgTree &m_tree;
    const qsizetype m_most;
    const SvgMatrix m_matrix;
    SvgCharacters m_out;
    std::vector<Lists> m_open;
    int m_path = -1;
    bool m_begins = false;
};

} // namespace

SvgCharacters svgCharacters(const SvgElement &text, const SvgStyle &style, SvgTree &tree, qsizetype most)
{
    SvgStyle own = style;
    own.isEvenOdd = false;
    return Walk(tree, most, style.matrix).of(text, own);
}

} // namespace suffuse

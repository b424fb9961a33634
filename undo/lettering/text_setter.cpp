#include "undo/lettering/text_setter.h"

#include "model/shaping/baseline_curve.h"
#include "undo/lettering/vertical_forms.h"

namespace suffuse {

namespace {

/// The square of an ideographic letter, ems from its baseline.
constexpr double squareTop = 0.88, squareBottom = 0.12;

/// A line with the places where its letters begin along it, ems from where it begins.
struct SpacedLine {
    std::shared_ptr<const ShapedLine> shaped;
    std::vector<double> from; ///< of each cluster, in logical order
    std::vector<double> room; ///< that it takes, what is added behind it apart
    double length = 0;
};

Rect inkOf(const LetterOutline &outline)
{
    Rect box;
    for (const std::vector<Cubic> &contour : outline)
        for (const Cubic &curve : contour)
            box = box.united(curve.controlBox());
    return box;
}

class Setter {
public:
    explicit Setter(const Text &text)
        : m_text(text), m_curve(text.curve), m_isVertical(text.vertical && text.curve.empty())
    {
        m_out.clusters.reserve(std::size_t(text.string.size()));
    }

    void add(qsizetype from, qsizetype to, std::shared_ptr<const ShapedLine> shaped)
    {
        const SpacedLine line = spaced(std::move(shaped), QStringView(m_text.string).sliced(from, to - from));
        LaidLine laid;
        laid.from = from;
        laid.to = to;
        laid.firstCluster = m_out.clusters.size();
        laid.rightToLeft = line.shaped->rightToLeft;
        const double start = startOf(line);
        for (std::size_t k = 0; k < line.shaped->clusters.size(); ++k)
            m_out.clusters.push_back(set(line, k, start, from));
        laid.endCluster = m_out.clusters.size();
        if (laid.firstCluster < laid.endCluster) {
            laid.start = m_out.clusters[laid.firstCluster].before;
            laid.end = m_out.clusters.back().after;
        } else {
            laid.start = laid.end = caretOfEmpty(line, start);
        }
        m_out.lines.push_back(laid);
    }
    LaidText take() { return std::move(m_out); }

private:
    SpacedLine spaced(std::shared_ptr<const ShapedLine> shaped, QStringView string) const
    {
        SpacedLine line;
        const std::vector<ShapedCluster> &clusters = shaped->clusters;
        line.from.resize(clusters.size());
        line.room.resize(clusters.size());
        const double spacing = double(m_text.letterSpacing);
        std::vector<std::size_t> visual(clusters.size());
        for (std::size_t k = 0; k < clusters.size(); ++k)
            visual[std::size_t(clusters[k].visual)] = k;
        double at = 0;
        for (std::size_t i = 0; i < visual.size(); ++i) {
            const ShapedCluster &cluster = clusters[visual[i]];
            const bool upright = m_isVertical && standOf(string.sliced(cluster.from, cluster.to - cluster.from),
                                                         cluster.hasVerticalForm) != Stand::Turned;
            line.from[visual[i]] = m_isVertical ? at : cluster.left + double(i) * spacing;
            line.room[visual[i]] = upright ? squareTop + squareBottom : cluster.width;
            at += line.room[visual[i]] + spacing;
            line.length = line.from[visual[i]] + line.room[visual[i]];
        }
        line.shaped = std::move(shaped);
        return line;
    }

    /// Where the line begins along its axis, canvas units.
    double startOf(const SpacedLine &line) const
    {
        const double length = line.length * m_text.size, room = m_text.curve.empty() ? 0 : m_curve.length();
        TextAlignment alignment = m_text.alignment;
        if (line.shaped->rightToLeft && !m_isVertical && alignment != TextAlignment::Centre)
            alignment = alignment == TextAlignment::Start ? TextAlignment::End : TextAlignment::Start;
        switch (alignment) {
        case TextAlignment::Start:
            return 0;
        case TextAlignment::Centre:
            return 0.5 * (room - length);
        case TextAlignment::End:
            break;
        }
        return room - length;
    }

    /// How far the line is from the first one.
    double beside() const { return double(m_out.lines.size()) * double(m_text.lineHeight) * m_text.size; }

    /// From ems of a letter, whose middle has this x, to the curve.
    Affine onCurve(double along, double middle) const
    {
        const BaselineCurve::Place at = m_curve.at(along);
        const Point d = at.direction, down{-d.y, d.x};
        const double s = m_text.size;
        const Point origin = at.point + beside() * down - (s * middle) * d;
        return {s * d.x, s * down.x, s * d.y, s * down.y, origin};
    }

    LaidCluster set(const SpacedLine &line, std::size_t k, double start, qsizetype lineFrom)
    {
        const ShapedCluster &shaped = line.shaped->clusters[k];
        const double s = m_text.size, at = start + line.from[k] * s, room = line.room[k];
        LaidCluster out;
        out.from = lineFrom + shaped.from;
        out.to = lineFrom + shaped.to;
        out.line = int(m_out.lines.size());
        out.rightToLeft = shaped.rightToLeft;
        out.outline = shaped.outline;
        out.along = at + 0.5 * room * s;
        const double ascent = line.shaped->ascent, descent = line.shaped->descent;
        out.box = {0, -ascent, room, descent};
        if (m_isVertical)
            return hang(std::move(out), shaped, ascent, descent, at);
        out.place = m_text.curve.empty() ? Affine{s, 0, 0, s, {at, beside()}} : onCurve(out.along, 0.5 * room);
        const CaretLine left{out.place({0, -ascent}), out.place({0, descent})};
        const CaretLine right{out.place({room, -ascent}), out.place({room, descent})};
        out.before = out.rightToLeft ? right : left;
        out.after = out.rightToLeft ? left : right;
        return out;
    }

    /// A letter of a vertical line.
    LaidCluster hang(LaidCluster out, const ShapedCluster &shaped, double ascent, double descent, double at) const
    {
        const double s = m_text.size, axis = -beside();
        const Stand stand =
            standOf(QStringView(m_text.string).sliced(out.from, out.to - out.from), shaped.hasVerticalForm);
        if (stand == Stand::Turned) {
            const bool isSquare = shaped.width > 0.9 && !m_text.string.at(out.from).isSpace();
            const double middle = isSquare ? 0.5 * (squareTop - squareBottom) : 0.5 * (ascent - descent);
            out.place = {0, -s, s, 0, {axis - s * middle, at}};
            const CaretLine left{out.place({0, -ascent}), out.place({0, descent})};
            const CaretLine right{out.place({out.box.right, -ascent}), out.place({out.box.right, descent})};
            out.before = out.rightToLeft ? right : left;
            out.after = out.rightToLeft ? left : right;
            return out;
        }
        const double half = 0.5 * shaped.width;
        out.box = {half - 0.5, -squareTop, half + 0.5, squareBottom};
        out.before = {Point{axis + 0.5 * s, at}, Point{axis - 0.5 * s, at}};
        out.after = {Point{axis + 0.5 * s, at + s}, Point{axis - 0.5 * s, at + s}};
        out.place = {s, 0, 0, s, {axis - s * half, at + s * squareTop}};
        if (stand == Stand::OtherCorner && out.outline) {
            const Point ink = inkOf(*out.outline).centre(), middle{half, -0.5 * (squareTop - squareBottom)};
            out.place.offset = out.place.offset + (-2 * s) * (ink - middle);
        }
        return out;
    }

    /// The caret of a line without letters.
    CaretLine caretOfEmpty(const SpacedLine &line, double start) const
    {
        const double s = m_text.size, ascent = line.shaped->ascent, descent = line.shaped->descent;
        if (m_isVertical)
            return {Point{-beside() + 0.5 * s, start}, Point{-beside() - 0.5 * s, start}};
        const Affine place = m_text.curve.empty() ? Affine{s, 0, 0, s, {start, beside()}} : onCurve(start, 0);
        return {place({0, -ascent}), place({0, descent})};
    }

    const Text &m_text;
    const BaselineCurve m_curve;
    const bool m_isVertical;
    LaidText m_out;
};

} // namespace

std::optional<LaidText> layText(const Text &text, LetterShaper &shaper)
{
    const Face face{text.family, text.weight, text.italic, text.letterSpacing != 0,
                    text.vertical && text.curve.empty()};
    Setter setter(text);
    for (qsizetype from = 0; from <= text.string.size();) {
        const qsizetype end = text.string.indexOf(QLatin1Char('\n'), from), to = end < 0 ? text.string.size() : end;
        std::shared_ptr<const ShapedLine> line = shaper.shape(text.string.mid(from, to - from), face);
        if (!line)
            return {};
        setter.add(from, to, std::move(line));
        from = to + 1;
    }
    return setter.take();
}

std::optional<LaidText> layAsFilesDo(const Text &text)
{
    LetterShaper *shaper = letterShaper();
    return shaper ? layText(text, *shaper) : std::nullopt;
}

} // namespace suffuse

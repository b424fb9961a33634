#include "undo/lettering/laid_text.h"

#include <QTextBoundaryFinder>

namespace suffuse {

namespace {

using Boundary = QTextBoundaryFinder;

CaretLine between(const CaretLine &a, const CaretLine &b, double share)
{
    return {(1 - share) * a[0] + share * b[0], (1 - share) * a[1] + share * b[1]};
}

double fromCaret(Point p, const CaretLine &line)
{
    const Point way = line[1] - line[0];
    const double square = dot(way, way);
    const double t = square > 0 ? std::clamp(dot(p - line[0], way) / square, 0.0, 1.0) : 0;
    return length(p - (line[0] + t * way));
}

Point middleOf(const CaretLine &line)
{
    return 0.5 * (line[0] + line[1]);
}

/// Whether letters that follow each other stand apart, so that the first one ends before the place of the caret between
/// them. Where the direction of writing turns, the next letter stands somewhere else.
bool standApart(const LaidCluster &cluster, const LaidCluster &next)
{
    const Point end = middleOf(cluster.after);
    return cluster.rightToLeft == next.rightToLeft &&
           dot(middleOf(next.before) - end, end - middleOf(cluster.before)) > 0;
}

/// Whether what follows a boundary between words is a word: marks that follow each other are one, and blanks are none.
bool beginsWord(const QString &string, qsizetype boundary)
{
    const auto isMark = [](QChar c) { return c.isPunct() || c.isSymbol(); };
    if (boundary >= string.size() || string[boundary].isSpace())
        return false;
    return boundary == 0 || !isMark(string[boundary]) || !isMark(string[boundary - 1]);
}

} // namespace

std::array<Point, 4> LaidCluster::corners() const
{
    return {place({box.left, box.top}), place({box.right, box.top}), place({box.right, box.bottom}),
            place({box.left, box.bottom})};
}

int LaidText::lineOf(qsizetype position) const
{
    const auto behind = std::upper_bound(lines.begin(), lines.end(), position,
                                         [](qsizetype at, const LaidLine &line) { return at < line.from; });
    return std::max(0, int(behind - lines.begin()) - 1);
}

CaretLine LaidText::caretAt(qsizetype position) const
{
    const LaidLine &line = lines[std::size_t(lineOf(position))];
    if (position <= line.from)
        return line.start;
    if (position >= line.to)
        return line.end;
    const auto first = clusters.begin() + std::ptrdiff_t(line.firstCluster);
    const auto last = clusters.begin() + std::ptrdiff_t(line.endCluster);
    const auto behind = std::upper_bound(first, last, position,
                                         [](qsizetype at, const LaidCluster &cluster) { return at < cluster.from; });
    if (behind == first)
        return line.start;
    const LaidCluster &cluster = *(behind - 1);
    if (position >= cluster.to)
        return cluster.after;
    // Within a ligature, the characters share its width evenly.
    return between(cluster.before, cluster.after, double(position - cluster.from) / double(cluster.to - cluster.from));
}

qsizetype LaidText::positionInLine(int index, Point point, const QString &string) const
{
    const LaidLine &line = lines[std::size_t(index)];
    Boundary finder(Boundary::Grapheme, string);
    finder.setPosition(line.from);
    qsizetype best = line.from;
    double least = fromCaret(point, caretAt(line.from));
    const auto consider = [&](const CaretLine &caret, qsizetype position) {
        if (const double far = fromCaret(point, caret); far < least) {
            least = far;
            best = position;
        }
    };
    while (finder.position() < line.to) {
        const qsizetype next = finder.toNextBoundary();
        if (next < 0 || next > line.to)
            break;
        consider(caretAt(next), next);
    }
    // The caret stands at the next letter; but the half of a letter that is nearer to its end means behind it, too.
    for (std::size_t k = line.firstCluster; k + 1 < line.endCluster; ++k) {
        finder.setPosition(clusters[k].to);
        if (standApart(clusters[k], clusters[k + 1]) && finder.isAtBoundary())
            consider(clusters[k].after, clusters[k].to);
    }
    return best;
}

qsizetype LaidText::positionAt(Point point, const QString &string) const
{
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    const auto consider = [&](const CaretLine &caret, int line) {
        if (const double far = fromCaret(point, caret); far < least) {
            least = far;
            nearest = line;
        }
    };
    for (std::size_t k = 0; k < lines.size(); ++k) {
        consider(lines[k].start, int(k));
        consider(lines[k].end, int(k));
        for (std::size_t i = lines[k].firstCluster; i < lines[k].endCluster; ++i)
            consider(clusters[i].after, int(k));
    }
    return positionInLine(nearest, point, string);
}

std::vector<std::array<Point, 4>> LaidText::areasOf(qsizetype from, qsizetype to) const
{
    std::vector<std::array<Point, 4>> areas;
    for (const LaidCluster &cluster : clusters) {
        if (cluster.to <= from || cluster.from >= to)
            continue;
        const CaretLine a = from > cluster.from ? caretAt(from) : cluster.before;
        const CaretLine b = to < cluster.to ? caretAt(to) : cluster.after;
        areas.push_back({a[0], b[0], b[1], a[1]});
    }
    for (std::size_t k = 0; k + 1 < lines.size(); ++k)
        if (from <= lines[k].to && to > lines[k].to) { // the \n
            constexpr double share = 0.25;
            const CaretLine &end = lines[k].end;
            const Point down = end[1] - end[0];
            const Point on = (lines[k].rightToLeft ? -share : share) * Point{down.y, -down.x};
            areas.push_back({end[0], end[0] + on, end[1] + on, end[1]});
        }
    return areas;
}

Rect LaidText::box() const
{
    Rect box;
    for (const LaidLine &line : lines)
        for (const Point p : {line.start[0], line.start[1], line.end[0], line.end[1]})
            box.include(p);
    for (const LaidCluster &cluster : clusters)
        for (const Point corner : cluster.corners())
            box.include(corner);
    return box;
}

qsizetype nextPlace(const QString &string, qsizetype position)
{
    Boundary finder(Boundary::Grapheme, string);
    finder.setPosition(position);
    const qsizetype next = finder.toNextBoundary();
    return next < 0 ? string.size() : next;
}

qsizetype placeBefore(const QString &string, qsizetype position)
{
    Boundary finder(Boundary::Grapheme, string);
    finder.setPosition(position);
    const qsizetype before = finder.toPreviousBoundary();
    return before < 0 ? 0 : before;
}

qsizetype nextWord(const QString &string, qsizetype position)
{
    Boundary finder(Boundary::Word, string);
    finder.setPosition(position);
    while (finder.toNextBoundary() >= 0)
        if (beginsWord(string, finder.position()))
            return finder.position();
    return string.size();
}

qsizetype wordBefore(const QString &string, qsizetype position)
{
    Boundary finder(Boundary::Word, string);
    finder.setPosition(position);
    while (finder.toPreviousBoundary() >= 0)
        if (beginsWord(string, finder.position()))
            return finder.position();
    return 0;
}

std::pair<qsizetype, qsizetype> wordAt(const QString &string, qsizetype position)
{
    if (string.isEmpty())
        return {0, 0};
    Boundary finder(Boundary::Word, string);
    qsizetype from = std::clamp<qsizetype>(position, 0, string.size() - 1);
    finder.setPosition(from);
    if (!finder.isAtBoundary())
        from = std::max<qsizetype>(0, finder.toPreviousBoundary());
    finder.setPosition(from);
    const qsizetype to = finder.toNextBoundary();
    return {from, to < 0 ? string.size() : to};
}

} // namespace suffuse

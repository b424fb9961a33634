// Reads path data: the grammar of the attribute d.
#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/paths/svg_paths.h"

#include <QString>

#include <cmath>
#include <numbers>

namespace suffuse {

namespace {

constexpr std::size_t mostCurves = 2'000'000; ///< Bounds the memory for hostile input.

class PathData {
public:
    explicit PathData(const QString &text) : m_text(text) {}

    std::vector<PenLine> parse()
    {
        QChar command;
        while (m_count < mostCurves) {
            skipSpace();
            if (m_at >= m_text.size())
                break;
            if (m_text[m_at].isLetter())
                command = m_text[m_at++];
            else if (command.toLower() == 'z' || command.isNull())
                break;
            if (!step(command))
                break;
            if (command == 'M') // Further pairs of numbers are lines.
                command = 'L';
            else if (command == 'm')
                command = 'l';
        }
        finish(false);
        return std::move(m_lines);
    }

private:
    bool step(QChar command)
    {
        const bool relative = command.isLower();
        const QChar kind = command.toLower();
        if (!m_started && kind != 'm')
            return false;
        switch (kind.toLatin1()) {
        case 'm':
            return move(relative);
        case 'l': {
            const auto to = point(relative);
            return to && line(*to);
        }
        case 'h':
        case 'v':
            return along(kind == 'h', relative);
        case 'c': {
            const auto a = point(relative), b = point(relative), to = point(relative);
            return a && b && to && curve(*a, *b, *to, 'c');
        }
        case 's': {
            const auto b = point(relative), to = point(relative);
            return b && to && curve(m_last == 'c' ? reflected() : m_pen, *b, *to, 'c');
        }
        case 'q': {
            const auto control = point(relative), to = point(relative);
            return control && to && quadratic(*control, *to);
        }
        case 't': {
            const auto to = point(relative);
            return to && quadratic(m_last == 'q' ? reflected() : m_pen, *to);
        }
        case 'a':
            return arc(relative);
        case 'z':
            if (!(m_pen == m_start))
                line(m_start);
            m_isDrawn = true;
            finish(true);
            m_last = 0;
            return true;
        default:
            return false;
        }
    }

    bool move(bool relative)
    {
        const auto to = point(relative);
        if (!to)
            return false;
        finish(false);
        m_pen = m_start = *to;
        m_started = true;
        m_last = 0;
        return true;
    }

    bool along(bool horizontal, bool relative)
    {
        const auto value = number();
        if (!value)
            return false;
        Point to = m_pen;
        double &coordinate = horizontal ? to.x : to.y;
        coordinate = relative ? coordinate + *value : *value;
        return line(to);
    }

    bool line(Point to) { return curve(m_pen + (1.0 / 3) * (to - m_pen), to - (1.0 / 3) * (to - m_pen), to, 0); }

    bool quadratic(Point control, Point to)
    {
        const Point from = m_pen;
        curve(from + (2.0 / 3) * (control - from), to + (2.0 / 3) * (control - to), to, 'q');
        m_control = control;
        return true;
    }

    bool curve(Point a, Point b, Point to, char kind)
    {
        const Cubic cubic{{m_pen, a, b, to}};
        bool finite = true, isPoint = true;
        for (const Point &p : cubic.p) {
            finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
            isPoint = isPoint && p == m_pen;
        }
        if (!finite)
            return false;
        m_isDrawn = true;
        if (!isPoint) {
            m_curves.push_back(cubic);
            ++m_count;
        }
        m_pen = to;
        m_control = b;
        m_last = kind;
        return true;
    }

    Point reflected() const { return m_pen + (m_pen - m_control); }

    /// Adds an elliptical arc (SVG 2, B.2.4) as cubics of at most a quarter turn.
    bool arc(bool relative)
    {
        const auto rx0 = number(), ry0 = number(), turn = number();
        const auto large = flag(), sweep = flag();
        const auto end = point(relative);
        if (!rx0 || !ry0 || !turn || !large || !sweep || !end)
            return false;
        double rx = std::abs(*rx0), ry = std::abs(*ry0);
        const Point from = m_pen, to = *end;
        if (from == to)
            return true;
        if (!(rx > 0) || !(ry > 0))
            return line(to);
        const double angle = *turn * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
        const Point half = 0.5 * (from - to);
        const Point p{c * half.x + s * half.y, c * half.y - s * half.x};
        const double size = p.x * p.x / (rx * rx) + p.y * p.y / (ry * ry);
        if (size > 1) {
            rx *= std::sqrt(size);
            ry *= std::sqrt(size);
        }
        const double a = rx * rx * p.y * p.y + ry * ry * p.x * p.x;
        double k = std::sqrt(std::max(0.0, (rx * rx * ry * ry - a) / a));
        if (*large == *sweep)
            k = -k;
        const Point q{k * rx * p.y / ry, -k * ry * p.x / rx};
        const Point centre = 0.5 * (from + to) + Point{c * q.x - s * q.y, s * q.x + c * q.y};
        const double start = std::atan2((p.y - q.y) / ry, (p.x - q.x) / rx);
        double sweepAngle = std::atan2((-p.y - q.y) / ry, (-p.x - q.x) / rx) - start;
        if (*sweep && sweepAngle < 0)
            sweepAngle += 2 * std::numbers::pi;
        else if (!*sweep && sweepAngle > 0)
            sweepAngle -= 2 * std::numbers::pi;
        const auto at = [&](double t, double along) { // a point of the ellipse plus `along` times its derivative
            const double x = rx * (std::cos(t) - along * std::sin(t)), y = ry * (std::sin(t) + along * std::cos(t));
            return centre + Point{c * x - s * y, s * x + c * y};
        };
        if (!std::isfinite(sweepAngle)) // The squares of radii or ends have overflowed.
            return line(to);
        const int parts = std::max(1, int(std::ceil(std::abs(sweepAngle) / (std::numbers::pi / 2) - 1e-9)));
        const double step = sweepAngle / parts, handle = 4.0 / 3 * std::tan(step / 4);
        for (int i = 0; i < parts; ++i) {
            const double t = start + i * step, next = t + step;
            if (!curve(at(t, handle), at(next, -handle), i + 1 < parts ? at(next, 0) : to, 0))
                return false;
        }
        return true;
    }

    /// Ends a subpath. One to which something leads that has no extent is a point.
    void finish(bool isClosed)
    {
        if (m_isDrawn && m_count < mostCurves)
            m_lines.push_back({std::move(m_curves), isClosed, m_start, {1, 0}}), ++m_count;
        m_curves.clear();
        m_isDrawn = false;
        m_pen = m_start;
    }

    void skipSpace()
    {
        while (m_at < m_text.size() && (m_text[m_at].isSpace() || m_text[m_at] == ','))
            ++m_at;
    }

    std::optional<Point> point(bool relative)
    {
        const auto x = number(), y = number();
        if (!x || !y)
            return {};
        const Point p{*x, *y};
        return relative ? m_pen + p : p;
    }

    /// Reads a flag, which needs no space behind it: "a1 1 0 0110 10".
    std::optional<bool> flag()
    {
        skipSpace();
        if (m_at >= m_text.size() || (m_text[m_at] != '0' && m_text[m_at] != '1'))
            return {};
        return m_text[m_at++] == '1';
    }

    std::optional<double> number()
    {
        skipSpace();
        const qsizetype start = m_at;
        const auto digits = [this] {
            const qsizetype from = m_at;
            while (m_at < m_text.size() && m_text[m_at] >= '0' && m_text[m_at] <= '9')
                ++m_at;
            return m_at > from;
        };
        if (m_at < m_text.size() && (m_text[m_at] == '-' || m_text[m_at] == '+'))
            ++m_at;
        bool any = digits();
        if (m_at < m_text.size() && m_text[m_at] == '.') {
            ++m_at;
            any = digits() || any;
        }
        if (any && m_at < m_text.size() && m_text[m_at].toLower() == 'e') {
            const qsizetype exponent = m_at++;
            if (m_at < m_text.size() && (m_text[m_at] == '-' || m_text[m_at] == '+'))
                ++m_at;
            if (!digits())
                m_at = exponent;
        }
        bool ok = false;
        const double value = m_text.mid(start, m_at - start).toDouble(&ok);
        return any && ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
    }

    const QString m_text;
    qsizetype m_at = 0;
    std::size_t m_count = 0;
    bool m_started = false;
    Point m_pen, m_start, m_control;
    char m_last = 0; ///< 'c' or 'q' after a curve whose handle may be mirrored
    bool m_isDrawn = false; ///< whether a command has led on from where the subpath begins
    std::vector<Cubic> m_curves;
    std::vector<PenLine> m_lines;
};

} // namespace

std::vector<PenLine> svgLines(const QString &data)
{
    return PathData(data).parse();
}

std::vector<std::vector<Cubic>> parsePathData(const QString &data)
{
    std::vector<std::vector<Cubic>> subpaths;
    for (PenLine &line : svgLines(data))
        if (!line.curves.empty())
            subpaths.push_back(std::move(line.curves));
    return subpaths;
}

} // namespace suffuse

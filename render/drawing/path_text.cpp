#include "render/drawing/path_text.h"

#include <cmath>

namespace suffuse {

namespace {

constexpr double coarsestStep = 1e-3; ///< canvas units, of coordinates

int decimalsFor(const Canvas &canvas)
{
    const double step = std::min(coarsestStep, 1e-6 * std::max(canvas.width, canvas.height));
    return std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 3, 9);
}

/// Calls put(curve) for the pieces of a curve, each of which lies within `bend` of a line.
template <typename Put>
void cut(const Cubic &curve, double bend, const Put &put)
{
    const Point a = curve.p[0] - 2 * curve.p[1] + curve.p[2], b = curve.p[1] - 2 * curve.p[2] + curve.p[3];
    const int parts = std::max(1, int(std::ceil(std::sqrt(0.75 / bend * std::max(length(a), length(b))))));
    Cubic rest = curve;
    for (int k = parts; k > 0; --k) {
        const auto [part, after] = rest.split(1.0 / k);
        put(part);
        rest = after;
    }
}

} // namespace

PathText::PathText(const Canvas &canvas) : m_decimals(decimalsFor(canvas)), m_steps(std::pow(10.0, m_decimals)) {}

QByteArray PathText::svg(const contours::Loops &loops, double bend)
{
    m_text.clear();
    m_isRelative = true;
    for (const std::vector<Cubic> &loop : loops) {
        m_x = m_y = 0;
        m_text += 'M';
        m_pending = false;
        append(loop.front().p[0], true);
        m_text += 'c';
        m_pending = false;
        for (const Cubic &curve : loop)
            cut(curve, bend, [&](const Cubic &part) {
                append(part.p[1], false);
                append(part.p[2], false);
                append(part.p[3], true);
            });
        m_text += 'z';
    }
    return m_text;
}

QByteArray PathText::pdf(const contours::Loops &loops, double bend)
{
    m_text.clear();
    m_isRelative = false;
    m_x = m_y = 0;
    const auto end = [&](const char *operation) {
        m_text += operation;
        m_pending = false;
    };
    m_pending = false;
    for (const std::vector<Cubic> &loop : loops) {
        append(loop.front().p[0], false);
        end(" m\n");
        for (const Cubic &curve : loop)
            cut(curve, bend, [&](const Cubic &part) {
                for (int k = 1; k < 4; ++k)
                    append(part.p[k], false);
                end(" c\n");
            });
        end("h\n");
    }
    return m_text;
}

void PathText::append(Point p, bool moves)
{
    const qint64 x = std::llround(p.x * m_steps), y = std::llround(p.y * m_steps);
    append(x - m_x);
    append(y - m_y);
    if (moves)
        m_x = x, m_y = y;
}

void PathText::append(qint64 steps)
{
    // In SVG a minus parts numbers as a space does; readers of PDF want the space.
    if (m_pending && (steps >= 0 || !m_isRelative))
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

} // namespace suffuse

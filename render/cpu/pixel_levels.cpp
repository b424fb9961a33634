#include "render/cpu/pixel_levels.h"

#include <algorithm>
#include <numbers>

namespace suffuse::cpu {

namespace {

bool touch(const Rect &a, const Rect &b)
{
    return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

} // namespace

void PixelLevels::begin(const View &view, int x, int y)
{
    m_view = view;
    m_first = {x + 0.5, y + 0.5};
    m_known = false;
}

void PixelLevels::findCentres()
{
    if (m_known)
        return;
    m_known = true;
    const double cosine = std::cos(m_view.rotation), sine = std::sin(m_view.rotation);
    const auto centre = [&](int column, int row) {
        return m_view.toCanvas({m_first.x + column, m_first.y + row}, cosine, sine);
    };
    m_turned = sine != 0;
    if (m_turned) {
        for (int at = 0; at < blockSize; ++at)
            m_centres[std::size_t(at)] = centre(at % blockSide, at / blockSide);
    } else {
        for (int i = 0; i < blockSide; ++i) {
            m_columns[std::size_t(i)] = centre(i, 0).x;
            m_rows[std::size_t(i)] = centre(0, i).y;
        }
    }
    m_area = {};
    for (const int column : {0, blockSide - 1})
        for (const int row : {0, blockSide - 1})
            m_area.include(centre(column, row));
    m_area = m_area.grown(0.1 * m_view.px());
}

bool PixelLevels::mark(const SceneStroke &stroke, const TileFill *fill)
{
    const bool small = fill && fill->fill().level > 0;
    if (stroke.small.empty() && !small)
        return false;
    m_marks.fill(0);
    m_levels = 1;
    if (!stroke.small.empty())
        markSmall(stroke);
    if (small) {
        const auto mark = std::uint8_t(levelQuarters * fill->fill().level);
        const int x = int(m_first.x - 0.5), y = int(m_first.y - 0.5);
        fill->forEachNear(x, y, [&](int column, int row) {
            std::uint8_t &own = m_marks[std::size_t(row * blockSide + column)];
            own = std::max(own, mark);
            m_levels |= 1u << fill->fill().level;
        });
    }
    return m_levels > 1;
}

void PixelLevels::markSmall(const SceneStroke &stroke)
{
    findCentres();
    const double quarter = m_view.rotation / (0.5 * std::numbers::pi);
    const bool upright = std::abs(quarter - std::round(quarter)) < 1e-12;
    const double margin = m_view.px() * (upright ? 0.5 : std::numbers::sqrt2 / 2);
    const Rect near = m_area.grown(margin);
    int everywhere = 0; // the mark that all pixels have at least
    for (std::size_t i = 0; i < stroke.small.size(); ++i) {
        if (i % smallRun == 0 && !touch(stroke.smallRuns[i / smallRun], near)) {
            i += smallRun - 1;
            continue;
        }
        const SmallSegment &segment = stroke.small[i];
        const int mark = levelQuarters * segment.level + segment.quarter;
        if (mark <= everywhere || !touch(segment.reach, near))
            continue;
        const Rect box = segment.reach.grown(margin);
        if (box.contains({m_area.left, m_area.top}) && box.contains({m_area.right, m_area.bottom}))
            everywhere = mark, m_levels &= ~0u << segment.level; // No pixel has a lower one.
        if (raise(box, std::uint8_t(mark)))
            m_levels |= 1u << segment.level;
    }
}

PixelLevels::Span PixelLevels::within(const std::array<double, blockSide> &places, double low, double high) const
{
    Span s{0, blockSide - 1};
    const auto isIn = [&](int i) { return low <= places[std::size_t(i)] && places[std::size_t(i)] <= high; };
    while (s.first <= s.last && !isIn(s.first))
        ++s.first;
    while (s.first < s.last && !isIn(s.last))
        --s.last;
    return s;
}

/// Raises the marks of the pixels whose centres lie in a box. Returns whether there are any.
bool PixelLevels::raise(const Rect &box, std::uint8_t mark)
{
    if (m_turned) {
        bool any = false;
        for (std::size_t at = 0; at < m_marks.size(); ++at)
            if (box.contains(m_centres[at]))
                m_marks[at] = std::max(m_marks[at], mark), any = true;
        return any;
    }
    // Of a view that is not turned all pixels of a column have the same x, and all pixels of a row the same y.
    const Span columns = within(m_columns, box.left, box.right), rows = within(m_rows, box.top, box.bottom);
    if (columns.first > columns.last)
        return false;
    std::array<std::uint8_t, blockSide> raised{};
    std::fill(raised.begin() + columns.first, raised.begin() + columns.last + 1, mark);
    for (int row = rows.first; row <= rows.last; ++row) {
        std::uint8_t *marks = m_marks.data() + row * blockSide;
        for (std::size_t i = 0; i < raised.size(); ++i)
            marks[i] = std::max(marks[i], raised[i]);
    }
    return rows.first <= rows.last;
}

bool PixelLevels::has(int level, int column, int row, int side) const
{
    bool any = false;
    for (int y = row; y < row + side; ++y)
        for (int x = column; x < column + side; ++x)
            any |= at(y * blockSide + x) == level;
    return any;
}

} // namespace suffuse::cpu

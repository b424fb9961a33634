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
    for (int at = 0; at < blockSize; ++at)
        if (m_turned || at < blockSide || at % blockSide == 0)
            m_centres[std::size_t(at)] = centre(at % blockSide, at / blockSide);
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
    if (!stroke.small.empty())
        markSmall(stroke);
    if (small) {
        const auto mark = std::uint8_t(levelQuarters * fill->fill().level);
        const int x = int(m_first.x - 0.5), y = int(m_first.y - 0.5);
        fill->forEachNear(x, y, [&](int column, int row) {
            std::uint8_t &own = m_marks[std::size_t(row * blockSide + column)];
            own = std::max(own, mark);
        });
    }
    recount();
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
            everywhere = mark;
        raise(box, std::uint8_t(mark));
    }
}

/// Raises the marks of the pixels whose centres lie in a box.
void PixelLevels::raise(const Rect &box, std::uint8_t mark)
{
    if (m_turned) {
        for (std::size_t at = 0; at < m_marks.size(); ++at)
            if (box.contains(m_centres[at]))
                m_marks[at] = std::max(m_marks[at], mark);
        return;
    }
    // Of a view that is not turned all pixels of a column have the same x, and all pixels of a row the same y.
    std::array<std::uint8_t, blockSide> columns;
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i] = box.left <= m_centres[i].x && m_centres[i].x <= box.right ? mark : 0;
    for (std::size_t row = 0; row < m_marks.size(); row += columns.size())
        if (const double y = m_centres[row].y; box.top <= y && y <= box.bottom)
            for (std::size_t i = 0; i < columns.size(); ++i)
                m_marks[row + i] = std::max(m_marks[row + i], columns[i]);
}

void PixelLevels::recount()
{
    m_levels = 0;
    for (unsigned level = 0; level <= 6; ++level) {
        std::uint8_t any = 0; // A loop over bytes becomes one over vectors.
        for (const std::uint8_t mark : m_marks)
            any |= std::uint8_t(std::uint8_t(mark - levelQuarters * level) < levelQuarters);
        m_levels |= unsigned(any) << level;
    }
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

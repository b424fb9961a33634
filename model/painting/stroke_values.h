// Values that are computed for each stroke of a painting, at the cost of the strokes that changed.
#pragma once

#include "model/painting/stroke_list.h"

#include <utility>
#include <vector>

namespace suffuse {

/// A value for each stroke of a list, by its place in the order. The values of strokes that stay are kept.
template <class Value>
class StrokeValues {
public:
    /// Calls valueOf(const Stroke &) for strokes that were not there before. Returns true if the same strokes stand in
    /// the same order as before, whatever their values are.
    template <class ValueOf>
    bool follow(const StrokeList &strokes, ValueOf valueOf)
    {
        bool same = strokes.size() == m_strokes.size();
        if (same) {
            strokes.forEachDifference(m_strokes, [&](std::size_t i) {
                same = same && strokes[i]->id == std::as_const(m_strokes)[i]->id;
                m_values[i] = valueOf(*strokes[i]);
            });
        } else {
            realign(strokes, valueOf);
        }
        m_strokes = strokes;
        return same;
    }
    const Value &operator[](std::size_t place) const { return m_values[place]; }
    auto begin() const { return m_values.begin(); }
    auto end() const { return m_values.end(); }

private:
    /// Finds kept values. When strokes are added or removed, most of those below, between and above stay as they are.
    template <class ValueOf>
    void realign(const StrokeList &strokes, ValueOf valueOf)
    {
        constexpr std::size_t near = 8; // how many places ahead are compared
        const StrokeList &before = m_strokes;
        const std::size_t n = strokes.size(), old = before.size(), least = std::min(n, old);
        std::size_t below = 0, above = 0;
        while (below < least && strokes[below] == before[below])
            ++below;
        while (above < least - below && strokes[n - 1 - above] == before[old - 1 - above])
            ++above;
        std::vector<Value> values(m_values.begin(), m_values.begin() + std::ptrdiff_t(below));
        values.reserve(n);
        std::size_t next = below;
        for (std::size_t i = below; i < n - above; ++i) {
            const std::size_t end = std::min(next + near, old - above);
            std::size_t known = next;
            while (known < end && before[known] != strokes[i])
                ++known;
            if (known < end) {
                values.push_back(m_values[known]);
                next = known + 1;
            } else {
                values.push_back(valueOf(*strokes[i]));
                next += next < end && before[next]->id == strokes[i]->id;
            }
        }
        values.insert(values.end(), m_values.end() - std::ptrdiff_t(above), m_values.end());
        m_values = std::move(values);
    }

    StrokeList m_strokes;
    std::vector<Value> m_values;
};

} // namespace suffuse

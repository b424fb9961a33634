#include "app/session/layer_steps.h"

namespace suffuse {

void LayerSteps::add(int step, const PaintedLayer &before, const PaintedLayer &after)
{
    m_steps.erase(m_steps.lower_bound(step), m_steps.end());
    m_known.erase(m_known.lower_bound(step), m_known.end());
    m_known.insert_or_assign(step, std::pair(before.group, after.group));
    note(step, before, after);
}

void LayerSteps::note(int step, const PaintedLayer &before, const PaintedLayer &after)
{
    if (before.group != after.group || before.coming.has_value() != after.coming.has_value())
        m_steps.insert_or_assign(step, Step{before, after});
}

const PaintedLayer *LayerSteps::before(int step) const
{
    const auto it = m_steps.find(step);
    return it == m_steps.end() ? nullptr : &it->second.before;
}

std::optional<GroupId> LayerSteps::known(int from, int to) const
{
    const auto it = m_known.find(to < from ? to : to - 1);
    return it == m_known.end() ? std::nullopt : std::optional(to < from ? it->second.first : it->second.second);
}

std::optional<PaintedLayer> LayerSteps::walked(const PaintedLayer &layer, int from, int to) const
{
    std::optional<PaintedLayer> result;
    const auto pass = [&](int number, PaintedLayer Step::*here, PaintedLayer Step::*there) {
        const auto it = m_steps.find(number);
        if (it != m_steps.end() && (it->second.*here).group == (result ? *result : layer).group)
            result = it->second.*there;
    };
    for (int number = from; number > to; --number)
        pass(number - 1, &Step::after, &Step::before);
    for (int number = from; number < to; ++number)
        pass(number, &Step::before, &Step::after);
    return result;
}

} // namespace suffuse

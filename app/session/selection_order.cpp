#include "app/session/selection_order.h"

#include <algorithm>
#include <iterator>

namespace suffuse {

SelectionOrder::SelectionOrder(const Document &document, QObject *parent) : QObject(parent), m_document(document)
{
    connect(&document, &Document::changed, this, &SelectionOrder::follow);
}

void SelectionOrder::follow(const Change &change)
{
    if (!change.selection)
        return;
    const std::set<StrokeId> &now = m_document.selection().strokes;
    std::vector<StrokeId> known, added;
    for (std::vector<StrokeId> &step : m_steps) {
        std::erase_if(step, [&now](StrokeId id) { return !now.contains(id); });
        known.insert(known.end(), step.begin(), step.end());
    }
    std::erase_if(m_steps, [](const std::vector<StrokeId> &step) { return step.empty(); });
    std::sort(known.begin(), known.end());
    std::set_difference(now.begin(), now.end(), known.begin(), known.end(), std::back_inserter(added));
    if (!added.empty())
        m_steps.push_back(std::move(added));
}

StrokeId SelectionOrder::first() const
{
    return m_steps.empty() ? 0 : topmostOf(m_steps.front());
}

StrokeId SelectionOrder::last() const
{
    return m_steps.empty() ? 0 : topmostOf(m_steps.back());
}

StrokeId SelectionOrder::topmostOf(const std::vector<StrokeId> &strokes) const
{
    StrokeId topmost = strokes.front();
    if (strokes.size() > 1)
        for (const StrokePtr &stroke : m_document.painting()->strokes)
            if (std::binary_search(strokes.begin(), strokes.end(), stroke->id))
                topmost = stroke->id;
    return topmost;
}

} // namespace suffuse

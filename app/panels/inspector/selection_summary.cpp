#include "app/panels/inspector/selection_summary.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

struct SummaryText {
    Q_DECLARE_TR_FUNCTIONS(suffuse::InspectorPanel)
};

} // namespace

QString selectionSummary(const Inspected &inspected, bool inPart)
{
    std::size_t all = 0, lifting = 0;
    for (const Stroke *stroke : inspected.strokes) {
        all += stroke->segments.size();
        lifting += std::size_t(std::ranges::count_if(stroke->segments, &Segment::lift));
    }
    const std::size_t count = inspected.segments.size();
    const auto lifts = [](const InspectedSegment &s) { return s.segment->lift; };
    const auto meant = std::size_t(std::ranges::count_if(inspected.segments, lifts));
    if (meant == 0 && !inPart)
        all -= lifting; // whole strokes stand for what lays paint
    const QString segments = count == all ? SummaryText::tr("%Ln segment(s)", nullptr, int(all))
                                          : SummaryText::tr("%1 of %Ln segment(s)", nullptr, int(all)).arg(count);
    QString text = SummaryText::tr("%1 · %2").arg(
        SummaryText::tr("%Ln stroke(s)", nullptr, int(inspected.strokes.size())), segments);
    if (meant == 0 && !inPart && lifting > 0)
        text = SummaryText::tr("%1 · %2").arg(text, SummaryText::tr("%Ln erasing segment(s)", nullptr, int(lifting)));
    if (meant > 0)
        text += '\n' + (meant == count ? SummaryText::tr("They take paint away: the more density, the more.")
                                       : SummaryText::tr("%Ln of them take(s) paint away.", nullptr, int(meant)));
    return text;
}

} // namespace suffuse

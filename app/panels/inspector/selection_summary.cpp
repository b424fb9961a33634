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
    std::size_t all = 0, erasing = 0;
    for (const Stroke *stroke : inspected.strokes) {
        all += stroke->segments.size();
        erasing += std::size_t(std::ranges::count_if(stroke->segments, &Segment::takesPaint));
    }
    const std::size_t count = inspected.segments.size();
    const auto takes = [](const InspectedSegment &s) { return s.segment->takesPaint(); };
    const auto fades = [](const InspectedSegment &s) { return s.segment->fade; };
    const auto meant = std::size_t(std::ranges::count_if(inspected.segments, takes));
    if (meant == 0 && !inPart)
        all -= erasing; // whole strokes stand for what lays paint
    const QString segments = count == all ? SummaryText::tr("%Ln segment(s)", nullptr, int(all))
                                          : SummaryText::tr("%1 of %Ln segment(s)", nullptr, int(all)).arg(count);
    QString text = SummaryText::tr("%1 · %2").arg(
        SummaryText::tr("%Ln stroke(s)", nullptr, int(inspected.strokes.size())), segments);
    if (meant == 0 && !inPart && erasing > 0)
        text = SummaryText::tr("%1 · %2").arg(text, SummaryText::tr("%Ln erasing segment(s)", nullptr, int(erasing)));
    if (meant > 0 && std::ranges::all_of(inspected.segments, fades))
        text += '\n' + SummaryText::tr("They make paint paler.");
    else if (meant > 0)
        text += '\n' + (meant == count ? SummaryText::tr("They take paint away: the more density, the more.")
                                       : SummaryText::tr("%Ln of them take(s) paint away.", nullptr, int(meant)));
    return text;
}

} // namespace suffuse

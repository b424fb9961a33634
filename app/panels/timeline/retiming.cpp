#include "app/panels/timeline/retiming.h"

#include "app/session/editor.h"
#include "model/painting/editable.h"
#include "undo/time_edits.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

QString signedSeconds(Microseconds t)
{
    return (t < 0 ? QStringLiteral("−") : QStringLiteral("+")) + QLocale().toString(std::abs(toSeconds(t)), 'f', 3);
}

bool isErasure(const Segment &segment)
{
    return segment.takesPaint();
}

} // namespace

Retiming::Retiming(Editor &editor, Kind kind, const TimelineBar &held)
    : m_kind(kind), m_held(held), m_before(editor.document().painting()), m_selection(editor.document().selection()),
      m_drawn(drawnSpan(*m_before, m_selection))
{
    const Locks isLocked(m_before->groups);
    for (const StrokePtr &stroke : m_before->strokes) {
        if (!m_selection.strokes.contains(stroke->id) || isLocked(*stroke) ||
            std::ranges::none_of(stroke->segments, isErasure))
            continue;
        const auto first = m_selection.segments.lower_bound({stroke->id, 0}),
                   end = m_selection.segments.lower_bound({stroke->id, int(stroke->segments.size())});
        const auto isErasureOf = [&](const SegmentRef &ref) {
            return isErasure(stroke->segments[std::size_t(ref.segment)]);
        };
        // Whoever moves nothing but erasures knows it.
        m_hasErasures = m_hasErasures || first == end || !std::all_of(first, end, isErasureOf);
        m_movesErasures = m_movesErasures || first == end || std::any_of(first, end, isErasureOf);
    }
}

std::optional<Retiming> Retiming::begin(Editor &editor, Kind kind, const TimelineBar &held)
{
    Retiming retiming(editor, kind, held);
    if (retiming.m_drawn.end < retiming.m_drawn.begin)
        return {};
    retiming.m_gesture = editor.begin(retiming.eases()      ? tr("Ease in time")
                                      : kind == Kind::Shift ? tr("Move in time")
                                                            : tr("Stretch in time"));
    return retiming;
}

QString Retiming::moveBy(Microseconds by)
{
    auto [edit, words] = m_kind == Kind::Shift ? shifted(by) : eases() ? eased(by) : stretched(by);
    m_gesture.show(std::move(edit));
    return withErasures(words);
}

/// Erasures have no bar, so words say what becomes of them.
QString Retiming::withErasures(const QString &words) const
{
    return !m_hasErasures                             ? words
           : m_kind == Kind::Shift && m_movesErasures ? tr("%1, with its erasures").arg(words)
                                                      : tr("%1; erasures keep their time").arg(words);
}

std::pair<Edit, QString> Retiming::shifted(Microseconds by) const
{
    return {retime(*m_before, m_selection, by), tr("Later by %1 s").arg(signedSeconds(by))};
}

std::pair<Edit, QString> Retiming::stretched(Microseconds by) const
{
    // The end that is held follows the pointer, whichever stroke it belongs to.
    const bool begin = m_kind == Kind::StretchBegin;
    TimeSpan span = m_drawn;
    const Microseconds held = begin ? m_held.begin : m_held.drawn;
    const Microseconds fixed = begin ? span.end : span.begin;
    const double share = held == fixed ? 1 : double(held - fixed) / double((begin ? span.begin : span.end) - fixed);
    (begin ? span.begin : span.end) += Microseconds(std::llround(double(by) / share));
    if (begin)
        span.begin = std::min(span.begin, span.end);
    const double seconds = toSeconds(std::max<Microseconds>(span.end - span.begin, 0));
    return {by != 0 ? stretch(*m_before, m_selection, span) : retime(*m_before, m_selection, 0),
            tr("Drawn in %1 s").arg(QLocale().toString(seconds, 'f', 3))};
}

std::pair<Edit, QString> Retiming::eased(Microseconds by) const
{
    // When the pointer has moved half of the bar inwards, the pen is as slow there as it can be.
    const bool begin = m_kind == Kind::EaseBegin;
    const double half = 0.5 * double(std::max<Microseconds>(m_held.drawn - m_held.begin, 1));
    const double slower = std::pow(Ease::most, std::clamp(double(begin ? by : -by) / half, -1.0, 1.0));
    const QString pace = QLocale().toString(100 / slower, 'f', 0);
    return {ease(*m_before, m_selection, begin ? Ease{slower, 1} : Ease{1, slower}),
            begin ? tr("Begins at %1 % of its pace").arg(pace) : tr("Ends at %1 % of its pace").arg(pace)};
}

} // namespace suffuse

#include "app/session/commands/reshaping.h"

#include "app/session/settings/settings.h"
#include "model/painting/editable.h"
#include "model/painting/validate.h"
#include "model/shaping/curves/fairing.h"
#include "model/shaping/curves/simplify.h"
#include "model/shaping/nodes/bending.h"
#include "undo/run_edits.h"

#include <QCoreApplication>

namespace suffuse {

namespace {

struct StoredAmount {
    const char *key;
    double ReshapeAmounts::*amount;
    double least, most;
};
constexpr StoredAmount storedAmounts[] = {
    {"reshape/distance", &ReshapeAmounts::distance, 0, 1e6},      {"reshape/values", &ReshapeAmounts::values, 0, 10},
    {"reshape/smoothing", &ReshapeAmounts::smoothing, 1e-6, 1e6}, {"reshape/straight", &ReshapeAmounts::straight, 0, 1},
    {"reshape/width", &ReshapeAmounts::width, 0.01, 100},         {"reshape/aside", &ReshapeAmounts::aside, -1e6, 1e6}};

/// Paint k times as wide: D·k² and φˢ·k scale the whole cross-section, as a transform with the spread does.
Stroke widened(const Stroke &stroke, double k, const std::vector<bool> &chosen)
{
    Stroke result = stroke;
    for (std::size_t i = 0; i < result.segments.size(); ++i) {
        Segment wider = result.segments[i];
        wider.diffusion = float(double(wider.diffusion) * k * k);
        wider.density = float(double(wider.density) * k);
        if ((chosen.empty() || chosen[i]) && problemOf(wider).isEmpty())
            result.segments[i] = std::move(wider);
    }
    return result;
}

/// What a selection of a stroke's segments means; none are the whole stroke. One segment alone cannot become fewer, and
/// every click with the Segments tool selects one: it means its stroke or, where it takes paint away, its chain.
std::vector<bool> meantBy(const std::vector<bool> &chosen, const Stroke &stroke, Reshaping what)
{
    if (chosen.empty())
        return meantOfWhole(stroke);
    if (what != Reshaping::Simplify || std::ranges::count(chosen, true) != 1)
        return chosen;
    const auto one = int(std::ranges::find(chosen, true) - chosen.begin());
    if (!stroke.segments[std::size_t(one)].takesPaint())
        return meantOfWhole(stroke);
    const Chain chain = chainAt(stroke, one);
    std::vector<bool> meant(chosen.size());
    std::fill(meant.begin() + chain.first, meant.begin() + chain.last + 1, true);
    return meant;
}

ReshapeRuns changeOf(Reshaping what, const ReshapeAmounts &a)
{
    using Chosen = const std::vector<bool> &;
    switch (what) {
    case Reshaping::Simplify:
        return [a](const Stroke &stroke, Chosen chosen, std::vector<int> *sources) {
            return simplified(stroke, {a.distance, a.values}, chosen, sources);
        };
    case Reshaping::Smooth: {
        // A wiggle of wave length l loses ninety per cent where deviation·2π/l is 2.4.
        const double deviation = 0.38 * a.smoothing;
        return [deviation](const Stroke &stroke, Chosen chosen, std::vector<int> *) {
            return smoothed(stroke, deviation, chosen);
        };
    }
    case Reshaping::Straighten:
        return [a](const Stroke &stroke, Chosen chosen, std::vector<int> *) {
            return straightened(stroke, a.straight, chosen);
        };
    case Reshaping::Width:
        return
            [a](const Stroke &stroke, Chosen chosen, std::vector<int> *) { return widened(stroke, a.width, chosen); };
    case Reshaping::Offset:
        break;
    }
    return [a](const Stroke &stroke, Chosen chosen, std::vector<int> *sources) {
        return offsetAside(stroke, a.aside, chosen, sources);
    };
}

} // namespace

ReshapeAmounts ReshapeAmounts::stored()
{
    ReshapeAmounts amounts;
    for (const StoredAmount &s : storedAmounts) {
        const double value = settings::store().value(QLatin1String(s.key), amounts.*s.amount).toDouble();
        if (value >= s.least && value <= s.most)
            amounts.*s.amount = value;
    }
    return amounts;
}

void ReshapeAmounts::store() const
{
    for (const StoredAmount &s : storedAmounts)
        settings::store().setValue(QLatin1String(s.key), this->*s.amount);
}

QString nameOf(Reshaping what)
{
    switch (what) {
    case Reshaping::Simplify:
        return QCoreApplication::translate("Commands", "Simplify");
    case Reshaping::Smooth:
        return QCoreApplication::translate("Commands", "Smooth strokes");
    case Reshaping::Straighten:
        return QCoreApplication::translate("Commands", "Straighten");
    case Reshaping::Width:
        return QCoreApplication::translate("Commands", "Grow or shrink paint");
    case Reshaping::Offset:
        break;
    }
    return QCoreApplication::translate("Commands", "Offset");
}

Edit reshapeEdit(const Document &document, const Painting &before, const Selection &selection, Reshaping what,
                 const ReshapeAmounts &amounts)
{
    return reshapeSelection(document, before, selection,
                            [what, change = changeOf(what, amounts)](
                                const Stroke &stroke, const std::vector<bool> &chosen, std::vector<int> *sources) {
                                return change(stroke, meantBy(chosen, stroke, what), sources);
                            });
}

QString reshapeSelected(Editor &editor, Reshaping what, const ReshapeAmounts &amounts)
{
    const Document &document = editor.document();
    const PaintingPtr before = document.painting();
    if (chosenCount(*before, document.selection()) == 0)
        return QCoreApplication::translate("Commands", "What is selected is locked or hidden.");
    Edit edit = reshapeEdit(document, *before, document.selection(), what, amounts);
    if (edit.isEmpty())
        return QCoreApplication::translate("Commands", "Nothing changes.");
    editor.push(std::move(edit), nameOf(what));
    return {};
}

std::size_t chosenCount(const Painting &painting, const Selection &selection)
{
    std::size_t count = 0;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (selection.strokes.contains(stroke->id) && isEditable(*stroke)) {
            const std::vector<bool> chosen = chosenSegments(*stroke, selection);
            count += chosen.empty() ? stroke->segments.size() : std::size_t(std::ranges::count(chosen, true));
        }
    return count;
}

} // namespace suffuse

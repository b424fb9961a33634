#include "app/session/colour/colour_target.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "model/colour/colour_shift.h"
#include "model/colour/one_colour.h"
#include "undo/colour_edits.h"

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

const QString modeKey = QStringLiteral("colour/shifts");

/// One colour of a gradient, or nothing where the stroke cannot be changed or has no gradient.
ColourParts partsOfEnd(const Painting &painting, const Selection &selection, const GradientEnd &end)
{
    const StrokePtr stroke = painting.find(end.stroke);
    if (!stroke || !selection.strokes.contains(end.stroke) || !stroke->fill || !stroke->fill->gradient ||
        !painting.isVisible(*stroke) || painting.isLocked(*stroke))
        return {};
    return {{stroke, std::vector<bool>(stroke->segments.size()), !end.isSecond, end.isSecond}};
}

/// The opacity of an end that takes a colour; that of the other end where it has none itself.
float seenOpacity(const ColourPart &end, float opacity)
{
    if (opacity > 0)
        return opacity;
    const float other = (end.gradient ? end.stroke->fill->colour : end.stroke->fill->gradient->colour).opacity;
    return other > 0 ? other : 1;
}

} // namespace

ColourTarget::ColourTarget(Editor &editor)
    : m_editor(editor), m_mode(settings::store().value(modeKey).toBool() ? Mode::Shift : Mode::Set)
{
    connect(&editor, &Editor::brushChanged, this, [this] {
        if (kind() == Kind::Brush)
            emit changed();
    });
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &ColourTarget::follow);
}

ColourTarget::Kind ColourTarget::kind() const
{
    if (isSwatchThere())
        return Kind::Swatch;
    const bool refines = m_end || m_use == ToolUse::Refines;
    const Kind wanted = (m_end ? m_chosenForEnd : m_chosen).value_or(refines ? Kind::Selection : Kind::Brush);
    return wanted == Kind::Selection && m_selected ? Kind::Selection : Kind::Brush;
}

void ColourTarget::choose(Kind kind)
{
    (m_end ? m_chosenForEnd : m_chosen) = kind;
    m_swatch.reset();
    emit changed();
}

void ColourTarget::useTool(ToolUse use)
{
    m_isToolPainting = use == ToolUse::Paints;
    if (use == ToolUse::PaintsOver)
        use = ToolUse::Paints;
    if (use == ToolUse::Either || use == m_use)
        return;
    m_use = use;
    m_chosen.reset();
    m_swatch.reset();
    emit changed();
}

void ColourTarget::editSwatch(std::size_t index)
{
    const std::vector<Swatch> &swatches = m_editor.document().painting()->swatches;
    if (index >= swatches.size())
        return;
    m_swatch = {index, swatches};
    emit changed();
}

void ColourTarget::chooseEnd(std::optional<GradientEnd> end)
{
    if (!end && !m_end)
        return;
    m_end = end;
    m_chosenForEnd.reset();
    m_swatch.reset();
    m_start.reset();
    summarise();
    emit changed();
}

void ColourTarget::endSwatch()
{
    if (!m_swatch)
        return;
    m_swatch.reset();
    emit changed();
}

/// Whether the list is the one in which it was chosen, but for what it is itself: its colour, its name, its link.
bool ColourTarget::isSwatchThere() const
{
    if (!m_swatch)
        return false;
    const std::vector<Swatch> &now = m_editor.unsettled().painting()->swatches;
    if (now.size() != m_swatch->list.size())
        return false;
    for (std::size_t i = 0; i < now.size(); ++i)
        if (i != m_swatch->index && now[i] != m_swatch->list[i])
            return false;
    return true;
}

void ColourTarget::setMode(Mode mode)
{
    m_mode = mode;
    settings::store().setValue(modeKey, mode == Mode::Shift);
    summarise();
    emit changed();
}

Colour ColourTarget::colour() const
{
    switch (kind()) {
    case Kind::Selection:
        return m_selected->usual;
    case Kind::Swatch:
        return m_editor.unsettled().painting()->swatches[m_swatch->index].colour;
    case Kind::Brush:
        break;
    }
    return m_editor.brush().colour;
}

QString ColourTarget::title() const
{
    if (kind() == Kind::Brush)
        return tr("Colour of the brush");
    if (kind() == Kind::Swatch) {
        const QString &name = m_editor.unsettled().painting()->swatches[m_swatch->index].name;
        return name.isEmpty() ? tr("Colour of a swatch") : tr("Colour of the swatch “%1”").arg(name);
    }
    const Document &document = m_editor.unsettled();
    if (m_end && !partsOfEnd(*document.painting(), document.selection(), *m_end).empty())
        return m_end->isSecond ? tr("Colour of the gradient's end") : tr("Colour of the gradient's start");
    const ColourSummary &summary = *m_selected;
    const bool ofSegments = !document.selection().segments.empty();
    if (ofSegments && summary.onlyFills && summary.strokes == 1)
        return summary.several ? tr("Colours of the fill") : tr("Colour of the fill");
    if (ofSegments && !summary.onlyFills)
        return summary.several ? tr("Colours of %Ln segment(s)", "", int(summary.segments))
                               : tr("Colour of %Ln segment(s)", "", int(summary.segments));
    return summary.several ? tr("Colours of %Ln stroke(s)", "", int(summary.strokes))
                           : tr("Colour of %Ln stroke(s)", "", int(summary.strokes));
}

void ColourTarget::follow(const Change &change)
{
    const bool hadSelected = m_selected.has_value();
    if (change.reset || change.selection || !isSwatchThere())
        m_swatch.reset();
    if (change.reset)
        m_start.reset();
    if (change.reset || change.selection || change.canvas || !change.strokes.empty())
        summarise();
    const bool another = change.reset || change.selection || change.canvas || hadSelected != m_selected.has_value();
    if (another || kind() == Kind::Selection)
        emit changed();
}

/// What a colour is for, of what is selected.
ColourParts ColourTarget::partsMeant(const Painting &painting) const
{
    const Selection &selection = m_editor.unsettled().selection();
    if (selection.isEmpty())
        return {};
    if (m_end)
        if (ColourParts end = partsOfEnd(painting, selection, *m_end); !end.empty())
            return end;
    return partsToColour(painting, selection);
}

void ColourTarget::summarise()
{
    m_selected.reset();
    if (const ColourParts parts = partsMeant(*m_editor.unsettled().painting()); !parts.empty())
        m_selected = summaryOf(parts, m_mode == Mode::Shift);
}

/// What is meant, as it was when the drag began or, where nothing is dragged, as it is now.
const ColourTarget::Start &ColourTarget::startOf(ValueEntry *entry)
{
    const bool goesOn =
        m_start && entry && entry->isDragging() && m_start->entry == entry && m_editor.undecided() != nullptr;
    if (goesOn)
        return *m_start;
    const Painting &painting = *m_editor.document().painting();
    if (kind() == Kind::Swatch) {
        m_start = {usersOf(painting, m_swatch->index), colour(), entry};
        return *m_start;
    }
    ColourParts parts = partsMeant(painting);
    const Colour usual = parts.empty() ? Colour() : summaryOf(parts, m_mode == Mode::Shift).usual;
    m_start = {std::move(parts), usual, entry};
    return *m_start;
}

void ColourTarget::setPaint(const Colour &colour, ValueEntry *entry)
{
    switch (kind()) {
    case Kind::Brush:
        m_editor.setColour(withOpacity(colour, m_editor.brush().colour.opacity));
        return;
    case Kind::Swatch:
        colourSwatch(withOpacity(colour, this->colour().opacity), entry);
        return;
    case Kind::Selection:
        break;
    }
    const Start &start = startOf(entry);
    const Colour from = start.colour;
    if (m_end && start.parts.size() == 1 && start.parts.front().count() == 0) {
        const ColourPart end = start.parts.front();
        colourSelection([&](const Colour &each) { return withOpacity(colour, seenOpacity(end, each.opacity)); },
                        tr("Change colour"), entry);
        return;
    }
    // What a brush has strayed by stays, where people see one colour and are not asked what to do with several.
    const bool sets = m_mode == Mode::Set && !looksLikeOne(start.parts, from);
    const ColourShift shift = sets ? ColourShift() : shiftBetween(from, colour);
    colourSelection(
        [=](const Colour &each) {
            const bool becomesIt = sets || samePaint(each, from);
            return becomesIt ? withOpacity(colour, each.opacity) : shifted(each, shift);
        },
        tr("Change colour"), entry);
}

void ColourTarget::setChannel(float Colour::*channel, float value, ValueEntry *entry)
{
    Colour paint = colour();
    paint.*channel = value;
    if (kind() != Kind::Selection || m_end)
        return setPaint(paint, entry);
    const Start &start = startOf(entry);
    const bool isOne = looksLikeOne(start.parts, start.colour);
    if (!isOne && m_mode == Mode::Shift)
        return setPaint(paint, entry);
    const float by = value - start.colour.*channel;
    colourSelection(
        [=, from = start.colour.*channel](Colour each) {
            const bool becomesIt = !isOne || each.*channel == from;
            each.*channel = becomesIt ? value : std::clamp(each.*channel + by, 0.0f, 1.0f);
            return each;
        },
        tr("Change colour"), entry);
}

void ColourTarget::setOpacity(float opacity, ValueEntry *entry)
{
    const auto thinned = [opacity](const Colour &each) { return withOpacity(each, opacity); };
    const bool drags = entry && entry->isDragging();
    switch (kind()) {
    case Kind::Brush:
        m_editor.setColour(thinned(m_editor.brush().colour));
        return;
    case Kind::Swatch:
        colourSwatch(thinned(colour()), entry);
        return;
    case Kind::Selection:
        break;
    }
    const float by = opacity - startOf(entry).colour.opacity;
    const auto shiftedBy = [by](const Colour &each) {
        return withOpacity(each, std::clamp(each.opacity + by, 0.0f, 1.0f));
    };
    if (drags) // A slider keeps what varies, as those of the inspector do; a number is meant for all.
        colourSelection(shiftedBy, tr("Change opacity"), entry);
    else
        colourSelection(thinned, tr("Change opacity"), entry);
}

void ColourTarget::changeEach(const std::function<Colour(const Colour &)> &map, ValueEntry *entry)
{
    if (kind() == Kind::Selection)
        colourSelection(map, tr("Change colour"), entry);
}

void ColourTarget::take(const Colour &colour)
{
    if (kind() == Kind::Brush && colour.opacity != 1)
        m_editor.setColour(colour);
    else
        setPaint(colour);
}

void ColourTarget::colourSelection(const std::function<Colour(const Colour &)> &map, const QString &name,
                                   ValueEntry *entry)
{
    m_editor.push(recolour(m_editor.document(), startOf(entry).parts, map), name, entry);
}

void ColourTarget::colourSwatch(const Colour &colour, ValueEntry *entry)
{
    const Start &start = startOf(entry);
    m_editor.push(changeSwatch(m_editor.document(), m_swatch->index, colour, start.parts), tr("Change swatch"), entry);
}

} // namespace suffuse

#include "app/session/colour/recolouring.h"

#include "app/session/editor.h"
#include "model/painting/editable.h"
#include "undo/colour_edits.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>
#include <tuple>

namespace suffuse {

namespace {

struct ByPaint {
    bool operator()(const Colour &a, const Colour &b) const
    {
        return std::tie(a.red, a.yellow, a.blue) < std::tie(b.red, b.yellow, b.blue);
    }
};

ColourPalette paletteOf(const Painting &painting)
{
    std::vector<Colour> colours;
    for (const Swatch &swatch : painting.swatches)
        colours.push_back(swatch.colour);
    return ColourPalette(std::move(colours));
}

/// By how much a shift goes beyond an earlier one.
ColourShift beyond(const ColourShift &earlier, const ColourShift &now)
{
    return {now.hue - earlier.hue,
            earlier.saturation > 0 ? now.saturation / earlier.saturation : now.saturation - earlier.saturation + 1,
            std::clamp(now.lightness - earlier.lightness, -1.0, 1.0)};
}

} // namespace

Recolouring::Recolouring(Editor &editor)
    : m_editor(editor), m_ofSelection(!editor.document().selection().isEmpty()),
      m_parts(partsToColour(*editor.document().painting(), editor.selection())), m_uses(coloursOf(m_parts, mostUses)),
      m_swatches(paletteOf(*editor.document().painting()))
{
    m_wanted.set.resize(m_uses.size());
    m_changes.push_back(m_wanted);
}

Recolouring::~Recolouring()
{
    m_gesture.giveUp();
}

Colour Recolouring::mapped(const Colour &member, std::size_t use) const
{
    const Colour &from = m_uses[use].colour;
    Colour colour = member;
    if (const std::optional<Wish> &wish = m_wanted.set[use]) {
        const bool becomesIt = !m_wanted.keeps || samePaint(member, from);
        colour = becomesIt ? wish->colour : shifted(member, shiftBetween(from, wish->colour));
        colour = shifted(colour, beyond(wish->shift, m_wanted.shift));
    } else {
        colour = shifted(colour, m_wanted.shift);
    }
    return withOpacity(m_wanted.maps && hasSwatches() ? m_swatches.nearest(colour) : colour, 1);
}

void Recolouring::set(const std::vector<std::size_t> &uses, std::optional<Colour> colour)
{
    for (const std::size_t use : uses)
        m_wanted.set[use] = colour ? std::optional<Wish>({*colour, m_wanted.shift}) : std::nullopt;
    show();
}

void Recolouring::setKeepsDifferences(bool keeps)
{
    m_wanted.keeps = keeps;
    show();
}

void Recolouring::setShift(const ColourShift &shift)
{
    m_wanted.shift = shift;
    show();
}

void Recolouring::setMapped(bool mapped)
{
    m_wanted.maps = mapped;
    show();
}

void Recolouring::show()
{
    std::map<Colour, Colour, ByPaint> becomes;
    for (std::size_t use = 0; use < m_uses.size(); ++use)
        for (const Colour &member : m_uses[use].members)
            becomes.emplace(member, mapped(member, use));
    if (!m_gesture.isOpen())
        m_gesture = m_editor.begin(QCoreApplication::translate("Commands", "Recolour artwork"));
    m_gesture.show(recolour(m_editor.document(), m_parts, [&](const Colour &each) {
        const auto at = becomes.find(each);
        return at == becomes.end() ? each : withOpacity(at->second, each.opacity);
    }));
}

void Recolouring::rest()
{
    m_gesture.rest();
    if (m_wanted == m_changes[m_at])
        return;
    m_changes.resize(++m_at);
    m_changes.push_back(m_wanted);
}

bool Recolouring::canStep(bool back) const
{
    return back ? m_at > 0 || m_wanted != m_changes[m_at] : m_at + 1 < m_changes.size();
}

void Recolouring::step(bool back)
{
    rest(); // What goes on ends, and is the first to be taken back.
    if (!canStep(back))
        return;
    m_wanted = m_changes[back ? --m_at : ++m_at];
    show();
    m_gesture.rest();
}

void Recolouring::accept()
{
    m_gesture.commit();
}

void Recolouring::giveUp()
{
    if (!m_gesture.isOpen())
        return;
    // A part of it may be a step already, where the painting was saved meanwhile.
    m_gesture.show(recolour(m_editor.document(), m_parts, [](const Colour &each) { return each; }));
    m_gesture.commit();
}

QString mapToSwatches(Editor &editor)
{
    const Document &document = editor.document();
    const Painting &painting = *document.painting();
    if (painting.swatches.empty())
        return QCoreApplication::translate("Commands", "The painting has no swatches yet.");
    const ColourParts parts = partsToColour(painting, document.selection());
    if (parts.empty())
        return QCoreApplication::translate("Commands", "What is selected is locked or hidden.");
    const ColourPalette swatches = paletteOf(painting);
    Edit edit = recolour(document, parts,
                         [&](const Colour &each) { return withOpacity(swatches.nearest(each), each.opacity); });
    if (edit.isEmpty())
        return QCoreApplication::translate("Commands", "Nothing changes.");
    editor.push(std::move(edit), QCoreApplication::translate("Commands", "Map colours to swatches"));
    return {};
}

void selectColour(Editor &editor, const Colour &colour)
{
    const Painting &painting = *editor.document().painting();
    Selection selection;
    const Editable isEditable(painting.groups);
    for (const ColourPart &part : partsOfColour(painting, colour)) {
        const Stroke &stroke = *part.stroke;
        if (!isEditable(stroke))
            continue;
        selection.strokes.insert(stroke.id);
        if (part.fill || part.gradient || part.count() == stroke.segments.size())
            continue;
        for (std::size_t k = 0; k < stroke.segments.size(); ++k)
            if (part.has(k))
                selection.segments.insert({stroke.id, int(k)});
    }
    editor.document().setSelection(std::move(selection));
}

} // namespace suffuse

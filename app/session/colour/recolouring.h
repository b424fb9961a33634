// Gives the colours of a painting, or of what is selected in it, others.
#pragma once

#include "app/session/gesture.h"
#include "model/colour/colour_shift.h"
#include "model/colour/colour_uses.h"
#include "model/colour/perceived.h"

#include <optional>

namespace suffuse {

class Editor;

/// What the dialog Recolour Artwork does: the colours as they were when it began, and what is to become of them. What
/// is wanted shows at once; `accept` makes it one step, and `giveUp`, or destroying this, takes it back.
class Recolouring {
public:
    /// At most so many colours are told apart; beyond it, those that look alike are one.
    static constexpr std::size_t mostUses = 24;

    /// Of what is selected and can be changed; of all that can be changed where nothing is selected.
    explicit Recolouring(Editor &editor);
    ~Recolouring();
    Recolouring(const Recolouring &) = delete;
    Recolouring &operator=(const Recolouring &) = delete;

    bool isOfSelection() const { return m_ofSelection; }
    /// The colours as they were, those with the most paint first.
    const std::vector<ColourUse> &uses() const { return m_uses; }
    /// What becomes of each, after all that is wanted; opaque.
    Colour result(std::size_t use) const { return mapped(m_uses[use].colour, use); }

    /// Gives some of the colours another one, which the shift of all leaves alone until it changes; nothing: each has
    /// its own again.
    void set(const std::vector<std::size_t> &uses, std::optional<Colour> colour);
    /// Whether the colours that are one in the list keep their differences when it is changed. They do at first.
    void setKeepsDifferences(bool keeps);
    bool keepsDifferences() const { return m_wanted.keeps; }
    /// Shifts all of them, after each was set.
    void setShift(const ColourShift &shift);
    const ColourShift &shift() const { return m_wanted.shift; }
    /// Each becomes the swatch of the painting that looks nearest, after everything else.
    void setMapped(bool mapped);
    bool isMapped() const { return m_wanted.maps; }
    bool hasSwatches() const { return !m_swatches.isEmpty(); }

    /// The hand is off it for now: frames are exact, the journal has what is shown, and a change has ended.
    void rest();
    /// Goes back to what was wanted one change before, or on again.
    bool canStep(bool back) const;
    void step(bool back);
    void accept();
    void giveUp();

private:
    /// A colour that was set, and the shift of all at that time.
    struct Wish {
        Colour colour;
        ColourShift shift;
        friend bool operator==(const Wish &, const Wish &) = default;
    };
    /// All that is to become of the colours.
    struct Wanted {
        std::vector<std::optional<Wish>> set; ///< for each use
        bool keeps = true;
        bool maps = false;
        ColourShift shift;
        friend bool operator==(const Wanted &, const Wanted &) = default;
    };

    Colour mapped(const Colour &member, std::size_t use) const;
    void show();

    Editor &m_editor;
    bool m_ofSelection;
    ColourParts m_parts;
    std::vector<ColourUse> m_uses;
    ColourPalette m_swatches;
    Wanted m_wanted;
    std::vector<Wanted> m_changes; ///< what was wanted at first, and after each change
    std::size_t m_at = 0;          ///< the one of them that is shown, but for a change that has not ended
    Gesture m_gesture;
};

/// Gives each colour of what is selected, or else of all of the painting, the red, yellow and blue of the swatch that
/// looks nearest, as a step. Returns what there is to say: why nothing was done, or nothing.
QString mapToSwatches(Editor &editor);

/// Selects what has exactly this red, yellow and blue, and can be selected.
void selectColour(Editor &editor, const Colour &colour);

} // namespace suffuse

// Whose colour it is that the colour dock shows and changes.
#pragma once

#include "model/colour/colour_uses.h"

#include <QObject>

#include <functional>
#include <optional>

namespace suffuse {

struct Change;
class Editor;
class ValueEntry;

/// An end of the gradient of a stroke's fill.
struct GradientEnd {
    StrokeId stroke = 0;
    bool isSecond = false;
    friend bool operator==(const GradientEnd &, const GradientEnd &) = default;
};

/// The colour dock, its swatches and the eyedropper ask here which colour they show, and hand over here what is picked:
/// it becomes the colour of the brush, of what is selected, or of a swatch. What is selected comes before the brush
/// while a tool is in use that does not paint, unless the user chooses otherwise.
class ColourTarget : public QObject {
    Q_OBJECT

public:
    enum class Kind { Brush, Selection, Swatch };
    /// What happens to a selection of several colours: all become the one that is picked, or all shift as the shown one
    /// does.
    enum class Mode { Set, Shift };
    /// What a tool is about, as far as colours go. `PaintsOver`: it paints with the brush's colour, and with nothing
    /// else of the brush. `Either`: it goes on with what the tool before it was about.
    enum class ToolUse { Paints, PaintsOver, Refines, Either };

    explicit ColourTarget(Editor &editor);

    Kind kind() const;
    /// Something that can be changed is selected.
    bool canBeSelection() const { return m_selected.has_value(); }
    /// Brush or Selection, as the user chooses; holds until a tool of another use is taken.
    void choose(Kind kind);
    void useTool(ToolUse use);
    /// The tool in use paints by itself, with the brush. What was in use before `Either` does not count.
    bool isToolPainting() const { return m_isToolPainting; }
    /// From now on this swatch is meant, until something else is chosen or selected, or it is gone.
    void editSwatch(std::size_t index);
    void endSwatch();
    /// From now on this end of a selected stroke's gradient is meant, and nothing else of what is selected, as long as
    /// it is there; without a value all of it again.
    void chooseEnd(std::optional<GradientEnd> end);
    /// Only while the kind is Swatch.
    std::size_t swatch() const { return m_swatch->index; }

    /// The settings remember it.
    Mode mode() const { return m_mode; }
    void setMode(Mode mode);

    /// The colour that is shown: of a selection, the usual one.
    Colour colour() const;
    /// Only while the kind is Selection.
    const ColourSummary &selected() const { return *m_selected; }
    /// The shown colour is one of several that are selected.
    bool isOneOfSeveral() const { return kind() == Kind::Selection && m_selected->several; }

    /// Whose colour it is, for people: "Colour of the brush", "Colours of 3 strokes".
    QString title() const;

    /// Gives red, yellow and blue; opacity stays, but for a chosen end of a gradient that nobody would see: it becomes
    /// as opaque as the other end. A drag with one entry is one step, and begins with the colours that were there then.
    void setPaint(const Colour &colour, ValueEntry *entry = nullptr);
    /// Gives red, yellow or blue alone; the other two of each colour stay. What a brush has strayed by stays, too; of
    /// several colours all get the value, or shift as the shown one does.
    void setChannel(float Colour::*channel, float value, ValueEntry *entry = nullptr);
    void setOpacity(float opacity, ValueEntry *entry = nullptr);
    /// Of what is selected, each colour becomes what the map makes of it. A drag with one entry is one step.
    void changeEach(const std::function<Colour(const Colour &)> &map, ValueEntry *entry = nullptr);
    /// As if the colour was taken out of a palette: an opaque one says nothing of how thin the brush paints, and of a
    /// selection the opacity stays in any case.
    void take(const Colour &colour);

signals:
    /// Another colour is shown, or it is another one's.
    void changed();

private:
    /// What a drag began with.
    struct Start {
        ColourParts parts;
        Colour colour;
        const ValueEntry *entry = nullptr;
    };
    /// The swatch that is meant, and the list as it was when it was chosen.
    struct EditedSwatch {
        std::size_t index;
        std::vector<Swatch> list;
    };
    ColourParts partsMeant(const Painting &painting) const;
    const Start &startOf(ValueEntry *entry);
    void colourSelection(const std::function<Colour(const Colour &)> &map, const QString &name, ValueEntry *entry);
    void colourSwatch(const Colour &colour, ValueEntry *entry);
    void follow(const Change &change);
    void summarise();
    bool isSwatchThere() const;

    Editor &m_editor;
    ToolUse m_use = ToolUse::Paints;
    bool m_isToolPainting = true;
    std::optional<Kind> m_chosen; ///< by the user, for this use
    std::optional<EditedSwatch> m_swatch;
    std::optional<GradientEnd> m_end;
    std::optional<Kind> m_chosenForEnd; ///< by the user, while an end is meant
    Mode m_mode;
    std::optional<ColourSummary> m_selected; ///< nothing: no selection that could be changed
    std::optional<Start> m_start;
};

} // namespace suffuse

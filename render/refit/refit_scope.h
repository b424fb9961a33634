// Strokes of a painting that others are to take the place of.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <unordered_set>

namespace suffuse::refit {

/// The part of a painting in which the chosen strokes mix, and where the new ones go. That part is what the innermost
/// isolated group around all of them holds, since its picture is put on the rest as one; without such a group it is the
/// whole painting.
class RefitScope {
public:
    /// Takes the strokes of these ids that are visible and not locked. It fails, and says what to choose instead, where
    /// there are none, and where they are a part of a group that mixes in its own way (a wash, or an isolated group
    /// within the scope): such a group must be chosen as a whole.
    static Result<RefitScope> of(PaintingPtr painting, const std::unordered_set<StrokeId> &ids);

    const Painting &painting() const { return *m_painting; }
    std::size_t count() const { return m_count; } ///< how many strokes were taken
    /// How many other strokes lie between the lowest and the highest of them, and will lie below the new ones.
    std::size_t between() const { return m_between; }
    bool isWholePainting() const { return m_group == 0; }
    /// Whether it counts how far strokes cover what is below: where the sheet is not opaque, or the scope is a group.
    bool showsCoverage() const;

    enum Part {
        Ground, ///< what is not chosen and lies below the highest chosen stroke
        Chosen, ///< that, and the chosen ones, in their order
        Above   ///< what lies above
    };
    /// A part of the scope by itself, on an opaque sheet of that colour.
    Painting part(Part part, const Colour &sheet) const;
    /// The colour of the sheet for parts of the scope, over white (`onBlack` false) or over black.
    Colour sheet(bool onBlack) const;
    bool hasAbove() const { return m_highest + 1 < m_strokes.size(); }

    /// The box of what is seen of the chosen strokes, with room around it, as far as the sheet goes; units.
    const Rect &area() const { return m_area; }
    double finestSpread() const { return m_finest; } ///< the least s of chosen strokes, units; 0 if they have none

    /// The painting with other strokes in place of the chosen ones: above the highest of them, in its group, born in
    /// their order from the first to the last moment in which the chosen ones were. A group within the scope that mixed
    /// in its own way is one like others then, since its strokes look as its picture did. Groups in which nothing is
    /// left go.
    Painting with(const StrokeList &strokes) const;

private:
    QString findHome();
    void measure();
    bool isTaken(StrokeId id) const { return m_taken.contains(id); }

    PaintingPtr m_painting;
    std::unordered_set<StrokeId> m_taken;
    std::size_t m_count = 0, m_between = 0;
    GroupId m_group = 0;              ///< of the scope; 0: the whole painting
    GroupId m_home = 0;               ///< the group that new strokes come into
    GroupId m_plain = 0;              ///< the group that is one like others then, since what is in it is new; 0: none
    StrokeId m_top = 0;               ///< the highest chosen stroke
    std::vector<StrokePtr> m_strokes; ///< visible ones of the scope; those right in its group are in none
    std::vector<Group> m_groups;      ///< within the scope
    std::size_t m_highest = 0;        ///< place of the highest chosen stroke in m_strokes
    Rect m_area;
    double m_finest = 0;
    Microseconds m_firstBirth = 0, m_lastBirth = 0;
};

} // namespace suffuse::refit

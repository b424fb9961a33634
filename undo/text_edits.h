// Edits of texts: groups whose strokes are the letters of a text that can be typed in again.
#pragma once

#include "model/brush/brush.h"
#include "undo/edits.h"
#include "undo/lettering/laid_text.h"

namespace suffuse {

/// A letter with the values of a brush at full pressure, whose outline bounds a fill and lays no paint itself. A fill
/// spreads by at most a thirtieth of the letter's size: the stems of letters are about a tenth of it, and would run
/// together. It has one segment, which stands for all.
Stroke letterWith(const Brush &brush, double size, Microseconds born);

/// How letters are added.
struct TextChange {
    /// Where it was typed: of several ways in which one string can have become the other, the one that changes nothing
    /// before this place is meant. No value: anywhere.
    std::optional<qsizetype> at;
    /// New letters look like this one, but for `likeNeighbours`.
    Stroke letter;
    /// New letters look like the first of those that they replace, or like the one before them, or the one behind them
    /// where there is none. They are born with
    /// `letter`.
    bool likeNeighbours = true;
};

/// Makes a group what a text is when it is set. A letter that stays keeps its stroke, with all its values; where its
/// outline and its size are those of `before`, it is moved alone, by as much as its place has changed. Otherwise it
/// gets the outline that `after` has for it. Letters that are new are strokes of their own. What else stands in the
/// group stays above the letter that it lies above, or above all of them.
///
/// `before` is how the text of the group is set now, or null for a group that there is not yet: it is put on top.
/// A text of which no letter has ink is no group. Locked texts, and those in which a stroke is locked, stay as they
/// are.
Edit setText(Document &document, GroupId group, const Text &text, const LaidText *before, const LaidText &after,
             const TextChange &change);

/// The strokes of a group that are letters of its text as it is set: one for each cluster with ink in `laid`, 0 where
/// it was deleted.
std::vector<StrokeId> lettersOf(const Painting &painting, GroupId group, const LaidText &laid);

/// The letters of a group that are others where its text becomes `text`, which differs from it in place and curve
/// alone; `before` and `after` are both as they are set. Letters that were drawn otherwise stay so. No value where one
/// of them would be no stroke.
std::optional<std::vector<StrokePtr>> relaidLetters(const Painting &painting, GroupId group, const LaidText &before,
                                                    const Text &text, const LaidText &after);

/// The text of a group, or none.
SharedText textOf(const Painting &painting, GroupId group);
/// Whether a text cannot be typed in: it is locked, or a stroke of it is.
bool isTextLocked(const Painting &painting, GroupId group);
/// The innermost group around a stroke that is a text, or 0.
GroupId textAround(const Painting &painting, const Stroke &stroke);
/// The text whose letters are all that is selected, or some of it; 0 if none is, or other strokes are.
GroupId selectedText(const Document &document);
/// The strokes of a group, and of those within it.
std::set<StrokeId> strokesWithin(const Painting &painting, GroupId group);

/// The texts of which all strokes are among some.
std::map<GroupId, Text> wholeTexts(const Painting &painting, const std::function<bool(StrokeId)> &isAmong);
/// The groups of a painting, where these texts are as a map makes them of what they were; no value where they are so.
std::optional<std::vector<Group>> withTextsMapped(const Painting &painting, const std::map<GroupId, Text> &before,
                                                  const Affine &map);

/// Completes an edit that maps all strokes of a text in one way, so that the text knows where it is. `before` is the
/// painting that the edit is meant for.
void followTexts(const Painting &before, Edit &edit);

} // namespace suffuse

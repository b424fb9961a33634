// Strokes and groups as a screen reader says them.
#pragma once

#include "model/painting/painting.h"

#include <QString>

#include <set>

namespace suffuse {

/// A stroke in a few words, "stroke 12, dark edge, blue, 34 segments" for example, translated. The number is the one that
/// the list of strokes shows; a name stands in place of it. Of several colours the one in the middle is named.
QString wordsOf(const Stroke &stroke);
/// What else is to be said of it: that it is hidden or locked, itself or by a group; empty where it is neither.
QString stateWordsOf(const Painting &painting, const Stroke &stroke);
/// What a command or a key has to say of selected strokes: the stroke in words or, of several, how many they are.
QString wordsOfSelected(const Painting &painting, const std::set<StrokeId> &strokes);

} // namespace suffuse

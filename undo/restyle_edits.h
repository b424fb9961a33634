// Edits that give the selected strokes, or the selected parts of them, another look. As in edits.h: an empty Edit where
// there is nothing to do. Locked and hidden strokes are left alone.
#pragma once

#include "model/document/document.h"
#include "model/restyling/appearance.h"
#include "model/restyling/restyle.h"
#include "model/restyling/vary.h"

#include <functional>

namespace suffuse {

/// The brush of that name as it is in the library, or null.
using BrushNamed = std::function<const Brush *(const QString &name)>;

/// Puts a brush, or a part of it, on the selection.
Edit applyBrush(const Document &document, const Brush &brush, BrushPart part, const BrushNamed &brushNamed);

/// Gives what was selected in `before` an appearance, whatever stands in the document now.
Edit applyAppearance(const Document &document, const Painting &before, const Selection &selection,
                     const Appearance &appearance, Variation variation);

/// Varies what was selected in `before`, as it was there, whatever stands in the document now.
Edit varySelection(const Document &document, const Painting &before, const Selection &selection,
                   const VaryAmounts &amounts);

} // namespace suffuse

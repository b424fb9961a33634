// How rows of the Strokes dock look: the layer that is painted on stands out from what is selected.
#pragma once

#include "model/painting/painting.h"

#include <QPalette>
#include <QStyleOptionViewItem>

namespace suffuse {

/// The palette of selected rows other than the layer's. It is kept, since pictures in rows are remembered by it.
class WeakPalette {
public:
    const QPalette &of(const QPalette &palette) const;

private:
    mutable QPalette m_weak;
    mutable qint64 m_madeOf = 0; ///< the key of the palette that it was made of
};

/// Whether a row is selected, and not in a weak palette.
bool isStronglySelected(const QStyleOptionViewItem &option);
/// Whether a stroke, or else a group and all in it, is not seen since others are shown alone.
bool isHiddenByOthers(const Painting &painting, const Stroke *stroke, const Group *group);

} // namespace suffuse

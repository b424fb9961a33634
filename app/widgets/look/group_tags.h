// The colours that groups are marked with, for people.
#pragma once

#include "model/painting/painting.h"

#include <QColor>
#include <QIcon>
#include <QString>

namespace suffuse {

/// The translated name of a mark.
QString nameOf(GroupTag tag);
/// The colour of a mark, which is told from others on light and dark grounds; not valid for none.
QColor colourOf(GroupTag tag);
/// A square in the colour of a mark; an empty one for none.
QIcon iconOf(GroupTag tag);

} // namespace suffuse

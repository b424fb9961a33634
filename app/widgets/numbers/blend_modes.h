// The blend modes of groups, in words for people.
#pragma once

#include "model/painting/blend.h"

#include <QString>

#include <vector>

class QComboBox;

namespace suffuse {

/// The translated name of a mode, as painters know it: "Colour Dodge".
QString nameOf(BlendMode mode);
/// What a mode does, in a translated sentence.
QString tipOf(BlendMode mode);

/// Fills a box with all modes, in families with a line between them: those that darken, that lighten, that do both,
/// that compare, that take a part of the colour, and that ask where there is paint. What an item stands for is its
/// data.
void addBlendModes(QComboBox &box);
/// The mode that is chosen in such a box.
BlendMode modeAt(const QComboBox &box, int index);
/// Chooses a mode in such a box.
void chooseMode(QComboBox &box, BlendMode mode);

} // namespace suffuse

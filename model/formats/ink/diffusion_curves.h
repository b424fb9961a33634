// Pictures of diffusion curves (Orzan et al. 2008), in the XML of their authors' program.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <QByteArray>

namespace suffuse {

/// A diffusion curve is a boundary whose colours spread from both sides, while strokes are paint. So each curve becomes
/// two uniform strokes, one along each side, whose edges meet on the curve. They have the left and the right colours,
/// and their edges are as soft as the curve's blur says. What lies farther from a curve than a stroke is wide stays
/// bare. 1 pixel is 1 canvas unit. Errors name the line.
Result<Painting> readDiffusionCurves(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse

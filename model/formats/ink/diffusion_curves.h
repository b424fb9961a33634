// Diffusion-curve pictures (Orzan et al. 2008) as the XML of their authors' program.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <QByteArray>

namespace suffuse {

/// A diffusion curve is a boundary with a colour on either side that spreads from it; strokes are paint. So each curve
/// comes in as two uniform strokes, one along each side, whose edges meet on the curve: the left colours on one, the
/// right ones on the other, as soft at the edge as the curve's blur says. What lies further from a curve than a stroke
/// is wide stays bare. 1 pixel is 1 canvas unit. Errors name the line.
Result<Painting> readDiffusionCurves(const QByteArray &bytes, const QString &fileName);

} // namespace suffuse

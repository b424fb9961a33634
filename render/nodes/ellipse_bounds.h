// Level 0 bounds the error of a Gauss rule by maxima on Bernstein ellipses of [0, 1], which have their foci at 0 and 1
// (docs/solver.md, "Nodes"). The functions here find these maxima with SIMD, to the bits that render/math/panels.h
// gives.
#pragma once

#include "render/math/panels.h"

namespace suffuse {

/// Returns the tables that all curves share.
const panels::Tables &panelTables();

/// Returns the least of panels::evenNodesOn over all ellipses.
float nodesOfEvenCurve(const panels::EvenCurve &curve, float logAllowed);

/// Finds the maxima of panels::sampleAt over the points of an ellipse.
void sampleEllipse(const panels::EllipseBasis &basis, const panels::Differences &curve, float &lift, float &speed);

} // namespace suffuse

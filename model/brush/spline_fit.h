#pragma once

#include <Eigen/Core>

namespace suffuse {

/// Fits the C² cubic spline through `values` (n rows, one column for each quantity) at increasing `times` (n), n ≥ 2,
/// with natural ends. Returns the derivative with respect to time at each knot (n rows). The Bézier handles of interval
/// i then are v_i + d_i·h/3 and v_{i+1} − d_{i+1}·h/3, where h is its duration.
Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values);

/// The same with a given derivative at the first knot (one row). The other end is natural.
Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values,
                                  const Eigen::RowVectorXd &startDerivative);

} // namespace suffuse

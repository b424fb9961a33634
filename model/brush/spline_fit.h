#pragma once

#include <Eigen/Core>

namespace suffuse {

/// C² cubic spline through `values` (n rows, one column per quantity) at increasing `times` (n), n ≥ 2.
/// Returns the derivative with respect to time at each knot (n rows); natural ends. With them, the Bézier handles of
/// interval i are v_i + d_i·h/3 and v_{i+1} − d_{i+1}·h/3, h its duration.
Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values);

/// The same with the derivative at the first knot given (one row); the other end is natural.
Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values,
                                  const Eigen::RowVectorXd &startDerivative);

} // namespace suffuse

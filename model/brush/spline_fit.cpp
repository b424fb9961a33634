#include "model/brush/spline_fit.h"

namespace suffuse {

namespace {

/// Rows below·d_{i−1} + diagonal·d_i + above·d_{i+1} = right. They are solved in place by elimination without pivoting,
/// since the matrix is diagonally dominant.
struct Tridiagonal {
    Eigen::VectorXd below, diagonal, above;
    Eigen::MatrixXd right;

    Eigen::MatrixXd solved()
    {
        const Eigen::Index n = diagonal.size();
        for (Eigen::Index i = 1; i < n; ++i) {
            const double k = below[i] / diagonal[i - 1];
            diagonal[i] -= k * above[i - 1];
            right.row(i) -= k * right.row(i - 1);
        }
        right.row(n - 1) /= diagonal[n - 1];
        for (Eigen::Index i = n - 2; i >= 0; --i)
            right.row(i) = (right.row(i) - above[i] * right.row(i + 1)) / diagonal[i];
        return right;
    }
};

Tridiagonal naturalSystem(const Eigen::VectorXd &times, const Eigen::MatrixXd &values)
{
    const Eigen::Index n = times.size();
    Tridiagonal t{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                  Eigen::MatrixXd(n, values.cols())};
    const Eigen::VectorXd rate = (times.tail(n - 1) - times.head(n - 1)).cwiseInverse();
    const auto slope = [&](Eigen::Index i) { return ((values.row(i + 1) - values.row(i)) * rate[i]).eval(); };
    t.diagonal[0] = 2, t.above[0] = 1;
    t.right.row(0) = 3 * slope(0);
    for (Eigen::Index i = 1; i < n - 1; ++i) {
        t.below[i] = rate[i - 1];
        t.diagonal[i] = 2 * (rate[i - 1] + rate[i]);
        t.above[i] = rate[i];
        t.right.row(i) = 3 * (rate[i - 1] * slope(i - 1) + rate[i] * slope(i));
    }
    t.below[n - 1] = 1, t.diagonal[n - 1] = 2;
    t.right.row(n - 1) = 3 * slope(n - 2);
    return t;
}

} // namespace

Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values)
{
    return naturalSystem(times, values).solved();
}

Eigen::MatrixXd splineDerivatives(const Eigen::VectorXd &times, const Eigen::MatrixXd &values,
                                  const Eigen::RowVectorXd &startDerivative)
{
    Tridiagonal t = naturalSystem(times, values);
    t.diagonal[0] = 1, t.above[0] = 0;
    t.right.row(0) = startDerivative;
    return t.solved();
}

} // namespace suffuse

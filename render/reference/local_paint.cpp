#include "render/reference/local_paint.h"

#include <cmath>

namespace suffuse::reference {

double modulation(double granulation, double eta)
{
    return (1 - granulation) * eta + granulation;
}

double localDensityFunction(const LocalDensity &local, double eta, double px)
{
    const double gamma = modulation(local.granulation, eta);
    const double h = 0.5 * gamma * local.slope * px;
    double sum = 0;
    for (int i = 0; i < local.styleCount; ++i) {
        const StyleShare &style = local.styles[std::size_t(i)];
        if (style.share > 0)
            sum += style.share * densityFunctionMean(style.kind, style.xi, gamma * local.density, h, local.lifted);
    }
    return sum;
}

Paint paintOf(const LocalDensity &local, double eta, double px)
{
    return {localDensityFunction(local, eta, px) * local.colour[3] * std::exp(-local.faded),
            {local.colour[0], local.colour[1], local.colour[2]}};
}

} // namespace suffuse::reference

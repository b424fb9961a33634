#include "render/reference/quadrature.h"

#include <cmath>
#include <numbers>

namespace suffuse::reference {

namespace {

struct Legendre {
    double value;
    double derivative;
};

/// P_n(x) and P_n'(x) by the three-term recurrence.
Legendre legendre(int n, double x)
{
    double previous = 1;
    double current = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
        previous = current;
        current = next;
    }
    return {current, n * (x * current - previous) / (x * x - 1)};
}

} // namespace

GaussRule gaussLegendre(int n)
{
    GaussRule rule;
    if (n == 1)
        return {{0.5}, {1.0}};
    for (int i = n; i >= 1; --i) {
        double x = std::cos(std::numbers::pi * (i - 0.25) / (n + 0.5));
        for (int step = 0; step < 20; ++step) {
            const Legendre p = legendre(n, x);
            x -= p.value / p.derivative;
        }
        const double slope = legendre(n, x).derivative;
        rule.nodes.push_back(0.5 * (1 + x));
        rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

const GaussRule &gauss10()
{
    static const GaussRule rule = gaussLegendre(10);
    return rule;
}

const GaussRule &gauss20()
{
    static const GaussRule rule = gaussLegendre(20);
    return rule;
}

const KronrodRule &kronrod15()
{
    static const KronrodRule rule = {
        {0.0, 0.207784955007898467600689403773245, 0.405845151377397166906606412076961,
         0.586087235467691130294144691693013, 0.741531185599394439863864773280788, 0.864864423359769072789712788640926,
         0.949107912342758524526189684047851, 0.991455371120812639206854697526329},
        {0.209482141084727828012999174891714, 0.204432940075298892414161999234649, 0.190350578064785409913256402421014,
         0.169004726639267902826583426598550, 0.140653259715525918745189590510238, 0.104790010322250183839876322541518,
         0.063092092629978553290700663189204, 0.022935322010529224963732008058970},
        {0.417959183673469387755102040816327, 0.0, 0.381830050505118944950369775488975, 0.0,
         0.279705391489276667901467771423780, 0.0, 0.129484966168869693270611432679082, 0.0}};
    return rule;
}

} // namespace suffuse::reference

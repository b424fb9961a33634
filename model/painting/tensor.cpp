#include "model/painting/tensor.h"

namespace suffuse {

Tensor tensorOf(const Segment &segment)
{
    const double across = segment.diffusion;
    if (segment.isIsotropic())
        return {across, 0, across};
    const double along = across * segment.anisotropyRatio;
    const double c = std::cos(double(segment.anisotropyAngle)), s = std::sin(double(segment.anisotropyAngle));
    return {along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c};
}

void setTensor(Segment &segment, const Tensor &t)
{
    const double difference = 0.5 * (t.xx - t.yy);
    const double radius = std::hypot(difference, t.xy);
    const double larger = 0.5 * (t.xx + t.yy) + radius;
    const double smaller = (t.xx * t.yy - t.xy * t.xy) / larger; // The product of both is the determinant.
    segment.diffusion = float(smaller);
    segment.anisotropyRatio = float(larger / smaller);
    segment.anisotropyAngle = segment.isIsotropic() ? 0 : float(0.5 * std::atan2(t.xy, difference));
}

Tensor mapped(const Tensor &t, const Affine &m)
{
    const Point x = m.turned({t.xx, t.xy}), y = m.turned({t.xy, t.yy}); // the columns of M·T
    return {m.a * x.x + m.b * y.x, m.c * x.x + m.d * y.x, m.c * x.y + m.d * y.y};
}

} // namespace suffuse

#include "model/painting/tensor.h"

namespace suffuse {

namespace {

template <class Source>
Tensor tensorOfSource(const Source &source)
{
    const double across = source.diffusion;
    if (source.isIsotropic())
        return {across, 0, across};
    const double along = across * source.anisotropyRatio;
    const double c = std::cos(double(source.anisotropyAngle)), s = std::sin(double(source.anisotropyAngle));
    return {along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c};
}

template <class Source>
void setTensorOfSource(Source &source, const Tensor &t)
{
    const double difference = 0.5 * (t.xx - t.yy);
    const double radius = std::hypot(difference, t.xy);
    const double larger = 0.5 * (t.xx + t.yy) + radius;
    if (!(larger > 0)) { // What does not spread has no direction in which it does.
        source.diffusion = 0;
        return;
    }
    const double smaller = (t.xx * t.yy - t.xy * t.xy) / larger; // The product of both is the determinant.
    source.diffusion = float(smaller);
    source.anisotropyRatio = float(larger / smaller);
    source.anisotropyAngle = source.isIsotropic() ? 0 : float(0.5 * std::atan2(t.xy, difference));
}

} // namespace

Tensor tensorOf(const Segment &segment)
{
    return tensorOfSource(segment);
}

Tensor tensorOf(const Fill &fill)
{
    return tensorOfSource(fill);
}

void setTensor(Segment &segment, const Tensor &tensor)
{
    setTensorOfSource(segment, tensor);
}

void setTensor(Fill &fill, const Tensor &tensor)
{
    setTensorOfSource(fill, tensor);
}

Tensor mapped(const Tensor &t, const Affine &m)
{
    const Point x = m.turned({t.xx, t.xy}), y = m.turned({t.xy, t.yy}); // the columns of M·T
    return {m.a * x.x + m.b * y.x, m.c * x.x + m.d * y.x, m.c * x.y + m.d * y.y};
}

} // namespace suffuse

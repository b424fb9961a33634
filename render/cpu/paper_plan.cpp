#include "render/cpu/paper_plan.h"

#include "render/math/paper.h"

namespace suffuse::cpu {

namespace {

/// How canvas points become coordinates of cells that are turned and enlarged again and again.
class Turned {
public:
    Turned(const Paper &paper, const View &view)
    {
        const double scale = double(paper.scale), px = view.px() / scale;
        const double c = std::cos(view.rotation), s = std::sin(view.rotation), flip = view.mirrored ? -1 : 1;
        m_u = view.centre.x / scale, m_v = view.centre.y / scale;
        m_ux = flip * c * px, m_uy = flip * s * px;
        m_vx = -s * px, m_vy = c * px;
        m_middle = {0.5 * view.width, 0.5 * view.height};
    }
    void turn(double times)
    {
        math::paperTurn(m_u, m_v, times);
        math::paperTurn(m_ux, m_vx, times);
        math::paperTurn(m_uy, m_vy, times);
    }
    /// The layer of these coordinates, multiplied by (a, b) and moved by `shift` along both axes.
    PaperLayer layer(const Paper &paper, std::uint32_t number, double a, double b, double shift, double share) const
    {
        PaperLayer out;
        out.ux = a * m_ux, out.uy = a * m_uy;
        out.vx = b * m_vx, out.vy = b * m_vy;
        out.u0 = a * m_u - out.ux * m_middle.x - out.uy * m_middle.y + shift;
        out.v0 = b * m_v - out.vx * m_middle.x - out.vy * m_middle.y + shift;
        out.base = math::paperBase(number, paper.seed);
        out.share = float(share);
        return out;
    }

private:
    double m_u, m_v;               // at the picture's centre
    double m_ux, m_uy, m_vx, m_vy; // the change from pixel to pixel
    Point m_middle;                // in pixels
};

std::vector<PaperLayer> octavesOf(const Paper &paper, const View &view, double samples)
{
    std::vector<PaperLayer> out;
    Turned turned(paper, view);
    turned.turn(1);
    double amplitude = 1;
    for (std::uint32_t i = 0; i < math::paperMostOctaves; ++i) {
        const double band = math::paperBand(samples);
        if (band <= 0)
            break;
        out.push_back(turned.layer(paper, i, 1, 1, 0.5, band * amplitude));
        turned.turn(2);
        amplitude *= math::paperFalloff;
        samples *= 0.5;
    }
    return out;
}

} // namespace

PaperPlan planPaper(const Paper &paper, const View &view, double step)
{
    PaperPlan plan;
    const double samples = double(paper.scale) / (step * view.px());
    plan.octaves = octavesOf(paper, view, samples);
    plan.strength = float(paper.strength);
    Turned turned(paper, view);
    switch (paper.grain) {
    case PaperGrain::Tooth:
        plan.octavesFactor = 2.5f;
        break;
    case PaperGrain::Fibres:
        for (std::uint32_t j = 0; j < 5 && samples > 5; ++j) {
            turned.turn(1);
            plan.fibres.push_back(turned.layer(paper, 50 + j, 0.125, 1, 0, math::paperBand(0.4 * samples)));
        }
        break;
    case PaperGrain::Weave:
        plan.octavesFactor = 0.75f;
        if (samples <= 2)
            break;
        plan.weaveFactor = float(2.2 * math::paperBand(samples));
        plan.weave = {turned.layer(paper, 48, 0.25, 0.25, 0, 0.35), turned.layer(paper, 49, 0.25, 0.25, 0, 0.35),
                      turned.layer(paper, 0, 1, 1, 0, 1)};
        break;
    }
    return plan;
}

} // namespace suffuse::cpu

#include "render/fitting/birth_order.h"

#include "model/brush/random_values.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::fitting {

namespace {

constexpr std::size_t moments = 100;
constexpr double unborn = 1e-3; ///< The opacity of a stroke that waits: too little to be seen, enough for a derivative.
constexpr int firstSamples = 8, samples = 2; ///< of random signs, at the first moment and at each one after it
constexpr double memory = 0.75;              ///< of the estimate, from one moment to the next

class BirthOrder {
public:
    BirthOrder(gradient::Differentiator &gradient, gradient::FlatScene &scene, const FitPicture &target,
               const FitPicture &weight, std::uint64_t seed)
        : m_gradient(gradient), m_scene(scene), m_target(target), m_weight(weight), m_seed(seed),
          m_waiting(scene.strokes.size()), m_opacities(scene.strokes.size()), m_squares(scene.strokes.size())
    {
        std::iota(m_waiting.begin(), m_waiting.end(), std::size_t(0));
        for (std::size_t i = 0; i < m_opacities.size(); ++i) {
            m_opacities[i] = scene.segments[scene.strokes[i].first].opacity;
            setOpacity(i, std::min(unborn, m_opacities[i]));
        }
        gradient.choose(scene);
    }

    /// Finds what painting each stroke that waits would add to the error. False if it was stopped before.
    bool look(std::size_t moment, const std::atomic<bool> *cancel)
    {
        const std::span<const float> drawn = m_gradient.draw(m_scene);
        m_by.resize(drawn.size());
        for (std::size_t i = 0; i < m_by.size(); ++i)
            m_by[i] = 2 * weightAt(i) * (drawn[i] - m_target.values[i]);
        m_effects = slopes(m_gradient.backward(m_by));
        const int count = moment == 0 ? firstSamples : samples;
        std::vector<double> squares(m_squares.size());
        for (int sample = 0; sample < count; ++sample) {
            if (cancel && *cancel)
                return false;
            for (std::size_t i = 0; i < m_by.size(); ++i)
                m_by[i] = std::copysign(std::sqrt(weightAt(i)),
                                        float(randomAt(m_seed + moment, sample, std::int64_t(i)) - 0.5));
            const std::vector<double> bySigns = slopes(m_gradient.backward(m_by));
            for (std::size_t k = 0; k < squares.size(); ++k)
                squares[k] += bySigns[k] * bySigns[k] / count;
        }
        for (std::size_t k = 0; k < squares.size(); ++k) {
            m_squares[k] = moment == 0 ? squares[k] : memory * m_squares[k] + (1 - memory) * squares[k];
            m_effects[k] = m_opacities[k] * (m_effects[k] + m_opacities[k] * m_squares[k]);
        }
        return true;
    }

    /// Paints so many, and returns them from the back to the front: the first ones that bring the picture nearer and, where
    /// there are too few of these, those that do the least harm. Where these together take it away after all, since they
    /// lie over each other, those that promise most take their place.
    std::vector<std::size_t> paint(std::size_t count)
    {
        const double before = error(m_gradient.draw(m_scene));
        const std::vector<std::size_t> waiting = m_waiting;
        std::vector<std::size_t> order = paint(count, 0);
        if (error(m_gradient.draw(m_scene)) <= before)
            return order;
        for (const std::size_t i : order)
            setOpacity(i, std::min(unborn, m_opacities[i]));
        m_waiting = waiting;
        return paint(count, -1e300);
    }

private:
    /// Paints those that do the least harm; what is better than `good` is as good.
    std::vector<std::size_t> paint(std::size_t count, double good)
    {
        std::vector<std::size_t> order = m_waiting;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return std::max(m_effects[a], good) < std::max(m_effects[b], good);
        });
        order.resize(count);
        std::sort(order.begin(), order.end());
        std::vector<std::size_t> rest;
        std::set_difference(m_waiting.begin(), m_waiting.end(), order.begin(), order.end(), std::back_inserter(rest));
        m_waiting = std::move(rest);
        for (const std::size_t i : order)
            setOpacity(i, m_opacities[i]);
        return order;
    }

    double error(std::span<const float> drawn) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            sum += double(weightAt(i)) * std::pow(double(drawn[i]) - double(m_target.values[i]), 2);
        return sum;
    }

    float weightAt(std::size_t i) const { return m_weight.isEmpty() ? 1.0f : m_weight.values[i / 3]; }

    void setOpacity(std::size_t i, double opacity)
    {
        const gradient::FlatStroke &stroke = m_scene.strokes[i];
        for (std::size_t k = stroke.first; k < stroke.first + stroke.count; ++k)
            m_scene.segments[k].opacity = opacity;
    }

    std::vector<double> slopes(const gradient::FlatGradient &by) const
    {
        std::vector<double> out(m_scene.strokes.size());
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = by.segments[m_scene.strokes[i].first].opacity;
        return out;
    }

    gradient::Differentiator &m_gradient;
    gradient::FlatScene &m_scene;
    const FitPicture &m_target, &m_weight;
    std::uint64_t m_seed;
    std::vector<std::size_t> m_waiting; ///< from the back to the front
    std::vector<double> m_opacities;    ///< that they will have
    std::vector<double> m_squares;      ///< Σ(∂picture/∂o)², estimated
    std::vector<double> m_effects;      ///< what each adds to the error
    std::vector<float> m_by;
};

} // namespace

std::vector<std::size_t> birthOrder(gradient::Differentiator &gradient, gradient::FlatScene scene,
                                    const FitPicture &target, const FitPicture &weight, std::uint64_t seed,
                                    const std::atomic<bool> *cancel)
{
    const std::size_t strokes = scene.strokes.size(), count = std::min(moments, strokes);
    std::vector<std::size_t> births(strokes);
    BirthOrder order(gradient, scene, target, weight, seed);
    std::size_t born = 0;
    for (std::size_t moment = 0; moment < count; ++moment) {
        if (!order.look(moment, cancel))
            return {};
        for (const std::size_t i : order.paint(strokes * (moment + 1) / count - born))
            births[i] = born++;
    }
    return births;
}

} // namespace suffuse::fitting

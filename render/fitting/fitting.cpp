#include "render/fitting/fitting.h"

#include "model/painting/ryb.h"
#include "render/fitting/birth_order.h"
#include "render/fitting/error_strokes.h"
#include "render/fitting/picture_metrics.h"
#include "render/fitting/stroke_removal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::fitting {

namespace {

constexpr int stepsForNodes = 10;           ///< Nodes are chosen anew after so many steps.
constexpr double unseenWhileFitting = 2e-3; ///< Errors of opacity that are too small to lead a fit astray.
constexpr int bandHeight = 96; ///< Whole tiles; a picture is drawn in some tens of milliseconds a band.
constexpr std::size_t leastPixelsForBirths = 20'000; ///< so many show in which order strokes bring a picture nearer
constexpr double leastEffect = 2e-6;        ///< of the whole error: strokes that do less are left out at the end
constexpr double doubtfulEffect = 3e-4;     ///< Strokes that do less by a rough measure are measured exactly.

/// The colour of the canvas: the mean of what counts.
Colour meanColour(const FitTarget &target)
{
    std::array<double, 3> sum{};
    double weights = 0;
    for (std::size_t p = 0; p < target.picture.pixels(); ++p) {
        const double w = target.weight.isEmpty() ? 1 : double(target.weight.values[p]);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += w * double(target.picture.values[3 * p + c]);
        weights += w;
    }
    for (double &v : sum)
        v /= std::max(weights, 1e-9);
    return rybFromSrgb(sum[0], sum[1], sum[2]);
}

/// R, Y, B of a picture of R, G, B; null for an empty one.
std::shared_ptr<const std::vector<float>> pigmentsOf(const FitPicture &picture)
{
    if (picture.isEmpty())
        return {};
    auto out = std::make_shared<std::vector<float>>(picture.values.size());
    for (std::size_t i = 0; i < out->size(); i += 3) {
        const float *const v = picture.values.data() + i;
        const std::array<double, 3> ryb = rybFromSrgb({double(v[0]), double(v[1]), double(v[2])});
        std::copy(ryb.begin(), ryb.end(), out->begin() + std::ptrdiff_t(i));
    }
    return out;
}

/// One picture on the white squares of a chessboard of pixels, and another one on the black ones.
FitPicture chequered(const FitPicture &white, const FitPicture &black)
{
    FitPicture out = white;
    for (int y = 0; y < out.height; ++y)
        for (int x = (y + 1) % 2; x < out.width; x += 2)
            std::copy_n(black.at(x, y), 3, out.at(x, y));
    return out;
}

} // namespace

/// The target at one size.
struct Fitting::Level {
    using Ground = std::shared_ptr<const std::vector<float>>;
    /// The picture on one ground, or on white and on black.
    struct Side {
        FitPicture target;
        Ground ground;
    };

    FitLoss loss;
    Ground ground; ///< R, Y, B of each pixel; null: the colour of the canvas
    std::vector<Side> sides; ///< on white and on black, where both count; `loss` has them as a chessboard
    View view;
    double scale = 1; ///< its pixels for each of the target's
};

Fitting::Fitting(FitTarget target, const FitOptions &options, std::shared_ptr<gradient::Differentiator> differentiator)
    : Fitting(std::move(target), options, {{}, options.limits.style, {}}, std::move(differentiator))
{
    m_fitted.background = meanColour(m_target);
}

Fitting::Fitting(FitTarget target, const FitOptions &options, FittedStrokes start,
                 std::shared_ptr<gradient::Differentiator> differentiator)
    : m_target(std::move(target)), m_options(options), m_fitted(std::move(start)),
      m_plan(planOf(int(m_fitted.strokes.size()), std::max(options.strokes, int(m_fitted.strokes.size())),
                    options.error > 0, options.steps, m_target.picture.width, m_target.picture.height)),
      m_gradient(differentiator ? std::move(differentiator) : gradient::makeCpuDifferentiator(Threads(options.threads)))
{
    m_options.limits.style = m_fitted.style;
    m_options.limits.greatestSpread = std::max(m_target.picture.width, m_target.picture.height);
    m_options.limits.width = m_target.picture.width, m_options.limits.height = m_target.picture.height;
    m_fitted.births.clear(); // They are found at the end.
    m_adam.grow(m_fitted.strokes.size());
}

Fitting::~Fitting() = default;

std::shared_ptr<const Fitting::Level> Fitting::levelAt(int halvings)
{
    m_levels.resize(std::max(m_levels.size(), std::size_t(halvings) + 1));
    std::shared_ptr<Level> &level = m_levels[std::size_t(halvings)];
    if (!level) {
        level = std::make_shared<Level>();
        const FitPicture &full = m_target.picture;
        const Rect area = Rect::of(0, 0, full.width, full.height);
        const int width = std::max(1, full.width >> halvings),
                  height = std::clamp(heightForWidth(area, width), 1, full.height);
        const auto smaller = [&](const FitPicture &p) { return p.isEmpty() ? p : averaged(p, width, height); };
        FitPicture target = smaller(full), ground = smaller(m_target.ground);
        if (const auto &onBlack = m_target.onBlack; !onBlack.picture.isEmpty()) {
            // A stroke is wider than a square, so it cannot look one way on white and another one on black.
            const FitPicture other = smaller(onBlack.picture), otherGround = smaller(onBlack.ground);
            level->sides = {{target, pigmentsOf(ground)}, {other, pigmentsOf(otherGround)}};
            target = chequered(target, other), ground = chequered(ground, otherGround);
        }
        level->ground = pigmentsOf(ground);
        level->loss = FitLoss(std::move(target), smaller(m_target.weight), m_options.perceptual);
        level->view = View::ofArea(area, width, height);
        level->scale = double(width) / full.width;
    }
    return level;
}

/// The strokes as a level shows them.
gradient::FlatScene Fitting::sceneAt(const Level &level) const
{
    gradient::FlatScene scene = sceneOf(m_fitted.strokes, m_fitted.style, m_fitted.background, level.view);
    scene.ground = level.ground;
    return scene;
}

void Fitting::choose()
{
    m_gradient->choose(m_scene, {unseenWhileFitting});
}

void Fitting::keep(const std::vector<std::size_t> &kept)
{
    std::vector<FitStroke> strokes;
    strokes.reserve(kept.size());
    for (const std::size_t i : kept)
        strokes.push_back(m_fitted.strokes[i]);
    m_fitted.strokes = std::move(strokes);
    m_adam.keep(kept);
    m_palette.keep(kept);
}

/// Takes away so many strokes that do the least.
void Fitting::removeLeast(std::size_t count)
{
    const std::vector<double> effects = roughErrorsWithout(
        *m_gradient, m_scene, {m_level->loss.target(), m_level->loss.weight(), m_level->view, nullptr}, m_options.seed, m_cancel);
    std::vector<std::size_t> order(effects.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return effects[a] < effects[b]; });
    order.erase(order.begin(), order.begin() + std::ptrdiff_t(std::min(count, order.size())));
    std::sort(order.begin(), order.end());
    keep(order);
}

/// Takes away the strokes that do nothing, or harm. Returns false if it was stopped before.
bool Fitting::removeIdle()
{
    const RemovalView seen{m_level->loss.target(), m_level->loss.weight(), m_level->view,
                           m_level->ground.get()};
    setNumbers(m_fitted.strokes, m_fitted.style, m_scene);
    choose();
    const std::vector<double> rough = roughErrorsWithout(*m_gradient, m_scene, seen, m_options.seed, m_cancel);
    const double error = meanSquareError() * 3 * double(m_target.picture.pixels());
    if (isCancelled())
        return false;
    std::vector<std::size_t> doubtful, kept;
    for (std::size_t i = 0; i < rough.size(); ++i)
        if (rough[i] < doubtfulEffect * error)
            doubtful.push_back(i);
    const std::vector<double> effects = errorsWithout(m_fitted.strokes, doubtful, m_fitted.style, m_fitted.background,
                                                      seen, Threads(m_options.threads), m_cancel);
    if (isCancelled())
        return false;
    std::vector<char> gone(rough.size());
    for (std::size_t k = 0; k < effects.size(); ++k)
        gone[doubtful[k]] = effects[k] < leastEffect * error ? 1 : 0;
    for (std::size_t i = 0; i < gone.size(); ++i)
        if (!gone[i])
            kept.push_back(i);
    keep(kept);
    return true;
}

/// Finds when each stroke is painted, on a small picture. Returns false if it was stopped before.
bool Fitting::orderBirths()
{
    int halvings = 0;
    while (m_target.picture.pixels() >> (2 * halvings + 2) >= leastPixelsForBirths)
        ++halvings;
    const auto level = levelAt(halvings);
    m_fitted.births = birthOrder(*m_gradient, sceneAt(*level), level->loss.target(), level->loss.weight(),
                                 m_options.seed, m_cancel);
    return m_fitted.births.size() == m_fitted.strokes.size();
}

void Fitting::addStrokes(std::size_t count)
{
    m_scene = sceneAt(*m_level);
    choose();
    const FitPicture *target = &m_level->loss.target();
    FitPicture drawn;
    const auto draw = [&](FitPicture &to) {
        to = FitPicture(target->width, target->height, 3);
        const std::span<const float> values = m_gradient->draw(m_scene);
        std::copy(values.begin(), values.end(), to.values.begin());
    };
    if (m_level->sides.empty())
        draw(drawn);
    // On a chessboard errors of neighbours may cancel each other. New strokes are for the ground that shows more of them.
    for (double worst = -1; const Level::Side &side : m_level->sides) {
        m_scene.ground = side.ground;
        FitPicture here;
        draw(here);
        if (const double square = meanSquare(here, side.target, m_level->loss.weight()); square > worst) {
            worst = square, target = &side.target;
            drawn = std::move(here);
        }
    }
    m_scene.ground = m_level->ground;
    const std::vector<FitStroke> added = strokesForError({*target, drawn, m_level->loss.weight(), m_level->scale}, count,
                                                         m_options.limits, m_options.seed + m_phase, m_cancel);
    m_fitted.strokes.insert(m_fitted.strokes.end(), added.begin(), added.end());
    m_adam.grow(m_fitted.strokes.size());
}

/// Begins a phase. Returns false if it was stopped before, and has changed nothing then.
bool Fitting::begin(const FitPhase &phase)
{
    const std::vector<FitStroke> strokes = m_fitted.strokes;
    const AdamSteps adam = m_adam;
    const FitPalette palette = m_palette;
    m_level = levelAt(phase.halvings);
    m_options.limits.leastSpread = std::min(1 / m_level->scale, 2.0);
    m_scene = sceneAt(*m_level);
    choose();
    if (const auto moved = std::size_t(std::lround(phase.moved * double(m_fitted.strokes.size()))); moved > 0)
        removeLeast(moved);
    if (const auto wanted = std::size_t(phase.strokes); m_fitted.strokes.size() < wanted)
        addStrokes(wanted - m_fitted.strokes.size());
    if (isCancelled()) {
        m_fitted.strokes = strokes;
        m_adam = adam;
        m_palette = palette;
        return false;
    }
    if (m_options.paints > 0 && m_phase + 1 == m_plan.size())
        m_palette = FitPalette(m_fitted.strokes, m_fitted.style, m_options.paints, m_options.seed);
    m_scene = sceneAt(*m_level);
    return true;
}

void Fitting::move(const FitPhase &phase)
{
    setNumbers(m_fitted.strokes, m_fitted.style, m_scene);
    if (m_step % stepsForNodes == 0)
        choose();
    const FitLoss &loss = m_level->loss;
    const gradient::FlatGradient &by = m_gradient->drawAndDifferentiate(
        m_scene, {[&loss](std::size_t first, std::size_t count, const float *rgb, float *byRgb) {
                      loss.differentiate(first, count, rgb, byRgb);
                  },
                  loss.isPlain() ? std::shared_ptr<const std::vector<float>>(m_level, &loss.target().values) : nullptr});
    std::vector<StrokeSlope> slopes = slopesOf(by, m_scene, m_fitted.strokes);
    if (!m_palette.isEmpty())
        m_palette.share(slopes);
    const double passed = double(m_step) / phase.steps;
    m_adam.move(m_fitted.strokes, slopes, {}, phase.firstRate * std::pow(phase.lastRate / phase.firstRate, passed));
    for (FitStroke &stroke : m_fitted.strokes)
        keepWithin(stroke, m_options.limits);
    if (!m_palette.isEmpty())
        m_palette.apply(m_fitted.strokes);
}

bool Fitting::step()
{
    if (isDone() || isCancelled())
        return !isDone();
    const FitPhase &phase = m_plan[m_phase];
    if (m_step < 0) {
        if (!begin(phase))
            return true;
        m_step = 0;
    }
    if (m_step < phase.steps && !m_fitted.strokes.empty()) {
        move(phase);
        ++m_steps;
        if (++m_step < phase.steps)
            return true;
    }
    end();
    return !isDone();
}

/// Ends a phase, unless it is stopped.
void Fitting::end()
{
    if (m_phase + 1 == m_plan.size() && (!removeIdle() || !orderBirths()))
        return;
    const std::size_t next = m_phase + 1;
    const bool isNear = m_options.error > 0 && next < m_plan.size() && m_plan[next].grows &&
                        std::sqrt(meanSquareError()) <= m_options.error;
    if (isCancelled())
        return;
    m_step = -1;
    m_phase = next;
    if (isNear) {
        while (m_plan[m_phase].grows)
            ++m_phase;
        for (FitPhase &phase : m_plan)
            phase.strokes = std::min(phase.strokes, int(m_fitted.strokes.size()));
    }
}

double Fitting::progress() const
{
    double done = 0, all = 0;
    for (std::size_t k = 0; k < m_plan.size(); ++k) {
        const double cost = std::pow(0.25, m_plan[k].halvings) * m_plan[k].steps;
        all += cost;
        done += k < m_phase ? cost : k == m_phase && m_step > 0 ? cost * m_step / m_plan[k].steps : 0;
    }
    return all > 0 ? done / all : 1;
}

Painting Fitting::painting() const
{
    return paintingOf(m_fitted, m_target, m_palette.paints());
}

FitPicture Fitting::picture()
{
    const auto full = levelAt(0);
    return drawn(*full, full->sides.empty() ? full->ground : full->sides[0].ground);
}

/// Draws the strokes so far on a ground of a level, or nothing if it is stopped.
FitPicture Fitting::drawn(const Level &full, const std::shared_ptr<const std::vector<float>> &ground) const
{
    gradient::SceneGradient<float> gradient{Threads(m_options.threads)};
    gradient::FlatScene scene = sceneAt(full);
    gradient.choose(scene);
    FitPicture out(full.view.width, full.view.height, 3);
    // Band by band, so that it stops soon.
    for (int y = 0; y < full.view.height; y += bandHeight) {
        if (isCancelled())
            return {};
        const PixelRect band{0, y, full.view.width, std::min(bandHeight, full.view.height - y)};
        scene.view = partOf(full.view, band);
        scene.ground = groundIn(ground.get(), full.view.width, band);
        const std::span<const float> values = gradient.draw(scene);
        std::copy(values.begin(), values.end(), out.at(0, y));
    }
    return out;
}

double Fitting::meanSquareError()
{
    const auto full = levelAt(0);
    const FitPicture is = drawn(*full, full->ground);
    return is.isEmpty() ? 0 : meanSquare(is, full->loss.target(), full->loss.weight());
}

} // namespace suffuse::fitting

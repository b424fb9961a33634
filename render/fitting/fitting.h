// From a picture to strokes, step by step.
#pragma once

#include "render/fitting/adam_steps.h"
#include "render/fitting/fit_loss.h"
#include "render/fitting/fit_palette.h"
#include "render/fitting/fit_plan.h"
#include "render/fitting/fitted_painting.h"
#include "render/gradient/differentiator.h"

#include <memory>
#include <optional>

namespace suffuse::fitting {

/// What a fit is to do.
struct FitOptions {
    int strokes = 512; ///< at most; a few that do nothing are left out
    double error = 0;  ///< No more strokes than this root mean square error asks for; 0: all.
    int steps = usualFitSteps;
    int paints = 0;        ///< 0: each stroke has a colour of its own
    double perceptual = 0; ///< share of OKLab in the loss, [0, 1]
    FitLimits limits;
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: one for each core
};

/// A fit under way. What it does is a pure function of target, options and start, on one processor: the same bits for any number
/// of threads. It is used by one thread at a time; only the flag of `stopWith` may change meanwhile.
class Fitting {
public:
    /// `differentiator` finds the gradients, of one fit at a time; null: the CPU does.
    Fitting(FitTarget target, const FitOptions &options, std::shared_ptr<gradient::Differentiator> differentiator = {});
    /// Goes on with strokes. Their style is taken, in place of that of the options.
    Fitting(FitTarget target, const FitOptions &options, FittedStrokes start,
            std::shared_ptr<gradient::Differentiator> differentiator = {});
    ~Fitting();

    /// Makes `step` return soon after the flag is set, which then outlives the fit. A fit goes on after it is cleared,
    /// as if it had not been set.
    void stopWith(const std::atomic<bool> *flag) { m_cancel = flag; }
    /// Does a step of some tens of milliseconds. Returns false when the fit has ended, and does nothing from then on.
    bool step();
    bool isDone() const { return m_phase == m_plan.size(); }
    double progress() const;              ///< [0, 1], about in time
    int steps() const { return m_steps; } ///< so many were done

    const FittedStrokes &strokes() const { return m_fitted; }
    /// The painting so far.
    Painting painting() const;
    const FitTarget &target() const { return m_target; }
    const gradient::Differentiator &differentiator() const { return *m_gradient; }
    /// Draws the strokes so far at the size of the target; on white, where their coverage counts. Empty if it was stopped
    /// before.
    FitPicture picture();
    /// The mean square error of the strokes so far, of what counts, at the size of the target; no number if it was stopped before.
    double meanSquareError();

private:
    struct Level;
    bool begin(const FitPhase &phase);
    void move(const FitPhase &phase);
    void end();
    void addStrokes(std::size_t count);
    void removeLeast(std::size_t count);
    bool removeIdle();
    bool orderBirths();
    void keep(const std::vector<std::size_t> &kept);
    void choose();
    std::shared_ptr<const Level> levelAt(int halvings);
    gradient::FlatScene sceneAt(const Level &level) const;
    FitPicture drawn(const Level &full, const std::shared_ptr<const std::vector<float>> &ground) const;
    bool isCancelled() const { return m_cancel && *m_cancel; }

    FitTarget m_target;
    FitOptions m_options;
    FittedStrokes m_fitted;
    std::vector<FitPhase> m_plan;
    std::size_t m_phase = 0;
    int m_step = -1; ///< of the phase; −1: it has not begun
    int m_steps = 0;
    AdamSteps m_adam;
    FitPalette m_palette;
    std::vector<std::shared_ptr<Level>> m_levels; ///< by halvings
    std::shared_ptr<const Level> m_level;
    std::shared_ptr<gradient::Differentiator> m_gradient;
    gradient::FlatScene m_scene;
    const std::atomic<bool> *m_cancel = nullptr;
};

} // namespace suffuse::fitting

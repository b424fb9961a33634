// Frames of a drag that floats.
#pragma once

#include "app/session/frames/coarse_frames.h"
#include "app/session/frames/exact_frames.h"
#include "app/session/frames/floating_layers.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace suffuse {

/// Draws the two pictures of a lift, by whatever is quickest, and composes frames of them (FloatingLayers). Used by one
/// thread.
class FloatingFrames {
public:
    /// Pictures of the rest are drawn by `exact`, which has drawn most of them already, or in haste by `coarse`.
    FloatingFrames(const RendererOptions &options, MakeRenderer make, ExactFrames &exact, CoarseFrames &coarse,
                   FrameBoard &board);

    /// Composes the frame of the task's job on the board. What it lacks for that it draws coarsely, since a hand waits.
    /// `frame` gets figures.
    FrameResult show(const FrameTask &task, FrameInfo &frame);
    /// Draws the two pictures of the task's lift as finely as they go.
    FrameResult prepare(const FrameTask &task, const std::atomic<bool> *cancel);
    /// Lets pictures and renderer go.
    void forget() { m_layers.reset(); }
    bool keepsAny() const { return m_layers != nullptr; }

    /// The lift of which there are both pictures; null: none.
    LiftPtr lift() const { return m_layers ? m_layers->lift() : nullptr; }
    bool isFine() const { return m_layers && m_layers->areFine(); }

private:
    bool open();
    FrameOutcome hurry(const FrameTask &task);
    FrameOutcome drawRest(const LiftPtr &lift, const std::atomic<bool> *cancel);
    FrameOutcome drawLifted(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel);
    bool drawCoarseRest(const FrameTask &task);
    bool layPaper(const FrameTask &task);
    std::optional<std::uint32_t> paperPixel(const Painting &painting) const;
    void takeShown(const LiftPtr &lift, std::uint32_t paper);

    RendererOptions m_options;
    MakeRenderer m_make;
    ExactFrames &m_exact;
    CoarseFrames &m_coarse;
    FrameBoard &m_board;
    std::unique_ptr<FloatingLayers> m_layers; ///< null until they are needed
};

} // namespace suffuse

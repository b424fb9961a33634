// The paper's texture η (docs/paper.md), written from its definition.
#pragma once

#include "render/scene/paper.h"

namespace suffuse::reference {

class PaperField {
public:
    /// `texture` is the decoded image of an image paper, otherwise null.
    PaperField(const Paper &paper, std::shared_ptr<const PaperTexture> texture);

    /// η ∈ [0, 1] at a canvas point. `px` is the size of a sample in canvas units; 0 means all 48 octaves.
    double at(Point canvas, double px) const;

private:
    double procedural(Point canvas, double px) const;
    double octaves(Point cell, double samples) const;
    double fibres(Point cell) const;
    double weave(Point cell) const;
    double image(Point canvas) const;

    Paper m_paper;
    std::shared_ptr<const PaperTexture> m_texture;
};

/// The gradient c of noise n_k at the lattice point whose coordinates are X, Y modulo 2³².
Point paperGradient(std::uint32_t x, std::uint32_t y, std::uint32_t layer, std::uint32_t seed);

} // namespace suffuse::reference

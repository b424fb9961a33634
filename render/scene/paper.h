// The paper's texture decoded for rendering (docs/paper.md).
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <memory>
#include <vector>

namespace suffuse {

/// Grey values in [0, 1] of an image paper, row by row.
struct PaperTexture {
    int width = 0;
    int height = 0;
    std::vector<float> grey;
};

/// Decodes an image paper by the image module (cached by the identity of the image). Null without an error for papers
/// that are not images.
Result<std::shared_ptr<const PaperTexture>> paperTexture(const Paper &paper);

} // namespace suffuse

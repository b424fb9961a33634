// The pictures that strokes are painted with, decoded for rendering (docs/solver.md, "Pictures").
#pragma once

#include "model/painting/stroke.h"
#include "model/result.h"
#include "render/math/picture_view.h"
#include "render/picture_grid.h"

#include <memory>
#include <vector>

namespace suffuse {

/// An image at all its sizes, from its own on, each half as large as the one before, the last one a single pixel: a
/// pixel is the mean of the four that it stands for, of those that there are at the edge.
class PictureLevels {
public:
    PictureLevels(int width, int height);

    std::size_t count() const { return m_levels.size(); }
    PictureLevel level(std::size_t k) const;
    std::size_t bytes() const { return m_values.size() * sizeof(std::uint16_t); }

    /// Sets a pixel of the image to straight values in [0, 1].
    void set(int x, int y, const float *rgba);
    /// Computes the smaller sizes from the image.
    void reduce();

private:
    struct Place {
        int width, height;
        std::size_t from; ///< in m_values
    };
    std::vector<Place> m_levels;
    std::vector<std::uint16_t> m_values;
};
using PictureLevelsPtr = std::shared_ptr<const PictureLevels>;

/// The pixels that the pictures of one painting may have together. More are neither imported nor drawn.
inline constexpr std::uint64_t mostPicturePixels = std::uint64_t(1) << 27;
/// The bytes of decoded pictures that are kept though nothing shows them now.
inline constexpr std::size_t mostIdlePictures = std::size_t(256) << 20;

/// Decodes a picture by the image module. Pictures of one image share what is decoded, and it is kept for a while once
/// none is left. An error names the remedy and begins with `name`, if there is one; it may be called on any thread.
Result<PictureLevelsPtr> pictureLevels(const Picture &picture, const QString &name = {});
/// The bytes of all decoded pictures, those that are shown and those that are kept.
std::size_t pictureBytes();

/// A stroke's picture as it lies in a grid of pixels.
struct ScenePicture {
    PictureLevelsPtr levels;
    PictureView view;
};
/// Null where the picture cannot be shown: its file is missing, or it cannot be read. Then nothing of the stroke is
/// seen.
std::shared_ptr<const ScenePicture> scenePicture(const Stroke &stroke, const PictureGrid &grid);
/// Whether two pictures show the same, in one grid.
bool isSamePicture(const ScenePicture *a, const ScenePicture *b);

} // namespace suffuse

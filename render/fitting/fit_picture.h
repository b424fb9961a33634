// Pictures that are fitted: how they are read at a bounded size, averaged and blurred.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <atomic>
#include <cstddef>
#include <vector>

namespace suffuse::fitting {

/// A picture as numbers: `channels` values of each pixel, row by row.
struct FitPicture {
    int width = 0, height = 0;
    int channels = 3; ///< 3: sRGB-encoded R, G, B in [0, 1]; 1: a weight, or an error
    std::vector<float> values;

    FitPicture() = default;
    FitPicture(int w, int h, int c)
        : width(w), height(h), channels(c), values(std::size_t(w) * std::size_t(h) * std::size_t(c))
    {}
    std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
    bool isEmpty() const { return values.empty(); }
    float *at(int x, int y) { return values.data() + (std::size_t(y) * width + x) * channels; }
    const float *at(int x, int y) const { return values.data() + (std::size_t(y) * width + x) * channels; }
};

/// What is fitted.
struct FitTarget {
    FitPicture picture;
    FitPicture weight;                        ///< how much each pixel counts, [0, 1]; empty: all count alike
    FitPicture ground;                        ///< what lies below the strokes; empty: a colour that the fit chooses
    /// Where the coverage of the strokes counts beside their colours: picture and ground are those on white, and these
    /// the same on black. Otherwise empty.
    struct {
        FitPicture picture, ground;
    } onBlack;
    double canvasWidth = 0, canvasHeight = 0; ///< of the painting: a unit for each pixel of the file
};

/// So many pixels a picture is averaged down to, unless the caller says otherwise: a photograph of that size holds
/// more than some thousand strokes can show.
inline constexpr int usualFitPixels = 600'000;

/// Reads an image at no more than `mostPixels` pixels, each the mean of what it covers. Rows are averaged as they are
/// decoded, so that a large file takes no more memory than its decoder does. Where it is transparent, white shows. A
/// file of diffusion curves is solved at that size (render/curves).
/// Errors name the file. It stops with an error soon after `cancel` is set.
Result<FitTarget> readFitTarget(const QByteArray &bytes, const QString &name, int mostPixels = usualFitPixels,
                                const std::atomic<bool> *cancel = nullptr);
/// Reads a mask of any size for a target: white counts, black does not, and what is transparent does not.
Result<FitPicture> readMask(const QByteArray &bytes, const QString &name, const FitTarget &target);

/// The picture at another size, not larger than it: each pixel is the mean of the area that it covers.
FitPicture averaged(const FitPicture &picture, int width, int height);
/// Blurred by about a Gaussian of this standard deviation in pixels (three means over boxes, one after another); beyond
/// its border a picture is 0.
FitPicture blurred(const FitPicture &picture, double deviation);

} // namespace suffuse::fitting

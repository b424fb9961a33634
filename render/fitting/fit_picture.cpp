#include "render/fitting/fit_picture.h"

#include "model/formats/files.h"
#include "model/formats/ink/curve_set.h"
#include "render/curves/solved_curves.h"
#include "render/image_io/image_io.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::fitting {

namespace {

/// Where a pixel of one size lies among those of a smaller one, along one axis: in `first` with a share, and in the
/// next one with the rest.
struct Overlap {
    int first = 0;
    float share = 1;
};

std::vector<Overlap> overlapsOf(int from, int to)
{
    std::vector<Overlap> out(static_cast<std::size_t>(from));
    const double scale = double(to) / from;
    for (int i = 0; i < from; ++i) {
        const double begin = i * scale, end = (i + 1) * scale;
        Overlap &o = out[std::size_t(i)];
        o.first = std::min(int(begin), to - 1);
        o.share = float(std::clamp((o.first + 1 - begin) / (end - begin), 0.0, 1.0));
        if (o.first + 1 >= to)
            o.share = 1;
    }
    return out;
}

/// Adds pixels of a large picture up to the means of a smaller one, in any order.
class Averager {
public:
    Averager() = default;
    Averager(int fromWidth, int fromHeight, int width, int height, int channels)
        : m_across(overlapsOf(fromWidth, width)), m_down(overlapsOf(fromHeight, height)),
          m_sum(width, height, channels), m_scale(float(width) / float(fromWidth) * float(height) / float(fromHeight))
    {}

    void add(int x, int y, const float *value)
    {
        const Overlap &across = m_across[std::size_t(x)], &down = m_down[std::size_t(y)];
        for (int dy = 0; dy < 2; ++dy)
            for (int dx = 0; dx < 2; ++dx) {
                const float share = (dx ? 1 - across.share : across.share) * (dy ? 1 - down.share : down.share);
                if (share <= 0)
                    continue;
                float *const to = m_sum.at(across.first + dx, down.first + dy);
                for (int c = 0; c < m_sum.channels; ++c)
                    to[c] += share * m_scale * value[c];
            }
    }
    FitPicture take() { return std::move(m_sum); }

private:
    std::vector<Overlap> m_across, m_down;
    FitPicture m_sum;
    float m_scale = 1;
};

/// The mean over 2·radius + 1 values with a given step, 0 beyond the ends.
void averageLine(const float *in, float *out, int count, std::ptrdiff_t step, int radius)
{
    double sum = 0;
    for (int i = 0; i < std::min(radius, count); ++i)
        sum += in[i * step];
    const double scale = 1.0 / (2 * radius + 1);
    for (int i = 0; i < count; ++i) {
        if (i + radius < count)
            sum += in[(i + radius) * step];
        if (i - radius - 1 >= 0)
            sum -= in[(i - radius - 1) * step];
        out[i * step] = float(sum * scale);
    }
}

/// Width and height of a picture that has no more pixels than that.
std::array<int, 2> sizeWithin(int mostPixels, double width, double height)
{
    const double scale = std::min(1.0, std::sqrt(double(mostPixels) / (width * height)));
    const int w = std::max(1, int(std::floor(width * scale)));
    return {w, std::clamp(int(std::lround(height * (double(w) / width))), 1, std::max(1, mostPixels / w))};
}

/// The picture that diffusion curves make, for each pixel of their file a unit of the canvas.
Result<FitTarget> readCurves(const QByteArray &bytes, const QString &name, int mostPixels, int threads,
                             const std::atomic<bool> *cancel)
{
    const Result<CurveSet> set = readCurveSet(bytes, name);
    if (!set)
        return Error{set.error()};
    if (const QString problem = curves::problemOf(*set); !problem.isEmpty())
        return Error{QStringLiteral("%1: %2").arg(name, problem)};
    FitTarget target;
    target.canvasWidth = set->width, target.canvasHeight = set->height;
    const std::array<int, 2> size = sizeWithin(mostPixels, set->width, set->height);
    curves::SolvedCurves solved = curves::solvedCurves(*set, size[0], size[1], threads, cancel);
    if (cancel && *cancel)
        return Error{QCoreApplication::translate("fitting", "stopped")};
    target.picture = FitPicture(size[0], size[1], 3);
    target.picture.values = std::move(solved.rgb);
    return target;
}

/// A picture read into `mostPixels`; `value` makes a pixel's numbers of straight RGBA.
template <typename Value>
Result<FitTarget> readAveraged(const QByteArray &bytes, const QString &name, int channels, Value value,
                               std::array<int, 2> size, int mostPixels, const std::atomic<bool> *cancel)
{
    FitTarget target;
    Averager averager;
    ImageRows rows;
    rows.begin = [&](int width, int height) {
        target.canvasWidth = width, target.canvasHeight = height;
        int w = size[0], h = size[1];
        if (w == 0) {
            const std::array<int, 2> fitting = sizeWithin(mostPixels, width, height);
            w = fitting[0], h = fitting[1];
        }
        // A mask may be smaller than its picture: then its pixels are repeated.
        averager = Averager(width, height, std::min(w, width), std::min(h, height), channels);
    };
    rows.row = [&](const ImageRun &run) {
        if (cancel && *cancel)
            return;
        run.forEach([&](int x, int y, const float *rgba) {
            std::array<float, 3> v{};
            value(rgba, v);
            averager.add(x, y, v.data());
        });
    };
    if (const Result<void> read = readImageRows(bytes, name, rows); !read)
        return Error{read.error()};
    if (cancel && *cancel)
        return Error{QCoreApplication::translate("fitting", "stopped")};
    target.picture = averager.take();
    for (float &v : target.picture.values)
        v = std::clamp(v, 0.0f, 1.0f);
    return target;
}

} // namespace

Result<FitTarget> readFitTarget(const QByteArray &bytes, const QString &name, int mostPixels,
                                const std::atomic<bool> *cancel)
{
    if (detectFormat(bytes) == FileFormat::DiffusionCurves)
        return readCurves(bytes, name, mostPixels, 0, cancel);
    return readAveraged(
        bytes, name, 3,
        [](const float *rgba, std::array<float, 3> &v) {
            for (std::size_t c = 0; c < 3; ++c)
                v[c] = 1 + rgba[3] * (rgba[c] - 1);
        },
        {0, 0}, mostPixels, cancel);
}

Result<FitPicture> readMask(const QByteArray &bytes, const QString &name, const FitTarget &target)
{
    const int width = target.picture.width, height = target.picture.height;
    const Result<FitTarget> mask = readAveraged(
        bytes, name, 1,
        [](const float *rgba, std::array<float, 3> &v) {
            v[0] = rgba[3] * (0.299f * rgba[0] + 0.587f * rgba[1] + 0.114f * rgba[2]);
        },
        {width, height}, 0, nullptr);
    if (!mask)
        return Error{mask.error()};
    const FitPicture &small = mask->picture;
    FitPicture out(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            *out.at(x, y) = *small.at(x * small.width / width, y * small.height / height);
    if (std::all_of(out.values.begin(), out.values.end(), [](float v) { return v <= 0; }))
        return Error{QCoreApplication::translate(
                         "fitting", "%1: is black all over, so nothing counts; paint white what is to be fitted")
                         .arg(name)};
    return out;
}

FitPicture averaged(const FitPicture &picture, int width, int height)
{
    if (width == picture.width && height == picture.height)
        return picture;
    Averager averager(picture.width, picture.height, width, height, picture.channels);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            averager.add(x, y, picture.at(x, y));
    return averager.take();
}

FitPicture blurred(const FitPicture &picture, double deviation)
{
    // A box of 2r + 1 pixels has the variance r (r + 1)/3. Of the three, some are a pixel wider on each side.
    const double variance = deviation * deviation;
    const int radius = std::max(0, int(std::sqrt(variance + 0.25) - 0.5));
    const int wider = int(std::lround((variance - radius * (radius + 1)) / (2.0 * (radius + 1) / 3)));
    FitPicture from = picture, to = picture;
    const std::ptrdiff_t across = picture.channels, down = std::ptrdiff_t(picture.width) * picture.channels;
    for (int pass = 0; pass < 6; ++pass) {
        const bool isDown = pass >= 3;
        const int lines = isDown ? picture.width : picture.height;
        for (int line = 0; line < lines; ++line)
            for (int c = 0; c < picture.channels; ++c) {
                const std::ptrdiff_t at = line * (isDown ? across : down) + c;
                averageLine(from.values.data() + at, to.values.data() + at, isDown ? picture.height : picture.width,
                            isDown ? down : across, radius + (pass % 3 < wider ? 1 : 0));
            }
        std::swap(from, to);
    }
    return from;
}

} // namespace suffuse::fitting

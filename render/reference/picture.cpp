#include "render/reference/picture.h"

#include "render/image_io/image_io.h"

#include <algorithm>
#include <cmath>

namespace suffuse::reference {

const PictureField::Value &PictureField::Level::at(int x, int y) const
{
    return values[std::size_t(std::clamp(y, 0, height - 1)) * std::size_t(width) +
                  std::size_t(std::clamp(x, 0, width - 1))];
}

PictureField::Value PictureField::Level::between(double x, double y) const
{
    const double left = std::floor(std::clamp(x - 0.5, -1.0, double(width)));
    const double top = std::floor(std::clamp(y - 0.5, -1.0, double(height)));
    const double right = std::clamp(x - 0.5 - left, 0.0, 1.0), down = std::clamp(y - 0.5 - top, 0.0, 1.0);
    Value value{};
    for (std::size_t c = 0; c < 4; ++c) {
        const auto corner = [&](int i, int j) { return at(int(left) + i, int(top) + j)[c]; };
        value[c] =
            std::lerp(std::lerp(corner(0, 0), corner(1, 0), right), std::lerp(corner(0, 1), corner(1, 1), right), down);
    }
    return value;
}

PictureField::Level PictureField::half(const Level &level)
{
    Level out{(level.width + 1) / 2, (level.height + 1) / 2, {}};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            // Where one of two is missing, the other one counts twice, which is their mean.
            Value mean{};
            for (std::size_t c = 0; c < 4; ++c)
                mean[c] = 0.25 * (level.at(2 * x, 2 * y)[c] + level.at(2 * x + 1, 2 * y)[c] +
                                  level.at(2 * x, 2 * y + 1)[c] + level.at(2 * x + 1, 2 * y + 1)[c]);
            out.values.push_back(mean);
        }
    return out;
}

std::shared_ptr<const PictureField> PictureField::of(const Stroke &stroke, const View &view)
{
    const Picture &picture = *stroke.picture;
    if (!picture.image)
        return nullptr;
    const Result<FloatPicture> image = readImage(*picture.image, picture.link);
    if (!image)
        return nullptr;
    auto field = std::make_shared<PictureField>();
    field->m_view = view;
    field->m_corner = stroke.origin + picture.corner;
    field->m_right = (stroke.origin + picture.right) - field->m_corner;
    field->m_down = (stroke.origin + picture.down) - field->m_corner;
    Level level{image->width, image->height, {}};
    for (std::size_t i = 0; i < std::size_t(image->width) * std::size_t(image->height); ++i) {
        const float *rgba = image->rgba.data() + 4 * i;
        const double alpha = double(rgba[3]);
        level.values.push_back({alpha * double(rgba[0]), alpha * double(rgba[1]), alpha * double(rgba[2]), alpha});
    }
    // How fast the place in the image can change from pixel to pixel: the reciprocal of the least stretch of its map.
    const Point a = (view.scale / image->width) * field->m_right, b = (view.scale / image->height) * field->m_down;
    const double sum = dot(a, a) + dot(b, b), area = std::abs(cross(a, b));
    const double greatest = std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, (sum - 2 * area) * (sum + 2 * area)))));
    field->m_lambda = std::max(0.0, std::log2(greatest / area));
    double size = 1;
    while (field->m_lambda >= 1 && (level.width > 1 || level.height > 1)) {
        level = half(level);
        field->m_lambda -= 1;
        size *= 2;
    }
    if (level.width == 1 && level.height == 1)
        field->m_lambda = 0;
    field->m_columns = image->width / size, field->m_rows = image->height / size;
    field->m_coarser = half(level);
    field->m_finer = std::move(level);
    return field;
}

Paint PictureField::shownAt(Point canvas, const Paint &paint) const
{
    const Point from = canvas - m_corner;
    const double area = cross(m_right, m_down);
    const double x = m_columns * cross(from, m_down) / area, y = m_rows * cross(m_right, from) / area;
    const Value finer = m_finer.between(x, y), coarser = m_coarser.between(0.5 * x, 0.5 * y);
    Value value{};
    for (std::size_t c = 0; c < 4; ++c)
        value[c] = std::lerp(finer[c], coarser[c], m_lambda);
    const double alpha = value[3];
    if (!(alpha > 0))
        return {0, paint.colour};
    return {paint.opacity * alpha, rybOfRgb({std::min(1.0, value[0] / alpha), std::min(1.0, value[1] / alpha),
                                             std::min(1.0, value[2] / alpha)})};
}

} // namespace suffuse::reference

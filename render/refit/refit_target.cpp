#include "render/refit/refit_target.h"

#include "model/geometry/affine.h"
#include "model/paint/half_width.h"
#include "model/painting/ryb.h"
#include "model/shaping/transform.h"
#include "render/target.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace suffuse::refit {

namespace {

using fitting::FitPicture;
using fitting::FitTarget;

constexpr double pixelsForSpread = 2;   ///< The finest stroke has so many at least,
constexpr double mostPixelsForUnit = 4; ///< and a unit no more than that.
constexpr float leastGain = 1.0f / 64;  ///< Below, what lies above hides what is fitted.
constexpr double sameShape = 0.01;      ///< Sides may differ by that share.

Rect sheetOf(const Painting &painting)
{
    return painting.canvas.area();
}

Rect commonOf(const Rect &a, const Rect &b)
{
    const Rect common{std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
                      std::min(a.bottom, b.bottom)};
    return common.isEmpty() ? Rect() : common;
}

bool isShapedLike(double width, double height, const Rect &sheet)
{
    return std::abs(width * sheet.height() / (height * sheet.width()) - 1) <= sameShape;
}

QString otherShape(const QString &name, double width, double height, const Rect &sheet)
{
    return QCoreApplication::translate("refit",
                                       "%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape "
                                       "of the sheet")
        .arg(name)
        .arg(width)
        .arg(height)
        .arg(sheet.width())
        .arg(sheet.height());
}

std::array<double, 3> pigmentsAt(const FitPicture &picture, std::size_t pixel)
{
    const float *const v = picture.values.data() + 3 * pixel;
    return rybFromSrgb({double(v[0]), double(v[1]), double(v[2])});
}

} // namespace

RefitPictures::RefitPictures(const RefitScope &scope, const RefitGoal &goal, Renderer &renderer, int mostPixels,
                             const std::atomic<bool> *cancel)
    : m_scope(scope), m_goal(goal), m_renderer(renderer), m_cancel(cancel)
{
    const Rect &area = scope.area();
    const double fine = scope.finestSpread() > 0 ? pixelsForSpread / scope.finestSpread() : 1;
    m_scale = std::min(std::clamp(fine, 1.0, mostPixelsForUnit),
                       std::sqrt(double(mostPixels) / (area.width() * area.height())));
    m_width = std::max(1, int(std::floor(area.width() * m_scale)));
    m_scale = m_width / area.width();
    m_height = std::max(1, int(std::lround(area.height() * m_scale)));
}

/// A painting over an area, on its own sheet.
Result<FitPicture> RefitPictures::drawn(const Painting &painting, const Rect &area, int width, int height) const
{
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(painting);
    request.time = m_scope.painting().end();
    request.view = View::ofArea(area, width, height);
    FloatPicture picture;
    const Result<RenderStats> stats = m_renderer.render(request, picture, m_cancel);
    if (!stats)
        return Error{stats.error()};
    if (stats->cancelled || (m_cancel && *m_cancel))
        return Error{QCoreApplication::translate("refit", "stopped")};
    FitPicture out(width, height, 3);
    for (std::size_t p = 0; p < out.pixels(); ++p)
        for (std::size_t c = 0; c < 3; ++c)
            out.values[3 * p + c] = std::clamp(picture.rgba[4 * p + c], 0.0f, 1.0f);
    return out;
}

/// The picture of a file over an area, between its pixels bilinear.
Result<FitPicture> RefitPictures::pictureOfFile(const Rect &area, int width, int height) const
{
    const Rect sheet = sheetOf(m_scope.painting());
    const double pixels = std::clamp(sheet.width() * sheet.height() * m_scale * m_scale, 1.0, 1e7);
    const Result<FitTarget> read = fitting::readFitTarget(m_goal.picture, m_goal.name, int(pixels), m_cancel);
    if (!read)
        return Error{read.error()};
    if (!isShapedLike(read->canvasWidth, read->canvasHeight, sheet))
        return Error{otherShape(m_goal.name, read->canvasWidth, read->canvasHeight, sheet)};
    const FitPicture &all = read->picture;
    const Affine map = Affine::between(sheet, Rect::of(0, 0, all.width, all.height));
    FitPicture out(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Point at =
                map({area.left + (x + 0.5) * area.width() / width, area.top + (y + 0.5) * area.height() / height});
            const double px = std::clamp(at.x - 0.5, 0.0, all.width - 1.0),
                         py = std::clamp(at.y - 0.5, 0.0, all.height - 1.0);
            const int left = int(px), top = int(py), right = std::min(left + 1, all.width - 1),
                      bottom = std::min(top + 1, all.height - 1);
            const auto u = float(px - left), v = float(py - top);
            for (int c = 0; c < 3; ++c)
                out.at(x, y)[c] = (1 - v) * ((1 - u) * all.at(left, top)[c] + u * all.at(right, top)[c]) +
                                  v * ((1 - u) * all.at(left, bottom)[c] + u * all.at(right, bottom)[c]);
        }
    return out;
}

/// The whole picture that is wanted over an area, on a sheet of that colour.
Result<FitPicture> RefitPictures::goalOn(const Colour &sheet, const Rect &area, int width, int height) const
{
    if (!m_goal.picture.isEmpty())
        return pictureOfFile(area, width, height);
    Painting other = m_goal.painting ? *m_goal.painting : m_scope.painting();
    const Rect own = sheetOf(m_scope.painting()), its = sheetOf(other);
    if (m_goal.painting && !isShapedLike(its.width(), its.height(), own))
        return Error{otherShape(m_goal.name, its.width(), its.height(), own)};
    if (!m_goal.painting || other.canvas.background.opacity < 1)
        other.canvas.background = sheet;
    const Affine map = Affine::between(own, its);
    const Point from = map({area.left, area.top}), to = map({area.right, area.bottom});
    return drawn(other, {from.x, from.y, to.x, to.y}, width, height);
}

/// Makes of a goal for the whole picture one for what lies below `above`, which is that on white and on black.
void RefitPictures::lookThrough(FitPicture &goal, const FitPicture *above, FitPicture *weight) const
{
    for (std::size_t p = 0; p < goal.pixels(); ++p) {
        const std::array<double, 3> offset = pigmentsAt(above[0], p), onBlack = pigmentsAt(above[1], p);
        double gain = 0;
        for (std::size_t c = 0; c < 3; ++c)
            gain += (onBlack[c] - offset[c]) / 3;
        gain = std::clamp(gain, 0.0, 1.0);
        if (weight)
            weight->values[p] = gain < double(leastGain) ? 0 : float(gain * gain);
        if (m_goal.isOwnLook() || gain < double(leastGain))
            continue;
        std::array<double, 3> below = pigmentsAt(goal, p);
        for (std::size_t c = 0; c < 3; ++c)
            below[c] = std::clamp((below[c] - offset[c]) / gain, 0.0, 1.0);
        const std::array<double, 3> rgb = srgbFromRyb(below);
        std::copy(rgb.begin(), rgb.end(), goal.values.begin() + std::ptrdiff_t(3 * p));
    }
}

Result<FitTarget> RefitPictures::target() const
{
    if (!m_goal.isOwnLook() && !m_scope.isWholePainting())
        return Error{QCoreApplication::translate("refit", "the strokes are in a group that is put on the others as one "
                                                          "picture, so no picture of the whole says how they should "
                                                          "look; make it a group like others first")};
    FitTarget out;
    const Rect &area = m_scope.area();
    out.canvasWidth = area.width(), out.canvasHeight = area.height();
    FitPicture above[2];
    if (m_scope.hasAbove())
        for (const bool black : {false, true}) {
            const float v = black ? 1 : 0;
            Result<FitPicture> on = drawn(m_scope.part(RefitScope::Above, {v, v, v, 1}), area, m_width, m_height);
            if (!on)
                return Error{on.error()};
            above[black ? 1 : 0] = std::move(*on);
        }
    for (const bool black : {false, true}) {
        if (black && !m_scope.showsCoverage())
            break;
        const Colour sheet = m_scope.sheet(black);
        Result<FitPicture> ground = drawn(m_scope.part(RefitScope::Ground, sheet), area, m_width, m_height);
        if (!ground)
            return Error{ground.error()};
        Result<FitPicture> goal = m_goal.isOwnLook()
                                      ? drawn(m_scope.part(RefitScope::Chosen, sheet), area, m_width, m_height)
                                      : goalOn(sheet, area, m_width, m_height);
        if (!goal)
            return Error{goal.error()};
        if (m_scope.hasAbove()) {
            if (!black)
                out.weight = FitPicture(m_width, m_height, 1);
            lookThrough(*goal, above, black ? nullptr : &out.weight);
        }
        (black ? out.onBlack.picture : out.picture) = std::move(*goal);
        (black ? out.onBlack.ground : out.ground) = std::move(*ground);
    }
    if (!out.weight.isEmpty() &&
        std::all_of(out.weight.values.begin(), out.weight.values.end(), [](float v) { return v <= 0; }))
        return Error{QCoreApplication::translate("refit",
                                                 "other strokes hide the chosen ones wholly; choose others, or "
                                                 "hide what lies above")};
    return out;
}

Result<RefitPictures::Difference> RefitPictures::differenceOf(const Painting &painting, const Rect &area) const
{
    const int width = std::max(1, int(std::lround(area.width() * m_scale))),
              height = std::max(1, int(std::lround(area.height() * m_scale)));
    const Colour &own = m_scope.painting().canvas.background;
    Difference out;
    double sum = 0, count = 0;
    for (const float rest : {0.0f, 1.0f}) {
        if (rest > 0 && own.opacity >= 1)
            break;
        const auto pigment = [&](float v) { return own.opacity * v + (1 - own.opacity) * rest; };
        const Colour sheet{pigment(own.red), pigment(own.yellow), pigment(own.blue), 1};
        Painting shown = painting;
        shown.canvas.background = sheet;
        const Result<FitPicture> is = drawn(shown, area, width, height), wanted = goalOn(sheet, area, width, height);
        if (!is || !wanted)
            return Error{is ? wanted.error() : is.error()};
        for (std::size_t i = 0; i < is->values.size(); ++i) {
            const double d = std::abs(double(is->values[i]) - double(wanted->values[i]));
            sum += d * d;
            out.greatest = std::max(out.greatest, 255 * d);
        }
        count += double(is->values.size());
    }
    out.rootMeanSquare = 255 * std::sqrt(sum / count);
    return out;
}

Rect areaWith(const RefitScope &scope, const StrokeList &strokes)
{
    Rect out = scope.area();
    for (const StrokePtr &stroke : strokes)
        out = out.united(commonOf(seenBox(*stroke), sheetOf(scope.painting())));
    return commonOf(out, sheetOf(scope.painting()));
}

StrokeList placed(const RefitScope &scope, const Painting &fitted)
{
    StrokeList out;
    const Affine move = Affine::translation({scope.area().left, scope.area().top});
    for (const StrokePtr &stroke : fitted.strokes)
        out.push_back(std::make_shared<const Stroke>(transformed(*stroke, move, SpreadRule::Stays)));
    return out;
}

} // namespace suffuse::refit

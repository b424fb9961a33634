#include "render/drawing/drawing_picture.h"

#include "model/formats/svg/css/css_blending.h"
#include "model/painting/ryb.h"
#include "render/drawing/drawn_picture.h"
#include "render/drawing/path_coverage.h"
#include "render/math/scalar.h"
#include "render/threads/parallel.h"

// This header has templates over the numbers of scalar.h, which must be declared before it.
#include "render/math/blend.h"

#include <QCoreApplication>

#include <cmath>

namespace suffuse {

namespace {

constexpr int stripRows = 32;
constexpr double mostComparedPixels = 4e6;

/// A sheet of premultiplied RGBA while paths are put on it.
struct Sheet {
    GroupId group = 0;
    float opacity = 1;
    BlendMode blend = BlendMode::Normal;
    std::vector<float> rgba;
    std::vector<float> seen{}; ///< how much of each pixel is seen through what bounds the group; empty: all
};

/// Draws rows of a drawing.
class Strip {
public:
    Strip(const PathDrawing &drawing, const View &view, int top, int height)
        : m_drawing(drawing), m_view(view), m_top(top), m_height(height), m_coverage(view.width, top, height),
          m_levels(std::size_t(view.width) * std::size_t(height))
    {
        Sheet ground{0, 1, BlendMode::Normal, emptyRows()};
        const Colour &canvas = drawing.painting->canvas.background;
        const std::array<double, 3> rgb = srgbFromRyb(canvas);
        for (std::size_t i = 0; i < ground.rgba.size(); i += 4) {
            for (std::size_t c = 0; c < 3; ++c) // over white
                ground.rgba[i + c] = float(1 + double(canvas.opacity) * (rgb[c] - 1));
            ground.rgba[i + 3] = 1;
        }
        m_sheets.push_back(std::move(ground));
        if (const auto all = m_drawing.bounds.find(0); all != m_drawing.bounds.end())
            m_sheets.push_back({0, 1, BlendMode::Normal, emptyRows(), seenThrough(all->second)});
        m_floor = m_sheets.size();
    }

    void draw(FloatPicture &out, const std::atomic<bool> *cancel)
    {
        for (const DrawnStroke &stroke : m_drawing.strokes) {
            if (cancel && cancel->load(std::memory_order_relaxed))
                return;
            goTo(stroke.stroke->group);
            put(stroke);
        }
        goTo(0);
        while (m_sheets.size() > 1)
            putSheet();
        out.store({0, m_top, m_view.width, m_height}, m_sheets.front().rgba.data(), m_view.width);
    }

private:
    std::vector<float> emptyRows() const { return std::vector<float>(4 * std::size_t(m_view.width * m_height)); }

    /// What follows is in this group.
    void goTo(GroupId id)
    {
        std::vector<const Group *> wanted;
        for (const Group *group = m_drawing.painting->findGroup(id); group;
             group = m_drawing.painting->findGroup(group->parent))
            if (comesTogether(m_drawing, *group))
                wanted.insert(wanted.begin(), group);
        std::size_t same = 0;
        while (same < wanted.size() && same + m_floor < m_sheets.size() &&
               m_sheets[same + m_floor].group == wanted[same]->id)
            ++same;
        while (m_sheets.size() > same + m_floor)
            putSheet();
        for (; same < wanted.size(); ++same) {
            const Group &group = *wanted[same];
            Sheet sheet{group.id, group.opacity, cssOf(group.blend) ? group.blend : BlendMode::Normal, emptyRows()};
            if (const auto bounds = m_drawing.bounds.find(group.id); bounds != m_drawing.bounds.end())
                sheet.seen = seenThrough(bounds->second);
            m_sheets.push_back(std::move(sheet));
        }
    }

    std::vector<float> seenThrough(const std::vector<DrawnBound> &bounds)
    {
        std::vector<float> seen(m_levels.size(), 1.0f);
        for (const DrawnBound &bound : bounds) {
            m_sheets.push_back({0, 1, BlendMode::Normal, emptyRows()});
            for (const DrawnStroke &stroke : bound.strokes)
                put(stroke);
            for (std::size_t i = 0; i < seen.size(); ++i)
                seen[i] *= m_sheets.back().rgba[4 * i + 3] * float(bound.opacity);
            m_sheets.pop_back();
        }
        return seen;
    }

    void putSheet()
    {
        const Sheet sheet = std::move(m_sheets.back());
        m_sheets.pop_back();
        std::vector<float> &below = m_sheets.back().rgba;
        for (std::size_t i = 0; i < below.size(); i += 4) {
            const float alpha = sheet.rgba[i + 3] * sheet.opacity * (sheet.seen.empty() ? 1 : sheet.seen[i / 4]);
            if (!(alpha > 0))
                continue;
            mix(below.data() + i, alpha,
                {sheet.rgba[i] / sheet.rgba[i + 3], sheet.rgba[i + 1] / sheet.rgba[i + 3],
                 sheet.rgba[i + 2] / sheet.rgba[i + 3]},
                sheet.blend);
        }
    }

    /// W3C Compositing and Blending, source over.
    static void mix(float *below, float alpha, const std::array<float, 3> &colour, BlendMode mode)
    {
        const float ground = below[3];
        std::array<float, 3> blended = colour;
        if (mode != BlendMode::Normal && ground > 0) {
            const math::Triple<float> b{below[0] / ground, below[1] / ground, below[2] / ground};
            const auto mixed = math::blendedColour(mode, b, math::Triple<float>{colour[0], colour[1], colour[2]});
            const float channels[3] = {mixed.x, mixed.y, mixed.z};
            for (std::size_t c = 0; c < 3; ++c)
                blended[c] = (1 - ground) * colour[c] + ground * channels[c];
        }
        for (std::size_t c = 0; c < 3; ++c)
            below[c] += alpha * (blended[c] - below[c]);
        below[3] += alpha * (1 - ground);
    }

    /// Finds the opacities of a stroke in these rows: each band adds what it has more than the one around it, by the
    /// share of a pixel that it covers.
    void put(const DrawnStroke &stroke)
    {
        int first = m_view.width, last = 0;
        double before = 0;
        for (const contours::Band &band : stroke.bands) {
            const float step = float(band.opacity - before);
            before = band.opacity;
            addPaths(band.loops);
            if (m_coverage.first() >= m_coverage.last())
                continue;
            first = std::min(first, m_coverage.first()), last = std::max(last, m_coverage.last());
            for (int row = 0; row < m_height; ++row) {
                m_coverage.takeRow(row, m_row);
                float *levels = m_levels.data() + std::size_t(row) * std::size_t(m_view.width);
                for (int x = m_coverage.first(); x < m_coverage.last(); ++x)
                    levels[x] += m_row[std::size_t(x)] * step;
            }
            m_coverage.clear();
        }
        if (first >= last)
            return;
        const auto picture =
            stroke.stroke->picture ? scenePicture(*stroke.stroke, PictureGrid::ofPicture(m_view)) : nullptr;
        for (int row = 0; row < m_height; ++row)
            putRow(stroke, picture.get(), row, first, last);
    }

    void addPaths(const contours::Loops &loops)
    {
        for (const std::vector<Cubic> &loop : loops) {
            Rect box;
            for (const Cubic &curve : loop)
                box = box.united(curve.controlBox());
            if (m_view.toPixels({0, box.bottom}).y < m_top || m_view.toPixels({0, box.top}).y > m_top + m_height)
                continue;
            for (const Cubic &curve : loop)
                m_coverage.add({{m_view.toPixels(curve.p[0]), m_view.toPixels(curve.p[1]), m_view.toPixels(curve.p[2]),
                                 m_view.toPixels(curve.p[3])}});
        }
    }

    void putRow(const DrawnStroke &stroke, const ScenePicture *picture, int row, int first, int last)
    {
        float *levels = m_levels.data() + std::size_t(row) * std::size_t(m_view.width);
        float *below = m_sheets.back().rgba.data() + 4 * std::size_t(row) * std::size_t(m_view.width);
        DrawnColour colour = stroke.paint.at({});
        const BlendMode mode = stroke.multiplies ? BlendMode::Multiply : BlendMode::Normal;
        for (int x = first; x < last; ++x) {
            const float level = levels[x];
            levels[x] = 0;
            if (!(level > 0))
                continue;
            if (picture)
                colour = colourAt(*picture, x, m_top + row);
            else if (stroke.paint.isGradient())
                colour = stroke.paint.at(m_view.toCanvas({x + 0.5, m_top + row + 0.5}));
            mix(below + 4 * std::size_t(x), level * float(colour[3]),
                {float(colour[0]), float(colour[1]), float(colour[2])}, mode);
        }
    }

    const PathDrawing &m_drawing;
    const View &m_view;
    int m_top, m_height;
    PathCoverage m_coverage;
    std::vector<float> m_levels, m_row;
    std::vector<Sheet> m_sheets; ///< the groups that come together around where it is, the canvas first
    std::size_t m_floor = 1;     ///< how many of them are no group's: the canvas, and what masks of all let through
};

} // namespace

FloatPicture pictureOf(const PathDrawing &drawing, const View &view, const std::atomic<bool> *cancel)
{
    FloatPicture picture;
    picture.resize(view.width, view.height);
    const int strips = (view.height + stripRows - 1) / stripRows;
    parallelFor(std::size_t(strips), Threads(), [&](std::size_t k) {
        const int top = int(k) * stripRows;
        Strip(drawing, view, top, std::min(stripRows, view.height - top)).draw(picture, cancel);
    });
    return picture;
}

Result<DrawingDifference> differenceOf(const PathDrawing &drawing, const PaintingPtr &painting, Microseconds T,
                                       Renderer &renderer, const std::atomic<bool> *cancel)
{
    const Rect area = painting->canvas.area();
    const double scale = std::min(1.0, std::sqrt(mostComparedPixels / (area.width() * area.height())));
    const int width = std::max(1, int(std::lround(scale * area.width())));
    RenderRequest request;
    request.painting = withoutDrafts(painting);
    request.time = T;
    request.view = View::ofArea(area, width, std::max(1, heightForWidth(area, width)));
    FloatPicture exact;
    const Result<RenderStats> stats = renderer.render(request, exact, cancel);
    if (!stats)
        return Error{stats.error()};
    if (stats->cancelled)
        return Error{QCoreApplication::translate("Drawing", "interrupted")};
    DrawingDifference difference;
    FloatPicture shown;
    if (!drawing.unpainted)
        shown = pictureOf(drawing, request.view, cancel);
    double sum = 0;
    const std::size_t pixels = std::size_t(exact.width) * std::size_t(exact.height);
    for (std::size_t i = 0; i < 4 * pixels; i += 4)
        for (std::size_t c = 0; c < 3; ++c) {
            // straight colour, over white
            const double e = 1 + double(exact.rgba.data()[i + 3]) * (double(exact.rgba.data()[i + c]) - 1);
            // What is unpainted shows the picture itself, in 8 bits.
            const double drawn = drawing.unpainted ? std::round(255 * e) / 255 : double(shown.rgba.data()[i + c]);
            const double d = std::abs(e - drawn);
            difference.largest = std::max(difference.largest, d);
            sum += d;
        }
    difference.mean = sum / double(3 * pixels);
    return difference;
}

} // namespace suffuse

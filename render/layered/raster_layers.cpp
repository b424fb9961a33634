#include "render/layered/raster_layers.h"

#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"

#include <QCoreApplication>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace suffuse {

namespace {

/// Pictures in whole levels while layers are made.
template <class Level>
class LevelStack {
public:
    static constexpr int most = std::numeric_limits<Level>::max();
    static constexpr double driftUnits = 64; ///< parts of a level
    /// Where a group's layer is further from the picture, in levels, it is baked: 1/255, and 1/8192 in 16 bits.
    static constexpr double farOff = sizeof(Level) == 1 ? 1.5 : 8;

    LevelStack(int width, int height)
        : m_width(width), m_height(height), m_composite(pixels() * 3), m_drift(pixels() * 3), m_exact(pixels() * 3),
          m_layer(pixels() * 4)
    {}

    /// Begins a layer: what is stored from now on is the picture with it.
    void begin(bool bare)
    {
        m_bare = bare;
        std::fill(m_rows.begin(), m_rows.end(), Span());
        m_rows.resize(std::size_t(m_height));
    }

    /// Takes pixels of the picture with a layer of Paint.
    void paint(const PixelRect &rect, const float *rgba, int stride)
    {
        forEach(rect, rgba, stride, [&](std::size_t at, int x, int y, const float *to) {
            Level *exact = &m_exact[at * 3];
            for (int c = 0; c < 3; ++c)
                exact[c] = toLevel(to[c]);
            if (cover(at))
                touch(x, y);
        });
    }
    /// Takes pixels of the picture with a layer of a group, whose own pixels are there.
    void expect(const PixelRect &rect, const float *rgba, int stride)
    {
        forEach(rect, rgba, stride, [&](std::size_t at, int, int, const float *to) {
            for (int c = 0; c < 3; ++c)
                m_exact[at * 3 + std::size_t(c)] = toLevel(to[c]);
        });
    }
    /// Takes a group's own pixels.
    void own(const PixelRect &rect, const float *rgba, int stride)
    {
        forEach(rect, rgba, stride, [&](std::size_t at, int x, int y, const float *from) {
            Level *layer = &m_layer[at * 4];
            layer[3] = toLevel(from[3]);
            if (layer[3] == 0)
                return;
            touch(x, y);
            for (int c = 0; c < 3; ++c)
                layer[c] = toLevel(from[c]);
        });
    }

    /// Puts the group's pixels on the composite as others do. Where a level more or less of the group comes nearer to
    /// the picture, it takes that. Returns false, and leaves the composite alone, if a channel is far off all the
    /// same.
    bool put(BlendMode mode, float opacity)
    {
        LayerPut how{mode, opacity, true, {1, 1, 1}};
        std::vector<Level> before;
        std::vector<std::int8_t> drift;
        bool near = true;
        const PixelRect r = touched();
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x) {
                const std::size_t at = place(x, y);
                if (m_layer[at * 4 + 3] == 0)
                    continue;
                before.insert(before.end(), &m_composite[at * 3], &m_composite[at * 3] + 3);
                drift.insert(drift.end(), &m_drift[at * 3], &m_drift[at * 3] + 3);
                near = near && fit(how, at);
            }
        if (near)
            return true;
        std::size_t i = 0;
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x)
                if (const std::size_t at = place(x, y); m_layer[at * 4 + 3] != 0 && i < before.size())
                    std::copy_n(&before[i], 3, &m_composite[at * 3]), std::copy_n(&drift[i], 3, &m_drift[at * 3]),
                        i += 3;
        return false;
    }
    /// Makes the layer of a group one of Paint.
    void bake()
    {
        const PixelRect r = touched();
        for (int y = r.y; y < r.y + r.height; ++y)
            for (int x = r.x; x < r.x + r.width; ++x)
                cover(place(x, y));
    }

    LevelPixels layer() const
    {
        LevelPixels out{touched(), int(sizeof(Level)) * 8, 4, nullptr, std::size_t(m_width) * 4};
        out.row0 = m_layer.data() + place(out.rect.x, out.rect.y) * 4;
        return out;
    }
    /// Clears the pixels of the layer in hand.
    void end()
    {
        const PixelRect r = touched();
        for (int y = r.y; y < r.y + r.height; ++y)
            std::fill_n(&m_layer[place(r.x, y) * 4], std::size_t(r.width) * 4, Level(0));
    }
    LevelPixels picture() const
    {
        return {{0, 0, m_width, m_height}, int(sizeof(Level)) * 8, 3, m_exact.data(), std::size_t(m_width) * 3};
    }
    double greatestDifference() const
    {
        int greatest = 0;
        for (std::size_t i = 0; i < m_exact.size(); ++i)
            for (const double made : {double(m_composite[i]), smooth(i)})
                greatest = std::max(greatest, std::abs(int(m_exact[i]) - int(std::lround(made))));
        return double(greatest) / most;
    }

private:
    struct Span {
        int from = std::numeric_limits<int>::max(), to = 0;
    };

    std::size_t pixels() const { return std::size_t(m_width) * std::size_t(m_height); }
    std::size_t place(int x, int y) const { return std::size_t(y) * std::size_t(m_width) + std::size_t(x); }
    static Level toLevel(float value) { return Level(std::lround(std::clamp(value, 0.0f, 1.0f) * most)); }

    /// Tiles are stored by several threads, of which each has rows of its own columns: a row's span is theirs together.
    void touch(int x, int y)
    {
        std::atomic_ref<int> from(m_rows[std::size_t(y)].from), to(m_rows[std::size_t(y)].to);
        for (int known = from.load(std::memory_order_relaxed);
             x < known && !from.compare_exchange_weak(known, x, std::memory_order_relaxed);) {
        }
        for (int known = to.load(std::memory_order_relaxed);
             x + 1 > known && !to.compare_exchange_weak(known, x + 1, std::memory_order_relaxed);) {
        }
    }
    PixelRect touched() const
    {
        Span columns, rows;
        for (int y = 0; y < int(m_rows.size()); ++y)
            if (const Span &row = m_rows[std::size_t(y)]; row.to > 0) {
                columns.from = std::min(columns.from, row.from), columns.to = std::max(columns.to, row.to);
                rows.from = std::min(rows.from, y), rows.to = y + 1;
            }
        return rows.to == 0 ? PixelRect{0, 0, 0, 0}
                            : PixelRect{columns.from, rows.from, columns.to - columns.from, rows.to - rows.from};
    }

    template <class Take>
    void forEach(const PixelRect &rect, const float *rgba, int stride, Take take)
    {
        for (int y = 0; y < rect.height; ++y)
            for (int x = 0; x < rect.width; ++x)
                take(place(rect.x + x, rect.y + y), rect.x + x, rect.y + y,
                     rgba + (std::size_t(y) * std::size_t(stride) + std::size_t(x)) * 4);
    }

    /// What programs that round nothing between the layers have in a channel, levels.
    double smooth(std::size_t i) const { return double(m_composite[i]) + double(m_drift[i]) / driftUnits; }
    void setBelow(std::size_t i, double rounded, double smooth)
    {
        m_composite[i] = Level(std::lround(std::clamp(rounded, 0.0, double(most))));
        m_drift[i] =
            std::int8_t(std::lround(std::clamp((smooth - double(m_composite[i])) * driftUnits, -127.0, 127.0)));
    }

    /// Finds what makes the picture's levels of what lies below by source-over, and does that. Programs that round
    /// after each layer get exactly them. What the others have is within the same levels as far as the layer's colour
    /// has room for it, so that their errors do not add up. Returns false if nothing is to be done.
    bool cover(std::size_t at)
    {
        const std::size_t first = at * 3;
        Level *layer = &m_layer[at * 4];
        double a = m_bare ? most : 0, base[3], rough[3], to[3];
        bool differs = m_bare;
        for (std::size_t c = 0; c < 3; ++c) {
            base[c] = m_bare ? 0 : double(m_composite[first + c]), rough[c] = m_bare ? 0 : smooth(first + c);
            to[c] = double(m_exact[first + c]);
            differs = differs || to[c] != base[c];
            const double close = std::clamp(rough[c], to[c] - 0.5, to[c] + 0.5);
            a = std::max({a, leastOpacity(base[c], to[c]), leastOpacity(rough[c], close)});
        }
        if (!differs) {
            std::fill_n(layer, 4, Level(0));
            return false;
        }
        const double alpha = std::clamp(std::ceil(a - 1e-9), 1.0, double(most));
        layer[3] = Level(alpha);
        for (std::size_t c = 0; c < 3; ++c) {
            const double rounded = base[c] + (to[c] - base[c]) * most / alpha, room = 0.49 * most / alpha;
            const double wanted = rough[c] + (to[c] - rough[c]) * most / alpha;
            const double colour = std::clamp(wanted, rounded - room, rounded + room);
            layer[c] = Level(std::lround(std::clamp(colour, 0.0, double(most))));
            const auto over = [&](double below) { return (layer[c] * alpha + below * (most - alpha)) / most; };
            setBelow(first + c, over(base[c]), over(rough[c]));
        }
        return true;
    }

    /// The least opacity, in levels, of a colour that makes one value of another by source-over.
    static double leastOpacity(double from, double to)
    {
        return to > from ? (to - from) / (most - from) * most : to < from ? (from - to) / from * most : 0;
    }

    static void blend(const LayerPut &how, const Level *layer, const double *below, double *out)
    {
        constexpr float scale = 1.0f / float(most);
        const auto unit = [](double level) { return float(std::clamp(level, 0.0, double(most))) * scale; };
        const math::Triple<float> colour{float(layer[0]) * scale, float(layer[1]) * scale, float(layer[2]) * scale};
        const math::RgbPixel<float> ground{{unit(below[0]), unit(below[1]), unit(below[2])}, 1};
        const auto put = math::putStraight(how, float(layer[3]) * scale * how.opacity, colour, ground);
        std::transform(put.rgb, put.rgb + 3, out, [](float value) { return double(value) * most; });
    }

    /// Puts one pixel, and moves the layer's levels a little where that helps. Returns false if it is still far off.
    bool fit(const LayerPut &how, std::size_t at)
    {
        Level *layer = &m_layer[at * 4];
        const std::size_t first = at * 3;
        double below[3], rough[3], put[3], roughPut[3];
        for (std::size_t c = 0; c < 3; ++c)
            below[c] = double(m_composite[first + c]), rough[c] = smooth(first + c);
        const auto blendBoth = [&] { blend(how, layer, below, put), blend(how, layer, rough, roughPut); };
        blendBoth();
        bool near = true;
        for (std::size_t c = 0; c < 3; ++c) {
            const double exact = double(m_exact[first + c]);
            const auto error = [&] { return std::max(std::abs(put[c] - exact), std::abs(roughPut[c] - exact)); };
            const Level start = layer[c];
            Level best = start;
            double least = error();
            for (int step = 1; step <= 3 && least > 0.5; ++step)
                for (int sign : {-1, 1}) {
                    const int moved = int(start) + sign * step;
                    if (moved < 0 || moved > most)
                        continue;
                    layer[c] = Level(moved);
                    blendBoth();
                    if (error() < least)
                        least = error(), best = layer[c];
                }
            layer[c] = best;
            near = near && least < farOff;
        }
        blendBoth();
        for (std::size_t c = 0; c < 3; ++c)
            setBelow(first + c, put[c], roughPut[c]);
        return near;
    }

    int m_width, m_height;
    Pixels<Level> m_composite;   ///< what the layers so far make where each result is rounded, RGB
    Pixels<std::int8_t> m_drift; ///< what they make where none is, less that: in parts of a level
    Pixels<Level> m_exact;       ///< the picture, RGB
    Pixels<Level> m_layer;       ///< the layer in hand, straight RGBA
    bool m_bare = false;         ///< whether it is the lowest one, which is opaque
    std::vector<Span> m_rows;    ///< what of it is covered
};

/// Hands pixels on to a stack.
template <class Level>
class StackTarget : public Target {
public:
    using Take = void (LevelStack<Level>::*)(const PixelRect &, const float *, int);

    StackTarget(LevelStack<Level> &stack, Take take) : m_stack(stack), take(take) {}
    void resize(int, int) override {}
    void store(const PixelRect &rect, const float *rgba, int stride) override { (m_stack.*take)(rect, rgba, stride); }

private:
    LevelStack<Level> &m_stack;

public:
    Take take; ///< what is done with the pixels that come
};

template <class Level>
class Drawing {
public:
    Drawing(const LayeredRequest &request, Renderer &renderer, Renderer &groups, LayerSink &sink)
        : m_request(request), m_renderer(renderer), m_groups(groups), m_sink(sink),
          m_stack(request.view.width, request.view.height), m_picture(m_stack, &LevelStack<Level>::paint),
          m_own(m_stack, &LevelStack<Level>::own)
    {}

    Result<LayeredStats> draw()
    {
        const std::vector<PlannedLayer> plan = planLayers(*m_request.painting);
        bool first = true;
        std::size_t done = 0;
        for (const PlannedLayer &layer : plan) {
            Result<void> taken;
            if (layer.kind == PlannedLayer::Kind::BeginFolder)
                taken = m_sink.beginFolder(layer);
            else if (layer.kind == PlannedLayer::Kind::EndFolder)
                taken = m_sink.endFolder();
            else
                taken = add(layer, std::exchange(first, false));
            if (!taken)
                return Error{taken.error()};
            if (m_request.progress)
                m_request.progress(++done, plan.size());
        }
        if (const Result<void> taken = m_sink.picture(m_stack.picture()); !taken)
            return Error{taken.error()};
        m_stats.greatestDifference = m_stack.greatestDifference();
        return m_stats;
    }

private:
    Result<void> add(const PlannedLayer &planned, bool bare)
    {
        m_stack.begin(bare);
        PlannedLayer layer = planned;
        layer.upTo = layer.alone = nullptr;
        if (m_request.wholeOpacities)
            layer.opacity = std::round(layer.opacity * 255) / 255;
        if (planned.alone)
            if (Result<void> drawn = render(m_groups, planned.alone, m_own); !drawn)
                return drawn;
        if (planned.upTo) {
            m_picture.take = planned.alone ? &LevelStack<Level>::expect : &LevelStack<Level>::paint;
            if (Result<void> drawn = render(m_renderer, planned.upTo, m_picture); !drawn)
                return drawn;
            if (planned.alone && !m_stack.put(layer.blend, layer.opacity)) {
                m_stack.bake();
                layer.blend = BlendMode::Normal, layer.opacity = 1;
                ++m_stats.baked;
            }
        }
        const LevelPixels pixels = m_stack.layer();
        Result<void> taken;
        if (pixels.rect.width > 0)
            taken = m_sink.layer(layer, pixels), ++m_stats.layers;
        m_stack.end();
        return taken;
    }

    Result<void> render(Renderer &renderer, const PaintingPtr &painting, Target &target) const
    {
        const bool transparent = &target == &m_own;
        const Result<RenderStats> stats =
            renderer.render({painting, m_request.time, m_request.view, transparent}, target, m_request.cancel);
        if (!stats)
            return Error{stats.error()};
        if (stats->cancelled)
            return Error{QCoreApplication::translate("LayeredFile", "stopped; nothing was written")};
        return {};
    }

    const LayeredRequest &m_request;
    Renderer &m_renderer, &m_groups;
    LayerSink &m_sink;
    LevelStack<Level> m_stack;
    StackTarget<Level> m_picture, m_own;
    LayeredStats m_stats;
};

} // namespace

Result<LayeredStats> drawLayers(const LayeredRequest &request, Renderer &renderer, Renderer &groups, LayerSink &sink)
{
    if (request.bits == 8)
        return Drawing<std::uint8_t>(request, renderer, groups, sink).draw();
    return Drawing<std::uint16_t>(request, renderer, groups, sink).draw();
}

} // namespace suffuse

#include "render/layered/raster_layers.h"

#include "render/math/scalar.h"
// It has templates over the numbers, which must be declared before.
#include "render/math/blend.h"
#include "render/threads/parallel.h"

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

    /// Once `cancel` is true, what is computed is of no use, and comes soon.
    LevelStack(int width, int height, const std::atomic<bool> *cancel)
        : m_width(width), m_height(height), m_cancel(cancel), m_composite(pixels() * 3), m_drift(pixels() * 3),
          m_exact(pixels() * 3), m_layer(pixels() * 4)
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
            bool changes = m_bare;
            for (int c = 0; c < 3; ++c) {
                const Level before = std::exchange(exact[c], toLevel(to[c]));
                changes = changes || exact[c] != before;
            }
            if (changes && cover(at))
                touch(x, y);
        });
    }
    /// Adds pixels to a layer of Paint where what lies below is a level off, as below a group that was put there.
    void mend()
    {
        parallelFor(std::size_t(m_height), {}, [&](std::size_t row) {
            for (int x = 0; x < m_width && !isCancelled(); ++x) {
                const std::size_t at = place(x, int(row));
                if (m_layer[at * 4 + 3] == 0 && isOff(at) && cover(at))
                    touch(x, int(row));
            }
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
    /// the picture, it takes that. Returns false, and changes nothing, if a channel is far off all the same. So that
    /// nothing need be kept of what it might have to take back, it looks first.
    bool put(BlendMode mode, float opacity)
    {
        const LayerPut how{mode, opacity, true, {1, 1, 1}};
        std::atomic<bool> far = false;
        forRows([&](std::size_t from, std::size_t to) {
            for (std::size_t at = from; at < to && !far.load(std::memory_order_relaxed); ++at)
                if (m_layer[at * 4 + 3] != 0 && !fitted(how, at).near)
                    far = true;
        });
        if (far)
            return false;
        forRows([&](std::size_t from, std::size_t to) {
            for (std::size_t at = from; at < to; ++at) {
                if (m_layer[at * 4 + 3] == 0)
                    continue;
                const Fitted pixel = fitted(how, at);
                std::copy_n(pixel.colour, 3, &m_layer[at * 4]);
                for (std::size_t c = 0; c < 3; ++c)
                    setBelow(at * 3 + c, pixel.put[c], pixel.smooth[c]);
            }
        });
        return true;
    }
    /// Makes the layer of a group one of Paint.
    void bake()
    {
        forRows([&](std::size_t from, std::size_t to) {
            for (std::size_t at = from; at < to; ++at)
                cover(at);
        });
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
        std::vector<int> greatest(std::size_t(m_height), 0);
        parallelFor(greatest.size(), {}, [&](std::size_t y) {
            const std::size_t row = isCancelled() ? 0 : std::size_t(m_width) * 3;
            for (std::size_t i = y * row; i < (y + 1) * row; ++i)
                for (const double made : {double(m_composite[i]), smooth(i)})
                    greatest[y] = std::max(greatest[y], std::abs(int(m_exact[i]) - nearest(made)));
        });
        return double(*std::ranges::max_element(greatest)) / most;
    }

private:
    struct Span {
        int from = std::numeric_limits<int>::max(), to = 0;
    };

    bool isCancelled() const { return m_cancel && m_cancel->load(std::memory_order_relaxed); }
    std::size_t pixels() const { return std::size_t(m_width) * std::size_t(m_height); }
    std::size_t place(int x, int y) const { return std::size_t(y) * std::size_t(m_width) + std::size_t(x); }
    /// The whole number that is nearest to one between 0 and `most`, or a little beside them.
    static int nearest(double value) { return int(value + 1.5) - 1; }
    static Level toLevel(float value) { return Level(nearest(double(std::clamp(value, 0.0f, 1.0f)) * most)); }

    /// Calls use(from, to) for each row of what is touched, with its first pixel and the one behind its last one, on
    /// several threads.
    template <class Use>
    void forRows(Use use)
    {
        const PixelRect r = touched();
        parallelFor(std::size_t(r.height), {}, [&](std::size_t row) {
            const int y = r.y + int(row);
            if (!isCancelled())
                use(place(r.x, y), place(r.x, y) + std::size_t(r.width));
        });
    }

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

    /// Whether a channel of what lies below is not the picture's to the nearest level.
    bool isOff(std::size_t at) const
    {
        for (std::size_t i = at * 3; i < at * 3 + 3; ++i)
            if (m_composite[i] != m_exact[i] || std::abs(smooth(i) - double(m_exact[i])) > 0.5)
                return true;
        return false;
    }

    /// What programs that round nothing between the layers have in a channel, levels.
    double smooth(std::size_t i) const { return double(m_composite[i]) + double(m_drift[i]) / driftUnits; }
    void setBelow(std::size_t i, double rounded, double smooth)
    {
        m_composite[i] = Level(nearest(std::clamp(rounded, 0.0, double(most))));
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
            layer[c] = Level(nearest(std::clamp(colour, 0.0, double(most))));
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

    /// One pixel of a group's layer, and what it makes of what lies below.
    struct Fitted {
        Level colour[3];
        double put[3], smooth[3]; ///< levels: where each result is rounded, and where none is
        bool near = true;         ///< whether no channel is far off
    };
    /// Puts one pixel, with the layer's levels moved a little where that helps.
    Fitted fitted(const LayerPut &how, std::size_t at) const
    {
        Level layer[4];
        std::copy_n(&m_layer[at * 4], 4, layer);
        const std::size_t first = at * 3;
        Fitted out;
        double below[3], rough[3];
        for (std::size_t c = 0; c < 3; ++c)
            below[c] = double(m_composite[first + c]), rough[c] = smooth(first + c);
        const auto blendBoth = [&] { blend(how, layer, below, out.put), blend(how, layer, rough, out.smooth); };
        blendBoth();
        for (std::size_t c = 0; c < 3; ++c) {
            const double exact = double(m_exact[first + c]);
            const auto error = [&] { return std::max(std::abs(out.put[c] - exact), std::abs(out.smooth[c] - exact)); };
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
            out.near = out.near && least < farOff;
        }
        blendBoth();
        std::copy_n(layer, 3, out.colour);
        return out;
    }

    int m_width, m_height;
    const std::atomic<bool> *m_cancel; ///< null: nobody cancels
    Pixels<Level> m_composite;         ///< what the layers so far make where each result is rounded, RGB
    Pixels<std::int8_t> m_drift;       ///< what they make where none is, less that: in parts of a level
    Pixels<Level> m_exact;             ///< the picture, RGB
    Pixels<Level> m_layer;             ///< the layer in hand, straight RGBA
    bool m_bare = false;               ///< whether it is the lowest one, which is opaque
    std::vector<Span> m_rows;          ///< what of it is covered
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
          m_stack(request.view.width, request.view.height, request.cancel),
          m_picture(m_stack, &LevelStack<Level>::paint)
    {}

    Result<LayeredStats> draw()
    {
        const std::vector<PlannedLayer> plan = planLayers(*m_request.painting);
        // To go on from the picture before, a renderer keeps 16 bytes a pixel. In large pictures of few layers it is as
        // quick to draw all below again.
        constexpr qint64 large = qint64(1) << 23;
        constexpr std::size_t few = 32;
        m_goesOn = qint64(m_request.view.width) * m_request.view.height <= large || plan.size() > few;
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
        if (isCancelled())
            return Error{stopped().error()};
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
        if (planned.alone) {
            // A target of its own: the renderer keeps nothing of a group for the next one, which has nothing of it.
            StackTarget<Level> own(m_stack, &LevelStack<Level>::own);
            if (Result<void> drawn = render(m_groups, planned.alone, own, true); !drawn)
                return drawn;
        }
        if (planned.upTo) {
            const auto take = planned.alone ? &LevelStack<Level>::expect : &LevelStack<Level>::paint;
            StackTarget<Level> anew(m_stack, take);
            m_picture.take = take;
            if (Result<void> drawn = render(m_renderer, planned.upTo, m_goesOn ? m_picture : anew, false); !drawn)
                return drawn;
            if (!planned.alone)
                m_stack.mend();
            else if (!m_stack.put(layer.blend, layer.opacity)) {
                m_stack.bake();
                layer.blend = BlendMode::Normal, layer.opacity = 1;
                ++m_stats.baked;
            }
        }
        if (isCancelled())
            return stopped();
        const LevelPixels pixels = m_stack.layer();
        Result<void> taken;
        if (pixels.rect.width > 0)
            taken = m_sink.layer(layer, pixels), ++m_stats.layers;
        m_stack.end();
        return taken;
    }

    Result<void> render(Renderer &renderer, const PaintingPtr &painting, Target &target, bool transparent) const
    {
        const Result<RenderStats> stats =
            renderer.render({painting, m_request.time, m_request.view, transparent}, target, m_request.cancel);
        if (!stats)
            return Error{stats.error()};
        return stats->cancelled ? stopped() : Result<void>();
    }

    bool isCancelled() const { return m_request.cancel && m_request.cancel->load(std::memory_order_relaxed); }
    static Result<void> stopped()
    {
        return Error{QCoreApplication::translate("LayeredFile", "stopped; nothing was written")};
    }

    const LayeredRequest &m_request;
    Renderer &m_renderer, &m_groups;
    LayerSink &m_sink;
    LevelStack<Level> m_stack;
    StackTarget<Level> m_picture;
    bool m_goesOn = true; ///< whether each picture is drawn from the one before
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

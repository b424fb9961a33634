// Strokes in a drag that floats: a picture of them over a picture of the rest.
#pragma once

#include "app/session/frames/lift.h"
#include "render/renderer.h"

#include <memory>
#include <vector>

namespace suffuse {

/// The two pictures of a lift, and frames that are composed of them: what one costs depends on the pixels alone. The
/// lifted strokes lie on top meanwhile. Used by one thread.
class FloatingLayers {
public:
    explicit FloatingLayers(std::unique_ptr<Renderer> renderer) : m_renderer(std::move(renderer)) {}

    /// The picture of the rest, opaque, of the lift's view; not `fine`: parts of it are coarse.
    void setRest(const LiftPtr &lift, Picture8 rest, bool fine);
    bool hasRest(const LiftPtr &lift) const { return m_restOf == lift; }
    bool hasFineRest(const LiftPtr &lift) const { return hasRest(lift) && m_restIsFine; }

    /// Draws the lifted strokes, those beside the view, too, as far as `margin` goes; `factor` pixels of the view to a
    /// side of one that is drawn. False where it was cancelled: then what was drawn before holds.
    Result<bool> draw(const LiftPtr &lift, int factor, const std::atomic<bool> *cancel = nullptr);
    /// Takes the lifted strokes from a picture of them over nothing but `paper`, of the lift's view; not `fine`: there is
    /// more beside the view.
    void take(const LiftPtr &lift, const Picture8 &picture, std::uint32_t paper, bool fine);
    bool isOf(const LiftPtr &lift) const { return m_of == lift && hasRest(lift); }
    /// The lift of which there are both pictures; null: none.
    LiftPtr lift() const { return m_of && hasRest(m_of) ? m_of : nullptr; }
    bool areFine() const { return m_layerIsFine && m_restIsFine; }
    int factor() const { return m_factor; }

    /// Pixels around the view.
    static constexpr int margin = 128;

    /// Puts the frame into `picture`, of the view's size, which shows the last one: what differs from it is written and
    /// listed. `whole`: it shows something else.
    std::vector<PixelRect> compose(const Affine &map, bool whole, Picture8 &picture, int threads);

private:
    /// Where a pixel of the frame lies in the layer.
    struct Placing {
        Point base, right, down;
        Point operator()(double x, double y) const { return base + x * right + y * down; }
    };
    Placing placingUnder(const Affine &map) const;
    bool isWholePixels(const Placing &placing) const;
    void takeOver(const Picture8 &drawn);
    std::vector<char> squaresUnder(const Placing &placing) const;
    bool hasPaint(double left, double top, double right, double bottom) const;
    PixelRect square(std::size_t i) const;
    void restoreRest(const PixelRect &r, Picture8 &picture) const;
    void shiftOver(const PixelRect &r, int dx, int dy, Picture8 &picture) const;
    void mapOver(const PixelRect &r, const Placing &placing, Picture8 &picture) const;

    std::unique_ptr<Renderer> m_renderer;
    Picture8 m_drawn; ///< the renderer's
    LiftPtr m_restOf, m_of;
    Picture8 m_rest;
    bool m_restIsFine = false, m_layerIsFine = false;
    int m_factor = 1;
    int m_width = 0, m_height = 0;      ///< of the layer
    std::vector<std::uint32_t> m_layer; ///< premultiplied
    int m_columns = 0, m_rows = 0;      ///< of its cells
    std::vector<char> m_painted;        ///< cells that have paint
    std::vector<char> m_covered;        ///< squares of the last frame that the layer reached
};

} // namespace suffuse

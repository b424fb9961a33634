// Maps many points of the canvas to pixels of one view.
#pragma once

#include "render/view.h"

namespace suffuse {

/// Does what View::toPixels does, for many points that are given as offsets from one point of the canvas, without
/// computing sines for each.
class PixelMap {
public:
    explicit PixelMap(const View &view, Point origin = {})
        : m_base(view.toPixels(origin)), m_right(turned(view, {1, 0})), m_down(turned(view, {0, 1}))
    {}
    Point operator()(Point offset) const { return m_base + offset.x * m_right + offset.y * m_down; }

private:
    static Point turned(View view, Point vector)
    {
        view.centre = {};
        return view.toPixels(vector) - view.toPixels({});
    }

    Point m_base, m_right, m_down;
};

} // namespace suffuse

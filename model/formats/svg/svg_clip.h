// Where a drawing may paint: clip paths, and nested drawings that show no more than their viewport.
#pragma once

#include "model/area/area_sets.h"
#include "model/formats/svg/svg_style.h"
#include "model/formats/svg/text/svg_text.h"

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace suffuse {

/// An area of the document to which painting is bound.
struct SvgClip {
    Area area;
    std::optional<Rect> rect; ///< the area, if it is an upright rectangle

    /// Whether what lies in a box is not clipped, as far as that is easy to say.
    bool holds(const Rect &box) const
    {
        return rect && rect->left <= box.left && box.right <= rect->right && rect->top <= box.top &&
               box.bottom <= rect->bottom;
    }
};
using SvgClipPtr = std::shared_ptr<const SvgClip>; ///< null: there is no bound

/// Finds what clip paths show.
class SvgClips {
public:
    SvgClips(SvgTree &tree, SvgTexts &texts, AreaEffort &effort) : m_tree(tree), m_texts(texts), m_effort(effort) {}

    /// What of `outer` a rectangle shows under a matrix.
    SvgClipPtr within(const SvgClipPtr &outer, const Rect &port, const SvgMatrix &matrix);
    /// What of `outer` the clip path of an element with the style shows. `boxOf` gives the box of what the element
    /// paints, in its own units. Returns `outer` if the clip path takes too much work.
    SvgClipPtr within(const SvgClipPtr &outer, const SvgElement &clipPath, const SvgStyle &style,
                      const std::function<Rect()> &boxOf);

private:
    std::optional<Area> areaOfPath(const SvgElement &clipPath, const SvgStyle &style,
                                   const std::function<Rect()> &boxOf, int depth);
    std::optional<Area> areaOfChild(const SvgElement &child, const SvgStyle &around, int depth);
    std::vector<PenLine> linesOf(const SvgElement &shape, const SvgStyle &style);
    SvgClipPtr both(const SvgClipPtr &outer, Area area);

    SvgTree &m_tree;
    SvgTexts &m_texts;
    AreaEffort &m_effort;
    /// Clip paths that were found, by matrix: one often clips many elements.
    using Key = std::pair<const SvgElement *, std::array<double, 6>>;
    std::map<Key, Area> m_found;
};

} // namespace suffuse

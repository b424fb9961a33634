// Paints shapes of SVG: their fills and strokes become the paths of a drawing.
#pragma once

#include "model/formats/svg/paths/svg_outlines.h"
#include "model/formats/svg/svg_clip.h"
#include "model/formats/svg/svg_drawing.h"
#include "model/formats/svg/svg_gradient.h"

#include <set>

namespace suffuse {

/// A shape as it stands in the document.
struct SvgShape {
    std::vector<PenLine> lines; ///< in user units
    const SvgStyle &style;
    SvgClipPtr clip;
    QString name;
    int group = -1;
    std::optional<Rect> box{}; ///< by which gradients count, user units; no value: that of the lines
    bool isLetter = false;     ///< of a text, which is taken as one thing
    int lead = -1;             ///< which of the drawing's leads it is
};

class SvgPainter {
public:
    /// Paints into a drawing whose scale is known. `lost` receives the gradients and patterns that cannot be shown.
    SvgPainter(SvgTree &tree, SvgDrawing &out, std::set<const SvgElement *> &lost)
        : m_tree(tree), m_out(out), m_lost(lost)
    {}

    /// Whether there are as many curves as a drawing may have.
    bool isFull() const;
    void paint(const SvgShape &shape);
    /// Gives all paths behind the first ones an opacity as one: those that lie over each other do not shine through
    /// more than they did.
    void fade(std::size_t first, double opacity);

private:
    static constexpr std::uint64_t mostEffort = 600'000'000; ///< about two seconds

    void paintParts(const SvgShape &shape);
    void paintFill(const SvgShape &shape);
    void paintStroke(const SvgShape &shape);
    void noteUnpainted(const SvgPaint &paint);
    bool isWholeSeen(const SvgShape &shape);
    void addArea(const SvgShape &shape, const SvgLoops &loops, bool isEvenOdd, const SvgPaint &paint, double opacity);
    void addShades(const SvgShape &shape, const SvgPath &area, const SvgLoops &loops, const SvgPaint &paint,
                   const std::vector<SvgShade> &shades);
    std::optional<Area> seenOf(const SvgLoops &loops, bool isEvenOdd, const SvgClipPtr &clip);
    std::vector<SvgPath> faded(std::size_t first, double opacity, AreaEffort &effort);
    Area areaOfPath(const SvgPath &path, AreaEffort &effort) const;
    bool countCurves(std::size_t curves);
    double tolerance() const;
    int finestSteps() const;
    /// Calls `work` with a part of the effort that is left, and takes what it spent.
    template <class Work>
    auto withEffort(Work work);

    SvgTree &m_tree;
    SvgDrawing &m_out;
    std::set<const SvgElement *> &m_lost;
    std::size_t m_curves = 0;
    AreaEffort m_effort{mostEffort};
};

} // namespace suffuse

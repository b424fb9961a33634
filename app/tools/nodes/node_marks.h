// The nodes and handles that the Segments tool shows, their places on the screen, and which of them the pointer means.
#pragma once

#include "app/canvas/overlay/overlay.h"
#include "model/shaping/nodes/reshape.h"

#include <map>
#include <optional>
#include <set>

namespace suffuse {

/// A tangent handle of a node.
struct HandleRef {
    NodeRef node;
    bool after = false;
    friend auto operator<=>(const HandleRef &, const HandleRef &) = default;
};

struct NodeMark {
    NodeRef node;
    Point pixel;
    NodeKind kind = NodeKind::Smooth;
    bool selected = false;
};

struct HandleMark {
    HandleRef handle;
    Point pixel;
    Point nodePixel;
};

/// Which nodes of strokes are shown. It is kept while the zoom stays the same, so that a drag leaves the same nodes.
struct ShownNodes {
    double gap = 0; ///< canvas units between the nodes
    /// by stroke, the number of its nodes and those that are shown
    std::map<StrokeId, std::pair<int, std::vector<int>>> ofStrokes;
};

/// The marks for one state of painting, selection and view. A stroke shows as many nodes as the view needs
/// (`coarseNodes`), and those that are selected; of a run of selected nodes these are its ends. Where very many nodes
/// are in view, each place shows one. The handles shown are those of the selected nodes and of their neighbours, unless
/// these are very many. All pixels are device pixels.
class NodeMarks {
public:
    /// Logical pixels around the pointer in which a mark is hit.
    static constexpr double reach = 8;
    /// The same where something else lies around a mark, of which it leaves a ring.
    static constexpr double narrowReach = 5;

    /// Takes over which nodes were shown before, as far as that still holds, and adds to it. `shown` must outlive the
    /// marks.
    NodeMarks(const Painting &painting, const std::set<StrokeId> &strokes, const std::set<NodeRef> &selected,
              const View &view, double dpr, ShownNodes &shown);

    /// How far apart nodes are shown along a stroke, in canvas units.
    static double gap(const View &view, double dpr);

    const View &view() const { return m_view; }
    /// Takes over strokes as they are now while they are dragged. Only the marks of these strokes decide which of their
    /// nodes crowd.
    void follow(const Painting &painting, const std::vector<StrokeId> &strokes, const std::set<NodeRef> &selected);
    /// The nearest node or handle within reach, if there is one.
    struct Hit {
        std::optional<NodeRef> node;
        std::optional<HandleRef> handle;
        bool isEmpty() const { return !node && !handle; }
        friend bool operator==(const Hit &, const Hit &) = default;
    };
    /// What the pointer hits at a pixel.
    Hit hit(Point pixel, double within = reach) const;
    /// Paints the marks; `hovered` stands out among them.
    void paint(QPainter &painter, const OverlayColours &colours, const Hit &hovered) const;

private:
    void add(const Stroke &stroke, const std::set<NodeRef> &selected);
    void addNodes(const Stroke &stroke, const std::set<NodeRef> &selected);
    std::vector<int> shownNodes(const Stroke &stroke, const std::set<NodeRef> &selected);
    void addHandles(const Stroke &stroke, const std::set<NodeRef> &selected);
    void thinOut();
    Rect window() const;

    View m_view;
    double m_dpr;
    ShownNodes &m_shown;
    std::vector<NodeMark> m_nodes;
    std::vector<HandleMark> m_handles;
};

} // namespace suffuse

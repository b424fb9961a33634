#pragma once

#include "app/tools/nodes/deleted_parts.h"
#include "app/tools/nodes/gradient_handles.h"
#include "app/tools/nodes/node_commands.h"
#include "app/tools/nodes/node_drag.h"
#include "app/tools/nodes/nodes_in_reach.h"
#include "app/tools/nodes/width_handle.h"
#include "app/tools/selection_tool.h"

#include <QPointer>

namespace suffuse {

class Commands;
struct Change;

/// Selects and drags segments, nodes and handles of strokes. The document knows the selected segments and the tool the
/// selected nodes; never are both selected at once.
class NodeTool : public SelectionTool {
    Q_OBJECT

public:
    /// Adds the rows of the commands that work on nodes.
    NodeTool(CanvasWidget &canvas, Commands &commands, QObject *parent = nullptr);

    QString hint() const override;
    QCursor cursor() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool isBusy() const override { return m_width.isBusy() || m_gradient.isBusy() || SelectionTool::isBusy(); }
    bool showsErasures() const override { return true; }
    void cancel() override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    /// Changes the reach within which a stroke follows a drag.
    bool wheel(double notches) override { return m_drag.stepReach(notches); }
    void stepSize(int steps) override;
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    /// Deletes the selected nodes and bridges the gaps between their neighbours, or deletes the selected segments.
    /// Where the knob of a gradient was clicked last, it only says how a gradient goes, and where nothing was selected
    /// since parts were deleted, that nothing is.
    bool deleteSelected() override;
    /// Selects all nodes of the selected strokes.
    bool selectAll() override { return m_commands.selectAll(); }
    Rect chosenBox() const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;
    std::optional<double> paintMargin() const override;

    const std::set<NodeRef> &nodes() const { return m_nodes; }
    /// Selects nodes of selected strokes, and deselects the segments.
    void selectNodes(std::set<NodeRef> nodes);

protected:
    void pressed(const PointerEvent &event) override;
    void clicked(const PointerEvent &event) override;
    void banded(const Rect &band, const PointerEvent &event) override;
    bool beginDrag(const PointerEvent &event) override;
    void drag(const PointerEvent &event) override;
    void endDrag(bool cancelled) override;

private:
    void followDocument(const Change &change);
    void followDeleted(const Change &change);
    void rememberDeleted(const std::set<NodeRef> &nodes, const Painting &before);
    bool isOfDrag(const Change &change) const;
    bool isInUse() const;
    void followView();
    /// What lies under the pointer, besides paint.
    struct Hovered {
        NodeMarks::Hit mark;
        bool curve = false;
        bool erasure = false; ///< The curve takes paint away.
        bool width = false;
        bool gradient = false;
        friend bool operator==(const Hovered &, const Hovered &) = default;
    };
    void setHovered(const Hovered &hovered);
    NodeHit hitAt(const PointerEvent &event) const;
    void clickedSegment(const PointerEvent &event);
    void addStroke(const SegmentRef &hit);
    bool dragErasure(const PointerEvent &press);
    QString erasureHint() const;
    void insertNode(const NodeHit &at);
    void selectNext(int step);
    bool nudge(QKeyEvent *event);

    QPointer<QWidget> m_options;
    std::set<NodeRef> m_nodes;
    NodeCommands m_commands;
    NodesInReach m_inReach;
    Hovered m_hovered;

    SoftReach m_reach;
    NodeDrag m_drag;
    NodeHit m_hit;           ///< what the press hit
    bool m_inserted = false; ///< whether this press has inserted a node
    WidthHandle m_width;
    GradientHandles m_gradient;
    std::optional<DeletedParts> m_deleted; ///< until something else is selected
    ValueEntry m_nodeNudges;
    std::set<NodeRef> m_nudged; ///< what the arrow keys moved last
};

} // namespace suffuse

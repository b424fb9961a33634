// What menu and the tool's row do to nodes and segments.
#pragma once

#include "model/painting/segment.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <QObject>

#include <set>

class QWidget;

namespace suffuse {

class CanvasWidget;
class Commands;
class Editor;
class Tool;

/// The commands of the node tool, which are enabled as the selected nodes and segments allow.
class NodeCommands : public QObject {
    Q_OBJECT

public:
    /// Adds the rows. `nodes`: the tool's, that are selected; the tool calls `update` when they change.
    NodeCommands(const CanvasWidget &canvas, Editor &editor, Commands &table, const Tool &tool,
                 const std::set<NodeRef> &nodes);

    void update();
    /// A button for each; whoever calls it owns it.
    QWidget *makeRow();
    /// False if none is selected. Their neighbours are bridged.
    bool deleteNodes();
    /// All nodes of the selected strokes; false if there are none.
    bool selectAll();
    /// The next node of the selected strokes, or the one before: by 1 or -1.
    void selectNext(int step);

signals:
    /// Nodes are to be selected, and no others.
    void chosen(const std::set<suffuse::NodeRef> &nodes);

private:
    void setKind(NodeKind kind);
    void insertBetween();
    void breakAtNodes();
    void join();
    void reverse();
    void deleteSegments();
    void bridge();
    /// The selected segments, or else those between selected nodes.
    std::set<SegmentRef> chosenSegments() const;

    const CanvasWidget &m_canvas;
    Editor &m_editor;
    Commands &m_table;
    const Tool &m_tool;
    const std::set<NodeRef> &m_nodes;
};

} // namespace suffuse

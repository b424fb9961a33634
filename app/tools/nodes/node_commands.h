// The commands that the menu and the tool's row have for nodes and segments.
#pragma once

#include "model/painting/painting.h"
#include "model/painting/segment.h"
#include "model/painting/selection.h"
#include "model/painting/stroke_places.h"

#include <QObject>

#include <optional>
#include <set>

class QHBoxLayout;

namespace suffuse {

class CanvasWidget;
class Commands;
class Editor;
class Tool;

/// The commands of the node tool, which are enabled as the selected nodes and segments allow.
class NodeCommands : public QObject {
    Q_OBJECT

public:
    /// Adds the rows to the table. `nodes` are the tool's selected nodes; the tool calls `update` when they change.
    NodeCommands(const CanvasWidget &canvas, Editor &editor, Commands &table, const Tool &tool,
                 const std::set<NodeRef> &nodes);

    /// Enables the commands that the selected nodes and segments allow.
    void update();
    /// Adds a button for each command to the row of the tool.
    void addButtons(QHBoxLayout &row);
    /// Deletes the selected nodes and bridges the gaps between their neighbours. Returns false if no node is selected.
    bool deleteNodes();
    /// Says something in the status bar.
    void say(const QString &text);
    /// Selects all nodes of the selected strokes. Returns false if no stroke is selected.
    bool selectAll();
    /// Selects the next (1) or the previous (-1) node instead, of those of the selected strokes that the view shows.
    void selectNext(int step);

signals:
    /// Emitted when exactly these nodes are to be selected.
    void chosen(const std::set<suffuse::NodeRef> &nodes);
    /// Emitted when nodes or, without any, segments were deleted from what the painting was before.
    void deleted(const std::set<suffuse::NodeRef> &nodes, const suffuse::Painting &before);

private:
    void askBeforeCopying();
    void setKind(NodeKind kind);
    void insertBetween();
    void breakAtNodes();
    std::optional<std::pair<NodeRef, NodeRef>> endsToJoin() const;
    void join();
    void reverse();
    void deleteSegments();
    void bridge();
    /// The selected segments or, where none is, the segments between selected nodes.
    std::set<SegmentRef> chosenSegments() const;

    const CanvasWidget &m_canvas;
    Editor &m_editor;
    Commands &m_table;
    const Tool &m_tool;
    const std::set<NodeRef> &m_nodes;
};

} // namespace suffuse

#include "app/tools/nodes/node_commands.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/files/clipboard.h"
#include "app/tools/nodes/node_tool.h"
#include "model/painting/editable.h"
#include "model/shaping/nodes/coarse_nodes.h"
#include "undo/node_edits.h"

#include <QHBoxLayout>
#include <QToolButton>

#include <algorithm>

namespace suffuse {

namespace {

/// The commands in the order of the tool's row; an entry without a command is a line between groups.
constexpr std::optional<Command> rowOfCommands[] = {Command::InsertNodes,
                                                    {},
                                                    Command::NodeCorner,
                                                    Command::NodeSmooth,
                                                    Command::NodeSymmetric,
                                                    {},
                                                    Command::BreakNodes,
                                                    Command::JoinNodes,
                                                    {},
                                                    Command::DeleteSegments,
                                                    Command::BridgeSegments,
                                                    {},
                                                    Command::ReverseStrokes};

bool isEnd(const Painting &painting, const NodeRef &node)
{
    const StrokePtr stroke = painting.find(node.stroke);
    return stroke && node.node < nodeCount(*stroke) && !isInnerNode(*stroke, node.node);
}

/// Empty, or what is to be said of the fills of two strokes that become one: the lower one's goes where it is another.
QString lostFillOf(const Painting &painting, StrokeId a, StrokeId b)
{
    StrokePtr upper = painting.find(a), lower = painting.find(b);
    if (!upper || !lower || upper == lower)
        return {};
    if (painting.indexOf(a) < painting.indexOf(b))
        std::swap(upper, lower);
    if (!lower->fill)
        return {};
    if (!upper->fill)
        return NodeCommands::tr(
            "The joined stroke has no fill, as the upper one had none. Undo brings the lower one's back.");
    Fill kept = *upper->fill, other = *lower->fill;
    other.born = kept.born;
    const bool alike = kept == other && upper->style == lower->style;
    return alike ? QString()
                 : NodeCommands::tr("The joined stroke has the upper one's fill. Undo brings the other back.");
}

} // namespace

NodeCommands::NodeCommands(const CanvasWidget &canvas, Editor &editor, Commands &table, const Tool &tool,
                           const std::set<NodeRef> &nodes)
    : m_canvas(canvas), m_editor(editor), m_table(table), m_tool(tool), m_nodes(nodes)
{
    using enum Command;
    const auto add = [this](Command command, const char *id, const QString &text, const char *icon,
                            const QKeySequence &key, const QString &tip, CommandRow::Condition condition,
                            std::function<void()> perform) {
        m_table.add(command, QString::fromLatin1(id), text, icon, {key}, tip)
            .in(CommandScope::Nodes)
            .when(std::move(condition))
            .runs([this, perform = std::move(perform)] {
                if (!m_tool.isBusy())
                    perform();
            });
    };
    const auto anyNodes = [this, whyNot = Commands::tr("Select nodes with Segments first.")] {
        return Usability(!m_nodes.empty(), whyNot);
    };
    const auto anySegments = [this, whyNot = Commands::tr("Select segments, or the nodes at their ends, with Segments first.")] {
        return Usability(!chosenSegments().empty(), whyNot);
    };
    const auto strokesInHand = [this, whyNot = Commands::tr("Select two end nodes with Segments first.")] {
        return Usability(m_canvas.tool() == &m_tool && !m_editor.selection().isEmpty(), whyNot);
    };
    const auto anyStrokes = anySelected(m_editor);
    add(InsertNodes, "insertNodes", Commands::tr("&Insert Nodes"), "node-insert", Qt::Key_Insert,
        Commands::tr("Insert a node into each selected segment"), anySegments, [this] { insertBetween(); });
    add(NodeCorner, "nodeCorner", Commands::tr("&Corner"), "node-corner", Commands::tr("Shift+C"),
        Commands::tr("Make the selected nodes corners"), anyNodes, [this] { setKind(NodeKind::Corner); });
    add(NodeSmooth, "nodeSmooth", Commands::tr("&Smooth"), "node-smooth", Commands::tr("Shift+S"),
        Commands::tr("Make the selected nodes smooth"), anyNodes, [this] { setKind(NodeKind::Smooth); });
    add(NodeSymmetric, "nodeSymmetric", Commands::tr("S&ymmetric"), "node-symmetric", Commands::tr("Shift+Y"),
        Commands::tr("Make the selected nodes symmetric"), anyNodes, [this] { setKind(NodeKind::Symmetric); });
    add(BreakNodes, "breakNodes", Commands::tr("&Break Strokes"), "node-break", Commands::tr("Shift+B"),
        Commands::tr("Break strokes at the selected nodes"), anyNodes, [this] { breakAtNodes(); });
    add(JoinNodes, "joinNodes", Commands::tr("&Join Nodes"), "node-join", Commands::tr("Shift+J"),
        Commands::tr("Join two selected end nodes"), strokesInHand, [this] { join(); });
    add(DeleteSegments, "deleteSegments", Commands::tr("&Delete Segments"), "segment-delete", Commands::tr("Ctrl+Del"),
        Commands::tr("Delete the selected segments, which leaves gaps in strokes"), anySegments,
        [this] { deleteSegments(); });
    add(BridgeSegments, "bridgeSegments", Commands::tr("Brid&ge Segments"), "bridge", Commands::tr("Alt+Del"),
        Commands::tr("Replace selected segments by one that goes on smoothly"), anySegments, [this] { bridge(); });
    add(ReverseStrokes, "reverseStrokes", Commands::tr("&Reverse"), "reverse", Commands::tr("Shift+R"),
        Commands::tr("Let the selected strokes run from end to start"), anyStrokes, [this] { reverse(); });
    askBeforeCopying();
}

/// Where nodes are selected, they are meant and not their whole strokes, as in Inkscape: what is cut, copied or doubled
/// are the segments between them. A node alone has no paint.
void NodeCommands::askBeforeCopying()
{
    for (const Command command : {Command::Cut, Command::Copy, Command::Duplicate})
        m_table.ask(command, [this, command] {
            if (m_nodes.empty() || m_tool.isBusy())
                return false;
            constexpr int shownMs = 8000;
            Selection between{{}, chosenSegments()};
            for (const SegmentRef &segment : between.segments)
                between.strokes.insert(segment.stroke);
            if (between.isEmpty()) {
                emit m_table.said(tr("A node alone has no paint: select the nodes at both ends of a segment, or take "
                                     "the whole stroke with the Select tool."),
                                  shownMs);
                return true;
            }
            if (command == Command::Copy) { // The nodes stay selected.
                if (const QString leftOut = clipboard::copy(m_editor, between); !leftOut.isEmpty())
                    emit m_table.said(leftOut, shownMs);
                return true;
            }
            m_editor.document().setSelection(std::move(between));
            return false;
        });
}

void NodeCommands::update()
{
    for (const std::optional<Command> &command : rowOfCommands)
        if (command)
            m_table.update(*command);
}

void NodeCommands::addButtons(QHBoxLayout &row)
{
    QWidget *widget = row.parentWidget();
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    for (const std::optional<Command> &command : rowOfCommands) {
        if (!command) {
            buttons->addSpacing(10);
            continue;
        }
        auto *button = new QToolButton(widget);
        button->setDefaultAction(&m_table[*command]);
        button->setIconSize(QSize(20, 20));
        button->setAutoRaise(true);
        buttons->addWidget(button);
    }
    row.addLayout(buttons);
}

std::set<SegmentRef> NodeCommands::chosenSegments() const
{
    std::set<SegmentRef> chosen = m_editor.document().selection().segments;
    for (const NodeRef &node : m_nodes) {
        const StrokePtr stroke = m_editor.document().painting()->find(node.stroke);
        if (stroke && node.node < int(stroke->segments.size()) &&
            m_nodes.contains({node.stroke, endNode(*stroke, node.node)}))
            chosen.insert({node.stroke, node.node});
    }
    return chosen;
}

void NodeCommands::setKind(NodeKind kind)
{
    const QString names[] = {tr("Smooth nodes"), tr("Symmetric nodes"), tr("Corner nodes")};
    m_editor.push(setNodeKind(m_editor.document(), m_nodes, kind), names[int(kind)]);
}

void NodeCommands::insertBetween()
{
    PlacesOfStrokes places;
    for (const SegmentRef &segment : chosenSegments())
        places[segment.stroke].push_back({segment.segment, 0.5});
    // Both the nodes that were selected and the new ones between them are selected afterwards.
    std::set<NodeRef> nodes;
    for (const auto &[id, inStroke] : places) {
        const StrokePtr stroke = m_editor.document().painting()->find(id);
        std::vector<int> sources;
        if (!stroke)
            continue;
        const Stroke split = withNodes(*stroke, inStroke, &sources);
        for (int k = 0; k < nodeCount(split); ++k) {
            const bool isNew = k > 0 && k < int(sources.size()) && sources[k] == sources[k - 1];
            const int old =
                k < int(sources.size()) ? sources[k] : k - int(sources.size()) + int(stroke->segments.size());
            if (isNew || m_nodes.contains({id, old}))
                nodes.insert({id, k});
        }
    }
    m_editor.push(insertNodes(m_editor.document(), places), tr("Insert nodes"));
    emit chosen(nodes);
}

void NodeCommands::breakAtNodes()
{
    const Edit edit = splitAtNodes(m_editor.document(), m_nodes, Leaves::Chains);
    if (edit.isEmpty()) {
        if (std::ranges::any_of(m_nodes, [this](const NodeRef &node) {
                const StrokePtr stroke = m_editor.document().painting()->find(node.stroke);
                return stroke && nodesTogether(*stroke, node.node).size() == 2;
            }))
            say(tr("The closed outline begins and ends at this node, so it has nothing more to break. "
                   "Delete Segments (Ctrl+Del) opens it."));
        return;
    }
    // Of the two ends that a node becomes, the upper one keeps its number: what follows pulls it off the other one.
    std::set<NodeRef> ends;
    for (const NodeRef &node : m_nodes)
        if (const StrokePtr stroke = m_editor.document().painting()->find(node.stroke);
            stroke && isInnerNode(*stroke, node.node))
            ends.insert(node);
    m_editor.push(edit, tr("Break stroke"));
    emit chosen(ends);
}

/// The two selected ends to be joined: of many, those that lie nearest to each other, of different chains where there
/// are such. Empty where fewer than two ends are selected.
std::optional<std::pair<NodeRef, NodeRef>> NodeCommands::endsToJoin() const
{
    struct End {
        NodeRef node;
        Point place;
        int chain;
    };
    const Painting &painting = *m_editor.document().painting();
    std::vector<End> ends;
    for (const NodeRef &node : m_nodes)
        if (isEnd(painting, node)) {
            const StrokePtr stroke = painting.find(node.stroke);
            const NodeSides sides = sidesOf(*stroke, node.node);
            const Chain chain = chainAt(*stroke, std::max(sides.before, sides.after));
            if (!isClosed(*stroke, chain))
                ends.push_back({node, nodePosition(*stroke, node.node), chain.first});
        }
    std::optional<std::pair<NodeRef, NodeRef>> nearest;
    std::pair<bool, double> least;
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const End &a = ends[i], &b = ends[j];
            const std::pair apart(a.node.stroke == b.node.stroke && a.chain == b.chain, length(a.place - b.place));
            if (!nearest || apart < least) {
                nearest = {a.node, b.node};
                least = apart;
            }
        }
    return nearest;
}

void NodeCommands::join()
{
    const auto ends = endsToJoin();
    if (!ends) {
        say(tr("Join needs two ends of strokes: select one, and Shift+click the other or drag around both."));
        return;
    }
    const auto [a, b] = *ends;
    const Edit edit = suffuse::joinNodes(m_editor.document(), a, b);
    if (edit.isEmpty()) {
        say(tr("These two ends cannot be joined."));
        return;
    }
    const QString lost = lostFillOf(*m_editor.document().painting(), a.stroke, b.stroke);
    emit chosen({});
    m_editor.push(edit, tr("Join nodes"));
    if (!lost.isEmpty())
        emit m_table.said(lost, 8000);
}

void NodeCommands::reverse()
{
    std::set<NodeRef> nodes;
    for (const NodeRef &node : m_nodes)
        if (const StrokePtr stroke = m_editor.document().painting()->find(node.stroke)) {
            const NodeSides sides = sidesOf(*stroke, node.node);
            const int last = int(stroke->segments.size()) - 1;
            nodes.insert({node.stroke, sides.before >= 0 ? last - sides.before
                                                         : endNode(suffuse::reversed(*stroke), last - sides.after)});
        }
    m_editor.push(reverseSelection(m_editor.document()), tr("Reverse strokes"));
    if (!m_nodes.empty())
        emit chosen(nodes);
}

void NodeCommands::say(const QString &text)
{
    constexpr int shownMs = 8000;
    emit m_table.said(text, shownMs);
}

bool NodeCommands::deleteNodes()
{
    if (m_nodes.empty())
        return false;
    const double gap = NodeMarks::gap(m_canvas.view(), m_canvas.devicePixelRatioF());
    const Edit edit = suffuse::deleteNodes(m_editor.document(), m_nodes, gap);
    const std::set<NodeRef> nodes = m_nodes;
    const PaintingPtr before = m_editor.document().painting();
    emit chosen({});
    m_editor.push(edit, tr("Delete nodes"));
    emit deleted(nodes, *before);
    return true;
}

void NodeCommands::deleteSegments()
{
    const std::set<SegmentRef> segments = chosenSegments();
    std::set<StrokeId> strokes; // Strokes that take no part stay selected.
    for (const SegmentRef &segment : segments)
        strokes.insert(segment.stroke);
    const PaintingPtr before = m_editor.document().painting();
    m_editor.document().setSelection({strokes, segments});
    m_editor.push(deleteSelection(m_editor.document(), Leaves::Chains), tr("Delete segments"));
    emit deleted({}, *before);
}

void NodeCommands::bridge()
{
    const Edit edit = bridgeSegments(m_editor.document(), chosenSegments());
    emit chosen({});
    m_editor.push(edit, tr("Bridge segments"));
}

bool NodeCommands::selectAll()
{
    std::set<NodeRef> nodes;
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (m_canvas.selection().strokes.contains(stroke->id) && isEditable(*stroke))
            for (int k = 0; k < nodeCount(*stroke); ++k)
                nodes.insert(nodes.end(), NodeRef{stroke->id, k});
    if (nodes.empty())
        return false;
    emit chosen(nodes);
    return true;
}

void NodeCommands::selectNext(int step)
{
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    std::vector<const Stroke *> strokes;
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (m_canvas.selection().strokes.contains(stroke->id) && isEditable(*stroke))
            strokes.push_back(stroke.get());
    if (strokes.empty())
        return;
    const std::set<SegmentRef> &segments = m_editor.document().selection().segments;
    if (m_nodes.empty() && !segments.empty()) { // From a segment it goes on to its end, or back to its start.
        const SegmentRef from = step > 0 ? *segments.rbegin() : *segments.begin();
        if (const StrokePtr stroke = painting.find(from.stroke); stroke && from.segment < int(stroke->segments.size()))
            emit chosen({{from.stroke, step > 0 ? endNode(*stroke, from.segment) : from.segment}});
        return;
    }
    const StrokePtr chosenStroke =
        m_nodes.empty() ? nullptr : m_editor.document().painting()->find(m_nodes.begin()->stroke);
    const bool isSeam =
        chosenStroke && m_nodes.size() == 2 && nodesTogether(*chosenStroke, m_nodes.begin()->node).size() == 2;
    const NodeRef from = m_nodes.empty() ? NodeRef{} : (step > 0) != isSeam ? *m_nodes.rbegin() : *m_nodes.begin();
    std::size_t at = 0;
    while (at < strokes.size() && strokes[at]->id != from.stroke)
        ++at;
    if (at == strokes.size()) {
        const Stroke &first = step > 0 ? *strokes.front() : *strokes.back();
        emit chosen({{first.id, step > 0 ? 0 : nodeCount(first) - 1}});
        return;
    }
    const double gap = NodeMarks::gap(m_canvas.view(), m_canvas.devicePixelRatioF());
    std::vector<int> shown = coarseNodes(*strokes[at], gap);
    std::erase_if(shown, [&](int node) { // A seam is passed once: at the beginning of the way.
        const std::vector<int> both = nodesTogether(*strokes[at], node);
        return both.size() == 2 && node == (step > 0 ? both.back() : both.front());
    });
    const auto next = step > 0 ? std::upper_bound(shown.begin(), shown.end(), from.node)
                               : std::lower_bound(shown.begin(), shown.end(), from.node);
    if (next == (step > 0 ? shown.end() : shown.begin())) {
        at = (at + strokes.size() + std::size_t(step)) % strokes.size();
        emit chosen({{strokes[at]->id, step > 0 ? 0 : nodeCount(*strokes[at]) - 1}});
        return;
    }
    const int node = step > 0 ? *next : *std::prev(next);
    emit chosen({{strokes[at]->id, node}});
}

} // namespace suffuse

#include "app/window/layout/tool_rack.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/commands/session_rows.h"
#include "app/tools/assistants/assistant_tool.h"
#include "app/tools/brush/attribute_brush_tool.h"
#include "app/tools/brush/brush_tool.h"
#include "app/tools/brush/eyedropper_tool.h"
#include "app/tools/nodes/node_tool.h"
#include "app/tools/pan_tool.h"
#include "app/tools/select/select_tool.h"
#include "app/tools/shapes/bucket_tool.h"
#include "app/tools/shapes/lasso_fill_tool.h"
#include "app/tools/shapes/pen_tool.h"
#include "app/tools/shapes/shape_tool.h"
#include "app/tools/shaping/eraser_tool.h"
#include "app/tools/shaping/knife_tool.h"
#include "app/tools/shaping/push_tool.h"
#include "app/tools/shaping/redraw_tool.h"
#include "app/tools/text/text_tool.h"
#include "app/tools/tool_options.h"

namespace suffuse {

ToolRack::ToolRack(const Workplace &place, ToolOptionsBar &options, QObject *parent)
    : QObject(parent), m_place(place), m_options(options)
{
    addTools();
    connect(&place.canvas, &CanvasWidget::penTurned, this, &ToolRack::turnPen);
    connect(&place.canvas, &CanvasWidget::busyChanged, this, [this] {
        if (m_next)
            use(m_next);
    });
    place.commands[Command::Brush].setChecked(true);
}

void ToolRack::addTools()
{
    using enum Command;
    CanvasWidget &canvas = m_place.canvas;
    add(Brush, "brush", Commands::tr("&Brush"), "brush", Qt::Key_B, Commands::tr("Paint strokes"),
        new BrushTool(canvas, &canvas));
    auto *select = new SelectTool(canvas, m_place.commands, &canvas);
    add(Select, "select", Commands::tr("&Select"), "select", Qt::Key_V, Commands::tr("Select and move strokes"),
        select);
    add(Segments, "segments", Commands::tr("Se&gments"), "segments", Qt::Key_N,
        Commands::tr("Edit segments, nodes and handles of strokes"), new NodeTool(canvas, m_place.commands, &canvas));
    add(Shapes, "shapes", Commands::tr("Geome&tric Shapes"), "shapes", Qt::Key_S,
        Commands::tr("Paint rectangles, ellipses, polygons and stars"), new ShapeTool(canvas, &canvas));
    add(OutlinePen, "outlinePen", Commands::tr("Outline Pe&n"), "outline-pen", Qt::Key_C,
        Commands::tr("Draw an outline node by node, filled or not"), new PenTool(canvas, &canvas));
    add(LassoFill, "lassoFill", Commands::tr("Lasso F&ill"), "lasso-fill", Qt::Key_G,
        Commands::tr("Fill what is drawn around"), new LassoFillTool(canvas, &canvas));
    add(Bucket, "bucket", Commands::tr("Bu&cket"), "bucket", Qt::Key_F,
        Commands::tr("Fill what the paint around a place bounds"), new BucketTool(canvas, &canvas));
    m_text = new TextTool(canvas, &canvas);
    add(Text, "text", Commands::tr("Te&xt"), "text", Qt::Key_T, Commands::tr("Type texts, whose letters are strokes"),
        m_text);
    for (const auto &[command, key] : {std::pair(Cut, Qt::Key_X), std::pair(Copy, Qt::Key_C)})
        m_place.commands.ask(command, [this, key = key] { return m_text->takesKey(key, Qt::ControlModifier); });
    connect(select, &Tool::textAsked, this, [this](const PointerEvent &event, GroupId text) {
        m_place.commands[Text].setChecked(true);
        m_text->edit(text, event.point);
    });
    add(Redraw, "redraw", Commands::tr("Redra&w"), "redraw", Qt::Key_W,
        Commands::tr("Draw over a part of a stroke, which follows the new line"), new RedrawTool(canvas, &canvas));
    add(Push, "push", Commands::tr("&Push"), "push", Qt::Key_U, Commands::tr("Push, comb, pinch or roughen strokes"),
        new PushTool(canvas, &canvas));
    add(Knife, "knife", Commands::tr("&Knife"), "knife", Qt::Key_K, Commands::tr("Cut strokes along a line"),
        new KnifeTool(canvas, &canvas));
    add(Eraser, "eraser", Commands::tr("&Eraser"), "eraser", Qt::Key_E,
        Commands::tr("Take paint away softly, or cut out parts of strokes"), new EraserTool(canvas, &canvas));
    add(AttributeBrush, "attributeBrush", Commands::tr("&Attribute Brush"), "attribute-brush", Qt::Key_A,
        Commands::tr("Paint values onto segments"), new AttributeBrushTool(canvas, &canvas));
    auto *eyedropper = new EyedropperTool(canvas, &canvas);
    add(Eyedropper, "eyedropper", Commands::tr("Eye&dropper"), "eyedropper", Qt::Key_I, Commands::tr("Pick a colour"),
        eyedropper);
    m_place.commands
        .add(MatchAppearance, "matchAppearance", Commands::tr("Match &by Eyedropper"), "eyedropper", {},
             Commands::tr("Click a stroke: the selected ones get its style, mixing, values and colour"))
        .when(anySelected(m_place.open.editor))
        .runs([this, eyedropper] { eyedropper->beginMatching(m_place.commands); });
    add(Assistants, "assistants", Commands::tr("Assistants"), "assistants", Qt::Key_Y,
        Commands::tr("Lines, vanishing points and ellipses that lead strokes"),
        new AssistantTool(canvas, m_place.commands, &canvas));
    add(Pan, "pan", Commands::tr("&Hand"), "pan", Qt::Key_H, Commands::tr("Move the canvas"),
        new PanTool(canvas, &canvas));
    m_place.commands.makeExclusive({Brush, Select, Segments, Shapes, OutlinePen, LassoFill, Bucket, Text, Redraw, Push,
                                    Knife, Eraser, AttributeBrush, Eyedropper, Assistants, Pan});
}

void ToolRack::add(Command command, const QString &id, const QString &text, const char *icon, Qt::Key key,
                   const QString &tip, Tool *tool)
{
    m_place.commands.add(command, id, text, icon, {QKeySequence(key)}, tip).toggles([this, tool](bool on) {
        if (on)
            use(tool);
    });
    m_options.setWidget(tool->options()); // the row is as high as the highest from the start
}

void ToolRack::use(Tool *tool)
{
    CanvasWidget &canvas = m_place.canvas;
    m_next = canvas.isPressed() && canvas.tool()->isBusy() ? tool : nullptr;
    if (m_next) // when the stroke in hand is finished
        return;
    if (Tool *before = canvas.tool())
        before->settle();
    canvas.setTool(tool);
    m_options.setWidget(tool->options());
}

void ToolRack::turnPen(bool eraser)
{
    QAction &erase = m_place.commands[Command::Eraser];
    QAction *inUse = erase.actionGroup()->checkedAction();
    if (eraser && inUse != &erase) {
        m_tip = inUse;
        erase.setChecked(true);
    } else if (!eraser && m_tip) {
        if (inUse == &erase)
            m_tip->setChecked(true);
        m_tip = nullptr;
    }
}

} // namespace suffuse

#include "app/window/pointer/canvas_menu.h"

#include "app/canvas/canvas_widget.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"
#include "app/session/selecting/pick.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/theme.h"
#include "app/window/workplace.h"

#include <QCoreApplication>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace suffuse {

namespace {

constexpr std::size_t namedStrokes = 6; ///< that stand in the menu itself
constexpr int chipSide = 16;            ///< logical pixels
constexpr double reach = 3;             ///< logical pixels in which hairlines are found

QString menuWords(const char *text)
{
    return QCoreApplication::translate("suffuse::CanvasMenu", text);
}

QIcon chip(const Colour &colour, double ratio)
{
    QPixmap pixmap(QSize(chipSide, chipSide) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shape;
    shape.addRoundedRect(QRectF(1, 1, chipSide - 2, chipSide - 2), 3, 3);
    paintColour(painter, shape, colour);
    painter.strokePath(shape, QPen(edgeOfColours(), 1));
    return QIcon(pixmap);
}

/// "Stroke 12 · Ink wash"
QString titleFor(const Stroke &stroke)
{
    const QString brush = stroke.brush.isEmpty() ? QString() : QStringLiteral(" · ") + brushTitle(stroke.brush);
    QString title = titleOf(stroke) + brush;
    return title.replace('&', QStringLiteral("&&"));
}

/// What is seen of a stroke at the point or, where it is found for being near, of the segment that is.
Colour colourAt(const Stroke &stroke, int segment, Microseconds T, Point point)
{
    const SeenPaint seen = seenPaint(stroke, T, point);
    return seen.density > 0 ? seen.colour : stroke.segments[std::size_t(segment)].colour;
}

void addStrokes(QMenu &menu, const Workplace &place, const std::vector<SegmentRef> &found, Point point)
{
    if (found.empty())
        return;
    const Document &document = place.open.editor.document();
    menu.addSection(menuWords(QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Under the Pointer")));
    QMenu *into = &menu;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (i == namedStrokes && found.size() > namedStrokes + 1)
            into = menu.addMenu(menuWords(QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Further Below")));
        const StrokePtr stroke = document.painting()->find(found[i].stroke);
        const QString number = i < 9 ? QStringLiteral("&%1  ").arg(i + 1) : QString();
        const Colour colour = colourAt(*stroke, found[i].segment, place.open.editor.clock().time(), point);
        QAction *action = into->addAction(chip(colour, menu.devicePixelRatioF()), number + titleFor(*stroke));
        if (document.selection().strokes.contains(stroke->id)) {
            QFont font = menu.font();
            font.setBold(true); // it is selected
            action->setFont(font);
        }
        QObject::connect(action, &QAction::triggered, &place.canvas, [place, id = stroke->id] {
            place.open.editor.document().setSelection({{id}, {}});
            if (!place.canvas.tool()->showsOutlines()) // the Brush shows what is selected for a moment only
                place.commands[Command::Select].setChecked(true);
        });
    }
}

/// What can be used of the commands, below a line.
void addUsable(QMenu &menu, const Commands &table, std::initializer_list<Command> commands)
{
    bool first = true;
    for (const Command command : commands) {
        QAction &action = table[command];
        if (!action.isEnabled() || !action.isVisible())
            continue;
        if (std::exchange(first, false) && !menu.isEmpty())
            menu.addSeparator();
        menu.addAction(&action);
    }
}

using Groups = std::initializer_list<std::initializer_list<Command>>;

/// The same in a menu of its own, with lines between groups; no menu where nothing can be used.
void addUsable(QMenu &menu, const char *title, const Commands &table, Groups groups)
{
    QMenu *below = menu.addMenu(menuWords(title));
    for (const auto &group : groups)
        addUsable(*below, table, group);
    if (below->isEmpty())
        delete below;
}

void addBrushAndColours(QMenu &menu, const Commands &table)
{
    using enum Command;
    QMenu *below = menu.addMenu(menuWords(QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Brush and C&olours")));
    addUsable(*below, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Apply &Brush"), table,
              {{ApplyBrush}, {ApplyBrushForm, ApplyBrushColour, ApplyBrushTexture}});
    addUsable(*below, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "&Appearance"), table,
              {{CopyAppearance, PasteAppearance, PasteAppearanceEvenly}, {MatchAppearance}});
    addUsable(*below, table, {MapToSwatches, RecolourArtwork});
    addUsable(*below, table, {VaryStrokes});
}

void addForSelection(QMenu &menu, const Commands &table)
{
    using enum Command;
    if (table[Segments].isChecked())
        addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "&Nodes"), table,
                  {{InsertNodes, NodeCorner, NodeSmooth, NodeSymmetric},
                   {BreakNodes, JoinNodes, DeleteSegments, BridgeSegments, ReverseStrokes}});
    addUsable(menu, table, {EditHere});
    addUsable(menu, table, {Cut, Copy, Paste, PasteInPlace, Duplicate, Delete});
    addUsable(menu, table, {GroupStrokes, UngroupStrokes, LockStrokes, HideStrokes, RenameStrokes});
    menu.addSeparator();
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "A&rrange"), table, {{Top, Raise, Lower, Bottom}});
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Trans&form"), table,
              {{FlipAcross, FlipDown, QuarterLeft, QuarterRight}});
    addUsable(
        menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "R&eshape"), table,
        {{SimplifyStrokes, RefitStrokes, SmoothStrokes, StraightenStrokes, OffsetStrokes}, {GrowPaint, ShrinkPaint}});
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Com&bine and Break"), table,
              {{CombineStrokes, BreakApart, RemoveErasures},
               {UniteAreas, SubtractAreas, IntersectAreas, ExcludeAreas, DivideAreas},
               {InsetAreas, OutsetAreas, LinesToAreas}});
    addBrushAndColours(menu, table);
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Select S&ame"), table,
              {{SameColour, SameStyle, SameBrush, SameName}});
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Dr&ying"), table,
              {{LetDry, FreezeNow, Rewet, RemoveRewetting}});
}

void clear(QMenu &menu)
{
    const QList<QMenu *> submenus = menu.findChildren<QMenu *>(QString(), Qt::FindDirectChildrenOnly);
    menu.clear();
    qDeleteAll(submenus);
}

void addForCanvas(QMenu &menu, const Commands &table)
{
    using enum Command;
    addUsable(menu, table, {Undo, Redo});
    addUsable(menu, table, {Paste, PasteInPlace, SelectAll});
    addUsable(menu, table, {UnlockAll, ShowAll});
    addUsable(menu, table, {Fit, Zoom100, Mirror});
    addUsable(menu, table, {ShowGrid, ShowOutlines, ShowErasures, ShowBeyond});
    menu.addSeparator();
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "Under&lay"), table,
              {{ShowUnderlay, UnderlayToLayer, ImportUnderlay}});
    addUsable(menu, QT_TRANSLATE_NOOP("suffuse::CanvasMenu", "&Colours"), table, {{MapToSwatches, RecolourArtwork}});
}

} // namespace

std::vector<SegmentRef> strokesAt(const Workplace &place, Point point)
{
    const double tolerance = reach * place.canvas.devicePixelRatioF() / place.canvas.view().scale;
    return pickAll(*place.open.editor.document().painting(), place.open.editor.clock().time(), point, tolerance);
}

void fillCanvasMenu(QMenu &menu, const Workplace &place, const std::vector<SegmentRef> &found, Point point)
{
    clear(menu);
    addStrokes(menu, place, found, point);
    if (place.commands[Command::Brush].isChecked())
        addUsable(menu, place.commands, {Command::BrushPalette});
    if (place.open.editor.document().selection().isEmpty())
        addForCanvas(menu, place.commands);
    else
        addForSelection(menu, place.commands);
}

void fillRulerMenu(QMenu &menu, const Workplace &place)
{
    using enum Command;
    clear(menu);
    addUsable(menu, place.commands, {RulersInUnits, RulersInMillimetres, RulersInInches});
    addUsable(menu, place.commands, {AddLevelGuide, AddUprightGuide, RemoveGuides});
    addUsable(menu, place.commands, {ShowGuides, SnapToGuides, LockGuides});
    addUsable(menu, place.commands, {ShowRulers});
}

} // namespace suffuse

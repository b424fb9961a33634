#include "app/window/files/pasting.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/files/clipboard.h"
#include "app/session/open_painting.h"
#include "app/window/files/clipboard_drops.h"

#include <QClipboard>
#include <QCursor>
#include <QGuiApplication>
#include <QKeyEvent>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int pastedShownMs = 8'000;

/// What can be seen of the canvas. All of the view where the canvas itself is elsewhere.
Rect seenOf(CanvasWidget &canvas)
{
    const View &view = canvas.view();
    Rect seen;
    for (const Point corner : {Point{0, 0}, Point{double(view.width), 0}, Point{0, double(view.height)},
                               Point{double(view.width), double(view.height)}})
        seen.include(view.toCanvas(corner));
    const Rect sheet = canvas.editor().document().painting()->canvas.area();
    if (canvas.aids().showBeyond || !seen.intersects(sheet))
        return seen;
    return {std::max(seen.left, sheet.left), std::max(seen.top, sheet.top), std::min(seen.right, sheet.right),
            std::min(seen.bottom, sheet.bottom)};
}

} // namespace

Pasting::Pasting(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    place.commands
        .add(Command::Paste, "paste", Commands::tr("&Paste"), "paste", QKeySequence::keyBindings(QKeySequence::Paste),
             Commands::tr("Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one"))
        .when([this] { return m_canPaste; }, Commands::tr("The clipboard has nothing that can be painted."))
        .runs([this] { pasteAt(pointer()); });
    place.commands
        .add(Command::PasteInPlace, "pasteInPlace", Commands::tr("Paste &in Place"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+V"))}, Commands::tr("Paste strokes where they were"))
        .when([this] { return m_canPaste; }, Commands::tr("The clipboard has nothing that can be painted."))
        .runs([this] { pasteAt({}); });
    connect(new CanvasDrops(place.canvas), &CanvasDrops::leftOut, this,
            [this](const QString &problem) { emit m_place.commands.said(problem, pastedShownMs); });
    connect(QGuiApplication::clipboard(), &QClipboard::dataChanged, this, &Pasting::followClipboard);
    followClipboard();
}

void Pasting::followClipboard()
{
    m_canPaste = clipboard::canPaste(QGuiApplication::clipboard()->mimeData());
    m_place.commands.update(Command::Paste);
    m_place.commands.update(Command::PasteInPlace);
}

/// At the pointer, as in Inkscape; in the middle where it is elsewhere.
Point Pasting::pointer() const
{
    const CanvasWidget &canvas = m_place.canvas;
    const QPointF at = canvas.mapFromGlobal(QPointF(QCursor::pos()));
    const View &view = canvas.view();
    const double dpr = canvas.devicePixelRatioF();
    const bool inside = QRectF(canvas.rect()).contains(at);
    return view.toCanvas(inside ? Point{at.x() * dpr, at.y() * dpr} : Point{0.5 * view.width, 0.5 * view.height});
}

void Pasting::pasteAt(std::optional<Point> middle)
{
    if (Tool *tool = m_place.canvas.tool(); tool && tool->takesText()) { // What is pasted then is typed.
        QKeyEvent key(QEvent::KeyPress, Qt::Key_V, Qt::ControlModifier);
        tool->keyPress(&key);
        return;
    }
    if (const Tool *tool = m_place.canvas.tool(); tool && tool->isBusy())
        return; // first things first
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    const QString problem =
        data ? clipboard::paste(m_place.open.editor, *data, {middle, seenOf(m_place.canvas)}) : QString();
    if (!problem.isEmpty())
        emit m_place.commands.said(problem, pastedShownMs);
}

} // namespace suffuse

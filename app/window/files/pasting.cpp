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

namespace suffuse {

namespace {

constexpr int pastedShownMs = 8'000;

} // namespace

Pasting::Pasting(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    place.commands
        .add(Command::Paste, "paste", Commands::tr("&Paste"), "paste", QKeySequence::keyBindings(QKeySequence::Paste),
             Commands::tr("Paste strokes or SVG paths at the pointer; a colour becomes the current one"))
        .when([this] { return m_canPaste; })
        .runs([this] { pasteAt(pointer()); });
    place.commands
        .add(Command::PasteInPlace, "pasteInPlace", Commands::tr("Paste &in Place"), "",
             {QKeySequence(Commands::tr("Ctrl+Alt+V"))}, Commands::tr("Paste strokes where they were"))
        .when([this] { return m_canPaste; })
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

void Pasting::pasteAt(std::optional<Point> centre)
{
    if (Tool *tool = m_place.canvas.tool(); tool && tool->takesText()) { // What is pasted then is typed.
        QKeyEvent key(QEvent::KeyPress, Qt::Key_V, Qt::ControlModifier);
        tool->keyPress(&key);
        return;
    }
    if (const Tool *tool = m_place.canvas.tool(); tool && tool->isBusy())
        return; // first things first
    const QMimeData *data = QGuiApplication::clipboard()->mimeData();
    const QString problem = data ? clipboard::paste(m_place.open.editor, *data, centre) : QString();
    if (!problem.isEmpty())
        emit m_place.commands.said(problem, pastedShownMs);
}

} // namespace suffuse

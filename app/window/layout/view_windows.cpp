#include "app/window/layout/view_windows.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/editor.h"
#include "app/session/open_painting.h"
#include "app/window/free_hand.h"

#include <QAction>
#include <QCloseEvent>
#include <QEvent>
#include <QLocale>
#include <QToolBar>

#include <utility>

namespace suffuse {

namespace {

constexpr double viewZoomStep = 1.4142135623730951;

} // namespace

ViewWindow::ViewWindow(const Workplace &place, MakeRenderer make) : m_place(place)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowIcon(place.window.windowIcon());
    resize(640, 520);
    m_canvas = new CanvasWidget(place.open.editor, this, std::move(make), CanvasUse::Look);
    m_canvas->setObjectName("secondCanvas");
    m_canvas->setAccessibleName(tr("View of the painting"));
    setCentralWidget(m_canvas);
    makeActions();
    connect(&place.open.editor, &Editor::fileChanged, this, &ViewWindow::showTitle);
    connect(m_canvas, &CanvasWidget::viewChanged, this, &ViewWindow::showTitle);
    showTitle();
    m_canvas->setFocus();
}

ViewWindow::~ViewWindow()
{
    delete m_canvas; // It shows the painting, which may go before its window.
}

void ViewWindow::makeActions()
{
    m_bar = addToolBar(tr("View"));
    m_bar->setObjectName("viewTools");
    m_bar->setMovable(false);
    m_bar->toggleViewAction()->setVisible(false);
    const Commands &table = m_place.commands;
    // They are called and look as in the other window, and move this view.
    const auto add = [&](Command command, auto move) {
        const QAction &like = table[command];
        QAction *action = m_bar->addAction(like.icon(), plainTitle(like.text()));
        action->setShortcuts(like.shortcuts());
        action->setToolTip(like.toolTip());
        connect(action, &QAction::triggered, this, move);
        addAction(action);
    };
    add(Command::ZoomIn, [this] { m_canvas->zoomBy(viewZoomStep); });
    add(Command::ZoomOut, [this] { m_canvas->zoomBy(1 / viewZoomStep); });
    add(Command::Zoom100, [this] { m_canvas->setZoom(1); });
    add(Command::Fit, [this] { m_canvas->fit(); });
    add(Command::Mirror, [this] { m_canvas->mirror(); });
    auto *closing = new QAction(plainTitle(table[Command::Close].text()), this);
    closing->setShortcuts(table[Command::Close].shortcuts());
    connect(closing, &QAction::triggered, this, &QWidget::close);
    addAction(closing);
    for (const Command command : {Command::Undo, Command::Redo, Command::Save, Command::Quit})
        addAction(&table[command]);
}

void ViewWindow::showTitle()
{
    const double percent = 100 * m_canvas->view().scale / m_canvas->devicePixelRatioF();
    setWindowTitle(
        tr("%1 · view at %2 %").arg(m_place.open.editor.displayName()).arg(QLocale().toString(percent, 'g', 3)));
}

void ViewWindow::closeEvent(QCloseEvent *event)
{
    event->accept(); // Nothing is lost: the painting is open in the other window.
}

ViewWindows::ViewWindows(const Workplace &place, MakeRenderer make, QObject *parent)
    : QObject(parent), m_place(place), m_make(std::move(make))
{
    place.commands
        .add(Command::NewView, "newView", Commands::tr("New View"), "", {},
             Commands::tr("A window that shows the painting from elsewhere while you paint; each edit shows in both"))
        .runs([this] { whenHandIsFree(m_place.canvas, *this, [this] { open(); }); });
    place.window.installEventFilter(this);
}

ViewWindows::~ViewWindows()
{
    for (const QPointer<ViewWindow> &window : std::exchange(m_windows, {}))
        if (window) {
            window->disconnect(this);
            delete window;
        }
}

void ViewWindows::open()
{
    Editor &editor = m_place.open.editor;
    editor.settle();
    auto *window = new ViewWindow(m_place, m_make);
    m_windows.emplace_back(window);
    editor.setFloatingView(nullptr);
    connect(window, &QObject::destroyed, this, [this, window] { noteClosed(window); });
    window->show();
}

void ViewWindows::noteClosed(const ViewWindow *closed)
{
    std::erase_if(m_windows, [closed](const QPointer<ViewWindow> &window) { return !window || window == closed; });
    if (m_windows.empty())
        m_place.open.editor.setFloatingView(&m_place.canvas.lifted());
}

/// The program ends with its last window; one that only looks does not keep it.
bool ViewWindows::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Hide && watched == &m_place.window && !event->spontaneous())
        for (const QPointer<ViewWindow> &window : std::vector(m_windows))
            if (window)
                window->close();
    return QObject::eventFilter(watched, event);
}

} // namespace suffuse

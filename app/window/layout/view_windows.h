// More windows that show the painting of a window.
#pragma once

#include "app/window/workplace.h"
#include "render/backends.h"

#include <QMainWindow>
#include <QObject>
#include <QPointer>

#include <vector>

class QToolBar;

namespace suffuse {

/// Shows a painting from somewhere else, or nearer, while it is painted in its own window: each edit shows in both at
/// once, also while it is made. One looks here: a drag moves the view, the wheel zooms. There is no outline and no axis
/// over the picture.
class ViewWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `place` is that of the window in which one paints.
    ViewWindow(const Workplace &place, MakeRenderer make);
    ~ViewWindow() override;

    CanvasWidget &canvas() const { return *m_canvas; }

protected:
    void closeEvent(QCloseEvent *event) override;

private:
    void makeActions();
    void showTitle();

    Workplace m_place;
    CanvasWidget *m_canvas = nullptr;
    QToolBar *m_bar = nullptr;
};

/// Opens them, and closes them with the window in which one paints. Closing one asks nothing, since the painting stays
/// open. While there is one, strokes that are dragged are drawn in the document and do not float over the canvas
/// (CanvasLift): a picture that floats is one window's alone.
class ViewWindows : public QObject {
    Q_OBJECT

public:
    ViewWindows(const Workplace &place, MakeRenderer make, QObject *parent);
    ~ViewWindows() override;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void open();
    void noteClosed(const ViewWindow *closed);

    Workplace m_place;
    MakeRenderer m_make;
    std::vector<QPointer<ViewWindow>> m_windows;
};

} // namespace suffuse

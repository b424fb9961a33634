// The real window, driven at the pace of a hand, and a stopwatch that stops when what an event did is on the screen.
#pragma once

#include "app/canvas/canvas_widget.h"
#include "app/window/main_window.h"

#include <QApplication>

#include <functional>
#include <map>
#include <vector>

namespace suffuse {

/// Milliseconds: by the clock on the wall, from the event on.
struct Times {
    std::vector<double> ms;
    double at(double share) const; ///< 0: the least, 1: the greatest; 0 without any
};

/// What a drag at the pace of a hand did.
struct DragTimes {
    Times toFrame;   ///< from an event to the frame on the screen that shows what it did
    int skipped = 0; ///< events that came while the one before still waited
    double framesASecond = 0;
    double coarse = 0;  ///< per cent of the frames
    double frameMs = 0; ///< of the renderer, by its own clock, the median
    double guiMs = 0;   ///< computed on the GUI thread, an event
    double allMs = 0;   ///< on all threads, an event
};

/// Milliseconds that this thread has computed for.
double computedMs();

/// Knows when a window has been painted.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject *receiver, QEvent *event) override;

    QWidget *watched = nullptr;
    std::function<void()> painted;
};

/// A window of 1920 × 1080 with a painting in it, dry.
class EditingSession {
public:
    EditingSession(Application &application, PaintingPtr painting);
    ~EditingSession();

    MainWindow &window() { return m_window; }
    Editor &editor() { return m_window.editor(); }
    Document &document() { return m_window.editor().document(); }
    CanvasWidget &canvas() { return m_window.canvas(); }
    const Painting &painting() { return *document().painting(); }

    /// Calls `act(0)` … from the event loop, 60 times a second, as reports of a mouse come: while one waits, none
    /// follow.
    DragTimes paced(int events, const std::function<void(int)> &act);
    /// Milliseconds until the window has been painted after `act`, whatever picture it shows; `computed`: those that
    /// the GUI thread has computed for.
    double untilPainted(const std::function<void()> &act, double *computed = nullptr);
    /// Milliseconds until the picture on the screen shows what `act` did.
    double untilShown(const std::function<void()> &act);
    /// Until the exact picture stands.
    void settle();
    /// The same, and for as long as a hand does, which panels have to come to rest, too.
    void rest();
    /// The same pause with the button down, where an open drag would never settle.
    void holdStill();
    /// Pixels evaluated since the last call, by the frames shown since then.
    double takeEvaluatedPixels();

    void mouse(QWidget &widget, QEvent::Type type, Point at);
    void mouse(QEvent::Type type, Point pixel) { mouse(canvas(), type, pixel); }
    void key(int key, Qt::KeyboardModifiers modifiers = {});

private:
    using Clock = std::chrono::steady_clock;

    void painted();
    void waitFor(quint64 frame, Clock::time_point since);
    bool runUntil(const std::function<bool()> &done);

    Application &m_application;
    MainWindow m_window;
    std::multimap<quint64, Clock::time_point> m_waiting; ///< by the frame that they wait for
    std::vector<double> m_shown;
    quint64 m_presented = 0;
    quint64 m_lastPainted = 0;
    int m_frames = 0;
    int m_coarseFrames = 0;
    Times m_frameTimes;
    Clock::time_point m_paintedAt;
    double m_paintedComputed = 0;
    int m_paints = 0;
    double m_evaluated = 0;
};

} // namespace suffuse

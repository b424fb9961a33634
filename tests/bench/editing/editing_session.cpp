#include "tests/bench/editing/editing_session.h"

#include <QEventLoop>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>

namespace suffuse {

namespace {

constexpr int width = 1920, height = 1080;
constexpr auto interval = std::chrono::microseconds(16'667);
constexpr auto patience = std::chrono::seconds(60);
constexpr auto handRests = std::chrono::milliseconds(200); ///< between choosing what to drag and dragging it

double computedMs(clockid_t clock)
{
    timespec t;
    clock_gettime(clock, &t);
    return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

template <typename Duration>
double toMs(Duration d)
{
    return std::chrono::duration<double, std::milli>(d).count();
}

} // namespace

double computedMs()
{
    return computedMs(CLOCK_THREAD_CPUTIME_ID);
}

double Times::at(double share) const
{
    if (ms.empty())
        return 0;
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted[std::size_t(std::ceil(share * double(sorted.size() - 1)))];
}

bool Application::notify(QObject *receiver, QEvent *event)
{
    const bool paints = receiver == watched && event->type() == QEvent::UpdateRequest;
    const bool result = QApplication::notify(receiver, event);
    if (paints && painted)
        painted();
    return result;
}

EditingSession::EditingSession(Application &application, PaintingPtr painting) : m_application(application)
{
    m_window.resize(width, height);
    m_window.show();
    QObject::connect(&canvas(), &CanvasWidget::framePresented, &m_window, [this](const FrameInfo &frame) {
        m_presented = frame.serial;
        m_evaluated += frame.evaluated;
        m_coarseFrames += !frame.isExact();
        m_frameTimes.ms.push_back(frame.stats.totalMs);
        if (frame.stats.dirty.empty())
            painted(); // the picture stays
    });
    m_application.watched = &m_window;
    m_application.painted = [this] { this->painted(); };
    document().reset(std::move(painting));
    editor().clock().setTime(this->painting().end());
    settle();
}

EditingSession::~EditingSession()
{
    m_application.painted = {};
    m_application.watched = nullptr;
}

void EditingSession::painted()
{
    const Clock::time_point now = Clock::now();
    m_paintedAt = now;
    m_paintedComputed = computedMs();
    ++m_paints;
    if (m_presented != std::exchange(m_lastPainted, m_presented))
        ++m_frames;
    const auto end = m_waiting.upper_bound(m_presented);
    for (auto it = m_waiting.begin(); it != end; ++it)
        m_shown.push_back(toMs(now - it->second));
    m_waiting.erase(m_waiting.begin(), end);
}

void EditingSession::waitFor(quint64 frame, Clock::time_point since)
{
    if (frame != m_lastPainted) // else the event changed nothing, as at a slider's end, and no frame comes for it
        m_waiting.emplace(frame, since);
}

bool EditingSession::runUntil(const std::function<bool()> &done)
{
    const Clock::time_point start = Clock::now();
    QTimer awake; // so that the loop comes round
    awake.start(1);
    while (!done() && Clock::now() - start < patience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return done();
}

DragTimes EditingSession::paced(int events, const std::function<void(int)> &act)
{
    DragTimes result;
    m_shown.clear();
    m_frames = m_coarseFrames = 0;
    m_frameTimes.ms.clear();
    std::atomic<bool> waits = false, over = false;
    int taken = 0;
    const double gui = computedMs(), all = computedMs(CLOCK_PROCESS_CPUTIME_ID);
    const Clock::time_point start = Clock::now();
    std::thread hand([&] {
        for (int i = 0; i < events; ++i) {
            std::this_thread::sleep_until(start + i * interval);
            if (waits.exchange(true)) {
                ++result.skipped;
                continue;
            }
            const Clock::time_point at = Clock::now();
            QMetaObject::invokeMethod(
                &m_application,
                [&, i, at] {
                    waits = false;
                    ++taken;
                    act(i);
                    waitFor(canvas().neededFrame(), at);
                },
                Qt::QueuedConnection);
        }
        over = true;
    });
    runUntil([&] { return over && !waits && m_waiting.empty(); });
    hand.join();
    const double seconds = 1e-3 * toMs(Clock::now() - start);
    result.toFrame.ms = m_shown;
    result.framesASecond = m_frames / seconds;
    result.frameMs = m_frameTimes.at(0.5);
    result.coarse = 100.0 * m_coarseFrames / std::max(m_frames, 1);
    result.guiMs = (computedMs() - gui) / taken;
    result.allMs = (computedMs(CLOCK_PROCESS_CPUTIME_ID) - all) / taken;
    return result;
}

double EditingSession::untilPainted(const std::function<void()> &act, double *computed)
{
    const int before = m_paints;
    const Clock::time_point start = Clock::now();
    const double own = computedMs();
    act();
    while (m_paints == before && Clock::now() - start < patience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    if (computed)
        *computed = m_paintedComputed - own;
    return toMs(m_paintedAt - start);
}

double EditingSession::untilShown(const std::function<void()> &act)
{
    m_shown.clear();
    const Clock::time_point start = Clock::now();
    act();
    waitFor(canvas().neededFrame(), start);
    runUntil([this] { return m_waiting.empty(); });
    return m_shown.empty() ? 0 : m_shown.front();
}

void EditingSession::settle()
{
    runUntil(
        [this] { return canvas().isUpToDate() && m_presented == canvas().neededFrame() && !editor().isDragging(); });
    QCoreApplication::processEvents();
}

void EditingSession::rest()
{
    settle();
    holdStill();
}

void EditingSession::holdStill()
{
    const Clock::time_point start = Clock::now();
    runUntil([start] { return Clock::now() - start > handRests; });
}

double EditingSession::takeEvaluatedPixels()
{
    return std::exchange(m_evaluated, 0);
}

void EditingSession::mouse(QWidget &widget, QEvent::Type type, Point at)
{
    const bool moves = type == QEvent::MouseMove;
    const QPointF p(at.x, at.y);
    QMouseEvent event(type, p, widget.mapToGlobal(p), moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &event);
}

void EditingSession::key(int key, Qt::KeyboardModifiers modifiers)
{
    for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
        QKeyEvent event(type, key, modifiers);
        QCoreApplication::sendEvent(&canvas(), &event);
    }
}

} // namespace suffuse

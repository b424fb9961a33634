// A window with its timeline shown, and strokes whose times are known.
#pragma once

#include "app/panels/timeline/timeline_panel.h"
#include "app/panels/timeline/timeline_view.h"
#include "app/session/playback.h"
#include "model/formats/files.h"
#include "render/backends.h"
#include "tests/app/selecting.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTimer>

namespace suffuse {

inline constexpr Microseconds second = 1'000'000;

/// A straight stroke whose segments are born a tenth of a second apart.
inline StrokePtr drawnAt(StrokeId id, Microseconds born, Point from, Point to, Colour colour = {1, 0, 0, 1})
{
    auto stroke = std::make_shared<Stroke>(*line(id, from, to));
    for (std::size_t k = 0; k < stroke->segments.size(); ++k) {
        stroke->segments[k].born = born + Microseconds(k) * second / 10;
        stroke->segments[k].colour = colour;
    }
    return stroke;
}

/// Four strokes that cross in the middle, begun at 1, 2, 3 and 10 seconds; each dries 1.3 s after.
inline StrokeList fourStrokes()
{
    return {drawnAt(1, second, {200, 200}, {600, 400}), drawnAt(2, 2 * second, {600, 200}, {200, 400}, {0, 1, 0, 1}),
            drawnAt(3, 3 * second, {400, 150}, {400, 450}, {0, 0, 1, 1}),
            drawnAt(4, 10 * second, {200, 300}, {600, 300}, {1, 1, 0, 1})};
}

/// A window with strokes in it, the timeline shown.
struct Timed : Selecting {
    explicit Timed(StrokeList strokes = fourStrokes()) : Selecting(std::move(strokes))
    {
        panel = window.findChild<TimelinePanel *>();
        qobject_cast<QDockWidget *>(panel->parentWidget())->show();
        use(Command::Brush);
        window.resizeDocks({window.findChild<QDockWidget *>("timelineDock")}, {150},
                           Qt::Vertical); // lower on a low screen
        QTRY_VERIFY_WITH_TIMEOUT(view().viewport()->height() > 80, waitMs);
    }
    TimelineView &view() { return *panel->view(); }
    Playback &playback() { return window.playback(); }
    QPoint middleOf(StrokeId id) { return view().drawnRect(id).center().toPoint(); }
    QPoint endOf(StrokeId id)
    {
        const QRectF rect = view().drawnRect(id);
        return QPointF(rect.right(), rect.center().y()).toPoint();
    }
    QPoint beginOf(StrokeId id)
    {
        const QRectF rect = view().drawnRect(id);
        return QPointF(rect.left(), rect.center().y()).toPoint();
    }
    QPoint onRuler(Microseconds time) { return {int(std::lround(view().xOf(time))), 5}; }
    void press(QPoint at, Qt::KeyboardModifiers keys = {})
    {
        QTest::mousePress(view().viewport(), Qt::LeftButton, keys, at);
    }
    void moveTo(QPoint at)
    {
        const QPointF p(at);
        QMouseEvent event(QEvent::MouseMove, p, view().viewport()->mapToGlobal(p), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(view().viewport(), &event);
    }
    void release(QPoint at) { QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, at); }
    void dragBar(QPoint from, QPoint to)
    {
        press(from);
        moveTo(from + (to - from) / 2);
        moveTo(to);
        release(to);
    }
    QImage pictureNow()
    {
        [&] { QTRY_VERIFY_WITH_TIMEOUT(canvas().isUpToDate(), waitMs); }();
        return canvas().picture();
    }
    std::vector<StrokeId> order()
    {
        std::vector<StrokeId> ids;
        for (const StrokePtr &s : painting().strokes)
            ids.push_back(s->id);
        return ids;
    }
    /// What the status bar says of the tool in hand.
    QString hint()
    {
        for (const QLabel *label : window.findChildren<QLabel *>())
            if (label->toolTip().endsWith(canvas().tool()->hint()))
                return label->text();
        return {};
    }

    TimelinePanel *panel = nullptr;
};

/// What a renderer that has drawn nothing before makes of it.
inline QImage rendered(const Painting &painting, Microseconds time, const View &view)
{
    auto renderer = makeRenderer({.backend = Backend::Cpu, .threads = 1});
    RenderRequest request;
    request.painting = std::make_shared<const Painting>(painting);
    request.time = time;
    request.view = view;
    Picture8 picture;
    if (!renderer || !(*renderer)->render(request, picture, nullptr))
        return {};
    return QImage(reinterpret_cast<const uchar *>(picture.argb.data()), picture.width, picture.height,
                  picture.width * 4, QImage::Format_ARGB32)
        .copy();
}
} // namespace suffuse

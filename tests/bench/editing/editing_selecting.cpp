// Selecting, and moving the view.
#include "tests/bench/editing/editing_benches.h"

#include <cmath>

namespace suffuse {

Report measureViews(EditingSession &s, int events)
{
    Report report{"Moving the view at 60 events a second: event to frame on the screen, ms", {}};
    const auto measure = [&](const QString &name, const std::function<void(int)> &move) {
        const DragTimes times = s.paced(events, move);
        report.rows.push_back(rowOf(name, times));
        s.canvas().fit();
        s.settle();
    };
    const auto pan = [&](const QString &name, double pixels) {
        int moves = 0;
        measure(name, [&](int) { s.canvas().panBy({moves++ % 40 < 20 ? pixels : -pixels, 0.5 * pixels}); });
    };
    s.document().setSelection({});
    pan("pan, nothing selected", 2);
    pan("pan, 20 pixels an event", 20);
    s.window().action(Command::SelectAll).trigger();
    pan("pan, all selected", 2);
    s.document().setSelection({});
    s.canvas().setZoom(0.1);
    s.settle();
    const double step = std::pow(1e4, 2.0 / std::max(events, 2)); // from 0.1 to 1,000 times, and back
    int moves = 0;
    measure("zoom, 0.1 to 1000 times and back",
            [&](int) { s.canvas().setZoom(s.canvas().view().scale * (moves++ < events / 2 ? step : 1 / step)); });
    return report;
}

namespace {

using Act = std::function<void(int)>;
/// What is measured: its name, how often, what is done, and what is done before it.
using Measure = std::function<void(const QString &name, int times, const Act &act, const Act &before)>;

void measureTouchPath(EditingSession &s, int events, const Measure &measure)
{
    const View view = s.canvas().view();
    const auto along = [&](int i) {
        return Point{view.width * 0.2 + 4 * i, view.height * (0.5 + 0.3 * std::sin(0.04 * i))};
    };
    const auto touch = [&](int i) {
        s.document().setSelection({});
        s.mouse(QEvent::MouseButtonPress, {4, 4}); // A drag that begins on a stroke moves it.
        for (int k = 0; k < 20; ++k)
            s.mouse(QEvent::MouseMove, along(i + k));
    };
    const auto goOn = [&](int i) { s.mouse(QEvent::MouseMove, along(20 + i)); };
    const auto letGo = [&](int i) { s.mouse(QEvent::MouseButtonRelease, along(20 + i)); };
    s.window().action(Command::TouchPath).setChecked(true);
    measure("touch path, a step of it", events, goOn, [&](int i) {
        if (i == 0)
            touch(0);
    });
    letGo(events);
    measure("touch path, what it touches", events / 3, letGo, touch);
    s.window().action(Command::TouchPath).setChecked(false);
}

} // namespace

Report measureSelecting(EditingSession &s, int events, const QString &wanted)
{
    Report report{"Selecting: event to selection and overlay on the screen, ms", {}};
    s.window().action(Command::Select).trigger();
    const auto nothing = [](int) {};
    const auto measure = [&](const QString &name, int times, const Act &act, const Act &before) {
        if (!name.contains(wanted))
            return;
        Times result, computed;
        for (int i = 0; i < times; ++i) {
            before(i);
            s.rest();
            result.ms.push_back(s.untilPainted([&] { act(i); }, &computed.ms.emplace_back()));
        }
        report.rows.push_back(rowOf(name, result));
        report.rows.back().values.push_back({"GUI ms", computed.at(0.5)});
    };
    const View view = s.canvas().view();
    const auto place = [&](int i) {
        const Rect area = s.painting().canvas.area();
        return view.toPixels({area.width() * (0.1 + 0.8 * std::fmod(0.618 * i, 1)),
                              area.height() * (0.1 + 0.8 * std::fmod(0.414 * i, 1))});
    };
    const auto click = [&](int i) {
        s.mouse(QEvent::MouseButtonPress, place(i));
        s.mouse(QEvent::MouseButtonRelease, place(i));
    };
    measure("click", events, click, nothing);
    measure(
        "Tab", events, [&](int) { s.key(Qt::Key_Tab); }, nothing);
    const auto corner = [&](int i) { return Point{view.width * 0.5 + i, view.height * 0.5 + i}; };
    const auto band = [&](int i) {
        s.mouse(QEvent::MouseButtonPress, {4, 4});
        s.mouse(QEvent::MouseMove, corner(i));
    };
    measure(
        "band over a quarter", events / 3, [&](int i) { s.mouse(QEvent::MouseButtonRelease, corner(i)); }, band);
    measureTouchPath(s, events, measure);
    measure(
        "select all, select none", events / 3,
        [&](int i) { s.window().action(i % 2 == 0 ? Command::SelectAll : Command::Deselect).trigger(); }, nothing);
    s.document().setSelection({});
    return report;
}

} // namespace suffuse

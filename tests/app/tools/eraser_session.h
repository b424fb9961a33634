// Two waves, and the eraser in hand.
#pragma once

#include "app/panels/inspector/inspector_panel.h"
#include "app/tools/shaping/eraser_tool.h"
#include "tests/app/shapes.h"

#include <QLabel>

#include <algorithm>

namespace suffuse {

/// Two waves whose paint is 20 wide and more; an eraser in hand, 24 across, that lifts unless told otherwise.
struct EraserSession : WaveSession {
    StrokeId other = addWave(200, 420, false);

    explicit EraserSession(EraserMode mode = EraserMode::Lift)
    {
        editor().document().setSelection({});
        use(Command::Eraser);
        choose(mode);
        eraser().setRadius(12);
    }
    void choose(EraserMode mode, double strength = 1)
    {
        EraserChoice choice;
        choice.setMode(mode);
        choice.strength = strength;
        eraser().setChoice(choice);
    }
    EraserTool &eraser() { return *window.findChild<EraserTool *>(); }
    /// As a hand does: the clock goes on, and it takes a moment from one path to the next.
    void erase(Point from, Point to, Qt::KeyboardModifiers modifiers = {}, bool release = true)
    {
        advance(200'000);
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, at(from));
        for (int i = 1; i <= 12; ++i) {
            advance(interval);
            move(from + (i / 12.0) * (to - from), modifiers);
        }
        if (release)
            QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, at(to));
    }
    QString hint() { return canvas().tool()->hint(); }
    int erasing(StrokeId which) { return int(std::ranges::count_if(stroke(which).segments, &Segment::takesPaint)); }
    /// Selects what takes paint away of one stroke.
    void selectErasing()
    {
        std::set<SegmentRef> erasing;
        for (int k = 0; k < int(stroke().segments.size()); ++k)
            if (stroke().segments[std::size_t(k)].takesPaint())
                erasing.insert({id, k});
        editor().document().setSelection({{id}, erasing});
    }
    QString summary()
    {
        for (const QLabel *label : window.findChild<InspectorPanel *>()->findChildren<QLabel *>())
            if (label->text().contains(QStringLiteral("stroke(s)")))
                return label->text();
        return {};
    }
};

} // namespace suffuse

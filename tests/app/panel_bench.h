// What tests of panels share: an editor with a few strokes, and hands that click and type.
#pragma once

#include "app/session/editor.h"
#include "app/widgets/numbers/bar_slider.h"

#include <QLineEdit>
#include <QTest>

namespace suffuse {

inline StrokePtr makeStroke(StrokeId id, int segments, float diffusion)
{
    Stroke stroke;
    stroke.id = id;
    stroke.origin = {50, 100};
    for (int i = 0; i < segments; ++i) {
        Segment segment;
        const float x = float(20 * i);
        segment.bezier = {Offset{x, 0}, Offset{x + 7, 0}, Offset{x + 13, 0}, Offset{x + 20, 0}};
        segment.diffusion = diffusion;
        stroke.segments.push_back(segment);
    }
    return std::make_shared<const Stroke>(std::move(stroke));
}

/// An editor with strokes 1 … count, bottom to top.
struct Bench {
    explicit Bench(int count = 3)
    {
        auto painting = std::make_shared<Painting>();
        for (int i = 1; i <= count; ++i)
            painting->strokes.push_back(makeStroke(StrokeId(i), 4, float(10 * i)));
        editor.document().reset(painting);
        editor.undoStack().clear();
    }
    void select(std::set<StrokeId> strokes, std::set<SegmentRef> segments = {})
    {
        editor.document().setSelection({std::move(strokes), std::move(segments)});
    }
    const Stroke &stroke(StrokeId id) { return *editor.document().painting()->find(id); }
    int steps() { return editor.undoStack().count(); }

    Editor editor;
};

inline void showAt(QWidget &widget, QSize size = {280, 700})
{
    widget.resize(size);
    widget.show();
    QVERIFY(QTest::qWaitForWindowExposed(&widget));
}

inline QPoint sliderPoint(const BarSlider &slider, double share)
{
    return {int(8 + share * (slider.width() - 16)), slider.height() / 2};
}

inline void type(QLineEdit &field, const QString &text)
{
    field.setFocus();
    QTest::qWait(1); // the field selects its text when it gets the focus
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

inline std::vector<StrokeId> orderOf(Editor &editor)
{
    std::vector<StrokeId> ids;
    for (const StrokePtr &stroke : editor.document().painting()->strokes)
        ids.push_back(stroke->id);
    return ids;
}

} // namespace suffuse

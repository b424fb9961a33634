// Undo and redo, and what the undo stack holds.
#include "tests/bench/editing/editing_benches.h"
#include "undo/edits.h"
#include "undo/node_edits.h"
#include "undo/transform_edits.h"

#include <QElapsedTimer>

#include <algorithm>

#include <malloc.h>

namespace suffuse {

namespace {

Edit restyle(const Document &document, float xi)
{
    return changeStrokes(document, document.selection().strokes, [xi](Stroke &stroke) {
        stroke.style = {StyleKind::Uniform, {xi, 0.5f * xi, 0}};
    });
}

double allocated()
{
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks + info.hblkhd);
}

double bytesOf(const Stroke &stroke)
{
    return double(sizeof(Stroke) + stroke.segments.size() * sizeof(Segment));
}

} // namespace

Report measureUndo(EditingSession &s, int times, const QString &wanted)
{
    Report report{"Undo and redo: in the call, and to the frame on the screen, ms", {}};
    QUndoStack &stack = s.editor().undoStack();
    const auto measure = [&](const QString &name, const Selection &selected, const std::function<Edit()> &edit) {
        if (!name.contains(wanted))
            return;
        s.document().setSelection(selected);
        s.editor().push(edit(), name);
        for (const bool undoes : {true, false}) {
            Times call, computed, frame;
            for (int i = 0; i < times; ++i) {
                s.rest();
                frame.ms.push_back(s.untilShown([&] {
                    QElapsedTimer timer;
                    timer.start();
                    const double before = computedMs();
                    undoes ? stack.undo() : stack.redo();
                    computed.ms.push_back(computedMs() - before);
                    call.ms.push_back(double(timer.nsecsElapsed()) * 1e-6);
                }));
                s.settle();
                undoes ? stack.redo() : stack.undo();
            }
            if (undoes)
                stack.undo();
            report.rows.push_back({(undoes ? "undo: " : "redo: ") + name,
                                   {{"call", call.at(0.5)},
                                    {"call p99", call.at(0.99)},
                                    {"call, computed", computed.at(0.5)},
                                    {"frame", frame.at(0.5)},
                                    {"frame p99", frame.at(0.99)}}});
        }
        s.settle();
    };
    const SegmentRef middle = middleSegment(s.painting());
    const std::size_t all = s.painting().strokes.size();
    const Selection one{{middle.stroke}, {}};
    const auto first = [&s](std::size_t count) { return Selection{firstStrokes(s.painting(), count), {}}; };
    const auto move = [&] { return transformSelection(s.document(), Affine::translation({7, 5}), SpreadRule::Stays); };
    measure("a node moved", one, [&] { return moveNodes(s.document(), {{middle.stroke, middle.segment}}, {7, 5}); });
    measure("D of a segment", {{middle.stroke}, {middle}}, [&] {
        return changeSegments(s.document(), {middle}, [](Segment &segment) { segment.diffusion *= 1.3f; });
    });
    measure("one stroke moved", one, move);
    measure("20 strokes moved", first(20), move);
    measure(QStringLiteral("all %1 strokes moved").arg(all), first(all), move);
    measure("one stroke painted", {}, [&] {
        Stroke stroke = *s.painting().find(middle.stroke);
        stroke.id = s.document().takeStrokeId();
        return addStrokes(s.document(), {std::make_shared<const Stroke>(std::move(stroke))}, false);
    });
    measure("20 strokes deleted", first(20), [&] { return deleteSelection(s.document()); });
    measure("100 strokes restyled", first(100), [&] { return restyle(s.document(), 0.3f); });
    measure("colour of all strokes", first(all), [&] {
        return changeSegments(s.document(), targetSegments(s.document()), [](Segment &segment) {
            segment.colour = {0.2f, 0.7f, 0.4f, segment.colour.opacity};
        });
    });
    s.document().setSelection({});
    return report;
}

Report measureMemory(const Painting &painting, int steps)
{
    Report report{"Memory of a step of the undo stack, bytes", {}};
    const auto measure = [&](const QString &name, const std::set<StrokeId> &selected,
                             const std::function<Edit(Document &, int)> &edit) {
        Editor editor;
        Document &document = editor.document();
        document.reset(std::make_shared<const Painting>(painting));
        document.setSelection({selected, {}});
        const auto push = [&](int from, int to) {
            for (int i = from; i < to; ++i)
                editor.push(edit(document, i), "step");
        };
        push(0, 10);
        const double before = allocated();
        const int first = editor.undoStack().count();
        push(10, 10 + steps);
        const int made = editor.undoStack().count() - first;
        double changed = 0;
        for (const StrokeId id : selected)
            changed += bytesOf(*document.painting()->find(id));
        const double each = (allocated() - before) / made;
        report.rows.push_back({name, {{"bytes", each}, {"changed strokes", changed}, {"ratio", each / changed}}});
    };
    const auto longest = std::max_element(painting.strokes.begin(), painting.strokes.end(),
                                          [](auto &a, auto &b) { return a->segments.size() < b->segments.size(); });
    const StrokeId id = (*longest)->id;
    const auto move = [](Document &document, int i) {
        return transformSelection(document, Affine::translation({i % 2 ? 1.5 : -1.25, 0.5}), SpreadRule::Scales);
    };
    const auto segmentEdit = [&](Document &document, int i) {
        return changeSegments(document, {{id, 1}}, [i](Segment &segment) { segment.density = float(1 + i % 7); });
    };
    measure(QStringLiteral("one segment of a stroke of %1").arg((*longest)->segments.size()), {id}, segmentEdit);
    measure("one stroke moved", {id}, move);
    measure("100 strokes moved", firstStrokes(painting, 100), move);
    measure("one stroke raised", {id}, [](Document &document, int i) {
        return arrangeSelection(document, i % 2 ? Arrange::Raise : Arrange::Lower);
    });
    measure("one stroke painted", {id}, [&](Document &document, int) {
        Stroke stroke = **longest;
        stroke.id = document.takeStrokeId();
        return addStrokes(document, {std::make_shared<const Stroke>(std::move(stroke))}, false);
    });
    return report;
}

} // namespace suffuse

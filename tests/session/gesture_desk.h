// Gestures of each kind without a window, and a desk on which they are made.
#pragma once

#include "app/session/editor.h"
#include "app/session/files/opened_file.h"
#include "tests/undo/random_edits.h"
#include "undo/node_edits.h"

#include <QTemporaryDir>
#include <QTest>

namespace suffuse {

/// Lifts whatever it is asked to, and counts.
class Pictures : public FloatingView {
public:
    explicit Pictures(Editor &editor) : m_editor(editor) { editor.setFloatingView(this); }
    ~Pictures() override { m_editor.setFloatingView(nullptr); }

    void lift(const std::set<StrokeId> &) override { m_from = m_editor.unsettledShown(); }
    void endLift() override { m_from.reset(); }
    bool isLifted() const override { return m_from && m_from == m_editor.unsettledShown(); }
    void showFloating(const Affine &map) override { shown.push_back(map); }
    void settleFloating() override { m_from = m_editor.unsettledShown(), ++settled; }
    bool coversFloating(const Affine &) const override { return covers; }

    std::vector<Affine> shown;
    int settled = 0;
    bool covers = true;

private:
    Editor &m_editor;
    PaintingPtr m_from;
};

/// What a gesture does in its step k; step 0 brings it back to its start.
enum class Kind { Edits, Strokes, Maps, Floats };

inline void showStep(Editor &editor, Gesture &gesture, Kind kind, int k)
{
    if (kind == Kind::Edits)
        gesture.show(changeSegments(editor.document(), {{1, 2}}, [k](Segment &s) { s.density = float(11 + k); }));
    else if (kind == Kind::Strokes)
        gesture.show([k](const Stroke &stroke) { return withNodeMoved(stroke, {1}, {3.0 * k, 5.0 * k}); });
    else
        gesture.floatBy(Affine::translation({4.0 * k, -2.0 * k}), SpreadRule::Scales);
}

/// The painting that is meant by it.
inline Painting expected(const Painting &start, Kind kind, int k)
{
    Painting painting = start;
    for (std::size_t i = 0; i < painting.strokes.size(); ++i) {
        Stroke stroke = *start.strokes[i];
        if (stroke.id > 2 || (kind == Kind::Edits && stroke.id > 1))
            continue;
        if (kind == Kind::Edits)
            stroke.segments[2].density = float(11 + k);
        else if (kind == Kind::Strokes)
            stroke = withNodeMoved(stroke, {1}, {3.0 * k, 5.0 * k});
        else
            stroke = transformed(stroke, Affine::translation({4.0 * k, -2.0 * k}), SpreadRule::Scales);
        painting.strokes[i] = std::make_shared<const Stroke>(stroke);
    }
    return painting;
}

/// An editor with three strokes, a step that is done, one that is saved, and two that are undone.
struct Desk {
    QTemporaryDir folder;
    Editor editor;
    std::optional<Pictures> pictures;
    Painting start, last;
    QStringList steps;

    explicit Desk(Kind kind)
    {
        qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
        editor.document().reset(makePainting(3));
        editor.clock().setManual(true);
        editor.clock().setTime(start.end());
        for (int k = 1; k <= 4; ++k) {
            rename(3, QString::number(k));
            if (k == 2)
                save();
        }
        last = painting();
        editor.undoStack().setIndex(2);
        start = painting();
        for (int i = 0; i < stack().count(); ++i)
            steps << stack().text(i);
        if (kind == Kind::Floats)
            pictures.emplace(editor);
    }
    QUndoStack &stack() { return editor.undoStack(); }
    const Painting &painting() { return *editor.document().painting(); }
    void rename(StrokeId id, const QString &name)
    {
        editor.push(changeStrokes(editor.document(), {id}, [&](Stroke &s) { s.name = name; }), "name " + name);
    }
    void save()
    {
        editor.startSaving(folder.filePath("a.suffuse"), true);
        QTRY_VERIFY(!editor.isSaving());
    }
    Painting saved()
    {
        const Result<OpenedFile> file = readOpenedFile(folder.filePath("a.suffuse"));
        return file ? file->document.painting : Painting();
    }
    Gesture begin(const QString &name = "gesture")
    {
        if (pictures)
            pictures->lift({1, 2});
        Gesture gesture = editor.begin(name);
        gesture.take({1, 2});
        return gesture;
    }
    /// Nothing is left of the gesture, and all that was before it is there.
    void checkUntouched()
    {
        QVERIFY(!editor.isDragging());
        QCOMPARE(painting(), start);
        QStringList now;
        for (int i = 0; i < stack().count(); ++i)
            now << stack().text(i);
        QCOMPARE(now, steps);
        QCOMPARE(stack().index(), 2);
        QVERIFY(!editor.isModified());
        QVERIFY(editor.canRedo());
        editor.redo();
        editor.redo();
        QCOMPARE(painting(), last);
        editor.undo();
        editor.undo();
        QCOMPARE(painting(), start);
        QVERIFY(!editor.isModified());
    }
    /// From here everything is undone, and done again.
    void checkWalk()
    {
        const Painting now = painting();
        const int index = stack().index();
        while (editor.canUndo())
            editor.undo();
        QCOMPARE(painting(), *makePainting(3));
        while (stack().index() < index)
            editor.redo();
        QCOMPARE(painting(), now);
    }
};

/// How many steps a gesture shows.
inline constexpr int steps = 4;

/// The column of tests that go through all kinds.
inline void kinds()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("edits") << Kind::Edits;
    QTest::newRow("strokes") << Kind::Strokes;
    QTest::newRow("maps") << Kind::Maps;
    QTest::newRow("floats") << Kind::Floats;
}

} // namespace suffuse

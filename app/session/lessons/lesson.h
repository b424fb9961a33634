// Short lessons: what to do, step by step, and whether it was done.
#pragma once

#include "app/session/commands/command.h"
#include "model/document/document.h"

#include <QObject>

#include <functional>
#include <vector>

namespace suffuse {

class Editor;

enum class LessonKind { Change, Spread, Layers };
inline constexpr LessonKind lessonKinds[] = {LessonKind::Change, LessonKind::Spread, LessonKind::Layers};

/// What a lesson is about, in a few words.
QString titleOf(LessonKind kind);

/// Where in the window a step is done.
struct LessonPlace {
    enum class Kind { Canvas, Tool, Dock } kind = Kind::Canvas;
    Command tool = Command::Brush; ///< for a tool
    const char *dock = "";         ///< for a dock, its name
};

/// Waits at each step until the painting shows that it was done, however it was done: nobody clicks "Next". It changes
/// nothing itself.
class Lesson : public QObject {
    Q_OBJECT

public:
    Lesson(LessonKind kind, Editor &editor, QObject *parent = nullptr);

    LessonKind kind() const { return m_kind; }
    int count() const { return int(m_steps.size()); }
    /// The step that is to be done, from 0; `count()`: all are done.
    int step() const { return m_step; }
    bool isDone() const { return m_step == count(); }
    /// What is to be done now, as a sentence or two; what was learned, where all is done.
    QString text() const;
    /// Where; the canvas, where all is done.
    LessonPlace place() const;

signals:
    void stepped();

private:
    /// What was there when the step began.
    struct Start {
        PaintingPtr painting;
        GroupId layer = 0;
    };
    struct Step {
        QString text;
        LessonPlace place;
        std::function<bool()> isDone;
    };

    void addChange();
    void addSpread();
    void addLayers();
    void add(const QString &text, const LessonPlace &place, std::function<bool()> isDone);
    void begin();
    void lookSoon();
    void look();
    bool hasNewStroke() const;
    bool hasSelected() const;
    /// A segment or a fill of a selected stroke has another value than when the step began.
    bool differs(const std::function<bool(const Stroke &now, const Stroke &before)> &other) const;

    LessonKind m_kind;
    Editor &m_editor;
    std::vector<Step> m_steps;
    int m_step = 0;
    Start m_start;
    bool m_looks = false; ///< a look is on its way
};

} // namespace suffuse

#include "app/session/lessons/lesson.h"

#include "app/session/current_layer.h"
#include "app/session/editor.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace suffuse {

namespace {

LessonPlace onCanvas()
{
    return {};
}

LessonPlace atTool(Command tool)
{
    return {LessonPlace::Kind::Tool, tool, ""};
}

LessonPlace inDock(const char *dock)
{
    return {LessonPlace::Kind::Dock, Command::Brush, dock};
}

bool hasOtherColour(const Stroke &now, const Stroke &before)
{
    return !std::ranges::equal(now.segments, before.segments, {}, &Segment::colour, &Segment::colour);
}

bool hasOtherDiffusion(const Stroke &now, const Stroke &before)
{
    return !std::ranges::equal(now.segments, before.segments, {}, &Segment::diffusion, &Segment::diffusion);
}

} // namespace

QString titleOf(LessonKind kind)
{
    switch (kind) {
    case LessonKind::Change:
        return Lesson::tr("Paint, and change your mind");
    case LessonKind::Spread:
        return Lesson::tr("Let paint spread");
    case LessonKind::Layers:
        return Lesson::tr("Work with layers");
    }
    return {};
}

Lesson::Lesson(LessonKind kind, Editor &editor, QObject *parent) : QObject(parent), m_kind(kind), m_editor(editor)
{
    switch (kind) {
    case LessonKind::Change:
        addChange();
        break;
    case LessonKind::Spread:
        addSpread();
        break;
    case LessonKind::Layers:
        addLayers();
        break;
    }
    begin();
    const auto soon = [this] { lookSoon(); };
    connect(&editor.document(), &Document::changed, this, soon);
    connect(&editor, &Editor::edited, this, soon);
    connect(&editor.layer(), &CurrentLayer::changed, this, soon);
    connect(&editor.clock(), &PaintingClock::timeChanged, this, soon);
}

/// In the middle of a change nothing may be asked of the editor, and a change of many parts is looked at once.
void Lesson::lookSoon()
{
    if (!std::exchange(m_looks, true))
        QTimer::singleShot(0, this, &Lesson::look);
}

QString Lesson::text() const
{
    return isDone() ? tr("Done. All of this can be changed at any time.") : m_steps[std::size_t(m_step)].text;
}

LessonPlace Lesson::place() const
{
    return isDone() ? LessonPlace{} : m_steps[std::size_t(m_step)].place;
}

void Lesson::add(const QString &text, const LessonPlace &place, std::function<bool()> isDone)
{
    m_steps.push_back({text, place, std::move(isDone)});
}

void Lesson::addChange()
{
    add(tr("Press B and draw a stroke on the sheet, however you like."), onCanvas(), [this] { return hasNewStroke(); });
    add(tr("Press V for the Select tool, and click the paint of your stroke."), atTool(Command::Select),
        [this] { return hasSelected(); });
    add(tr("Choose another colour in the Colour dock. It is now about what is selected."), inDock("colourDock"),
        [this] { return differs(hasOtherColour); });
    add(tr("Take it back with Ctrl+Z."), onCanvas(), [this] { return differs(hasOtherColour); });
}

void Lesson::addSpread()
{
    add(tr("Press B and draw a stroke. Watch it spread after you let go."), onCanvas(),
        [this] { return hasNewStroke(); });
    add(tr("Press D: this goes to the moment when everything is dry."), onCanvas(),
        [this] { return m_editor.clock().time() >= m_editor.document().painting()->end(); });
    add(tr("Press V for the Select tool, and click the paint of your stroke."), atTool(Command::Select),
        [this] { return hasSelected(); });
    add(tr("In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far."),
        inDock("inspectorDock"), [this] { return differs(hasOtherDiffusion); });
}

void Lesson::addLayers()
{
    add(tr("Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it."), inDock("strokesDock"),
        [this] { return m_editor.layer().group() != 0 && m_editor.layer().group() != m_start.layer; });
    add(tr("Press B and draw a stroke. The layer comes into the list with it."), onCanvas(), [this] {
        return m_editor.layer().group() != 0 && !m_editor.layer().isComing() && hasNewStroke();
    });
    add(tr("In the row of the layer, drag its opacity to the left, or click its mode and choose another one."),
        inDock("strokesDock"), [this] {
            return std::ranges::any_of(m_editor.document().painting()->groups, [this](const Group &group) {
                const auto before = std::ranges::find(m_start.painting->groups, group.id, &Group::id);
                return before != m_start.painting->groups.end() &&
                       (before->opacity != group.opacity || before->blend != group.blend);
            });
        });
}

void Lesson::begin()
{
    m_start = {m_editor.document().painting(), m_editor.layer().group()};
}

void Lesson::look()
{
    m_looks = false;
    // What is in the hand is not decided yet: a slider may still be dragged, a stroke drawn.
    if (isDone() || m_editor.undecided() || !m_steps[std::size_t(m_step)].isDone())
        return;
    ++m_step;
    begin();
    emit stepped();
    lookSoon(); // what comes next may be there already
}

bool Lesson::hasNewStroke() const
{
    const Painting &now = *m_editor.document().painting();
    return std::ranges::any_of(now.strokes,
                               [this](const StrokePtr &stroke) { return !m_start.painting->find(stroke->id); });
}

bool Lesson::hasSelected() const
{
    return !m_editor.selection().strokes.empty();
}

bool Lesson::differs(const std::function<bool(const Stroke &, const Stroke &)> &other) const
{
    const Painting &now = *m_editor.document().painting();
    return std::ranges::any_of(now.strokes, [&](const StrokePtr &stroke) {
        const StrokePtr before = m_start.painting->find(stroke->id);
        return before && before != stroke && other(*stroke, *before);
    });
}

} // namespace suffuse

#include "app/session/fitting/refit_task.h"

#include "app/session/editor.h"
#include "render/backends.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace suffuse {

namespace {

struct RefitText {
    Q_DECLARE_TR_FUNCTIONS(RefitTask)
};

/// The error is measured at so many pixels at most, while people wait.
constexpr int pixelsForError = 200'000;

refit::RefitGoal goalOf(const EncodedImage &picture, const QString &place)
{
    refit::RefitGoal goal;
    goal.name = place;
    if (picture)
        goal.picture = *picture;
    return goal;
}

/// How far a painting is from what was wanted, and whether what was there before came nearer; empty where that cannot be
/// drawn.
QString errorOf(const refit::RefitScope &scope, const refit::RefitGoal &goal, const Painting &painting,
                const Rect &area)
{
    const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({.backend = Backend::Cpu});
    if (!renderer)
        return {};
    const refit::RefitPictures pictures(scope, goal, **renderer, pixelsForError);
    const auto apart = pictures.differenceOf(painting, area);
    if (!apart)
        return {};
    const auto number = [](double value, int decimals) { return QLocale().toString(value, 'f', decimals); };
    const QString said = RefitText::tr("There the picture is off by %1 of 255 (root mean square), %2 at most.")
                             .arg(number(apart->rootMeanSquare, 1), number(apart->greatest, 0));
    if (goal.isOwnLook())
        return said;
    const auto before = pictures.differenceOf(scope.painting(), area);
    if (!before || before->rootMeanSquare >= apart->rootMeanSquare)
        return said;
    return said + QLatin1Char(' ') +
           RefitText::tr("That is farther than before, when it was off by %1; Undo brings the former strokes back.")
               .arg(number(before->rootMeanSquare, 1));
}

/// Gives new strokes ids of the document.
void takeIds(Document &document, Painting &painting, const Painting &before)
{
    for (StrokePtr &stroke : painting.strokes)
        if (!before.find(stroke->id)) {
            Stroke copy = *stroke;
            copy.id = document.takeStrokeId();
            stroke = std::make_shared<const Stroke>(std::move(copy));
        }
}

Edit editTo(const Painting &before, const Painting &now)
{
    Edit edit;
    edit.order.emplace();
    edit.selection.emplace();
    for (const StrokePtr &stroke : before.strokes)
        edit.strokes.emplace(stroke->id, nullptr);
    for (const StrokePtr &stroke : now.strokes) {
        edit.order->push_back(stroke->id);
        const auto [at, isNew] = edit.strokes.emplace(stroke->id, stroke);
        if (isNew)
            edit.selection->strokes.insert(stroke->id);
        else
            edit.strokes.erase(at); // It stays as it was.
    }
    if (now.groups != before.groups)
        edit.groups = now.groups;
    return edit;
}

} // namespace

Result<RefitTask> RefitTask::ofSelection(Editor &editor)
{
    std::unordered_set<StrokeId> ids(editor.selection().strokes.begin(), editor.selection().strokes.end());
    for (const SegmentRef &segment : editor.selection().segments)
        ids.insert(segment.stroke);
    Result<refit::RefitScope> scope = refit::RefitScope::of(editor.document().snapshot(), ids);
    if (!scope)
        return Error{scope.error()};
    RefitTask out;
    out.m_scope = std::make_shared<const refit::RefitScope>(std::move(*scope));
    return out;
}

ReadTarget RefitTask::target(EncodedImage picture, const QString &place) const
{
    return [scope = m_scope, goal = goalOf(picture, place)](int pixels, const std::atomic<bool> *cancel) {
        const Result<std::unique_ptr<Renderer>> renderer = makeRenderer({.backend = Backend::Cpu});
        if (!renderer)
            return Result<fitting::FitTarget>(Error{renderer.error()});
        return refit::RefitPictures(*scope, goal, **renderer, pixels, cancel).target();
    };
}

QString RefitTask::apply(Editor &editor, const FitResult &fit, EncodedImage picture, const QString &place) const
{
    const StrokeList strokes = refit::placed(*m_scope, fit.painting);
    Painting now = m_scope->with(strokes);
    takeIds(editor.document(), now, m_scope->painting());
    const QString error = errorOf(*m_scope, goalOf(picture, place), now, refit::areaWith(*m_scope, strokes));
    Edit edit = editTo(m_scope->painting(), now);
    if (!fit.painting.swatches.empty()) {
        edit.swatches = now.swatches;
        edit.swatches->insert(edit.swatches->end(), fit.painting.swatches.begin(), fit.painting.swatches.end());
    }
    editor.push(std::move(edit), RefitText::tr("Fewer strokes"));
    QString said = RefitText::tr("%Ln stroke(s)", nullptr, int(strokes.size())) + QLatin1Char(' ') +
                   RefitText::tr("in place of %Ln.", nullptr, int(count()));
    if (!error.isEmpty())
        said += QLatin1Char(' ') + error;
    if (const std::size_t between = m_scope->between(); between > 0)
        said += QLatin1Char(' ') +
                RefitText::tr("%Ln stroke(s) that lay between them lie below now.", nullptr, int(between));
    return said;
}

} // namespace suffuse

#include "undo/edit_command.h"

#include <algorithm>

namespace suffuse {

namespace {

bool sameStroke(const StrokePtr &a, const StrokePtr &b)
{
    return a == b || (a && b && *a == *b);
}

/// True if the state that an exchanged edit would put in is the one that is there, the selection aside. Compares values.
bool changesNothing(const Edit &edit, const Painting &painting)
{
    if (edit.places && !edit.places->empty())
        return false;
    if (edit.canvas && *edit.canvas != painting.canvas)
        return false;
    if (edit.groups && *edit.groups != painting.groups)
        return false;
    if (edit.swatches && *edit.swatches != painting.swatches)
        return false;
    if (edit.underlay) {
        const Underlay *a = edit.underlay->get(), *b = painting.underlay.get();
        if (a != b && (!a || !b || !(*a == *b)))
            return false;
    }
    if (edit.strokes.empty())
        return true;
    std::size_t found = 0;
    for (const StrokePtr &stroke : painting.strokes) {
        const auto it = edit.strokes.find(stroke->id);
        if (it == edit.strokes.end())
            continue;
        if (!sameStroke(it->second, stroke))
            return false; // soon, of many that are dragged
        ++found;
    }
    const auto comes = [](const auto &entry) { return bool(entry.second); };
    return std::size_t(std::count_if(edit.strokes.begin(), edit.strokes.end(), comes)) == found;
}

/// Both in order, so that the usual case, a drag of the same strokes, costs one pass.
bool holdsAllOf(const std::map<StrokeId, StrokePtr> &older, const std::map<StrokeId, StrokePtr> &newer)
{
    return std::includes(older.begin(), older.end(), newer.begin(), newer.end(),
                         [](const auto &a, const auto &b) { return a.first < b.first; });
}

/// Keeps the older state of each part.
template <typename T>
void keepOldest(std::optional<T> &older, const std::optional<T> &newer)
{
    if (!older)
        older = newer;
}

} // namespace

EditRun beginEditRun()
{
    static EditRun last = 0;
    return ++last;
}

EditCommand::EditCommand(Document &document, Edit edit, const QString &text, EditRun run)
    : QUndoCommand(text), m_document(document), m_edit(std::make_shared<Edit>(std::move(edit))), m_run(run)
{}

EditCommand::EditCommand(Document &document, std::shared_ptr<Edit> edit, const QString &text)
    : QUndoCommand(text), m_document(document), m_edit(std::move(edit)), m_run(0)
{}

void EditCommand::redo()
{
    const bool isFirst = !m_done;
    // Undo brings the selection back too, whether the edit altered it or not.
    if (!m_edit->selection)
        m_edit->selection = m_document.selection();
    m_document.exchange(*m_edit);
    m_done = true;
    if (isFirst && changesNothing(*m_edit, *m_document.painting()))
        setObsolete(true);
}

void EditCommand::undo()
{
    m_document.exchange(*m_edit);
    if (m_givenUp)
        setObsolete(true);
}

int EditCommand::id() const
{
    return m_run == 0 ? -1 : m_run;
}

bool EditCommand::mergeWith(const QUndoCommand *other)
{
    const auto *newer = dynamic_cast<const EditCommand *>(other);
    if (!newer || m_run == 0 || newer->m_run != m_run || &newer->m_document != &m_document)
        return false;
    if (newer->m_edit->places) {
        const std::vector<StrokeId> now = orderOf(*m_document.painting());
        m_edit->places = orderDifference(now, orderWanted(*m_edit, orderWanted(*newer->m_edit, now)));
    }
    if (!holdsAllOf(m_edit->strokes, newer->m_edit->strokes))
        m_edit->strokes.insert(newer->m_edit->strokes.begin(), newer->m_edit->strokes.end());
    keepOldest(m_edit->canvas, newer->m_edit->canvas);
    keepOldest(m_edit->groups, newer->m_edit->groups);
    keepOldest(m_edit->swatches, newer->m_edit->swatches);
    keepOldest(m_edit->underlay, newer->m_edit->underlay);
    keepOldest(m_edit->selection, newer->m_edit->selection);
    setObsolete(changesNothing(*m_edit, *m_document.painting()));
    return true;
}

} // namespace suffuse

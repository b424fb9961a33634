#include "app/session/editor.h"

#include "app/session/colour/colour_target.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/files/opened_file.h"
#include "app/session/files/samples.h"
#include "app/session/gesture_state.h"
#include "app/session/settings/settings.h"
#include "model/formats/messages.h"
#include "model/formats/picture_links.h"
#include "model/painting/paper_presets.h"
#include "model/painting/resolution.h"
#include "undo/history/kept_history.h"
#include "undo/history/restore_edit.h"
#include "undo/lettering/text_layout.h"
#include "undo/text_edits.h"
#include "undo/text_links.h"
#include "undo/time_edits.h"

#include <QDir>
#include <QFileInfo>
#include <QScopedValueRollback>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int stepPauseMs = 120; ///< steps that come no later are taken for a hand that moves

bool canBeSavedAs(FileFormat format)
{
    return format == FileFormat::Suffuse || format == FileFormat::Text;
}

/// More than what is selected, and than the stroke in hand.
bool altersPainting(const Change &change)
{
    return change.order || change.canvas || change.texts || change.reset || !change.strokes.empty();
}

/// The moment by which all segments of these strokes are born.
Microseconds latestBirth(const Painting &painting, const std::vector<StrokeId> &strokes)
{
    Microseconds latest = 0;
    for (const StrokeId id : strokes)
        if (const StrokePtr stroke = painting.find(id))
            for (const Segment &segment : stroke->segments)
                latest = std::max(latest, segment.born);
    return latest;
}

QString recoveredPattern()
{
    //: name of a document that was brought back after a crash
    return Editor::tr("%1 (recovered)");
}

} // namespace

Editor::Editor(QObject *parent) : QObject(parent), m_brush(builtinBrushes().front())
{
    connect(&m_undoStack, &QUndoStack::indexChanged, this, &Editor::followStack);
    connect(&m_saver, &Saver::finished, this, &Editor::noteSaved);
    connect(&m_gestures, &GestureDesk::openChanged, &m_laterChanges, &LaterChanges::setGestureOpen);
    connect(&m_gestures, &GestureDesk::movingEnded, this, &Editor::dragEnded);
    connect(&m_gestures, &GestureDesk::undecidedChanged, this, &Editor::tellModified);
    connect(&m_gestures, &GestureDesk::restTold, this, &Editor::edited);
    connect(&m_document, &Document::changed, this, &Editor::followDocument);
    m_colourTarget = std::make_unique<ColourTarget>(*this);
    m_layer = std::make_unique<CurrentLayer>(m_document, m_clock);
    m_aids = std::make_unique<DrawingAids>();
    m_layout = std::make_unique<TextLayout>();
    connect(&m_clock, &PaintingClock::timeChanged, this, &Editor::settle); // what floats is of one moment
}

Editor::~Editor()
{
    m_undoStack.disconnect(this); // one that goes tells of it
}

void Editor::followStack()
{
    if (m_takesUpSteps) {
        m_layer->forgetSteps(m_undoStack.index());
    } else {
        m_layer->walkTo(m_undoStack.index());
        emit edited();
    }
    m_savedStep.follow();
    tellModified();
}

void Editor::tellModified()
{
    if (isModified() != m_wasModified)
        tellFileChanged();
}

void Editor::followDocument(const Change &change)
{
    setCompared(nullptr);
    if (change.selection)
        ++m_selection;
    if (change.draft || change.reset)
        m_clock.setDraftEnd(m_document.draft() ? m_document.draft()->driesAt() : 0);
    if (!altersPainting(change))
        return;
    const Painting &painting = *m_document.painting();
    m_driesAt.follow(painting.strokes, [](const Stroke &stroke) { return stroke.driesAt(); });
    const Microseconds end = painting.strokes.empty() ? 0 : *std::ranges::max_element(m_driesAt);
    m_clock.setEnd(end);
    // Who looks at all goes on seeing all, also what was moved to later.
    if (!m_clock.isInPast() && !m_clock.isDrawing() && m_clock.time() < end)
        m_clock.runFrom(latestBirth(painting, change.strokes));
}

Gesture Editor::begin(const QString &name, GestureSteps *steps)
{
    return Gesture(m_gestures.begin(name, steps));
}

GestureSteps *Editor::stepsInHand(bool back) const
{
    GestureSteps *steps = m_gestures.open() ? m_gestures.open()->steps() : nullptr;
    return steps && steps->canStep(back) ? steps : nullptr;
}

bool Editor::isStepping() const
{
    return m_sinceStep.isValid() && m_sinceStep.elapsed() < stepPauseMs;
}

Edit Editor::placed(Edit edit)
{
    completeTexts(*m_document.painting(), edit, [this](const Text &text) { return m_layout->lay(text); });
    m_layer->takeEmptied(edit);
    if (!m_clock.isInPast())
        return edit;
    edit = placedInTime(m_document, std::move(edit));
    noteDrawn(edit);
    return edit;
}

void Editor::noteComing(const Edit &edit)
{
    const bool driesLater = std::ranges::any_of(
        edit.strokes, [end = m_clock.end()](const auto &put) { return put.second && put.second->driesAt() > end; });
    if (driesLater)
        m_clock.forgetUndone();
}

void Editor::push(Edit edit, const QString &text, ValueEntry *entry)
{
    if (edit.isEmpty())
        return;
    if (entry && entry->m_drags) {
        if (!entry->m_gesture.isOpen())
            entry->m_gesture = begin(text);
        entry->m_gesture.show(std::move(edit));
        return;
    }
    commit();
    edit = placed(std::move(edit));
    noteComing(edit);
    if (entry && goesOn(*entry)) {
        m_sinceStep.start();
        goOnWithStep(m_undoStack, m_document, std::move(edit));
        entry->m_selection = m_selection;
        return;
    }
    std::optional<Edit> back = doEdit(m_document, std::move(edit));
    if (!back)
        return;
    pushDone(std::move(*back), text);
    if (!entry)
        return;
    entry->m_step = static_cast<const EditCommand *>(m_undoStack.command(m_undoStack.index() - 1))->sharedEdit();
    entry->m_selection = m_selection;
}

/// Whether the entry's step is the last one and is in no file. What a key or a wheel steps must be what is selected
/// now.
bool Editor::goesOn(const ValueEntry &entry) const
{
    const std::shared_ptr<Edit> step = entry.m_step.lock();
    const auto *last = dynamic_cast<const EditCommand *>(m_undoStack.command(m_undoStack.index() - 1));
    return step && last && last->sharedEdit() == step &&
           (!entry.m_sinceStep.isValid() || entry.m_selection == m_selection) && !m_undoStack.canRedo() &&
           !m_undoStack.isClean() && !m_savedStep.isNow();
}

/// What was done becomes a step.
void Editor::pushDone(Edit back, const QString &text)
{
    m_savedStep.willPush();
    m_layer->stepComes(m_undoStack.index());
    auto *step = new EditCommand(m_document, std::move(back), text);
    step->keepSelection();
    m_undoStack.push(step);
}

QString Editor::undoText() const
{
    return undecided() ? m_gestures.open()->name() : m_undoStack.undoText();
}

QString Editor::redoText() const
{
    if (stepsInHand(false))
        return m_gestures.open()->name();
    return undecided() ? QString() : m_undoStack.redoText();
}

void Editor::undo()
{
    if (GestureSteps *steps = stepsInHand(true))
        return steps->step(true);
    commitChanges();
    m_undoStack.undo();
}

void Editor::redo()
{
    if (GestureSteps *steps = stepsInHand(false))
        return steps->step(false);
    commitChanges();
    m_undoStack.redo();
}

/// Commits what is in hand, and the changes within it one by one, also those that were taken back and can be redone.
/// Where it is back at its start by itself, steps that could be redone before it began still can be.
void Editor::commitChanges()
{
    GestureSteps *steps = m_gestures.open() ? m_gestures.open()->steps() : nullptr;
    if (!steps || (!undecided() && !steps->canStep(false) && m_undoStack.canRedo()))
        return commit();
    const auto commitOne = [this] {
        const int before = m_undoStack.index();
        commit();
        return m_undoStack.index() > before;
    };
    steps->handOver(commitOne, [this] { m_undoStack.undo(); });
}

void Editor::setBrush(const Brush &brush)
{
    if (brush == m_brush)
        return;
    m_brush = brush;
    emit brushChanged();
}

void Editor::setColour(const Colour &colour)
{
    Brush brush = m_brush;
    brush.colour = colour;
    setBrush(brush);
}

void Editor::setCompared(PaintingPtr painting)
{
    if (painting == m_compared)
        return;
    m_compared = std::move(painting);
    emit comparedChanged();
}

void Editor::setFinalShown(bool shown)
{
    if (shown == m_finalShown)
        return;
    m_finalShown = shown;
    emit comparedChanged();
}

PaintingPtr Editor::shown()
{
    settle();
    return unsettledShown();
}

PaintingPtr Editor::unsettledShown() const
{
    if (m_compared)
        return m_compared;
    PaintingPtr painting = snapshotInTime();
    return m_finalShown ? m_finalPreview.of(painting, m_clock.time()) : painting;
}

PaintingPtr Editor::snapshotInTime() const
{
    const bool isOnTop = m_layer->isTop() && !m_clock.isInPast();
    return !m_document.draft() || isOnTop ? m_document.snapshot() : m_layer->withDraft();
}

void Editor::noteDrawn(const Edit &edit)
{
    if (!m_clock.isDrawing()) { // Letters are there at once, and are seen when they have spread.
        for (const auto &[id, stroke] : edit.strokes)
            if (stroke && !m_document.painting()->find(id) && stroke->born() >= m_clock.time())
                m_clock.runUntil(stroke->driesAt());
        return;
    }
    for (const auto &[id, stroke] : edit.strokes)
        if (stroke)
            for (const Segment &segment : stroke->segments)
                m_clock.noteDrawn(segment);
}

QString Editor::displayName() const
{
    const QString own = ownName(), name = own.isEmpty() ? tr("Untitled") : own;
    return m_isRecovered && m_filePath.isEmpty() ? recoveredPattern().arg(name) : name;
}

QString Editor::ownName() const
{
    return m_filePath.isEmpty() ? m_untitledName : QFileInfo(m_filePath).fileName();
}

Canvas Editor::usualCanvas()
{
    Canvas canvas;
    canvas.paper = paperOf(paperPresets()[1]);
    return canvas;
}

double Editor::resolution() const
{
    return isResolution(m_extras.resolution) ? m_extras.resolution : usualResolution;
}

void Editor::newPainting(const Canvas &canvas, double resolution)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas = canvas;
    m_extras = {};
    m_extras.resolution = resolution;
    show(std::move(painting), {});
}

Result<std::vector<QString>> Editor::open(const QString &path)
{
    Result<OpenedFile> file = readOpenedFile(path);
    if (!file)
        return Error{file.error()};
    return open(std::move(*file));
}

std::vector<QString> Editor::open(OpenedFile file)
{
    LoadedDocument &document = file.document;
    const QString said = joinedSentences({document.leftOut, document.missing});
    m_extras = std::move(document.extras);
    const QByteArray history = std::exchange(m_extras.history, {});
    const bool damaged = !document.losses.empty();
    Origin origin;
    if (damaged)
        origin = {{}, QFileInfo(file.path).fileName(), file.path, {}, said, true, true};
    else if (file.isSample)
        origin = {{}, sampleTitle(file.path), {}, {}, said};
    else if (canBeSavedAs(document.format))
        origin = {file.path, {}, file.path, file.hash, said};
    else { // A drawing or a recording: the painting of it has its name, and would lie beside it.
        const QFileInfo drawn(file.path);
        origin.name = drawn.completeBaseName();
        origin.suggestedPath = drawn.dir().filePath(origin.name + QStringLiteral(".suffuse"));
        origin.leftOut = said;
    }
    show(std::make_shared<const Painting>(std::move(document.painting)), origin);
    takeUpHistory(history, damaged);
    return std::move(document.losses);
}

void Editor::takeUpHistory(const QByteArray &bytes, bool modified)
{
    if (bytes.isEmpty())
        return;
    Result<UndoHistory> history = readHistory(bytes, *m_document.painting());
    if (!history) {
        m_leftOut = joinedSentences({history.error(), m_leftOut});
        return;
    }
    for (HistoryStep &step : history->steps)
        for (auto &[id, stroke] : step.edit.strokes)
            readLink(stroke, QFileInfo(m_filePath).absolutePath());
    {
        const QScopedValueRollback takesUp(m_takesUpSteps, true);
        restoreHistory(m_undoStack, m_document, *history);
    }
    m_savedStep.set(!modified);
    m_keepsHistory = m_historyIsSaved = true;
    m_historyBytes = bytes.size();
    tellFileChanged();
}

bool Editor::isModified() const
{
    const bool historyDiffers = m_keepsHistory != m_historyIsSaved && m_undoStack.count() > 0;
    return undecided() || !m_savedStep.isNow() || historyDiffers || m_savedStep.isSaving();
}

void Editor::setKeepsHistory(bool keeps)
{
    if (keeps == m_keepsHistory)
        return;
    m_keepsHistory = keeps;
    tellFileChanged();
}

void Editor::openRecovered(Painting painting, const QString &name, const QString &suggestedPath, double resolution)
{
    m_extras = {};
    m_extras.resolution = resolution;
    const QString added = recoveredPattern().section(QStringLiteral("%1"), 1); // journals of earlier versions have it
    const QString own = name.endsWith(added) ? name.chopped(added.size()) : name;
    const QString folder = QFileInfo(suggestedPath).absolutePath();
    painting = withAbsoluteLinks(std::move(painting), folder);
    const QString missing = readLinks(painting, folder); // Journals do not have the images of linked pictures.
    show(std::make_shared<const Painting>(std::move(painting)), {{}, own, suggestedPath, {}, missing, true, true});
}

SaveOrder Editor::orderFor(const QString &path)
{
    SaveOrder order{m_document.painting(), m_extras, path, {}, settings::backups()};
    order.serial = ++m_lastSave;
    if (m_keepsHistory)
        order.history = historyOf(m_undoStack);
    return order;
}

void Editor::startSaving(const QString &path, bool whatever)
{
    commitChanges();
    SaveOrder order = orderFor(path);
    if (!whatever && QFileInfo(path).absoluteFilePath() == m_filePath) {
        order.expected = m_fileHash;
        order.isThere = !isModified() && m_leftOut.isEmpty(); // a file with damage is mended
    }
    m_savedStep.savingBegins(order.serial);
    m_saver.save(std::move(order));
    tellFileChanged();
}

void Editor::startSavingCopy(const QString &path)
{
    commitChanges();
    SaveOrder order = orderFor(path);
    order.isCopy = true;
    m_saver.save(std::move(order));
}

void Editor::noteSaved(const SaveOutcome &outcome)
{
    // Without a step it is a copy, or of a painting that is not here any more.
    if (m_savedStep.savingEnds(outcome.serial, outcome.isSaved())) {
        if (outcome.isSaved()) {
            m_filePath = m_suggestedPath = outcome.path;
            m_fileHash = outcome.hash;
        }
        if (outcome.isSaved() && !outcome.wasThere) {
            m_historyBytes = outcome.historyBytes;
            m_historyIsSaved = outcome.withHistory;
            m_leftOut.clear();
        }
        if (outcome.kind == SaveOutcome::Kind::ChangedOutside && !m_savedStep.isSaving())
            m_savedStep.set(false); // the file that had it is another one now
        tellFileChanged();
    }
    emit saved(outcome);
}

void Editor::tellFileChanged()
{
    m_wasModified = isModified();
    emit fileChanged();
}

void Editor::restore(const Painting &loaded, const QString &text)
{
    const QString folder = QFileInfo(m_filePath).absolutePath(); // A backup lies elsewhere.
    Painting state = withAbsoluteLinks(loaded, folder);
    readLinks(state, folder);
    m_clock.lookAt(m_document.painting()->end()); // in the past an edit would be put to its place in time
    push(restorePainting(m_document, state), text);
    m_clock.reset(m_document.painting()->end());
    emit m_clock.timeChanged();
}

Result<void> Editor::revert()
{
    Result<OpenedFile> file = readOpenedFile(m_filePath);
    if (!file)
        return Error{file.error()};
    LoadedDocument &document = file->document;
    if (!document.losses.empty())
        return fileError(m_filePath, tr("is damaged, so the painting stays as it is; save it, or open the file to see "
                                        "what is whole of it"));
    restore(document.painting, tr("Revert"));
    m_extras = std::move(document.extras);
    m_historyBytes = std::exchange(m_extras.history, {}).size();
    m_keepsHistory = m_historyIsSaved = m_historyBytes > 0;
    m_leftOut = joinedSentences({document.leftOut, document.missing});
    m_fileHash = file->hash;
    m_savedStep.set(true);
    tellFileChanged();
    return {};
}

void Editor::keepMine(const QByteArray &hashOnDisk)
{
    m_fileHash = hashOnDisk;
    m_savedStep.set(false);
    tellFileChanged();
}

void Editor::show(PaintingPtr painting, const Origin &origin)
{
    commit(); // whoever holds a gesture shows nothing more of it
    m_clock.reset(painting->end());
    {
        const QScopedValueRollback letsGo(m_takesUpSteps, true);
        m_undoStack.clear(); // its commands name strokes of the painting that goes
    }
    m_savedStep.set(!origin.modified);
    m_filePath = origin.path;
    m_untitledName = origin.name;
    m_isRecovered = origin.recovered;
    m_suggestedPath = origin.suggestedPath;
    m_fileHash = origin.hash;
    m_keepsHistory = m_historyIsSaved = false;
    m_historyBytes = 0;
    m_leftOut = origin.leftOut;
    m_aids->reset(painting->canvas.area());
    m_document.reset(std::move(painting)); // whoever hears of it knows at once which file it is of
    emit opened();
    emit m_clock.timeChanged();
    tellFileChanged();
}

} // namespace suffuse

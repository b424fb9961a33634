#include "app/editor.h"

#include "model/formats/files.h"
#include "model/paper_presets.h"
#include "undo/time_edits.h"

#include <QFile>
#include <QFileInfo>
#include <QTimerEvent>

namespace suffuse {

namespace {

constexpr int tickMs = 16;
constexpr int dragPauseMs = 120; // without an edit of the run
/// Enough of a file to tell its format.
constexpr qint64 headBytes = 64 * 1024;

bool canBeSavedAs(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return false;
    const FileFormat format = detectFormat(file.read(headBytes));
    return format == FileFormat::Suffuse || format == FileFormat::Text;
}

} // namespace

Editor::Editor(QObject *parent) : QObject(parent), m_brush(builtinBrushes().front())
{
    m_dragEnd.setSingleShot(true);
    m_dragEnd.setInterval(dragPauseMs);
    connect(&m_dragEnd, &QTimer::timeout, this, &Editor::dragEnded);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &Editor::fileChanged);
    connect(&m_document, &Document::changed, this, [this](const Change &) {
        setCompared(nullptr);
        const Microseconds now = time();
        m_end = m_document.painting()->end();
        if (m_inPast && !m_drawing && now >= m_end)
            setInPast(false);
        if (!m_inPast && m_end > now)
            startClock();
    });
}

void Editor::push(Edit edit, const QString &text, EditRun run)
{
    if (edit.isEmpty())
        return;
    if (run != 0)
        m_dragEnd.start();
    if (m_inPast) {
        edit = placedInTime(m_document, std::move(edit));
        noteDrawn(edit);
    }
    m_undoStack.push(new EditCommand(m_document, std::move(edit), text, run));
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

Microseconds Editor::time() const
{
    if (!m_running || m_manual)
        return m_time;
    const Microseconds now = m_time + m_since.nsecsElapsed() / 1000;
    // The end is where a reopened file stands: stopping right there makes both the same picture.
    return m_drawing ? now : std::min(now, std::max(m_time, runsUntil()));
}

void Editor::setFinalShown(bool shown)
{
    if (shown == m_finalShown)
        return;
    m_finalShown = shown;
    emit comparedChanged();
}

PaintingPtr Editor::shown() const
{
    if (m_compared)
        return m_compared;
    PaintingPtr painting = snapshotInTime();
    return m_finalShown ? m_finalPreview.of(painting, time()) : painting;
}

PaintingPtr Editor::snapshotInTime() const
{
    const StrokePtr &draft = m_document.draft();
    if (!draft || !m_inPast)
        return m_document.snapshot();
    auto painting = std::make_shared<Painting>(*m_document.painting());
    const PlaceInTime place = placeInTime(*painting, draft->born());
    painting->strokes.insert(std::as_const(painting->strokes).begin() + std::ptrdiff_t(place.index), draft);
    return painting;
}

void Editor::noteDrawn(const Edit &edit)
{
    if (!m_drawing)
        return;
    for (const auto &[id, stroke] : edit.strokes) {
        if (!stroke)
            continue;
        for (const Segment &segment : stroke->segments)
            if (segment.born >= m_drawnSince)
                m_dryAt = std::max(m_dryAt, segment.driesAt());
    }
}

void Editor::holdClock(bool drawing)
{
    m_time = time();
    m_since.start();
    m_drawing = drawing;
    if (drawing)
        m_drawnSince = m_dryAt = m_time;
    startClock();
}

void Editor::lookAt(Microseconds time)
{
    if (m_drawing)
        return;
    stopClock();
    m_time = m_dryAt = std::min(time, m_end);
    setInPast(m_time < m_end);
    emit timeChanged();
}

void Editor::setInPast(bool past)
{
    if (past == m_inPast)
        return;
    m_inPast = past;
    emit pastChanged();
}

void Editor::setTime(Microseconds time)
{
    if (!m_drawing)
        setInPast(false);
    m_time = time;
    m_since.start();
    startClock();
    tick();
}

void Editor::setManualClock(bool manual)
{
    m_time = time();
    m_since.start();
    m_manual = manual;
}

void Editor::timerEvent(QTimerEvent *event)
{
    if (event->timerId() == m_timer.timerId())
        tick();
}

void Editor::tick()
{
    if (!m_drawing && time() >= runsUntil()) {
        stopClock();
        if (m_time >= m_end)
            setInPast(false);
    }
    emit timeChanged();
}

void Editor::startClock()
{
    if (m_running)
        return;
    m_running = true;
    m_since.start();
    m_timer.start(tickMs, Qt::PreciseTimer, this);
}

void Editor::stopClock()
{
    m_time = time();
    m_running = false;
    m_timer.stop();
}

QString Editor::displayName() const
{
    return m_filePath.isEmpty() ? tr("Untitled") : QFileInfo(m_filePath).fileName();
}

Canvas Editor::usualCanvas()
{
    Canvas canvas;
    canvas.paper = paperOf(paperPresets()[1]);
    return canvas;
}

void Editor::newPainting(const Canvas &canvas)
{
    auto painting = std::make_shared<Painting>();
    painting->canvas = canvas;
    show(std::move(painting), {});
}

Result<void> Editor::open(const QString &path)
{
    Result<Painting> painting = loadPainting(path);
    if (!painting)
        return Error{painting.error()};
    show(std::make_shared<const Painting>(std::move(*painting)),
         canBeSavedAs(path) ? QFileInfo(path).absoluteFilePath() : QString());
    return {};
}

Result<void> Editor::save(const QString &path)
{
    if (Result<void> saved = savePainting(*m_document.painting(), path); !saved)
        return saved;
    m_filePath = QFileInfo(path).absoluteFilePath();
    m_undoStack.setClean();
    emit fileChanged();
    return {};
}

void Editor::show(PaintingPtr painting, const QString &path)
{
    m_drawing = false;
    setInPast(false);
    m_time = painting->end();
    m_since.start();
    m_undoStack.clear(); // its commands name strokes of the painting that goes
    m_document.reset(std::move(painting));
    m_filePath = path;
    stopClock();
    emit timeChanged();
    emit fileChanged();
}

} // namespace suffuse

#include "app/canvas/canvas_widget.h"

#include "app/canvas/handles/guide_handle.h"
#include "app/canvas/handles/symmetry_handle.h"
#include "app/canvas/input/layer_note.h"
#include "app/session/colour_convert.h"
#include "app/session/current_layer.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/selecting/seen_selection.h"
#include "app/session/settings/renderer_options.h"

#include <QEvent>
#include <QGuiApplication>
#include <QInputMethod>
#include <QKeyEvent>
#include <QPainter>
#include <QScopeGuard>
#include <QTabletEvent>
#include <QWheelEvent>
#include <QWindow>

#include <utility>

namespace suffuse {

namespace {

constexpr double fitMargin = 24;    ///< logical pixels around the canvas
constexpr double followMargin = 60; ///< logical pixels around what the view follows

} // namespace

CanvasWidget::CanvasWidget(Editor &editor, QWidget *parent, MakeRenderer make, CanvasUse use)
    : QWidget(parent), m_editor(editor), m_use(use), m_worker(settings::rendererOptions(), std::move(make)),
      m_input(*this, m_view, m_handles, editor.clock()), m_selected(editor),
      m_repaint(*this, editor, m_view, m_selected, [this] { return tool() ? tool()->paintMargin() : 0.0; })
{
    setObjectName("canvas");
    setAccessibleName(tr("Canvas"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setTabletTracking(true);
    setMinimumSize(160, 120);
    setAttribute(Qt::WA_AcceptTouchEvents);
    m_overlay.readPalette(palette());
    m_screenColours.read(*this);
    m_presenter = makePresenter(*this, this);
    m_repaint.setPresenter(m_presenter);
    connect(&m_view, &CanvasView::moved, this, &CanvasWidget::viewMoved);
    connectInput();
    if (use == CanvasUse::Work) {
        addHandles();
    } else {
        m_input.setLooksOnly();
        CanvasAids aids = m_overlay.aids();
        aids.showOutlines = false;
        m_overlay.setAids(aids);
    }
    connect(&m_worker, &FrameThread::frameReady, this, &CanvasWidget::frameReady);
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &CanvasWidget::scheduleRender);
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &CanvasWidget::followMoment);
    connect(&editor, &Editor::dragEnded, this, &CanvasWidget::endDrag);
    connect(&editor, &Editor::comparedChanged, this, &CanvasWidget::scheduleRender);
    // The canvas may have become bare, or is no longer bare.
    connect(&editor, &Editor::comparedChanged, this, [this] { updateOverlay(); });
    connect(&editor.document(), &Document::changed, this, &CanvasWidget::follow);
    connect(&note(), &CanvasNote::changed, this, [this] { updateOverlay(); });
    connect(&editor.layer(), &CurrentLayer::noted, &note(), &CanvasNote::show);
    connect(&m_underlay, &UnderlayLoader::loaded, this, [this] { updateOverlay(); });
    connect(&m_underlay, &UnderlayLoader::failed, this, &CanvasWidget::underlayFailed);
    wantUnderlay();
    if (use == CanvasUse::Work)
        connect(&m_worker, &FrameThread::handRests, this, &CanvasWidget::handRests);
}

void CanvasWidget::connectInput()
{
    connect(&m_input.hand(), &Hand::moved, this, &CanvasWidget::pointerMoved);
    auto *note = new LayerNote(m_editor, m_input.hand(), this);
    const auto slack = [this, note] { note->setTolerance(3 * devicePixelRatioF() / view().scale); };
    connect(this, &CanvasWidget::viewChanged, note, slack);
    slack();
    connect(&m_input.hand(), &Hand::asked, this, &CanvasWidget::asked);
    connect(&m_input, &CanvasInput::pointerLeft, this, &CanvasWidget::pointerLeft);
    connect(&m_input, &CanvasInput::penTurned, this, &CanvasWidget::penTurned);
    connect(&m_input, &CanvasInput::modifiersChanged, this, &CanvasWidget::modifiersChanged);
    connect(&m_input, &CanvasInput::busyChanged, this, &CanvasWidget::busyChanged);
    connect(&m_input, &CanvasInput::cursorChanged, this, &CanvasWidget::refreshCursor);
    connect(&m_input, &CanvasInput::overlayChanged, this, [this] { updateOverlay(); });
    connect(&m_input, &CanvasInput::fitWanted, this, &CanvasWidget::fit);
}

void CanvasWidget::addHandles()
{
    const auto dpr = [this] { return devicePixelRatioF(); };
    m_handles.add(std::make_unique<SymmetryHandle>(
        m_editor.aids(), m_view, [this] { return aids().showSymmetry && !isBare(); }, dpr));
    m_handles.add(std::make_unique<GuideHandle>(
        m_editor.aids(), m_view,
        GuideHandle::Surroundings{[this] { return aids(); }, [this] { return rulerUnit(); },
                                  [this] { return isBare(); },
                                  [this](Point pixel) { return tool() && tool()->leavesToGuides(pixel); }, dpr,
                                  [this](int guide) { emit guideAsked(guide); }}));
    connect(&m_editor.aids(), &DrawingAids::aboutToReset, this, [this] { m_handles.cancel(); });
    connect(&m_editor.aids(), &DrawingAids::changed, this, [this] { updateOverlay(); });
}

RulerUnit CanvasWidget::rulerUnit() const
{
    return m_overlay.rulerUnit();
}

CanvasWidget::~CanvasWidget()
{
    tellShown(false);
    m_editor.disconnect(this); // The tools are destroyed later, and give up then what they have in hand.
    m_editor.document().disconnect(this);
    m_editor.clock().disconnect(this);
    delete m_presenter->widget(); // The presenter draws what this object holds, so it must go first.
}

void CanvasWidget::follow(const Change &change)
{
    m_selected.noteChange();
    if (change.selection || change.draft || change.reset)
        revealSelection(change.selection && !change.draft && !m_editor.selection().isEmpty());
    if (change.reset) {
        m_input.hand().cancel();
        fit();
    }
    if (change.canvas || change.reset)
        wantUnderlay();
    const bool altersFrame = change.texts && !m_editor.selection().isEmpty(); // around a text that is selected
    if (change.canvas || change.reset || altersFrame || m_overlay.followsPaint())
        updateOverlay();
    else if (change.selection || !m_editor.selection().isEmpty())
        m_repaint.follow(change);
    if (change.selection)
        m_worker.setCoarseWanted(wantsCoarse());
    if (change.selection && change.strokes.empty()) // No frame comes for a change of the selection alone.
        m_repaint.flush();
    if (!change.strokes.empty() || change.order || change.canvas || change.texts || change.draft || change.reset)
        scheduleRender(); // A selection is in no picture.
}

void CanvasWidget::followMoment()
{
    if (m_overlay.changesUntil(m_editor.clock().time()))
        updateOverlay();
    if (!m_selected.followMoment())
        return;
    emit begunChanged();
    updateSelection();
}

QRect CanvasWidget::selectionOnScreen() const
{
    const QRect visible = m_selected.curvesInView(view(), rect(), devicePixelRatioF());
    return visible.isEmpty() ? QRect() : visible.translated(mapToGlobal(QPoint()));
}

void CanvasWidget::endDrag()
{
    m_repaint.endDrag();
    scheduleRender();
}

void CanvasWidget::frameReady(const FrameInfo &frame)
{
    if (frame.backendText != m_backendText || frame.notice != m_rendererNotice) {
        m_backendText = frame.backendText;
        m_rendererNotice = frame.notice;
        emit backendChanged();
    }
    if (frame.error.isEmpty()) {
        m_repaint.flushWaiting();
        if (frame.isExact())
            m_lift.exactShown();
        if (frame.view == view() && !frame.floats)
            m_repaint.tiles(frame.stats.dirty);
        else
            updateOverlay();
    }
    emit framePresented(frame);
}

bool CanvasWidget::wantsCoarse() const
{
    return !m_editor.selection().isEmpty() || (tool() && tool()->changesAnything());
}

void CanvasWidget::setTool(Tool *next)
{
    if (next == tool())
        return;
    if (tool())
        disconnect(tool(), nullptr, this, nullptr);
    m_input.hand().setTool(next);
    m_overlay.reveal(false); // All of the overlay is painted anew below.
    if (next)
        connect(next, &Tool::typingChanged, this, &CanvasWidget::followTyping);
    if (next)
        connect(next, &Tool::asideChanged, this, [this] {
            refreshCursor();
            m_input.noteBusy();
        });
    followTyping();
    if (next)
        m_editor.colourTarget().useTool(next->colourUse());
    m_worker.setCoarseWanted(wantsCoarse());
    refreshCursor();
    updateOverlay();
    emit toolChanged();
    m_input.noteBusy();
}

void CanvasWidget::followTyping()
{
    const bool types = tool() && tool()->takesText();
    if (types != testAttribute(Qt::WA_InputMethodEnabled))
        setAttribute(Qt::WA_InputMethodEnabled, types);
    if (types)
        QGuiApplication::inputMethod()->update(Qt::ImQueryInput);
}

void CanvasWidget::inputMethodEvent(QInputMethodEvent *event)
{
    if (tool() && tool()->takesText())
        tool()->inputMethod(*event);
    event->accept();
    m_input.noteBusy();
}

QVariant CanvasWidget::inputMethodQuery(Qt::InputMethodQuery query) const
{
    if (query == Qt::ImEnabled || !tool() || !tool()->takesText())
        return QWidget::inputMethodQuery(query);
    const QVariant answer = tool()->inputMethodQuery(query);
    return answer.isValid() ? answer : QWidget::inputMethodQuery(query);
}

Point CanvasWidget::zoomCentre() const
{
    return m_input.pointer().value_or(m_view.centre());
}

void CanvasWidget::fit()
{
    m_view.fit(m_editor.unsettled().painting()->canvas.area(), fitMargin * devicePixelRatioF());
}

void CanvasWidget::zoomToSelection()
{
    const Document &document = m_editor.document();
    const Rect chosen = tool() ? tool()->chosenBox() : Rect();
    const Rect area = chosen.isEmpty() ? seenSelection(*document.painting(), document.selection()) : chosen;
    if (!area.isEmpty())
        m_view.lookAt(area, fitMargin * devicePixelRatioF());
}

void CanvasWidget::bringIntoView(const Rect &pixels)
{
    m_view.bringIntoView(pixels, followMargin * devicePixelRatioF());
}

void CanvasWidget::bringIntoView(Point point)
{
    const Point at = view().toPixels(point);
    bringIntoView({at.x, at.y, at.x, at.y});
}

void CanvasWidget::viewMoved()
{
    m_editor.settle(); // What floats belongs to one view.
    updateOverlay();
    scheduleRender();
    emit viewChanged();
}

void CanvasWidget::scheduleRender()
{
    // One request serves all that happens before the event loop comes round. In between a stroke turns from the draft
    // into a part of the painting, and must not vanish for a frame.
    if (m_renderScheduled)
        return;
    m_renderScheduled = true;
    QMetaObject::invokeMethod(this, &CanvasWidget::requestFrame, Qt::QueuedConnection);
}

void CanvasWidget::requestFrame()
{
    m_renderScheduled = false;
    if (view().width <= 0 || view().height <= 0)
        return;
    RenderRequest request;
    request.painting = m_editor.unsettledShown();
    request.time = m_editor.clock().time();
    request.view = view();
    request.interactive = isMoving();
    m_lastSerial = m_worker.request(std::move(request), m_lift.forFrame());
}

bool CanvasWidget::isMoving() const
{
    return m_editor.isDragging() || m_editor.isStepping();
}

/// Called when nothing has changed since the frame with this number was asked for.
void CanvasWidget::handRests(quint64 serial)
{
    if (m_renderScheduled || serial != m_lastSerial)
        return;
    if (m_editor.isDragging())
        m_editor.rest();
    else
        endDrag();
}

bool CanvasWidget::isUpToDate() const
{
    return !m_renderScheduled && !m_lift.isAhead() && m_lastSerial > 0 && m_worker.shownSerial() == m_lastSerial;
}

void CanvasWidget::setDeviceFramesWanted(bool wanted, const QString &why)
{
    m_worker.setDeviceFramesWanted(wanted);
    m_presenterNotice = wanted ? QString() : tr("The picture goes to the screen by way of memory: %1").arg(why);
    scheduleRender();
    emit backendChanged();
}

void CanvasWidget::readColours()
{
    const bool converted = !screenColours().changesNothing();
    if (!m_screenColours.read(*this))
        return;
    if (converted == screenColours().changesNothing()) { // another presenter may be the right one now
        delete m_presenter->widget();
        m_worker.setDeviceFramesWanted(false);
        m_presenterNotice.clear();
        m_presenter = makePresenter(*this, this);
        m_repaint.setPresenter(m_presenter);
        m_presenter->widget()->setGeometry(rect());
        m_presenter->widget()->lower();
        m_presenter->widget()->show();
        scheduleRender();
    }
    m_presenter->updateArea(rect());
    emit coloursChanged();
}

QString CanvasWidget::backendNotice() const
{
    QStringList lines{m_rendererNotice, m_presenterNotice};
    lines.removeAll(QString());
    return lines.join('\n');
}

QImage CanvasWidget::picture()
{
    QImage copy;
    m_worker.withFrame([&](ShownFrame &frame) {
        if (!frame.picture.argb.empty())
            copy = QImage(reinterpret_cast<const uchar *>(frame.picture.argb.data()), frame.picture.width,
                          frame.picture.height, qsizetype(frame.picture.width) * 4, QImage::Format_ARGB32)
                       .copy();
    });
    return copy;
}

QColor CanvasWidget::backgroundColour() const
{
    return toOpaqueScreen(m_editor.unsettled().painting()->canvas.background);
}

void CanvasWidget::wantUnderlay()
{
    const auto &underlay = m_editor.unsettled().painting()->underlay;
    m_underlay.want(underlay ? underlay->image : nullptr);
}

std::optional<ShownUnderlay> CanvasWidget::underlay() const
{
    const auto &underlay = m_editor.unsettled().painting()->underlay;
    if (!underlay || !underlay->visible || !m_underlay.image() || underlay->area.width() == 0 ||
        underlay->area.height() == 0)
        return {};
    const bool dark = qGray(backgroundColour().rgb()) < 128;
    return ShownUnderlay{m_underlay.image(), underlay->area, double(underlay->opacity), dark};
}

void CanvasWidget::paintAround(QPainter &painter)
{
    m_overlay.paintAround(painter, devicePixelRatioF());
}

void CanvasWidget::paintOverlay(QPainter &painter)
{
    m_overlay.paint(painter, devicePixelRatioF());
    m_repaint.painted(m_lift.isFloating());
    if (m_use == CanvasUse::Work)
        m_editor.laterChanges().painted();
}

void CanvasWidget::revealSelection(bool revealed)
{
    if (m_overlay.reveal(revealed))
        updateOverlay();
}

void CanvasWidget::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange && m_presenter) {
        m_overlay.readPalette(palette());
        updateOverlay();
    }
    QWidget::changeEvent(event);
}

/// Panels wait for the canvas on which one works, and for no other.
void CanvasWidget::tellShown(bool shown)
{
    if (m_use == CanvasUse::Work)
        m_editor.laterChanges().setCanvasShown(shown);
}

/// While the canvas is on the screen, panels hear of a change when the canvas has been painted.
void CanvasWidget::showEvent(QShowEvent *event)
{
    tellShown(true);
    readColours(); // The window is on a screen now.
    if (const QWindow *handle = window()->windowHandle())
        connect(handle, &QWindow::screenChanged, this, &CanvasWidget::readColours, Qt::UniqueConnection);
    QWidget::showEvent(event);
}

void CanvasWidget::hideEvent(QHideEvent *event)
{
    tellShown(false);
    QWidget::hideEvent(event);
}

void CanvasWidget::resizeEvent(QResizeEvent *)
{
    m_presenter->widget()->setGeometry(rect());
    const double dpr = devicePixelRatioF();
    m_view.resize(int(std::lround(width() * dpr)), int(std::lround(height() * dpr)));
    if (isFitted())
        fit();
    else
        viewMoved();
}

bool CanvasWidget::event(QEvent *event)
{
    const auto after = qScopeGuard([this] { m_input.noteBusy(); });
    return m_input.take(event) || QWidget::event(event);
}

void CanvasWidget::mousePressEvent(QMouseEvent *event)
{
    m_input.mousePress(*event);
}

void CanvasWidget::mouseMoveEvent(QMouseEvent *event)
{
    m_input.mouseMove(*event);
}

void CanvasWidget::mouseReleaseEvent(QMouseEvent *event)
{
    m_input.mouseRelease(*event);
}

void CanvasWidget::mouseDoubleClickEvent(QMouseEvent *event)
{
    // Every press of two quick dots paints a dot. A tool may look at PointerEvent::doubleClick.
    m_input.mousePress(*event);
}

void CanvasWidget::tabletEvent(QTabletEvent *event)
{
    event->accept(); // Qt makes no mouse events of a tablet event that was accepted.
    m_input.tablet(*event);
}

void CanvasWidget::wheelEvent(QWheelEvent *event)
{
    event->accept();
    m_input.wheel(*event);
}

void CanvasWidget::keyPressEvent(QKeyEvent *event)
{
    if (!m_input.keyPress(event))
        QWidget::keyPressEvent(event);
}

void CanvasWidget::keyReleaseEvent(QKeyEvent *event)
{
    if (!m_input.keyRelease(*event))
        QWidget::keyReleaseEvent(event);
}

void CanvasWidget::enterEvent(QEnterEvent *event)
{
    m_input.enter(event->position());
}

void CanvasWidget::leaveEvent(QEvent *)
{
    m_input.leave();
}

void CanvasWidget::focusOutEvent(QFocusEvent *event)
{
    m_input.focusOut(event->reason());
    QWidget::focusOutEvent(event);
}

bool CanvasWidget::focusNextPrevChild(bool next)
{
    const QKeyEvent key(QEvent::KeyPress, next ? Qt::Key_Tab : Qt::Key_Backtab,
                        next ? Qt::NoModifier : Qt::ShiftModifier);
    if (next || m_input.isToolKey(key))
        return false; // Tab hides the docks, or belongs to the tool.
    return QWidget::focusNextPrevChild(next);
}

} // namespace suffuse

#include "app/tools/text/text_tool.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/current_layer.h"
#include "app/session/editor.h"
#include "app/session/selecting/pick.h"
#include "app/tools/text/text_marks.h"
#include "model/painting/editable.h"
#include "undo/text_edits.h"

#include <QGuiApplication>
#include <QInputMethodEvent>
#include <QKeyEvent>
#include <QStyleHints>

namespace suffuse {

namespace {

constexpr double pickSlack = 3; ///< logical pixels

bool contains(const std::array<Point, 4> &corners, Point p)
{
    int left = 0, right = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const double side = cross(corners[(i + 1) % 4] - corners[i], p - corners[i]);
        left += side >= 0;
        right += side <= 0;
    }
    return left == 4 || right == 4;
}

/// Whether a point lies in what the letters take up or, of lines that are no curves, between two of them; canvas units
/// before the text's place.
bool covers(const LaidText &laid, const Text &text, Point p)
{
    const auto isIn = [p](const LaidLine &line) {
        return contains(std::array{line.start[0], line.end[0], line.end[1], line.start[1]}, p);
    };
    return std::ranges::any_of(laid.clusters, [p](const LaidCluster &c) { return contains(c.corners(), p); }) ||
           (text.curve.empty() && std::ranges::any_of(laid.lines, isIn));
}

} // namespace

TextTool::TextTool(CanvasWidget &canvas, QObject *parent)
    : CanvasTool(canvas, parent), m_entry(canvas.editor(), this), m_values(canvas, m_entry, this), m_keys(m_entry)
{
    connect(&m_entry, &TextEntry::opened, this, [this] {
        m_caret = {};
        m_followed = {QString(), -1};
        emit typingChanged();
        emit hintChanged();
        restartBlinking();
        QGuiApplication::inputMethod()->show();
    });
    connect(&m_entry, &TextEntry::closed, this, [this] {
        m_blinking.stop();
        m_said.clear();
        m_isPressed = false;
        m_editor.colourTarget().useTool(ColourTarget::ToolUse::Paints);
        emit typingChanged();
        emit hintChanged();
        m_canvas.updateOverlay();
        m_canvas.updateSelection();
        m_values.showRow();
    });
    connect(&m_entry, &TextEntry::changed, this, &TextTool::changed);
    connect(&m_entry, &TextEntry::fontMissing, this, [this](const QString &family) {
        say(tr("The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or "
               "type on: new letters are those of a font like it.")
                .arg(family));
    });
    const auto sayLocked = [this] { say(tr("Something in this text is locked: unlock it to change the text.")); };
    connect(&m_entry, &TextEntry::locked, this, sayLocked);
    connect(&m_values, &TextValues::locked, this, sayLocked);
    connect(&m_editor, &Editor::brushChanged, this, [this] {
        if (m_entry.isOpen())
            m_entry.useBrush();
    });
}

QString TextTool::hint() const
{
    if (!m_said.isEmpty())
        return m_said;
    return m_entry.isOpen() ? tr("Type. Return: a new line. Esc or a click elsewhere: done.")
                            : tr("Click or Return: type a text, or in the text that is there.");
}

void TextTool::say(const QString &text)
{
    if (std::exchange(m_said, text) != text)
        emit hintChanged();
}

void TextTool::changed()
{
    m_isOn = true;
    restartBlinking();
    const std::set<StrokeId> letters = m_entry.selectedLetters();
    // What is selected of it is what panels change: a colour, for example.
    m_editor.colourTarget().useTool(letters.empty() ? ColourTarget::ToolUse::Paints : ColourTarget::ToolUse::Refines);
    if (m_editor.selection().strokes != letters || !m_editor.selection().segments.empty())
        m_editor.document().setSelection({letters, {}});
    m_values.showRow();
    followCaret();
    // Where nothing but the caret lies over the text, the rest of what lies over the picture stays as it is.
    const QRectF caret = seenCaret();
    const auto [from, to] = m_entry.composed();
    const bool isCaretAlone = !m_entry.hasSelection() && from == to && m_entry.text().curve.empty();
    if (isCaretAlone && !m_caret.isEmpty())
        m_canvas.updateOverlay(QRegion(caret.toAlignedRect()) + QRegion(m_caret.toAlignedRect()));
    else
        m_canvas.updateOverlay();
    m_caret = isCaretAlone ? caret : QRectF();
    if (QGuiApplication::inputMethod()->isVisible() || m_canvas.hasFocus())
        QGuiApplication::inputMethod()->update(Qt::ImCursorRectangle | Qt::ImCursorPosition | Qt::ImSurroundingText |
                                               Qt::ImAnchorPosition | Qt::ImCurrentSelection);
}

/// The device pixels of the caret that the canvas shows.
QRectF TextTool::seenCaret() const
{
    const View &view = m_canvas.view();
    return caretPixels(m_entry, view, m_canvas.devicePixelRatioF()).intersected(QRectF(0, 0, view.width, view.height));
}

/// Moves the view where the caret has left it, as text editors do; not below a pointer that selects.
void TextTool::followCaret()
{
    const std::pair<QString, qsizetype> now(m_entry.text().string, m_entry.caret());
    if (m_isPressed || std::exchange(m_followed, now) == now)
        return;
    const QRectF caret = caretPixels(m_entry, m_canvas.view(), m_canvas.devicePixelRatioF());
    m_canvas.bringIntoView({caret.left(), caret.top(), caret.right(), caret.bottom()});
}

void TextTool::restartBlinking()
{
    const int flash = QGuiApplication::styleHints()->cursorFlashTime();
    if (flash > 1)
        m_blinking.start(flash / 2, this);
}

void TextTool::timerEvent(QTimerEvent *event)
{
    if (event->timerId() != m_blinking.timerId())
        return CanvasTool::timerEvent(event);
    m_isOn = !m_isOn;
    m_canvas.updateOverlay(seenCaret());
}

qsizetype TextTool::placeAt(Point point) const
{
    const std::optional<Affine> back = m_entry.text().place.inverse();
    return back ? m_entry.laid().positionAt((*back)(point), m_entry.text().string) : 0;
}

bool TextTool::isOver(Point point) const
{
    const std::optional<Affine> back = m_entry.text().place.inverse();
    if (!back)
        return false;
    const Point p = (*back)(point);
    if (covers(m_entry.laid(), m_entry.text(), p))
        return true;
    // A little beside the lines is meant for them, too.
    const auto isBeside = [p](const CaretLine &caret) {
        return length(p - 0.5 * (caret[0] + caret[1])) <= 0.75 * length(caret[1] - caret[0]);
    };
    const LaidText &laid = m_entry.laid();
    return isBeside(laid.caretAt(laid.positionAt(p, m_entry.text().string))) ||
           std::ranges::any_of(laid.clusters, [&](const LaidCluster &c) { return isBeside(c.before); });
}

GroupId TextTool::textAt(const PointerEvent &event) const
{
    const PaintingPtr reached = m_editor.layer().reached();
    const Painting &painting = *reached;
    const double slack = pickSlack * m_canvas.devicePixelRatioF() / m_canvas.view().scale;
    if (const auto hit = pickTopmost(painting, m_editor.clock().time(), event.point, slack)) {
        const StrokePtr stroke = painting.find(hit->stroke);
        if (const GroupId text = stroke ? textAround(painting, *stroke) : 0)
            return text;
    }
    // Between the letters of one, the topmost first.
    std::set<GroupId> asked;
    const Editable isEditable(painting.groups);
    for (auto at = painting.strokes.size(); at-- > 0;) {
        const Stroke &stroke = *painting.strokes[at];
        if (stroke.group == 0 || !isEditable(stroke) || !asked.insert(stroke.group).second)
            continue;
        const SharedText text = textOf(painting, stroke.group);
        const std::optional<Affine> back = text ? text->place.inverse() : std::nullopt;
        if (back && covers(m_layout.lay(*text), *text, (*back)(event.point)))
            return stroke.group;
    }
    return 0;
}

void TextTool::edit(GroupId text, Point point)
{
    const std::set<StrokeId> selected = m_editor.selection().strokes;
    m_entry.open(text);
    if (!m_entry.isOpen())
        return;
    m_values.noteChosen(selected);
    m_entry.moveTo(placeAt(point), false);
}

void TextTool::press(const PointerEvent &event)
{
    say({});
    m_isPressed = true;
    m_choosesWords = false;
    m_keys.forgetColumn();
    if (m_entry.isOpen() && !isOver(event.point)) {
        m_entry.finish();
        m_isPressed = false;
        return;
    }
    if (!m_entry.isOpen()) {
        if (const GroupId text = textAt(event)) {
            edit(text, event.point);
        } else if (m_editor.layer().takesPaint()) {
            m_values.noteChosen(m_editor.selection().strokes);
            Text begun = m_values.style();
            begun.place = Affine::translation(event.point);
            m_entry.begin(begun);
        }
        return;
    }
    const qsizetype place = placeAt(event.point);
    if (event.doubleClick) {
        std::tie(m_wordFrom, m_wordTo) = wordAt(m_entry.text().string, place);
        m_choosesWords = true;
        m_entry.select(m_wordFrom, m_wordTo);
    } else {
        m_entry.moveTo(place, event.modifiers & Qt::ShiftModifier);
    }
}

void TextTool::move(const PointerEvent &event)
{
    if (!m_isPressed || !m_entry.isOpen())
        return;
    const qsizetype place = placeAt(event.point);
    if (m_choosesWords) {
        const auto [from, to] = wordAt(m_entry.text().string, place);
        if (place < m_wordFrom)
            m_entry.select(m_wordTo, from);
        else
            m_entry.select(m_wordFrom, std::max(m_wordTo, to));
    } else if (place != m_entry.caret()) {
        m_entry.moveTo(place, true);
    }
}

void TextTool::release(const PointerEvent &)
{
    m_isPressed = false;
}

void TextTool::cancel()
{
    m_isPressed = false;
    if (m_entry.hasTyped())
        m_entry.giveUp();
    else
        m_entry.finish();
}

void TextTool::settle()
{
    m_isPressed = false;
    m_entry.settle();
}

/// The selected text, or a new one in the middle of the view.
void TextTool::beginByKey()
{
    m_values.noteChosen(m_editor.selection().strokes);
    if (const GroupId text = selectedText(m_editor.document())) {
        m_entry.open(text);
        return;
    }
    if (!m_editor.layer().takesPaint())
        return;
    Text begun = m_values.style();
    begun.place = Affine::translation(m_canvas.view().centre);
    m_entry.begin(begun);
}

bool TextTool::wantsKey(const QKeyEvent &event) const
{
    if (!m_entry.isOpen())
        return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    return m_keys.areMeant(event);
}

bool TextTool::keyPress(QKeyEvent *event)
{
    if (!wantsKey(*event))
        return false;
    if (!m_entry.isOpen()) {
        beginByKey();
        return true;
    }
    if (m_entry.laid().hasFamily)
        say({});
    return m_keys.take(*event);
}

bool TextTool::takesKey(Qt::Key key, Qt::KeyboardModifiers modifiers)
{
    QKeyEvent event(QEvent::KeyPress, key, modifiers);
    return m_entry.isOpen() && keyPress(&event);
}

bool TextTool::deleteSelected()
{
    if (!m_entry.isOpen())
        return false;
    m_entry.eraseTo(nextPlace(m_entry.text().string, m_entry.caret()));
    return true;
}

bool TextTool::selectAll()
{
    if (!m_entry.isOpen())
        return false;
    m_entry.select(0, m_entry.text().string.size());
    return true;
}

void TextTool::inputMethod(QInputMethodEvent &event)
{
    if (!event.commitString().isEmpty() || event.replacementLength() > 0)
        m_entry.decide(event.commitString(), event.replacementStart(), event.replacementLength());
    qsizetype caret = event.preeditString().size();
    for (const QInputMethodEvent::Attribute &attribute : event.attributes())
        if (attribute.type == QInputMethodEvent::Cursor)
            caret = attribute.start;
    m_entry.compose(event.preeditString(), caret);
}

QVariant TextTool::inputMethodQuery(Qt::InputMethodQuery query) const
{
    if (!m_entry.isOpen())
        return {};
    const double dpr = m_canvas.devicePixelRatioF();
    switch (query) {
    case Qt::ImCursorRectangle: {
        const QRectF r = caretPixels(m_entry, m_canvas.view(), m_canvas.devicePixelRatioF());
        return QRectF(r.topLeft() / dpr, r.size() / dpr);
    }
    case Qt::ImSurroundingText:
        return m_entry.text().string;
    case Qt::ImCursorPosition:
        return int(m_entry.caret());
    case Qt::ImAnchorPosition:
        return int(m_entry.anchor());
    case Qt::ImCurrentSelection:
        return m_entry.selectedString();
    case Qt::ImHints:
        return int(Qt::ImhMultiLine);
    default:
        return {};
    }
}

bool TextTool::showsOutlines() const
{
    return !m_entry.isOpen() && selectedText(m_editor.unsettled()) == 0;
}

void TextTool::paint(QPainter &painter, const View &view, double dpr) const
{
    const QColor accent = m_canvas.overlayColours().accent;
    if (m_entry.isOpen())
        return paintTextInHand(painter, view, dpr, m_entry, accent, m_isOn);
    const Document &document = m_editor.unsettled();
    const SharedText text = textOf(*document.painting(), selectedText(document));
    if (!text)
        return;
    if (!(m_framed == text)) {
        m_framed = text;
        m_frame = m_layout.lay(*text).box();
    }
    paintTextFrame(painter, view, dpr, *text, m_frame, accent);
}

} // namespace suffuse

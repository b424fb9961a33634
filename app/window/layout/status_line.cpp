#include "app/window/layout/status_line.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/handles/rulers.h"
#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/at_next_change.h"
#include "app/widgets/look/elided_sentences.h"
#include "app/widgets/look/section.h"

#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QPainter>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOption>

#include <utility>

namespace suffuse {

namespace {

void drawLine(QPainter &painter, const QWidget &widget, const QRect &area, const QString &text)
{
    widget.style()->drawItemText(&painter, area, Qt::AlignLeading | Qt::AlignVCenter | Qt::TextSingleLine,
                                 widget.palette(), true, text, QPalette::WindowText);
}

/// A line that takes the room there is, so that another text need not be measured.
class HintLine : public QLabel {
public:
    using QLabel::QLabel;
    QSize sizeHint() const override { return {0, fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        drawLine(painter, *this, contentsRect(), elidedSentences(text(), fontMetrics(), contentsRect().width()));
    }
};

/// Qt's own bar cuts a message off where the numbers begin. All of it is in the tool tip. Unlike of a hint, the part of
/// a sentence that there is room for tells something: what was lost, for example, and that there is more of it.
class MessageBar : public QStatusBar {
public:
    explicit MessageBar(QWidget *parent) : QStatusBar(parent)
    {
        connect(this, &QStatusBar::messageChanged, this, &QWidget::setToolTip);
    }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        if (currentMessage().isEmpty())
            return QStatusBar::paintEvent(event);
        QStyleOption option;
        option.initFrom(this);
        QPainter painter(this);
        style()->drawPrimitive(QStyle::PE_PanelStatusBar, &option, &painter, this);
        constexpr int margin = 6;
        QRect area = rect().adjusted(margin, 0, -margin, 0); // beside what stays visible: the numbers
        for (const QObject *child : children())
            if (const auto *widget = qobject_cast<const QWidget *>(child); widget && widget->isVisible())
                area.setRight(std::min(area.right(), widget->x() - margin));
        drawLine(painter, *this, area, fontMetrics().elidedText(currentMessage(), Qt::ElideRight, area.width()));
    }
};

} // namespace

StatusLine::StatusLine(const Workplace &place, QObject *parent) : QObject(parent), m_place(place)
{
    makeLabels();
    const CanvasWidget *canvas = &place.canvas;
    for (const Tool *tool : canvas->findChildren<Tool *>())
        connect(tool, &Tool::hintChanged, this, &StatusLine::showHint);
    connect(canvas, &CanvasWidget::toolChanged, this, &StatusLine::showHint);
    connect(&place.canvas.keyboardPen(), &KeyboardPen::onChanged, this, &StatusLine::showHint);
    connect(canvas, &CanvasWidget::modifiersChanged, this, &StatusLine::showHint);
    connect(&place.open.editor.clock(), &PaintingClock::pastChanged, this, &StatusLine::showHint);
    connect(canvas, &CanvasWidget::viewChanged, this, &StatusLine::showZoom);
    connect(canvas, &CanvasWidget::framePresented, this, &StatusLine::showFrame);
    connect(canvas, &CanvasWidget::backendChanged, this, &StatusLine::showBackend);
    connect(canvas, &CanvasWidget::pointerLeft, this, [this] { m_position->clear(); });
    connect(canvas, &CanvasWidget::pointerMoved, this, &StatusLine::showPosition);
    connect(&place.commands, &Commands::said, this, [this](const QString &message, int milliseconds) {
        sayUntilChange(*m_place.window.statusBar(), m_place.open.editor.document(), message, milliseconds);
    });
    showHint();
    showZoom();
}

void StatusLine::makeLabels()
{
    m_place.window.setStatusBar(new MessageBar(&m_place.window));
    const QFontMetrics metrics = m_place.window.fontMetrics();
    // Characters that the font lacks come from another one, whose lines may be higher. A status bar keeps the height
    // that it has at first, so it must know them before there is a text.
    const int height = metrics.size(0, tr("What renders the picture")).height();
    const auto label = [this, height](const QString &tip, int width) {
        auto *l = new QLabel(&m_place.window);
        l->setToolTip(tip);
        l->setMinimumSize(width, height);
        l->setContentsMargins(8, 0, 8, 0);
        return l;
    };
    m_hint = new HintLine(&m_place.window);
    m_hint->setObjectName("hint");
    m_hint->setContentsMargins(6, 0, 0, 0);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_position =
        label(tr("Position of the pointer, in what the rulers count"), metrics.horizontalAdvance("00000.0, 00000.0"));
    m_zoom = label(tr("Zoom, and the angle by which the canvas is turned"), metrics.horizontalAdvance("00000 %"));
    m_backend = label(tr("What renders the picture"), 0);
    m_frameTime = label(tr("Time that the last frame took"), metrics.horizontalAdvance("0000.0 ms"));
    for (QLabel *number : {m_position, m_zoom, m_frameTime})
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_backend->setObjectName("backend");
    showBackend();
    m_place.window.statusBar()->addWidget(m_hint, 1);
    for (QLabel *l : {m_position, m_zoom, m_backend, m_frameTime})
        m_place.window.statusBar()->addPermanentWidget(l);
}

void StatusLine::sayWhoHasKeyboard(const QString &sentence)
{
    m_keyboard = sentence;
    showHint();
}

void StatusLine::showHint()
{
    if (!m_keyboard.isEmpty()) {
        m_hint->setText(m_keyboard);
        m_hint->setToolTip(m_keyboard);
        return;
    }
    const QString hint =
        m_place.canvas.keyboardPen().isOn()
            ? tr("Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and "
                 "lifts it; + and - change its pressure; Esc puts it away.")
            : m_place.canvas.tool()->hint();
    const bool isPast = m_place.open.editor.clock().isInPast() && m_place.commands[Command::Brush].isChecked();
    //: instead of what the brush does, while the timeline shows a moment of the past
    const QString past = tr("You paint in the past: what came later covers it.");
    // Both have no room beside each other. What the brush does is told where one asks for it.
    m_hint->setText(isPast ? past : hint);
    m_hint->setToolTip(isPast ? past + '\n' + hint : hint);
}

void StatusLine::showPosition(double x, double y)
{
    const double unit = m_place.canvas.rulerUnit().units;
    // As many decimals as a pixel shows.
    const int decimals = std::clamp(int(std::ceil(std::log10(unit * m_place.canvas.view().scale))) + 1, 0, 10);
    const QLocale l = m_place.window.locale();
    //: a position: x, y
    showInPlace(*m_position,
                tr("%1, %2").arg(l.toString(x / unit, 'f', decimals), l.toString(y / unit, 'f', decimals)));
}

void StatusLine::showZoom()
{
    const double percent = m_place.canvas.view().scale * 100;
    const bool plain = percent >= 0.1 && percent < 1e6;
    const QString zoom = tr("%1 %").arg(plain ? m_place.window.locale().toString(percent, 'f', percent < 10 ? 1 : 0)
                                              : m_place.window.locale().toString(percent, 'g', 3));
    const double rotation = m_place.canvas.view().rotation;
    showInPlace(*m_zoom, std::abs(rotation) < 1e-6 ? zoom : zoom + QStringLiteral(" · ") + angleText(rotation));
}

void StatusLine::showFrame(const FrameInfo &frame)
{
    if (frame.error.isEmpty())
        showInPlace(*m_frameTime, (frame.isExact() ? tr("%1 ms") : tr("%1 ms, coarse"))
                                      .arg(m_place.window.locale().toString(frame.stats.totalMs, 'f', 1)));
    if (frame.error != m_renderError) { // once, not sixty times a second
        m_renderError = frame.error;
        if (!m_renderError.isEmpty())
            showError(&m_place.window, m_renderError);
    }
}

void StatusLine::showBackend()
{
    const QString before = std::exchange(m_backendText, m_place.canvas.backendText()),
                  notice = m_place.canvas.backendNotice();
    const QString tip = tr("What renders the picture");
    // The name of the device is told where one asks for it: some are as long as a hint, which needs the room.
    m_backend->setText(m_backendText.section(QStringLiteral(" · "), 0, 0));
    m_backend->setToolTip(tip + '\n' + m_backendText + (notice.isEmpty() ? notice : '\n' + notice));
    if (!before.isEmpty() && before != m_backendText) // it went over while at work
        m_place.window.statusBar()->showMessage(notice.section('\n', 0, 0), 15'000);
}

} // namespace suffuse

// What the status bar says.
#include "app/canvas/canvas_widget.h"
#include "app/widgets/messages.h"
#include "app/widgets/section.h"
#include "app/window/main_window.h"

#include <QLocale>
#include <QStatusBar>

namespace suffuse {

namespace {

/// A line that takes the room there is, so that another text need not be measured.
class HintLine : public QLabel {
public:
    using QLabel::QLabel;
    QSize sizeHint() const override { return {0, fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace

void MainWindow::makeStatusBar()
{
    const auto label = [this](const QString &tip, int width) {
        auto *l = new QLabel(this);
        l->setToolTip(tip);
        l->setMinimumWidth(width);
        l->setContentsMargins(8, 0, 8, 0);
        return l;
    };
    m_hint = new HintLine(this);
    m_hint->setContentsMargins(6, 0, 0, 0);
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_position =
        label(tr("Position of the pointer in canvas units"), fontMetrics().horizontalAdvance("00000.0, 00000.0"));
    m_zoom = label(tr("Zoom, and the angle by which the canvas is turned"), fontMetrics().horizontalAdvance("00000 %"));
    m_backend = label(tr("What renders the picture"), 0);
    m_frameTime = label(tr("Time that the last frame took"), fontMetrics().horizontalAdvance("0000.0 ms"));
    for (QLabel *number : {m_position, m_zoom, m_frameTime})
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_backend->setObjectName("backend");
    showBackend();
    statusBar()->addWidget(m_hint, 1);
    for (QLabel *l : {m_position, m_zoom, m_backend, m_frameTime})
        statusBar()->addPermanentWidget(l);
}

void MainWindow::showHint()
{
    //: before what the brush does, while the timeline shows a moment of the past
    const QString past = m_editor.clock().isInPast() && (*m_commands)[Command::Brush].isChecked()
                             ? tr("You paint in the past: what came later covers it. ")
                             : QString();
    m_hint->setText(past + m_canvas->tool()->hint());
    m_hint->setToolTip(past + m_canvas->tool()->hint());
}

void MainWindow::showPosition(double x, double y)
{
    // As many decimals as a pixel shows.
    const int decimals = std::clamp(int(std::ceil(std::log10(m_canvas->view().scale))) + 1, 0, 10);
    const QLocale l = locale();
    //: a position: x, y
    showInPlace(*m_position, tr("%1, %2").arg(l.toString(x, 'f', decimals), l.toString(y, 'f', decimals)));
}

void MainWindow::updateZoom()
{
    const double percent = m_canvas->view().scale * 100;
    const bool plain = percent >= 0.1 && percent < 1e6;
    const QString zoom = tr("%1 %").arg(plain ? locale().toString(percent, 'f', percent < 10 ? 1 : 0)
                                              : locale().toString(percent, 'g', 3));
    const double rotation = m_canvas->view().rotation;
    showInPlace(*m_zoom, std::abs(rotation) < 1e-6 ? zoom : zoom + QStringLiteral(" · ") + angleText(rotation));
}

void MainWindow::showFrame(const FrameInfo &frame)
{
    if (frame.error.isEmpty())
        showInPlace(
            *m_frameTime,
            (frame.isExact() ? tr("%1 ms") : tr("%1 ms, coarse")).arg(locale().toString(frame.stats.totalMs, 'f', 1)));
    if (frame.error != m_renderError) { // once, not sixty times a second
        m_renderError = frame.error;
        if (!m_renderError.isEmpty())
            showError(this, m_renderError);
    }
}

void MainWindow::showBackend()
{
    const QString before = m_backend->text(), text = m_canvas->backendText(), notice = m_canvas->backendNotice();
    const QString tip = tr("What renders the picture");
    m_backend->setText(text);
    m_backend->setToolTip(notice.isEmpty() ? tip : tip + '\n' + notice);
    if (!before.isEmpty() && before != text) // it went over while at work
        statusBar()->showMessage(notice.section('\n', 0, 0), 15'000);
}

} // namespace suffuse

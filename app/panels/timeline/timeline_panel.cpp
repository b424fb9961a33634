#include "app/panels/timeline/timeline_panel.h"

#include "app/panels/timeline/timeline_view.h"
#include "app/session/commands/commands.h"
#include "app/session/editor.h"
#include "app/session/playback.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/row_scroll.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/arithmetic.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/numbers/time_text.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>

namespace suffuse {

namespace {

constexpr int endLaterMs = 100; ///< milliseconds after which the end is looked for while edits follow each other fast
constexpr std::array<double, 11> speeds{0.1, 0.25, 0.5, 1, 2, 4, 10, 25, 100, 250, 1000};

QString speedText(double speed)
{
    return QStringLiteral("%1×").arg(QLocale().toString(speed, 'g', 4));
}

QToolButton *buttonOf(QAction &action, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    button->setIconSize({18, 18});
    button->setFocusPolicy(Qt::TabFocus); // A click leaves the keyboard with the canvas or the Timeline.
    return button;
}

} // namespace

TimelinePanel::TimelinePanel(Editor &editor, Playback &playback, const Commands &commands, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_playback(playback), m_commands(commands)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *head = new QWidget(this);
    auto *row = new QHBoxLayout(head);
    row->setContentsMargins(8, 3, 8, 3);
    row->setSpacing(2);
    for (const Command command :
         {Command::ToStart, Command::PreviousStroke, Command::Play, Command::NextStroke, Command::ToEnd})
        row->addWidget(buttonOf(commands[command], this));
    row->addSpacing(8);
    m_time = new QLabel(this);
    m_time->setToolTip(tr("The moment that is shown, and the end, when all has dried"));
    m_time->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00:00.000 / 00:00.000 ")));
    row->addWidget(m_time);
    row->addSpacing(8);
    row->addWidget(buttonOf(commands[Command::LoopPlaying], this));
    row->addWidget(buttonOf(commands[Command::SkipPauses], this));
    m_speed = new QComboBox(this);
    m_speedField = new EntryField(m_speed);
    m_speed->setLineEdit(m_speedField); // which makes it editable
    m_speed->setInsertPolicy(QComboBox::NoInsert);
    m_speed->setCompleter(nullptr); // A number that is typed means itself, not a listed one that begins so.
    for (const double speed : speeds)
        m_speed->addItem(speedText(speed));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("How fast the painting is played: 0.1 to 1000 times as fast as it was painted"));
    m_speed->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000.0×")) + 40);
    row->addSpacing(4);
    row->addWidget(m_speed);
    row->addSpacing(12);
    m_what = quietLabel({}, this);
    m_what->setWordWrap(false);
    m_what->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(m_what, 1);
    row->addWidget(buttonOf(commands[Command::FinalPreview], this));
    auto *fit = new QToolButton(this);
    fit->setIcon(icon("fit-time"));
    fit->setAutoRaise(true);
    fit->setIconSize({18, 18});
    fit->setFocusPolicy(Qt::TabFocus);
    fit->setToolTip(tr("Show all of the time (0). Ctrl+wheel zooms."));
    fit->setAccessibleName(tr("Show all of the time"));
    row->addWidget(fit);
    column->addWidget(new RowScroll(head));
    m_view = new TimelineView(editor, playback, this);
    column->addWidget(m_view, 1);

    connect(fit, &QToolButton::clicked, m_view, &TimelineView::fit);
    connect(m_view, &TimelineView::dragged, this, [this](const QString &what) {
        m_what->setText(what);
        showTime();
    });
    connect(m_view, &TimelineView::menuWanted, this, &TimelinePanel::showMenu);
    connect(m_speed, &QComboBox::textActivated, this, &TimelinePanel::takeSpeed);
    connect(m_speedField, &EntryField::typed, this, &TimelinePanel::takeSpeed);
    connect(&playback, &Playback::stateChanged, this, &TimelinePanel::showState);
    connect(&editor.clock(), &PaintingClock::timeChanged, this, &TimelinePanel::showTime);
    connect(&editor.clock(), &PaintingClock::pastChanged, this, &TimelinePanel::showTime);
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (!change.draft && !m_later.isActive())
            m_later.start();
    });
    m_later.setSingleShot(true);
    m_later.setInterval(endLaterMs);
    connect(&m_later, &QTimer::timeout, this, &TimelinePanel::showTime);
    showState();
}

void TimelinePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    showTime();
}

void TimelinePanel::showTime()
{
    if (!isVisible())
        return;
    const PaintingClock &clock = m_editor.clock();
    showInPlace(*m_time, QStringLiteral("%1 / %2").arg(clockText(clock.shown()), clockText(clock.end())));
}

void TimelinePanel::showMenu(QPoint globalPosition, bool onBar)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto append = [this](QMenu &to, std::initializer_list<Command> commands) {
        for (const Command command : commands)
            to.addAction(&m_commands[command]);
    };
    if (onBar) {
        const std::set<StrokeId> selected = m_editor.selection().strokes;
        TimelineBar all;
        bool any = false;
        for (const StrokePtr &stroke : m_editor.unsettled().painting()->strokes)
            if (selected.contains(stroke->id)) {
                const TimelineBar bar = barOf(*stroke);
                all.begin = any ? std::min(all.begin, bar.begin) : bar.begin;
                all.end = any ? std::max(all.end, bar.end) : bar.end;
                any = true;
            }
        menu->addAction(tr("Go to Its &Start"), this, [this, all] { m_playback.seek(all.begin); });
        menu->addAction(tr("Go to When It Is Dr&y"), this, [this, all] { m_playback.seek(all.end); });
        menu->addSeparator();
        append(*menu->addMenu(tr("Drawing Pa&ce")),
               {Command::PaceEven, Command::PaceEaseIn, Command::PaceEaseOut, Command::PaceEaseInOut});
        append(*menu, {Command::Rewet, Command::RemoveRewetting});
    } else {
        append(*menu, {Command::Play, Command::ToStart, Command::ToEnd});
        menu->addSeparator();
        append(*menu, {Command::LoopPlaying, Command::SkipPauses});
    }
    menu->popup(globalPosition);
}

void TimelinePanel::showState()
{
    const QSignalBlocker blocker(m_speed);
    m_speedField->showText(speedText(m_playback.speed()));
}

void TimelinePanel::takeSpeed(const QString &text)
{
    const QString times(QChar(0xd7));
    QString typed = text.trimmed();
    if (typed.endsWith(times) || typed.endsWith(QLatin1Char('x'), Qt::CaseInsensitive))
        typed.chop(1);
    const std::optional<double> speed = evaluateArithmetic(typed, m_playback.speed());
    const bool isPossible = speed && *speed >= Playback::slowest && *speed <= Playback::fastest;
    if (isPossible)
        m_playback.setSpeed(*speed);
    m_what->setText(!speed       ? NumberField::whyUnread(typed, times)
                    : isPossible ? QString()
                                 : tr("%1 is out of range: 0.1 to 1000 times is possible.").arg(speedText(*speed)));
    showState();
}

} // namespace suffuse

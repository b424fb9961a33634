#include "app/window/welcome/lesson_card.h"

#include "app/widgets/habits/place_beside.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int ringCorner = 6, ringWidth = 3, cardGap = 10; ///< logical pixels

} // namespace

/// The frame around the place. Whatever is pressed goes through it.
class LessonCard::Ring : public QWidget {
public:
    explicit Ring(QWidget *parent) : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(focusFrame(), ringWidth));
        constexpr double half = ringWidth / 2.0;
        painter.drawRoundedRect(QRectF(rect()).adjusted(half, half, -half, -half), ringCorner, ringCorner);
    }
};

LessonCard::LessonCard(Lesson &lesson, FindPlace find, QMainWindow &window)
    : QFrame(&window), m_lesson(lesson), m_find(std::move(find)), m_window(window), m_ring(new Ring(&window))
{
    setObjectName(QStringLiteral("lessonCard"));
    setAutoFillBackground(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 12);
    column->setSpacing(8);
    m_title = quietLabel({}, this);
    m_text = new QLabel(this);
    m_text->setWordWrap(true);
    m_leave = new QPushButton(this);
    m_leave->setFocusPolicy(Qt::TabFocus); // a click leaves the keyboard to the canvas
    auto *row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(m_leave);
    column->addWidget(m_title);
    column->addWidget(m_text, 1);
    column->addLayout(row);
    setFixedWidth(20 * fontMetrics().height());
    connect(m_leave, &QPushButton::clicked, this, &LessonCard::left);
    connect(&lesson, &Lesson::stepped, this, [this] { show(m_lesson); });
    m_window.installEventFilter(this);
    show(lesson);
}

LessonCard::~LessonCard()
{
    delete m_ring; // it is the window's, too
}

void LessonCard::show(const Lesson &lesson)
{
    m_title->setText(lesson.isDone()
                         ? titleOf(lesson.kind())
                         : tr("%1 – step %2 of %3").arg(titleOf(lesson.kind())).arg(lesson.step() + 1).arg(lesson.count()));
    m_text->setText(lesson.text());
    m_leave->setText(lesson.isDone() ? tr("Close") : tr("Leave the lesson"));
    setAccessibleName(lesson.text());
    m_target = m_find(lesson.place());
    m_ring->setVisible(!lesson.isDone());
    place();
    QTimer::singleShot(0, this, &LessonCard::place); // when what was brought to the front has its size
}

void LessonCard::place()
{
    adjustSize();
    resize(width(), heightForWidth(width()));
    const QWidget &target = m_target ? *m_target : m_window;
    const QRect where(target.mapTo(&m_window, QPoint()), target.size());
    const bool isLarge = where.width() > m_window.width() / 2; // the canvas, which the card lies on
    m_ring->setGeometry(isLarge ? where : where.adjusted(-ringWidth, -ringWidth, ringWidth, ringWidth) & m_window.rect());
    if (isLarge)
        move(where.center().x() - width() / 2, where.bottom() - height() - 2 * cardGap);
    else
        move(placeBeside(size() + QSize(2 * cardGap, 2 * cardGap), where, m_window.rect()) + QPoint(cardGap, cardGap));
    m_ring->raise();
    raise();
    QFrame::show();
}

void LessonCard::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
    painter.setPen(QPen(focusFrame(), 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

bool LessonCard::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest))
        QTimer::singleShot(0, this, &LessonCard::place);
    return QFrame::eventFilter(watched, event);
}

} // namespace suffuse

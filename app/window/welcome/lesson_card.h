#pragma once

#include "app/session/lessons/lesson.h"

#include <QFrame>
#include <QPointer>

class QLabel;
class QMainWindow;
class QPushButton;

namespace suffuse {

/// Says what is to be done in a lesson, beside the place in the window where it is done, which has a frame around it. It
/// waits: who does it goes on to the next step.
class LessonCard : public QFrame {
    Q_OBJECT

public:
    /// Says where a place of a lesson is now, and brings it to the front.
    using FindPlace = std::function<QWidget *(const LessonPlace &place)>;

    LessonCard(Lesson &lesson, FindPlace find, QMainWindow &window);
    ~LessonCard() override;

    QLabel *text() const { return m_text; }
    QPushButton *leave() const { return m_leave; }
    /// The widget that it points at.
    QWidget *target() const { return m_target; }

signals:
    void left();

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    class Ring;

    void show(const Lesson &lesson);
    void place();

    Lesson &m_lesson;
    FindPlace m_find;
    QMainWindow &m_window;
    Ring *m_ring = nullptr;
    QLabel *m_title = nullptr;
    QLabel *m_text = nullptr;
    QPushButton *m_leave = nullptr;
    QPointer<QWidget> m_target;
};

} // namespace suffuse

// The welcome page and the lessons of a window.
#pragma once

#include "app/session/lessons/lesson.h"
#include "app/window/workplace.h"

#include <QObject>
#include <QPointer>

#include <memory>

class QWidget;

namespace suffuse {

class FileOpening;
class LessonCard;
class WelcomeDialog;

class Welcoming : public QObject {
    Q_OBJECT

public:
    Welcoming(const Workplace &place, FileOpening &opening, QObject *parent);
    ~Welcoming() override;

    /// Shows the welcome page if people want it at the start and nothing was begun yet.
    void greet();
    /// Shows it.
    WelcomeDialog *show();
    /// Begins a lesson in this window. Another one that goes on is left.
    void begin(LessonKind kind);
    /// Begins a lesson on an empty sheet: in this window if nothing was begun here, else in a new one, so that one's own
    /// painting is left alone.
    void practise(LessonKind kind);
    /// The card of the lesson that goes on; null: there is none.
    LessonCard *card() const { return m_card.get(); }

private:
    QWidget *find(const LessonPlace &place) const;
    void leave();

    const Workplace m_place;
    FileOpening &m_opening;
    QPointer<WelcomeDialog> m_dialog;
    std::unique_ptr<Lesson> m_lesson;
    std::unique_ptr<LessonCard> m_card; ///< goes before the lesson
};

} // namespace suffuse

#include "app/window/welcome/welcoming.h"

#include "app/canvas/canvas_widget.h"
#include "app/dialogs/welcome/welcome_dialog.h"
#include "app/session/commands/commands.h"
#include "app/session/open_painting.h"
#include "app/session/settings/greeting.h"
#include "app/window/files/file_opening.h"
#include "app/window/welcome/lesson_card.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QToolBar>

namespace suffuse {

Welcoming::Welcoming(const Workplace &place, FileOpening &opening, QObject *parent)
    : QObject(parent), m_place(place), m_opening(opening)
{
    place.commands
        .add(Command::Welcome, "welcome", Commands::tr("&Welcome…"), "", {},
             Commands::tr("New paintings, recent ones, samples, and short lessons"))
        .runs([this] { show(); });
    connect(&place.open.editor, &Editor::opened, this, &Welcoming::leave);
}

Welcoming::~Welcoming()
{
    delete m_dialog;
}

void Welcoming::greet()
{
    if (settings::welcomes() && m_opening.isUntouched())
        show();
}

WelcomeDialog *Welcoming::show()
{
    if (!m_dialog) {
        m_dialog = new WelcomeDialog(&m_place.window);
        m_dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_dialog, &WelcomeDialog::sheetChosen, this,
                [this](const NewSheet &sheet) { m_opening.begin(sheet.canvas, sheet.resolution); });
        connect(m_dialog, &WelcomeDialog::otherSheetWanted, this, [this] { m_place.commands[Command::New].trigger(); });
        connect(m_dialog, &WelcomeDialog::openWanted, this, [this] { m_place.commands[Command::Open].trigger(); });
        connect(m_dialog, &WelcomeDialog::fileChosen, this, [this](const QString &path) { m_opening.open(path); });
        connect(m_dialog, &WelcomeDialog::lessonChosen, this, &Welcoming::practise);
    }
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
    return m_dialog;
}

void Welcoming::practise(LessonKind kind)
{
    if (m_opening.isUntouched())
        return begin(kind);
    const FileOpening *other = m_opening.begin(Editor::usualCanvas());
    other->window().findChild<Welcoming *>()->begin(kind);
}

void Welcoming::begin(LessonKind kind)
{
    leave();
    m_lesson = std::make_unique<Lesson>(kind, m_place.open.editor);
    m_card = std::make_unique<LessonCard>(
        *m_lesson, [this](const LessonPlace &place) { return find(place); }, m_place.window);
    connect(m_card.get(), &LessonCard::left, this, &Welcoming::leave, Qt::QueuedConnection);
    m_place.window.activateWindow();
    m_place.canvas.setFocus();
}

void Welcoming::leave()
{
    m_card.reset();
    m_lesson.reset();
}

QWidget *Welcoming::find(const LessonPlace &place) const
{
    switch (place.kind) {
    case LessonPlace::Kind::Canvas:
        break;
    case LessonPlace::Kind::Tool:
        for (const QToolBar *bar : m_place.window.findChildren<QToolBar *>())
            if (QWidget *button = bar->widgetForAction(&m_place.commands[place.tool]); button && button->isVisible())
                return button;
        break;
    case LessonPlace::Kind::Dock:
        if (auto *dock = m_place.window.findChild<QDockWidget *>(QString::fromLatin1(place.dock))) {
            dock->show();
            dock->raise();
            return dock->isFloating() ? nullptr : dock;
        }
        break;
    }
    return &m_place.canvas;
}

} // namespace suffuse

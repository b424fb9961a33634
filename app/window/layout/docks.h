// The docks of a window.
#pragma once

#include "app/session/commands/command_row.h"
#include "app/window/workplace.h"

#include <QList>
#include <QObject>

class QAction;
class QDockWidget;
class QWidget;

namespace suffuse {

class InspectorPanel;
class KeyboardFocus;
class StrokesPanel;

/// Which docks are shown, where all of them stand where they do at the first start.
enum class DockSet { Usual, Paint, Refine, Time };

/// Makes the panels and puts them where they stand at the first start.
class Docks : public QObject {
    Q_OBJECT

public:
    Docks(const Workplace &place, KeyboardFocus &keyboard, QObject *parent);
    ~Docks() override;

    /// In the order of their menu.
    const QList<QDockWidget *> &all() const { return m_docks; }
    /// Does what an entry of their menu does, by the keyboard: a dock that is hidden, or stands behind another one,
    /// comes to the front and gets the keyboard; one that is seen is hidden.
    void toggle(QAction &entry);
    /// Puts them where they stand at the first start, and shows those of a set.
    void arrangeAnew(DockSet set = DockSet::Usual);

private:
    /// Keys of a scope are the panel's as much as the canvas'. `page` is that of the manual.
    QDockWidget *add(const char *name, const char *page, const QString &title, QWidget *panel,
                     CommandScope scope = CommandScope::Window);
    void makeDocks();
    void stack();
    void shareRoom();
    void showOnly(DockSet set);
    void followTool();
    QDockWidget *makeTimeline();
    QDockWidget *makeProbe();
    QDockWidget *makeReference();
    void addRows(KeyboardFocus &keyboard);
    void addSelectingRows();
    void addAlongRow(InspectorPanel &inspector);
    void hide(bool hide);

    Workplace m_place;
    KeyboardFocus &m_keyboard;
    StrokesPanel *m_strokes = nullptr;
    QDockWidget *m_strokesDock = nullptr;
    QDockWidget *m_brushes = nullptr;
    QDockWidget *m_inspector = nullptr;
    QDockWidget *m_probe = nullptr;
    QDockWidget *m_reference = nullptr;
    QDockWidget *m_timeline = nullptr;
    QList<QDockWidget *> m_docks;
    QByteArray m_layout; ///< while they are hidden
    bool m_hidden = false;
};

} // namespace suffuse

#pragma once

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;

namespace suffuse {

class Commands;
class Editor;
class EntryField;
class Playback;
class TimelineView;

/// The Timeline, with a row of buttons to play it.
class TimelinePanel : public QWidget {
    Q_OBJECT

public:
    /// The buttons trigger commands of the window.
    TimelinePanel(Editor &editor, Playback &playback, const Commands &commands, QWidget *parent = nullptr);

    TimelineView *view() const { return m_view; }
    QComboBox *speed() const { return m_speed; }
    /// What is dragged, or why a speed was refused.
    QLabel *what() const { return m_what; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    void showTime();
    void showState();
    void showMenu(QPoint globalPosition, bool onBar);
    void takeSpeed(const QString &text);

    Editor &m_editor;
    Playback &m_playback;
    const Commands &m_commands;
    TimelineView *m_view = nullptr;
    QComboBox *m_speed = nullptr;
    EntryField *m_speedField = nullptr; ///< of `m_speed`
    QLabel *m_time = nullptr;
    QLabel *m_what = nullptr;
    QTimer m_later;
};

} // namespace suffuse

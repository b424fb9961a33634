// The tools of a window and the row over the canvas.
#pragma once

#include "app/window/workplace.h"

#include <QKeySequence>
#include <QObject>

class QAction;

namespace suffuse {

class TextTool;
class Tool;
class ToolOptionsBar;
enum class Command;

/// Makes the tools, and takes one into the hand when its command is switched on; while a stroke is in hand, when that
/// is finished.
class ToolRack : public QObject {
    Q_OBJECT

public:
    ToolRack(const Workplace &place, ToolOptionsBar &options, QObject *parent);

private:
    void addTools();
    /// The tool belongs to the canvas.
    void add(Command command, const QString &id, const QString &text, const char *icon, Qt::Key key, const QString &tip,
             Tool *tool);
    void use(Tool *tool);
    /// The pen's other end erases, whatever its tip does.
    void turnPen(bool eraser);

    Workplace m_place;
    ToolOptionsBar &m_options;
    TextTool *m_text = nullptr;
    Tool *m_next = nullptr;   ///< chosen while a stroke was in hand
    QAction *m_tip = nullptr; ///< of the tool that the pen's tip goes back to
};

} // namespace suffuse

#include "app/widgets/habits/compare_button.h"

#include "app/session/editor.h"
#include "undo/history/stroke_history.h"

namespace suffuse {

namespace {
constexpr int clickMs = 300; ///< a press that lasts longer counts as holding the button
}

CompareButton::CompareButton(Editor &editor, QWidget *parent) : QToolButton(parent), m_editor(editor)
{
    setText(tr("Before"));
    setToolTip(
        tr("Shows the picture as it was before the last changes to the selection: while held, or click to switch "
           "back and forth."));
    setFocusPolicy(Qt::TabFocus);
    setCheckable(true);
    connect(this, &QToolButton::pressed, this, [this] {
        m_held.start();
        m_wasOn = m_editor.compared() != nullptr;
        m_editor.setCompared(beforeEditsOfSelection(m_editor.undoStack(), m_editor.document(), m_editor.undecided()));
    });
    connect(this, &QToolButton::released, this, [this] {
        if (m_wasOn || m_held.elapsed() > clickMs)
            m_editor.setCompared(nullptr);
        refresh();
    });
    // The check mark follows the shown picture.
    connect(this, &QToolButton::clicked, this, &CompareButton::refresh);
    connect(&editor, &Editor::comparedChanged, this, &CompareButton::refresh);
    connect(&editor.undoStack(), &QUndoStack::indexChanged, this, &CompareButton::refresh);
    connect(&editor.laterChanges(), &LaterChanges::changed, this, &CompareButton::refresh);
    refresh();
}

void CompareButton::refresh()
{
    if (isDown())
        return;
    setChecked(m_editor.compared() != nullptr);
    setEnabled(endsWithEditOfSelection(m_editor.undoStack(), m_editor.document(), m_editor.undecided()));
}

} // namespace suffuse

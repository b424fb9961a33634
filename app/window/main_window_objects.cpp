// What the Object menu, Select Same, the canvas' aids and the underlay's commands do.
#include "app/canvas/canvas_widget.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_panel.h"
#include "app/session/commands/selection_commands.h"
#include "app/session/commands/session_rows.h"
#include "app/session/commands/underlay_commands.h"
#include "app/widgets/messages.h"
#include "app/window/main_window.h"

#include <QApplication>
#include <QInputDialog>
#include <QLineEdit>
#include <QStatusBar>

#include <algorithm>

namespace suffuse {

namespace {

/// What is to be renamed and how it is called.
struct PresentName {
    QString label;
    QString name;  ///< as it was typed; empty: none, or several
    QString title; ///< what people see where it has no name
};

/// Of the group that is selected as a whole, or else of the selected strokes; nothing where none are.
std::optional<PresentName> presentNameOf(const Document &document)
{
    const Painting &painting = *document.painting();
    const std::set<StrokeId> &selected = document.selection().strokes;
    if (const GroupId group = selectedGroup(document))
        for (const Group &g : painting.groups)
            if (g.id == group)
                return PresentName{MainWindow::tr("Name of the group"), g.name, titleOf(g)};
    if (selected.empty())
        return {};
    const StrokePtr first = painting.find(*selected.begin());
    const bool alike = std::all_of(selected.begin(), selected.end(),
                                   [&](StrokeId id) { return painting.find(id)->name == first->name; });
    return PresentName{MainWindow::tr("Name of %n stroke(s)", nullptr, int(selected.size())),
                       alike ? first->name : QString(), selected.size() == 1 ? titleOf(*first) : QStringLiteral("—")};
}

} // namespace

void MainWindow::addObjectRows()
{
    using enum Command;
    m_commands
        ->add(SelectAll, "selectAll", Commands::tr("Select &All"), "",
              QKeySequence::keyBindings(QKeySequence::SelectAll))
        .runs([this] {
            if (m_strokes->isSearching() && m_strokes->isAncestorOf(QApplication::focusWidget()))
                m_strokes->selectFound(); // all of what is to be seen there
            else if (!m_canvas->tool()->selectAll())
                commands::selectAll(m_editor);
        });
    m_commands
        ->add(SelectFound, "selectFound", Commands::tr("Select &Found"), "", {},
              Commands::tr("Select what the search in the Strokes dock has found"))
        .when([this] { return m_strokes->isSearching(); })
        .runs([this] { m_strokes->selectFound(); });
    m_commands->add(RenameStrokes, "rename", Commands::tr("Rena&me…"), "", {QKeySequence(Commands::tr("F2"))})
        .when(anySelected(m_editor))
        .runs([this] { renameSelected(); });
    connect(m_canvas, &CanvasWidget::underlayFailed, this,
            [this](const QString &problem) { statusBar()->showMessage(problem, 15'000); });
}

void MainWindow::importUnderlay(const QString &path)
{
    if (const QString problem = underlay::importFile(m_editor, path); !problem.isEmpty())
        showError(this, problem);
}

void MainWindow::renameSelected()
{
    const std::optional<PresentName> present = presentNameOf(m_editor.document());
    if (!present)
        return;
    QInputDialog dialog(this);
    dialog.setWindowTitle(tr("Rename"));
    dialog.setLabelText(present->label);
    dialog.setTextValue(present->name);
    if (auto *field = dialog.findChild<QLineEdit *>())
        field->setPlaceholderText(present->title);
    if (dialog.exec() == QDialog::Accepted)
        commands::renameSelected(m_editor, dialog.textValue());
}

} // namespace suffuse

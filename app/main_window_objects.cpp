// What the Object menu, Select Same, the canvas' aids and the underlay's commands do.
#include "app/canvas/canvas_widget.h"
#include "app/main_window.h"
#include "app/messages.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/selection_order.h"
#include "app/settings.h"
#include "app/tools/commands.h"
#include "app/underlay_commands.h"

#include <QInputDialog>
#include <QLineEdit>
#include <QStatusBar>

#include <algorithm>

namespace suffuse {

namespace {

struct AlignCommand {
    Command command;
    Align how;
};
constexpr AlignCommand alignCommands[] = {{Command::AlignLeft, Align::Left},     {Command::AlignCentre, Align::Centre},
                                          {Command::AlignRight, Align::Right},   {Command::AlignTop, Align::Top},
                                          {Command::AlignMiddle, Align::Middle}, {Command::AlignBottom, Align::Bottom}};

struct DistributeCommand {
    Command command;
    Axis axis;
    Spacing spacing;
};
constexpr DistributeCommand distributeCommands[] = {
    {Command::DistributeGapsAcross, Axis::Horizontal, Spacing::Gaps},
    {Command::DistributeGapsDown, Axis::Vertical, Spacing::Gaps},
    {Command::DistributeCentresAcross, Axis::Horizontal, Spacing::Centres},
    {Command::DistributeCentresDown, Axis::Vertical, Spacing::Centres}};

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

void MainWindow::connectObjectActions()
{
    const auto on = [this](Command command, auto function) {
        connect(&action(command), &QAction::triggered, this, function);
    };
    on(Command::InvertSelection, [this] { commands::invertSelection(m_editor); });
    on(Command::SameColour, [this] { commands::selectSameAs(m_editor, Same::Colour); });
    on(Command::SameStyle, [this] { commands::selectSameAs(m_editor, Same::Style); });
    on(Command::SameBrush, [this] { commands::selectSameAs(m_editor, Same::Brush); });
    on(Command::GroupStrokes, [this] { commands::groupSelected(m_editor); });
    on(Command::UngroupStrokes, [this] { commands::ungroupSelected(m_editor); });
    on(Command::LockStrokes, [this] { commands::lockSelected(m_editor); });
    on(Command::UnlockAll, [this] { commands::unlockAllStrokes(m_editor); });
    on(Command::HideStrokes, [this] { commands::hideSelected(m_editor); });
    on(Command::ShowAll, [this] { commands::showAllStrokes(m_editor); });
    on(Command::RenameStrokes, [this] { renameSelected(); });
    for (const AlignCommand &c : alignCommands)
        on(c.command, [this, how = c.how] {
            const auto is = [this](Command command) { return action(command).isChecked(); };
            const AlignTo to = is(Command::AlignToCanvas)                              ? AlignTo::Canvas
                               : is(Command::AlignToBiggest)                           ? AlignTo::Biggest
                               : is(Command::AlignToLast) || is(Command::AlignToFirst) ? AlignTo::Anchor
                                                                                       : AlignTo::Selection;
            const StrokeId anchor = is(Command::AlignToFirst) ? m_selectionOrder->first() : m_selectionOrder->last();
            commands::alignSelected(m_editor, how, to, anchor);
        });
    for (const DistributeCommand &c : distributeCommands)
        on(c.command, [this, c] { commands::distributeSelected(m_editor, c.axis, c.spacing); });
    m_selectionOrder = new SelectionOrder(m_editor.document(), this);
    for (const Command command : {Command::AlignToSelection, Command::AlignToLast, Command::AlignToFirst,
                                  Command::AlignToBiggest, Command::AlignToCanvas})
        on(command, [this] { updateObjectActions(); });
    const auto rule = [this] {
        return action(Command::ScaleSpread).isChecked() ? SpreadRule::Scales : SpreadRule::Stays;
    };
    on(Command::FlipAcross, [this, rule] { commands::flipSelected(m_editor, Axis::Horizontal, rule()); });
    on(Command::FlipDown, [this, rule] { commands::flipSelected(m_editor, Axis::Vertical, rule()); });
    on(Command::QuarterLeft, [this, rule] { commands::quarterTurnSelected(m_editor, -1, rule()); });
    on(Command::QuarterRight, [this, rule] { commands::quarterTurnSelected(m_editor, 1, rule()); });
    connect(&action(Command::ScaleSpread), &QAction::toggled, this, [](bool on) { settings::setScalesSpread(on); });
    connectAids();
    connectUnderlay();
}

void MainWindow::connectAids()
{
    m_canvas->setAids(settings::canvasAids());
    const auto change = [this](auto set) {
        return [this, set](auto value) {
            CanvasAids aids = m_canvas->aids();
            set(aids, value);
            m_canvas->setAids(aids);
            settings::setCanvasAids(aids);
        };
    };
    connect(&action(Command::SnapToNodes), &QAction::toggled, this,
            change([](CanvasAids &aids, bool on) { aids.snapToNodes = on; }));
    connect(&action(Command::SnapToGrid), &QAction::toggled, this,
            change([](CanvasAids &aids, bool on) { aids.snapToGrid = on; }));
    connect(&action(Command::ShowGrid), &QAction::toggled, this,
            change([](CanvasAids &aids, bool on) { aids.showGrid = on; }));
    connect(&action(Command::GridStep), &QAction::triggered, this, [this, change] {
        bool ok = false;
        const double step = QInputDialog::getDouble(this, tr("Grid"), tr("Step in canvas units"),
                                                    m_canvas->aids().gridStep, 0.001, maxGridStep, 3, &ok);
        if (ok)
            change([](CanvasAids &aids, double value) { aids.gridStep = value; })(step);
    });
}

void MainWindow::importUnderlay(const QString &path)
{
    if (const QString problem = underlay::importFile(m_editor, path); !problem.isEmpty())
        showError(this, problem);
}

void MainWindow::connectUnderlay()
{
    connect(&action(Command::ImportUnderlay), &QAction::triggered, this, [this] {
        if (const QString path = underlay::choose(this); !path.isEmpty())
            importUnderlay(path);
    });
    connect(&action(Command::ShowUnderlay), &QAction::triggered, this,
            [this](bool on) { underlay::show(m_editor, on); });
    connect(m_canvas, &CanvasWidget::underlayFailed, this,
            [this](const QString &problem) { statusBar()->showMessage(problem, 15'000); });
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

void MainWindow::updateObjectActions()
{
    const auto &underlay = m_editor.document().painting()->underlay;
    action(Command::ShowUnderlay).setEnabled(bool(underlay));
    action(Command::ShowUnderlay).setChecked(underlay && underlay->visible);
    const bool any = !m_editor.document().selection().isEmpty();
    const std::size_t count = m_editor.document().selection().strokes.size();
    for (const Command command :
         {Command::SameColour, Command::SameStyle, Command::SameBrush, Command::GroupStrokes, Command::UngroupStrokes,
          Command::LockStrokes, Command::HideStrokes, Command::RenameStrokes, Command::FlipAcross, Command::FlipDown,
          Command::QuarterLeft, Command::QuarterRight})
        action(command).setEnabled(any);
    const bool alone = action(Command::AlignToCanvas).isChecked();
    for (const AlignCommand &c : alignCommands)
        action(c.command).setEnabled(count > 1 || (any && alone));
    for (const DistributeCommand &c : distributeCommands)
        action(c.command).setEnabled(count > 2);
}

} // namespace suffuse

#include "app/panels/brushes/brush_menu.h"

#include "app/panels/brushes/brush_dialog.h"
#include "app/session/commands/restyling.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/asking/usual_folder.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>

namespace suffuse {

BrushMenu::BrushMenu(Editor &editor, QWidget *panel)
    : QMenu(panel), m_editor(editor), m_panel(panel), m_apply(new QMenu(tr("&Apply to Selection"), this))
{
    connect(this, &QMenu::aboutToShow, this, &BrushMenu::fill);
    const auto addPart = [this](const QString &text, BrushPart part) {
        m_apply->addAction(text, this, [this, part] { emit noted(commands::applyBrushInHand(m_editor, part)); });
    };
    addPart(tr("&Whole Brush"), BrushPart::Whole);
    addPart(tr("&Form Only"), BrushPart::Form);
    addPart(tr("&Colour Only"), BrushPart::Colour);
    addPart(tr("&Texture Only"), BrushPart::Texture);
}

QString BrushMenu::inHand() const
{
    return m_editor.brush().name;
}

void BrushMenu::fill()
{
    BrushLibrary &library = BrushLibrary::instance();
    const QString name = inHand();
    const bool own = library.isOwn(name), known = library.find(name) != nullptr;
    clear();
    const auto add = [this](const QString &text, bool enabled, auto slot) {
        QAction *action = addAction(text, this, slot);
        action->setEnabled(enabled);
        return action;
    };
    add(tr("&Edit Brush…"), true, &BrushMenu::showDialog);
    QAction *favourite = addAction(tr("&Favourite"));
    favourite->setCheckable(true);
    favourite->setEnabled(known);
    favourite->setChecked(library.isFavourite(name));
    connect(favourite, &QAction::triggered, this, [name](bool on) { BrushLibrary::instance().setFavourite(name, on); });
    m_apply->setEnabled(!m_editor.selection().isEmpty());
    addMenu(m_apply);
    addSeparator();
    add(tr("&Save Changes"), own && library.isChanged(m_editor.brush()), &BrushMenu::saveChanges);
    add(tr("Rel&oad"), library.isChanged(m_editor.brush()),
        [this] { BrushLibrary::instance().reload(m_editor, inHand()); });
    add(tr("Save as &New…"), true, &BrushMenu::saveAsNew);
    add(tr("&Duplicate"), known, [this] {
        Brush brush = *BrushLibrary::instance().find(inHand());
        brush.name = brushTitle(brush.name);
        Result<QString> added = BrushLibrary::instance().add(std::move(brush));
        if (!added)
            return noted(added.error());
        BrushLibrary::instance().use(m_editor, *added);
    });
    add(tr("&Rename…"), own, &BrushMenu::rename);
    add(tr("De&lete…"), own, &BrushMenu::remove);
    addSeparator();
    add(tr("&Import…"), true, &BrushMenu::import);
    add(tr("E&xport…"), known, &BrushMenu::exportBrush);
}

void BrushMenu::showDialog()
{
    if (!m_dialog) {
        m_dialog = new BrushDialog(m_editor, m_panel->window());
        connect(m_dialog, &BrushDialog::saveWanted, this, &BrushMenu::saveChanges);
        connect(m_dialog, &BrushDialog::saveAsNewWanted, this, &BrushMenu::saveAsNew);
    }
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void BrushMenu::saveChanges()
{
    BrushLibrary &library = BrushLibrary::instance();
    if (Result<void> saved = library.save(m_editor.brush()); !saved)
        emit noted(saved.error());
}

void BrushMenu::saveAsNew()
{
    bool taken = false;
    const QString name =
        QInputDialog::getText(m_panel, tr("Save Brush"), tr("Name"), QLineEdit::Normal, brushTitle(inHand()), &taken);
    if (!taken)
        return;
    Brush brush = m_editor.brush();
    const QString before = brush.name;
    brush.name = name;
    Result<QString> added = BrushLibrary::instance().add(brush);
    if (!added)
        return noted(added.error());
    BrushLibrary::instance().use(m_editor, *added);
    BrushLibrary::instance().forgetChanges(before); // They are in the new brush.
}

void BrushMenu::rename()
{
    bool taken = false;
    const QString before = inHand();
    const QString name =
        QInputDialog::getText(m_panel, tr("Rename Brush"), tr("Name"), QLineEdit::Normal, before, &taken);
    if (!taken)
        return;
    if (Result<void> renamed = BrushLibrary::instance().rename(before, name); !renamed)
        return noted(renamed.error());
    Brush brush = m_editor.brush();
    brush.name = name.simplified();
    emit noted({});
    m_editor.setBrush(brush);
}

void BrushMenu::remove()
{
    const QString name = inHand();
    if (!confirm(m_panel, tr("Delete the brush “%1”?").arg(name), tr("Strokes painted with it stay."), tr("&Delete")))
        return;
    if (Result<void> removed = BrushLibrary::instance().remove(name); !removed)
        return noted(removed.error());
    BrushLibrary::instance().use(m_editor, builtinBrushes().front().name);
}

void BrushMenu::import()
{
    const QStringList paths = QFileDialog::getOpenFileNames(m_panel, tr("Import Brushes"), usualFolder(brushFileEnding),
                                                            tr("Brushes (*.suffuse-brush *.myb);;All files (*)"));
    QStringList notes;
    if (!paths.isEmpty())
        keepUsualFolder(brushFileEnding, paths.front());
    for (const QString &path : paths) {
        QStringList left;
        Result<QString> added = BrushLibrary::instance().import(path, &left);
        if (!added) {
            notes << added.error();
            continue;
        }
        BrushLibrary::instance().use(m_editor, *added);
        if (!left.isEmpty())
            notes << tr("%1: these settings have no counterpart here: %2").arg(*added, left.join(QStringLiteral(", ")));
    }
    emit noted(notes.join('\n'));
}

void BrushMenu::exportBrush()
{
    const QString ending = QLatin1String(brushFileEnding);
    const QString path = chooseFileToSave(m_panel, tr("Export Brush"), brushTitle(inHand()) + '.' + ending,
                                          {{tr("Suffuse brush"), {ending}}});
    if (path.isEmpty())
        return;
    if (Result<void> written = BrushLibrary::instance().exportTo(inHand(), path); !written)
        emit noted(written.error());
}

} // namespace suffuse

// What can be done with the brush in hand and with brush files.
#include "app/panels/brushes/brush_dialog.h"
#include "app/panels/brushes/brush_panel.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/messages.h"
#include "app/widgets/save_name.h"
#include "app/widgets/section.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>

namespace suffuse {

void BrushPanel::fillMenu()
{
    BrushLibrary &library = BrushLibrary::instance();
    const QString name = inHand();
    const bool own = library.isOwn(name), known = library.find(name) != nullptr;
    m_menu->clear();
    const auto add = [this](const QString &text, bool enabled, auto slot) {
        QAction *action = m_menu->addAction(text, this, slot);
        action->setEnabled(enabled);
        return action;
    };
    add(tr("&Edit Brush…"), true, &BrushPanel::showDialog);
    QAction *favourite = m_menu->addAction(tr("&Favourite"));
    favourite->setCheckable(true);
    favourite->setEnabled(known);
    favourite->setChecked(library.isFavourite(name));
    connect(favourite, &QAction::triggered, this, [name](bool on) { BrushLibrary::instance().setFavourite(name, on); });
    m_menu->addSeparator();
    add(tr("&Save Changes"), own && isModified(), &BrushPanel::saveChanges);
    add(tr("Save as &New…"), true, &BrushPanel::saveAsNew);
    add(tr("&Duplicate"), known, [this] {
        Brush brush = *BrushLibrary::instance().find(inHand());
        brush.name = brushTitle(brush.name);
        Result<QString> added = BrushLibrary::instance().add(std::move(brush));
        if (!added)
            return note(added.error());
        BrushLibrary::instance().use(m_editor, *added);
    });
    add(tr("&Rename…"), own, &BrushPanel::rename);
    add(tr("De&lete…"), own, &BrushPanel::remove);
    m_menu->addSeparator();
    add(tr("&Import…"), true, &BrushPanel::import);
    add(tr("E&xport…"), known, &BrushPanel::exportBrush);
}

void BrushPanel::note(const QString &text)
{
    m_hint->showHint(text);
}

void BrushPanel::showDialog()
{
    if (!m_dialog) {
        m_dialog = new BrushDialog(m_editor, window());
        connect(m_dialog, &BrushDialog::saveWanted, this, &BrushPanel::saveChanges);
        connect(m_dialog, &BrushDialog::saveAsNewWanted, this, &BrushPanel::saveAsNew);
    }
    m_dialog->show();
    m_dialog->raise();
    m_dialog->activateWindow();
}

void BrushPanel::saveChanges()
{
    BrushLibrary &library = BrushLibrary::instance();
    if (Result<void> saved = library.save(m_editor.brush()); !saved)
        note(saved.error());
}

void BrushPanel::saveAsNew()
{
    bool taken = false;
    const QString name =
        QInputDialog::getText(this, tr("Save Brush"), tr("Name"), QLineEdit::Normal, brushTitle(inHand()), &taken);
    if (!taken)
        return;
    Brush brush = m_editor.brush();
    brush.name = name;
    Result<QString> added = BrushLibrary::instance().add(brush);
    if (!added)
        return note(added.error());
    BrushLibrary::instance().use(m_editor, *added);
}

void BrushPanel::rename()
{
    bool taken = false;
    const QString before = inHand();
    const QString name = QInputDialog::getText(this, tr("Rename Brush"), tr("Name"), QLineEdit::Normal, before, &taken);
    if (!taken)
        return;
    if (Result<void> renamed = BrushLibrary::instance().rename(before, name); !renamed)
        return note(renamed.error());
    edit([&](Brush &b) { b.name = name.simplified(); });
}

void BrushPanel::remove()
{
    const QString name = inHand();
    if (!confirm(this, tr("Delete the brush “%1”?").arg(name), tr("Strokes painted with it stay."), tr("&Delete")))
        return;
    if (Result<void> removed = BrushLibrary::instance().remove(name); !removed)
        return note(removed.error());
    BrushLibrary::instance().use(m_editor, builtinBrushes().front().name);
}

void BrushPanel::import()
{
    const QStringList paths = QFileDialog::getOpenFileNames(this, tr("Import Brushes"), {},
                                                            tr("Brushes (*.suffuse-brush *.myb);;All files (*)"));
    QStringList notes;
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
    note(notes.join('\n'));
}

void BrushPanel::exportBrush()
{
    const QString ending = QLatin1String(brushFileEnding);
    const QString path = chooseFileToSave(this, tr("Export Brush"), brushTitle(inHand()) + '.' + ending,
                                          {{tr("Suffuse brush"), {ending}}});
    if (path.isEmpty())
        return;
    if (Result<void> written = BrushLibrary::instance().exportTo(inHand(), path); !written)
        note(written.error());
}

} // namespace suffuse

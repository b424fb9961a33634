#include "app/panels/colour/swatches_section.h"

#include "app/session/colour/colour_target.h"
#include "app/session/colour/recolouring.h"
#include "app/session/editor.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/asking/usual_folder.h"
#include "app/widgets/colour/swatch_grid.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "model/formats/brushes/gimp_palette.h"
#include "model/formats/files.h"
#include "undo/swatch_edits.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QToolButton>

namespace suffuse {

namespace {

QToolButton *iconButton(const char *name, const QString &text, const QString &tip, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setIcon(icon(name));
    button->setAutoRaise(true);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    return button;
}

} // namespace

SwatchesSection::SwatchesSection(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto *head = new QHBoxLayout;
    head->setSpacing(0);
    head->addWidget(sectionTitle(tr("Swatches"), this), 1);
    m_add = iconButton("plus", tr("Add swatch"), tr("Keeps the current colour with the painting."), this);
    m_menu = iconButton("menu", tr("Palettes"), tr("GIMP palettes in and out"), this);
    head->addWidget(m_add);
    head->addWidget(m_menu);
    column->addLayout(head);
    m_grid = new SwatchGrid(true, this);
    m_grid->setAccessibleName(tr("Swatches"));
    m_grid->setToolTip(tr("Colours kept with the painting. Click: take it. Drag to move; Delete removes."));
    m_grid->setEmptyText(tr("None yet: + keeps the current colour."));
    // The list scrolls, so it stays beside the wheel however many swatches there are.
    auto *scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    scroll->setMinimumSize(m_grid->minimumSizeHint());
    scroll->setWidget(m_grid);
    column->addWidget(scroll, 1);
    addMenu();

    ColourTarget &target = editor.colourTarget();
    connect(m_add, &QToolButton::clicked, this,
            [this, &target] { m_grid->insert(int(m_grid->swatches().size()), target.colour()); });
    connect(m_grid, &SwatchGrid::picked, this, [&target](const Colour &colour) {
        target.endSwatch(); // A swatch is taken, not changed, by a click on another one.
        target.take(colour);
    });
    connect(m_grid, &SwatchGrid::changeWanted, this, [&target](int index) { target.editSwatch(std::size_t(index)); });
    connect(m_grid, &SwatchGrid::usersWanted, this,
            [this](int index) { selectColour(m_editor, m_grid->swatches()[std::size_t(index)].colour); });
    connect(&target, &ColourTarget::changed, this, [this, &target] {
        m_grid->setEdited(target.kind() == ColourTarget::Kind::Swatch ? int(target.swatch()) : -1);
    });
    connect(m_grid, &SwatchGrid::edited, this, &SwatchesSection::push);
    connect(&editor.document(), &Document::changed, this, [this](const Change &change) {
        if (change.canvas || change.reset)
            refresh();
    });
    refresh();
}

void SwatchesSection::addMenu()
{
    auto *menu = new QMenu(m_menu);
    const QString filter = tr("GIMP palettes") + QStringLiteral(" (*.gpl)");
    menu->addAction(tr("Import Palette…"), this, [=, this] {
        const QString kind = QStringLiteral("gpl");
        const QString path = QFileDialog::getOpenFileName(this, tr("Import palette"), usualFolder(kind), filter);
        if (path.isEmpty())
            return;
        keepUsualFolder(kind, path);
        importPalette(path);
    });
    m_export = menu->addAction(tr("Export Palette…"), this, [=, this] {
        const QString path =
            chooseFileToSave(this, tr("Export palette"), QString(), {{tr("GIMP palettes"), {QStringLiteral("gpl")}}});
        if (!path.isEmpty())
            exportPalette(path);
    });
    menu->addSeparator();
    m_map = menu->addAction(tr("Map Colours to Swatches"), this, [this] { mapToSwatches(m_editor); });
    m_map->setToolTip(tr("Gives what is selected, or else all of the painting, the swatch that looks nearest"));
    menu->addSeparator();
    m_clear = menu->addAction(tr("Remove All"), this, [this] { push({}, tr("Remove all swatches")); });
    m_menu->setMenu(menu);
    m_menu->setPopupMode(QToolButton::InstantPopup);
}

void SwatchesSection::importPalette(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return showError(this, tr("%1 cannot be read: %2.").arg(path, file.errorString()));
    const Result<GimpPalette> palette = readGimpPalette(file.read((1 << 20) + 1), path);
    if (!palette)
        return showError(this, palette.error());
    std::vector<Swatch> swatches = m_grid->swatches();
    swatches.insert(swatches.end(), palette->swatches.begin(), palette->swatches.end());
    push(swatches, tr("Import palette"));
}

void SwatchesSection::exportPalette(const QString &path)
{
    const GimpPalette palette{QFileInfo(path).completeBaseName(), m_grid->swatches()};
    if (const Result<void> written = writeFileAtomically(path, writeGimpPalette(palette)); !written)
        showError(this, written.error());
}

void SwatchesSection::push(const std::vector<Swatch> &swatches, const QString &undoText)
{
    m_editor.push(setSwatches(m_editor.document(), swatches), undoText);
}

void SwatchesSection::refresh()
{
    m_grid->setSwatches(m_editor.document().painting()->swatches);
    m_export->setEnabled(!m_grid->swatches().empty());
    m_map->setEnabled(!m_grid->swatches().empty());
    m_clear->setEnabled(!m_grid->swatches().empty());
}

} // namespace suffuse

#include "app/tools/brush/brush_palette.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/commands/session_rows.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/colour/colour_chips.h"
#include "app/widgets/colour/colour_rows.h"
#include "app/widgets/colour/colour_swatch.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/brush/brush_width.h"
#include "model/colour/colour_shift.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

namespace {

constexpr int brushColumns = 3, brushRows = 4;
constexpr int chipColumns = 7;
constexpr qsizetype recentShown = 14;
constexpr double leastZoom = 0.02, mostZoom = 64; ///< of the slider

/// What was painted with last, in this window or another, as the Colour dock keeps it.
std::vector<Colour> recentColours()
{
    std::vector<Colour> colours;
    for (const QString &text : settings::store().value("recentColours").toStringList().mid(0, recentShown))
        if (const std::optional<Colour> colour = colourOfText(text))
            colours.push_back(*colour);
    return colours;
}

FieldSpec zoomSpec()
{
    return {.name = BrushPalette::tr("Zoom"),
            .toolTip = BrushPalette::tr("How large the painting is shown"),
            .display = shareDisplay(),
            .minimum = 1e-4,
            .maximum = 1e6,
            .sliderMinimum = leastZoom,
            .sliderMaximum = mostZoom,
            .logarithmic = true,
            .defaultValue = 1};
}

} // namespace

BrushPalette::BrushPalette(CanvasWidget &canvas, const Commands &commands)
    : FloatingCard(canvas), m_canvas(canvas), m_editor(canvas.editor()), m_commands(commands)
{
    setAccessibleName(tr("Brush palette"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(10, 10, 10, 10);
    row->setSpacing(12);
    row->addWidget(makeBrushes());
    auto *side = new QVBoxLayout;
    side->setSpacing(10);
    side->addWidget(makeColours());
    side->addStretch(1);
    side->addWidget(makeNumbers());
    row->addLayout(side);
    const auto refreshOpen = [this] {
        if (isOpen())
            refresh();
    };
    connect(&m_editor, &Editor::brushChanged, this, refreshOpen);
    connect(&m_editor.colourTarget(), &ColourTarget::changed, this, refreshOpen);
    connect(&canvas, &CanvasWidget::viewChanged, this, [this] { m_zoom->setValue(m_canvas.view().scale); });
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, [this] {
        if (isOpen())
            fillBrushes();
    });
}

QWidget *BrushPalette::makeBrushes()
{
    m_grid = new BrushGrid(this);
    m_grid->setFixedSize(m_grid->sizeFor(brushColumns, brushRows));
    m_grid->setToolTip(tr("Choose what to paint with. The colour stays."));
    connect(m_grid, &QListWidget::currentItemChanged, this,
            [this](const QListWidgetItem *item) { take(BrushGrid::brushOf(item)); });
    connect(m_grid, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem *item) { take(BrushGrid::brushOf(item)); });
    connect(m_grid, &QListWidget::itemDoubleClicked, this, [this] { close(); });
    return m_grid;
}

QWidget *BrushPalette::makeColours()
{
    auto *part = new QWidget(this);
    auto *column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto *head = new QHBoxLayout;
    m_colour = new ColourSwatch(part);
    m_colour->setFocusPolicy(Qt::NoFocus);
    m_colour->setAccessibleName(tr("Current colour"));
    m_whose = sectionTitle(QString(), part);
    m_whose->setMinimumWidth(1); // A long name of a swatch makes the palette no wider.
    head->addWidget(m_whose, 1);
    head->addWidget(m_colour);
    column->addLayout(head);
    m_near = new ColourChips(chipColumns, part);
    m_near->setAccessibleName(tr("Near colours"));
    m_near->setToolTip(tr("Lighter and darker, the neighbouring hues, and from grey to full"));
    column->addWidget(m_near);
    column->addWidget(quietLabel(tr("Painted with last"), part));
    m_recent = new ColourChips(chipColumns, part);
    m_recent->showOpacity();
    m_recent->setAccessibleName(tr("Recent colours"));
    column->addWidget(m_recent);
    connect(m_near, &ColourChips::picked, this, [this](const Colour &colour) {
        const QScopedValueRollback<bool> picking(m_picking, true);
        m_editor.colourTarget().setPaint(colour);
    });
    connect(m_recent, &ColourChips::picked, &m_editor.colourTarget(),
            [this](const Colour &colour) { m_editor.colourTarget().setPaint(colour); });
    return part;
}

QWidget *BrushPalette::makeNumbers()
{
    auto *part = new QWidget(this);
    auto *column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    QGridLayout *grid = addFieldGrid(*column);
    m_size = new SliderField(specOf(Quantity::Size), *grid, 0, part);
    m_flow = new SliderField(specOf(Quantity::Flow), *grid, 1, part);
    m_opacity = new SliderField(specOf(Quantity::Opacity), *grid, 2, part);
    m_zoom = new SliderField(zoomSpec(), *grid, 3, part);
    connect(m_size, &SliderField::edited, this,
            [this](double width) { edit([=](Brush &b) { setVisibleWidth(b, width); }); });
    connect(m_flow, &SliderField::edited, this, [this](double peak) { edit([=](Brush &b) { b.peak = float(peak); }); });
    connect(m_opacity, &SliderField::editedRelative, this, [this](const ValueMap &map) {
        m_editor.colourTarget().changeEach(
            [&map](const Colour &each) { return withOpacity(each, float(map(each.opacity).value_or(each.opacity))); });
    });
    connect(m_opacity, &SliderField::edited, &m_editor.colourTarget(),
            [this](double opacity, ValueEntry *entry) { m_editor.colourTarget().setOpacity(float(opacity), entry); });
    connect(m_zoom, &SliderField::edited, this, [this](double scale) { m_canvas.setZoom(scale); });
    auto *hint = new HintLabel(part);
    column->addWidget(hint);
    for (SliderField *field : {m_size, m_flow, m_opacity, m_zoom})
        connect(field, &SliderField::refused, hint, &HintLabel::showRefusal);
    return part;
}

void BrushPalette::fillBrushes()
{
    QStringList names = BrushLibrary::instance().favourites();
    if (!names.contains(firstBrush().name))
        names.prepend(firstBrush().name);
    for (const Brush &brush : BrushLibrary::instance().brushes())
        if (!names.contains(brush.name))
            names << brush.name;
    m_grid->fill(names);
    m_grid->showInHand(m_editor.brush());
}

void BrushPalette::openAt(QPoint global)
{
    fillBrushes();
    m_recent->setColours(recentColours());
    refreshNear();
    refresh();
    m_zoom->setValue(m_canvas.view().scale);
    layout()->activate();
    const QSize wanted = sizeHint();
    FloatingCard::openAt(global, {wanted.width() - m_near->sizeHint().width() / 2, wanted.height() / 3}, m_grid);
    m_grid->scrollToItem(m_grid->currentItem());
}

void BrushPalette::take(const QString &brush)
{
    if (brush.isEmpty())
        return;
    if (brush != m_editor.brush().name)
        BrushLibrary::instance().use(m_editor, brush);
    takeToPaint(m_commands, m_editor);
}

void BrushPalette::edit(const std::function<void(Brush &)> &change)
{
    Brush brush = m_editor.brush();
    change(brush);
    m_editor.setBrush(brush);
}

void BrushPalette::refreshNear()
{
    m_near->setColours(nearColours(m_editor.colourTarget().colour()));
}

void BrushPalette::refresh()
{
    const Brush &brush = m_editor.brush();
    m_grid->showInHand(brush);
    const Colour colour = m_editor.colourTarget().colour();
    const ColourTarget &target = m_editor.colourTarget();
    const ColourSummary summary = target.kind() == ColourTarget::Kind::Selection ? target.selected() : ColourSummary();
    m_colour->setColour(colour);
    m_colour->setOther(summary.other);
    m_colour->setToolTip(m_editor.colourTarget().title());
    m_whose->setText(m_editor.colourTarget().title());
    m_whose->setToolTip(m_editor.colourTarget().title());
    if (!m_picking)
        refreshNear();
    m_size->setValue(visibleWidth(brush));
    m_flow->setValue(double(brush.peak));
    m_opacity->setValue(double(colour.opacity));
    m_opacity->setOneOfSeveral(summary.differ[ColourRows::Opacity]);
}

} // namespace suffuse

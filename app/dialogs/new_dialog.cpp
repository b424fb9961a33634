#include "app/dialogs/new_dialog.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/length_units.h"
#include "app/widgets/numbers/number_field.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/painting/validate.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

/// What sides are given in, in the order of the list.
enum SideUnit { InPixels, InMillimetres, InInches };

Display displayIn(int unit, double resolution)
{
    switch (unit) {
    case InMillimetres:
        return {.unit = millimetreUnit(),
                .factor = millimetresOfInch / resolution,
                .decimals = 1,
                .resolution = resolution};
    case InInches:
        return {.unit = inchUnit(), .factor = 1 / resolution, .decimals = 2, .resolution = resolution};
    default:
        break;
    }
    Display pixels = screenDisplay();
    pixels.resolution = resolution;
    return pixels;
}

int unitOfPaper()
{
    return QLocale::system().measurementSystem() == QLocale::MetricSystem ? InMillimetres : InInches;
}

Canvas lastCanvas()
{
    Canvas canvas = Editor::usualCanvas();
    const QSettings &s = settings::store();
    canvas.width = s.value("newCanvas/width", canvas.width).toDouble();
    canvas.height = s.value("newCanvas/height", canvas.height).toDouble();
    return problemOf(canvas).isEmpty() ? canvas : Editor::usualCanvas();
}

} // namespace

NewDialog::NewDialog(QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("New Painting"));
    setHelpPage(*this, "first-painting");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);

    auto *row = new QHBoxLayout;
    addPresets(*row);
    column->addLayout(row);
    auto *measure = new QHBoxLayout;
    addUnits(*measure);
    column->addLayout(measure);

    m_section = new CanvasSection(this);
    m_lengths = new LengthUnits(*m_section, usualResolution);
    m_section->setMinimumWidth(340);
    m_section->setCanvas(lastCanvas());
    alignFieldLabels(*m_section);
    column->addWidget(m_section);
    auto *hint = new HintLabel(this);
    column->addWidget(hint);
    column->addStretch(1);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setText(tr("C&reate"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_section, &CanvasSection::edited, this, &NewDialog::showPreset);
    connect(m_section, &CanvasSection::refused, hint, &HintLabel::showRefusal);
    connect(m_resolution, &NumberField::refused, hint, &HintLabel::showRefusal);
    giveMnemonics(*this);
    takeUnit();
}

void NewDialog::addPresets(QHBoxLayout &row)
{
    auto *label = new QLabel(tr("Sheet"), this);
    m_presets = new QComboBox(this);
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        if (i > 0 && m_sheets[i].section != m_sheets[i - 1].section)
            m_presets->insertSeparator(m_presets->count());
        m_presets->addItem(m_sheets[i].name + QStringLiteral(" — ") + m_sheets[i].size, int(i));
    }
    m_presets->setPlaceholderText(tr("Custom"));
    m_presets->setAccessibleName(tr("Sheet"));
    m_presets->setToolTip(tr("Usual sizes, and sheets with a ground of their own"));
    label->setBuddy(m_presets);
    auto *swap = new QToolButton(this);
    swap->setIcon(icon("swap"));
    swap->setAccessibleName(tr("Swap width and height"));
    swap->setToolTip(tr("Swap width and height"));
    row.addWidget(label);
    row.addWidget(m_presets, 1);
    row.addWidget(swap);
    connect(m_presets, &QComboBox::activated, this, &NewDialog::takePreset);
    connect(swap, &QToolButton::clicked, this, &NewDialog::swapSides);
}

void NewDialog::addUnits(QHBoxLayout &row)
{
    const QSettings &s = settings::store();
    auto *label = new QLabel(tr("Sides in"), this);
    m_units = new QComboBox(this);
    m_units->addItems({tr("Pixels"), tr("Millimetres"), tr("Inches")});
    m_units->setCurrentIndex(
        std::clamp(s.value("newCanvas/unit", int(InPixels)).toInt(), int(InPixels), int(InInches)));
    m_units->setAccessibleName(tr("Sides in"));
    m_units->setToolTip(tr("What width and height are given in. A pixel is a unit of the canvas."));
    label->setBuddy(m_units);
    auto *resolutionLabel = new QLabel(tr("Resolution"), this);
    m_resolution = new NumberField(this);
    m_resolution->setRange(leastResolution, mostResolution);
    m_resolution->setDisplay({.unit = tr(" dpi"), .decimals = 1});
    m_resolution->setStep(10);
    const double kept = s.value("newCanvas/resolution", usualResolution).toDouble();
    m_resolution->setValue(isResolution(kept) ? kept : usualResolution);
    m_resolution->setAccessibleName(tr("Resolution"));
    m_resolution->setToolTip(tr("Pixels for each inch of paper. The sheet stays as large on paper."));
    resolutionLabel->setBuddy(m_resolution);
    row.addWidget(label);
    row.addWidget(m_units, 1);
    row.addWidget(resolutionLabel);
    row.addWidget(m_resolution);
    connect(m_units, &QComboBox::activated, this, &NewDialog::takeUnit);
    for (const auto signal : {&NumberField::entered, &NumberField::stepped})
        connect(m_resolution, signal, this, &NewDialog::takeResolution);
}

const Canvas &NewDialog::canvas() const
{
    return m_section->canvas();
}

NewSheet NewDialog::sheet() const
{
    const bool isPaper = m_units->currentIndex() != InPixels || (preset() && !preset()->paper.isEmpty());
    return {canvas(), isPaper ? *m_resolution->value() : 0};
}

/// The sheet that is shown as chosen; null: another one.
const SheetPreset *NewDialog::preset() const
{
    const int index = m_presets->currentIndex();
    return index < 0 ? nullptr : &m_sheets[std::size_t(m_presets->itemData(index).toInt())];
}

void NewDialog::takePreset(int index)
{
    const SheetPreset &sheet = m_sheets[std::size_t(m_presets->itemData(index).toInt())];
    const QSizeF sides = sheet.sides(*m_resolution->value());
    Canvas canvas = sheet.hasGround ? sheet.canvas : m_section->canvas();
    canvas.width = sides.width();
    canvas.height = sides.height();
    m_section->setCanvas(canvas);
    const bool isPaper = !sheet.paper.isEmpty();
    if (isPaper != (m_units->currentIndex() != InPixels))
        m_units->setCurrentIndex(isPaper ? unitOfPaper() : InPixels);
    takeUnit();
}

/// The sheet stays as it is, and its sides are shown otherwise.
void NewDialog::takeUnit()
{
    const int unit = m_units->currentIndex();
    m_resolution->setEnabled(unit != InPixels);
    m_section->setSideDisplay(displayIn(unit, *m_resolution->value()), unit != InPixels);
    showPreset();
}

/// The sheet stays as large on paper, and has more or fewer units.
void NewDialog::takeResolution(double resolution)
{
    const double factor = resolution / *m_resolution->value();
    Canvas canvas = m_section->canvas();
    for (double *side : {&canvas.width, &canvas.height})
        *side = std::max(1.0, std::round(*side * factor));
    if (const SheetPreset *shown = preset()) { // Rounding twice would lose it.
        const QSizeF sides = shown->sides(resolution);
        canvas.width = sides.width(), canvas.height = sides.height();
    }
    m_resolution->setValue(resolution);
    if (problemOf(canvas).isEmpty())
        m_section->setCanvas(canvas);
    takeUnit();
}

void NewDialog::swapSides()
{
    Canvas canvas = m_section->canvas();
    std::swap(canvas.width, canvas.height);
    m_section->setCanvas(canvas);
    showPreset();
}

/// The first sheet that it is; one with a ground of its own only with this ground.
void NewDialog::showPreset()
{
    const auto isShown = [this](const SheetPreset &sheet) {
        return sheet.sides(*m_resolution->value()) == QSizeF(canvas().width, canvas().height) &&
               (!sheet.hasGround ||
                (sheet.canvas.background == canvas().background && sheet.canvas.paper == canvas().paper));
    };
    int index = -1;
    for (std::size_t i = 0; i < m_sheets.size(); ++i)
        if (isShown(m_sheets[i]) && (index < 0 || m_sheets[i].hasGround))
            index = int(i);
    m_presets->setCurrentIndex(index < 0 ? -1 : m_presets->findData(index));
    const double resolution = sheet().resolution;
    m_lengths->setResolution(isResolution(resolution) ? resolution : usualResolution);
}

std::optional<NewSheet> NewDialog::ask(QWidget *parent)
{
    NewDialog dialog(parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    settings::store().setValue("newCanvas/width", dialog.canvas().width);
    settings::store().setValue("newCanvas/height", dialog.canvas().height);
    settings::store().setValue("newCanvas/unit", dialog.units()->currentIndex());
    settings::store().setValue("newCanvas/resolution", *dialog.resolution()->value());
    return dialog.sheet();
}

} // namespace suffuse

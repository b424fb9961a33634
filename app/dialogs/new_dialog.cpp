#include "app/dialogs/new_dialog.h"

#include "app/session/editor.h"
#include "app/session/settings/settings.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/paper/canvas_section.h"
#include "model/painting/validate.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

struct SizePreset {
    QString name;
    double width;
    double height;
};

/// The usual sizes, with their names in the present language.
std::vector<SizePreset> sizePresets()
{
    return {{NewDialog::tr("Sketch"), 1024, 768},      {NewDialog::tr("Full HD"), 1920, 1080},
            {NewDialog::tr("4K"), 3840, 2160},         {NewDialog::tr("Square"), 1080, 1080},
            {NewDialog::tr("A5, 150 dpi"), 1240, 874}, {NewDialog::tr("A4, 150 dpi"), 1754, 1240},
            {NewDialog::tr("A4, 300 dpi"), 3508, 2480}};
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
    auto *label = new QLabel(tr("Size"), this);
    m_presets = new QComboBox(this);
    for (const SizePreset &preset : sizePresets())
        m_presets->addItem(QStringLiteral("%1 — %2 × %3").arg(preset.name).arg(preset.width).arg(preset.height));
    m_presets->setPlaceholderText(tr("Custom"));
    m_presets->setAccessibleName(tr("Size"));
    m_presets->setToolTip(tr("Usual sizes in units; a unit is a pixel at 100 %."));
    label->setBuddy(m_presets);
    auto *swap = new QToolButton(this);
    swap->setIcon(icon("swap"));
    swap->setAccessibleName(tr("Swap width and height"));
    swap->setToolTip(tr("Swap width and height"));
    row->addWidget(label);
    row->addWidget(m_presets, 1);
    row->addWidget(swap);
    column->addLayout(row);

    m_section = new CanvasSection(this);
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
    connect(m_presets, &QComboBox::activated, this, &NewDialog::takePreset);
    connect(swap, &QToolButton::clicked, this, &NewDialog::swapSides);
    connect(m_section, &CanvasSection::edited, this, &NewDialog::showPreset);
    connect(m_section, &CanvasSection::refused, hint, &HintLabel::showRefusal);
    giveMnemonics(*this);
    showPreset();
}

const Canvas &NewDialog::canvas() const
{
    return m_section->canvas();
}

void NewDialog::takePreset(int index)
{
    Canvas canvas = m_section->canvas();
    canvas.width = sizePresets()[std::size_t(index)].width;
    canvas.height = sizePresets()[std::size_t(index)].height;
    m_section->setCanvas(canvas);
}

void NewDialog::swapSides()
{
    Canvas canvas = m_section->canvas();
    std::swap(canvas.width, canvas.height);
    m_section->setCanvas(canvas);
    showPreset();
}

void NewDialog::showPreset()
{
    int index = -1;
    for (std::size_t i = 0; i < sizePresets().size(); ++i)
        if (sizePresets()[i].width == canvas().width && sizePresets()[i].height == canvas().height)
            index = int(i);
    m_presets->setCurrentIndex(index);
}

std::optional<Canvas> NewDialog::ask(QWidget *parent)
{
    NewDialog dialog(parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    settings::store().setValue("newCanvas/width", dialog.canvas().width);
    settings::store().setValue("newCanvas/height", dialog.canvas().height);
    return dialog.canvas();
}

} // namespace suffuse

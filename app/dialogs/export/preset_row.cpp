#include "app/dialogs/export/preset_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>

namespace suffuse {

PresetRow::PresetRow(QGridLayout &grid, int row, std::function<ExportSettings()> present, QWidget *parent)
    : QWidget(parent), m_present(std::move(present))
{
    auto *label = new QLabel(tr("Preset"), parent);
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    m_box = new QComboBox(this);
    m_box->setPlaceholderText(tr("None"));
    m_box->setAccessibleName(tr("Preset"));
    m_box->setToolTip(tr("Format, depth, quality, resolution, size, area and moment under a name"));
    m_save = new QPushButton(tr("&Save…"), this);
    m_save->setToolTip(tr("Keep what is set here as a preset"));
    m_remove = new QPushButton(tr("&Remove"), this);
    m_remove->setToolTip(tr("Forget the chosen preset"));
    label->setBuddy(m_box);
    line->addWidget(m_box, 1);
    for (QPushButton *button : {m_save, m_remove}) {
        button->setAutoDefault(false);
        line->addWidget(button);
    }
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
    connect(m_box, &QComboBox::activated, this, [this] {
        m_remove->setEnabled(true);
        if (const auto settings = exports::preset(m_box->currentText()))
            emit chosen(*settings);
    });
    connect(m_save, &QPushButton::clicked, this, &PresetRow::askForName);
    connect(m_remove, &QPushButton::clicked, this, &PresetRow::removeChosen);
    fill({});
}

void PresetRow::fill(const QString &chosen)
{
    m_box->clear();
    m_box->addItems(exports::presets());
    m_box->setCurrentIndex(m_box->findText(chosen));
    m_box->setEnabled(m_box->count() > 0);
    m_remove->setEnabled(m_box->currentIndex() >= 0);
}

void PresetRow::saveAs(const QString &name)
{
    exports::setPreset(name, m_present());
    fill(name);
}

void PresetRow::showPresetOf(const ExportSettings &settings)
{
    const QStringList names = exports::presets();
    const auto name = std::ranges::find_if(names, [&settings](const QString &name) {
        const std::optional<ExportSettings> preset = exports::preset(name);
        return preset && preset->writesAs(settings);
    });
    fill(name != names.end() ? *name : QString());
}

void PresetRow::askForName()
{
    bool given = false;
    const QString name =
        QInputDialog::getText(this, tr("Save Preset"), tr("Name"), QLineEdit::Normal, m_box->currentText(), &given)
            .trimmed();
    if (!given || name.isEmpty())
        return;
    if (exports::presets().contains(name) &&
        QMessageBox::question(this, tr("Save Preset"), tr("There is a preset “%1”. Replace it?").arg(name)) !=
            QMessageBox::Yes)
        return;
    saveAs(name);
}

void PresetRow::removeChosen()
{
    exports::removePreset(m_box->currentText());
    fill({});
}

} // namespace suffuse

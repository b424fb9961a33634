#include "app/dialogs/export/exporting_dialog.h"

#include "app/dialogs/export/export_rows.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/asking/save_name.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/decimal_box.h"
#include "render/image_io/image_io.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>

namespace suffuse {

ExportingDialog::ExportingDialog(const QString &title, QStandardPaths::StandardLocation place, QWidget *parent)
    : QDialog(parent), m_place(place), m_form(new QWidget(this)), m_grid(new QGridLayout(m_form)),
      m_column(new QVBoxLayout(this))
{
    setWindowTitle(title);
    setHelpPage(*this, "exchange");
    setMinimumWidth(480);
    m_column->setContentsMargins(16, 16, 16, 16);
    m_column->setSpacing(12);
    m_column->addWidget(m_form);
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(16);
    m_grid->setVerticalSpacing(8);
    m_grid->setColumnStretch(1, 1);
}

void ExportingDialog::addField(int row, const QString &name, QWidget *field, const QString &tip, int columns,
                               Qt::Alignment alignment)
{
    auto *label = new QLabel(name, m_form);
    label->setBuddy(field);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    m_grid->addWidget(label, row, 0);
    m_grid->addWidget(field, row, 1, 1, columns, alignment);
}

void ExportingDialog::addFile(int row, const QString &tip)
{
    m_path = new QLineEdit(m_form);
    addField(row, tr("File"), m_path, tip, 1);
    m_browse = new QPushButton(tr("&Browse…"), m_form);
    m_browse->setToolTip(tr("Choose a folder and a name"));
    m_browse->setAutoDefault(false);
    m_grid->addWidget(m_browse, row, 2);
    connect(m_browse, &QPushButton::clicked, this, &ExportingDialog::browse);
}

void ExportingDialog::setFileEnabled(bool enabled)
{
    m_path->setEnabled(enabled);
    m_browse->setEnabled(enabled);
}

void ExportingDialog::addQuality(int row, Qt::Alignment alignment)
{
    m_quality = new WholeBox(m_form);
    m_quality->setRange(1, 100);
    m_quality->setValue(ImageOptions{}.quality);
    addField(row, tr("Quality"), m_quality, tr("Of JPEG and WebP; 100 is the best. WebP loses nothing then."), 2,
             alignment);
}

void ExportingDialog::addTransparent(int row)
{
    m_transparent = new QCheckBox(tr("Transparent background"), m_form);
    m_transparent->setToolTip(tr("Leaves the background out and stores how much the paint covers."));
    m_transparent->setAccessibleName(m_transparent->text());
    m_grid->addWidget(m_transparent, row, 1, 1, 2);
}

void ExportingDialog::addWork(const QString &iconName, const QString &verb)
{
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->hide();
    m_column->addWidget(m_progress);
    m_hint = new HintLabel(this);
    m_column->addWidget(m_hint);
    m_column->addStretch(1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_export = buttons->addButton(verb.isEmpty() ? tr("&Export") : verb, QDialogButtonBox::AcceptRole);
    m_export->setDefault(true);
    m_export->setIcon(icon(iconName));
    m_cancel = buttons->button(QDialogButtonBox::Cancel);
    m_column->addWidget(buttons);
    connect(m_export, &QPushButton::clicked, this, &ExportingDialog::startExport);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExportingDialog::reject);
    connect(m_path, &QLineEdit::textChanged, this, &ExportingDialog::pathChanged);
}

void ExportingDialog::begin()
{
    giveMnemonics(*this);
    setBusy(false);
    beginWithName(*m_path);
}

bool ExportingDialog::mayReplace(const QFileInfo &file)
{
    return !file.exists() || confirm(this, tr("%1 exists. Replace it?").arg(file.fileName()),
                                     tr("What it holds now is lost."), tr("&Replace"));
}

void ExportingDialog::setBusy(bool busy)
{
    m_form->setEnabled(!busy);
    m_export->setEnabled(!busy);
    m_cancel->setEnabled(true);
    m_progress->setValue(0);
    m_progress->setVisible(busy);
    if (busy)
        m_hint->showHint({});
}

void ExportingDialog::finish(bool written, const QString &error)
{
    setBusy(false);
    if (written) {
        settings::store().setValue(exportFolderKey(m_place), QFileInfo(m_path->text()).absolutePath());
        remember();
        accept();
    } else if (!error.isEmpty()) {
        m_hint->showHint(error);
    }
}

void ExportingDialog::reject()
{
    if (!isExporting())
        return QDialog::reject();
    stop();
    m_cancel->setEnabled(false);
}

} // namespace suffuse

#include "app/dialogs/extensions/extension_dialog.h"

#include "app/dialogs/extensions/extension_fields.h"
#include "app/extensions/field_values.h"
#include "app/session/editor.h"
#include "app/session/extensions/extension_library.h"
#include "app/session/translation.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/entry_field.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace suffuse {

ExtensionDialog::ExtensionDialog(Editor &editor, const Extension &extension, QWidget *parent)
    : QDialog(parent), m_editor(editor), m_extension(extension)
{
    const QString language = languageInUse();
    setWindowTitle(extension.name.in(language));
    setHelpPage(*this, "extensions");
    setMinimumWidth(420);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    if (!extension.description.isEmpty())
        column->addWidget(quietLabel(extension.description.in(language), this));
    m_fields = new ExtensionFields(extension, ExtensionLibrary::instance().valuesOf(extension), language, this);
    m_fields->setVisible(!extension.fields.empty());
    column->addWidget(m_fields);
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    column->addWidget(m_progress);
    m_doing = quietLabel({}, this);
    column->addWidget(m_doing);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    column->addStretch(1);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_run = buttons->addButton(tr("&Run"), QDialogButtonBox::AcceptRole);
    m_run->setDefault(true);
    m_cancel = buttons->button(QDialogButtonBox::Cancel);
    column->addWidget(buttons);
    connect(m_run, &QPushButton::clicked, this, &ExtensionDialog::run);
    connect(buttons, &QDialogButtonBox::rejected, this, &ExtensionDialog::reject);
    connect(m_fields, &ExtensionFields::edited, m_hint, [this] { m_hint->showHint({}); });
    connect(&m_job, &ExtensionJob::progressed, this, &ExtensionDialog::showProgress);
    connect(&m_job, &ExtensionJob::finished, this, &ExtensionDialog::take);
    giveMnemonics(*this);
    setBusy(false);
    // Qt gives it too little height where the description wraps, and would squeeze the fields.
    const int width = std::max(sizeHint().width(), minimumWidth());
    resize(width, layout()->totalHeightForWidth(width));
}

ExtensionDialog::~ExtensionDialog() = default;

void ExtensionDialog::run()
{
    if (isRunning())
        return;
    EntryField::takeTypedIn(*this);
    const QJsonObject values = m_fields->values();
    if (const QString problem = problemOfValues(m_extension, values, languageInUse()); !problem.isEmpty()) {
        m_hint->showHint(problem);
        return;
    }
    if (!mayReplaceFiles(values))
        return;
    ExtensionLibrary::instance().keepValues(m_extension, values);
    setBusy(true);
    m_job.start(extensionOrder(m_editor, m_extension, values));
}

bool ExtensionDialog::mayReplaceFiles(const QJsonObject &values)
{
    for (const ExtensionField &field : m_extension.fields) {
        const QFileInfo file(values[field.id].toString());
        if (field.type == ExtensionField::Type::File && field.saves && file.exists() &&
            !confirm(this, tr("%1 exists. Replace it?").arg(file.fileName()), tr("What it holds now is lost."),
                     tr("&Replace")))
            return false;
    }
    return true;
}

void ExtensionDialog::setBusy(bool busy)
{
    m_fields->setEnabled(!busy);
    m_run->setEnabled(!busy);
    m_cancel->setEnabled(true);
    m_progress->setRange(0, 0); // until the program says how far it is
    m_progress->setVisible(busy);
    m_doing->setText({});
    m_doing->setVisible(false);
    if (busy)
        m_hint->showHint({});
}

void ExtensionDialog::showProgress(double share, const QString &what)
{
    if (!isRunning())
        return;
    m_progress->setRange(0, 1000);
    m_progress->setValue(int(1000 * share));
    m_doing->setText(what);
    m_doing->setVisible(!what.isEmpty());
}

void ExtensionDialog::take(const ExtensionOutcome &outcome)
{
    setBusy(false);
    ExtensionLibrary::instance().noteRun(m_extension, outcome);
    if (outcome.cancelled) {
        m_hint->showHint(tr("It was stopped. The painting is as it was."));
    } else if (!outcome.error.isEmpty()) {
        m_hint->showHint(outcome.error);
    } else if (!applyExtension(m_editor, m_job.order(), outcome)) {
        m_hint->showHint(tr("The painting has changed meanwhile, so the result is not used. Run it again."));
    } else {
        m_said = outcome.said;
        accept();
    }
}

void ExtensionDialog::reject()
{
    if (!isRunning())
        return QDialog::reject();
    m_job.cancel();
    m_cancel->setEnabled(false);
}

} // namespace suffuse

#include "app/dialogs/extensions/manage_extensions_dialog.h"

#include "app/extensions/confinement.h"
#include "app/session/extensions/extension_library.h"
#include "app/session/translation.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/section.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

namespace suffuse {

namespace {

enum ExtensionColumn { NameColumn, FromColumn, StateColumn };

const FoundExtension *extensionOf(const QTreeWidgetItem *item)
{
    const std::vector<FoundExtension> &found = ExtensionLibrary::instance().found();
    const auto at = item ? std::size_t(item->data(NameColumn, Qt::UserRole).toInt()) : found.size();
    return at < found.size() ? &found[at] : nullptr;
}

} // namespace

ManageExtensionsDialog::ManageExtensionsDialog(QWidget *parent)
    : QDialog(parent), m_list(new QTreeWidget(this)), m_details(new QPlainTextEdit(this))
{
    setWindowTitle(tr("Manage Extensions"));
    setHelpPage(*this, "extensions");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    m_list->setAccessibleName(tr("Extensions"));
    m_list->setHeaderLabels({tr("Extension"), tr("From"), tr("State")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAllColumnsShowFocus(true);
    m_list->setToolTip(tr("Those that are checked stand in the menu"));
    m_list->setMinimumSize(420, 80);
    column->addWidget(m_list, 3);
    m_details->setReadOnly(true);
    m_details->setAccessibleName(tr("About the extension"));
    m_details->setToolTip(tr("What the chosen extension does, what is wrong with it, and what it wrote when it last ran"));
    m_details->setTabChangesFocus(true);
    m_details->setMinimumHeight(48);
    column->addWidget(m_details, 2);
    column->addWidget(quietLabel(confinement().why, this));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_folder = buttons->addButton(tr("&Open Folder"), QDialogButtonBox::ActionRole);
    m_folder->setToolTip(tr("Your own extensions lie there, each in a folder with a manifest"));
    auto *again = buttons->addButton(tr("Read &Again"), QDialogButtonBox::ActionRole);
    again->setToolTip(tr("Looks for extensions anew, after files were changed"));
    for (QPushButton *button : {m_folder, again})
        button->setAutoDefault(false);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_folder, &QPushButton::clicked, this, &ManageExtensionsDialog::openFolder);
    connect(again, &QPushButton::clicked, this, &ManageExtensionsDialog::readAgain);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &ManageExtensionsDialog::showDetails);
    connect(m_list, &QTreeWidget::itemChanged, this, &ManageExtensionsDialog::takeCheck);
    giveMnemonics(*this);
    fill();
    resize(560, 480);
    m_list->setFocus();
}

void ManageExtensionsDialog::readAgain()
{
    ExtensionLibrary::instance().reload();
    fill();
}

void ManageExtensionsDialog::fill()
{
    const QScopedValueRollback filling(m_isFilling, true);
    ExtensionLibrary &library = ExtensionLibrary::instance();
    m_list->clear();
    const std::vector<FoundExtension> &found = library.found();
    for (std::size_t i = 0; i < found.size(); ++i) {
        const FoundExtension &each = found[i];
        auto *item = new QTreeWidgetItem(m_list);
        item->setData(NameColumn, Qt::UserRole, int(i));
        item->setText(NameColumn,
                      each.extension ? each.extension->name.in(languageInUse()) : QFileInfo(each.folder).fileName());
        item->setText(FromColumn, each.isOwn ? tr("You") : tr("Suffuse"));
        item->setText(StateColumn, each.extension ? QString() : tr("Cannot be used"));
        if (each.extension)
            item->setCheckState(NameColumn, library.isEnabled(each.extension->id) ? Qt::Checked : Qt::Unchecked);
    }
    for (const int i : {NameColumn, FromColumn})
        m_list->resizeColumnToContents(i);
    m_list->setCurrentItem(m_list->topLevelItem(0));
    showDetails();
}

void ManageExtensionsDialog::showDetails()
{
    const FoundExtension *found = extensionOf(m_list->currentItem());
    QStringList parts;
    if (!found) {
        parts << tr("There are no extensions yet. Put a folder with a manifest into yours.");
    } else if (!found->extension) {
        parts << found->problem << QDir::toNativeSeparators(found->folder);
    } else {
        const Extension &extension = *found->extension;
        if (!extension.description.isEmpty())
            parts << extension.description.in(languageInUse());
        if (const QString needs = problemOfNeeds(extension); !needs.isEmpty())
            parts << needs;
        if (extension.network)
            parts << tr("It uses the network.");
        parts << QDir::toNativeSeparators(found->folder);
        if (const QString run = ExtensionLibrary::instance().lastRun(extension.id); !run.isEmpty())
            parts << tr("The last run: %1").arg(run);
    }
    m_details->setPlainText(parts.join(QStringLiteral("\n\n")));
}

void ManageExtensionsDialog::takeCheck(QTreeWidgetItem *item)
{
    const FoundExtension *found = extensionOf(item);
    if (!m_isFilling && found && found->extension)
        ExtensionLibrary::instance().setEnabled(found->extension->id, item->checkState(NameColumn) == Qt::Checked);
}

void ManageExtensionsDialog::openFolder()
{
    const QString folder = ownExtensionsFolder();
    if (!QDir().mkpath(folder) || !QDesktopServices::openUrl(QUrl::fromLocalFile(folder)))
        showNotice(this, tr("Your extensions lie in %1.").arg(QDir::toNativeSeparators(folder)));
}

} // namespace suffuse

#include "app/window/files/recovery.h"

#include "app/session/files/saving_preview.h"
#include "app/widgets/asking/messages.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/look/picture_icon.h"
#include "app/window/main_window.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int recoveredColumnGap = 20;
/// Larger ones are listed without a picture: it would take too long.
constexpr std::size_t mostPictured = 200'000;

} // namespace

RecoveryDialog::RecoveryDialog(std::vector<LostDocument> documents, QWidget *parent)
    : QDialog(parent), m_documents(std::move(documents))
{
    setWindowTitle(tr("Recover Paintings"));
    setHelpPage(*this, "saving");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    auto *text = new QLabel(tr("Suffuse ended before these paintings were saved. They open as they were at the last "
                               "stroke; files on the disk are left as they are."),
                            this);
    text->setWordWrap(true);
    column->addWidget(text);

    m_list = new QTreeWidget(this);
    m_list->setAccessibleName(tr("Paintings that can be recovered"));
    m_list->setAccessibleDescription(text->text());
    m_list->setHeaderLabels({tr("Painting"), tr("Last Change"), tr("Strokes"), tr("Folder")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setIconSize(pictureSize);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setAllColumnsShowFocus(true);
    m_list->setMinimumSize(640, 260);
    column->addWidget(m_list, 1);
    fillList();

    auto *buttons = new QDialogButtonBox(this);
    m_recover = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    m_later = buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    m_discard = buttons->addButton(tr("&Discard…"), QDialogButtonBox::ResetRole);
    m_recover->setDefault(true);
    m_recover->setToolTip(tr("Opens the selected paintings, without a file of their own"));
    m_later->setToolTip(tr("Asks again when Suffuse starts the next time"));
    m_discard->setToolTip(tr("Removes the selected paintings for good"));
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_discard, &QPushButton::clicked, this, &RecoveryDialog::discardSelected);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, [this] {
        const bool any = !m_list->selectedItems().isEmpty();
        m_recover->setEnabled(any);
        m_discard->setEnabled(any);
    });
    column->addWidget(buttons);
    m_list->selectAll();
    m_list->setFocus();
    startPreviews();
}

RecoveryDialog::~RecoveryDialog() = default;

void RecoveryDialog::fillList()
{
    const QLocale locale;
    for (const LostDocument &document : m_documents) {
        const QString &path = document.content.head.path;
        const QString folder = path.isEmpty() ? tr("not saved yet") : QFileInfo(path).absolutePath();
        const QString name = document.name().isEmpty() ? Editor::tr("Untitled") : document.name();
        auto *item = new QTreeWidgetItem(m_list, {name, locale.toString(document.lastChange(), QLocale::ShortFormat),
                                                  locale.toString(qulonglong(document.content.painting.strokes.size())),
                                                  folder});
        item->setIcon(0, pictureIcon({}, palette(), devicePixelRatioF()));
        item->setToolTip(3, path);
        item->setData(0, Qt::UserRole, document.id());
    }
    for (int i = 0; i < 3; ++i) {
        m_list->resizeColumnToContents(i);
        m_list->setColumnWidth(i, m_list->columnWidth(i) + recoveredColumnGap);
    }
}

void RecoveryDialog::startPreviews()
{
    std::vector<std::pair<QString, PaintingPtr>> paintings;
    for (const LostDocument &document : m_documents)
        if (document.content.painting.segmentCount() <= mostPictured)
            paintings.emplace_back(document.id(), std::make_shared<const Painting>(document.content.painting));
    const int side = int(pictureSize.width() * devicePixelRatioF());
    m_previews = std::jthread([this, paintings = std::move(paintings), side](const std::stop_token &stop) {
        for (const auto &[id, painting] : paintings) {
            if (stop.stop_requested())
                return;
            const QImage image = previewImage(painting, side);
            QMetaObject::invokeMethod(
                this, [this, image, id = id] { showPreview(id, image); }, Qt::QueuedConnection);
        }
    });
}

void RecoveryDialog::showPreview(const QString &id, const QImage &image)
{
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) // some may have been discarded
        if (QTreeWidgetItem *item = m_list->topLevelItem(i); item->data(0, Qt::UserRole) == id)
            item->setIcon(0, pictureIcon(image, palette(), devicePixelRatioF()));
}

std::vector<LostDocument> RecoveryDialog::takeSelected()
{
    std::vector<LostDocument> taken, left;
    for (std::size_t i = 0; i < m_documents.size(); ++i)
        (m_list->topLevelItem(int(i))->isSelected() ? taken : left).push_back(std::move(m_documents[i]));
    m_documents = std::move(left);
    qDeleteAll(m_list->selectedItems());
    return taken;
}

void RecoveryDialog::discardSelected()
{
    const qsizetype count = m_list->selectedItems().size();
    const QString question = count == 1 ? tr("Discard “%1”?").arg(m_list->selectedItems().front()->text(0))
                                        : tr("Discard %n paintings?", nullptr, int(count));
    if (!confirm(this, question, tr("What was painted since the last save is then lost for good."), tr("&Discard")))
        return;
    for (const LostDocument &document : takeSelected())
        document.file->remove();
    if (m_documents.empty())
        reject();
}

void offerRecovery(MainWindow &window, const QString &folder)
{
    Journals journals = findJournals(folder);
    tidyJournals(journals, folder, QDateTime::currentDateTime());
    if (journals.lost.empty())
        return;
    RecoveryDialog dialog(std::move(journals.lost), &window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    MainWindow *last = &window;
    for (LostDocument &document : dialog.takeSelected())
        last = last->openRecovered(std::move(document));
}

} // namespace suffuse

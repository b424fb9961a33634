#include "app/dialogs/backups_dialog.h"

#include "app/session/files/saving_preview.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/look/picture_icon.h"
#include "model/formats/atomic_save.h"
#include "model/formats/files.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int backupColumnGap = 20;
constexpr QSize usualSize(560, 400); ///< room for three pictures and a little more; low screens have that, too
/// Larger paintings show the picture in their file or none, since drawing one would take too long.
constexpr std::size_t mostDrawn = 200'000;
enum BackupColumn { Saved, Strokes, Size };

/// The short format of date and time. Versions of one minute must be told apart, so it has seconds, too.
QString formatWithSeconds(const QLocale &locale)
{
    QString format = locale.dateTimeFormat(QLocale::ShortFormat);
    if (const qsizetype minutes = format.indexOf(QStringLiteral("mm")); minutes > 0 && !format.contains('s'))
        format.insert(minutes + 2, format[minutes - 1] + QStringLiteral("ss"));
    return format;
}

QImage pictureOf(LoadedDocument &document, int side)
{
    if (const QImage kept = QImage::fromData(document.extras.preview, "PNG"); !kept.isNull())
        return kept;
    if (document.painting.segmentCount() > mostDrawn)
        return {};
    return previewImage(std::make_shared<const Painting>(std::move(document.painting)), side);
}

} // namespace

BackupsDialog::BackupsDialog(const QString &painting, QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Restore Backup"));
    setHelpPage(*this, "saving");
    const QStringList files = backupsOf(painting);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    const QString name = QFileInfo(painting).fileName();
    auto *text = new QLabel(this);
    text->setTextFormat(Qt::PlainText);
    text->setText(
        files.isEmpty()
            ? tr("There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings "
                 "says how many are.")
                  .arg(name)
            : tr("An earlier version of “%1” takes the place of the painting as it is now. Undo brings that "
                 "back, and no file changes until you save.")
                  .arg(name));
    text->setWordWrap(true);
    column->addWidget(text);

    m_list = new QTreeWidget(this);
    m_list->setAccessibleName(tr("Backups, the newest first"));
    m_list->setHeaderLabels({tr("Saved"), tr("Strokes"), tr("Size")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setIconSize(pictureSize);
    m_list->setAllColumnsShowFocus(true);
    m_list->setMinimumSize(420, 120);
    column->addWidget(m_list, 1);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_restore = buttons->addButton(tr("&Restore"), QDialogButtonBox::AcceptRole);
    m_restore->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, [this] {
        if (m_restore->isEnabled())
            accept();
    });
    connect(m_list, &QTreeWidget::itemSelectionChanged, this, &BackupsDialog::updateButton);
    column->addWidget(buttons);
    fillList(files);
    updateButton();
    resize(usualSize);
    m_list->setFocus();
    startReading(files);
}

BackupsDialog::~BackupsDialog() = default;

QString BackupsDialog::chosen() const
{
    const QList<QTreeWidgetItem *> selected = m_list->selectedItems();
    return selected.isEmpty() ? QString() : selected.front()->data(Saved, Qt::UserRole).toString();
}

void BackupsDialog::fillList(const QStringList &files)
{
    const QLocale locale;
    const QString format = formatWithSeconds(locale);
    for (const QString &path : files) {
        const QFileInfo file(path);
        auto *item = new QTreeWidgetItem(
            m_list, {locale.toString(file.lastModified(), format), QString(), locale.formattedDataSize(file.size())});
        item->setIcon(Saved, pictureIcon({}, palette(), devicePixelRatioF()));
        item->setToolTip(Saved, file.fileName());
        item->setData(Saved, Qt::UserRole, path);
    }
    if (m_list->topLevelItemCount() > 0)
        m_list->setCurrentItem(m_list->topLevelItem(0));
    for (const int i : {Saved, Strokes}) {
        m_list->resizeColumnToContents(i);
        m_list->setColumnWidth(i, m_list->columnWidth(i) + backupColumnGap);
    }
}

/// Reads the backups on a thread, since they may be large, and there may be twenty.
void BackupsDialog::startReading(const QStringList &files)
{
    const int side = int(pictureSize.width() * devicePixelRatioF());
    m_reading = std::jthread([this, files, side](const std::stop_token &stop) {
        for (int row = 0; row < files.size() && !stop.stop_requested(); ++row) {
            Result<LoadedDocument> document = loadDocument(files[row]);
            QString strokes;
            QImage picture;
            if (document) {
                strokes = QLocale().toString(qulonglong(document->painting.strokes.size()));
                picture = pictureOf(*document, side);
            }
            QMetaObject::invokeMethod(
                this, [=, this, isReadable = bool(document)] { showContent(row, picture, strokes, isReadable); },
                Qt::QueuedConnection);
        }
    });
}

void BackupsDialog::showContent(int row, const QImage &picture, const QString &strokes, bool isReadable)
{
    QTreeWidgetItem *item = m_list->topLevelItem(row);
    item->setIcon(Saved, pictureIcon(picture, palette(), devicePixelRatioF()));
    item->setText(Strokes, isReadable ? strokes : tr("cannot be read"));
    if (!isReadable)
        item->setFlags(Qt::NoItemFlags);
    m_list->resizeColumnToContents(Strokes);
    m_list->setColumnWidth(Strokes, m_list->columnWidth(Strokes) + backupColumnGap);
    updateButton();
}

void BackupsDialog::updateButton()
{
    const QList<QTreeWidgetItem *> selected = m_list->selectedItems();
    m_restore->setEnabled(!selected.isEmpty() && selected.front()->flags().testFlag(Qt::ItemIsEnabled));
}

} // namespace suffuse

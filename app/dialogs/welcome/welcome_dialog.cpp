#include "app/dialogs/welcome/welcome_dialog.h"

#include "app/session/colour_convert.h"
#include "app/session/files/samples.h"
#include "app/session/settings/greeting.h"
#include "app/session/settings/settings.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr int dataRole = Qt::UserRole;
constexpr QSize sheetSize(44, 36), keptSize(84, 60); ///< logical pixels

/// A sheet in its proportions and its ground.
QIcon sheetIcon(const Canvas &canvas, double scale)
{
    QPixmap picture(sheetSize * scale);
    picture.setDevicePixelRatio(scale);
    picture.fill(Qt::transparent);
    QSizeF size(canvas.width, canvas.height);
    size.scale(QSizeF(sheetSize) - QSizeF(4, 4), Qt::KeepAspectRatio);
    QRectF sheet({}, size);
    sheet.moveCenter(QRectF({}, QSizeF(sheetSize)).center());
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(edgeOfColours());
    painter.setBrush(toScreen(canvas.background));
    painter.drawRect(sheet);
    return picture;
}

void addHeading(QListWidget &list, const QString &text)
{
    auto *row = new QListWidgetItem(text, &list);
    row->setFlags(Qt::NoItemFlags);
    QFont font = list.font();
    font.setBold(true);
    row->setFont(font);
}

QListWidget *makeList(const QSize &icons, const QString &name, QWidget *parent)
{
    auto *list = new QListWidget(parent);
    list->setIconSize(icons);
    list->setSpacing(1);
    list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list->setTextElideMode(Qt::ElideMiddle);
    list->setAccessibleName(name);
    list->setMinimumWidth(20 * list->fontMetrics().height());
    list->setMinimumHeight(22 * list->fontMetrics().height());
    return list;
}

} // namespace

WelcomeDialog::WelcomeDialog(QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("Welcome to Suffuse"));
    setHelpPage(*this, "first-painting");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    auto *row = new QHBoxLayout;
    row->setSpacing(16);
    addSheets(*row);
    addPaintings(*row);
    column->addLayout(row, 1);
    addLessons(*column);
    addFoot(*column);
    giveMnemonics(*this);
    m_sheets->setFocus();
}

void WelcomeDialog::addSheets(QHBoxLayout &row)
{
    auto *column = new QVBoxLayout;
    column->addWidget(sectionTitle(tr("New painting"), this));
    m_sheets = makeList(sheetSize, tr("New painting"), this);
    m_sheets->setAccessibleDescription(tr("Sheets by their size. Return begins a painting on one."));
    QString section;
    for (std::size_t i = 0; i < m_presets.size(); ++i) {
        const SheetPreset &preset = m_presets[i];
        if (preset.section != section)
            addHeading(*m_sheets, section = preset.section);
        auto *sheet = new QListWidgetItem(sheetIcon(preset.canvas, devicePixelRatioF()),
                                          preset.name + '\n' + preset.size, m_sheets);
        sheet->setData(dataRole, int(i));
    }
    column->addWidget(m_sheets, 1);
    auto *other = new QPushButton(tr("Other Size…"), this);
    other->setAutoDefault(false);
    column->addWidget(other);
    row.addLayout(column, 1);
    whenChosen(*m_sheets,
               [this](const QVariant &preset) { emit sheetChosen(m_presets[std::size_t(preset.toInt())].sheet()); });
    connect(other, &QPushButton::clicked, this, [this] {
        accept();
        emit otherSheetWanted();
    });
}

void WelcomeDialog::addPaintings(QHBoxLayout &row)
{
    auto *column = new QVBoxLayout;
    column->addWidget(sectionTitle(tr("Open a painting"), this));
    m_paintings = makeList(keptSize, tr("Open a painting"), this);
    m_paintings->setAccessibleDescription(tr("Recent paintings and samples. Return opens one."));
    QStringList recent = settings::recentFiles();
    for (const QString &path : std::as_const(recent))
        addPainting(path, QFileInfo(path).completeBaseName(), tr("Recent"));
    for (const QString &path : sampleFiles())
        if (!recent.contains(path))
            addPainting(path, sampleTitle(path), tr("Samples"));
    column->addWidget(m_paintings, 1);
    auto *open = new QPushButton(tr("Open File…"), this);
    open->setAutoDefault(false);
    column->addWidget(open);
    row.addLayout(column, 1);
    whenChosen(*m_paintings, [this](const QVariant &path) { emit fileChosen(path.toString()); });
    connect(open, &QPushButton::clicked, this, [this] {
        accept();
        emit openWanted();
    });
    QTimer::singleShot(0, this, &WelcomeDialog::loadPreviews); // once all of this is seen
}

/// A click chooses, and so does Return. Of a double click, which is both, the first counts.
void WelcomeDialog::whenChosen(QListWidget &list, const std::function<void(const QVariant &data)> &does)
{
    const auto choose = [this, does](const QListWidgetItem *row) {
        if (!row->data(dataRole).isValid() || !isVisible())
            return;
        const QVariant data = row->data(dataRole);
        accept();
        does(data);
    };
    connect(&list, &QListWidget::itemClicked, this, choose);
    connect(&list, &QListWidget::itemActivated, this, choose);
}

/// Below its heading, which comes with the first of them.
void WelcomeDialog::addPainting(const QString &path, const QString &title, const QString &heading)
{
    if (m_paintings->property("heading").toString() != heading) {
        addHeading(*m_paintings, heading);
        m_paintings->setProperty("heading", heading);
    }
    QPixmap none(keptSize * devicePixelRatioF());
    none.setDevicePixelRatio(devicePixelRatioF());
    none.fill(Qt::transparent);
    auto *row = new QListWidgetItem(none, title, m_paintings);
    row->setData(dataRole, path);
    row->setToolTip(path);
}

/// Beside the window, so that nobody waits for a slow disk or for what must be drawn.
void WelcomeDialog::loadPreviews()
{
    std::vector<std::pair<int, QString>> wanted;
    for (int row = 0; row < m_paintings->count(); ++row)
        if (const QString path = m_paintings->item(row)->data(dataRole).toString(); !path.isEmpty())
            wanted.emplace_back(row, path);
    const auto side = int(keptSize.width() * devicePixelRatioF());
    m_loader = std::jthread([this, wanted, side](const std::stop_token &stop) {
        for (const auto &[row, path] : wanted) {
            if (stop.stop_requested())
                return;
            if (const QImage preview = previewOf(path, side); !preview.isNull())
                QMetaObject::invokeMethod(
                    this, [this, row = row, preview] { showPreview(row, preview); }, Qt::QueuedConnection);
        }
    });
}

/// In the middle of where pictures stand.
void WelcomeDialog::showPreview(int row, const QImage &preview)
{
    const double scale = devicePixelRatioF();
    QPixmap picture(keptSize * scale);
    picture.fill(Qt::transparent);
    const QImage fit = preview.scaled(picture.size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter painter(&picture);
    painter.drawImage((picture.width() - fit.width()) / 2, (picture.height() - fit.height()) / 2, fit);
    painter.end();
    picture.setDevicePixelRatio(scale);
    m_paintings->item(row)->setIcon(picture);
}

void WelcomeDialog::addLessons(QVBoxLayout &column)
{
    column.addWidget(sectionTitle(tr("Three short lessons"), this));
    auto *row = new QHBoxLayout;
    for (const LessonKind kind : lessonKinds) {
        auto *lesson = new QPushButton(titleOf(kind), this);
        lesson->setAutoDefault(false);
        row->addWidget(lesson, 1);
        connect(lesson, &QPushButton::clicked, this, [this, kind] {
            accept();
            emit lessonChosen(kind);
        });
    }
    column.addLayout(row);
}

void WelcomeDialog::addFoot(QVBoxLayout &column)
{
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_atStart = new QCheckBox(tr("Show this at the start"), this);
    m_atStart->setChecked(settings::welcomes());
    connect(m_atStart, &QCheckBox::toggled, this, [](bool on) { settings::setWelcomes(on); });
    auto *row = new QHBoxLayout;
    row->addWidget(m_atStart);
    row->addWidget(buttons, 1);
    column.addLayout(row);
}

} // namespace suffuse

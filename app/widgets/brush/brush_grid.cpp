#include "app/widgets/brush/brush_grid.h"

#include "app/session/settings/brush_library.h"
#include "app/widgets/brush/brush_pictures.h"
#include "app/widgets/numbers/display.h"
#include "model/brush/brush_width.h"

#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QScrollBar>
#include <QTimer>

#include <algorithm>
#include <map>
#include <tuple>

namespace suffuse {

namespace {

constexpr int headingRole = Qt::UserRole + 1, changedRole = Qt::UserRole + 2;

} // namespace

BrushGrid::BrushGrid(QWidget *parent) : QListWidget(parent)
{
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setIconSize(BrushPictures::size);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setAccessibleName(tr("Brushes"));
    setAccessibleDescription(tr("Choose a brush to paint with it."));
    viewport()->setAutoFillBackground(false);
    const auto showAnew = [this](const QString &name) {
        if (QListWidgetItem *item = itemOf(name))
            setPicture(item);
    };
    connect(&BrushPictures::instance(), &BrushPictures::drawn, this, showAnew);
    connect(&BrushLibrary::instance(), &BrushLibrary::changesKept, this, showAnew);
}

QString BrushGrid::brushOf(const QListWidgetItem *item)
{
    return item && !item->data(headingRole).toBool() ? item->data(Qt::UserRole).toString() : QString();
}

QListWidgetItem *BrushGrid::itemOf(const QString &name) const
{
    for (int row = 0; row < count(); ++row)
        if (!item(row)->data(headingRole).toBool() && brushOf(item(row)) == name)
            return item(row);
    return nullptr;
}

QString BrushGrid::first() const
{
    for (int row = 0; row < count(); ++row)
        if (const QString name = brushOf(item(row)); !name.isEmpty())
            return name;
    return {};
}

void BrushGrid::showFirst()
{
    mark(first());
    scrollToTop(); // not to where the marked one stood before, or below its heading
}

void BrushGrid::mark(const QString &name)
{
    const QSignalBlocker blocker(this);
    setCurrentItem(itemOf(name));
}

void BrushGrid::showInHand(const Brush &brush)
{
    m_inHand = brush.name;
    m_isChanged = BrushLibrary::instance().isChanged(brush);
    mark(brush.name);
    if (QListWidgetItem *item = currentItem(); item && item->data(changedRole).toBool() != m_isChanged)
        setPicture(item);
}

QSize BrushGrid::cell() const
{
    return {BrushPictures::size.width() + 6, BrushPictures::size.height() + fontMetrics().height() + 10};
}

QSize BrushGrid::sizeFor(int columns, int rows) const
{
    constexpr int slack = 4; // that a view keeps for itself
    return {columns * cell().width() + verticalScrollBar()->sizeHint().width() + slack, rows * cell().height() + slack};
}

void BrushGrid::addHeading(const QString &group)
{
    auto *heading = new QListWidgetItem(brushGroupTitle(group), this);
    heading->setFlags(Qt::NoItemFlags);
    heading->setData(headingRole, true);
    heading->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
    heading->setForeground(QApplication::palette().color(QPalette::PlaceholderText));
}

void BrushGrid::addBrush(const Brush &brush)
{
    auto *item = new QListWidgetItem(brushTitle(brush.name), this);
    item->setData(Qt::UserRole, brush.name);
    item->setSizeHint(cell());
    setPicture(item);
}

void BrushGrid::fillGroups(const std::function<bool(const Brush &brush)> &isShown, const QString &typed)
{
    struct Shown {
        const Brush *brush;
        int rank;
    };
    const QSignalBlocker blocker(this);
    clear();
    std::vector<Shown> shown;
    std::map<QString, std::pair<int, int>> groups; // what suits best in each, and its place in the library
    for (const Brush &brush : BrushLibrary::instance().brushes()) {
        if (!isShown(brush))
            continue;
        const int rank = typed.trimmed().isEmpty() ? 0 : searchRank(brush, typed);
        shown.push_back({&brush, rank});
        const auto group = groups.try_emplace(brush.group, rank, int(groups.size())).first;
        group->second.first = std::min(group->second.first, rank);
    }
    std::ranges::stable_sort(shown, {},
                             [&groups](const Shown &s) { return std::tuple(groups.at(s.brush->group), s.rank); });
    for (std::size_t k = 0; k < shown.size(); ++k) {
        if (k == 0 || shown[k].brush->group != shown[k - 1].brush->group)
            addHeading(shown[k].brush->group);
        addBrush(*shown[k].brush);
    }
    fitHeadings();
    if (m_started)
        BrushPictures::instance().want(devicePixelRatioF());
}

void BrushGrid::fill(const QStringList &names)
{
    const QSignalBlocker blocker(this);
    clear();
    for (const QString &name : names)
        if (const Brush *brush = BrushLibrary::instance().find(name))
            addBrush(*brush);
    if (m_started)
        BrushPictures::instance().want(devicePixelRatioF());
}

void BrushGrid::setPicture(QListWidgetItem *item)
{
    const QString name = brushOf(item);
    const bool changed = name == m_inHand ? m_isChanged : BrushLibrary::instance().hasChanges(name);
    item->setIcon(BrushPictures::instance().icon(name, devicePixelRatioF(), changed));
    item->setData(changedRole, changed);
    const Brush *brush = BrushLibrary::instance().find(name);
    if (!brush)
        return;
    const QString about = tr("%1: size %2, dry after %3")
                              .arg(brushTitle(name), lengthDisplay().text(visibleWidth(*brush)),
                                   timeDisplay().text(double(brush->maxAge)));
    item->setToolTip(
        changed ? about + '\n' + tr("Changed since the program was started; Reload in its menu undoes that") : about);
}

void BrushGrid::fitHeadings()
{
    const int width = viewport()->width() - 2 * spacing() - 2;
    for (int row = 0; row < count(); ++row)
        if (item(row)->data(headingRole).toBool())
            item(row)->setSizeHint({width, fontMetrics().height() + (row > 0 ? 10 : 2)});
}

/// After the view has been laid out for the size that it has then.
void BrushGrid::scrollToMarkedSoon()
{
    QTimer::singleShot(0, this, [this] {
        if (QListWidgetItem *item = currentItem())
            scrollToItem(item);
    });
}

void BrushGrid::resizeEvent(QResizeEvent *event)
{
    QListWidget::resizeEvent(event);
    fitHeadings();
    if (m_isMarkedSeen)
        scrollToMarkedSoon();
}

void BrushGrid::paintEvent(QPaintEvent *event)
{
    QListWidget::paintEvent(event);
    if (count() == 0) {
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(8, 8, -8, -8), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                         tr("There is no such brush."));
    }
    m_isMarkedSeen = currentItem() && viewport()->rect().intersects(visualItemRect(currentItem()));
    if (m_started)
        return;
    // Pictures come after the first paint: the window is there at once.
    m_started = true;
    fitHeadings();
    scrollToMarkedSoon();
    BrushPictures::instance().want(devicePixelRatioF());
}

void BrushGrid::changeEvent(QEvent *event)
{
    QListWidget::changeEvent(event);
    if (event->type() != QEvent::ApplicationPaletteChange && event->type() != QEvent::PaletteChange)
        return;
    for (int row = 0; row < count(); ++row)
        if (item(row)->data(headingRole).toBool())
            item(row)->setForeground(QApplication::palette().color(QPalette::PlaceholderText));
        else
            setPicture(item(row));
}

} // namespace suffuse

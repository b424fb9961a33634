#include "app/panels/brushes/brush_panel.h"

#include "app/panels/brushes/brush_menu.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/look/theme.h"
#include "app/widgets/numbers/quantity.h"

#include <QApplication>
#include <QEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

constexpr QSize previewSize{112, 44};
constexpr int headingRole = Qt::UserRole + 1;

/// A brush's picture on paper. `key` is 0 for a brush that is no favourite, else its number among the favourites.
/// Favourites without a key of their own have only a star.
QPixmap onPaper(const QImage &stroke, double ratio, bool chosen, int key)
{
    QPixmap pixmap(previewSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath sheet;
    sheet.addRoundedRect(QRectF(0.5, 0.5, previewSize.width() - 1, previewSize.height() - 1), 4, 4);
    painter.fillPath(sheet, paperFor(stroke));
    if (!stroke.isNull()) {
        painter.setClipPath(sheet);
        painter.drawImage(QRectF(QPointF(), QSizeF(previewSize)), stroke);
        painter.setClipping(false);
    }
    painter.strokePath(sheet,
                       chosen ? QPen(QApplication::palette().color(QPalette::Highlight), 4) : QPen(hairline(), 1));
    if (key > 0) {
        QFont font = QApplication::font();
        font.setPixelSize(10);
        painter.setFont(font);
        painter.setPen(QColor(70, 70, 76));
        const QString number = key <= BrushLibrary::keys ? QString::number(key) : QString();
        painter.drawText(QRectF(0, 3, previewSize.width() - 5, 14), Qt::AlignRight | Qt::AlignTop,
                         QStringLiteral("★") + number);
    }
    return pixmap;
}

/// The icon of a brush. When it is chosen it gets a frame, since a tint would change its colours.
QIcon previewIcon(const QImage &stroke, double ratio, int key)
{
    QIcon result(onPaper(stroke, ratio, false, key));
    result.addPixmap(onPaper(stroke, ratio, true, key), QIcon::Selected);
    return result;
}

QString brushNameOf(const QListWidgetItem *item)
{
    return item->data(Qt::UserRole).toString();
}

} // namespace

BrushPanel::BrushPanel(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    addHead(*column);
    addList(*column);
    fillList();
    addFields(*column);
    m_hint = new HintLabel(this);
    column->addWidget(m_hint);
    for (SliderField *field : {m_size, m_flow, m_opacity})
        connect(field, &SliderField::refused, m_hint, &HintLabel::showRefusal);
    connect(&editor, &Editor::brushChanged, this, &BrushPanel::refresh);
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, [this] {
        fillList();
        refresh();
    });
    refresh();
}

QMenu *BrushPanel::menu() const
{
    return m_menu;
}

QSize BrushPanel::sizeHint() const
{
    return {280, 320};
}

void BrushPanel::addHead(QVBoxLayout &column)
{
    auto *row = new QHBoxLayout;
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->setAccessibleName(tr("Search brushes"));
    m_search->setToolTip(tr("Shows brushes and groups with this in their name"));
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_favourites = new QToolButton(this);
    m_favourites->setText(QStringLiteral("★"));
    m_favourites->setCheckable(true);
    m_favourites->setAutoRaise(true);
    m_favourites->setAccessibleName(tr("Favourites only"));
    m_favourites->setToolTip(tr("Show favourites only; the first nine have the keys 1 to 9"));
    auto *more = new QToolButton(this);
    more->setIcon(icon("settings"));
    more->setAutoRaise(true);
    more->setPopupMode(QToolButton::InstantPopup);
    more->setAccessibleName(tr("Brush menu"));
    more->setToolTip(tr("Edit, save, import and export brushes"));
    more->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    m_menu = new BrushMenu(m_editor, this);
    more->setMenu(m_menu);
    connect(m_menu, &BrushMenu::noted, this, [this](const QString &text) { m_hint->showHint(text); });
    row->addWidget(m_search, 1);
    row->addWidget(m_favourites);
    row->addWidget(more);
    column.addLayout(row);
    connect(m_search, &QLineEdit::textChanged, this, [this] {
        fillList();
        refresh();
    });
    connect(m_favourites, &QToolButton::toggled, this, [this] {
        fillList();
        refresh();
    });
}

void BrushPanel::addList(QVBoxLayout &column)
{
    m_list = new QListWidget(this);
    m_list->setViewMode(QListView::IconMode);
    m_list->setMovement(QListView::Static);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setIconSize(previewSize);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_list->setAccessibleName(tr("Brushes"));
    m_list->setToolTip(tr("Choose what to paint with. The colour stays."));
    m_list->viewport()->setAutoFillBackground(false);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    column.addWidget(m_list, 1);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) {
        if (!item || item->data(headingRole).toBool())
            return;
        BrushLibrary::instance().use(m_editor, brushNameOf(item));
        if (!(QApplication::mouseButtons() & Qt::RightButton))
            emit chosen();
    });
    connect(m_list, &QListWidget::itemClicked, this, [this](const QListWidgetItem *item) {
        if (!item->data(headingRole).toBool())
            emit chosen(); // A click on the brush in hand counts, too, since another tool may be in use.
    });
    connect(m_list, &QListWidget::itemDoubleClicked, m_menu, &BrushMenu::showDialog);
    connect(m_list, &QListWidget::customContextMenuRequested, this,
            [this](QPoint at) { m_menu->popup(m_list->viewport()->mapToGlobal(at)); });
}

bool BrushPanel::isShown(const Brush &brush) const
{
    if (m_favourites->isChecked() && !BrushLibrary::instance().isFavourite(brush.name))
        return false;
    const QString text = m_search->text().trimmed();
    return text.isEmpty() || brushTitle(brush.name).contains(text, Qt::CaseInsensitive) ||
           brushGroupTitle(brush.group).contains(text, Qt::CaseInsensitive);
}

void BrushPanel::addHeading(const QString &group)
{
    auto *item = new QListWidgetItem(brushGroupTitle(group), m_list);
    item->setFlags(Qt::NoItemFlags);
    item->setData(headingRole, true);
    item->setTextAlignment(Qt::AlignLeft | Qt::AlignBottom);
    item->setForeground(QApplication::palette().color(QPalette::PlaceholderText));
}

void BrushPanel::fillList()
{
    const QSignalBlocker blocker(m_list);
    m_list->clear();
    // The user's brushes stand in groups of their own, behind the built-in ones.
    std::vector<QString> groups;
    const auto &brushes = BrushLibrary::instance().brushes();
    for (const Brush &brush : brushes)
        if (isShown(brush) && std::find(groups.begin(), groups.end(), brush.group) == groups.end())
            groups.push_back(brush.group);
    for (const QString &group : groups) {
        addHeading(group);
        for (const Brush &brush : brushes) {
            if (brush.group != group || !isShown(brush))
                continue;
            auto *item = new QListWidgetItem(brushTitle(brush.name), m_list);
            item->setData(Qt::UserRole, brush.name);
            item->setToolTip(tr("%1: size %2, dry after %3")
                                 .arg(brushTitle(brush.name), lengthDisplay().text(brush.spread()),
                                      timeDisplay().text(double(brush.maxAge))));
            item->setSizeHint({previewSize.width() + 6, previewSize.height() + fontMetrics().height() + 10});
            setPicture(item);
        }
    }
    fitHeadings();
    if (m_started)
        schedulePreviews();
}

void BrushPanel::fitHeadings()
{
    const int width = m_list->viewport()->width() - 2 * m_list->spacing() - 2;
    for (int row = 0; row < m_list->count(); ++row)
        if (m_list->item(row)->data(headingRole).toBool())
            m_list->item(row)->setSizeHint({width, fontMetrics().height() + (row > 0 ? 10 : 2)});
}

void BrushPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitHeadings();
}

QListWidgetItem *BrushPanel::itemOf(const QString &name) const
{
    for (int row = 0; row < m_list->count(); ++row)
        if (!m_list->item(row)->data(headingRole).toBool() && brushNameOf(m_list->item(row)) == name)
            return m_list->item(row);
    return nullptr;
}

void BrushPanel::setPicture(QListWidgetItem *item)
{
    const QString name = brushNameOf(item);
    const int key = int(BrushLibrary::instance().favourites().indexOf(name)) + 1;
    item->setIcon(previewIcon(m_drawn.value(name).image, devicePixelRatioF(), key));
}

void BrushPanel::addFields(QVBoxLayout &column)
{
    auto *head = new QHBoxLayout;
    m_title = sectionTitle(QString(), this);
    m_reset = new QToolButton(this);
    m_reset->setIcon(icon("reset"));
    m_reset->setAutoRaise(true);
    m_reset->setAccessibleName(tr("Reset brush"));
    m_reset->setToolTip(tr("Back to the brush as it came"));
    head->addWidget(m_title, 1);
    head->addWidget(m_reset);
    column.addLayout(head);
    connect(m_reset, &QToolButton::clicked, this, [this] { BrushLibrary::instance().use(m_editor, inHand()); });

    QGridLayout *grid = addFieldGrid(column);
    m_size = new SliderField(specOf(Quantity::Size), *grid, 0, this);
    m_flow = new SliderField(specOf(Quantity::Flow), *grid, 1, this);
    m_opacity = new SliderField(specOf(Quantity::Opacity), *grid, 2, this);
    connect(m_size, &SliderField::edited, this,
            [this](double spread) { edit([=](Brush &b) { b.setSpread(spread); }); });
    connect(m_flow, &SliderField::edited, this, [this](double peak) { edit([=](Brush &b) { b.peak = float(peak); }); });
    connect(m_opacity, &SliderField::edited, this,
            [this](double opacity) { edit([=](Brush &b) { b.colour.opacity = float(opacity); }); });
}

void BrushPanel::edit(const std::function<void(Brush &)> &change)
{
    Brush brush = m_editor.brush();
    change(brush);
    m_hint->showHint({});
    m_editor.setBrush(brush);
}

QString BrushPanel::inHand() const
{
    return m_editor.brush().name;
}

void BrushPanel::refresh()
{
    const Brush &brush = m_editor.brush();
    const QSignalBlocker blocker(m_list);
    QListWidgetItem *item = itemOf(brush.name);
    m_list->setCurrentItem(item);
    const bool modified = BrushLibrary::instance().isChanged(brush);
    m_title->setText(modified ? tr("%1 (changed)").arg(brushTitle(brush.name)) : brushTitle(brush.name));
    m_reset->setEnabled(modified);
    if (const Brush *preset = BrushLibrary::instance().find(brush.name)) {
        m_size->setDefaultValue(preset->spread());
        m_flow->setDefaultValue(double(preset->peak));
        m_opacity->setDefaultValue(double(preset->colour.opacity));
    }
    m_size->setValue(brush.spread());
    m_flow->setValue(double(brush.peak));
    m_opacity->setValue(double(brush.colour.opacity));
}

void BrushPanel::paintEvent(QPaintEvent *event)
{
    QWidget::paintEvent(event);
    if (m_started)
        return;
    // Pictures are made one at a time after the first paint, so that the window appears at once.
    m_started = true;
    fitHeadings();
    schedulePreviews();
}

void BrushPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    const bool otherColours =
        event->type() == QEvent::ApplicationPaletteChange || event->type() == QEvent::PaletteChange;
    if (otherColours && m_hint) { // The list exists only once everything is built.
        fillList();
        refresh();
    }
}

void BrushPanel::schedulePreviews()
{
    const bool idle = m_pending.empty();
    m_pending.clear();
    for (int row = m_list->count() - 1; row >= 0; --row) {
        const Brush *brush = BrushLibrary::instance().find(brushNameOf(m_list->item(row)));
        if (brush && !(m_drawn.contains(brush->name) && m_drawn.value(brush->name).brush == *brush))
            m_pending.push_back(brush->name);
    }
    if (idle && !m_pending.empty())
        QTimer::singleShot(0, this, &BrushPanel::renderNext);
}

void BrushPanel::renderNext()
{
    if (m_pending.empty())
        return;
    const QString name = m_pending.back();
    m_pending.pop_back();
    if (const Brush *brush = BrushLibrary::instance().find(name)) {
        m_drawn.insert(name, {*brush, m_preview.render(*brush, previewSize * devicePixelRatioF())});
        if (QListWidgetItem *item = itemOf(name))
            setPicture(item);
    }
    if (!m_pending.empty())
        QTimer::singleShot(0, this, &BrushPanel::renderNext);
}

} // namespace suffuse

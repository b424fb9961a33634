#include "app/panels/brushes/brush_panel.h"

#include "app/panels/brushes/brush_menu.h"
#include "app/session/editor.h"
#include "app/session/settings/brush_library.h"
#include "app/widgets/brush/brush_grid.h"
#include "app/widgets/brush/brush_pictures.h"
#include "app/widgets/habits/keyboard_focus.h"
#include "app/widgets/habits/search_field.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/quantity.h"
#include "model/brush/brush_width.h"

#include <QApplication>
#include <QGridLayout>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

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

QListWidget *BrushPanel::list() const
{
    return m_list;
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
    m_search = new SearchField(this);
    m_search->setObjectName("brushesSearch");
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
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) {
        fillList();
        refresh();
        if (!text.trimmed().isEmpty())
            m_list->showFirst();
    });
    connect(m_search, &QLineEdit::returnPressed, this, &BrushPanel::chooseFound);
    connect(m_favourites, &QToolButton::toggled, this, [this] {
        fillList();
        refresh();
    });
}

/// Takes what was searched for, as the list of the tool's row does: the brush that is marked, else the best one.
void BrushPanel::chooseFound()
{
    const QString marked = BrushGrid::brushOf(m_list->currentItem());
    const QString name = marked.isEmpty() ? m_list->first() : marked;
    if (name.isEmpty())
        return;
    BrushLibrary::instance().use(m_editor, name);
    emit chosen();
}

void BrushPanel::addList(QVBoxLayout &column)
{
    m_list = new BrushGrid(this);
    m_list->setToolTip(tr("Choose what to paint with. The colour stays."));
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    KeyboardFocus::leaveAfterClicks(*m_list);
    column.addWidget(m_list, 1);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem *item) {
        if (BrushGrid::brushOf(item).isEmpty())
            return;
        BrushLibrary::instance().use(m_editor, BrushGrid::brushOf(item));
        if (!(QApplication::mouseButtons() & Qt::RightButton))
            emit chosen();
    });
    connect(m_list, &QListWidget::itemClicked, this, [this](const QListWidgetItem *item) {
        if (!BrushGrid::brushOf(item).isEmpty())
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
    return isBrushCalled(brush, m_search->text());
}

void BrushPanel::fillList()
{
    m_list->fillGroups([this](const Brush &brush) { return isShown(brush); }, m_search->text());
}

QListWidgetItem *BrushPanel::itemOf(const QString &name) const
{
    return m_list->itemOf(name);
}

int BrushPanel::pendingPreviews() const
{
    return BrushPictures::instance().pending();
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
    connect(m_reset, &QToolButton::clicked, this, [this] { BrushLibrary::instance().reload(m_editor, inHand()); });

    QGridLayout *grid = addFieldGrid(column);
    m_size = new SliderField(specOf(Quantity::Size), *grid, 0, this);
    m_flow = new SliderField(specOf(Quantity::Flow), *grid, 1, this);
    m_opacity = new SliderField(specOf(Quantity::Opacity), *grid, 2, this);
    connect(m_size, &SliderField::edited, this,
            [this](double width) { edit([=](Brush &b) { setVisibleWidth(b, width); }); });
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
    const bool modified = BrushLibrary::instance().isChanged(brush);
    m_list->showInHand(brush);
    m_title->setText(modified ? tr("%1 (changed)").arg(brushTitle(brush.name)) : brushTitle(brush.name));
    m_reset->setEnabled(modified);
    if (const Brush *preset = BrushLibrary::instance().find(brush.name)) {
        m_size->setDefaultValue(visibleWidth(*preset));
        m_flow->setDefaultValue(double(preset->peak));
        m_opacity->setDefaultValue(double(preset->colour.opacity));
    }
    m_size->setValue(visibleWidth(brush));
    m_flow->setValue(double(brush.peak));
    m_opacity->setValue(double(brush.colour.opacity));
}

} // namespace suffuse

#include "app/panels/strokes/strokes_panel.h"

#include "app/panels/strokes/group_hand.h"
#include "app/panels/strokes/rows/kept_rows.h"
#include "app/panels/strokes/rows/row_menu.h"
#include "app/panels/strokes/rows/row_moves.h"
#include "app/panels/strokes/rows/row_selection.h"
#include "app/panels/strokes/strokes_filter.h"
#include "app/panels/strokes/strokes_model.h"
#include "app/panels/strokes/strokes_view.h"
#include "app/session/editor.h"
#include "app/widgets/habits/held_button.h"
#include "app/widgets/habits/search_field.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/menu_titles.h"
#include "model/painting/editable.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// The text of a row in a menu that tells the key that does the same in the list.
QString withKey(const QString &text, QKeyCombination key)
{
    return text + QLatin1Char('\t') + QKeySequence(key).toString(QKeySequence::NativeText);
}

} // namespace

StrokesPanel::StrokesPanel(Editor &editor, const QList<QAction *> &more, QWidget *parent)
    : QWidget(parent), m_editor(editor), m_more(more)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 0);
    column->setSpacing(8);
    m_search = new SearchField(this);
    m_search->setObjectName("strokesSearch");
    m_search->setPlaceholderText(tr("Search"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_search->setAccessibleName(tr("Search strokes"));
    m_search->setToolTip(tr("Shows only strokes and groups whose name holds this text. Return selects them."));
    m_header = new QHBoxLayout;
    m_header->setSpacing(4);
    m_header->addWidget(m_search);
    column->addLayout(m_header);
    m_notFound = quietLabel({}, this);
    m_notFound->hide();
    column->addWidget(m_notFound);
    m_layer = quietLabel({}, this);
    m_layer->setObjectName("layer");
    m_layer->setTextFormat(Qt::PlainText);
    column->addWidget(m_layer);

    m_model = new StrokesModel(editor, this);
    m_filter = new StrokesFilter(*m_model, this);
    m_view = new StrokesView(editor, *m_model, *m_filter, this);
    m_view->setAccessibleName(tr("Strokes"));
    m_view->setToolTip(tr("The topmost stroke comes first. Drag to reorder, double-click to rename; a right click "
                          "offers more."));
    column->addWidget(m_view, 1);

    connect(m_search, &QLineEdit::textChanged, this, [this](const QString &text) { search(text.trimmed()); });
    connect(m_view, &StrokesView::dragRefused, this, [this] {
        emit said(
            tr("While the list is searched, rows are not dragged: between those that show there may be others. Clear "
               "the search first."));
    });
    connect(m_view, &StrokesView::stepped, this, &StrokesPanel::step);
    connect(m_view, &StrokesView::chosen, this, &StrokesPanel::chooseLayer);
    connect(&editor.layer(), &CurrentLayer::changed, this, &StrokesPanel::showLayer);
    showLayer();
    connect(m_search, &QLineEdit::returnPressed, this, &StrokesPanel::selectFound);
    // Strokes may come, go and be renamed during a search.
    for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved})
        connect(m_filter, signal, this, &StrokesPanel::showWhetherFound);
    connect(m_filter, &QAbstractItemModel::modelReset, this, &StrokesPanel::showWhetherFound);
    m_kept = new KeptRows(*m_view, *m_model, *m_filter);
    m_selection = new RowSelection(editor, *m_model, *m_filter, *m_view);
    connect(m_model, &StrokesModel::droppedInto, m_kept, &KeptRows::open);
    m_search->installEventFilter(this);
    m_hand = new GroupHand(editor, *m_view);
    connect(m_hand, &GroupHand::said, this, &StrokesPanel::said);
    m_view->installEventFilter(this);
    m_view->viewport()->installEventFilter(this);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &StrokesPanel::showMenu);
}

void StrokesPanel::addSwitch(QAction &action)
{
    auto *button = new QToolButton(this);
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_header->addWidget(button);
}

bool StrokesPanel::isSearching() const
{
    return !m_filter->text().isEmpty();
}

void StrokesPanel::search(const QString &text)
{
    const bool before = isSearching();
    m_kept->search(text);
    showWhetherFound();
    m_selection->follow();
    if (before != isSearching())
        emit searchingChanged();
}

void StrokesPanel::showWhetherFound()
{
    const bool found = !isSearching() || m_filter->rowCount() > 0;
    if (!found)
        m_notFound->setText(tr("No stroke is called “%1”.").arg(m_filter->text()));
    m_notFound->setVisible(!found);
}

void StrokesPanel::showLayer()
{
    const CurrentLayer &layer = m_editor.layer();
    m_layer->setText(layer.group() == 0 ? tr("Painting on top of all")
                     : layer.isComing()
                         ? (layer.begun() && layer.begun()->clips ? tr("New clipped layer: %1") : tr("New layer: %1"))
                               .arg(layer.title())
                         : tr("Painting on: %1").arg(layer.title()));
    m_layer->setToolTip(layer.isComing()
                            ? tr("The layer comes into the list with the first stroke that is painted.")
                            : tr("What is painted goes into this group. A click beside all rows: on top of "
                                 "all again."));
    // A layer that has come gets its row after this.
    QMetaObject::invokeMethod(this, &StrokesPanel::showRowOfLayer, Qt::QueuedConnection);
}

void StrokesPanel::showRowOfLayer()
{
    const StrokesTree::Node *node = m_model->tree().nodeOfGroup(m_editor.layer().group());
    const QModelIndex row = node ? m_filter->mapFromSource(m_model->indexOf(node)) : QModelIndex();
    for (QModelIndex above = row.parent(); above.isValid(); above = above.parent())
        if (!m_view->isExpanded(above)) // Groups that are closed stay closed.
            return;
    if (row.isValid())
        m_view->scrollTo(row);
}

void StrokesPanel::chooseLayer(const QModelIndex &index)
{
    const QModelIndex row = m_filter->mapToSource(index);
    const StrokePtr stroke = m_model->strokeValueAt(row);
    m_editor.layer().choose(stroke ? stroke->group : row.data(StrokesModel::GroupIdRole).toULongLong());
}

void StrokesPanel::selectFound()
{
    if (!isSearching())
        return;
    const Painting &painting = *m_editor.document().painting();
    Selection selection{m_selection->foundBelow({}), {}};
    const Editable isEditable(painting.groups);
    for (const StrokePtr &stroke : painting.strokes)
        if (!isEditable(*stroke))
            selection.strokes.erase(stroke->id);
    if (!selection.strokes.empty()) // Else what is selected stays, and the panel says that nothing was found.
        m_editor.document().setSelection(std::move(selection));
}

void StrokesPanel::goToFirstFound()
{
    QModelIndex row = m_filter->index(0, StrokesModel::NameColumn);
    while (isSearching() && row.isValid() && !m_filter->matches(m_filter->mapToSource(row)) &&
           m_view->indexBelow(row).isValid())
        row = m_view->indexBelow(row); // A row above it may be a group's.
    if (!row.isValid())
        return;
    m_view->setFocus(Qt::TabFocusReason);
    m_view->setCurrentIndex(row);
}

std::vector<GroupId> StrokesPanel::openGroups() const
{
    const std::set<GroupId> open = m_kept->openGroups();
    return {open.begin(), open.end()};
}

void StrokesPanel::openOnly(const std::vector<GroupId> &groups)
{
    m_editor.laterChanges().flush(); // The rows are those of the painting.
    m_kept->openOnly({groups.begin(), groups.end()});
}

QTreeView *StrokesPanel::view() const
{
    return m_view;
}

QSize StrokesPanel::sizeHint() const
{
    return {280, 240};
}

QModelIndex StrokesPanel::viewIndexOf(StrokeId id) const
{
    return m_filter->mapFromSource(m_model->indexOf(id));
}

bool StrokesPanel::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_search && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Down) {
        goToFirstFound();
        return true;
    }
    if (watched == m_view && m_hand->isDragging() && event->type() == QEvent::KeyPress &&
        givesUpDrag(*static_cast<QKeyEvent *>(event))) {
        m_hand->giveUp();
        return true;
    }
    const bool used = watched == m_view->viewport() && (handTakes(*event) || sweep(*event));
    return used || QWidget::eventFilter(watched, event);
}

bool StrokesPanel::handTakes(const QEvent &event)
{
    if (event.type() != QEvent::MouseButtonPress && event.type() != QEvent::MouseButtonDblClick &&
        event.type() != QEvent::MouseMove && event.type() != QEvent::MouseButtonRelease)
        return false;
    const auto &mouse = static_cast<const QMouseEvent &>(event);
    const QModelIndex row = m_view->indexAt(mouse.position().toPoint()).siblingAtColumn(StrokesModel::NameColumn);
    const Group *group = row.isValid() ? m_model->groupAt(m_filter->mapToSource(row)) : nullptr;
    return m_hand->takes(mouse, row, group, m_view->cellsOf(row));
}

bool StrokesPanel::sweep(const QEvent &event)
{
    const bool press = event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
    if (!press && event.type() != QEvent::MouseMove && event.type() != QEvent::MouseButtonRelease)
        return false;
    const auto &mouse = static_cast<const QMouseEvent &>(event);
    const QModelIndex at = m_view->indexAt(mouse.position().toPoint());
    if (press && mouse.button() == Qt::LeftButton && at.isValid() && at.column() != StrokesModel::NameColumn)
        m_sweep = Sweep{at.column(), at.data(StrokesModel::SwitchRole).toBool()};
    else if (press || !m_sweep)
        return false;
    const QModelIndex row = at.siblingAtColumn(m_sweep ? m_sweep->column : 0);
    const bool held = mouse.buttons() & Qt::LeftButton;
    if (held && row.isValid() && row.data(StrokesModel::SwitchRole).toBool() == m_sweep->from)
        m_model->toggle(m_filter->mapToSource(row), &m_sweepStep);
    if (!held) {
        m_sweep.reset();
        m_sweepStep.endSteps();
    }
    return true;
}

void StrokesPanel::step(bool up, bool held)
{
    m_moves.noteStep(held);
    if (const QString why = moveRows(*m_view, *m_model, *m_filter, up, m_moves); !why.isEmpty())
        emit said(why);
    m_editor.laterChanges().flush();
    m_view->scrollTo(m_view->currentIndex());
}

void StrokesPanel::showMenu(const QPoint &at)
{
    const QModelIndex index = m_view->indexAt(at);
    if (!index.isValid())
        return;
    QMenu menu;
    makeMenu(menu, index);
    menu.exec(m_view->viewport()->mapToGlobal(at));
}

void StrokesPanel::makeMenu(QMenu &menu, const QModelIndex &index)
{
    fillMenu(menu, index);
    const QPersistentModelIndex row = index.siblingAtColumn(StrokesModel::NameColumn);
    if (const Group *group = m_model->groupAt(m_filter->mapToSource(row))) {
        menu.addSeparator();
        m_hand->fillModes(*menu.addMenu(tr("&Mode")), group->id);
        const auto type = [this, row] {
            if (const Group *now = row.isValid() ? m_model->groupAt(m_filter->mapToSource(row)) : nullptr)
                m_hand->typeOpacity(row, *now, m_view->cellsOf(row));
        };
        // The menu gives the keyboard back first, which the field then takes.
        menu.addAction(tr("O&pacity…"), this,
                       [this, type] { QMetaObject::invokeMethod(this, type, Qt::QueuedConnection); });
    }
    menu.addSeparator();
    for (const bool up : {true, false})
        menu.addAction(withKey(up ? tr("Mo&ve Up") : tr("Move Do&wn"), Qt::ALT | (up ? Qt::Key_Up : Qt::Key_Down)),
                       this, [this, up] { step(up, false); })
            ->setEnabled(!isSearching());
    makeMnemonicsDistinct(menu);
}

void StrokesPanel::fillMenu(QMenu &menu, const QModelIndex &index)
{
    const QModelIndex name = index.siblingAtColumn(StrokesModel::NameColumn);
    if (name.flags() & Qt::ItemIsEditable)
        menu.addAction(withKey(tr("&Rename"), Qt::Key_F2), m_view, [this, name] { m_view->edit(name); });
    fillRowMenu(menu, m_editor, *m_model, m_filter->mapToSource(name), m_more);
}

} // namespace suffuse

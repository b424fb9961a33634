#include "app/panels/strokes/strokes_filter.h"

#include "app/panels/strokes/strokes_model.h"

#include <algorithm>

namespace suffuse {

namespace {

/// Tells whether names contain a text. Making the names that strokes without one have is the most of the work.
class NameMatch {
public:
    explicit NameMatch(const QString &text) : m_text(text)
    {
        const QString pattern = StrokesModel::tr("Stroke %1");
        m_place = pattern.indexOf(QLatin1String("%1"));
        m_before = pattern.left(m_place);
        m_after = pattern.mid(m_place + 2);
    }

    bool operator()(const StrokesTree &tree, const StrokesTree::Node &node) const
    {
        const Group *group = tree.groupOf(node.group);
        if (group || !node.value || !node.value->name.isEmpty() || m_place < 0)
            return group ? isIn(titleOf(*group)) : node.value && isIn(titleOf(*node.value));
        return isIn(m_before + QString::number(node.stroke) + m_after);
    }

private:
    bool isIn(const QString &name) const { return name.contains(m_text, Qt::CaseInsensitive); }

    const QString &m_text;
    QString m_before, m_after;
    qsizetype m_place = -1;
};

} // namespace

StrokesFilter::StrokesFilter(StrokesModel &model, QObject *parent) : QAbstractProxyModel(parent), m_model(model)
{
    setSourceModel(&model);
    passOn();
    connect(&model, &StrokesModel::followed, this, &StrokesFilter::endReset);
    // A row that is renamed decides about the groups around it, too. The field that it was typed in is closed first.
    connect(&model, &StrokesModel::renamed, this, [this] {
        if (m_model.isRenaming())
            QMetaObject::invokeMethod(this, &StrokesFilter::lookAgain, Qt::QueuedConnection);
        else
            lookAgain();
    });
}

/// During a search all is reset once where any row comes, goes or moves.
void StrokesFilter::passOn()
{
    const auto passes = [this](const auto &begin) { m_text.isEmpty() ? void(begin()) : beginReset(); };
    const auto ends = [this](const auto &end) {
        if (m_text.isEmpty())
            end();
    };
    connect(&m_model, &QAbstractItemModel::rowsAboutToBeInserted, this,
            [=, this](const QModelIndex &parent, int first, int last) {
                passes([&] { beginInsertRows(mapFromSource(parent), first, last); });
            });
    connect(&m_model, &QAbstractItemModel::rowsInserted, this, [=, this] { ends([&] { endInsertRows(); }); });
    connect(&m_model, &QAbstractItemModel::rowsAboutToBeRemoved, this,
            [=, this](const QModelIndex &parent, int first, int last) {
                passes([&] { beginRemoveRows(mapFromSource(parent), first, last); });
            });
    connect(&m_model, &QAbstractItemModel::rowsRemoved, this, [=, this] { ends([&] { endRemoveRows(); }); });
    connect(&m_model, &QAbstractItemModel::rowsAboutToBeMoved, this,
            [=, this](const QModelIndex &from, int first, int last, const QModelIndex &to, int row) {
                passes([&] { beginMoveRows(mapFromSource(from), first, last, mapFromSource(to), row); });
            });
    connect(&m_model, &QAbstractItemModel::rowsMoved, this, [=, this] { ends([&] { endMoveRows(); }); });
    connect(&m_model, &QAbstractItemModel::layoutAboutToBeChanged, this,
            [=, this] { passes([&] { emit layoutAboutToBeChanged(); }); });
    connect(&m_model, &QAbstractItemModel::layoutChanged, this, [=, this] {
        ends([&] {
            const QModelIndexList before = persistentIndexList();
            QModelIndexList after;
            for (const QModelIndex &old : before) // Nodes know the rows where they stand by now.
                after << mapFromSource(mapToSource(old));
            changePersistentIndexList(before, after);
            emit layoutChanged();
        });
    });
    connect(&m_model, &QAbstractItemModel::modelAboutToBeReset, this, &StrokesFilter::beginReset);
    connect(&m_model, &QAbstractItemModel::modelReset, this, &StrokesFilter::endReset);
    connect(&m_model, &QAbstractItemModel::dataChanged, this,
            [this](const QModelIndex &first, const QModelIndex &last, const QList<int> &roles) {
                if (m_resetting)
                    return;
                const std::vector<int> *shown = shownBelow(first.parent());
                if (!shown) {
                    if (const QModelIndex from = mapFromSource(first); from.isValid())
                        emit dataChanged(from, mapFromSource(last), roles);
                    return;
                }
                const auto from = std::ranges::lower_bound(*shown, first.row());
                const auto to = std::ranges::upper_bound(*shown, last.row());
                const QModelIndex parent = mapFromSource(first.parent());
                if (from < to && (parent.isValid() || !first.parent().isValid()))
                    emit dataChanged(index(int(from - shown->begin()), first.column(), parent),
                                     index(int(to - shown->begin()) - 1, last.column(), parent), roles);
            });
}

void StrokesFilter::beginReset()
{
    if (std::exchange(m_resetting, true))
        return;
    emit aboutToReset();
    beginResetModel();
}

void StrokesFilter::endReset()
{
    if (!m_resetting)
        return;
    m_found = find();
    m_resetting = false;
    endResetModel();
}

void StrokesFilter::setText(const QString &text)
{
    if (text == m_text)
        return;
    beginReset();
    m_text = text;
    endReset();
}

void StrokesFilter::lookAgain()
{
    if (m_text.isEmpty())
        return;
    Found found = find();
    if (found.shown != m_found.shown) {
        beginReset();
        endReset();
    } else {
        m_found = std::move(found);
    }
}

StrokesFilter::Found StrokesFilter::find() const
{
    Found found;
    if (m_text.isEmpty())
        return found;
    const StrokesTree &tree = m_model.tree();
    const NameMatch isMatch(m_text);
    // Returns whether something below a node matches. What is in a group that matches is shown whole.
    const auto look = [&](const Node &node, bool isWhole, const auto &again) -> bool {
        std::vector<int> shown;
        bool any = false;
        for (const auto &child : node.children) {
            const bool own = isMatch(tree, *child);
            const bool below = child->group != 0 && again(*child, isWhole || own, again);
            any = any || own || below;
            if (own || below)
                shown.push_back(child->row);
        }
        if (!isWhole && shown.size() < node.children.size())
            found.shown.emplace(&node, std::move(shown));
        if (any)
            found.holding.insert(&node);
        return any;
    };
    look(tree.root(), false, look);
    return found;
}

const StrokesFilter::Node *StrokesFilter::nodeOf(const QModelIndex &source) const
{
    if (!source.isValid())
        return &m_model.tree().root();
    const StrokeId stroke = m_model.strokeAt(source);
    const Group *group = stroke ? nullptr : m_model.groupAt(source);
    return stroke ? m_model.tree().nodeOf(stroke) : group ? m_model.tree().nodeOfGroup(group->id) : nullptr;
}

/// Null where all rows are shown, or where the parent is a stroke.
const std::vector<int> *StrokesFilter::shownBelow(const QModelIndex &sourceParent) const
{
    if (m_found.shown.empty())
        return nullptr;
    const auto it = m_found.shown.find(nodeOf(sourceParent));
    return it == m_found.shown.end() ? nullptr : &it->second;
}

bool StrokesFilter::hidesSome(const QModelIndex &group) const
{
    return shownBelow(mapToSource(group)) != nullptr;
}

bool StrokesFilter::matches(const QModelIndex &index) const
{
    return index.data().toString().contains(m_text, Qt::CaseInsensitive);
}

bool StrokesFilter::holdsMatchWithin(const QModelIndex &group) const
{
    return m_text.isEmpty() || m_found.holding.contains(nodeOf(group));
}

QModelIndex StrokesFilter::mapToSource(const QModelIndex &index) const
{
    return m_model.indexLike(index);
}

QModelIndex StrokesFilter::mapFromSource(const QModelIndex &index) const
{
    if (!index.isValid() || m_found.shown.empty())
        return index.isValid() ? createIndex(index.row(), index.column(), index.internalId()) : QModelIndex();
    int row = index.row();
    for (QModelIndex at = index; at.isValid(); at = at.parent()) {
        const std::vector<int> *shown = shownBelow(at.parent());
        if (!shown)
            continue;
        const auto place = std::ranges::lower_bound(*shown, at.row());
        if (place == shown->end() || *place != at.row())
            return {};
        if (at == index)
            row = int(place - shown->begin());
    }
    return createIndex(row, index.column(), index.internalId());
}

QModelIndex StrokesFilter::index(int row, int column, const QModelIndex &parent) const
{
    const QModelIndex above = mapToSource(parent);
    const std::vector<int> *shown = shownBelow(above);
    if (row < 0 || (shown && row >= int(shown->size())))
        return {};
    const QModelIndex source = m_model.index(shown ? (*shown)[std::size_t(row)] : row, column, above);
    return source.isValid() ? createIndex(row, column, source.internalId()) : QModelIndex();
}

QModelIndex StrokesFilter::parent(const QModelIndex &child) const
{
    return mapFromSource(mapToSource(child).parent());
}

QModelIndex StrokesFilter::sibling(int row, int column, const QModelIndex &index) const
{
    if (row == index.row() && index.isValid() && column >= 0 && column < columnCount())
        return createIndex(row, column, index.internalId());
    return this->index(row, column, parent(index));
}

int StrokesFilter::rowCount(const QModelIndex &parent) const
{
    const QModelIndex above = mapToSource(parent);
    const std::vector<int> *shown = parent.column() > 0 ? nullptr : shownBelow(above);
    return shown ? int(shown->size()) : m_model.rowCount(above);
}

int StrokesFilter::columnCount(const QModelIndex &) const
{
    return m_model.columnCount();
}

bool StrokesFilter::hasChildren(const QModelIndex &parent) const
{
    return m_model.hasChildren(mapToSource(parent));
}

} // namespace suffuse

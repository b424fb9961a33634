#pragma once

#include "app/panels/strokes/group_cells.h"
#include "app/panels/strokes/thumbnails/group_thumbnails.h"
#include "app/panels/strokes/thumbnails/stroke_thumbnails.h"

#include <QCache>
#include <QStyledItemDelegate>

namespace suffuse {

class Editor;
class StrokesFilter;
class StrokesModel;

/// Paints a small picture of a stroke or a group before its name, a chip of its colour before a segment's name, what is
/// unusual behind it, and eyes and locks in the middle of their columns.
class RowDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    RowDelegate(Editor &editor, const StrokesModel &model, const StrokesFilter &filter, QObject *parent);

    /// Where the cells of a group's row stand, whose name's cell is `rect`. `index` is its row.
    static GroupCells cellsOf(const Group &group, const QModelIndex &index, const QRect &rect, const QFont &font);

    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    bool eventFilter(QObject *object, QEvent *event) override;

signals:
    /// Emitted when there is another picture for a row of the model.
    void pictureReady(const QModelIndex &row);

private:
    void addPicture(QStyleOptionViewItem *option, const QModelIndex &index) const;
    void addGroupPicture(QStyleOptionViewItem *option, GroupId group) const;
    /// Keeps icons. A new icon for each painting would fill Qt's cache of pixmaps with equal ones.
    template <typename Make>
    QIcon remembered(std::pair<qint64, qint64> key, Make make) const;
    /// Whether what a row stands for is not seen since others are shown alone.
    bool isHidden(const QModelIndex &index) const;
    QIcon chipOf(const QColor &colour, const QStyleOptionViewItem &option) const;

    Editor &m_editor;
    const StrokesModel &m_model;
    const StrokesFilter &m_filter;
    StrokeThumbnails *m_strokes;
    GroupThumbnails *m_groups;
    mutable QCache<std::pair<qint64, qint64>, QIcon> m_icons{256};
};

} // namespace suffuse

#pragma once

#include <QStyledItemDelegate>

namespace suffuse {

/// Draws rows of the manual's contents: the heading of a section quietly, a page by its title, and, below the title of a
/// page in which something was found, what stands around it.
class HitDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    enum Role { ExcerptRole = Qt::UserRole + 1, IsHeadingRole };

    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    void paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const override;
};

} // namespace suffuse

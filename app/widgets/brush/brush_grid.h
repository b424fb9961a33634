// Brushes with pictures of their strokes, to choose from.
#pragma once

#include "model/brush/brush.h"

#include <QListWidget>

#include <functional>

namespace suffuse {

/// Lists brushes of the library as pictures in rows, with their names below. It chooses none by itself: whoever shows
/// it listens to the list.
class BrushGrid : public QListWidget {
    Q_OBJECT

public:
    explicit BrushGrid(QWidget *parent = nullptr);

    /// The brushes that pass, in their groups below headings; the user's stand behind those that came along. Where a
    /// text was typed to search for them, the group with the brush whose name it suits best comes first, and that brush
    /// in it.
    void fillGroups(const std::function<bool(const Brush &brush)> &isShown, const QString &typed = {});
    /// These, in this order, without headings.
    void fill(const QStringList &names);

    /// Empty for a heading.
    static QString brushOf(const QListWidgetItem *item);
    /// The item of a brush that is shown; null if there is none.
    QListWidgetItem *itemOf(const QString &name) const;
    /// The name of the first brush that is shown; empty if there is none.
    QString first() const;
    /// Marks that one, tells nobody, and shows it.
    void showFirst();
    /// Marks a brush, or none, and tells nobody.
    void mark(const QString &name);
    /// Marks the brush in hand, which may have changes, and tells nobody.
    void showInHand(const Brush &brush);
    /// The size of the list's contents where so many pictures stand in a row and so many rows are seen.
    QSize sizeFor(int columns, int rows) const;

protected:
    /// Where it shows no brush it says so.
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void addHeading(const QString &group);
    void addBrush(const Brush &brush);
    void fitHeadings();
    void scrollToMarkedSoon();
    void setPicture(QListWidgetItem *item);
    QSize cell() const;

    QString m_inHand;         ///< empty where nobody has told
    bool m_isChanged = false; ///< whether the brush in hand is
    bool m_started = false;
    bool m_isMarkedSeen = false; ///< what the last picture of the list showed
};

} // namespace suffuse

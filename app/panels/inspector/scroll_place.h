// What a panel shows of its contents, whatever comes and goes above that.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QScrollArea>

namespace suffuse {

/// Keeps what stands at the upper edge of a panel there. The scroll bar alone would show other fields once rows above
/// have appeared or gone. The panel's contents are pages of which one is shown at a time, and each has its own place.
class ScrollPlace : public QObject {
public:
    ScrollPlace(QScrollArea &scroll, const QWidgetList &pages);

    /// Scrolls to where the shown page was left. To be called when pages or rows were shown or hidden. Whoever was at
    /// the beginning of the page stays there; for a row that is gone what held it counts.
    void restore();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Anchor {
        QPointer<QWidget> widget;
        int below = 0; ///< logical pixels from the upper edge of what is seen
    };
    struct Page {
        QWidget *widget = nullptr;
        QList<Anchor> anchors; ///< from the innermost widget outwards; none at the beginning of the page
    };

    Page &shown();
    void take();
    void scrollToAnchor();

    QScrollArea &m_scroll;
    QList<Page> m_pages;
    bool m_restoring = false;
};

} // namespace suffuse

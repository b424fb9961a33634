#include "app/widgets/habits/dialog_scroll.h"

#include "app/widgets/look/section.h"

#include <QApplication>
#include <QBoxLayout>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QScrollBar>

#include <algorithm>

namespace suffuse {

namespace {

/// As large as its contents, where there is room. It shows what has the keyboard, also where that comes from a button
/// outside.
class DialogScroll : public PanelScroll {
public:
    DialogScroll(int mostWidth, QWidget *parent) : PanelScroll(parent), m_mostWidth(mostWidth)
    {
        setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
        connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) {
            if (now && isAncestorOf(now))
                ensureWidgetVisible(now);
        });
    }
    QSize minimumSizeHint() const override
    {
        return PanelScroll::minimumSizeHint().boundedTo({m_mostWidth, QWIDGETSIZE_MAX});
    }
    QSize sizeHint() const override { return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0); }

private:
    const int m_mostWidth;
};

int leastHeight(const QLayout &layout)
{
    const QSize least = layout.totalMinimumSize();
    return layout.hasHeightForWidth() ? std::max(least.height(), layout.totalMinimumHeightForWidth(least.width()))
                                      : least.height();
}

} // namespace

void scrollIfHigher(QDialog &dialog, QSize room)
{
    QLayout *all = dialog.layout();
    if (!all || !(qobject_cast<QBoxLayout *>(all) || qobject_cast<QFormLayout *>(all)) ||
        leastHeight(*all) <= room.height())
        return;
    QWidget *focus = dialog.focusWidget();
    const QMargins margins = all->contentsMargins();
    auto *buttons = dialog.findChild<QDialogButtonBox *>(QString(), Qt::FindDirectChildrenOnly);
    if (buttons)
        all->removeWidget(buttons);
    auto *scroll = new DialogScroll(room.width(), &dialog);
    auto *content = new QWidget;
    content->setLayout(all); // which takes it and its widgets from the dialog
    scroll->setWidget(content);
    auto *column = new QVBoxLayout(&dialog);
    column->setContentsMargins({});
    column->addWidget(scroll, 1);
    if (focus)
        focus->setFocus(); // which it lost when it went into the area
    if (!buttons)
        return;
    auto *row = new QHBoxLayout;
    row->setContentsMargins(margins.left(), 0, margins.right(), margins.bottom());
    row->addWidget(buttons);
    column->addLayout(row);
}

} // namespace suffuse

#include "app/widgets/look/section.h"

#include "app/widgets/habits/lay_out.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QGridLayout>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

namespace suffuse {

QLabel *sectionTitle(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    QFont bold = label->font();
    bold.setWeight(QFont::DemiBold);
    label->setFont(bold);
    return label;
}

QGridLayout *addFieldGrid(QVBoxLayout &column)
{
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(1, 1);
    column.addLayout(grid);
    return grid;
}

QLabel *quietLabel(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

void showInPlace(QLabel &label, const QString &text)
{
    label.setText(text);
    label.setFixedSize(label.sizeHint().expandedTo(label.minimumSize()));
}

namespace {

void scrollTo(QWidget &widget)
{
    for (QWidget *outer = widget.parentWidget(); outer; outer = outer->parentWidget()) {
        auto *scroll = qobject_cast<QScrollArea *>(outer);
        if (!scroll || !scroll->widget())
            continue;
        // The panel grows for a hint when it is laid out, which may not have happened yet.
        layOutNow(*scroll);
        // Of a text field ensureWidgetVisible would show the cursor alone.
        const QRect place(widget.mapTo(scroll->widget(), QPoint()), widget.size());
        scroll->ensureVisible(place.center().x(), place.center().y(), 0, place.height() / 2 + 1);
    }
}

} // namespace

void keepInSight(QWidget &widget)
{
    QTimer::singleShot(0, &widget, [&widget] { scrollTo(widget); });
}

HintLabel::HintLabel(QWidget *parent) : QLabel(parent)
{
    setWordWrap(true);
    setMargin(8);
    setAccessibleName(tr("Hint"));
    setForegroundRole(QPalette::BrightText); // which the theme gives the colour of warnings
    hide();
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget *from, const QWidget *to) {
        if (m_passing && from && to) // not when another window comes to the front
            showHint({});
    });
}

void HintLabel::showHint(const QString &hint)
{
    setText(hint);
    setVisible(!hint.isEmpty());
    m_passing = false;
    // A dialog does not grow by itself for a text that wraps, and its fields would be squeezed.
    QWidget *dialog = window();
    if (hint.isEmpty() || !qobject_cast<QDialog *>(dialog) || !dialog->layout())
        return;
    dialog->layout()->activate();
    const int wanted = dialog->layout()->totalHeightForWidth(dialog->width());
    if (wanted > dialog->height())
        dialog->resize(dialog->width(), wanted);
}

void HintLabel::showRefusal(const QString &hint)
{
    showHint(hint);
    // This is done later: the Tab that left the field, or the Return that gives the keyboard back, is still on its way.
    QTimer::singleShot(0, this, [this] {
        m_passing = !text().isEmpty();
        scrollTo(*this);
    });
}

PanelScroll::PanelScroll(QWidget *parent) : QScrollArea(parent)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
}

QSize PanelScroll::minimumSizeHint() const
{
    const int content = widget() ? widget()->minimumSizeHint().expandedTo(widget()->minimumSize()).width() : 0;
    return {content + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
}

bool PanelScroll::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry(); // the panel may need more room now
    return QScrollArea::eventFilter(watched, event);
}

void alignFieldLabels(QWidget &parent)
{
    QList<QLabel *> first;
    int width = 0;
    const auto collect = [&](QLayout *layout) {
        if (auto *grid = qobject_cast<QGridLayout *>(layout))
            for (int row = 0; row < grid->rowCount(); ++row)
                if (QLayoutItem *item = grid->itemAtPosition(row, 0))
                    if (auto *label = qobject_cast<QLabel *>(item->widget())) {
                        first << label;
                        width = std::max(width, label->sizeHint().width());
                    }
    };
    for (QLayout *layout : parent.findChildren<QLayout *>())
        collect(layout);
    for (QLabel *label : first)
        label->setMinimumWidth(width);
}

} // namespace suffuse

#include "app/widgets/habits/spoken_names.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QAccessibleWidget>
#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QToolButton>

namespace suffuse {

namespace {

/// A drop-down, with its list, and its field where it can be typed into, as its children.
class SpokenCombo : public QAccessibleWidget {
public:
    explicit SpokenCombo(QComboBox &box) : QAccessibleWidget(&box, QAccessible::ComboBox) {}

    int childCount() const override { return box().isEditable() ? 2 : 1; }

    QAccessibleInterface *child(int index) const override
    {
        return index == 0                        ? QAccessible::queryAccessibleInterface(box().view())
               : index == 1 && box().isEditable() ? QAccessible::queryAccessibleInterface(box().lineEdit())
                                                 : nullptr;
    }

    int indexOfChild(const QAccessibleInterface *child) const override
    {
        return child->object() == box().view()                            ? 0
               : box().isEditable() && child->object() == box().lineEdit() ? 1
                                                                          : -1;
    }

    QString text(QAccessible::Text kind) const override
    {
        if (kind == QAccessible::Value)
            return box().currentText();
        if (kind != QAccessible::Name)
            return QAccessibleWidget::text(kind);
        const QString name = QAccessibleWidget::text(QAccessible::Name), chosen = box().currentText();
        if (name.isEmpty() || chosen.isEmpty() || name == chosen)
            return name.isEmpty() ? chosen : name;
        //: a drop-down and what is chosen in it: "Speed, 2×"
        return QCoreApplication::translate("SpokenNames", "%1, %2").arg(name, chosen);
    }

    QAccessible::State state() const override
    {
        QAccessible::State state = QAccessibleWidget::state();
        state.hasPopup = true;
        state.expandable = true;
        state.expanded = box().view()->isVisible();
        state.collapsed = !state.expanded;
        state.editable = box().isEditable();
        return state;
    }

    QStringList actionNames() const override
    {
        return QStringList{showMenuAction(), pressAction()} + QAccessibleWidget::actionNames();
    }

    void doAction(const QString &name) override
    {
        if (name != showMenuAction() && name != pressAction())
            return QAccessibleWidget::doAction(name);
        if (box().view()->isVisible())
            box().hidePopup();
        else
            box().showPopup();
    }

private:
    QComboBox &box() const { return *static_cast<QComboBox *>(object()); }
};

QAccessibleInterface *makeSpokenCombo(const QString &, QObject *object)
{
    auto *box = qobject_cast<QComboBox *>(object);
    return box ? new SpokenCombo(*box) : nullptr;
}

/// The drop-down that a list belongs to; null where it belongs to none.
QComboBox *comboOf(const QAbstractItemView &list)
{
    auto *box = list.parentWidget() ? qobject_cast<QComboBox *>(list.parentWidget()->parentWidget()) : nullptr;
    return box && box->view() == &list ? box : nullptr;
}

} // namespace

void installSpokenNames()
{
    static const bool installed = (QAccessible::installFactory(makeSpokenCombo), true);
    Q_UNUSED(installed);
}

void nameOwnWidgetOfQt(QWidget &widget)
{
    // Lists do not tell what their tool tips say, as other widgets do.
    if (qobject_cast<const QAbstractItemView *>(&widget) && widget.accessibleDescription().isEmpty() &&
        !widget.toolTip().isEmpty())
        widget.setAccessibleDescription(widget.toolTip());
    if (!widget.accessibleName().isEmpty())
        return;
    if (const auto *list = qobject_cast<const QAbstractItemView *>(&widget)) {
        if (const QComboBox *box = comboOf(*list)) {
            const QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(const_cast<QComboBox *>(box));
            widget.setAccessibleName(spoken ? spoken->text(QAccessible::Name) : QString());
        }
    } else if (auto *button = qobject_cast<QToolButton *>(&widget);
               button && button->objectName() == QLatin1String("qt_toolbar_ext_button")) {
        button->setAccessibleName(QCoreApplication::translate("SpokenNames", "More buttons"));
        button->setToolTip(button->accessibleName());
    }
}

} // namespace suffuse

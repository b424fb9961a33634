#include "app/widgets/habits/house_rules.h"

#include "app/widgets/habits/dialog_scroll.h"
#include "app/widgets/habits/place_beside.h"
#include "app/widgets/habits/spoken_names.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollBar>
#include <QTabBar>
#include <QToolButton>
#include <QTreeView>

namespace suffuse {

namespace {

/// Whether the wheel would change something for good in this widget, or bring something else to the front, where the
/// user meant to scroll.
bool wheelAlters(const QObject *widget)
{
    return qobject_cast<const QAbstractSpinBox *>(widget) || qobject_cast<const QComboBox *>(widget) ||
           qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QTabBar *>(widget) ||
           (qobject_cast<const QAbstractSlider *>(widget) && !qobject_cast<const QScrollBar *>(widget));
}

bool isField(const QWidget &widget)
{
    return qobject_cast<const QAbstractSpinBox *>(&widget) || qobject_cast<const QComboBox *>(&widget) ||
           qobject_cast<const QLineEdit *>(&widget) || qobject_cast<const QAbstractItemView *>(&widget);
}

/// Gives the keyboard to a dialog's first field where the dialog itself has not chosen one, so that nothing gets lost
/// that is typed at once.
void focusFirstField(QDialog &dialog)
{
    if (dialog.focusWidget())
        return;
    for (QWidget *w = dialog.nextInFocusChain(); w && w != &dialog; w = w->nextInFocusChain())
        if (dialog.isAncestorOf(w) && isField(*w) && w->focusPolicy() & Qt::TabFocus && !w->focusProxy() &&
            w->isEnabled() && w->isVisibleTo(&dialog))
            return w->setFocus(Qt::TabFocusReason);
}

/// In Qt's own file dialog sizes, types and dates are as wide as some texts of long ago; names get what they leave.
void fitColumns(const QFileDialog &dialog)
{
    const auto *files = dialog.findChild<QTreeView *>(QStringLiteral("treeView"));
    if (!files) // the desktop's dialog
        return;
    QHeaderView &header = *files->header();
    header.setResizeContentsPrecision(0); // what is seen; a folder may hold thousands of files
    header.setSectionResizeMode(QHeaderView::ResizeToContents);
    header.setSectionResizeMode(0, QHeaderView::Stretch);
}

/// Qt calls the type of a file "unknown" where no desktop has been told of it.
class FileTypes : public QFileIconProvider {
    Q_DECLARE_TR_FUNCTIONS(suffuse::FileTypes)

public:
    QString type(const QFileInfo &file) const override
    {
        const QString ending = file.suffix().toLower();
        if (file.isDir())
            return QFileIconProvider::type(file);
        if (ending == QLatin1String("suffuse"))
            return tr("Suffuse painting");
        if (ending == QLatin1String("suffuse-brush"))
            return tr("Suffuse brush");
        return ending.startsWith(QLatin1String("suffuse~")) ? tr("Backup of a painting")
                                                            : QFileIconProvider::type(file);
    }
};

void nameOwnTypes(QFileDialog &dialog)
{
    static FileTypes types;
    dialog.setIconProvider(&types);
}

/// Presses a dialog's button that has the keyboard. Qt would press the dialog's default button for those that may not
/// become it, which are those that Return in a field must not press, and for tool buttons.
bool pressFocused(QObject *watched, const QKeyEvent &key)
{
    const bool isReturn = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    const bool plain = !(key.modifiers() & ~Qt::KeypadModifier);
    auto *button = qobject_cast<QAbstractButton *>(watched);
    if (!isReturn || !plain || !button || !button->hasFocus() || !qobject_cast<QDialog *>(button->window()))
        return false;
    if (auto *tool = qobject_cast<QToolButton *>(button); tool && tool->popupMode() == QToolButton::InstantPopup) {
        tool->showMenu();
        return true;
    }
    const auto *push = qobject_cast<QPushButton *>(button);
    if (!qobject_cast<QToolButton *>(button) && (!push || push->autoDefault() || push->isDefault()))
        return false;
    button->click();
    return true;
}

class HouseRules : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override
    {
        switch (event->type()) {
        case QEvent::Polish:
            if (auto *dialog = qobject_cast<QDialog *>(watched); dialog && dialog->isWindow())
                scrollIfHigher(*dialog, roomFor(*dialog));
            // With this policy, Qt would give the focus before the wheel event reaches the widget.
            if (auto *widget = qobject_cast<QWidget *>(watched); widget && widget->focusPolicy() == Qt::WheelFocus)
                widget->setFocusPolicy(Qt::StrongFocus);
            if (auto *widget = qobject_cast<QWidget *>(watched))
                nameOwnWidgetOfQt(*widget);
            break;
        case QEvent::Wheel:
            if (wheelAlters(watched) && !static_cast<QWidget *>(watched)->hasFocus()) {
                event->ignore(); // Qt then goes on to the parent, which may scroll
                return true;
            }
            break;
        case QEvent::KeyPress:
            if (pressFocused(watched, *static_cast<QKeyEvent *>(event)))
                return true;
            break;
        case QEvent::Show:
            if (auto *dialog = qobject_cast<QDialog *>(watched);
                dialog && dialog->isWindow() && !event->spontaneous()) {
                placeDialog(*dialog);
                focusFirstField(*dialog);
                if (auto *files = qobject_cast<QFileDialog *>(dialog)) {
                    nameOwnTypes(*files);
                    fitColumns(*files);
                }
            }
            break;
        default:
            break;
        }
        return QObject::eventFilter(watched, event);
    }
};

} // namespace

void installHouseRules()
{
    static QPointer<HouseRules> rules; // is deleted with the application
    if (rules)
        return;
    rules = new HouseRules(qApp);
    qApp->installEventFilter(rules);
}

} // namespace suffuse

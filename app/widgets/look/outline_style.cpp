#include "app/widgets/look/outline_style.h"

#include "app/widgets/look/icons.h"
#include "app/widgets/look/reduced_motion.h"
#include "app/widgets/look/theme.h"

#include <QAbstractItemView>
#include <QMainWindow>
#include <QPainter>
#include <QPushButton>
#include <QStyleOption>
#include <QWidget>

namespace suffuse {

namespace {

/// The outline that takes the place of one of Qt's pictures; null if there is none.
const char *outlineNameOf(QStyle::StandardPixmap standard)
{
    switch (standard) {
    case QStyle::SP_TitleBarNormalButton:
        return "float";
    case QStyle::SP_TitleBarCloseButton:
    case QStyle::SP_DockWidgetCloseButton:
    case QStyle::SP_TabCloseButton:
    case QStyle::SP_DialogCancelButton:
    case QStyle::SP_DialogCloseButton:
    case QStyle::SP_DialogNoButton:
    case QStyle::SP_DialogAbortButton:
    case QStyle::SP_LineEditClearButton:
        return "close";
    case QStyle::SP_DialogOkButton:
    case QStyle::SP_DialogYesButton:
    case QStyle::SP_DialogApplyButton:
    case QStyle::SP_DialogYesToAllButton:
        return "ok";
    case QStyle::SP_DialogSaveButton:
    case QStyle::SP_DialogSaveAllButton:
        return "save";
    case QStyle::SP_DialogOpenButton:
    case QStyle::SP_DirOpenIcon:
        return "open";
    case QStyle::SP_DialogDiscardButton:
        return "delete";
    case QStyle::SP_DialogResetButton:
    case QStyle::SP_RestoreDefaultsButton:
    case QStyle::SP_DialogRetryButton:
    case QStyle::SP_BrowserReload:
        return "reset";
    case QStyle::SP_DialogHelpButton:
    case QStyle::SP_MessageBoxQuestion:
        return "question";
    case QStyle::SP_MessageBoxWarning:
    case QStyle::SP_MessageBoxCritical:
        return "warning";
    case QStyle::SP_MessageBoxInformation:
        return "information";
    case QStyle::SP_ToolBarHorizontalExtensionButton:
        return "more-right";
    case QStyle::SP_ToolBarVerticalExtensionButton:
        return "more-down";
    case QStyle::SP_ArrowBack:
    case QStyle::SP_ArrowLeft:
    case QStyle::SP_FileDialogBack:
        return "back";
    case QStyle::SP_ArrowForward:
    case QStyle::SP_ArrowRight:
        return "forward";
    case QStyle::SP_FileDialogToParent:
    case QStyle::SP_ArrowUp:
        return "raise";
    case QStyle::SP_ArrowDown:
        return "lower";
    case QStyle::SP_FileDialogNewFolder:
        return "new-folder";
    case QStyle::SP_FileDialogListView:
        return "list";
    case QStyle::SP_FileDialogDetailedView:
    case QStyle::SP_FileDialogContentsView:
        return "menu";
    case QStyle::SP_DirIcon:
    case QStyle::SP_DirLinkIcon:
    case QStyle::SP_DirClosedIcon:
        return "group";
    case QStyle::SP_FileIcon:
    case QStyle::SP_FileLinkIcon:
        return "file";
    case QStyle::SP_DirHomeIcon:
        return "home";
    case QStyle::SP_ComputerIcon:
    case QStyle::SP_DesktopIcon:
        return "computer";
    case QStyle::SP_DriveHDIcon:
    case QStyle::SP_DriveNetIcon:
    case QStyle::SP_DriveCDIcon:
    case QStyle::SP_DriveDVDIcon:
    case QStyle::SP_DriveFDIcon:
        return "drive";
    default:
        return nullptr;
    }
}

/// Focus that the keyboard has brought, which is seen as long as the keyboard is used.
bool showsFocus(const QStyleOption &option)
{
    return (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_KeyboardFocusChange);
}

/// Fusion's own frames are of the colour of selections, which is too dark to be seen on dark windows.
void drawFocus(QPainter &painter, const QRect &area, int width, const QColor &colour = focusFrame())
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, width));
    const double half = 0.5 * width;
    painter.drawRoundedRect(QRectF(area).adjusted(half, half, -half, -half), 2, 2);
    painter.restore();
}

/// Where dragged rows will go: a line between two rows, or a frame around the one that takes them. It has an edge, so
/// that it is seen on selected rows, too.
void drawDropPlace(QPainter &painter, const QStyleOption &option)
{
    const QPalette &palette = option.palette;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const auto &[colour, width] : {std::pair(palette.color(QPalette::Base), 6.0), {focusFrame(), 2.0}}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (option.rect.height() == 0)
            painter.drawLine(QPointF(option.rect.left() + 3, option.rect.top()),
                             QPointF(option.rect.right() - 3, option.rect.top()));
        else
            painter.drawRoundedRect(QRectF(option.rect).adjusted(3, 3, -3, -3), 2, 2);
    }
    painter.restore();
}

} // namespace

OutlineStyle::OutlineStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

QIcon OutlineStyle::standardIcon(StandardPixmap standard, const QStyleOption *option, const QWidget *widget) const
{
    const char *outline = outlineNameOf(standard);
    return outline ? icon(outline) : QProxyStyle::standardIcon(standard, option, widget);
}

QPixmap OutlineStyle::standardPixmap(StandardPixmap standard, const QStyleOption *option, const QWidget *widget) const
{
    const char *outline = outlineNameOf(standard);
    if (!outline)
        return QProxyStyle::standardPixmap(standard, option, widget);
    const int side = pixelMetric(PM_SmallIconSize, option, widget);
    return icon(outline).pixmap(QSize(side, side), widget ? widget->devicePixelRatioF() : 1);
}

void OutlineStyle::drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                                 const QWidget *widget) const
{
    if (element == PE_IndicatorItemViewItemDrop)
        return drawDropPlace(*painter, *option);
    if (element == PE_FrameFocusRect) {
        const bool isRow = qobject_cast<const QAbstractItemView *>(widget);
        const bool isSelected = isRow && option->state & State_Selected;
        if (isSelected) // The frame has the colour of the selection, or nearly so.
            drawFocus(*painter, option->rect, 2, option->palette.color(QPalette::HighlightedText));
        else if (isRow)
            drawFocus(*painter, option->rect, 2);
        else if (showsFocus(*option) && !qobject_cast<const QPushButton *>(widget))
            drawFocus(*painter, option->rect, 1);
        return; // A push button has its frame around it, and not within.
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_PanelButtonCommand && showsFocus(*option))
        drawFocus(*painter, option->rect, 2);
    if (element != PE_IndicatorCheckBox)
        return;
    painter->save();
    painter->setPen(option->state & State_Enabled ? edgeOfColours() : option->palette.color(QPalette::Mid));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
}

void OutlineStyle::drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                               const QWidget *widget) const
{
    const auto *bar = qstyleoption_cast<const QStyleOptionToolBar *>(option);
    const auto *entry = qstyleoption_cast<const QStyleOptionMenuItem *>(option);
    const auto *tab = qstyleoption_cast<const QStyleOptionTab *>(option);
    const QRect &area = option->rect;
    if (element == CE_TabBarTabLabel && tab && tab->state & State_HasFocus) { // Fusion would ask itself for the frame.
        QStyleOptionTab label(*tab);
        label.state &= ~State_HasFocus;
        QProxyStyle::drawControl(element, &label, painter, widget);
        return drawFocus(*painter, area.adjusted(3, 3, -3, -3), 2);
    }
    if (isDarkTheme() && element == CE_ToolBar && bar && widget &&
        qobject_cast<QMainWindow *>(widget->parentWidget())) {
        painter->fillRect(area, option->palette.color(QPalette::Window));
        const bool lies = bar->state & State_Horizontal;
        const QRect edge = lies ? QRect(area.left(), area.bottom(), area.width(), 1)
                                : QRect(bar->toolBarArea == Qt::RightToolBarArea ? area.left() : area.right(),
                                        area.top(), 1, area.height());
        painter->fillRect(edge, hairline());
    } else if (isDarkTheme() && element == CE_MenuItem && entry && entry->text.isEmpty() && entry->icon.isNull() &&
               entry->menuItemType == QStyleOptionMenuItem::Separator) {
        constexpr int margin = 5;
        painter->fillRect(QRect(area.left() + margin, area.center().y(), area.width() - 2 * margin, 1), hairline());
    } else {
        QProxyStyle::drawControl(element, option, painter, widget);
    }
}

void OutlineStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                                      const QWidget *widget) const
{
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    const auto *bar = qstyleoption_cast<const QStyleOptionSlider *>(option);
    if (control != CC_ScrollBar || !bar || bar->minimum == bar->maximum)
        return;
    const QRect handle = subControlRect(control, option, SC_ScrollBarSlider, widget);
    const bool isHeld = (option->state & State_MouseOver || option->state & State_Sunken) &&
                        option->activeSubControls & SC_ScrollBarSlider;
    const QColor atRest = isDarkTheme() ? edgeOfColours().lighter(120) : edgeOfColours().darker(115);
    painter->fillRect(handle, isHeld ? option->palette.color(QPalette::Highlight) : atRest);
}

QSize OutlineStyle::sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &contents,
                                     const QWidget *widget) const
{
    constexpr int room = 4; // logical pixels above and below
    const QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const auto *entry = qstyleoption_cast<const QStyleOptionMenuItem *>(option);
    const bool isHeading = type == CT_MenuItem && entry && !entry->text.isEmpty() &&
                           entry->menuItemType == QStyleOptionMenuItem::Separator;
    return isHeading ? size + QSize(0, 2 * room) : size;
}

int OutlineStyle::styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                            QStyleHintReturn *result) const
{
    if (hint == SH_Widget_Animation_Duration && motionIsReduced())
        return 0;
    switch (hint) { // These are the same on every desktop.
    case SH_DialogButtonBox_ButtonsHaveIcons:
    case SH_Menu_Scrollable: // A menu that is taller than the screen scrolls: columns cover what it belongs to.
        return 1;
    default:
        return QProxyStyle::styleHint(hint, option, widget, result);
    }
}

int OutlineStyle::pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const
{
    // The buttons of a dock's title are no higher than its text.
    const bool titleButton = metric == PM_SmallIconSize && widget && widget->inherits("QDockWidgetTitleButton");
    return titleButton ? 12 : QProxyStyle::pixelMetric(metric, option, widget);
}

} // namespace suffuse

#include "app/widgets/habits/help_page.h"

#include <QVariant>
#include <QWidget>

namespace suffuse {

namespace {

constexpr char pageProperty[] = "helpPage";

} // namespace

void setHelpPage(QWidget &widget, const char *page)
{
    widget.setProperty(pageProperty, QString::fromLatin1(page));
}

QString helpPageOf(const QWidget *widget)
{
    for (; widget; widget = widget->parentWidget())
        if (const QString page = widget->property(pageProperty).toString(); !page.isEmpty())
            return page;
    return {};
}

} // namespace suffuse

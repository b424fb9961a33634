// Which page of the manual is about what one works with.
#pragma once

#include <QString>

class QWidget;

namespace suffuse {

/// Says which page of the manual (the name of its file, without ".md") is about the widget and all that is in it.
void setHelpPage(QWidget &widget, const char *page);

/// The page about a widget: that of the nearest one around it which has one, its parents' windows included. Empty where
/// none has.
QString helpPageOf(const QWidget *widget);

} // namespace suffuse

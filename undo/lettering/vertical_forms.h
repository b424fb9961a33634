// Which form a character has in a line from top to bottom. It is a matter of characters alone; fonts are not known
// here.
#pragma once

#include <QStringView>

#include <optional>

namespace suffuse {

/// How a letter stands in a vertical line.
enum class Stand {
    Upright,
    Turned,     ///< by 90°, clockwise
    OtherCorner ///< upright, and what lies in the lower left corner of its square lies in the upper right one
};

/// The character that stands for a letter's form in vertical lines, if Unicode has one (U+FE10 to U+FE19, U+FE30 to
/// U+FE48): for brackets, commas, stops and the like that take up squares. Those that Latin text has, too, dashes and
/// dots, have one where their letter is about as wide as a square; `width` is its advance, ems.
std::optional<QChar> verticalFormOf(QStringView letter, double width);

/// How a letter stands, after Unicode's report 50, as far as it is about letters that stand in squares. Without a form
/// for vertical lines brackets and dashes are turned, as `text-orientation: mixed` of CSS has it, and commas and full
/// stops stand in the other corner.
Stand standOf(QStringView letter, bool hasVerticalForm);

} // namespace suffuse

// The sheets of paper that drawings are put on.
#pragma once

#include <QString>

#include <optional>

namespace suffuse {

/// How large a page is. Drawings fit into it, in its middle.
struct PageSize {
    double width = 0, height = 0; ///< points, 1/72 inch
    bool turns = false;           ///< whether it lies upright or across as the painting's sheet does

    /// The page for a painting that is so wide and high.
    PageSize laidAs(double wide, double high) const;
    friend bool operator==(const PageSize &, const PageSize &) = default;
};

/// A4, A5, A3, Letter, or a size such as "210x297mm" or "8.5x11in". No value for anything else, and for pages that are
/// smaller than a millimetre or larger than 100 metres.
std::optional<PageSize> pageSizeFrom(const QString &text);
/// The page of a painting at its own size. `resolution`: how many units an inch has; 0: a unit is a pixel of which it
/// has 96, as in CSS and SVG.
PageSize ownPage(double wide, double high, double resolution = 0);

} // namespace suffuse

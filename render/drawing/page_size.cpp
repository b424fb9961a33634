#include "render/drawing/page_size.h"

#include "model/painting/resolution.h"

#include <QRegularExpression>

#include <cmath>
#include <utility>

namespace suffuse {

namespace {

constexpr double pointsOfInch = 72, pixelsOfInch = 96;
constexpr double smallest = 1, largest = 100'000; // mm

struct NamedPage {
    const char *name;
    double width, height; // mm
};
constexpr NamedPage namedPages[] = {{"A4", 210, 297}, {"A5", 148, 210}, {"A3", 297, 420}, {"Letter", 215.9, 279.4}};

double points(double millimetres)
{
    return millimetres * pointsOfInch / millimetresOfInch;
}

} // namespace

PageSize PageSize::laidAs(double wide, double high) const
{
    PageSize page = *this;
    if (turns && (wide > high) != (width > height) && wide != high)
        std::swap(page.width, page.height);
    return page;
}

std::optional<PageSize> pageSizeFrom(const QString &text)
{
    for (const NamedPage &page : namedPages)
        if (text.compare(QLatin1String(page.name), Qt::CaseInsensitive) == 0)
            return PageSize{points(page.width), points(page.height), true};
    static const QRegularExpression pattern(QStringLiteral("^([0-9]+(?:\\.[0-9]+)?)x([0-9]+(?:\\.[0-9]+)?)(mm|in)$"),
                                            QRegularExpression::CaseInsensitiveOption);
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch())
        return {};
    const bool isInches = match.captured(3).compare(QLatin1String("in"), Qt::CaseInsensitive) == 0;
    const double unit = isInches ? millimetresOfInch : 1;
    const double width = unit * match.captured(1).toDouble(), height = unit * match.captured(2).toDouble();
    if (!(std::min(width, height) >= smallest && std::max(width, height) <= largest))
        return {};
    return PageSize{points(width), points(height), false};
}

PageSize ownPage(double wide, double high, double resolution)
{
    const double unit = pointsOfInch / (isResolution(resolution) ? resolution : pixelsOfInch);
    return {wide * unit, high * unit, false};
}

} // namespace suffuse

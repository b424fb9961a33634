#include "model/formats/svg/svg_elements.h"

#include "model/formats/svg/svg_length.h"
#include "model/formats/svg/svg_matrix.h"

#include <algorithm>
#include <set>

namespace suffuse {

bool isOnlyDefined(const QString &element)
{
    static const std::set<QString> names{"defs",   "clipPath", "mask",  "pattern", "marker",
                                         "symbol", "metadata", "title", "desc",    "style"};
    return names.contains(element);
}

bool isGroup(const QString &element)
{
    return element == QLatin1String("g") || element == QLatin1String("a") || element == QLatin1String("svg");
}

bool mayHaveMarkers(const QString &element)
{
    return element == QLatin1String("path") || element == QLatin1String("line") ||
           element == QLatin1String("polyline") || element == QLatin1String("polygon");
}

bool isForAll(const SvgElement &element)
{
    const QString extensions = QStringLiteral("requiredExtensions"), languages = QStringLiteral("systemLanguage");
    if (!element.attributes.value(extensions).isEmpty())
        return false;
    if (!element.attributes.hasAttribute(languages))
        return true;
    return std::ranges::any_of(element.attributes.value(languages).toString().split(u','), [](const QString &language) {
        return language.trimmed().section(u'-', 0, 0).compare(QLatin1String("en"), Qt::CaseInsensitive) == 0;
    });
}

Rect viewportOf(const SvgTree &tree)
{
    if (tree.root().children.empty())
        return {};
    const QXmlStreamAttributes &root = tree.root().children.front()->attributes;
    if (const Rect viewBox = svgViewBox(root); !viewBox.isEmpty())
        return viewBox;
    return Rect::of(0, 0, svgLength(root.value(QLatin1String("width")).toString()).value_or(0),
                    svgLength(root.value(QLatin1String("height")).toString()).value_or(0));
}

} // namespace suffuse

// An SVG document as a tree of elements: what refers to what, and which styles apply.
#pragma once

#include "model/formats/svg/css_sheet.h"

#include <QHash>
#include <QXmlStreamReader>

#include <memory>
#include <vector>

namespace suffuse {

struct SvgElement : CssElement {
    QXmlStreamAttributes attributes;
    QString title; ///< of its <title>
    std::vector<std::unique_ptr<SvgElement>> children;
    int index = 0; ///< in the document's order
    /// A <use> of what contains it, directly or by way of others: it would never end.
    bool isCycle = false;

    QString attribute(const char *attributeName) const
    {
        return attributes.value(QLatin1String(attributeName)).toString();
    }
    /// The name that people gave it: Inkscape's label, the title, or Illustrator's name, or else the id. At most 200
    /// characters.
    QString givenName() const;
};

class SvgTree {
public:
    /// Elements deeper than 256 levels, and more than 500,000, are left out. Empty, or what is wrong with the document.
    QString read(QXmlStreamReader &xml);

    /// The document's outermost element is its only child.
    const SvgElement &root() const { return m_root; }
    /// What "#id" stands for, the first of the document; null where there is none.
    const SvgElement *find(QStringView reference) const;
    /// What `href`, or `xlink:href`, of an element refers to.
    const SvgElement *target(const SvgElement &element) const;
    CssSheet &sheet() { return m_sheet; }
    /// Whether elements were left out.
    bool isCut() const { return m_isCut; }

private:
    void take(QXmlStreamReader &xml, SvgElement &parent);
    void markCycles();

    SvgElement m_root;
    std::vector<SvgElement *> m_elements; ///< by index
    QHash<QString, const SvgElement *> m_named;
    CssSheet m_sheet;
    bool m_isCut = false;
};

} // namespace suffuse

// An SVG document as a tree of elements: what refers to what, and which styles apply.
#pragma once

#include "model/formats/svg/css/css_sheet.h"

#include <QHash>
#include <QXmlStreamReader>

#include <memory>
#include <vector>

namespace suffuse {

struct SvgElement : CssElement {
    static constexpr QLatin1String characterData{"#text"};
    QXmlStreamAttributes attributes;
    QString title; ///< the text of its <title>
    /// Characters within a <text> are elements among its children, named characterData; these are their characters.
    QString characters;
    std::vector<std::unique_ptr<SvgElement>> children;
    int index = 0; ///< its place in the order of the document
    /// Whether it is a <use> of something that contains it, directly or through others, which would never end.
    bool isCycle = false;

    QString attribute(const char *attributeName) const
    {
        return attributes.value(QLatin1String(attributeName)).toString();
    }
    /// The name that people gave it: Inkscape's label, the title, or Illustrator's name, or else the id. It has at most
    /// 200 characters.
    QString givenName() const;
};

class SvgTree {
public:
    /// Reads a document. Elements deeper than 256 levels, and more than 500,000, are left out. Returns an empty text,
    /// or what is wrong with the document.
    QString read(QXmlStreamReader &xml);

    /// The root, whose only child is the document's outermost element.
    const SvgElement &root() const { return m_root; }
    /// The element that "#id" names, the first in the document; null if there is none.
    const SvgElement *find(QStringView reference) const;
    /// The element to which `href`, or `xlink:href`, of an element refers; null if there is none.
    const SvgElement *target(const SvgElement &element) const;
    CssSheet &sheet() { return m_sheet; }
    /// Whether elements were left out.
    bool isCut() const { return m_isCut; }

private:
    void take(QXmlStreamReader &xml, SvgElement &parent);
    void takeCharacters(QStringView characters, SvgElement &parent);
    void markCycles();

    SvgElement m_root;
    std::vector<SvgElement *> m_elements; ///< in the order of the document
    QHash<QString, const SvgElement *> m_named;
    CssSheet m_sheet;
    bool m_isCut = false;
};

} // namespace suffuse

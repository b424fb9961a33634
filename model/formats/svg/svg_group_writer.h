// Writes the groups of a painting as those of an SVG drawing.
#pragma once

#include "model/painting/painting.h"

#include <QXmlStreamWriter>

#include <functional>

namespace suffuse {

inline const QString svgNamespace = QStringLiteral("http://www.w3.org/2000/svg");
inline const QString inkscapeNamespace = QStringLiteral("http://www.inkscape.org/namespaces/inkscape");

/// Whether groups are told to Inkscape, as its layers. The document then declares `inkscapeNamespace`.
enum class SvgLayers { No, Inkscape };

/// Writes the beginnings and ends of groups between what is written of strokes: their names as titles, and opacity,
/// mode and isolation as CSS has them.
class SvgGroupWriter {
public:
    SvgGroupWriter(QXmlStreamWriter &xml, const Painting &painting, SvgLayers layers = SvgLayers::No)
        : m_xml(xml), m_painting(painting), m_layers(layers)
    {}

    /// What follows is in this group; 0: in none.
    void goTo(GroupId group);
    /// What is asked when a group begins: the id of the mask that it is seen through, empty if there is none, and which
    /// is called within it, to write that.
    void setMasks(std::function<QString(GroupId)> idOf, std::function<void(GroupId)> write);

private:
    void begin(GroupId id);
    void writeBlending(const Group &group);

    QXmlStreamWriter &m_xml;
    const Painting &m_painting;
    SvgLayers m_layers;
    std::vector<GroupId> m_open; ///< from outside to inside
    std::function<QString(GroupId)> m_maskOf;
    std::function<void(GroupId)> m_writeMask;
};

/// A name without the characters that XML cannot hold.
QString xmlText(const QString &name);

} // namespace suffuse

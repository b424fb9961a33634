#include "model/formats/svg/svg_group_writer.h"

#include "model/formats/svg/css/css_blending.h"

#include <algorithm>

namespace suffuse {

QString xmlText(const QString &name)
{
    QString text;
    for (const uint character : name.toUcs4())
        if (character >= 0x20 ? character != 0xFFFE && character != 0xFFFF && (character < 0xD800 || character > 0xDFFF)
                              : character == '\t' || character == '\n')
            text += QString::fromUcs4(reinterpret_cast<const char32_t *>(&character), 1);
    return text;
}

void SvgGroupWriter::goTo(GroupId group)
{
    std::vector<GroupId> wanted;
    while (group != 0) {
        wanted.insert(wanted.begin(), group);
        const Group *found = m_painting.findGroup(group);
        group = found ? found->parent : 0;
    }
    std::size_t same = 0;
    while (same < m_open.size() && same < wanted.size() && m_open[same] == wanted[same])
        ++same;
    for (; m_open.size() > same; m_open.pop_back())
        m_xml.writeEndElement();
    for (; m_open.size() < wanted.size(); m_open.push_back(wanted[m_open.size()]))
        begin(wanted[m_open.size()]);
}

void SvgGroupWriter::begin(GroupId id)
{
    m_xml.writeStartElement("g");
    const Group *group = m_painting.findGroup(id);
    if (!group)
        return;
    const QString name = xmlText(group->name);
    if (m_layers == SvgLayers::Inkscape) {
        m_xml.writeAttribute(inkscapeNamespace, "groupmode", "layer");
        if (!name.isEmpty())
            m_xml.writeAttribute(inkscapeNamespace, "label", name);
    }
    writeBlending(*group);
    const QString mask = m_maskOf ? m_maskOf(id) : QString();
    if (!mask.isEmpty())
        m_xml.writeAttribute("mask", "url(#" + mask + ')');
    if (!name.isEmpty())
        m_xml.writeTextElement("title", name);
    if (!mask.isEmpty())
        m_writeMask(id);
}

void SvgGroupWriter::setMasks(std::function<QString(GroupId)> idOf, std::function<void(GroupId)> write)
{
    m_maskOf = std::move(idOf), m_writeMask = std::move(write);
}

void SvgGroupWriter::writeBlending(const Group &group)
{
    if (group.opacity < 1)
        m_xml.writeAttribute("opacity", QString::number(double(group.opacity), 'g', 9));
    QStringList style;
    if (const char *mode = cssOf(group.blend); mode && group.blend != BlendMode::Normal)
        style << QLatin1String("mix-blend-mode:") + QLatin1String(mode);
    if (group.isolated)
        style << QStringLiteral("isolation:isolate");
    if (!style.isEmpty())
        m_xml.writeAttribute("style", style.join(u';'));
}

} // namespace suffuse

#include "render/drawing/pdf_resources.h"

namespace suffuse {

int PdfResources::addGroup(const QByteArray &box, const QByteArray &content, const QByteArray &space)
{
    return m_objects.addStream("<< /Type /XObject /Subtype /Form /BBox [" + box + "] /Resources " +
                                   pdf::reference(m_number) + " /Group << /S /Transparency /I true /CS " + space +
                                   " >> >>",
                               content);
}

QByteArray PdfResources::name(const QByteArray &kind, const QByteArray &value)
{
    const auto [known, isNew] = m_kinds[kind].try_emplace(value);
    if (isNew)
        known->second = "/R" + QByteArray::number(++m_named);
    return known->second;
}

void PdfResources::complete()
{
    QByteArray all = "<<";
    for (const auto &[kind, names] : m_kinds) {
        all += " /" + kind + " <<";
        for (const auto &[value, name] : names)
            all += ' ' + name + ' ' + value;
        all += " >>";
    }
    m_objects.set(m_number, all + " >>");
}

} // namespace suffuse

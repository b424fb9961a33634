// What the content of a PDF page refers to by names.
#pragma once

#include "model/formats/pdf/pdf_objects.h"

#include <map>

namespace suffuse {

/// The resources of a page and of all that is on it.
class PdfResources {
public:
    explicit PdfResources(pdf::Objects &objects) : m_objects(objects), m_number(objects.reserve()) {}

    /// The object that holds them once they are complete.
    int number() const { return m_number; }
    /// Names for use in content: a graphics state, an object that is painted, a shading, a layer.
    QByteArray state(const QByteArray &entries) { return name("ExtGState", "<< " + entries + " >>"); }
    QByteArray painted(int object) { return name("XObject", pdf::reference(object)); }
    QByteArray shading(const QByteArray &dictionary) { return name("Shading", dictionary); }
    QByteArray layer(int object) { return name("Properties", pdf::reference(object)); }
    /// Gives a colour space a meaning.
    void setSpace(const QByteArray &space, const QByteArray &value) { m_kinds["ColorSpace"][value] = space; }
    /// What is painted together: a form, with its box and its content, in a colour space. Returns its object.
    int addGroup(const QByteArray &box, const QByteArray &content, const QByteArray &space = "/DeviceRGB");
    void complete();

private:
    QByteArray name(const QByteArray &kind, const QByteArray &value);

    pdf::Objects &m_objects;
    int m_number;
    std::map<QByteArray, std::map<QByteArray, QByteArray>> m_kinds; ///< the names of values, of each kind
    int m_named = 0;
};

} // namespace suffuse

// A drawing becomes a page of a PDF file.
#pragma once

#include "render/drawing/drawing_pdf.h"
#include "render/drawing/pdf_strokes.h"

namespace suffuse {

/// Writes the content of a page, between the beginnings and ends of its groups.
class PdfPageWriter {
public:
    PdfPageWriter(const PdfPage &page, pdf::Objects &objects, const std::atomic<bool> *cancel);

    /// Adds the page, and returns its object. `rgb`: what red, green and blue mean; empty: what the reader takes them
    /// for. It fails if the picture cannot be read, and, without a message, if it was cancelled.
    Result<int> write(const QByteArray &rgb);

    /// The layers in the order in which they are listed, from the topmost on: objects and, in brackets, what is in
    /// them.
    QByteArray layerOrder() const { return orderWithin(0); }
    const std::vector<int> &layers() const { return m_layers; }
    const std::vector<int> &hidden() const { return m_hidden; }

private:
    struct Open {
        const Group *group = nullptr;
        bool isTogether = false; ///< whether its content becomes a form
        QByteArray content;
    };
    Result<void> writeContent();
    Result<void> writeBelow();
    void goTo(GroupId id);
    void begin(const Group &group);
    void end();
    QByteArray together(const QByteArray &inside, QByteArray state, GroupId group);
    QByteArray painted(int form, const QByteArray &state);
    QByteArray layerOf(const Group &group);
    int addLayer(const QString &name);
    QByteArray orderWithin(GroupId parent) const;
    QByteArray &content() { return m_content.back(); }

    const PdfPage &m_page;
    const Painting &m_painting;
    pdf::Objects &m_objects;
    const std::atomic<bool> *m_cancel;
    PdfResources m_resources;
    PdfStrokes m_strokes;
    std::vector<const Group *> m_open; ///< the groups around where it is, from outside to inside
    std::vector<QByteArray> m_content; ///< of the page, and of the open groups that become forms
    std::map<GroupId, int> m_groups;   ///< the layers of groups that have a name
    std::vector<GroupId> m_met;        ///< these groups, from bottom to top
    std::vector<int> m_layers, m_hidden;
    int m_outlines = 0; ///< the layer of unpainted paths
};

} // namespace suffuse

// The strokes of a drawing as the content of a PDF page.
#pragma once

#include "render/drawing/path_drawing.h"
#include "render/drawing/path_text.h"
#include "render/drawing/pdf_resources.h"

namespace suffuse {

/// Writes strokes, in canvas units. The bands of a stroke are a luminosity mask, through which its colour is seen.
class PdfStrokes {
public:
    PdfStrokes(const PathDrawing &drawing, pdf::Objects &objects, PdfResources &resources,
               const std::atomic<bool> *cancel)
        : m_drawing(drawing), m_objects(objects), m_resources(resources), m_cancel(cancel),
          m_text(drawing.painting->canvas)
    {}

    /// The operators that paint a stroke.
    QByteArray of(const DrawnStroke &drawn);

private:
    QByteArray look(const DrawnStroke &drawn, const Rect &box, bool masked);
    QByteArray maskOf(const DrawnStroke &drawn, const Rect &box, bool masked);
    QByteArray shadingOf(const DrawnPaint &paint, bool opacities);
    QByteArray imageOf(const Stroke &stroke);

    const PathDrawing &m_drawing;
    pdf::Objects &m_objects;
    PdfResources &m_resources;
    const std::atomic<bool> *m_cancel;
    PathText m_text;
    std::map<std::tuple<QString, std::uint32_t, std::uint32_t>, int> m_images; ///< 0: cannot be read
};

/// "red green blue", each in [0, 1].
QByteArray pdfColour(const DrawnColour &colour);
/// "left top width height".
QByteArray pdfBox(const Rect &box);
/// The numbers of a transformation.
QByteArray pdfMatrix(const Affine &map);

} // namespace suffuse

// A painting becomes an SVG or a PDF file.
#pragma once

#include "render/drawing/drawing_pdf.h"
#include "render/drawing/drawing_picture.h"

namespace suffuse {

/// A drawing that is ready to be written, and what is to be known of it before.
struct PreparedDrawing {
    PathDrawing drawing;
    QByteArray png; ///< the picture, if paths are unpainted
    DrawingDifference difference;
    std::optional<PageSize> paper = {}; ///< of PDF: what it is printed on; no value: a page as large as the sheet
    double resolution = 0;              ///< of the sheet, units an inch; 0: an inch has 96, as in CSS and SVG
    PdfAbout about = {};                ///< of PDF
};

/// Draws a painting. It fails if the renderer does, or if it was cancelled.
Result<PreparedDrawing> prepareDrawing(const PaintingPtr &painting, const DrawingOptions &options, Renderer &renderer);

/// The file's bytes, with the painting in it; SVG is packed if the ending of `name` is .svgz. It fails if it was
/// cancelled, and if the packed file would be too large to be opened again.
Result<QByteArray> bytesOf(const PreparedDrawing &prepared, const Painting &painting, const QString &name,
                           const std::atomic<bool> *cancel = nullptr);
/// The same of several drawings, which are the pages of one PDF; what is told of it is told of the first.
Result<QByteArray> bytesOf(const std::vector<PreparedDrawing> &prepared, const std::vector<Painting> &paintings,
                           const QString &name, const std::atomic<bool> *cancel = nullptr);
/// Replaces a file by them, or leaves it as it was.
Result<void> saveDrawing(const PreparedDrawing &prepared, const Painting &painting, const QString &path,
                         const std::atomic<bool> *cancel = nullptr);

/// The format by a path's ending: .svg or .svgz, .pdf; none for others.
std::optional<DrawingFormat> drawingFormatFor(const QString &path);

/// What of a painting the drawing has in another way, in sentences for people; empty if there is nothing.
QString leftOutOf(const PreparedDrawing &prepared);
/// "The drawing differs from the picture by at most 3 of 255, by 0.2 on average."
QString differenceText(const DrawingDifference &difference);

} // namespace suffuse

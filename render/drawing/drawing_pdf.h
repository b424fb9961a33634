// Drawings as PDF files.
#pragma once

#include "model/result.h"
#include "render/drawing/page_size.h"
#include "render/drawing/path_drawing.h"

#include <QByteArray>

namespace suffuse {

/// A drawing on a page of its own.
struct PdfPage {
    const PathDrawing &drawing;
    const QByteArray &png;         ///< the picture of the whole sheet, if the drawing is one of unpainted paths
    std::optional<PageSize> paper; ///< no value: as large as the sheet
    QByteArray document;           ///< the painting, which the file has as an attached .suffuse file
};

/// What is told of the file as a whole.
struct PdfAbout {
    QString title;
    QByteArray profile; ///< the ICC profile that the pages are meant for; empty: sRGB
};

/// A PDF file with a page for each drawing. Its groups are transparency groups and layers (optional content). The bands
/// of a stroke are a luminosity mask, through which its colour is seen. Unpainted paths are a layer that is off. Equal
/// drawings give equal bytes. It fails if a module is missing or an image cannot be read, and, without a message, if it
/// was cancelled.
Result<QByteArray> pdfOf(const std::vector<PdfPage> &pages, const PdfAbout &about,
                         const std::atomic<bool> *cancel = nullptr);

} // namespace suffuse

// How a page of the manual is set: sizes and spaces that follow the font, tones that follow the palette.
#pragma once

#include <QSizeF>
#include <QString>

class QFont;
class QPalette;
class QTextDocument;

namespace suffuse {

/// The file of a picture that a page names, by its last part.
QString pictureFile(const QString &name);
/// How large a picture of so many pixels is shown, in logical pixels; no wider than `room`.
QSizeF shownSize(const QSize &pixels, int room);

/// What is left free around a page, logical pixels.
double pageMargin(const QFont &font);

/// Gives a document that was read from Markdown its look. `width` is the room for pictures, in logical pixels: those
/// that are wider are shown that wide.
void setPageLook(QTextDocument &document, const QFont &font, const QPalette &palette, int width);

} // namespace suffuse

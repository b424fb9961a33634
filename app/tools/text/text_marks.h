// What lies over a text: its caret, what is selected of it, its frame.
#pragma once

#include "app/canvas/overlay/overlay.h"

#include <QRectF>

namespace suffuse {

class TextEntry;

/// Draws caret, selection, what an input method composes, and the curve of a text in hand.
void paintTextInHand(QPainter &painter, const View &view, double dpr, const TextEntry &entry, const QColor &accent,
                     bool hasCaret);
/// Draws a frame around a text, whose box is given before its place: lines along all of its letters would hide them.
void paintTextFrame(QPainter &painter, const View &view, double dpr, const Text &text, const Rect &box,
                    const QColor &accent);
/// The device pixels of the caret with what its line takes beside it.
QRectF caretPixels(const TextEntry &entry, const View &view, double dpr);

} // namespace suffuse

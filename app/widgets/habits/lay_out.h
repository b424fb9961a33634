// Layouts take effect when their requests are delivered, later. This does not wait.
#pragma once

class QWidget;

namespace suffuse {

/// Lays out a widget and what is in it, where they have asked for it, and nothing else. Whoever delivers the requests
/// of all widgets instead (QCoreApplication::sendPostedEvents without a receiver) also lays out windows, which crash
/// where they are being laid out and this was called by what they show meanwhile.
void layOutNow(QWidget &widget);

} // namespace suffuse

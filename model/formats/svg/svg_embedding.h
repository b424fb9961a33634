// The painting within an SVG drawing of it, so that what was drawn for others can be opened again as it is.
#pragma once

#include <QByteArray>

#include <optional>

namespace suffuse {

/// The drawing, which ends in </svg>, with a painting's document in a <metadata> at its end.
QByteArray withEmbedded(const QByteArray &svg, const QByteArray &document);

/// The document of the painting that a drawing was made of.
struct EmbeddedDocument {
    QByteArray document;
    /// Whether the drawing is what was written. Otherwise another program has changed it since.
    bool matches = false;
};
/// None if there is none.
std::optional<EmbeddedDocument> embeddedIn(const QByteArray &svg);

} // namespace suffuse

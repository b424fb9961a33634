// The text of an SVG drawing.
#pragma once

#include <QByteArray>

namespace suffuse::test {

/// A drawing of this content whose root element has these attributes.
inline QByteArray svg(const QByteArray &root, const QByteArray &content)
{
    return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " + root + ">" + content + "</svg>";
}

} // namespace suffuse::test

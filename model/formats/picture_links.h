// Pictures whose images are files beside the painting.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <QString>

namespace suffuse {

/// The bytes of the file that a link names, seen from a folder. An error names the file and what to do.
Result<EncodedImage> readLinked(const QString &link, const QString &sha256, const QString &folder);

/// Gives linked pictures that have none their images. Those whose files are missing, or are no longer what was linked,
/// stay without one. Returns a sentence about these for people; empty: there are none.
QString readLinks(Painting &painting, const QString &folder);

/// The same for one stroke, which may be null. A picture that is missing is not told.
void readLink(StrokePtr &stroke, const QString &folder);

/// The painting with links as absolute paths, as they are from a folder.
Painting withAbsoluteLinks(Painting painting, const QString &folder);
/// The painting with links as they are seen from a folder, where the files lie in it or below; the others are absolute.
Painting withRelativeLinks(Painting painting, const QString &folder);

} // namespace suffuse

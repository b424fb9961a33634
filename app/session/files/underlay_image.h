// The picture of an underlay, decoded for the screen.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <QImage>

#include <memory>
#include <vector>

namespace suffuse {

/// Premultiplied pictures. The first level is the picture itself; each further level is half as wide and high as the
/// one before, down to a pixel.
struct UnderlayImage {
    std::vector<QImage> levels;
    QSize size() const { return levels.front().size(); }
};
using UnderlayImagePtr = std::shared_ptr<const UnderlayImage>;

/// Decodes an underlay's picture, or returns it where somebody holds it decoded already. `name` stands in messages. Any
/// thread.
Result<UnderlayImagePtr> decodeUnderlay(const EncodedImage &encoded, const QString &name);

/// The decoded picture, or null where nobody holds it.
UnderlayImagePtr decodedUnderlay(const EncodedImage &encoded);

} // namespace suffuse

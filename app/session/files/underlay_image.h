// The picture of an underlay, decoded for the screen.
#pragma once

#include "model/painting/painting.h"
#include "model/result.h"

#include <QImage>

#include <memory>
#include <vector>

namespace suffuse {

/// Premultiplied; after the picture itself each level is half as wide and high as the one before, down to a pixel.
struct UnderlayImage {
    std::vector<QImage> levels;
    QSize size() const { return levels.front().size(); }
};
using UnderlayImagePtr = std::shared_ptr<const UnderlayImage>;

/// Decodes what an underlay holds, or gives what is decoded already and in use. `name` stands in messages. Any thread.
Result<UnderlayImagePtr> decodeUnderlay(const EncodedImage &encoded, const QString &name);

/// Null where nobody holds it decoded.
UnderlayImagePtr decodedUnderlay(const EncodedImage &encoded);

} // namespace suffuse

#pragma once

#include "render/image_io/image_io.h"

namespace suffuse {

/// The ICC profile that an image file brings, which says what its numbers mean as colours; empty if it brings none, or
/// if the profile is broken off or has more than 16 MB. Whether it is a profile at all is not looked at. EXR files have
/// none.
QByteArray embeddedProfile(const QByteArray &bytes, ImageFormat format);

} // namespace suffuse

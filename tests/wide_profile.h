// A colour profile that is not sRGB: Adobe's primaries with gamma 2.2.
#pragma once

#include "render/image_io/embedded_profile.h"
#include "tests/files.h"

namespace suffuse::test {

/// Taken from a picture of the fuzzers' seeds; empty if it is missing.
inline QByteArray wideProfile()
{
    QFile file(QStringLiteral(SUFFUSE_SOURCE_DIR "/tests/fuzz/seeds/image/profile.png"));
    return file.open(QIODevice::ReadOnly) ? embeddedProfile(file.readAll(), ImageFormat::Png) : QByteArray();
}

} // namespace suffuse::test

// PNG files of the plainest kind, read without a module.
#pragma once

#include "render/target.h"

#include <QByteArray>

#include <optional>

namespace suffuse {

/// Reads a PNG with 8 bits a channel, of grey, RGB or RGBA, whose rows lie one below the other, as straight RGBA in
/// [0, 1]. The module that `readImage` needs takes longer to load than a thumbnail may take in all. No value for other
/// PNG files, for damaged ones, for those that have more than `mostSide` pixels a side, and for those that name a
/// colour profile.
std::optional<FloatPicture> readPlainPng(const QByteArray &bytes, int mostSide);

} // namespace suffuse

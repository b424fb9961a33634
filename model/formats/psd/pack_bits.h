// PackBits, the packing of rows in Photoshop and TIFF files.
#pragma once

#include <QByteArray>

#include <cstdint>

namespace suffuse {

/// Appends a row in packed form: runs of one byte as its count and the byte, other bytes behind their count. It grows
/// by at most 1/128.
void packBits(const std::uint8_t *row, std::size_t bytes, QByteArray &out);

/// Unpacks a row of so many bytes. Returns false if the packed bytes are not exactly such a row.
bool unpackBits(const std::uint8_t *packed, std::size_t size, std::uint8_t *row, std::size_t bytes);

} // namespace suffuse

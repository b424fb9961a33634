// Bounds what streams of PDF files unpack to: a small file may claim to hold gigabytes, and libqpdf unpacks what it
// needs of the file's structure into memory.
#pragma once

#include <cstddef>

namespace suffuse {

/// While it lives, no stream that this thread reads unpacks to more bytes; libqpdf gives up then.
class UnpackedBound {
public:
    explicit UnpackedBound(std::size_t most);
    ~UnpackedBound();
    UnpackedBound(const UnpackedBound &) = delete;
    UnpackedBound &operator=(const UnpackedBound &) = delete;
};

} // namespace suffuse

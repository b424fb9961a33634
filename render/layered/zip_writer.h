// Writes the parts of a zip file one after another.
#pragma once

#include "render/image_io/file_replacement.h"

#include <memory>

namespace suffuse {

/// Writes into a file that replaces another one. Nothing is there before `finish`, and the file's own `commit`.
class ZipWriter {
public:
    explicit ZipWriter(FileReplacement &file);
    ~ZipWriter();
    ZipWriter(const ZipWriter &) = delete;
    ZipWriter &operator=(const ZipWriter &) = delete;

    /// Adds a part. What is compressed already (PNG) is stored as it is.
    Result<void> add(const QString &name, const QByteArray &bytes, bool compress);
    /// Ends the file; nothing may be added then.
    Result<void> finish();

private:
    struct Access;

    QString problem() const;

    std::unique_ptr<Access> m_access;
};

} // namespace suffuse

// Reads the parts of a zip file that is in memory.
#pragma once

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>

namespace suffuse {

class ZipParts {
public:
    explicit ZipParts(QByteArray bytes);
    ~ZipParts();
    ZipParts(const ZipParts &) = delete;
    ZipParts &operator=(const ZipParts &) = delete;

    /// Whether the bytes are a zip file with a list of its parts.
    bool isOpen() const;
    /// The content of a part; no value if it is not there, is not whole, or has more than `most` bytes.
    std::optional<QByteArray> part(const QString &name, qint64 most) const;

private:
    struct Memory;
    std::unique_ptr<Memory> m_memory;
    void *m_zip = nullptr; ///< minizip's handle
};

} // namespace suffuse

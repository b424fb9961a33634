#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <cstdint>

namespace suffuse {

/// A file that is written beside its target and takes its place in `commit`; destroyed before that, it is removed and
/// the target is as it was. Random access, since some image formats fill in tables at the end.
class FileReplacement {
public:
    explicit FileReplacement(const QString &target);
    ~FileReplacement();
    FileReplacement(const FileReplacement &) = delete;
    FileReplacement &operator=(const FileReplacement &) = delete;

    /// Creates the temporary file. Fails, with file and remedy, where the target cannot be replaced: the folder is
    /// missing or closed, the target is read-only or not a plain file.
    Result<void> open();
    /// Bytes written, all or fewer; the first failure is remembered for `commit`.
    std::size_t write(const void *from, std::size_t bytes, std::int64_t offset);
    std::size_t read(void *to, std::size_t bytes, std::int64_t offset) const;
    std::int64_t size() const;
    /// The message of the first failed write; empty if there is none.
    QString problem() const;
    /// To disk and into place: file and folder are synced.
    Result<void> commit();

private:
    QString reason(int code) const;
    void discard();

    QString m_shown;     ///< as the user named it
    QByteArray m_target; ///< links followed
    QByteArray m_folder;
    QByteArray m_temporary;
    int m_file = -1;
    int m_error = 0;
};

} // namespace suffuse

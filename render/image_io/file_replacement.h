#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <cstdint>

namespace suffuse {

/// A file that is written beside its target, and replaces it in `commit`. If it is destroyed before that, it is removed
/// and the target is as it was. It allows random access, since some image formats fill in tables at the end.
class FileReplacement {
public:
    explicit FileReplacement(const QString &target);
    ~FileReplacement();
    FileReplacement(const FileReplacement &) = delete;
    FileReplacement &operator=(const FileReplacement &) = delete;

    /// Creates the temporary file. It fails, with file and remedy, if the target cannot be replaced: if the folder is
    /// missing or closed, or if the target is read-only or not a plain file.
    Result<void> open();
    /// Returns the number of bytes that were written, which may be fewer than given. The first failure is remembered
    /// for `commit`.
    std::size_t write(const void *from, std::size_t bytes, std::int64_t offset);
    std::size_t read(void *to, std::size_t bytes, std::int64_t offset) const;
    std::int64_t size() const;
    /// The message of the first failed write; empty if none has failed.
    QString problem() const;
    /// Brings the file to disk and into its place. File and folder are synced.
    /// With `toDisk` false it is left to the system when they come to disk: whoever writes many files knows another way to
    /// tell whether they are whole.
    Result<void> commit(bool toDisk = true);
    /// What an error of the system means for a file, and what to do.
    static QString reason(const QString &shown, int code);

private:
    QString reason(int code) const { return reason(m_shown, code); }
    void discard();

    QString m_shown;     ///< the name that the user gave
    QByteArray m_target; ///< the target after following links
    QByteArray m_folder;
    QByteArray m_temporary;
    int m_file = -1;
    int m_error = 0;
};

} // namespace suffuse

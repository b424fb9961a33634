#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <memory>

namespace suffuse {

/// A journal on disk, which is locked while this object lives. The system drops the lock of a program that dies,
/// however it dies. So a journal that can be locked has been abandoned.
class JournalFile {
public:
    /// Creates an empty journal that only its owner may read. The folder is made if it is missing.
    static Result<std::unique_ptr<JournalFile>> create(const QString &path);
    /// Opens an abandoned journal. Returns null if a program is still writing it, or if it no longer exists.
    static std::unique_ptr<JournalFile> openAbandoned(const QString &path);
    ~JournalFile();
    JournalFile(const JournalFile &) = delete;
    JournalFile &operator=(const JournalFile &) = delete;

    const QString &path() const { return m_path; }
    qint64 size() const { return m_size; }
    QByteArray readAll() const;
    /// Appends bytes, which are on disk when it returns. If it fails, the file counts as long as it was before, and the
    /// call can be repeated.
    Result<void> append(const QByteArray &bytes);
    /// Takes the name of another journal and replaces it. This is on disk when it returns.
    Result<void> renameTo(const QString &path);
    void remove();

private:
    JournalFile(QString path, int file, qint64 size) : m_path(std::move(path)), m_file(file), m_size(size) {}

    QString m_path;
    int m_file;
    qint64 m_size;
};

} // namespace suffuse

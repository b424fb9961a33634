#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <memory>

namespace suffuse {

/// A journal on disk, locked while this lives. The system drops the lock of a program that dies, however it dies, so a
/// journal that can be locked has been abandoned.
class JournalFile {
public:
    /// A new, empty one that only its owner may read. The folder is made where it is missing.
    static Result<std::unique_ptr<JournalFile>> create(const QString &path);
    /// Null where some program still writes it, or it is gone.
    static std::unique_ptr<JournalFile> openAbandoned(const QString &path);
    ~JournalFile();
    JournalFile(const JournalFile &) = delete;
    JournalFile &operator=(const JournalFile &) = delete;

    const QString &path() const { return m_path; }
    qint64 size() const { return m_size; }
    QByteArray readAll() const;
    /// On disk when it returns. Where it fails the file counts as long as it was, and can be tried again.
    Result<void> append(const QByteArray &bytes);
    /// Takes another's place, on disk when it returns.
    Result<void> renameTo(const QString &path);
    void remove();

private:
    JournalFile(QString path, int file, qint64 size) : m_path(std::move(path)), m_file(file), m_size(size) {}

    QString m_path;
    int m_file;
    qint64 m_size;
};

} // namespace suffuse

#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <thread>

namespace suffuse {

/// Notices that another program changed a file or took it away. By its content, not its time: a copy of the same bytes
/// is no change.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject *parent = nullptr);
    ~FileWatch() override;

    /// The file, and the SHA-256 of what it holds; an empty path: none.
    void watch(const QString &path, const QByteArray &hash);

signals:
    void changed(const QByteArray &hash); ///< it has another content
    void removed();

private:
    void look();
    void compare(const QString &path, const QByteArray &hash);
    void follow();

    QFileSystemWatcher m_watcher;
    QTimer m_pause; ///< another program may take a moment to write
    QString m_path;
    QByteArray m_hash;
    bool m_wasThere = false;
    std::jthread m_hashing;
};

} // namespace suffuse

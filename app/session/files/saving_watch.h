#pragma once

#include <QByteArray>
#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>

#include <thread>

namespace suffuse {

/// Notices that another program changed a file or took it away. It compares the content and not the time: a copy of the
/// same bytes is no change.
class FileWatch : public QObject {
    Q_OBJECT

public:
    explicit FileWatch(QObject *parent = nullptr);
    ~FileWatch() override;

    /// Watches a file, whose content has this SHA-256. An empty path: watches none.
    void watch(const QString &path, const QByteArray &hash);

signals:
    void changed(const QByteArray &hash); ///< the file has another content, with this hash
    void removed();

private:
    void look();
    void compare(const QString &path, const QByteArray &hash);
    void follow();

    QFileSystemWatcher m_watcher;
    QTimer m_pause; ///< waits a moment, since the other program may still be writing
    QString m_path;
    QByteArray m_hash;
    bool m_wasThere = false;
    std::jthread m_hashing;
};

} // namespace suffuse

#include "app/session/files/saving_watch.h"

#include "model/formats/atomic_save.h"

#include <QFileInfo>

namespace suffuse {

namespace {

constexpr int pauseMs = 300;

} // namespace

FileWatch::FileWatch(QObject *parent) : QObject(parent)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(pauseMs);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_pause, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_pause, qOverload<>(&QTimer::start));
    connect(&m_pause, &QTimer::timeout, this, &FileWatch::look);
}

FileWatch::~FileWatch() = default;

void FileWatch::watch(const QString &path, const QByteArray &hash)
{
    if (const QStringList before = m_watcher.files() + m_watcher.directories(); !before.isEmpty())
        m_watcher.removePaths(before);
    m_pause.stop();
    m_path = path;
    m_hash = hash;
    m_wasThere = QFileInfo::exists(path);
    follow();
}

/// Names the file to the watcher again, since a file that was replaced is another one to it. The folder is watched,
/// too: it tells when the file comes back.
void FileWatch::follow()
{
    if (m_path.isEmpty())
        return;
    const QFileInfo info(m_path);
    if (info.exists() && !m_watcher.files().contains(m_path))
        m_watcher.addPath(m_path);
    if (const QString folder = info.absolutePath(); !m_watcher.directories().contains(folder))
        m_watcher.addPath(folder);
}

void FileWatch::look()
{
    follow();
    const bool isThere = QFileInfo::exists(m_path);
    if (m_wasThere && !isThere)
        emit removed();
    m_wasThere = isThere;
    if (!isThere)
        return;
    m_hashing = std::jthread([this, path = m_path] { // assigning waits for the thread before
        if (const auto hash = hashOfFile(path))
            QMetaObject::invokeMethod(
                this, [this, path, hash] { compare(path, *hash); }, Qt::QueuedConnection);
    });
}

void FileWatch::compare(const QString &path, const QByteArray &hash)
{
    if (path != m_path || hash == m_hash)
        return;
    m_hash = hash; // a change is told once
    emit changed(hash);
}

} // namespace suffuse

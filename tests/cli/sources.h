// The sources of the program, for tests of how they are built.
#pragma once

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QString>

#include <functional>

/// Calls `use` with the path below the root, and the text, of every source; returns how many there are.
inline int forEachSource(const std::function<void(const QString &path, const QString &text)> &use)
{
    const QDir root(SUFFUSE_SOURCE_DIR);
    int files = 0;
    for (const char *folder : {"model", "undo", "render", "app"}) {
        QDirIterator it(root.filePath(folder), {"*.h", "*.cpp", "*.cu", "*.cuh"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            if (!file.open(QIODevice::ReadOnly))
                qFatal("%s cannot be read", qPrintable(file.fileName()));
            use(root.relativeFilePath(file.fileName()), QString::fromUtf8(file.readAll()));
            ++files;
        }
    }
    return files;
}

// What a program of others may do while it runs, and how it is ended with all that it started.
#pragma once

#include "app/extensions/extension.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <functional>

namespace suffuse {

/// How programs are confined here: by bubblewrap where it works, otherwise by limits alone.
struct Confinement {
    QString bubblewrap; ///< the program; empty: none that works
    QString why;        ///< a sentence about it, for people
};
/// Tried once, since a system may have the program and forbid what it needs.
const Confinement &confinement();

/// Where a program works.
struct WorkFolders {
    QStringList read; ///< what is handed to it: folders and files, wherever they lie
    QString write;    ///< the only folder in which it may write
};

/// The command as it is started: within bubblewrap, where that works, with all files to be read, those of `folders` to
/// be written, and neither network nor other processes; or as it is.
QStringList confined(const QStringList &command, const WorkFolders &folders, bool network);

/// To be called in the process that becomes the program: a group of its own, and the limits of the kernel. It does
/// nothing that is forbidden between fork and exec.
std::function<void()> limitsModifier(const ExtensionLimits &limits);

/// What a program and all that it started use together. They are known by a mark in their environment, which children
/// inherit, whatever groups and sessions they make.
class ProcessTree {
public:
    /// `mark`: "NAME=value" with a value that nobody else has.
    explicit ProcessTree(QByteArray mark) : m_mark(std::move(mark)) {}

    struct Use {
        qint64 memory = 0;  ///< bytes
        qint64 written = 0; ///< bytes that went to disks, by those that still run
    };
    Use use() const;
    /// Ends all of it, whatever it does against that. `leader` is the first process, or 0 where it has ended.
    void end(qint64 leader) const;

private:
    std::vector<int> processes() const;

    QByteArray m_mark;
};

/// The bytes of all files in a folder, as much as they take on disk at least; more than `enough` is not counted.
qint64 bytesWithin(const QString &folder, qint64 enough);

} // namespace suffuse

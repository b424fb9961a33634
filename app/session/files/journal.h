#pragma once

#include "model/journal/journal_writer.h"

#include <QObject>

namespace suffuse {

class Editor;

/// Keeps an editor's document recoverable: hands every finished edit to the document's own journal.
class Journal : public QObject {
    Q_OBJECT

public:
    /// The folder in which all windows keep their journals from now on. Empty, as at first: they keep none.
    static void setFolder(const QString &folder);
    static const QString &folder();

    /// Follows the editor from its present state on, if there is a folder.
    explicit Journal(Editor &editor, QObject *parent = nullptr);
    ~Journal() override;

    /// The next document that the editor opens comes from this journal of an earlier run. The old journal is removed
    /// when the new one is on disk.
    void replaceNext(std::shared_ptr<JournalFile> old) { m_replaced = std::move(old); }
    /// Removes the journal: the document was closed without a crash.
    void remove();
    /// Waits until all that was handed over is on disk.
    void flush();

signals:
    /// The n-th edit that was handed over is on disk, with all before it. Emitted on the writer's thread.
    void written(quint64 n);
    /// The journal cannot be written: edits from now on would not survive a crash. Emitted once, on the editor's
    /// thread.
    void failed(const QString &message);

private:
    void begin();
    void record(bool modified);

    Editor &m_editor;
    std::shared_ptr<JournalFile> m_replaced;
    bool m_modified = false;                 ///< the modified state that was recorded last
    std::unique_ptr<JournalWriter> m_writer; ///< null where there is no folder
};

} // namespace suffuse

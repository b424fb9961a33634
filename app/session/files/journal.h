#pragma once

#include "model/journal/journal_writer.h"

#include <QObject>

namespace suffuse {

class Editor;

/// Keeps an editor's document recoverable: hands every finished edit to the journal of its own.
class Journal : public QObject {
    Q_OBJECT

public:
    /// Where all windows keep their journals from now on; empty, as at first: nowhere.
    static void setFolder(const QString &folder);
    static const QString &folder();

    /// Follows the editor from its present state on, if there is a folder.
    explicit Journal(Editor &editor, QObject *parent = nullptr);
    ~Journal() override;

    /// The next document that the editor opens has this journal of an earlier run; it goes when the new one is on disk.
    void replaceNext(std::shared_ptr<JournalFile> old) { m_replaced = std::move(old); }
    /// The document was closed in peace.
    void remove();
    /// Waits until what was done is on disk.
    void flush();

signals:
    /// An edit, the n-th that was handed over, is on disk with all before it. On the writer's thread.
    void written(quint64 n);
    /// Once: what is done from now on would not survive a crash. On the editor's thread.
    void failed(const QString &message);

private:
    void begin();
    void record(bool modified);

    Editor &m_editor;
    std::shared_ptr<JournalFile> m_replaced;
    bool m_modified = false;                 ///< as it was told last
    std::unique_ptr<JournalWriter> m_writer; ///< null: no folder
};

} // namespace suffuse

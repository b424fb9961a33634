#include "app/session/files/journal.h"

#include "app/session/editor.h"

namespace suffuse {

namespace {

QString &journals()
{
    static QString folder;
    return folder;
}

JournalHead headOf(const Editor &editor)
{
    const QString &path = editor.filePath();
    return {editor.ownName(), path.isEmpty() ? editor.suggestedPath() : path, editor.fileHash(),
            editor.extras().resolution};
}

} // namespace

void Journal::setFolder(const QString &folder)
{
    journals() = folder;
}

const QString &Journal::folder()
{
    return journals();
}

Journal::Journal(Editor &editor, QObject *parent) : QObject(parent), m_editor(editor)
{
    if (folder().isEmpty())
        return;
    m_writer = std::make_unique<JournalWriter>(
        folder(), JournalWriter::Reports{[this](quint64 serial) { emit written(serial); },
                                         [this](const QString &message) {
                                             QMetaObject::invokeMethod(
                                                 this, [this, message] { emit failed(message); }, Qt::QueuedConnection);
                                         }});
    begin();
    connect(&editor, &Editor::opened, this, &Journal::begin);
    // In the middle of an edit the stack may say that all is saved; there is something new all the same.
    connect(&editor, &Editor::edited, this, [this] { record(true); });
    connect(&editor, &Editor::fileChanged, this, [this] {
        if (m_editor.isModified() != m_modified)
            record(m_editor.isModified());
    });
    connect(&editor, &Editor::saved, this, [this](const SaveOutcome &outcome) {
        if (!outcome.isSaved() || outcome.isCopy)
            return;
        m_modified = m_editor.isModified();
        m_writer->saved(headOf(m_editor), m_modified);
    });
}

Journal::~Journal() = default;

void Journal::begin()
{
    m_modified = m_editor.isModified();
    m_writer->begin(headOf(m_editor), m_editor.document().painting(), m_modified, std::move(m_replaced));
    m_replaced.reset();
}

void Journal::record(bool modified)
{
    m_modified = modified;
    m_writer->record(m_editor.document().painting(), modified);
}

void Journal::remove()
{
    if (m_writer)
        m_writer->remove();
}

void Journal::flush()
{
    if (m_writer)
        m_writer->flush();
}

} // namespace suffuse

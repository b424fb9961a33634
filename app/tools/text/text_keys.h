// What keys do in a text.
#pragma once

#include <QtGlobal>

#include <optional>

class QKeyEvent;

namespace suffuse {

class TextEntry;

/// Types, deletes and moves the caret of a text in hand by keys, as text fields do.
class TextKeys {
public:
    explicit TextKeys(TextEntry &entry) : m_entry(entry) {}

    /// Whether a key means the open text, even where it is the shortcut of a command.
    bool areMeant(const QKeyEvent &event) const;
    /// Does what such a key means. Returns false if it is nothing by itself.
    bool take(QKeyEvent &event);
    /// The caret was moved by other means.
    void forgetColumn() { m_column.reset(); }

private:
    bool moveCaret(QKeyEvent &event);
    bool doEditing(QKeyEvent &event);
    qsizetype placeBeside(int dx, int dy);

    TextEntry &m_entry;
    std::optional<double> m_column; ///< along the line, where the caret is kept from line to line
};

} // namespace suffuse

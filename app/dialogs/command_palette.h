// Finds a command, a brush, a dock or a file by a part of its name, and runs it.
#pragma once

#include <QDialog>
#include <QIcon>

#include <functional>
#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;

namespace suffuse {

/// What can be found.
struct PaletteEntry {
    QString title;       ///< with what it belongs to, apart by " ▸ "
    QString id;          ///< its name in English, which is searched, too; may be empty
    QString keys;        ///< as people read them; may be empty
    QIcon icon;          ///< may be null
    bool enabled = true; ///< otherwise it is shown and not run
    std::function<void()> run;
};

/// How well an entry answers to what is typed: 0 best; nothing: not at all. Each word of it must be somewhere in the
/// title or the id, as a part of it or, in the title's last part, with letters left out.
std::optional<int> paletteRank(const PaletteEntry &entry, const QString &typed);

class CommandPalette : public QDialog {
    Q_OBJECT

public:
    CommandPalette(std::vector<PaletteEntry> entries, QWidget *parent);

    /// Shows the palette over a widget, and runs what is chosen when it has gone.
    static void ask(std::vector<PaletteEntry> entries, QWidget &over);

    QLineEdit *search() const { return m_search; }
    QListWidget *list() const { return m_list; }
    /// What was chosen; null: nothing.
    const PaletteEntry *chosen() const { return m_chosen; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill();
    void choose();
    const PaletteEntry *current() const;

    std::vector<PaletteEntry> m_entries;
    const PaletteEntry *m_chosen = nullptr;
    QLineEdit *m_search = nullptr;
    QListWidget *m_list = nullptr;
    QLabel *m_nothing = nullptr;
};

} // namespace suffuse

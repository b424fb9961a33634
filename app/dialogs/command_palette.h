// The command palette: finds a command, a brush, a dock or a file by a part of its name, and runs it.
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

/// An entry of the palette.
struct PaletteEntry {
    QString title;       ///< title with the menu or dock that it belongs to before it, separated by " ▸ "
    QString id;          ///< name in English, which is searched, too; may be empty
    QString keys;        ///< keys as people read them; may be empty
    QIcon icon;          ///< may be null
    bool enabled = true; ///< an entry that is not enabled is shown, but not run
    std::function<void()> run;
    QString whyNot = {}; ///< where it is not enabled, why; may be empty
};

/// How well an entry matches the typed text: 0 is best, and nothing means not at all. Each word of the text must stand
/// somewhere in the title or the id, as a part of it or, in the title's last part, with letters left out.
std::optional<int> paletteRank(const PaletteEntry &entry, const QString &typed);

class CommandPalette : public QDialog {
    Q_OBJECT

public:
    CommandPalette(std::vector<PaletteEntry> entries, QWidget *parent);

    /// Shows the palette over a widget, and runs the chosen entry when the palette has gone.
    static void ask(std::vector<PaletteEntry> entries, QWidget &over);

    QLineEdit *search() const { return m_search; }
    QListWidget *list() const { return m_list; }
    /// The chosen entry; null: none.
    const PaletteEntry *chosen() const { return m_chosen; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void fill();
    void choose();
    void showState();
    const PaletteEntry *current() const;

    std::vector<PaletteEntry> m_entries;
    const PaletteEntry *m_chosen = nullptr;
    QLineEdit *m_search = nullptr;
    QListWidget *m_list = nullptr;
    QLabel *m_nothing = nullptr;
    QLabel *m_state = nullptr; ///< says that what is marked cannot be used now
};

} // namespace suffuse

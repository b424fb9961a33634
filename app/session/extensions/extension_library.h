// The extensions of the program that runs: which there are, which are wanted, and what was chosen for each.
#pragma once

#include "app/extensions/extension_run.h"
#include "app/extensions/found_extensions.h"

#include <QObject>

namespace suffuse {

class Editor;

/// All windows share it.
class ExtensionLibrary : public QObject {
    Q_OBJECT

public:
    static ExtensionLibrary &instance();

    /// Those that there are, by their names in the language in use. They are read when they are asked for first.
    const std::vector<FoundExtension> &found();
    /// Reads them anew.
    void reload();
    /// Of those that can be used and are enabled, the one with an id; null where there is none.
    const Extension *usable(const QString &id);

    /// Those that are not enabled are in no menu.
    bool isEnabled(const QString &id) const;
    void setEnabled(const QString &id, bool enabled);

    /// What was chosen last; where that is not valid any more, or nothing was chosen, what is usual. Where files go is
    /// not kept.
    QJsonObject valuesOf(const Extension &extension) const;
    void keepValues(const Extension &extension, const QJsonObject &values);

    /// The id of the one that was run last; empty: none yet.
    QString last() const { return m_last; }
    /// How the last run of an extension since the program was started went, for people; empty: there was none.
    QString lastRun(const QString &id) const;
    void noteRun(const Extension &extension, const ExtensionOutcome &outcome);

signals:
    /// There are others, or others are enabled.
    void changed();

private:
    bool m_isRead = false;
    QString m_language; ///< in which they were sorted
    std::vector<FoundExtension> m_found;
    QString m_last;
    std::map<QString, QString> m_runs;
};

/// What an extension gets of a painting that is open, with what is selected there.
ExtensionOrder extensionOrder(Editor &editor, const Extension &extension, const QJsonObject &values);
/// Makes what came back of it the painting, as one step named after the extension. Returns false, and changes nothing,
/// where the painting is another one than that of which it was made.
bool applyExtension(Editor &editor, const ExtensionOrder &order, const ExtensionOutcome &outcome);

} // namespace suffuse

// Asks what an extension needs to know, and runs it.
#pragma once

#include "app/dialogs/extensions/extension_job.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace suffuse {

class Editor;
class ExtensionFields;
class HintLabel;

/// Has the fields that the manifest names, with the values that were chosen last. While the program runs it shows how
/// far it is; nothing else can be done in the window meanwhile, so that what comes back is a result of what is there.
/// It becomes one step. The first Cancel stops the program; what went wrong is said, and the dialog stays.
class ExtensionDialog : public QDialog {
    Q_OBJECT

public:
    ExtensionDialog(Editor &editor, const Extension &extension, QWidget *parent);
    ~ExtensionDialog() override;

    ExtensionFields &fields() const { return *m_fields; }
    HintLabel *hint() const { return m_hint; }
    QPushButton *runButton() const { return m_run; }
    QProgressBar *progress() const { return m_progress; }
    bool isRunning() const { return m_job.isRunning(); }
    /// What the program said about its result; may be empty.
    const QString &said() const { return m_said; }

    /// Runs the program with what the fields have.
    void run();
    void reject() override;

private:
    bool mayReplaceFiles(const QJsonObject &values);
    void setBusy(bool busy);
    void showProgress(double share, const QString &what);
    void take(const ExtensionOutcome &outcome);

    Editor &m_editor;
    const Extension m_extension;
    ExtensionJob m_job;
    ExtensionFields *m_fields = nullptr;
    QProgressBar *m_progress = nullptr;
    QLabel *m_doing = nullptr;
    HintLabel *m_hint = nullptr;
    QPushButton *m_run = nullptr;
    QPushButton *m_cancel = nullptr;
    QString m_said;
};

} // namespace suffuse

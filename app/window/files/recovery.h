// What a start offers after a crash.
#pragma once

#include "model/journal/recovery.h"

#include <QDialog>

#include <thread>

class QPushButton;
class QTreeWidget;

namespace suffuse {

class MainWindow;

/// Lists documents of programs that never closed them, each with its picture, and asks what is to become of them. What
/// is neither chosen nor discarded is offered again at the next start.
class RecoveryDialog : public QDialog {
    Q_OBJECT

public:
    explicit RecoveryDialog(std::vector<LostDocument> documents, QWidget *parent = nullptr);
    ~RecoveryDialog() override;

    /// After `Accepted`: what is to be opened.
    std::vector<LostDocument> takeSelected();

    QTreeWidget *list() const { return m_list; }
    QPushButton *recoverButton() const { return m_recover; }
    QPushButton *discardButton() const { return m_discard; }
    QPushButton *laterButton() const { return m_later; }

private:
    void fillList();
    void startPreviews();
    void discardSelected();
    void showPreview(const QString &id, const QImage &image);

    std::vector<LostDocument> m_documents; ///< in the list's order
    QTreeWidget *m_list = nullptr;
    QPushButton *m_recover = nullptr;
    QPushButton *m_discard = nullptr;
    QPushButton *m_later = nullptr;
    std::jthread m_previews;
};

/// Tidies the journals and asks about what is left of lost documents; those that are wanted open in `window`, if it is
/// untouched, and windows of their own.
void offerRecovery(MainWindow &window, const QString &folder);

} // namespace suffuse

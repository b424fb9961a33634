#pragma once

#include "app/session/commands/keys.h"

#include <QDialog>
#include <QList>

#include <map>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
class QVBoxLayout;

namespace suffuse {

/// Edits the shortcuts of actions, and says where which of them work; what several actions would share is marked and
/// cannot be kept.
class ShortcutsDialog : public QDialog {
    Q_OBJECT

public:
    /// `fixed` keys are shown below the actions, take part in clashes, and stay as they are.
    explicit ShortcutsDialog(const QList<QAction *> &actions, const QList<FixedKeys> &fixed = {},
                             QWidget *parent = nullptr);

    QTreeWidget *list() const { return m_list; }
    QKeySequenceEdit *editor() const { return m_edit; }
    QLabel *conflict() const { return m_conflict; }

    void accept() override;

private:
    void addList(QVBoxLayout &column);
    void addEditor(QVBoxLayout &column);
    QTreeWidgetItem *itemOf(QAction *action) const;
    QAction *currentAction() const;
    void fill(const QList<QAction *> &actions);
    void fillFixed(const QIcon &blank);
    void showCurrent();
    void takeSequence(const QKeySequence &sequence);
    void reset(QAction *action);
    /// Takes the current command's shortcuts from all others.
    void takeOver();
    /// Refreshes texts and clashes.
    void refresh();
    /// Shows the rows that the search finds.
    void filter();

    QTreeWidget *m_list = nullptr;
    QLineEdit *m_search = nullptr;
    QKeySequenceEdit *m_edit = nullptr;
    QPushButton *m_clear = nullptr;
    QPushButton *m_resetOne = nullptr;
    QPushButton *m_takeOver = nullptr;
    QPushButton *m_ok = nullptr;
    QLabel *m_conflict = nullptr;
    QList<QAction *> m_actions; ///< the actions of the rows; the rows below them are fixed keys
    QList<FixedKeys> m_fixed;
    std::map<QAction *, QList<QKeySequence>> m_chosen;
};

} // namespace suffuse

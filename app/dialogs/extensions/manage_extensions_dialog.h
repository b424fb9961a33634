// Which extensions there are, which are wanted, and what is wrong with the others.
#pragma once

#include <QDialog>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace suffuse {

class ManageExtensionsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ManageExtensionsDialog(QWidget *parent);

    QTreeWidget *list() const { return m_list; }
    /// All about the one that is chosen: what it does, what is wrong with its manifest, how it ran last.
    QPlainTextEdit *details() const { return m_details; }
    QPushButton *folderButton() const { return m_folder; }

    /// Reads all manifests anew.
    void readAgain();

private:
    void fill();
    void showDetails();
    void takeCheck(QTreeWidgetItem *item);
    void openFolder();

    QTreeWidget *m_list;
    QPlainTextEdit *m_details;
    QPushButton *m_folder = nullptr;
    bool m_isFilling = false;
};

} // namespace suffuse

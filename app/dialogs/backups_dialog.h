#pragma once

#include <QDialog>

#include <thread>

class QPushButton;
class QTreeWidget;

namespace suffuse {

/// Lists the backups of a painting, each with its picture, and asks which one is to be restored.
class BackupsDialog : public QDialog {
    Q_OBJECT

public:
    /// `painting` is the file whose backups are listed.
    explicit BackupsDialog(const QString &painting, QWidget *parent = nullptr);
    ~BackupsDialog() override;

    /// The path of the chosen backup; empty if there is none.
    QString chosen() const;

    QTreeWidget *list() const { return m_list; }
    QPushButton *restoreButton() const { return m_restore; }

private:
    void fillList(const QStringList &files);
    void startReading(const QStringList &files);
    void showContent(int row, const QImage &picture, const QString &strokes, bool isReadable);
    void updateButton();

    QTreeWidget *m_list = nullptr;
    QPushButton *m_restore = nullptr;
    std::jthread m_reading;
};

} // namespace suffuse

#pragma once

#include "app/dialogs/sheet_presets.h"
#include "app/session/lessons/lesson.h"

#include <QDialog>
#include <QVariant>

#include <functional>
#include <thread>

class QCheckBox;
class QHBoxLayout;
class QListWidget;
class QVBoxLayout;

namespace suffuse {

/// Where one begins: a new sheet, a painting that was open before, a sample, or a lesson. It stays beside the window,
/// and closes with a choice; it does nothing of it itself.
class WelcomeDialog : public QDialog {
    Q_OBJECT

public:
    explicit WelcomeDialog(QWidget *parent = nullptr);

    QListWidget *sheets() const { return m_sheets; }
    QListWidget *paintings() const { return m_paintings; }
    QCheckBox *atStart() const { return m_atStart; }

signals:
    void sheetChosen(const suffuse::NewSheet &sheet);
    /// Another sheet is wanted than those that are listed.
    void otherSheetWanted();
    void fileChosen(const QString &path);
    /// Files are to be looked for.
    void openWanted();
    void lessonChosen(suffuse::LessonKind kind);

private:
    void addSheets(QHBoxLayout &row);
    void addPaintings(QHBoxLayout &row);
    void addLessons(QVBoxLayout &column);
    void addFoot(QVBoxLayout &column);
    void whenChosen(QListWidget &list, const std::function<void(const QVariant &data)> &does);
    void addPainting(const QString &path, const QString &title, const QString &heading);
    void loadPreviews();
    void showPreview(int row, const QImage &preview);

    std::vector<SheetPreset> m_presets = sheetPresets();
    QListWidget *m_sheets = nullptr;
    QListWidget *m_paintings = nullptr;
    QCheckBox *m_atStart = nullptr;
    std::jthread m_loader; ///< of previews; it ends before all else goes
};

} // namespace suffuse

#pragma once

#include <QCoreApplication>
#include <QDialog>
#include <QStandardPaths>

class QCheckBox;
class QFileInfo;
class QGridLayout;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace suffuse {

class HintLabel;

/// What all dialogs for exports have: a form with the file's name, and below it a bar, a hint and the buttons. Such a
/// dialog does the work itself; the file at the target stays until the new one is whole.
class ExportingDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(suffuse::ExportDialog)

public:
    QLineEdit *path() const { return m_path; }
    QSpinBox *quality() const { return m_quality; }
    QCheckBox *transparent() const { return m_transparent; }
    QPushButton *exportButton() const { return m_export; }
    HintLabel *hint() const { return m_hint; }
    virtual bool isExporting() const = 0;

    /// The first Cancel stops the work. The dialog stays, so that the user can try again.
    void reject() override;

protected:
    /// `place` is where people keep such files; a film's frames are many, and no place for pictures.
    ExportingDialog(const QString &title, QStandardPaths::StandardLocation place, QWidget *parent);

    /// Adds a row with a label to the form.
    void addField(int row, const QString &name, QWidget *field, const QString &tip, int columns = 2,
                  Qt::Alignment alignment = {});
    /// Adds the row for the file's name, with a button that browses.
    void addFile(int row, const QString &tip);
    void addQuality(int row, Qt::Alignment alignment = {});
    void addTransparent(int row);
    /// Whether a name can be given; the row stays where it cannot.
    void setFileEnabled(bool enabled);
    /// Adds what stands below the form. To be called when the form is complete, since Tab goes in this order. `verb` is
    /// what the button says that does it; empty: Export.
    void addWork(const QString &iconName, const QString &verb = {});
    /// Begins with the name that is in the path. To be called last.
    void begin();

    QPushButton *cancelButton() const { return m_cancel; }
    /// Returns true if there is no such file, or the user lets it be replaced.
    bool mayReplace(const QFileInfo &file);
    /// Shows how the work went. What was written closes the dialog.
    void finish(bool written, const QString &error);
    virtual void setBusy(bool busy);

    virtual void browse() = 0;
    virtual void pathChanged() = 0;
    virtual void startExport() = 0;
    virtual void stop() = 0;
    virtual void remember() {} ///< what was exported is written

    const QStandardPaths::StandardLocation m_place;
    QWidget *const m_form;
    QGridLayout *const m_grid;
    QVBoxLayout *const m_column;
    QLineEdit *m_path = nullptr;
    QSpinBox *m_quality = nullptr;
    QCheckBox *m_transparent = nullptr;
    QProgressBar *m_progress = nullptr;
    HintLabel *m_hint = nullptr;

private:
    QPushButton *m_browse = nullptr;
    QPushButton *m_export = nullptr;
    QPushButton *m_cancel = nullptr;
};

} // namespace suffuse

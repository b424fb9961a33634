#pragma once

#include "app/dialogs/export/drawing_job.h"
#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/exporting_dialog.h"

#include <QTimer>

class QComboBox;
class QLabel;

namespace suffuse {

class Editor;

/// Exports the painting as a drawing of paths for other programs. It is drawn as soon as the dialog is open, and how
/// far it is from the picture is said before anything can be written.
class DrawingDialog : public ExportingDialog {
    Q_OBJECT

public:
    explicit DrawingDialog(Editor &editor, QWidget *parent = nullptr);

    QComboBox *kind() const { return m_kind; }
    QComboBox *page() const { return m_page; }
    QSpinBox *bands() const { return m_bands; }
    MomentRow *moment() const { return m_moment; }
    QLabel *difference() const { return m_difference; }
    bool isExporting() const override { return m_job.isWriting(); }

protected:
    /// Return while the drawing is being compared exports it as soon as that is done.
    void keyPressEvent(QKeyEvent *event) override;

private:
    void addFields(QGridLayout &grid);
    void restore();
    void remember() override;
    DrawingKind chosenKind() const;
    void kindChanged();
    /// Draws anew what is asked for now, or once nothing more is typed.
    void prepare();
    void prepareSoon();
    /// Something else is wanted than what Return was pressed for.
    void forgetReturn();
    void sayWhyItWaits();
    void showPrepared(const QString &error);
    void browse() override;
    void pathChanged() override;
    void startExport() override;
    void stop() override { m_job.cancel(); }
    void setBusy(bool busy) override;

    Editor &m_editor;
    DrawingJob m_job;
    QTimer m_soon;           ///< until what is being typed is drawn
    bool m_returned = false; ///< Return was pressed while nothing could be exported yet
    QComboBox *m_kind = nullptr;
    QLabel *m_purpose = nullptr;
    QSpinBox *m_bands = nullptr;
    QComboBox *m_page = nullptr;
    std::optional<DrawingFormat> m_format; ///< by the ending of the file's name
    MomentRow *m_moment = nullptr;
    QLabel *m_difference = nullptr;
};

} // namespace suffuse

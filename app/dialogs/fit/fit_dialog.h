#pragma once

#include "app/session/fitting/fit_job.h"

#include <QDialog>
#include <QElapsedTimer>

class QBoxLayout;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace suffuse {

class Editor;
class FitRows;
class FitView;
class HintLabel;

/// Fits strokes to a picture, which grows meanwhile, and puts them into the painting as a layer. The picture is that of
/// a file or of the underlay. The work is done aside; until Insert the painting stays as it is.
class FitDialog : public QDialog {
    Q_OBJECT

public:
    /// Begins with the underlay's picture, if there is one, or else with none until `takeFile`.
    FitDialog(Editor &editor, QWidget *parent);
    ~FitDialog() override;

    /// Begins anew with the picture of a file. Returns false where it cannot be read; the hint says why.
    bool takeFile(const QString &path);
    /// Begins anew with the underlay.
    void takeUnderlay();
    /// What is to be said after the strokes were inserted; may be empty.
    const QString &said() const { return m_said; }

    const FitJob &job() const { return m_job; }
    QComboBox *source() const { return m_source; }
    FitRows *rows() const { return m_rows; }
    FitView *view() const { return m_view; }
    QToolButton *originalButton() const { return m_original; }
    QPushButton *stopButton() const { return m_stop; }
    QPushButton *insertButton() const { return m_insert; }
    QLabel *status() const { return m_status; }
    QProgressBar *progress() const { return m_progress; }
    HintLabel *hint() const { return m_hint; }

    void accept() override;
    void reject() override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    void addPicture(QBoxLayout &row);
    void addSettings(QBoxLayout &row);
    void addButtons(QBoxLayout &column);
    void choose(int index);
    void take(EncodedImage image, const QString &place, const QString &name, bool isUnderlay);
    void restart();
    void stopOrGoOn();
    void showNews();
    void showEnd(const QString &error);
    void showState();
    FitWish wish() const;
    Rect area() const;

    Editor &m_editor;
    FitJob &m_job; ///< It may outlive the dialog for a moment, since Cancel waits for nothing.
    bool m_isUnderlay = false; ///< whose picture it is
    bool m_isFailed = false;
    QString m_said;
    QElapsedTimer m_held; ///< since the button for the original was pressed
    bool m_wasOriginal = false;
    QComboBox *m_source = nullptr;
    FitRows *m_rows = nullptr;
    FitView *m_view = nullptr;
    QToolButton *m_original = nullptr;
    QLabel *m_status = nullptr;
    QProgressBar *m_progress = nullptr;
    HintLabel *m_hint = nullptr;
    QPushButton *m_stop = nullptr;
    QPushButton *m_insert = nullptr;
};

} // namespace suffuse

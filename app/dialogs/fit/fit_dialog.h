#pragma once

#include "app/session/fitting/refit_task.h"

#include <QDialog>
#include <QElapsedTimer>

#include <optional>

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
    /// Begins with fewer strokes in place of those of the task, which are to look as they do, or like the picture of a
    /// file; Replace puts them there.
    FitDialog(Editor &editor, RefitTask task, QWidget *parent);
    ~FitDialog() override;

    /// Begins anew with the picture of a file. Returns false where it cannot be read; the hint says why.
    bool takeFile(const QString &path);
    /// Begins anew with the underlay.
    void takeUnderlay();
    /// Begins anew with what the strokes of the task show.
    void takeOwnLook();
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
    FitDialog(Editor &editor, std::optional<RefitTask> task, QWidget *parent);
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
    std::optional<RefitTask> m_task; ///< none: a picture becomes a layer
    EncodedImage m_image;            ///< that is fitted; null: what the task shows
    QString m_place;                 ///< of the image, for messages
    bool m_isUnderlay = false;       ///< whose picture it is
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

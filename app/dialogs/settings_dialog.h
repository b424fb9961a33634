#pragma once

#include "model/brush/brush.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace suffuse {

class ColourPage;
class PenPage;

/// The settings: language, theme, how pictures are made and come to the screen, backups, the pen, and colour profiles.
/// All of them take effect at once.
class SettingsDialog : public QDialog {
    Q_OBJECT

public:
    /// `brush` is the one with which the pen is tried.
    explicit SettingsDialog(QWidget *parent = nullptr, const Brush &brush = builtinBrushes().front());

    /// To be asked after the dialog was accepted: whether the open windows were made for other settings, so that they
    /// have to be made anew (rebuilt_windows.h).
    bool needsOtherWindows() const { return m_needsOtherWindows; }

    QComboBox *language() const { return m_language; }
    QComboBox *theme() const { return m_theme; }
    QComboBox *presenter() const { return m_presenter; }
    QComboBox *backend() const { return m_backend; }
    QSpinBox *threads() const { return m_threads; }
    QSpinBox *backups() const { return m_backups; }
    PenPage *pen() const { return m_pen; }
    ColourPage *colours() const { return m_colours; }

    void accept() override;
    void reject() override;

private:
    void addMotion(QFormLayout &form);
    void addDrawing(QFormLayout &form);
    void addSaving(QFormLayout &form);
    QComboBox *addCombo(QFormLayout &form, const QString &name, const QString &tip);

    QComboBox *m_language = nullptr;
    QComboBox *m_theme = nullptr;
    QComboBox *m_presenter = nullptr;
    QComboBox *m_backend = nullptr;
    QSpinBox *m_threads = nullptr;
    QSpinBox *m_backups = nullptr;
    PenPage *m_pen = nullptr;
    ColourPage *m_colours = nullptr;
    int m_themeBefore = 0;
    bool m_needsOtherWindows = false;
};

} // namespace suffuse

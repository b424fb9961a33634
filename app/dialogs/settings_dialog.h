#pragma once

#include "model/brush/brush.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QSpinBox;

namespace suffuse {

class PenPage;

/// Language, theme, how pictures are made and come to the screen, backups, and the pen. All of it changes at once.
class SettingsDialog : public QDialog {
    Q_OBJECT

public:
    /// `brush`: what the pen is tried with.
    explicit SettingsDialog(QWidget *parent = nullptr, const Brush &brush = builtinBrushes().front());

    /// After it was accepted: windows that are open have been made by what the settings said before
    /// (rebuilt_windows.h).
    bool needsOtherWindows() const { return m_needsOtherWindows; }

    QComboBox *language() const { return m_language; }
    QComboBox *theme() const { return m_theme; }
    QComboBox *presenter() const { return m_presenter; }
    QComboBox *backend() const { return m_backend; }
    QSpinBox *threads() const { return m_threads; }
    QSpinBox *backups() const { return m_backups; }
    PenPage *pen() const { return m_pen; }

    void accept() override;
    void reject() override;

private:
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
    int m_themeBefore = 0;
    bool m_needsOtherWindows = false;
};

} // namespace suffuse

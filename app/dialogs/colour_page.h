#pragma once

#include "app/session/settings/colour_settings.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace suffuse {

/// The page of the settings for colours: the screen's profile, and the device of soft proofs.
class ColourPage : public QWidget {
    Q_OBJECT

public:
    ColourPage(const ColourSettings &settings, QWidget *parent);

    ColourSettings settings() const;
    QComboBox *screen() const { return m_screen; }
    QPushButton *screenFile() const { return m_screenFile; }
    QPushButton *proofFile() const { return m_proofFile; }
    QComboBox *intent() const { return m_intent; }
    QCheckBox *blackPoints() const { return m_blackPoints; }

private:
    void chooseScreen();
    void chooseProof();
    /// Asks for a profile of these colours. Empty if none was chosen; what is none is said.
    QString ask(const QString &title, const QString &before, bool forScreen);
    void showNames();

    ColourSettings m_settings;
    QComboBox *m_screen = nullptr;
    QPushButton *m_screenFile = nullptr;
    QPushButton *m_proofFile = nullptr;
    QComboBox *m_intent = nullptr;
    QCheckBox *m_blackPoints = nullptr;
    QLabel *m_hint = nullptr;
};

} // namespace suffuse

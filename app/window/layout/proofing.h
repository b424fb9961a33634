// What a picture will look like elsewhere: the commands, and the sign in the status bar.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

class QLabel;

namespace suffuse {

struct ColourSettings;

/// Adds the rows for soft proofs. Their settings are those of the program, so all windows follow.
class Proofing : public QObject {
    Q_OBJECT

public:
    Proofing(const Workplace &place, QObject *parent);

private:
    void addRows();
    /// Shows colours as on the device of the profile that was chosen last; without one, asks for it.
    void switchProof();
    void switchWarning();
    /// Asks for a profile's file and shows it. What is no profile is said.
    void chooseProfile();
    /// Keeps the settings; all windows follow.
    void take(const ColourSettings &colours);
    void showSign();

    Workplace m_place;
    QLabel *m_sign = nullptr;
};

/// All windows take the settings of colours as they are now.
void recolourWindows();

} // namespace suffuse

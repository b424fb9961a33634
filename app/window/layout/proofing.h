// What a picture will look like elsewhere: the commands, and the sign in the status bar.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

class QLabel;

namespace suffuse {

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
    /// Asks for a profile's file and shows it. Returns false if none was chosen or it is none.
    bool chooseProfile();
    void showSign();

    Workplace m_place;
    QLabel *m_sign = nullptr;
};

/// All windows take the settings of colours as they are now.
void recolourWindows();

} // namespace suffuse

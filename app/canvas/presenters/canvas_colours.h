#pragma once

#include "app/session/colour/screen_colours.h"
#include "app/session/settings/colour_settings.h"

class QWidget;

namespace suffuse {

/// How the colours of a canvas come to its screen: what the settings ask for, and what came of it.
class CanvasColours {
public:
    /// Reads the settings, and the profile of the screen that a widget is on. Returns whether they differ from before.
    bool read(const QWidget &on);

    const ScreenColours &screen() const { return m_screen; }
    /// The name of the profile whose colours are shown instead; empty if there is none.
    QString proof() const { return m_proof; }
    /// Why colours are shown as if there were no profile; empty if nothing is wrong.
    QString problem() const { return m_problem; }

private:
    ColourSettings m_settings;
    QByteArray m_systemProfile;
    ScreenColours m_screen;
    QString m_proof, m_problem;
    bool m_isRead = false;
};

} // namespace suffuse

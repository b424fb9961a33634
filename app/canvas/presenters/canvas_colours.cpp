#include "app/canvas/presenters/canvas_colours.h"

#include "app/canvas/presenters/screen_profile.h"

#include <QWidget>

namespace suffuse {

bool CanvasColours::read(const QWidget &on)
{
    const ColourSettings settings = settings::colours();
    const QByteArray systemProfile =
        settings.screen == ScreenProfile::System ? systemProfileOf(on.screen()) : QByteArray();
    if (m_isRead && settings == m_settings && systemProfile == m_systemProfile)
        return false;
    m_isRead = true;
    m_settings = settings;
    m_systemProfile = systemProfile;
    m_screen = {}, m_proof.clear(), m_problem.clear();
    const Result<ColourConversion> conversion = screenConversion(settings, systemProfile);
    if (!conversion) {
        m_problem = conversion.error();
        return true;
    }
    m_screen = ScreenColours(*conversion);
    if (settings.proofs)
        m_proof = titleOfProfileAt(settings.proofFile);
    return true;
}

} // namespace suffuse

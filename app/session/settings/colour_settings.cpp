#include "app/session/settings/colour_settings.h"

#include "app/session/settings/settings.h"

#include <QFileInfo>

#include <algorithm>

namespace suffuse {

Result<ColourConversion> screenConversion(const ColourSettings &settings, const QByteArray &systemProfile)
{
    ColourProfiles profiles;
    if (settings.screen == ScreenProfile::System) {
        profiles.to = systemProfile;
    } else if (settings.screen == ScreenProfile::File) {
        Result<QByteArray> screen = readProfile(settings.screenFile);
        if (!screen)
            return Error{screen.error()};
        profiles.to = *screen;
    }
    if (settings.proofs && !settings.proofFile.isEmpty()) {
        Result<QByteArray> proof = readProfile(settings.proofFile);
        if (!proof)
            return Error{proof.error()};
        profiles.proof = *proof;
        profiles.intent = settings.intent;
        profiles.blackPoints = settings.blackPoints;
        profiles.marksGamut = settings.marksGamut;
    }
    if (profiles.to.isEmpty() && profiles.proof.isEmpty())
        return ColourConversion();
    return ColourConversion::between(profiles);
}

QString titleOfProfileAt(const QString &path)
{
    const Result<QByteArray> profile = readProfile(path);
    const QString file = QFileInfo(path).fileName();
    return profile ? titleOfProfile(*profile, file) : file;
}

namespace settings {

ColourSettings colours()
{
    const QSettings &kept = store();
    ColourSettings out;
    const QString screen = kept.value("colours/screen").toString();
    out.screen = screen == "none"   ? ScreenProfile::None
                 : screen == "file" ? ScreenProfile::File
                                    : ScreenProfile::System;
    out.screenFile = kept.value("colours/screenFile").toString();
    out.proofFile = kept.value("colours/proofFile").toString();
    out.proofs = kept.value("colours/proofs").toBool() && !out.proofFile.isEmpty();
    out.marksGamut = kept.value("colours/marksGamut").toBool();
    out.intent = RenderingIntent(std::clamp(kept.value("colours/intent", int(out.intent)).toInt(), 0, 3));
    out.blackPoints = kept.value("colours/blackPoints", true).toBool();
    return out;
}

void setColours(const ColourSettings &colours)
{
    QSettings &kept = store();
    kept.setValue("colours/screen", colours.screen == ScreenProfile::None   ? "none"
                                    : colours.screen == ScreenProfile::File ? "file"
                                                                            : "system");
    kept.setValue("colours/screenFile", colours.screenFile);
    kept.setValue("colours/proofFile", colours.proofFile);
    kept.setValue("colours/proofs", colours.proofs);
    kept.setValue("colours/marksGamut", colours.marksGamut);
    kept.setValue("colours/intent", int(colours.intent));
    kept.setValue("colours/blackPoints", colours.blackPoints);
}

} // namespace settings

} // namespace suffuse

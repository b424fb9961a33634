#include "app/session/settings/motion.h"

#include "app/session/settings/settings.h"

#include <QSettings>

namespace suffuse::settings {

namespace {

const QString motionKey = QStringLiteral("motion");

} // namespace

Motion motion()
{
    const QString kept = store().value(motionKey).toString();
    return kept == QLatin1String("reduced") ? Motion::Reduced : kept == QLatin1String("full") ? Motion::Full : Motion::System;
}

void setMotion(Motion motion)
{
    store().setValue(motionKey, motion == Motion::Reduced ? "reduced" : motion == Motion::Full ? "full" : "system");
}

} // namespace suffuse::settings

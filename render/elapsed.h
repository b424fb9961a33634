// Times of a renderer's stages.
#pragma once

#include <QElapsedTimer>

namespace suffuse {

/// Since a timer was started.
inline double milliseconds(const QElapsedTimer &timer)
{
    return double(timer.nsecsElapsed()) * 1e-6;
}

} // namespace suffuse

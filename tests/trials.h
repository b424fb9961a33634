// How often a test tries: often enough for every push, or as often as before a release.
#pragma once

#include <QtGlobal>

namespace suffuse {

inline bool isLongRun()
{
    return qEnvironmentVariableIsSet("SUFFUSE_LONG");
}

/// SUFFUSE_TRIALS, else `usual`, or `release` where SUFFUSE_LONG is set. Sanitizers take ten times as long.
inline int trials(int usual, int release)
{
#ifdef SUFFUSE_SANITIZED
    usual = (usual + 9) / 10;
#endif
    if (const int given = qEnvironmentVariableIntValue("SUFFUSE_TRIALS"); given > 0)
        return given;
    return isLongRun() ? release : usual;
}

/// Whether case `number` of a list has its turn: with sanitizers, which take ten times as long, each fifth has.
inline bool isTried([[maybe_unused]] int number)
{
#ifdef SUFFUSE_SANITIZED
    return isLongRun() || number % 5 == 0;
#else
    return true;
#endif
}

/// SUFFUSE_SEED: several runs beside each other try different things.
inline quint32 firstSeed()
{
    return quint32(qEnvironmentVariableIntValue("SUFFUSE_SEED"));
}

} // namespace suffuse

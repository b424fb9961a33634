// How suffuse-cli reaches the fonts: Qt's part for them links what a display needs, so it lies in a module of its own,
// which is loaded when a text is to be set.
#pragma once

#include "model/painting/letters.h"

class QCoreApplication;

namespace suffuse {

/// It rises with every change of LetterShaper, and of what a shaper hands out.
constexpr int letteringModuleVersion = 3;

extern "C" {
/// suffuse_lettering_version
using LetteringVersionFunction = int (*)();
/// suffuse_lettering_application: an application object that knows fonts and needs no display. There must be no other
/// one. The caller deletes it.
using LetteringApplicationFunction = QCoreApplication *(*)(int &argc, char **argv);
/// suffuse_lettering_shaper: needs such an object, and is deleted before it.
using LetteringShaperFunction = LetterShaper *(*)();
}

} // namespace suffuse

#include "model/painting/letters.h"

namespace suffuse {

namespace {

LetterShaper *present = nullptr;

}

LetterShaper *letterShaper()
{
    return present;
}

void setLetterShaper(LetterShaper *shaper)
{
    present = shaper;
}

} // namespace suffuse

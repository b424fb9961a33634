// The rows of the table that ask for a word or a number, and do it.
#pragma once

#include "app/window/workplace.h"

namespace suffuse {

void addDialogRows(const Workplace &place);

} // namespace suffuse

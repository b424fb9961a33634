// Whether what the program does may move by itself.
#pragma once

namespace suffuse::settings {

/// `System`: as the desktop says.
enum class Motion { System, Reduced, Full };
Motion motion();
void setMotion(Motion motion);

} // namespace suffuse::settings

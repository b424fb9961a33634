// Whether people are greeted.
#pragma once

namespace suffuse::settings {

/// The welcome page comes when the program starts without a file.
bool welcomes();
void setWelcomes(bool on);

} // namespace suffuse::settings

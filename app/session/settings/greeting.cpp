#include "app/session/settings/greeting.h"

#include "app/session/settings/settings.h"

namespace suffuse::settings {

namespace {

constexpr char welcomesKey[] = "welcomes";

} // namespace

bool welcomes()
{
    return store().value(welcomesKey, true).toBool();
}

void setWelcomes(bool on)
{
    store().setValue(welcomesKey, on);
}

} // namespace suffuse::settings

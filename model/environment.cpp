#include "model/environment.h"

#include <cstdlib>

namespace suffuse::environment {

namespace {

const char *nameOf(Variable variable)
{
    switch (variable) {
    case Variable::Settings:
        return "SUFFUSE_SETTINGS";
    case Variable::Journals:
        return "SUFFUSE_JOURNALS";
    case Variable::Backend:
        return "SUFFUSE_BACKEND";
    case Variable::Presenter:
        return "SUFFUSE_PRESENTER";
    case Variable::ModuleFolder:
        return "SUFFUSE_MODULE_DIR";
    case Variable::Simd:
        return "SUFFUSE_SIMD";
    case Variable::CudaFailure:
        return "SUFFUSE_CUDA_FAIL";
    case Variable::StateHome:
        return "XDG_STATE_HOME";
    case Variable::Display:
        return "DISPLAY";
    case Variable::WaylandDisplay:
        return "WAYLAND_DISPLAY";
    case Variable::Desktop:
        return "XDG_CURRENT_DESKTOP";
    case Variable::QtPlatform:
        return "QT_QPA_PLATFORM";
    }
    return "";
}

} // namespace

std::string value(Variable variable)
{
    const char *found = std::getenv(nameOf(variable));
    return found ? found : "";
}

bool isSet(Variable variable)
{
    return std::getenv(nameOf(variable)) != nullptr;
}

void set(Variable variable, const std::string &value)
{
    ::setenv(nameOf(variable), value.c_str(), 1);
}

} // namespace suffuse::environment

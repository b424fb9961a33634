// The environment variables that Suffuse reads. No other file asks for one (test_layering sees to it).
#pragma once

#include <string>

namespace suffuse::environment {

/// What a person sets permanently stands in the settings. The variables are for tests, for finding faults, and for
/// starting the program once in another way, so they override the settings.
enum class Variable {
    Settings,       ///< SUFFUSE_SETTINGS: the file of the settings
    Journals,       ///< SUFFUSE_JOURNALS: the folder in which journals are kept (docs/recovery.md)
    Backend,        ///< SUFFUSE_BACKEND=auto|cpu|cuda: what draws the canvas
    Presenter,      ///< SUFFUSE_PRESENTER=opengl|raster: how the canvas comes onto the screen
    ModuleFolder,   ///< SUFFUSE_MODULE_DIR: where the modules for image files lie
    Simd,           ///< SUFFUSE_SIMD=SCALAR|SSE4|AVX2|…: the vector instructions of the CPU renderer
    CudaFailure,    ///< SUFFUSE_CUDA_FAIL=n or n:oom: the call of a CUDA device that fails (docs/cuda.md)
    StateHome,      ///< XDG_STATE_HOME: the desktop's folder for what programs keep between runs
    Display,        ///< DISPLAY, of X11
    WaylandDisplay, ///< WAYLAND_DISPLAY
    Desktop,        ///< XDG_CURRENT_DESKTOP: which desktop runs, GNOME for example
    QtPlatform,     ///< QT_QPA_PLATFORM: how Qt reaches a screen, or that it does without
};

/// The value of a variable; empty where it is not set.
std::string value(Variable variable);
bool isSet(Variable variable);
/// Sets a variable for this process and for those that it starts. It must not be called while other threads read the
/// environment.
void set(Variable variable, const std::string &value);

} // namespace suffuse::environment

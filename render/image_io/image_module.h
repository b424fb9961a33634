#pragma once

#include "model/result.h"
#include "render/image_io/image_io.h"
#include "render/image_io/module_api.h"

namespace suffuse {

/// The image module's functions, all set.
struct ImageModule {
    ImageModuleWriteFunction write = nullptr;
    ImageModuleReadFunction read = nullptr;
};

/// Loads the module on the first call: from the folder SUFFUSE_MODULE_DIR if that is set, else from
/// ../lib/suffuse beside the program's folder. The outcome stays for the life of the process. Any thread.
const Result<ImageModule> &imageModule();

/// What the module calls a format (OpenImageIO's names).
const char *imageModuleName(ImageFormat format);

} // namespace suffuse

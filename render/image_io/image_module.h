#pragma once

#include "model/result.h"
#include "render/image_io/image_io.h"
#include "render/image_io/module_api.h"

namespace suffuse {

class FileReplacement;

/// An image module's functions, all set but those of films, which the small one alone has.
struct ImageModule {
    ImageModuleWriteFunction write = nullptr;
    ImageModuleReadFunction read = nullptr;
    ImageModuleFilmAddFunction filmAdd = nullptr;
    ImageModuleFilmEndFunction filmEnd = nullptr;
};

/// There are two modules: a small one for what is written often, which loads at once, and OpenImageIO, which brings
/// some 260 libraries. Each is loaded when it is first asked for: from the folder SUFFUSE_MODULE_DIR if that is set,
/// else from ../lib/suffuse beside the program's folder. The outcome stays for the life of the process. Any thread.
const Result<ImageModule> &readingModule(ImageFormat format);
/// `bytes`: of the picture's pixels in the file, before they are packed.
const Result<ImageModule> &writingModule(ImageFormat format, qint64 bytes);

/// The file as modules see it.
ImageModuleFile moduleFile(FileReplacement &file);

/// What the modules call a format (OpenImageIO's names).
const char *imageModuleName(ImageFormat format);

} // namespace suffuse

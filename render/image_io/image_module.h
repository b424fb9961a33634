#pragma once

#include "model/result.h"
#include "render/image_io/image_io.h"
#include "render/image_io/module/api.h"

namespace suffuse {

class FileReplacement;

/// The functions of an image module. All are set, except those for tiles, films and colours, which only the small
/// module has.
struct ImageModule {
    ImageModuleWriteFunction write = nullptr;
    ImageModuleReadFunction read = nullptr;
    ImageModuleTileFunction tile = nullptr;
    ImageModuleFilmAddFunction filmAdd = nullptr;
    ImageModuleFilmEndFunction filmEnd = nullptr;
    ImageModuleProfileFunction profile = nullptr;
    ImageModuleColoursNameFunction coloursName = nullptr;
    ImageModuleColoursOpenFunction coloursOpen = nullptr;
    ImageModuleColoursApplyFunction coloursApply = nullptr;
    ImageModuleColoursCloseFunction coloursClose = nullptr;
};

/// There are two modules: a small one for formats that are written often, which loads at once, and OpenImageIO, which
/// loads some 260 libraries. Each is loaded when it is first asked for, from the folder SUFFUSE_MODULE_DIR if that is
/// set, else from ../lib/suffuse beside the program's folder. The result stays for the life of the process. These may
/// be called on any thread.
const Result<ImageModule> &readingModule(ImageFormat format);
/// `bytes` is the size of the picture's pixels in the file before they are packed.
const Result<ImageModule> &writingModule(ImageFormat format, qint64 bytes);

/// The module that knows colour profiles.
const Result<ImageModule> &colourModule();

/// The file as modules see it.
ImageModuleFile moduleFile(FileReplacement &file);

/// The name of a format in modules (OpenImageIO's name).
const char *imageModuleName(ImageFormat format);

} // namespace suffuse

// What the image modules have in common: how they begin.
#pragma once

#include "model/module_guard.h"
#include "render/image_io/module/api.h"

/// Defines the entry points of a module, which writes and reads by these functions.
#define SUFFUSE_IMAGE_MODULE(writeRows, readRows)                                                                      \
    extern "C" {                                                                                                       \
    __attribute__((visibility("default"))) int suffuse_image_module_version()                                          \
    {                                                                                                                  \
        return suffuse::imageModuleVersion;                                                                            \
    }                                                                                                                  \
    __attribute__((visibility("default"))) bool suffuse_image_write(const suffuse::ImageModuleWrite *job, char *error, \
                                                                    std::size_t size)                                  \
    {                                                                                                                  \
        return suffuse::guarded([&] { return writeRows(*job, error, size); }, error, size);                            \
    }                                                                                                                  \
    __attribute__((visibility("default"))) bool suffuse_image_read(const suffuse::ImageModuleRead *job, char *error,   \
                                                                   std::size_t size)                                   \
    {                                                                                                                  \
        return suffuse::guarded([&] { return readRows(*job, error, size); }, error, size);                             \
    }                                                                                                                  \
    }

// The border between the program and the module that knows the structure of PDF files. It has plain C types, so that
// the module needs nothing of the program.
#pragma once

#include <cstddef>

namespace suffuse {

/// Both sides must have the same number. Raise it with every change below.
inline constexpr int pdfModuleVersion = 1;

/// An object of a PDF file in PDF's own syntax ("<< /Type /Catalog /Pages 2 0 R >>"), in which "N 0 R" is the object
/// number N of the file, from 1 on.
struct PdfModuleObject {
    const char *value; ///< ends with a zero
    std::size_t valueSize;
    const void *stream; ///< null: it is no stream, else `value` is its dictionary without a length
    std::size_t streamSize;
};

/// A file that is made of objects: number 1 is its catalogue, 2 its tree of pages, 3 what is known of it.
struct PdfModuleWrite {
    const PdfModuleObject *objects;
    std::size_t count;
    const char *trailer; ///< more entries of the trailer, a dictionary
    void *context;
    bool (*write)(void *context, const void *bytes, std::size_t size); ///< takes the next part; false: stop
    bool (*stopped)(void *context);                                    ///< whether writing is to stop
};

/// The files that are attached to a PDF file. Names are UTF-8.
struct PdfModuleRead {
    const void *bytes;
    std::size_t size;
    std::size_t most; ///< to how many bytes a part of the file may unpack
    void *context;
    bool (*wanted)(void *context, const char *name);                     ///< whether the content of this one is wanted
    bool (*content)(void *context, const void *bytes, std::size_t size); ///< takes the next part of it; false: stop
};

/// The entry points of the module (C linkage): `suffuse_pdf_module_version`, `suffuse_pdf_write` and
/// `suffuse_pdf_read`. Those that return a bool return false if they fail, and put a message (UTF-8, cut to `size`
/// bytes) into `error`. Equal objects give equal bytes.
using PdfModuleVersionFunction = int (*)();
using PdfModuleWriteFunction = bool (*)(const PdfModuleWrite *job, char *error, std::size_t size);
using PdfModuleReadFunction = bool (*)(const PdfModuleRead *job, char *error, std::size_t size);

} // namespace suffuse

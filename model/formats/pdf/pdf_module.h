#pragma once

#include "model/formats/pdf/pdf_module_api.h"
#include "model/result.h"

namespace suffuse {

/// The functions of the module that knows PDF files; all are set.
struct PdfModule {
    PdfModuleWriteFunction write = nullptr;
    PdfModuleReadFunction read = nullptr;
};

/// It is loaded when it is first asked for, and stays for the life of the process. This may be called on any thread.
const Result<PdfModule> &pdfModule();

} // namespace suffuse

// The module that writes and reads PDF files, by libqpdf.
#include "model/formats/pdf/module_bounds.h"
#include "model/formats/pdf/pdf_module_api.h"
#include "model/module_guard.h"

#include <qpdf/Buffer.hh>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include <functional>
#include <memory>
#include <stdexcept>

namespace suffuse {

namespace {

/// Hands what comes out of libqpdf over, until `take` refuses.
class Sink : public Pipeline {
public:
    using Take = std::function<bool(const void *, std::size_t)>;
    explicit Sink(Take take) : Pipeline("suffuse", nullptr), m_take(std::move(take)) {}

    void write(const unsigned char *bytes, std::size_t size) override
    {
        if (!m_take(bytes, size))
            throw std::runtime_error("stopped");
    }
    void finish() override {}

private:
    Take m_take;
};

class Progress : public QPDFWriter::ProgressReporter {
public:
    explicit Progress(const PdfModuleWrite &job) : m_job(job) {}
    void reportProgress(int) override
    {
        if (m_job.stopped(m_job.context))
            throw std::runtime_error("stopped");
    }

private:
    const PdfModuleWrite &m_job;
};

/// The empty file begins with objects 1 and 2. The others come one after the other, before any refers to them.
void addObjects(QPDF &file, const PdfModuleWrite &job)
{
    for (std::size_t k = 2; k < job.count; ++k) {
        const PdfModuleObject &object = job.objects[k];
        // libqpdf only reads it.
        auto *bytes = static_cast<unsigned char *>(const_cast<void *>(object.stream));
        const QPDFObjectHandle added =
            bytes ? QPDFObjectHandle::newStream(&file, std::make_shared<Buffer>(bytes, object.streamSize))
                  : QPDFObjectHandle::newReserved(&file);
        if (added.getObjectID() != int(k + 1))
            throw std::logic_error("objects do not follow each other");
    }
    for (std::size_t k = 0; k < job.count; ++k) {
        const PdfModuleObject &object = job.objects[k];
        QPDFObjectHandle value = QPDFObjectHandle::parse(&file, std::string(object.value, object.valueSize));
        if (object.stream)
            file.getObjectByID(int(k + 1), 0).replaceDict(value);
        else
            file.replaceObject(int(k + 1), 0, value);
    }
    file.getTrailer().replaceKey("/Info", file.getObjectByID(3, 0));
    QPDFObjectHandle more = QPDFObjectHandle::parse(&file, job.trailer);
    for (const std::string &key : more.getKeys())
        file.getTrailer().replaceKey(key, more.getKey(key));
}

bool writePdf(const PdfModuleWrite &job)
{
    QPDF file;
    file.emptyPDF();
    addObjects(file, job);
    Sink sink([&](const void *bytes, std::size_t size) { return job.write(job.context, bytes, size); });
    QPDFWriter writer(file);
    writer.setOutputPipeline(&sink);
    writer.setMinimumPDFVersion("1.7");
    writer.setObjectStreamMode(qpdf_o_generate);
    writer.setDeterministicID(true);
    writer.registerProgressReporter(std::make_shared<Progress>(job));
    writer.write();
    return true;
}

bool readPdf(const PdfModuleRead &job)
{
    const UnpackedBound bound(job.most);
    QPDF file;
    file.setSuppressWarnings(true);
    file.processMemoryFile("PDF", static_cast<const char *>(job.bytes), job.size);
    for (const auto &[name, attached] : QPDFEmbeddedFileDocumentHelper(file).getEmbeddedFiles()) {
        if (!job.wanted(job.context, attached->getFilename().c_str()))
            continue;
        QPDFObjectHandle stream = attached->getEmbeddedFileStream();
        if (!stream.isStream())
            continue;
        Sink sink([&](const void *bytes, std::size_t size) { return job.content(job.context, bytes, size); });
        if (!stream.pipeStreamData(&sink, 0, qpdf_dl_generalized, true))
            throw std::runtime_error("what is attached cannot be unpacked");
    }
    return true;
}

} // namespace

} // namespace suffuse

extern "C" {
__attribute__((visibility("default"))) int suffuse_pdf_module_version()
{
    return suffuse::pdfModuleVersion;
}
__attribute__((visibility("default"))) bool suffuse_pdf_write(const suffuse::PdfModuleWrite *job, char *error,
                                                              std::size_t size)
{
    return suffuse::guarded([&] { return suffuse::writePdf(*job); }, error, size);
}
__attribute__((visibility("default"))) bool suffuse_pdf_read(const suffuse::PdfModuleRead *job, char *error,
                                                             std::size_t size)
{
    return suffuse::guarded([&] { return suffuse::readPdf(*job); }, error, size);
}
}

#include "model/formats/pdf/pdf_objects.h"

#include "model/formats/messages.h"
#include "model/formats/pdf/pdf_module.h"

#include <array>

namespace suffuse::pdf {

namespace {

/// What the module writes into.
struct Output {
    QByteArray bytes;
    const std::atomic<bool> *cancel;

    bool isStopped() const { return cancel && cancel->load(std::memory_order_relaxed); }
};

} // namespace

QByteArray number(double value)
{
    QByteArray digits = QByteArray::number(value, 'f', 6);
    while (digits.endsWith('0'))
        digits.chop(1);
    if (digits.endsWith('.'))
        digits.chop(1);
    return digits == "-0" ? QByteArrayLiteral("0") : digits;
}

QByteArray text(const QString &text)
{
    QByteArray bytes = QByteArrayLiteral("\xFE\xFF");
    for (const QChar unit : text) {
        bytes += char(unit.unicode() >> 8);
        bytes += char(unit.unicode() & 0xFF);
    }
    return '<' + bytes.toHex() + '>';
}

QByteArray reference(int object)
{
    return QByteArray::number(object) + " 0 R";
}

int Objects::add(const QByteArray &value)
{
    m_objects.push_back({value, {}, false});
    return int(m_objects.size());
}

int Objects::addStream(const QByteArray &dictionary, const QByteArray &bytes)
{
    m_objects.push_back({dictionary, bytes, true});
    return int(m_objects.size());
}

Result<QByteArray> Objects::file(const QByteArray &trailer, const std::atomic<bool> *cancel) const
{
    const Result<PdfModule> &module = pdfModule();
    if (!module)
        return Error{module.error()};
    std::vector<PdfModuleObject> objects;
    for (const Object &object : m_objects)
        objects.push_back({object.value.constData(), std::size_t(object.value.size()),
                           object.isStream ? object.stream.constData() : nullptr, std::size_t(object.stream.size())});
    Output output{{}, cancel};
    PdfModuleWrite job{};
    job.objects = objects.data();
    job.count = objects.size();
    job.trailer = trailer.constData();
    job.context = &output;
    job.write = [](void *context, const void *bytes, std::size_t size) {
        auto &out = *static_cast<Output *>(context);
        out.bytes.append(static_cast<const char *>(bytes), qsizetype(size));
        return out.bytes.size() <= largestFile && !out.isStopped();
    };
    job.stopped = [](void *context) { return static_cast<Output *>(context)->isStopped(); };
    std::array<char, 512> error{};
    if (module->write(&job, error.data(), error.size()))
        return output.bytes;
    if (output.isStopped())
        return Error{};
    if (output.bytes.size() > largestFile)
        return Error{FileMessages::tr("would have more than 2 GB")};
    return Error{FileMessages::tr("could not be written: %1").arg(QString::fromUtf8(error.data()))};
}

} // namespace suffuse::pdf

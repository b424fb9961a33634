#include "model/formats/pdf/pdf_embedding.h"

#include "model/formats/messages.h"
#include "model/formats/pdf/pdf_module.h"

#include <QCryptographicHash>

#include <algorithm>
#include <array>

namespace suffuse::pdf {

namespace {

constexpr qsizetype mostOfDocument = qsizetype(1) << 29;
/// What a file may unpack to in one part: documents are packed already, and tables of objects are short.
constexpr qsizetype leastBound = qsizetype(16) << 20, mostPacking = 16;
/// The sum stands in the trailer, which is never packed, in digits that are 0 while it is taken.
const QByteArray sealBegin = QByteArrayLiteral("/SuffuseSum (");
constexpr qsizetype sealDigits = 64;

/// Where the digits of the last sum in a file are; -1 if there is none.
qsizetype sealOf(const QByteArray &bytes)
{
    const qsizetype at = bytes.lastIndexOf(sealBegin);
    const qsizetype digits = at + sealBegin.size();
    return at < 0 || digits + sealDigits > bytes.size() ? -1 : digits;
}

/// Of a file without the digits.
QByteArray sumOf(const QByteArray &bytes, qsizetype digits)
{
    QCryptographicHash sum(QCryptographicHash::Sha256);
    sum.addData(QByteArrayView(bytes).first(digits));
    sum.addData(QByteArrayView(bytes).sliced(digits + sealDigits));
    return sum.result().toHex();
}

} // namespace

bool isPdf(const QByteArray &bytes)
{
    return bytes.startsWith("%PDF-");
}

QByteArray attach(Objects &objects, const QByteArrayList &documents)
{
    QByteArray names, files;
    for (qsizetype k = 0; k < documents.size(); ++k) {
        const QByteArray &document = documents[k];
        // Names are in order in the list of attached files.
        const QByteArray name = "(painting" +
                                (documents.size() > 1 ? '-' + QByteArray::number(k + 1).rightJustified(5, '0') : "") +
                                ".suffuse)";
        const QByteArray md5 = QCryptographicHash::hash(document, QCryptographicHash::Md5).toHex();
        const int content =
            objects.addStream("<< /Type /EmbeddedFile /Subtype /application#2fx-suffuse /Params << "
                              "/Size " +
                                  QByteArray::number(document.size()) + " /CheckSum <" + md5 + "> >> >>",
                              document);
        const int file =
            objects.add("<< /Type /Filespec /F " + name + " /UF " + name + " /AFRelationship /Source /EF << /F " +
                        reference(content) + " /UF " + reference(content) + " >> >>");
        names += name + ' ' + reference(file) + ' ';
        files += reference(file) + ' ';
    }
    return "/Names << /EmbeddedFiles << /Names [" + names + "] >> >> /AF [" + files + ']';
}

Result<QByteArray> sealedFile(const Objects &objects, const std::atomic<bool> *cancel)
{
    Result<QByteArray> file = objects.file("<< " + sealBegin + QByteArray(sealDigits, '0') + ") >>", cancel);
    if (!file)
        return file;
    const qsizetype digits = sealOf(*file);
    if (digits >= 0)
        file->replace(digits, sealDigits, sumOf(*file, digits));
    return file;
}

Result<AttachedPainting> readAttached(const QByteArray &bytes)
{
    const Result<PdfModule> &module = pdfModule();
    if (!module)
        return Error{FileMessages::tr("This is a PDF file, and %1.").arg(module.error())};
    AttachedPainting painting;
    PdfModuleRead job{};
    job.bytes = bytes.constData();
    job.size = std::size_t(bytes.size());
    job.most = std::size_t(std::min(mostOfDocument, leastBound + mostPacking * bytes.size()));
    job.context = &painting;
    job.wanted = [](void *context, const char *name) {
        return QByteArray(name).endsWith(".suffuse") && static_cast<AttachedPainting *>(context)->count++ == 0;
    };
    job.content = [](void *context, const void *part, std::size_t size) {
        static_cast<AttachedPainting *>(context)->document.append(static_cast<const char *>(part), qsizetype(size));
        return true;
    };
    std::array<char, 512> error{};
    if (!module->read(&job, error.data(), error.size()))
        return Error{FileMessages::tr("This PDF file is damaged: %1.").arg(excerpt(error.data()))};
    const qsizetype digits = sealOf(bytes);
    painting.isChanged = digits < 0 || bytes.mid(digits, sealDigits) != sumOf(bytes, digits);
    return painting;
}

} // namespace suffuse::pdf

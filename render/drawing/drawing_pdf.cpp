#include "render/drawing/drawing_pdf.h"

#include "model/formats/pdf/pdf_embedding.h"
#include "render/drawing/pdf_page.h"
#include "render/image_io/image_io.h"

namespace suffuse {

namespace {

QByteArray references(const std::vector<int> &objects)
{
    QByteArray list;
    for (const int object : objects)
        list += ' ' + pdf::reference(object);
    return '[' + list + " ]";
}

QByteArray outputIntent(int profile, bool isSrgb)
{
    return "<< /Type /OutputIntent /S /GTS_PDFA1 /OutputConditionIdentifier (" +
           QByteArray(isSrgb ? "sRGB IEC61966-2.1" : "Custom") + ") /Info (" +
           QByteArray(isSrgb ? "sRGB IEC61966-2.1" : "the profile of the painting") + ") /DestOutputProfile " +
           pdf::reference(profile) + " >>";
}

} // namespace

Result<QByteArray> pdfOf(const std::vector<PdfPage> &pages, const PdfAbout &about, const std::atomic<bool> *cancel)
{
    const Result<QByteArray> srgb = srgbIccProfile();
    if (!srgb)
        return Error{srgb.error()};
    pdf::Objects objects;
    const int srgbProfile = objects.addStream("<< /N 3 >>", *srgb);
    const bool isSrgb = about.profile.isEmpty();
    const int intent = isSrgb ? srgbProfile : objects.addStream("<< /N 3 >>", about.profile);
    // Where pages are meant for other colours, numbers of red, green and blue would be taken for those.
    const QByteArray rgb = isSrgb ? QByteArray() : "[/ICCBased " + pdf::reference(srgbProfile) + ']';
    std::vector<int> numbers, layers, hidden;
    QByteArray order;
    QByteArrayList documents;
    for (const PdfPage &page : pages) {
        PdfPageWriter writer(page, objects, cancel);
        const Result<int> number = writer.write(rgb);
        if (!number)
            return Error{number.error()};
        numbers.push_back(*number);
        documents.push_back(page.document);
        layers.insert(layers.end(), writer.layers().begin(), writer.layers().end());
        hidden.insert(hidden.end(), writer.hidden().begin(), writer.hidden().end());
        order += writer.layerOrder();
    }
    objects.set(pdf::Objects::pages, "<< /Type /Pages /Count " + QByteArray::number(qsizetype(numbers.size())) +
                                         " /Kids " + references(numbers) + " >>");
    QByteArray catalogue = "<< /Type /Catalog /Pages " + pdf::reference(pdf::Objects::pages) + " /OutputIntents [" +
                           outputIntent(intent, isSrgb) + "] /ViewerPreferences << /DisplayDocTitle true >> " +
                           pdf::attach(objects, documents);
    if (!layers.empty())
        catalogue += " /OCProperties << /OCGs " + references(layers) + " /D << /Order [" + order + " ] /OFF " +
                     references(hidden) + " >> >>";
    objects.set(pdf::Objects::catalogue, catalogue + " >>");
    objects.set(pdf::Objects::information,
                "<< /Title " + pdf::text(about.title) + " /Creator (Suffuse " + QByteArray(SUFFUSE_VERSION) + ") >>");
    return pdf::sealedFile(objects, cancel);
}

} // namespace suffuse

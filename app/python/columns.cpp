#include "app/python/columns.h"

#include "app/python/text_caster.h"

namespace suffuse::python {

void RowWriter::putText(const QString &text, char *to, std::size_t bytes)
{
    const QList<char32_t> codes = codesOf(text);
    std::memset(to, 0, bytes);
    std::memcpy(to, codes.constData(), std::min(bytes, std::size_t(codes.size()) * sizeof(char32_t)));
}

QString RowReader::textAt(const char *from, std::size_t bytes)
{
    QList<char32_t> codes(qsizetype(bytes / sizeof(char32_t)));
    std::memcpy(codes.data(), from, std::size_t(codes.size()) * sizeof(char32_t));
    while (!codes.isEmpty() && codes.back() == 0) // numpy fills texts up with them
        codes.removeLast();
    return textOfCodes(codes.constData(), codes.size());
}

EncodedImage RowReader::imageAt(const char *from) const
{
    std::int64_t place = -1;
    std::memcpy(&place, from, sizeof place);
    return place >= 0 && place < std::int64_t(m_images.size()) ? m_images[std::size_t(place)] : EncodedImage();
}

} // namespace suffuse::python

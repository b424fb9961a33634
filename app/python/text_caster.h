// Texts between Qt and Python, to the last code unit.
#pragma once

#include "app/python/pybind.h"

#include <QList>
#include <QString>

namespace suffuse::python {

/// The code points of a text; a surrogate without its other half is one by itself.
inline QList<char32_t> codesOf(const QString &text)
{
    QList<char32_t> codes;
    codes.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isPair = text[i].isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        codes.append(isPair ? QChar::surrogateToUcs4(text[i], text[i + 1]) : char32_t(text[i].unicode()));
        i += isPair;
    }
    return codes;
}

inline QString textOfCodes(const char32_t *codes, qsizetype count)
{
    QString text;
    text.reserve(count);
    for (qsizetype i = 0; i < count; ++i) {
        if (codes[i] > 0xFFFF)
            text.append(QChar(QChar::highSurrogate(codes[i]))).append(QChar(QChar::lowSurrogate(codes[i])));
        else
            text.append(QChar(char16_t(codes[i])));
    }
    return text;
}

} // namespace suffuse::python

namespace pybind11::detail {

/// str ↔ QString. Single surrogates, which UTF-8 cannot hold, stay what they are.
template <>
struct type_caster<QString> {
    PYBIND11_TYPE_CASTER(QString, const_name("str"));

    bool load(handle source, bool /*convert*/)
    {
        if (!source || !PyUnicode_Check(source.ptr()))
            return false;
        const auto length = PyUnicode_GET_LENGTH(source.ptr());
        QList<char32_t> codes(length);
        for (Py_ssize_t i = 0; i < length; ++i)
            codes[i] = PyUnicode_READ_CHAR(source.ptr(), i);
        value = suffuse::python::textOfCodes(codes.constData(), codes.size());
        return true;
    }
    static handle cast(const QString &text, return_value_policy /*policy*/, handle /*parent*/)
    {
        const QList<char32_t> codes = suffuse::python::codesOf(text);
        return PyUnicode_FromKindAndData(PyUnicode_4BYTE_KIND, codes.constData(), codes.size());
    }
};

} // namespace pybind11::detail

// The objects of a PDF file that is made, in PDF's own syntax, and the file that they become.
#pragma once

#include "model/result.h"

#include <QByteArray>
#include <QString>

#include <atomic>
#include <vector>

namespace suffuse::pdf {

/// A number as PDF has it, without an exponent.
QByteArray number(double value);
/// A text, as what PDF calls a text string.
QByteArray text(const QString &text);
/// What refers to an object.
QByteArray reference(int object);

/// Objects by their numbers.
class Objects {
public:
    /// What files begin with.
    static constexpr int catalogue = 1, pages = 2, information = 3;

    Objects() : m_objects(3) {}

    /// Return the number of the new object. The dictionary of a stream ("<< … >>") has no length.
    int add(const QByteArray &value);
    int addStream(const QByteArray &dictionary, const QByteArray &bytes);
    /// An object that others refer to before it is set.
    int reserve() { return add("null"); }
    void set(int object, const QByteArray &value) { m_objects[std::size_t(object - 1)].value = value; }

    /// The file's bytes, which are the same each time. It fails if the module is missing, if an object is no object,
    /// and if it was cancelled: then without a message. `trailer` is a dictionary.
    Result<QByteArray> file(const QByteArray &trailer, const std::atomic<bool> *cancel = nullptr) const;

private:
    struct Object {
        QByteArray value = "null";
        QByteArray stream;
        bool isStream = false;
    };
    std::vector<Object> m_objects;
};

} // namespace suffuse::pdf

// A pull parser for JSON whose shape is known. It builds no tree, reads numbers directly into their types, and every
// error says where it is.
#pragma once

#include "model/painting/segment.h"

#include <QByteArray>
#include <QString>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse {

/// Reads UTF-8 JSON (RFC 8259). After the first error all calls fail, so callers need to check only once at the end.
/// Nesting is bounded by the calls, since unknown members are refused without walking into them.
class JsonReader {
public:
    /// `bytes` must live as long as the reader. A byte order mark is skipped.
    JsonReader(const QByteArray &bytes, const QString &fileName);

    bool ok() const { return m_error.isEmpty(); }
    const QString &error() const { return m_error; }
    const QString &fileName() const { return m_fileName; }

    /// Reads an object. Calls `handler(k)` when the reader stands before the value of member names[k]. Unknown and
    /// repeated members are errors. Returns the set of members that were found (bit k), or 0 after an error. There may
    /// be at most 32 names.
    template <typename Handler>
    std::uint32_t object(std::span<const std::string_view> names, Handler handler)
    {
        std::uint32_t found = 0;
        if (!open('{'))
            return 0;
        for (bool first = true; nextItem('}', first); first = false) {
            const int member = memberName(names, found);
            if (member < 0)
                return 0;
            found |= 1u << member;
            m_path.push_back({names[std::size_t(member)], 0});
            handler(member);
            if (!ok())
                return 0;
            m_path.pop_back();
        }
        return ok() ? found : 0;
    }

    /// Reads an array. Calls `handler(i)` before each element. Returns the number of elements.
    template <typename Handler>
    std::size_t array(Handler handler)
    {
        std::size_t count = 0;
        if (!open('['))
            return 0;
        for (; nextItem(']', count == 0); ++count) {
            m_path.push_back({{}, count});
            handler(count);
            if (!ok())
                return 0;
            m_path.pop_back();
        }
        return count;
    }

    /// Read the nearest value of the type, directly from the decimal digits. A number that is too large is an error;
    /// one that is too small is 0.
    void read(float &value);
    void read(double &value);
    void read(bool &value);
    void read(QString &value);
    /// Reads a whole number, 0 or greater.
    void read(std::uint64_t &value);
    /// Reads seconds, at most ±1e12. Decimals of up to six places are exact.
    void readSeconds(Microseconds &value);
    /// Skips null if it is next, and returns whether it was.
    bool skipNull();
    /// Whether an object is next, for members that may be something else.
    bool isObjectNext();
    /// Reads an array of exactly N numbers.
    template <typename Number, std::size_t N>
    void readAll(std::array<Number, N> &values)
    {
        const std::size_t count = array([&](std::size_t i) {
            Number ignored{};
            read(i < N ? values[i] : ignored);
        });
        if (ok() && count != N)
            failCount(count, N);
    }
    /// Fails if anything but white space follows.
    void finish();

    /// Fails with the message "file: path: what".
    void fail(const QString &what);
    /// Fails at a member of the current object.
    void failMember(std::string_view member, const QString &what);
    /// Fails with the message "file: line L, column C: what" at the present position.
    void failSyntax(const QString &what);

private:
    struct Step {
        std::string_view name; ///< empty: an element of an array
        std::size_t index = 0;
    };

    void skipSpace();
    bool open(char bracket);
    bool nextItem(char closing, bool first);
    int memberName(std::span<const std::string_view> names, std::uint32_t found);
    bool readText(std::string &text);
    bool numberToken(std::string_view &token);
    std::string_view valueToken() const;
    void failType(const QString &wanted);
    void failCount(std::size_t count, std::size_t wanted);
    template <typename Number>
    void readFloating(Number &value);
    QString pathText() const;

    const char *m_begin;
    const char *m_at;
    const char *m_end;
    QString m_fileName;
    QString m_error;
    std::vector<Step> m_path;
    std::string m_text;
};

} // namespace suffuse

// A pull parser for JSON whose shape is known: no tree is built, numbers are read straight into their type, and every
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

/// Reads UTF-8 JSON (RFC 8259). After the first error every call fails, so callers check once at the end.
/// Nesting is bounded by the caller's calls: unknown members are refused, never walked into.
class JsonReader {
public:
    /// `bytes` must live as long as the reader. A byte order mark is skipped.
    JsonReader(const QByteArray &bytes, const QString &fileName);

    bool ok() const { return m_error.isEmpty(); }
    const QString &error() const { return m_error; }
    const QString &fileName() const { return m_fileName; }

    /// Reads an object; calls `handler(k)` with the reader before the value of member names[k]. Unknown and repeated
    /// members are errors. Returns the set of members found (bit k), 0 after an error. At most 32 names.
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

    /// Reads an array; calls `handler(i)` before each element. Returns the number of elements.
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

    /// Numbers: the nearest value of the type, straight from the decimal digits; too large is an error, too small is 0.
    void read(float &value);
    void read(double &value);
    void read(bool &value);
    void read(QString &value);
    /// Whole numbers from 0 on.
    void read(std::uint64_t &value);
    /// Seconds, at most ±1e12; decimals of up to six places are exact.
    void readSeconds(Microseconds &value);
    /// Consumes null if it is next.
    bool skipNull();
    /// An array of exactly N numbers.
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
    /// Nothing but white space may follow.
    void finish();

    /// Fails with "file: path: what".
    void fail(const QString &what);
    /// Fails at a member of the current object.
    void failMember(std::string_view member, const QString &what);
    /// Fails with "file: line L, column C: what" at the reading position.
    void failSyntax(const QString &what);

private:
    struct Step {
        std::string_view name; ///< empty: an element
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

#pragma once

#include <QString>

#include <optional>
#include <utility>

namespace suffuse {

/// A message that a person can act on: what failed, where (file, member path), what to do.
struct Error {
    QString message;
};

/// A value or an error. No exceptions cross folders.
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_value(std::move(value)) {}
    Result(Error error) : m_error(std::move(error)) {}

    explicit operator bool() const { return m_value.has_value(); }
    T &operator*() { return *m_value; }
    const T &operator*() const { return *m_value; }
    T *operator->() { return &*m_value; }
    const T *operator->() const { return &*m_value; }
    const QString &error() const { return m_error.message; }

private:
    std::optional<T> m_value;
    Error m_error;
};

/// For calls that return nothing but may fail.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : m_error(std::move(error)) {}

    explicit operator bool() const { return !m_error.has_value(); }
    QString error() const { return m_error ? m_error->message : QString(); }

private:
    std::optional<Error> m_error;
};

} // namespace suffuse

// What stands at a place of a JSON text (RFC 8259) in UTF-8: where it ends, and what it means.
#pragma once

#include "model/painting/segment.h"

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::json {

/// A value as far as messages show it, or a word such as true and null. `at` must be behind white space.
std::string_view valueAt(const char *at, const char *end);

/// The number at a place; empty if there is none, or if something else follows it at once.
std::string_view numberAt(const char *at, const char *end);
/// Whether a number that no double or float can hold is too large (and not too small).
bool isTooLarge(std::string_view number);
/// The seconds of a number; no value beyond ±1e12. Decimals of up to six places are exact.
std::optional<Microseconds> secondsOf(std::string_view number);

/// How a string ends: with its quote, or at what cannot be read.
enum class StringEnd { Quote, EndOfFile, ControlCharacter, WrongEscape };

/// Reads a string into `text`. `at` must be behind the opening quote. Afterwards it is behind the closing one, or at
/// what cannot be read. `escape` gets the letter of the escape that was read last.
StringEnd readString(const char *&at, const char *end, std::string &text, char &escape);

} // namespace suffuse::json

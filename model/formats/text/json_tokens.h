// What stands at a place of a JSON text (RFC 8259) in UTF-8: where it ends, and what it means.
#pragma once

#include "model/painting/segment.h"

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::json {

/// A value, as far as messages show it, or a word as true and null; `at` is behind white space.
std::string_view valueAt(const char *at, const char *end);

/// The number that stands there; empty if none does, or something else follows it at once.
std::string_view numberAt(const char *at, const char *end);
/// Of a number that no double or float can hold: is it too large (rather than too small)?
bool isTooLarge(std::string_view number);
/// None beyond ±1e12; decimals of up to six places are exact.
std::optional<Microseconds> secondsOf(std::string_view number);

/// How a string ends: as it should, or where it cannot be read.
enum class StringEnd { Quote, EndOfFile, ControlCharacter, WrongEscape };

/// Reads a string into `text`. `at`: behind the opening quote, and afterwards behind the closing one, or where it
/// cannot be read. `escape`: the letter of the escape that was read last.
StringEnd readString(const char *&at, const char *end, std::string &text, char &escape);

} // namespace suffuse::json

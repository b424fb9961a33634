// Styles, mixing and colours as JSON, which are the same in the text form and in brush files.
#pragma once

#include "model/formats/text/json_reader.h"

namespace suffuse {

/// The bit of a member of a name table in what JsonReader::object returns.
constexpr std::uint32_t memberBit(int k)
{
    return 1u << k;
}
/// Fails at the first of the `wanted` members that was not found.
void requireMembers(JsonReader &json, std::uint32_t found, std::span<const std::string_view> names,
                    std::uint32_t wanted);
/// Reads one of a few words. Returns its position in `words`.
int readChoice(JsonReader &json, std::span<const std::string_view> words);

void readJson(JsonReader &json, Colour &colour);
void readJson(JsonReader &json, Style &style);
void readJson(JsonReader &json, Mix &mix);

void appendJson(QByteArray &out, const Colour &colour);
void appendJson(QByteArray &out, const Style &style);
void appendJson(QByteArray &out, const Mix &mix);

} // namespace suffuse

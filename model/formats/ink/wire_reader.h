// Messages of Protocol Buffers as JSON objects, for readers that know both.
#pragma once

#include <QByteArray>
#include <QJsonObject>

#include <optional>
#include <span>

namespace suffuse {

/// What a field of a message holds. Identifiers are bytes in the file, and letters of base 16 here.
enum class WireKind { Text, Identifier, Whole, Signed, Float, Double, Message };

struct WireField {
    int number = 0;
    const char *name = nullptr;
    WireKind kind = WireKind::Text;
    bool isList = false;
    std::span<const WireField> message = {}; ///< of a message
};

/// The fields of a message that are asked for; others are passed over. `budget` is how many values may still be made of
/// the file, and is counted down: packed numbers take much more memory than bytes. No value where the message is
/// damaged, too deep, or beyond the budget, which then is below zero.
std::optional<QJsonObject> readWire(QByteArrayView bytes, std::span<const WireField> fields, qint64 &budget);

} // namespace suffuse

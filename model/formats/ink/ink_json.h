// What the two JSON recordings share: a parsed tree and errors with a path.
#pragma once

#include "model/formats/ink/recording.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace suffuse {

/// The top object of a JSON file; errors give line and column.
Result<QJsonObject> parseJsonObject(const QByteArray &bytes, const QString &fileName);
/// Finite numbers of a list; `path` names it in the message. Numbers beyond ±1e15 are refused.
Result<std::vector<double>> numbersIn(const QJsonValue &list, const QString &fileName, const QString &path);

} // namespace suffuse

// What the readers of JSON recordings share: a parsed tree, and errors with a path.
#pragma once

#include "model/formats/ink/recording.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace suffuse {

/// The top object of a JSON file. Errors give line and column.
Result<QJsonObject> parseJsonObject(const QByteArray &bytes, const QString &fileName);
/// The numbers of a list, which must be finite and within ±1e15. `path` names the list in messages.
Result<std::vector<double>> numbersIn(const QJsonValue &list, const QString &fileName, const QString &path);

} // namespace suffuse

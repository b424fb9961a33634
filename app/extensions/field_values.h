// The values of an extension's fields: what they may be, and how they are written.
#pragma once

#include "app/extensions/extension.h"
#include "model/result.h"

#include <QJsonObject>

namespace suffuse {

/// What each field has where nobody chose anything, by the fields' ids.
QJsonObject usualValues(const Extension &extension);

/// Empty if a field may have the value; otherwise a text such as "12 is not in [0, 10]".
QString problemOfValue(const ExtensionField &field, const QJsonValue &value);
/// The same of all fields, as "Label: what"; a file that must be chosen is missing, too. `language`: of the labels.
QString problemOfValues(const Extension &extension, const QJsonObject &values, const QString &language);

/// A value as text, as it is typed on the command line and kept in the settings: "3.5", "true", "a,b,c,d".
QString textOfValue(const QJsonValue &value);
/// The value that a text stands for. The error does not name the field.
Result<QJsonValue> valueOfText(const ExtensionField &field, const QString &text);

/// The field with an id; null where there is none.
const ExtensionField *fieldOf(const Extension &extension, const QString &id);

} // namespace suffuse

#include "app/extensions/field_values.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr int longestText = 30'000; // It must fit into a variable of the environment.

QString shown(double number)
{
    return QLocale::c().toString(number, 'g', QLocale::FloatingPointShortest);
}

QString problemOfColour(const QJsonValue &value)
{
    const QJsonArray parts = value.toArray();
    const auto isShare = [](const QJsonValue &part) {
        return part.isDouble() && part.toDouble() >= 0 && part.toDouble() <= 1;
    };
    if (parts.size() == 4 && std::all_of(parts.begin(), parts.end(), isShare))
        return {};
    return ExtensionMessages::tr("a colour is red, yellow, blue and opacity, each from 0 to 1");
}

} // namespace

QJsonObject usualValues(const Extension &extension)
{
    QJsonObject values;
    for (const ExtensionField &field : extension.fields)
        values[field.id] = field.usual;
    return values;
}

QString problemOfValue(const ExtensionField &field, const QJsonValue &value)
{
    using Type = ExtensionField::Type;
    switch (field.type) {
    case Type::Number:
    case Type::Whole: {
        const double number = value.toDouble(NAN);
        if (!value.isDouble() || !std::isfinite(number))
            return ExtensionMessages::tr("give a number");
        if (number < field.least || number > field.most)
            return ExtensionMessages::tr("%1 is not in [%2, %3]")
                .arg(shown(number), shown(field.least), shown(field.most));
        if (field.type == Type::Whole && number != std::round(number))
            return ExtensionMessages::tr("%1 is no whole number").arg(shown(number));
        return {};
    }
    case Type::Choice: {
        QStringList known;
        for (const ExtensionField::Choice &choice : field.choices)
            known << choice.id;
        if (value.isString() && known.contains(value.toString()))
            return {};
        return ExtensionMessages::tr("“%1” is none of %2").arg(value.toString(), known.join(QStringLiteral(", ")));
    }
    case Type::Switch:
        return value.isBool() ? QString() : ExtensionMessages::tr("give true or false");
    case Type::Text:
        if (value.isString() && value.toString().size() <= longestText && !value.toString().contains(QChar(0)))
            return {};
        return ExtensionMessages::tr("give a text of at most %1 characters").arg(longestText);
    case Type::Colour:
        return problemOfColour(value);
    case Type::File:
        break;
    }
    const QString path = value.toString();
    if (path.isEmpty())
        return ExtensionMessages::tr("choose a file");
    const QFileInfo file(path);
    if (!field.endings.isEmpty() &&
        std::none_of(field.endings.begin(), field.endings.end(),
                     [&](const QString &ending) { return path.endsWith('.' + ending, Qt::CaseInsensitive); }))
        return ExtensionMessages::tr("%1: the name must end with .%2")
            .arg(path, field.endings.join(QStringLiteral(", .")));
    if (!field.saves && !file.isFile())
        return ExtensionMessages::tr("%1: there is no such file").arg(path);
    if (field.saves && (file.isDir() || !QFileInfo(file.absolutePath()).isDir()))
        return ExtensionMessages::tr("%1: there is no such folder").arg(path);
    return {};
}

QString problemOfValues(const Extension &extension, const QJsonObject &values, const QString &language)
{
    for (const ExtensionField &field : extension.fields)
        if (const QString problem = problemOfValue(field, values[field.id]); !problem.isEmpty())
            return QStringLiteral("%1: %2").arg(field.label.in(language), problem);
    return {};
}

QString textOfValue(const QJsonValue &value)
{
    if (value.isBool())
        return value.toBool() ? QStringLiteral("true") : QStringLiteral("false");
    if (value.isDouble())
        return shown(value.toDouble());
    if (!value.isArray())
        return value.toString();
    QStringList parts;
    for (const QJsonValue &part : value.toArray())
        parts << shown(part.toDouble());
    return parts.join(',');
}

Result<QJsonValue> valueOfText(const ExtensionField &field, const QString &text)
{
    using Type = ExtensionField::Type;
    QJsonValue value = text;
    bool ok = true;
    if (field.type == Type::Number || field.type == Type::Whole) {
        value = QLocale::c().toDouble(text, &ok);
        if (!ok)
            return Error{ExtensionMessages::tr("“%1” is no number").arg(text)};
    } else if (field.type == Type::Switch) {
        if (text != QLatin1String("true") && text != QLatin1String("false"))
            return Error{ExtensionMessages::tr("“%1” is neither true nor false").arg(text)};
        value = text == QLatin1String("true");
    } else if (field.type == Type::Colour) {
        QJsonArray parts;
        for (const QString &part : text.split(',')) {
            bool isNumber = false;
            parts.append(QLocale::c().toDouble(part, &isNumber));
            ok = ok && isNumber;
        }
        if (!ok)
            return Error{problemOfColour({})};
        value = parts;
    }
    if (const QString problem = problemOfValue(field, value); !problem.isEmpty())
        return Error{problem};
    return value;
}

const ExtensionField *fieldOf(const Extension &extension, const QString &id)
{
    const auto at = std::ranges::find(extension.fields, id, &ExtensionField::id);
    return at == extension.fields.end() ? nullptr : &*at;
}

} // namespace suffuse

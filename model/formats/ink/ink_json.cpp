#include "model/formats/ink/ink_json.h"

#include <cmath>

namespace suffuse {

Result<QJsonObject> parseJsonObject(const QByteArray &bytes, const QString &fileName)
{
    QJsonParseError problem;
    const QJsonDocument json = QJsonDocument::fromJson(bytes, &problem);
    if (problem.error != QJsonParseError::NoError)
        return fileError(fileName, placeOf(bytes, problem.offset) + QStringLiteral(": ") + problem.errorString());
    if (!json.isObject())
        return fileError(fileName, FileMessages::tr("is not a JSON object"));
    return json.object();
}

Result<std::vector<double>> numbersIn(const QJsonValue &list, const QString &fileName, const QString &path)
{
    if (!list.isArray())
        return fileError(fileName, path + FileMessages::tr(": is not a list of numbers"));
    const QJsonArray array = list.toArray();
    std::vector<double> numbers;
    numbers.reserve(std::size_t(array.size()));
    for (qsizetype k = 0; k < array.size(); ++k) {
        const QJsonValue value = array.at(k);
        const double number = value.toDouble();
        if (!value.isDouble() || !(std::abs(number) <= 1e15))
            return fileError(fileName, FileMessages::tr("%1[%2]: is not a number within ±1e15").arg(path).arg(k));
        numbers.push_back(number);
    }
    return numbers;
}

} // namespace suffuse

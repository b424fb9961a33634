#include "model/formats/ink/universal_container.h"

#include "model/formats/ink/wire_reader.h"
#include "model/formats/messages.h"

#include <QJsonArray>
#include <QtEndian>

#include <algorithm>
#include <cmath>

namespace suffuse {

namespace {

constexpr qint64 mostWireValues = qint64(1) << 23; ///< that are made of a file
constexpr qsizetype riffName = 4, riffHead = 8;
constexpr qsizetype versionSize = 3; ///< and a byte that means nothing

/// What of the messages is read. Identifiers are texts in version 3.0, and bytes in 3.1.
struct UniversalSchema {
    using enum WireKind;
    static constexpr WireField channel30[] = {
        {1, "id"}, {2, "type"}, {4, "resolution", Double}, {7, "precision", Whole}};
    static constexpr WireField channels30[] = {{2, "channels", Message, true, channel30}};
    static constexpr WireField context30[] = {{2, "sensorChannelsContext", Message, true, channels30}};
    static constexpr WireField contexts30[] = {{5, "sensorContexts", Message, true, context30}};
    static constexpr WireField values30[] = {{1, "sensorChannelID"}, {2, "values", Signed, true}};
    static constexpr WireField sensor30[] = {
        {1, "id"}, {4, "timestamp", Whole}, {5, "dataChannels", Message, true, values30}};
    static constexpr WireField input30[] = {{1, "inputContextData", Message, false, contexts30},
                                            {2, "sensorData", Message, true, sensor30}};
    static constexpr WireField number30[] = {{1, "value", Float}};
    static constexpr WireField properties30[] = {{1, "size", Message, false, number30},
                                                 {2, "red", Message, false, number30},
                                                 {3, "green", Message, false, number30},
                                                 {4, "blue", Message, false, number30},
                                                 {5, "alpha", Message, false, number30}};
    static constexpr WireField style30[] = {{1, "properties", Message, false, properties30}, {2, "brushURI"}};
    static constexpr WireField stroke30[] = {
        {4, "splineX", Float, true},   {5, "splineY", Float, true},  {11, "size", Float, true},
        {12, "rotation", Float, true}, {13, "scaleX", Float, true},  {14, "scaleY", Float, true},
        {15, "scaleZ", Float, true},   {16, "offsetX", Float, true}, {17, "offsetY", Float, true},
        {18, "offsetZ", Float, true},  {20, "sensorDataID"},         {22, "style", Message, false, style30}};
    static constexpr WireField ink30[] = {{1, "strokes", Message, true, stroke30}};
    static constexpr WireField prototype[] = {{5, "shapeURI"}};
    static constexpr WireField vectorBrush[] = {{1, "name"}, {2, "prototype", Message, true, prototype}};
    static constexpr WireField rasterBrush[] = {{1, "name"}};
    static constexpr WireField brushes[] = {{1, "vectorBrushes", Message, true, vectorBrush},
                                            {2, "rasterBrushes", Message, true, rasterBrush}};
    static constexpr WireField view[] = {{1, "name"}};
    static constexpr WireField object30[] = {{1, "inputData", Message, false, input30},
                                             {2, "inkData", Message, false, ink30},
                                             {3, "brushes", Message, false, brushes},
                                             {5, "views", Message, true, view}};

    static constexpr WireField channel31[] = {
        {1, "id", Identifier}, {2, "type"}, {4, "resolution", Double}, {7, "precision", Whole}};
    static constexpr WireField channels31[] = {{2, "channels", Message, true, channel31}};
    static constexpr WireField context31[] = {{2, "sensorChannelsContext", Message, true, channels31}};
    static constexpr WireField contexts31[] = {{5, "sensorContexts", Message, true, context31}};
    static constexpr WireField values31[] = {{1, "sensorChannelID", Identifier}, {2, "values", Signed, true}};
    static constexpr WireField sensor31[] = {
        {1, "id", Identifier}, {4, "timestamp", Whole}, {5, "dataChannels", Message, true, values31}};
    static constexpr WireField input31[] = {{1, "inputContextData", Message, false, contexts31},
                                            {2, "sensorData", Message, true, sensor31}};
    static constexpr WireField properties31[] = {{1, "color", Signed}, {2, "size", Float}};
    static constexpr WireField spline31[] = {{1, "splineX", Float, true},  {2, "splineY", Float, true},
                                             {8, "size", Float, true},     {9, "rotation", Float, true},
                                             {10, "scaleX", Float, true},  {11, "scaleY", Float, true},
                                             {12, "scaleZ", Float, true},  {13, "offsetX", Float, true},
                                             {14, "offsetY", Float, true}, {15, "offsetZ", Float, true}};
    static constexpr WireField packed31[] = {{1, "splineX", Signed, true},  {2, "splineY", Signed, true},
                                             {8, "size", Signed, true},     {9, "rotation", Signed, true},
                                             {10, "scaleX", Signed, true},  {11, "scaleY", Signed, true},
                                             {12, "scaleZ", Signed, true},  {13, "offsetX", Signed, true},
                                             {14, "offsetY", Signed, true}, {15, "offsetZ", Signed, true}};
    static constexpr WireField stroke31[] = {{2, "precisions", Signed},
                                             {5, "splineData", Message, false, spline31},
                                             {6, "splineCompressed", Message, false, packed31},
                                             {7, "propertiesIndex", Whole},
                                             {8, "propertiesValue", Message, false, properties31},
                                             {9, "brushURIIndex", Whole},
                                             {10, "brushURIValue"},
                                             {15, "sensorDataID", Identifier}};
    static constexpr WireField ink31[] = {{1, "strokes", Message, true, stroke31},
                                          {4, "brushURIs", Text, true},
                                          {6, "properties", Message, true, properties31}};
    static constexpr WireField structure31[] = {{3, "views", Message, true, view}};
};

/// Where the number of decimals of a column stands in the precisions of a stroke, bits from the end.
int shiftOf(const QString &column)
{
    if (column.startsWith(QLatin1String("spline")))
        return 0;
    if (column == QLatin1String("size"))
        return 4;
    if (column == QLatin1String("rotation"))
        return 8;
    return column.startsWith(QLatin1String("scale")) ? 12 : 16;
}

/// The columns of a stroke whose values are differences of whole numbers.
QJsonObject unpackedColumns(const QJsonObject &packed, qint64 precisions)
{
    QJsonObject columns;
    for (auto it = packed.begin(); it != packed.end(); ++it) {
        const double unit = std::pow(10.0, -double(precisions >> shiftOf(it.key()) & 15));
        QJsonArray values;
        double sum = 0;
        for (const QJsonValue &difference : it.value().toArray())
            values.append((sum += difference.toDouble()) * unit);
        columns.insert(it.key(), values);
    }
    return columns;
}

QJsonObject wrapped(double value)
{
    return {{QLatin1String("value"), value}};
}

/// Version 3.1 has all of a colour in one number.
QJsonObject propertiesAs30(const QJsonObject &properties)
{
    const auto colour = quint32(qint64(properties.value(QLatin1String("color")).toDouble()));
    const auto channel = [&](int shift) { return wrapped(double(colour >> shift & 255) / 255); };
    return {{QLatin1String("red"), channel(24)},
            {QLatin1String("green"), channel(16)},
            {QLatin1String("blue"), channel(8)},
            {QLatin1String("alpha"), channel(0)},
            {QLatin1String("size"), wrapped(properties.value(QLatin1String("size")).toDouble())}};
}

/// The value with a number that counts from 1, or else the one that stands in its place.
QJsonValue chosen(const QJsonArray &all, const QJsonObject &stroke, const char *index, const char *value)
{
    const double at = stroke.value(QLatin1String(index)).toDouble();
    return at >= 1 && at <= double(all.size()) ? all.at(qsizetype(at) - 1) : stroke.value(QLatin1String(value));
}

QJsonObject inkAs30(const QJsonObject &ink)
{
    const QJsonArray properties = ink.value(QLatin1String("properties")).toArray(),
                     uris = ink.value(QLatin1String("brushURIs")).toArray();
    QJsonArray strokes;
    for (const QJsonValue &value : ink.value(QLatin1String("strokes")).toArray()) {
        const QJsonObject from = value.toObject();
        QJsonObject stroke = from.value(QLatin1String("splineData")).toObject();
        if (stroke.value(QLatin1String("splineX")).toArray().isEmpty())
            stroke = unpackedColumns(from.value(QLatin1String("splineCompressed")).toObject(),
                                     qint64(from.value(QLatin1String("precisions")).toDouble()));
        const QJsonValue look = chosen(properties, from, "propertiesIndex", "propertiesValue");
        QJsonObject style{{QLatin1String("brushURI"), chosen(uris, from, "brushURIIndex", "brushURIValue").toString()}};
        if (look.isObject())
            style.insert(QLatin1String("properties"), propertiesAs30(look.toObject()));
        stroke.insert(QLatin1String("style"), style);
        stroke.insert(QLatin1String("sensorDataID"), from.value(QLatin1String("sensorDataID")));
        strokes.append(stroke);
    }
    return {{QLatin1String("strokes"), strokes}};
}

class UniversalContainer {
public:
    explicit UniversalContainer(const QByteArray &bytes) : m_rest(QByteArrayView(bytes).sliced(riffHead + riffName)) {}

    Result<QJsonObject> read()
    {
        const auto [name, head] = chunk();
        if (name != "HEAD" || head.size() < versionSize)
            return damaged();
        const int major = head[0], minor = head[1];
        if (major != 3 || minor < 0 || minor > 1)
            return Error{
                FileMessages::tr("is Universal Ink %1.%2; 3.0 and 3.1 can be read").arg(major).arg(int(uchar(minor)))};
        return minor == 0 ? readObject() : readChunks(head.sliced(std::min(versionSize + 1, head.size())));
    }

private:
    struct RiffPart {
        QByteArrayView name, content;
    };

    /// The next chunk, without a name where there is no whole one.
    RiffPart chunk()
    {
        if (m_rest.size() < riffHead)
            return {};
        const auto size = qint64(qFromLittleEndian<quint32>(m_rest.data() + riffName));
        if (size > m_rest.size() - riffHead)
            return {};
        const RiffPart chunk{m_rest.first(riffName), m_rest.sliced(riffHead, size)};
        m_rest = m_rest.sliced(std::min<qint64>(riffHead + size + (size & 1), m_rest.size()));
        return chunk;
    }

    Error damaged() const
    {
        if (m_budget < 0)
            return Error{FileMessages::tr("has more than %1 numbers").arg(mostWireValues)};
        return Error{FileMessages::tr("is damaged: a part of it is not whole")};
    }

    Result<QJsonObject> readObject()
    {
        const auto [name, content] = chunk();
        auto object = readWire(content, UniversalSchema::object30, m_budget);
        return name == "DATA" && object ? Result<QJsonObject>(std::move(*object)) : damaged();
    }

    /// `described` has eight bytes for each chunk: its version, how it is written, and how it is packed.
    Result<QJsonObject> readChunks(QByteArrayView described)
    {
        constexpr qsizetype description = 8;
        QJsonObject object;
        for (; described.size() >= description; described = described.sliced(description)) {
            const auto [name, content] = chunk();
            if (name.isEmpty())
                return damaged();
            if (described[3] != 1 || described[4] != 0)
                return Error{FileMessages::tr("its part %1 is packed in a way that cannot be read")
                                 .arg(excerpt({name.data(), std::size_t(name.size())}))};
            if (!take(name, content, object))
                return damaged();
        }
        return object;
    }

    bool take(QByteArrayView name, QByteArrayView content, QJsonObject &object)
    {
        const auto put = [&](const char *key, std::span<const WireField> fields) {
            const auto read = readWire(content, fields, m_budget);
            if (read)
                object.insert(QLatin1String(key), *read);
            return read.has_value();
        };
        if (name == "INPT")
            return put("inputData", UniversalSchema::input31);
        if (name == "BRSH")
            return put("brushes", UniversalSchema::brushes);
        if (name == "INKD") {
            const auto ink = readWire(content, UniversalSchema::ink31, m_budget);
            if (ink)
                object.insert(QLatin1String("inkData"), inkAs30(*ink));
            return ink.has_value();
        }
        if (name == "INKS") {
            const auto structure = readWire(content, UniversalSchema::structure31, m_budget);
            if (structure)
                object.insert(QLatin1String("views"), structure->value(QLatin1String("views")));
            return structure.has_value();
        }
        return true;
    }

    QByteArrayView m_rest;
    qint64 m_budget = mostWireValues;
};

} // namespace

bool isUniversalContainer(const QByteArray &bytes)
{
    return bytes.startsWith("RIFF") && bytes.size() >= riffHead + riffName &&
           bytes.sliced(riffHead, riffName) == "UINK";
}

Result<QJsonObject> unpackedUniversal(const QByteArray &bytes)
{
    return UniversalContainer(bytes).read();
}

} // namespace suffuse

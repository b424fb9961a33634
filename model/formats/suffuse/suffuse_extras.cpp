#include "model/formats/suffuse/suffuse_extras.h"

#include "model/formats/messages.h"
#include "model/formats/suffuse/suffuse_cbor.h"
#include "model/painting/resolution.h"

#include <cmath>

namespace suffuse {

namespace {

constexpr double largestCoordinate = 1e12;
constexpr Microseconds largestTime = 1'000'000'000'000'000;

constexpr qsizetype longestName = 200; ///< characters that are read of a layer's

QCborMap writeBegun(const BegunLayer &layer)
{
    QCborMap map{{QLatin1String("name"), layer.name}};
    if (layer.clips)
        map.insert(QLatin1String("clips"), true);
    if (layer.parent != 0)
        map.insert(QLatin1String("parent"), qint64(layer.parent));
    if (layer.above != 0)
        map.insert(QLatin1String("above"), qint64(layer.above));
    return map;
}

std::optional<BegunLayer> readBegun(const QCborValue &value)
{
    if (!value.isMap())
        return std::nullopt;
    const QCborMap map = value.toMap();
    const auto group = [&](QLatin1String key) { return GroupId(integerIn(map[key])); };
    return BegunLayer{map[QLatin1String("name")].toString().left(longestName), map[QLatin1String("clips")].toBool(),
                      group(QLatin1String("parent")), group(QLatin1String("above"))};
}

constexpr int mostGuides = 1000; ///< that are read
constexpr int mostAssistants = 100;

QCborMap writeSymmetry(const Symmetry &symmetry)
{
    return {{QLatin1String("on"), symmetry.isOn},
            {QLatin1String("kind"), int(symmetry.kind)},
            {QLatin1String("centre"), QCborArray{symmetry.centre.x, symmetry.centre.y}},
            {QLatin1String("angle"), symmetry.angle},
            {QLatin1String("arms"), symmetry.arms}};
}

std::optional<Symmetry> readSymmetry(const QCborValue &value)
{
    if (!value.isMap())
        return std::nullopt;
    bool ok = true;
    Symmetry symmetry;
    MapReader in(value, ok);
    in.read("on", symmetry.isOn);
    in.read("angle", symmetry.angle);
    const qint64 kind = integerIn(in.take("kind")), arms = integerIn(in.take("arms"), symmetry.arms);
    const QCborArray centre = in.take("centre").toArray();
    symmetry.centre = {centre.at(0).toDouble(), centre.at(1).toDouble()};
    ok = ok && kind >= 0 && kind <= int(SymmetryKind::Kaleidoscope) && arms >= Symmetry::leastArms &&
         arms <= Symmetry::mostArms && centre.size() == 2 && std::abs(symmetry.centre.x) <= largestCoordinate &&
         std::abs(symmetry.centre.y) <= largestCoordinate && std::abs(symmetry.angle) <= largestCoordinate;
    symmetry.kind = SymmetryKind(kind);
    symmetry.arms = int(arms);
    return ok ? std::optional(symmetry) : std::nullopt;
}

QCborArray writePlaces(const std::vector<Guide> &guides, bool upright)
{
    QCborArray places;
    for (const Guide &guide : guides)
        if (guide.upright == upright)
            places.append(guide.place);
    return places;
}

/// Numbers that are none, or too large, are passed over.
void readPlaces(const QCborValue &value, bool upright, std::vector<Guide> &guides)
{
    for (const QCborValue &place : value.toArray())
        if (const double at = place.toDouble(std::nan("")); std::abs(at) <= largestCoordinate && guides.size() < mostGuides)
            guides.push_back({upright, at});
}

/// Each is a list of its kind and the coordinates of its points.
QCborArray writeAssistants(const std::vector<Assistant> &assistants)
{
    QCborArray list;
    for (const Assistant &assistant : assistants) {
        QCborArray numbers{int(assistant.kind)};
        for (const Point &point : assistant.points) {
            numbers.append(point.x);
            numbers.append(point.y);
        }
        list.append(numbers);
    }
    return list;
}

/// Those of a kind that is not known, without all of their points, or with numbers that are none are passed over.
std::vector<Assistant> readAssistants(const QCborValue &value)
{
    std::vector<Assistant> assistants;
    for (const QCborValue &item : value.toArray()) {
        const QCborArray numbers = item.toArray();
        const qint64 kind = integerIn(numbers.at(0), -1);
        if (kind < 0 || kind > int(AssistantKind::Concentric) || assistants.size() == mostAssistants)
            continue;
        Assistant assistant{AssistantKind(kind), {}};
        if (numbers.size() != 1 + 2 * qsizetype(Assistant::pointsOf(assistant.kind)))
            continue;
        for (qsizetype i = 1; i < numbers.size(); i += 2)
            assistant.points.push_back(
                {numbers.at(i).toDouble(std::nan("")), numbers.at(i + 1).toDouble(std::nan(""))});
        if (assistant.isSound())
            assistants.push_back(std::move(assistant));
    }
    return assistants;
}

QCborMap writePrint(const PrintSetup &print)
{
    QCborArray margins;
    for (const double margin : print.margins)
        margins.append(margin);
    QCborMap map{{QLatin1String("paper"), print.paper},
                 {QLatin1String("landscape"), print.landscape},
                 {QLatin1String("margins"), margins},
                 {QLatin1String("size"), int(print.size)},
                 {QLatin1String("scale"), print.scale},
                 {QLatin1String("area"), int(print.area)},
                 {QLatin1String("moment"), int(print.moment)},
                 {QLatin1String("background"), print.background},
                 {QLatin1String("dpi"), print.dpi}};
    if (print.area == PrintSetup::Area::Numbers)
        map.insert(QLatin1String("numbers"), QCborArray{print.numbers.left, print.numbers.top, print.numbers.right,
                                                        print.numbers.bottom});
    if (print.moment == PrintSetup::Moment::Time)
        map.insert(QLatin1String("time"), qint64(print.time));
    return map;
}

/// Numbers of a list that has so many of them; no value where one is none, or too large.
template <std::size_t count>
std::optional<std::array<double, count>> numbersOf(const QCborValue &value, double least, double most)
{
    const QCborArray list = value.toArray();
    std::array<double, count> numbers;
    if (list.size() != qsizetype(count))
        return std::nullopt;
    for (std::size_t k = 0; k < count; ++k) {
        numbers[k] = list.at(qsizetype(k)).toDouble(std::nan(""));
        if (!(numbers[k] >= least && numbers[k] <= most))
            return std::nullopt;
    }
    return numbers;
}

std::optional<PrintSetup> readPrint(const QCborValue &value)
{
    if (!value.isMap())
        return std::nullopt;
    bool ok = true;
    PrintSetup print;
    MapReader in(value, ok);
    const auto choice = [&](const char *name, auto &chosen, auto last) {
        const qint64 number = integerIn(in.take(name));
        ok = ok && number >= 0 && number <= qint64(last);
        if (ok)
            chosen = std::remove_reference_t<decltype(chosen)>(number);
    };
    in.read("paper", print.paper);
    in.read("landscape", print.landscape);
    in.read("scale", print.scale);
    in.read("background", print.background);
    choice("size", print.size, PrintSetup::Size::Scaled);
    choice("area", print.area, PrintSetup::Area::Numbers);
    choice("moment", print.moment, PrintSetup::Moment::Time);
    choice("dpi", print.dpi, PrintSetup::mostDpi);
    const auto margins = numbersOf<4>(in.take("margins"), 0, PrintSetup::mostMargin);
    ok = ok && margins && print.paper.size() <= longestName && print.scale >= PrintSetup::leastScale &&
         print.scale <= PrintSetup::mostScale && (print.dpi == 0 || print.dpi >= PrintSetup::leastDpi);
    if (!ok)
        return std::nullopt;
    print.margins = *margins;
    if (print.area == PrintSetup::Area::Numbers) {
        const auto sides = numbersOf<4>(in.take("numbers"), -largestCoordinate, largestCoordinate);
        if (!sides || !((*sides)[2] > (*sides)[0] && (*sides)[3] > (*sides)[1]))
            return std::nullopt;
        print.numbers = {(*sides)[0], (*sides)[1], (*sides)[2], (*sides)[3]};
    }
    if (print.moment == PrintSetup::Moment::Time)
        print.time = std::clamp<Microseconds>(integerIn(in.take("time")), -largestTime, largestTime);
    return print;
}

QByteArray writeView(const WorkspaceState &view)
{
    QCborMap map;
    if (!view.isFitted)
        map = {{QLatin1String("centre"), QCborArray{view.centre.x, view.centre.y}},
               {QLatin1String("scale"), view.scale},
               {QLatin1String("rotation"), view.rotation},
               {QLatin1String("mirrored"), view.mirrored}};
    if (view.time)
        map.insert(QLatin1String("time"), qint64(*view.time));
    if (view.layer != 0)
        map.insert(QLatin1String("layer"), qint64(view.layer));
    if (!view.open.empty()) {
        QCborArray open;
        for (const GroupId group : view.open)
            open.append(qint64(group));
        map.insert(QLatin1String("open"), open);
    }
    if (view.begun)
        map.insert(QLatin1String("begun"), writeBegun(*view.begun));
    if (view.symmetry)
        map.insert(QLatin1String("symmetry"), writeSymmetry(*view.symmetry));
    if (!view.guides.empty())
        map.insert(QLatin1String("guides"), QCborMap{{QLatin1String("level"), writePlaces(view.guides, false)},
                                                     {QLatin1String("upright"), writePlaces(view.guides, true)}});
    if (!view.assistants.empty())
        map.insert(QLatin1String("assistants"), writeAssistants(view.assistants));
    if (view.print)
        map.insert(QLatin1String("print"), writePrint(*view.print));
    return QCborValue(map).toCbor();
}

std::optional<WorkspaceState> readView(QByteArrayView payload)
{
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(payload.data(), payload.size(), &problem);
    if (problem.error != QCborError::NoError) // Nothing of CBOR that is not whole may be looked into.
        return std::nullopt;
    WorkspaceState view;
    bool ok = true;
    MapReader in(value, ok);
    const QCborValue point = in.take("centre");
    const QCborArray centre = point.toArray();
    view.isFitted = point.isUndefined();
    view.centre = {centre.at(0).toDouble(), centre.at(1).toDouble()};
    in.read("scale", view.scale);
    in.read("rotation", view.rotation);
    in.read("mirrored", view.mirrored);
    if (const QCborValue time = in.take("time"); time.isInteger())
        view.time = std::clamp<Microseconds>(integerIn(time), -largestTime, largestTime);
    view.layer = GroupId(integerIn(in.take("layer")));
    for (const QCborValue &group : in.take("open").toArray())
        if (group.isInteger())
            view.open.push_back(GroupId(group.toInteger()));
    view.begun = readBegun(in.take("begun"));
    view.symmetry = readSymmetry(in.take("symmetry"));
    const QCborMap guides = in.take("guides").toMap();
    readPlaces(guides[QLatin1String("level")], false, view.guides);
    readPlaces(guides[QLatin1String("upright")], true, view.guides);
    view.assistants = readAssistants(in.take("assistants"));
    view.print = readPrint(in.take("print"));
    ok = ok && (view.isFitted || centre.size() == 2) && std::abs(view.centre.x) <= largestCoordinate &&
         std::abs(view.centre.y) <= largestCoordinate && view.scale > 0 && view.scale <= largestCoordinate &&
         std::abs(view.rotation) <= largestCoordinate;
    return ok ? std::optional(view) : std::nullopt;
}

/// 0 for what is no resolution.
double readResolution(QByteArrayView payload)
{
    QCborParserError problem;
    const QCborValue value = QCborValue::fromCbor(payload.data(), payload.size(), &problem);
    if (problem.error != QCborError::NoError)
        return 0;
    const double unitsOfInch = value.toDouble();
    return isResolution(unitsOfInch) ? unitsOfInch : 0;
}

} // namespace

bool isAncillary(const Chunk &chunk)
{
    return !chunk.type.isEmpty() && chunk.type.front() >= 'a' && chunk.type.front() <= 'z';
}

QString partBeside(const QByteArray &type)
{
    if (type == previewType)
        return FileMessages::tr("the preview");
    if (type == viewType)
        return FileMessages::tr("how it was last looked at");
    if (type == profileType)
        return FileMessages::tr("the colour profile");
    if (type == resolutionType)
        return FileMessages::tr("the size on paper");
    return type == historyType ? FileMessages::tr("the undo history") : QString();
}

void readExtra(const Chunk &chunk, DocumentExtras &extras)
{
    if (chunk.type == previewType) {
        if (extras.preview.isEmpty() && chunk.payload.startsWith("\x89PNG\r\n\x1a\n") &&
            chunk.payload.size() <= largestPreview)
            extras.preview = chunk.payload.toByteArray();
    } else if (chunk.type == viewType) {
        if (!extras.view)
            extras.view = readView(chunk.payload);
    } else if (chunk.type == historyType) {
        if (extras.history.isEmpty())
            extras.history = chunk.payload.toByteArray();
    } else if (chunk.type == profileType) {
        if (extras.profile.isEmpty() && chunk.payload.size() <= largestKeptProfile)
            extras.profile = chunk.payload.toByteArray();
    } else if (chunk.type == resolutionType) {
        if (extras.resolution == 0)
            extras.resolution = readResolution(chunk.payload);
    } else {
        extras.unknown.push_back({chunk.type, chunk.payload.toByteArray()});
    }
}

void appendFirstExtras(QByteArray &out, const DocumentExtras &extras)
{
    if (!extras.preview.isEmpty() && extras.preview.size() <= largestPreview)
        appendChunk(out, previewType, extras.preview);
    if (extras.view)
        appendChunk(out, viewType, writeView(*extras.view));
}

void appendLastExtras(QByteArray &out, const DocumentExtras &extras)
{
    if (!extras.profile.isEmpty() && extras.profile.size() <= largestKeptProfile)
        appendChunk(out, profileType, extras.profile);
    if (isResolution(extras.resolution))
        appendChunk(out, resolutionType, QCborValue(extras.resolution).toCbor());
    if (!extras.history.isEmpty())
        appendChunk(out, historyType, extras.history);
    for (const AncillaryChunk &chunk : extras.unknown)
        appendChunk(out, chunk.type.constData(), chunk.payload);
}

} // namespace suffuse

#include "app/cli/options.h"
#include "render/probe.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace suffuse::cli {

namespace {

struct Place {
    double x = 0;
    double y = 0;
    Microseconds time = 0;
};

template <std::size_t N>
QJsonArray arrayOf(const std::array<double, N> &values)
{
    QJsonArray out;
    for (double v : values)
        out.append(v);
    return out;
}

template <std::size_t N>
QString textOf(const std::array<double, N> &values)
{
    QStringList out;
    for (double v : values)
        out.append(QString::number(v, 'f', 6));
    return out.join(QStringLiteral(", "));
}

/// Smaller ones change nothing that could be seen; of a long stroke they are nearly all.
constexpr double leastShare = 1e-6;

/// Those that are listed.
std::vector<ProbeShare> listedOf(const ProbeStroke &s, bool all)
{
    std::vector<ProbeShare> out;
    std::copy_if(s.shares.begin(), s.shares.end(), std::back_inserter(out),
                 [all](const ProbeShare &k) { return all || (k.fades ? k.density : k.share) >= leastShare; });
    return out;
}

QJsonObject jsonOf(const ProbeStroke &s, bool all)
{
    const std::vector<ProbeShare> listed = listedOf(s, all);
    QJsonArray shares;
    for (const ProbeShare &k : listed)
        shares.append(QJsonObject{
            {"segment", k.segment}, {"density", k.density}, {"share", k.share}, {"lift", k.lifts}, {"fade", k.fades}});
    return {{"id", qint64(s.id)},
            {"name", s.name},
            {"density", s.density},
            {"lifted", s.lifted},
            {"faded", s.faded},
            {"granulation", s.granulation},
            {"modulatedDensity", s.modulated},
            {"densityFunction", s.densityFunction},
            {"colour", arrayOf(s.colour)},
            {"opacity", s.opacity},
            {"segments", shares},
            {"segmentsLeftOut", qint64(s.shares.size() - listed.size())},
            {"fill", QJsonObject{{"density", s.fillDensity}, {"share", s.fillShare}}},
            {"rybAfter", arrayOf(s.rybAfter)},
            {"rgbAfter", arrayOf(s.rgbAfter)},
            {"colourShare", s.colourShare}};
}

QJsonObject jsonOf(const Probe &probe, const Place &place, bool all)
{
    QJsonArray strokes;
    for (const ProbeStroke &s : probe.strokes)
        strokes.append(jsonOf(s, all));
    return {{"x", place.x},
            {"y", place.y},
            {"time", toSeconds(place.time)},
            {"paper", probe.paper},
            {"rybBefore", arrayOf(probe.rybBefore)},
            {"rgbBefore", arrayOf(probe.rgbBefore)},
            {"strokes", strokes},
            {"rybAfter", arrayOf(probe.rybAfter)},
            {"rgbAfter", arrayOf(probe.rgbAfter)},
            {"canvasShare", probe.canvasShare}};
}

QString textOf(const ProbeStroke &s, bool all)
{
    QString text = s.name.isEmpty() ? QCoreApplication::translate("Cli", "stroke %1").arg(s.id)
                                    : QCoreApplication::translate("Cli", "stroke %1, %2").arg(s.id).arg(s.name);
    text += QCoreApplication::translate("Cli",
                                        "\n  φ %1   ω̄ %2   φ′ %3   F %4   w %5\n  C̄ %6 (red, yellow, blue, opacity)\n"
                                        "  after it: RYB %7, RGB %8\n")
                .arg(s.density, 0, 'g', 8)
                .arg(s.granulation, 0, 'g', 8)
                .arg(s.modulated, 0, 'g', 8)
                .arg(s.densityFunction, 0, 'g', 8)
                .arg(s.opacity, 0, 'g', 8)
                .arg(textOf(s.colour), textOf(s.rybAfter), textOf(s.rgbAfter));
    const std::vector<ProbeShare> listed = listedOf(s, all);
    for (const ProbeShare &k : listed) {
        if (k.fades) {
            text += QCoreApplication::translate("Cli", "  segment %1 fades: φ %2, which leaves %3\n")
                        .arg(k.segment)
                        .arg(k.density, 0, 'g', 8)
                        .arg(std::exp(-k.density), 0, 'g', 8);
            continue;
        }
        text += (k.lifts ? QCoreApplication::translate("Cli", "  segment %1 lifts: φ %2, share %3\n")
                         : QCoreApplication::translate("Cli", "  segment %1: φ %2, share %3\n"))
                    .arg(k.segment)
                    .arg(k.density, 0, 'g', 8)
                    .arg(k.share, 0, 'g', 8);
    }
    if (s.fillDensity > 0)
        text += QCoreApplication::translate("Cli", "  fill: φ %1, share %2\n")
                    .arg(s.fillDensity, 0, 'g', 8)
                    .arg(s.fillShare, 0, 'g', 8);
    if (const std::size_t left = s.shares.size() - listed.size(); left > 0)
        text += QCoreApplication::translate("Cli", "  %n segment(s) with a share below %1 left out (--all)\n", nullptr,
                                            int(left))
                    .arg(leastShare);
    return text;
}

QString textOf(const Probe &probe, const Place &place, bool all)
{
    QString text = QCoreApplication::translate("Cli", "at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6\n")
                       .arg(place.x)
                       .arg(place.y)
                       .arg(toSeconds(place.time))
                       .arg(probe.paper, 0, 'g', 8)
                       .arg(textOf(probe.rybBefore), textOf(probe.rgbBefore));
    for (const ProbeStroke &s : probe.strokes)
        text += textOf(s, all);
    if (probe.strokes.empty())
        text += QCoreApplication::translate("Cli", "no stroke reaches this point\n");
    return text;
}

} // namespace

int probeCommand(const QStringList &arguments)
{
    CommandLine line("probe",
                     QCoreApplication::translate("Cli",
                                                 "Tells what lies at a point of the canvas, stroke by stroke from "
                                                 "bottom to top. X and Y are in canvas units."),
                     {"IN", "X", "Y"});
    line.add({"time"}, QCoreApplication::translate("Cli", "The moment, in seconds (default: the end)."), "T");
    line.add({"all"}, QCoreApplication::translate("Cli", "Lists segments with shares below a millionth, too."));
    line.add({"json"}, QCoreApplication::translate("Cli", "Prints JSON (docs/cli.md)."));
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const std::optional<double> x = toNumber(line.argument(1)), y = toNumber(line.argument(2));
    if (!x || !y)
        return failUsage("probe", QCoreApplication::translate("Cli", "%1 %2: give X and Y as numbers, in canvas units")
                                      .arg(line.argument(1), line.argument(2)));
    const Result<Painting> painting = paintingOf(line.argument(0));
    if (!painting)
        return fail(painting.error());
    const Result<Microseconds> time = timeOption(line, *painting);
    if (!time)
        return failUsage("probe", time.error());
    const Place place{*x, *y, *time};
    const Result<Probe> found = probe(*painting, place.time, place.x, place.y);
    if (!found)
        return fail(QStringLiteral("%1: %2").arg(line.argument(0), found.error()));
    const bool all = line.isSet("all");
    return line.isSet("json") ? printJson(jsonOf(*found, place, all)) : print(textOf(*found, place, all));
}

} // namespace suffuse::cli

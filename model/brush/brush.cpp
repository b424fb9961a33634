#include "model/brush/brush.h"

#include "model/painting/field_domains.h"
#include "model/painting/validate.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

struct BrushNumber {
    const char *path;
    double value;
    Domain domain;
};

/// Checks the numbers. Those that become numbers of a segment have the domains of these.
QString problemOfNumbers(const Brush &b)
{
    const auto segmentDomain = [](float Segment::*member) { return numberOf(member).traits.domain; };
    const BrushNumber numbers[] = {
        {"diffusion", b.diffusion, segmentDomain(&Segment::diffusion)},
        {"peak", b.peak, {0, 1e12}},
        {"granulation", b.granulation, segmentDomain(&Segment::granulation)},
        {"maxAge", b.maxAge, segmentDomain(&Segment::maxAge)},
        {"jitter.red", b.jitter.red, share},
        {"jitter.yellow", b.jitter.yellow, share},
        {"jitter.blue", b.jitter.blue, share},
        {"jitter.lightness", b.jitter.lightness, share},
        {"tip.ratio", b.tip.ratio, {1e-2, 1e2}},
        {"tip.angle", b.tip.angle, {-1e3, 1e3}},
        {"taper.in", b.taper.in, {0, 1e3}},
        {"taper.out", b.taper.out, {0, 1e3}},
        {"taper.tip", b.taper.tip, share},
        {"stabiliser.strength", b.stabiliser.strength, share},
        {"stabiliser.length", b.stabiliser.length, {0, 1e3}},
        {"fullSpeed", b.fullSpeed, {1e-3, 1e6}},
        {"fullDistance", b.fullDistance, {1e-3, 1e6}},
        {"driftLength", b.driftLength, {1e-2, 1e6}},
        {"interval", toSeconds(b.interval), {0.002, 0.2}},
    };
    for (const BrushNumber &n : numbers)
        if (!n.domain.contains(n.value))
            return outsideText(QLatin1String(n.path), n.value, n.domain);
    return {};
}

auto orderOf(const BrushDynamic &d)
{
    return std::pair(d.quantity, d.input);
}

} // namespace

const ResponseCurve *Brush::curve(BrushQuantity quantity, BrushInput input) const
{
    for (const BrushDynamic &d : dynamics)
        if (d.quantity == quantity && d.input == input)
            return &d.curve;
    return nullptr;
}

void Brush::setCurve(BrushQuantity quantity, BrushInput input, const ResponseCurve &curve)
{
    removeCurve(quantity, input);
    const BrushDynamic added{quantity, input, curve};
    const auto at = std::upper_bound(dynamics.begin(), dynamics.end(), added,
                                     [](const auto &a, const auto &b) { return orderOf(a) < orderOf(b); });
    dynamics.insert(at, added);
}

void Brush::removeCurve(BrushQuantity quantity, BrushInput input)
{
    std::erase_if(dynamics, [=](const BrushDynamic &d) { return d.quantity == quantity && d.input == input; });
}

QString problemOf(const Brush &brush)
{
    for (const QString &problem : {problemOf(brush.style), problemOf(brush.mix), problemOf(brush.colour)})
        if (!problem.isEmpty())
            return problem;
    if (const QString problem = problemOf(brush.secondColour); !problem.isEmpty())
        return QStringLiteral("second") + problem.mid(QStringLiteral("colour").size());
    if (const QString problem = problemOfNumbers(brush); !problem.isEmpty())
        return problem;
    if (brush.stabiliser.kind > Stabiliser::Kind::String)
        return QStringLiteral("stabiliser.kind: ") + QCoreApplication::translate("Validate", "there is no such kind");
    for (std::size_t i = 0; i < brush.dynamics.size(); ++i) {
        const BrushDynamic &d = brush.dynamics[i];
        const QString path = QStringLiteral("dynamics[%1]").arg(i);
        if (int(d.quantity) >= brushQuantities || int(d.input) >= brushInputs)
            return path + QStringLiteral(": ") + QCoreApplication::translate("Validate", "there is no such kind");
        if (i > 0 && orderOf(brush.dynamics[i - 1]) >= orderOf(d))
            return path + QStringLiteral(": ") +
                   QCoreApplication::translate("Validate", "another curve is of the same quantity and input");
        if (!d.curve.isValid())
            return path + QStringLiteral(".curve: ") +
                   QCoreApplication::translate("Validate",
                                               "it needs 2 to 16 points [x, y] in [0, 1], from left to right");
    }
    return {};
}

} // namespace suffuse

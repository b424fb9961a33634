#include "model/brush/brush.h"

#include "model/painting/validate.h"

#include <QCoreApplication>

#include <algorithm>

namespace suffuse {

namespace {

struct Domain {
    const char *path;
    double value, least, greatest;
};

/// Lower ends of domains that are open at 0 are small numbers, as the brush's values are float32.
QString problemOfNumbers(const Brush &b)
{
    constexpr double open = 1e-30;
    const Domain domains[] = {
        {"diffusion", b.diffusion, open, 1e12},
        {"peak", b.peak, 0, 1e12},
        {"granulation", b.granulation, 0, 1},
        {"maxAge", b.maxAge, open, 1e6},
        {"jitter.red", b.jitter.red, 0, 1},
        {"jitter.yellow", b.jitter.yellow, 0, 1},
        {"jitter.blue", b.jitter.blue, 0, 1},
        {"jitter.lightness", b.jitter.lightness, 0, 1},
        {"tip.ratio", b.tip.ratio, 1e-2, 1e2},
        {"tip.angle", b.tip.angle, -1e3, 1e3},
        {"taper.in", b.taper.in, 0, 1e3},
        {"taper.out", b.taper.out, 0, 1e3},
        {"taper.tip", b.taper.tip, 0, 1},
        {"stabiliser.strength", b.stabiliser.strength, 0, 1},
        {"stabiliser.length", b.stabiliser.length, 0, 1e3},
        {"fullSpeed", b.fullSpeed, 1e-3, 1e6},
        {"fullDistance", b.fullDistance, 1e-3, 1e6},
        {"driftLength", b.driftLength, 1e-2, 1e6},
        {"interval", toSeconds(b.interval), 0.002, 0.2},
    };
    for (const Domain &d : domains)
        if (!(d.value >= d.least && d.value <= d.greatest))
            return QCoreApplication::translate("Validate", "%1: %2 is not in %3")
                .arg(QLatin1String(d.path), QString::number(d.value, 'g', 9),
                     QStringLiteral("[%1, %2]").arg(d.least).arg(d.greatest));
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

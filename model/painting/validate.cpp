#include "model/painting/validate.h"

#include <QCoreApplication>

#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

constexpr double largestCoordinate = 1e12;
constexpr Microseconds largestTime = 1'000'000'000'000'000; // 1e15 µs
constexpr std::uint64_t largestId = 9'007'199'254'740'991;  // 2^53 − 1: exact in every JSON reader

QString tr(const char *text)
{
    return QCoreApplication::translate("Validate", text);
}

QString number(double value)
{
    return QString::number(value, 'g', 9);
}

/// "diffusion: -3 is not in (0, 1e12]"
QString outside(const QString &path, double value, const char *domain)
{
    return tr(QT_TRANSLATE_NOOP("Validate", "%1: %2 is not in %3")).arg(path, number(value), QLatin1String(domain));
}

QString outside(const char *path, double value, const char *domain)
{
    return outside(QString::fromLatin1(path), value, domain);
}

QString says(const QString &path, const char *translatable)
{
    return path + QLatin1String(": ") + tr(translatable);
}

bool inUnit(double v)
{
    return v >= 0 && v <= 1;
}

bool isCoordinate(double v)
{
    return std::abs(v) <= largestCoordinate; // false for NaN
}

bool isTime(Microseconds t)
{
    return t >= -largestTime && t <= largestTime;
}

QString problemOfColour(const Colour &colour, const char *path)
{
    const float channels[] = {colour.red, colour.yellow, colour.blue, colour.opacity};
    for (int i = 0; i < 4; ++i)
        if (!inUnit(channels[i]))
            return outside(QStringLiteral("%1[%2]").arg(QLatin1String(path)).arg(i), channels[i], "[0, 1]");
    return {};
}

QString problemOfEdge(double xi1, double xi2, double xi3)
{
    if (!(xi3 > 0 && xi3 <= 1))
        return outside("style.xi[2]", xi3, "(0, 1]");
    // Exactly 2^(1/3) rounded to float32 must pass.
    if (!(xi2 <= std::cbrt(2.0) * xi1 * (1 + 1e-6)))
        return tr(QT_TRANSLATE_NOOP("Validate", "style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2"))
            .arg(number(xi2), number(xi1));
    return {};
}

QString problemOfRewet(const Segment &segment)
{
    for (std::size_t i = 0; i < segment.rewet.size(); ++i) {
        const Rewet &r = segment.rewet[i];
        const QString path = QStringLiteral("rewet[%1]").arg(i);
        if (!isTime(r.time))
            return outside(path + QLatin1String("[0]"), toSeconds(r.time), "[-1e9, 1e9]");
        if (r.extra < 0 || !isTime(r.extra))
            return outside(path + QLatin1String("[1]"), toSeconds(r.extra), "[0, 1e9]");
        if (i > 0 && r.time < segment.rewet[i - 1].time)
            return says(
                path + QLatin1String("[0]"),
                QT_TRANSLATE_NOOP("Validate", "it is earlier than the one before it; put them in order of time"));
    }
    return {};
}

/// Ids unique and in range; parents exist; no cycle.
QString problemOfGroups(const std::vector<Group> &groups)
{
    std::unordered_map<GroupId, GroupId> parents;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const QString path = QStringLiteral("groups[%1].id").arg(i);
        if (groups[i].id == 0 || groups[i].id > largestId)
            return outside(path, double(groups[i].id), "[1, 9007199254740991]");
        if (!parents.emplace(groups[i].id, groups[i].parent).second)
            return says(path, QT_TRANSLATE_NOOP("Validate", "another group has the same id"));
    }
    std::unordered_set<GroupId> sound{0};
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const QString path = QStringLiteral("groups[%1].parent").arg(i);
        std::vector<GroupId> chain;
        std::unordered_set<GroupId> seen;
        for (GroupId id = groups[i].id; !sound.contains(id); id = parents[id]) {
            if (!parents.contains(id))
                return says(path, QT_TRANSLATE_NOOP("Validate", "there is no group with this id"));
            if (!seen.insert(id).second)
                return says(path, QT_TRANSLATE_NOOP("Validate", "the group would lie within itself"));
            chain.push_back(id);
        }
        sound.insert(chain.begin(), chain.end());
    }
    return {};
}

} // namespace

QString problemOf(const Style &style)
{
    const double xi1 = style.xi[0], xi2 = style.xi[1], xi3 = style.xi[2];
    if (style.kind > StyleKind::Edge)
        return says(QStringLiteral("style.kind"), QT_TRANSLATE_NOOP("Validate", "there is no such style"));
    if (!(xi1 > 0 && std::isfinite(xi1)))
        return outside("style.xi[0]", xi1, "(0, 3.4e38]");
    if (!(xi2 > 0 && std::isfinite(xi2)))
        return outside("style.xi[1]", xi2, "(0, 3.4e38]");
    if (style.kind == StyleKind::Edge)
        return problemOfEdge(xi1, xi2, xi3);
    if (style.kind == StyleKind::Feathering && !(xi2 >= 0.5 && xi2 <= 64))
        return outside("style.xi[1]", xi2, "[0.5, 64]");
    if (xi3 != 0)
        return says(QStringLiteral("style.xi[2]"),
                    QT_TRANSLATE_NOOP("Validate", "only edge darkening has a third value"));
    return {};
}

QString problemOf(const Mix &mix)
{
    if (mix.mode > MixMode::Beta)
        return says(QStringLiteral("mix.mode"), QT_TRANSLATE_NOOP("Validate", "there is no such mixing mode"));
    if (!inUnit(mix.beta))
        return outside("mix.beta", mix.beta, "[0, 1]");
    if (mix.mode == MixMode::Alpha && mix.beta != 0)
        return says(QStringLiteral("mix.beta"), QT_TRANSLATE_NOOP("Validate", "only beta mixing has a beta"));
    return {};
}

QString problemOf(const Colour &colour)
{
    return problemOfColour(colour, "colour");
}

QString problemOf(const Segment &s)
{
    for (int i = 0; i < 4; ++i)
        for (int axis = 0; axis < 2; ++axis)
            if (const double v = axis ? s.bezier[i].y : s.bezier[i].x; !isCoordinate(v))
                return outside(QStringLiteral("bezier[%1][%2]").arg(i).arg(axis), v, "[-1e12, 1e12]");
    if (!(s.diffusion > 0 && s.diffusion <= 1e12))
        return outside("diffusion", s.diffusion, "(0, 1e12]");
    if (!(s.density >= 0 && s.density <= 1e12))
        return outside("density", s.density, "[0, 1e12]");
    if (!inUnit(s.granulation))
        return outside("granulation", s.granulation, "[0, 1]");
    if (!(s.maxAge > 0 && s.maxAge <= 1e6))
        return outside("maxAge", s.maxAge, "(0, 1e6]");
    if (!isTime(s.born))
        return outside("born", toSeconds(s.born), "[-1e9, 1e9]");
    if (const QString problem = problemOf(s.colour); !problem.isEmpty())
        return problem;
    if (s.style)
        if (const QString problem = problemOf(*s.style); !problem.isEmpty())
            return problem;
    if (!(s.anisotropyRatio >= 1e-6f && s.anisotropyRatio <= 1e6f))
        return outside("anisotropy.ratio", s.anisotropyRatio, "[1e-6, 1e6]");
    if (!std::isfinite(s.anisotropyAngle))
        return outside("anisotropy.angle", s.anisotropyAngle, "[-3.4e38, 3.4e38]");
    if (s.node > NodeKind::Corner)
        return says(QStringLiteral("node"), QT_TRANSLATE_NOOP("Validate", "there is no such kind of node"));
    return problemOfRewet(s);
}

QString problemOf(const Stroke &stroke)
{
    if (stroke.id == 0 || stroke.id > largestId)
        return outside("id", double(stroke.id), "[1, 9007199254740991]");
    if (!isCoordinate(stroke.origin.x))
        return outside("origin[0]", stroke.origin.x, "[-1e12, 1e12]");
    if (!isCoordinate(stroke.origin.y))
        return outside("origin[1]", stroke.origin.y, "[-1e12, 1e12]");
    if (const QString problem = problemOf(stroke.style); !problem.isEmpty())
        return problem;
    if (const QString problem = problemOf(stroke.mix); !problem.isEmpty())
        return problem;
    if (stroke.segments.empty())
        return says(QStringLiteral("segments"), QT_TRANSLATE_NOOP("Validate", "a stroke needs at least one"));
    for (std::size_t k = 0; k < stroke.segments.size(); ++k) {
        const Segment &segment = stroke.segments[k];
        const auto path = [k] { return QStringLiteral("segments[%1].").arg(k); };
        if (const QString problem = problemOf(segment); !problem.isEmpty())
            return path() + problem;
        for (int i = 0; i < 4; ++i) {
            const Point p = stroke.origin + segment.bezier[i];
            if (!isCoordinate(p.x) || !isCoordinate(p.y))
                return path() + outside(QStringLiteral("bezier[%1][%2]").arg(i).arg(isCoordinate(p.x) ? 1 : 0),
                                        isCoordinate(p.x) ? p.y : p.x, "[-1e12, 1e12]");
        }
        if (k > 0 && segment.bezier[0] != stroke.segments[k - 1].bezier[3])
            return says(path() + QLatin1String("bezier[0]"),
                        QT_TRANSLATE_NOOP("Validate", "the segment does not start where the one before it ends"));
    }
    return {};
}

QString problemOf(const Canvas &canvas)
{
    if (!(canvas.width > 0 && canvas.width <= 1e6))
        return outside("canvas.width", canvas.width, "(0, 1e6]");
    if (!(canvas.height > 0 && canvas.height <= 1e6))
        return outside("canvas.height", canvas.height, "(0, 1e6]");
    if (const QString problem = problemOfColour(canvas.background, "canvas.background"); !problem.isEmpty())
        return problem;
    const Paper &paper = canvas.paper;
    if (paper.kind > PaperKind::Image)
        return says(QStringLiteral("canvas.paper.kind"),
                    QT_TRANSLATE_NOOP("Validate", "there is no such kind of paper"));
    if (paper.grain > PaperGrain::Weave)
        return says(QStringLiteral("canvas.paper.grain"),
                    QT_TRANSLATE_NOOP("Validate", "there is no such grain of paper"));
    if (!(paper.scale > 0 && paper.scale <= 1e6))
        return outside("canvas.paper.scale", paper.scale, "(0, 1e6]");
    if (!inUnit(paper.strength))
        return outside("canvas.paper.strength", paper.strength, "[0, 1]");
    if (paper.kind == PaperKind::Image && !paper.image)
        return says(QStringLiteral("canvas.paper.image"),
                    QT_TRANSLATE_NOOP("Validate", "the paper's image is missing"));
    return {};
}

/// Members of a group, those of its subgroups among them, must stand together in the order.
QString problemOfMembership(const Painting &painting)
{
    std::unordered_map<GroupId, GroupId> parents;
    for (const Group &g : painting.groups)
        parents.emplace(g.id, g.parent);
    std::unordered_set<GroupId> closed;
    std::vector<GroupId> open; // chain of the stroke before, innermost first
    for (std::size_t j = 0; j < painting.strokes.size(); ++j) {
        const auto path = [j] { return QStringLiteral("strokes[%1].group").arg(j); };
        std::vector<GroupId> chain;
        for (GroupId id = painting.strokes[j]->group; id != 0; id = parents[id]) {
            if (!parents.contains(id))
                return says(path(), QT_TRANSLATE_NOOP("Validate", "there is no group with this id"));
            chain.push_back(id);
        }
        for (GroupId id : open)
            if (std::find(chain.begin(), chain.end(), id) == chain.end())
                closed.insert(id);
        for (GroupId id : chain)
            if (closed.contains(id))
                return says(path(),
                            QT_TRANSLATE_NOOP("Validate", "the group's members do not stand together in the order"));
        open = std::move(chain);
    }
    return {};
}

QString problemOf(const Underlay &underlay)
{
    const Rect &a = underlay.area;
    for (double v : {a.left, a.top, a.right, a.bottom})
        if (!isCoordinate(v))
            return outside("underlay.area", v, "[-1e12, 1e12]");
    if (!inUnit(underlay.opacity))
        return outside("underlay.opacity", underlay.opacity, "[0, 1]");
    return {};
}

QString problemOf(const Painting &painting)
{
    if (const QString problem = problemOf(painting.canvas); !problem.isEmpty())
        return problem;
    if (const QString problem = problemOfGroups(painting.groups); !problem.isEmpty())
        return problem;
    std::unordered_set<StrokeId> ids;
    ids.reserve(painting.strokes.size());
    for (std::size_t j = 0; j < painting.strokes.size(); ++j) {
        const auto path = [j] { return QStringLiteral("strokes[%1]").arg(j); };
        if (!painting.strokes[j])
            return says(path(), QT_TRANSLATE_NOOP("Validate", "the stroke is missing"));
        const Stroke &stroke = *painting.strokes[j];
        if (const QString problem = problemOf(stroke); !problem.isEmpty())
            return path() + QLatin1Char('.') + problem;
        if (!ids.insert(stroke.id).second)
            return says(path() + QLatin1String(".id"), QT_TRANSLATE_NOOP("Validate", "another stroke has the same id"));
    }
    if (const QString problem = problemOfMembership(painting); !problem.isEmpty())
        return problem;
    for (std::size_t i = 0; i < painting.swatches.size(); ++i)
        if (const QString problem = problemOf(painting.swatches[i].colour); !problem.isEmpty())
            return QStringLiteral("swatches[%1].").arg(i) + problem;
    return painting.underlay ? problemOf(*painting.underlay) : QString();
}

} // namespace suffuse

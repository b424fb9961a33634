#include "model/painting/validate.h"

#include "model/painting/field_domains.h"

#include <QCoreApplication>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace suffuse {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("Validate", text);
}

QString number(double value)
{
    return QString::number(value, 'g', 9);
}

QString says(const QString &path, const char *translatable)
{
    return path + QLatin1String(": ") + tr(translatable);
}

QString outsideXi(const Style &style, int index)
{
    return outsideText(QStringLiteral("style.xi[%1]").arg(index), double(style.xi[std::size_t(index)]),
                       domainOfXi(style.kind, index));
}

bool isPlace(Point p)
{
    return coordinate.contains(p.x) && coordinate.contains(p.y);
}

/// Checks that ids are unique and in range, that parents exist, and that no group is within itself.
QString problemOfGroups(const std::vector<Group> &groups)
{
    std::unordered_map<GroupId, GroupId> parents;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const QString path = QStringLiteral("groups[%1].id").arg(i);
        if (!identity.contains(double(groups[i].id)))
            return outsideText(path, double(groups[i].id), identity);
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

QString FieldPath::text() const
{
    QString before = parent ? parent->text() : QString();
    if (!name)
        return before + QStringLiteral("[%1]").arg(index);
    if (!before.isEmpty() && *name != '[')
        before += QLatin1Char('.');
    return before + QLatin1String(name);
}

QString outsideText(const QString &path, double value, const Domain &domain)
{
    return QCoreApplication::translate("Validate", "%1: %2 is not in %3").arg(path, number(value), domain.text());
}

void DomainCheck::failDomain(const FieldPath &path, double value, const Domain &domain)
{
    m_problem = outsideText(path.text(), value, domain);
}

void DomainCheck::failText(const FieldPath &path, const char *translatable)
{
    m_problem = says(path.text(), translatable);
}

const char *DomainCheck::noSuch(NodeKind)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such kind of node");
}

const char *DomainCheck::noSuch(FillRule)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such rule");
}

const char *DomainCheck::noSuch(PaperKind)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such kind of paper");
}

const char *DomainCheck::noSuch(PaperGrain)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such grain of paper");
}

const char *DomainCheck::noSuch(BlendMode)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such blend mode");
}

const char *DomainCheck::noSuch(GroupTag)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such colour to mark groups");
}

const char *DomainCheck::noSuch(TextAlignment)
{
    return QT_TRANSLATE_NOOP("Validate", "there is no such alignment");
}

void DomainCheck::checkText(const Text &text, const FieldPath &path)
{
    const auto checkLength = [&](const QString &string, const char *name, int most) {
        const FieldPath place{&path, name};
        if (!string.isValidUtf16())
            failText(place, QT_TRANSLATE_NOOP("Validate", "it is no valid Unicode"));
        else if (string.size() > most)
            m_problem = QCoreApplication::translate("Validate", "%1: %2 characters are more than %3")
                            .arg(place.text())
                            .arg(string.size())
                            .arg(most);
    };
    checkLength(text.string, "string", Text::mostCharacters);
    if (ok())
        checkLength(text.family, "family", Text::mostFamily);
    if (ok() && text.curve.size() > std::size_t(Text::mostCurves))
        m_problem = QCoreApplication::translate("Validate", "%1: %2 curves are more than %3")
                        .arg(FieldPath{&path, "curve"}.text())
                        .arg(text.curve.size())
                        .arg(Text::mostCurves);
    if (ok())
        checkFields(text, path);
}

void DomainCheck::checkPicture(const Picture &picture, const FieldPath &path)
{
    const auto isHex = [](QChar c) { return (c >= u'0' && c <= u'9') || (c >= u'a' && c <= u'f'); };
    if (picture.sha256.size() != 64 || !std::ranges::all_of(picture.sha256, isHex))
        return failText(path,
                        QT_TRANSLATE_NOOP("Validate", "it needs an image, or a link with the SHA-256 of its file"));
    if (picture.link.size() > Picture::mostLink || !picture.link.isValidUtf16())
        return failText(FieldPath{&path, "link"}, QT_TRANSLATE_NOOP("Validate", "it is no path of a file"));
    checkFields(picture, path);
    const Domain side{1, Picture::mostSide};
    require(side.contains(double(picture.width)), FieldPath{&path, "width"}, double(picture.width), side);
    require(side.contains(double(picture.height)), FieldPath{&path, "height"}, double(picture.height), side);
    if (!ok())
        return;
    if (picture.pixels() > Picture::mostPixels)
        return failText(path, QT_TRANSLATE_NOOP("Validate", "it has more than 67 million pixels"));
    if (!mapOf(picture).inverse())
        failText(path, QT_TRANSLATE_NOOP("Validate", "its corners lie on one line; a picture needs an area"));
}

void DomainCheck::checkParts(const Affine &map, const FieldTraits &traits, const FieldPath &path)
{
    const std::array<double, 6> numbers{map.a, map.b, map.c, map.d, map.offset.x, map.offset.y};
    check(numbers, traits, path);
}

void DomainCheck::checkParts(const std::vector<Cubic> &curves, const FieldTraits &traits, const FieldPath &path)
{
    for (std::size_t i = 0; i < curves.size() && ok(); ++i)
        check(curves[i].p, traits, FieldPath{&path, nullptr, int(i)});
}

void DomainCheck::checkParts(const std::vector<Rewet> &list, const FieldTraits &, const FieldPath &path)
{
    for (std::size_t i = 0; i < list.size() && ok(); ++i) {
        const FieldPath place{&path, nullptr, int(i)};
        checkFields(list[i], place);
        if (ok() && i > 0 && list[i].time < list[i - 1].time)
            failText(FieldPath{&place, "[0]"},
                     QT_TRANSLATE_NOOP("Validate", "it is earlier than the one before it; put them in order of time"));
    }
}

QString problemOf(const Style &style)
{
    if (std::size_t(style.kind) >= styleKinds.size())
        return says(QStringLiteral("style.kind"), QT_TRANSLATE_NOOP("Validate", "there is no such style"));
    const auto isGood = [&](int index) { return domainOfXi(style.kind, index).contains(style.xi[std::size_t(index)]); };
    for (int index = 0; index < xiCount(style.kind); ++index)
        if (!isGood(index))
            return outsideXi(style, index);
    if (!isGood(2))
        return says(QStringLiteral("style.xi[2]"),
                    QT_TRANSLATE_NOOP("Validate", "only edge darkening has a third value"));
    const double xi1 = style.xi[0], xi2 = style.xi[1];
    // 2^(1/3) itself, rounded to float32, must pass.
    if (hasRim(style.kind) && !(xi2 <= greatestLightening() * xi1 * (1 + 1e-6)))
        return QCoreApplication::translate("Validate", "style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2")
            .arg(number(xi2), number(xi1));
    return {};
}

QString problemOf(const Mix &mix)
{
    if (mix.mode > MixMode::Beta)
        return says(QStringLiteral("mix.mode"), QT_TRANSLATE_NOOP("Validate", "there is no such mixing mode"));
    if (!share.contains(mix.beta))
        return outsideText(QStringLiteral("mix.beta"), double(mix.beta), share);
    if (mix.mode == MixMode::Alpha && mix.beta != 0)
        return says(QStringLiteral("mix.beta"), QT_TRANSLATE_NOOP("Validate", "only beta mixing has a beta"));
    return {};
}

QString problemOf(const Colour &colour)
{
    DomainCheck check;
    check.checkFields(colour, FieldPath{nullptr, "colour"});
    return check.problem();
}

QString problemOf(const Segment &segment)
{
    if (!fits(segment)) {
        DomainCheck check;
        check.checkFields(segment);
        if (!check.ok())
            return check.problem();
    }
    if (segment.lift && segment.fade)
        return says(QStringLiteral("fade"), QT_TRANSLATE_NOOP("Validate", "a segment that lifts cannot fade as well"));
    return {};
}

/// What fields of a fill demand of each other, and of the stroke.
static QString problemOfGradient(const Stroke &stroke)
{
    if (!stroke.fill || !stroke.fill->gradient)
        return {};
    const Gradient &gradient = *stroke.fill->gradient;
    for (const auto &[name, offset] : {std::pair("from", gradient.from), std::pair("to", gradient.to)}) {
        const Point p = stroke.origin + offset;
        const bool isX = !coordinate.contains(p.x);
        if (!isPlace(p))
            return outsideText(QStringLiteral("fill.gradient.%1[%2]").arg(QLatin1String(name)).arg(isX ? 0 : 1),
                               isX ? p.x : p.y, coordinate);
    }
    if (gradient.from == gradient.to)
        return says(QStringLiteral("fill.gradient.to"),
                    QT_TRANSLATE_NOOP("Validate", "it is the same point as from; a gradient needs two"));
    return {};
}

QString problemOf(const Stroke &stroke)
{
    DomainCheck check;
    check.checkFields(stroke);
    if (!check.ok())
        return check.problem();
    if (const QString problem = problemOfGradient(stroke); !problem.isEmpty())
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
            if (!isPlace(p)) {
                const bool isX = !coordinate.contains(p.x);
                return path() + outsideText(QStringLiteral("bezier[%1][%2]").arg(i).arg(isX ? 0 : 1), isX ? p.x : p.y,
                                            coordinate);
            }
        }
        if (!stroke.beginsChain(k) && segment.bezier[0] != stroke.segments[k - 1].bezier[3])
            return says(path() + QLatin1String("bezier[0]"),
                        QT_TRANSLATE_NOOP("Validate", "the segment does not start where the one before it ends"));
    }
    return {};
}

QString problemOf(const Canvas &canvas)
{
    DomainCheck check;
    check.checkFields(canvas, FieldPath{nullptr, "canvas"});
    if (!check.ok())
        return check.problem();
    if (canvas.paper.kind == PaperKind::Image && !canvas.paper.image)
        return says(QStringLiteral("canvas.paper.image"),
                    QT_TRANSLATE_NOOP("Validate", "the paper's image is missing"));
    return {};
}

QString problemOf(const Text &text)
{
    DomainCheck check;
    check.checkText(text, FieldPath{nullptr, "text"});
    return check.problem();
}

/// Checks that the members of a group, including those of its subgroups, stand together in the order.
QString problemOfMembership(const Painting &painting)
{
    std::unordered_map<GroupId, GroupId> parents;
    for (const Group &g : painting.groups)
        parents.emplace(g.id, g.parent);
    std::unordered_set<GroupId> closed;
    std::vector<GroupId> open; // the groups around the stroke before, the innermost first
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
    DomainCheck check;
    check.checkFields(underlay, FieldPath{nullptr, "underlay"});
    return check.problem();
}

QString problemOf(const Painting &painting)
{
    if (const QString problem = problemOf(painting.canvas); !problem.isEmpty())
        return problem;
    if (const QString problem = problemOfGroups(painting.groups); !problem.isEmpty())
        return problem;
    const FieldPath groups{nullptr, "groups"};
    for (std::size_t i = 0; i < painting.groups.size(); ++i) {
        DomainCheck check;
        check.checkFields(painting.groups[i], FieldPath{&groups, nullptr, int(i)});
        if (!check.ok())
            return check.problem();
    }
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

#include "model/painting/painting.h"

#include <QCryptographicHash>

#include <bit>
#include <type_traits>

namespace suffuse {

namespace {

bool equalImages(const EncodedImage &a, const EncodedImage &b)
{
    return a == b || (a && b && *a == *b);
}

const Group *findGroup(const std::vector<Group> &groups, GroupId id)
{
    const auto it = std::find_if(groups.begin(), groups.end(), [id](const Group &g) { return g.id == id; });
    return it == groups.end() ? nullptr : &*it;
}

/// True if the predicate holds for a group of the chain from `id` to the root. Ends on damaged chains too.
template <typename Predicate>
bool anyGroup(const std::vector<Group> &groups, GroupId id, Predicate predicate)
{
    for (std::size_t steps = 0; id != 0 && steps <= groups.size(); ++steps) {
        const Group *group = findGroup(groups, id);
        if (!group)
            return false;
        if (predicate(*group))
            return true;
        id = group->parent;
    }
    return false;
}

/// Feeds values to a hash in one canonical form: fixed-width little-endian, floats as bits, texts with their length.
class Serialiser {
public:
    template <typename T>
    void put(T value)
    {
        if constexpr (std::is_same_v<T, float>)
            put(std::bit_cast<std::uint32_t>(value + 0.0f)); // −0 equals 0, so it hashes as 0
        else if constexpr (std::is_same_v<T, double>)
            put(std::bit_cast<std::uint64_t>(value + 0.0));
        else if constexpr (std::is_enum_v<T>)
            put(std::underlying_type_t<T>(value));
        else {
            static_assert(std::is_integral_v<T>);
            auto bits = std::make_unsigned_t<std::conditional_t<std::is_same_v<T, bool>, char, T>>(value);
            for (std::size_t i = 0; i < sizeof bits; ++i, bits = decltype(bits)(std::uint64_t(bits) >> 8))
                m_buffer.append(char(bits & 0xff));
            if (m_buffer.size() > bufferSize)
                flush();
        }
    }
    void put(const QString &text) { put(text.toUtf8()); }
    void put(const QByteArray &bytes)
    {
        put(std::uint64_t(bytes.size()));
        flush();
        m_hash.addData(bytes);
    }
    void put(const Colour &c) { put(c.red), put(c.yellow), put(c.blue), put(c.opacity); }
    void put(const Style &s) { put(s.kind), put(s.xi[0]), put(s.xi[1]), put(s.xi[2]); }
    void put(const EncodedImage &image)
    {
        put(bool(image));
        if (image)
            put(*image);
    }
    QByteArray result()
    {
        flush();
        return m_hash.result();
    }

private:
    static constexpr qsizetype bufferSize = 1 << 16;
    void flush()
    {
        m_hash.addData(m_buffer);
        m_buffer.resize(0);
    }

    QCryptographicHash m_hash{QCryptographicHash::Sha256};
    QByteArray m_buffer;
};

void putSegment(Serialiser &out, const Segment &s)
{
    for (const Offset &o : s.bezier)
        out.put(o.x), out.put(o.y);
    out.put(s.diffusion), out.put(s.density), out.put(s.granulation), out.put(s.maxAge), out.put(s.born);
    out.put(s.colour);
    out.put(s.style.has_value());
    if (s.style)
        out.put(*s.style);
    out.put(s.anisotropyRatio), out.put(s.anisotropyAngle), out.put(s.node);
    out.put(std::uint64_t(s.rewet.size()));
    for (const Rewet &r : s.rewet)
        out.put(r.time), out.put(r.extra);
}

void putStroke(Serialiser &out, const Stroke &s)
{
    out.put(s.id), out.put(s.name), out.put(s.group), out.put(s.visible), out.put(s.locked);
    out.put(s.style), out.put(s.mix.mode), out.put(s.mix.beta);
    out.put(s.origin.x), out.put(s.origin.y), out.put(s.brush);
    out.put(std::uint64_t(s.segments.size()));
    for (const Segment &segment : s.segments)
        putSegment(out, segment);
}

void putCanvas(Serialiser &out, const Canvas &c)
{
    out.put(c.width), out.put(c.height), out.put(c.background);
    out.put(c.paper.kind), out.put(c.paper.seed), out.put(c.paper.scale), out.put(c.paper.strength);
    out.put(c.paper.image), out.put(c.paper.grain);
}

} // namespace

bool operator==(const Paper &a, const Paper &b)
{
    return a.kind == b.kind && a.seed == b.seed && a.scale == b.scale && a.strength == b.strength &&
           a.grain == b.grain && equalImages(a.image, b.image);
}

bool operator==(const Underlay &a, const Underlay &b)
{
    return equalImages(a.image, b.image) && a.area == b.area && a.opacity == b.opacity && a.visible == b.visible;
}

StrokePtr Painting::find(StrokeId id) const
{
    const int index = indexOf(id);
    return index < 0 ? nullptr : strokes[std::size_t(index)];
}

int Painting::indexOf(StrokeId id) const
{
    const auto it = std::find_if(strokes.begin(), strokes.end(), [id](const StrokePtr &s) { return s->id == id; });
    return it == strokes.end() ? -1 : int(it - strokes.begin());
}

bool Painting::isVisible(const Stroke &stroke) const
{
    return stroke.visible && !anyGroup(groups, stroke.group, [](const Group &g) { return !g.visible; });
}

bool Painting::isLocked(const Stroke &stroke) const
{
    return stroke.locked || anyGroup(groups, stroke.group, [](const Group &g) { return g.locked; });
}

std::size_t Painting::segmentCount() const
{
    std::size_t n = 0;
    for (const StrokePtr &s : strokes)
        n += s->segments.size();
    return n;
}

Microseconds Painting::end() const
{
    if (strokes.empty())
        return 0;
    Microseconds t = strokes.front()->driesAt();
    for (const StrokePtr &s : strokes)
        t = std::max(t, s->driesAt());
    return t;
}

StrokeId Painting::nextStrokeId() const
{
    StrokeId id = 0;
    for (const StrokePtr &s : strokes)
        id = std::max(id, s->id);
    return id + 1;
}

std::vector<StrokeId> orderOf(const Painting &painting)
{
    std::vector<StrokeId> order;
    order.reserve(painting.strokes.size() + 1);
    for (const StrokePtr &s : painting.strokes)
        order.push_back(s->id);
    return order;
}

bool operator==(const Painting &a, const Painting &b)
{
    const auto equalStrokes = [](const StrokePtr &x, const StrokePtr &y) { return x == y || (x && y && *x == *y); };
    const bool equalUnderlays = a.underlay == b.underlay || (a.underlay && b.underlay && *a.underlay == *b.underlay);
    return a.canvas == b.canvas && a.groups == b.groups && a.swatches == b.swatches && equalUnderlays &&
           std::equal(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(), equalStrokes);
}

QByteArray hashOf(const Painting &painting)
{
    Serialiser out;
    putCanvas(out, painting.canvas);
    out.put(std::uint64_t(painting.strokes.size()));
    for (const StrokePtr &s : painting.strokes)
        putStroke(out, *s);
    out.put(std::uint64_t(painting.groups.size()));
    for (const Group &g : painting.groups)
        out.put(g.id), out.put(g.name), out.put(g.parent), out.put(g.visible), out.put(g.locked);
    out.put(std::uint64_t(painting.swatches.size()));
    for (const Swatch &s : painting.swatches)
        out.put(s.name), out.put(s.colour);
    out.put(bool(painting.underlay));
    if (const Underlay *u = painting.underlay.get()) {
        out.put(u->image);
        out.put(u->area.left), out.put(u->area.top), out.put(u->area.right), out.put(u->area.bottom);
        out.put(u->opacity), out.put(u->visible);
    }
    return out.result();
}

} // namespace suffuse

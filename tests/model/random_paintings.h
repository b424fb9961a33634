// Valid paintings with every optional member and extreme values, the same for the same seed.
#pragma once

#include "model/painting/painting.h"

#include <QRandomGenerator>

#include <algorithm>
#include <limits>

namespace suffuse::test {

class RandomPaintings {
public:
    explicit RandomPaintings(quint32 seed) : m_random(seed) {}

    Painting painting(int strokes, int segments)
    {
        Painting p;
        p.canvas = canvas();
        if (chance(2))
            p.groups = {{7, QStringLiteral("Gruppe \"ä\\\n\t\x01 😀"), 0, false, true, {}},
                        {9, QStringLiteral("in"), 7, true, false, {}}};
        for (Group &group : p.groups) {
            if (chance(2))
                group.text = text();
            if (chance(2)) {
                group.opacity = float(unit());
                group.blend = BlendMode(below(blendModes));
                group.isolated = chance(2);
                group.clips = chance(2), group.mask = chance(4), group.solo = chance(4);
                if (chance(2))
                    group.wash = Wash{style(), chance(2) ? Mix() : Mix{MixMode::Beta, float(unit())}};
                group.tag = GroupTag(below(groupTags));
                group.draft = chance(3);
            }
        }
        for (int k = 0; k < strokes; ++k)
            p.strokes.push_back(
                stroke(StrokeId(k * 3 + 1), 1 + below(segments), p.groups.empty() || k > strokes / 2 ? 0 : 9));
        for (Group &group : p.groups)
            if (group.text && !group.text->curve.empty() && strokes > 0) {
                Text text = *group.text;
                text.follows = p.strokes.back()->id;
                text.followMap = {0.5, -0.25, 1e-7, 3, {1e10, -0.5}};
                group.text = std::move(text);
            }
        if (chance(2))
            p.swatches = {{QStringLiteral("湖"), colour()}, {QString(), colour(), true}};
        if (chance(2)) {
            auto u = std::make_shared<Underlay>();
            u->image = image();
            u->area = Rect::of(coordinate(100), coordinate(100), unit() * 500, unit() * 1e5);
            u->opacity = float(unit());
            u->visible = chance(2);
            p.underlay = u;
        }
        return p;
    }

    quint32 below(int n) { return m_random.bounded(quint32(n)); }
    bool chance(int oneIn) { return below(oneIn) == 0; }

private:
    double unit() { return m_random.generateDouble(); }
    double coordinate(double size) { return (unit() * 2 - 1) * size; }
    EncodedImage image()
    {
        QByteArray bytes("\x89PNG\r\n\x1a\n");
        for (int k = 0; k < 50; ++k)
            bytes.append(char(below(256)));
        return std::make_shared<const QByteArray>(bytes);
    }
    Colour colour() { return {float(unit()), 1, 0, float(unit())}; }
    Canvas canvas()
    {
        Canvas c;
        c.width = chance(3) ? 1e6 : 1 + unit() * 4000;
        c.height = chance(3) ? 1e-300 : 768;
        c.background = colour();
        c.paper.kind = PaperKind(below(3));
        c.paper.seed = m_random.generate();
        c.paper.scale = float(1e-3 + unit() * 100);
        c.paper.strength = float(unit());
        c.paper.grain = PaperGrain(below(3));
        if (c.paper.kind == PaperKind::Image || chance(5))
            c.paper.image = image();
        return c;
    }
    Style style()
    {
        switch (below(3)) {
        case 0:
            return {StyleKind::Uniform, {float(0.1 + unit()), float(1e-6 + unit()), 0}};
        case 1:
            return {StyleKind::Feathering, {std::numeric_limits<float>::max(), float(0.5 + 63 * unit()), 0}};
        default:
            return {StyleKind::Edge, {0.36f, float(0.4 * unit() + 1e-3), float(0.01 + 0.99 * unit())}};
        }
    }
    /// Up to the ends of the domain, and the smallest number above 0.
    float quantity(float largest)
    {
        switch (below(5)) {
        case 0:
            return largest;
        case 1:
            return std::numeric_limits<float>::denorm_min();
        case 2:
            return 0.5f;
        default:
            return float(unit() * std::min(largest, 50.0f) + 1e-9);
        }
    }
    Offset point()
    {
        switch (below(8)) {
        case 0:
            return {0, -0.0f};
        case 1:
            return {1e11f, -std::numeric_limits<float>::denorm_min()};
        case 2:
            return {12.25f, 1234.5678f};
        default:
            return {float(coordinate(1000)), float(coordinate(1000))};
        }
    }
    Microseconds time()
    {
        return chance(4) ? (chance(2) ? 1 : -1) * Microseconds(999'999'999'999'999 - below(1000))
                         : Microseconds(m_random.generate());
    }
    Segment segment(Offset start)
    {
        Segment s;
        s.bezier = {start, point(), point(), point()};
        s.diffusion = quantity(1e12f);
        s.density = chance(4) ? 0 : quantity(1e12f);
        s.granulation = float(unit());
        s.maxAge = quantity(1e6f);
        s.born = time();
        s.colour = colour();
        if (chance(3))
            s.style = style();
        if (chance(4)) {
            s.anisotropyRatio = std::max(1e-6f, quantity(1e6f));
            s.anisotropyAngle = float(coordinate(7));
        }
        s.node = NodeKind(below(3));
        for (Microseconds t = -5; chance(3); t += below(1000))
            s.rewet.push_back({t, chance(3) ? 0 : Microseconds(below(1'000'000))});
        return s;
    }
    Fill fill()
    {
        Fill f;
        f.diffusion = quantity(1e12f);
        f.density = chance(4) ? 0 : quantity(1e12f);
        f.granulation = float(unit());
        f.maxAge = quantity(1e6f);
        f.born = time();
        f.colour = colour();
        f.rule = FillRule(below(2));
        if (chance(2))
            f.gradient = {point(), {float(coordinate(1000)), 7}, colour()};
        if (chance(3)) {
            f.anisotropyRatio = std::max(1e-6f, quantity(1e6f));
            f.anisotropyAngle = float(coordinate(7));
        }
        return f;
    }
    Text text()
    {
        Text t;
        t.string = chance(3) ? QString() : QStringLiteral("Zwölf\n\"\u6c34\"\u0301 \U0001F3A8 %1").arg(below(100));
        t.family = chance(3) ? QString() : QStringLiteral("DejaVu Sans");
        t.weight = float(1 + below(1000));
        t.italic = chance(2);
        t.size = chance(3) ? 1e6 : unit() + 1e-300;
        t.letterSpacing = chance(2) ? 0 : float(unit() - 0.5);
        t.lineHeight = float(coordinate(100));
        t.alignment = TextAlignment(below(3));
        t.vertical = chance(2);
        if (chance(2))
            t.place = {unit(), -unit(), 1e-7, 3, {coordinate(1e10), -0.0}};
        for (quint32 k = below(4); chance(2) && k > 0; --k)
            t.curve.push_back({{Point{coordinate(1e10), 0.1}, {unit(), -0.0}, {1, 2}, {1e12, -1e12}}});
        return t;
    }
    Picture picture()
    {
        Picture p;
        p.image = image();
        p.sha256 = sha256Of(*p.image);
        if (chance(3)) { // a linked one whose file is not at hand
            p.link = QStringLiteral("ordner/\u6e56 \"%1\".png").arg(below(3));
            p.image = {};
        }
        p.width = 1 + below(100), p.height = 1 + below(Picture::mostSide);
        p.corner = {float(coordinate(1000)), -0.0f};
        p.right = {p.corner.x + float(1 + unit()), p.corner.y - float(unit())};
        p.down = {p.corner.x, p.corner.y + 1e10f};
        return p;
    }
    StrokePtr stroke(StrokeId id, quint32 segments, GroupId group)
    {
        auto s = std::make_shared<Stroke>();
        s->id = id;
        s->name = chance(2) ? QString() : QStringLiteral("line \"%1\" ü\u2028").arg(id);
        s->group = group;
        s->visible = chance(2);
        s->locked = chance(2);
        s->style = style();
        s->mix = chance(2) ? Mix{} : Mix{MixMode::Beta, float(unit())};
        if (chance(2))
            s->origin = {coordinate(1e10), 0.1};
        s->brush = chance(2) ? QString() : QStringLiteral("ink-wash");
        Offset at = point();
        const bool hasChains = chance(3), hasLift = chance(3);
        for (quint32 k = 0; k < segments; ++k) {
            const bool starts = hasChains && k > 0 && chance(4);
            s->segments.push_back(segment(starts && chance(2) ? point() : at));
            s->segments.back().start = starts;
            s->segments.back().lift = hasLift && chance(3);
            if (k % 2) // Each second one that would lift fades.
                std::swap(s->segments.back().lift, s->segments.back().fade);
            at = s->segments.back().bezier[3];
        }
        if (chance(3))
            s->fill = fill();
        if (chance(3))
            s->picture = picture();
        return s;
    }

    QRandomGenerator m_random;
};

} // namespace suffuse::test

#include "model/formats/suffuse/fill_columns.h"
#include "model/formats/suffuse/picture_columns.h"
#include "model/formats/suffuse/suffuse_predict.h"
#include "model/formats/suffuse/suffuse_strokes.h"

#include <algorithm>
#include <map>

namespace suffuse {

namespace {

/// Values that repeat, numbered in the order of their first use.
template <typename Value>
class Palette {
public:
    std::uint32_t place(const Value &value)
    {
        const auto [at, isNew] = m_places.try_emplace(value, std::uint32_t(m_values.size()));
        if (isNew)
            m_values.push_back(value);
        return at->second;
    }
    const std::vector<Value> &values() const { return m_values; }

private:
    std::map<Value, std::uint32_t> m_places;
    std::vector<Value> m_values;
};

using StyleBits = std::array<std::uint32_t, 4>; ///< kind, ξ1, ξ2, ξ3
using MixBits = std::array<std::uint32_t, 2>;   ///< mode, β

StyleBits bitsOf(const Style &s)
{
    return {std::uint32_t(s.kind), std::bit_cast<std::uint32_t>(s.xi[0]), std::bit_cast<std::uint32_t>(s.xi[1]),
            std::bit_cast<std::uint32_t>(s.xi[2])};
}

void addStarts(const std::vector<Segment> &segments, StrokeColumns &c)
{
    for (const Segment &s : segments) {
        c.starts.push_back(s.start);
        c.startsAt[0].push_back(s.start ? s.bezier[0].x : 0);
        c.startsAt[1].push_back(s.start ? s.bezier[0].y : 0);
    }
}

StrokeColumns columnsOf(const Stroke &stroke)
{
    StrokeColumns c;
    const auto &segments = stroke.segments;
    c.resize(segments.size());
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const Segment &s = segments[k];
        const Offset node = s.start && k > 0 ? segments[k - 1].bezier[3] : s.bezier[0];
        c.node[0][k] = node.x;
        c.node[1][k] = node.y;
        for (std::size_t h = 0; h < 2; ++h) {
            c.handle[h][0][k] = s.bezier[h + 1].x;
            c.handle[h][1][k] = s.bezier[h + 1].y;
        }
        for (std::size_t a = 0; a < StrokeColumns::attributeCount; ++a)
            c.attribute[a][k] = predictedNumbersOf<Segment>[a].of(s);
        c.born[k] = s.born;
    }
    if (!segments.empty()) {
        c.node[0].back() = segments.back().bezier[3].x;
        c.node[1].back() = segments.back().bezier[3].y;
    }
    if (std::ranges::any_of(segments, &Segment::start))
        addStarts(segments, c);
    return c;
}

bool fits(float value, int digits)
{
    return std::bit_cast<std::uint32_t>(dequantised(quantised(value, digits), digits)) ==
           std::bit_cast<std::uint32_t>(value);
}

/// The fewest decimals that give back every float bit for bit; −1 if seven are not enough.
int decimalsOf(std::initializer_list<std::span<const float>> columns)
{
    int digits = 0;
    for (bool raised = true; raised;) {
        // If a value needs more decimals, those before it must be checked again.
        raised = false;
        for (const auto &column : columns) {
            const auto misfit =
                std::find_if_not(column.begin(), column.end(), [&](float v) { return fits(v, digits); });
            if (misfit == column.end())
                continue;
            for (++digits; digits < 8 && !fits(*misfit, digits);)
                ++digits;
            if (digits == 8)
                return -1;
            raised = true;
        }
    }
    return digits;
}

std::uint32_t residual(float value, double prediction, int digits)
{
    return zigzag(std::uint32_t(quantised(value, digits)) - std::uint32_t(quantised(prediction, digits)));
}

/// The mode with the fewest bits in its residuals. `walk(predictor, code)` goes through a sample of the values.
template <typename Walk>
ColumnMode bestMode(int decimals, int predictors, Walk walk)
{
    ColumnMode best;
    std::uint64_t least = ~std::uint64_t(0);
    for (const int digits : {decimals, -1}) {
        for (int predictor = predictors == 4 ? 0 : 1; predictor < 4; ++predictor) {
            std::uint64_t bits = 0;
            walk(predictor, [&](float value, double prediction) {
                bits += std::uint64_t(std::bit_width(residual(value, prediction, digits)));
            });
            if (bits < least) {
                least = bits;
                best = {digits, predictor};
            }
        }
        if (decimals < 0)
            break;
    }
    return best;
}

/// So many segments of a stroke are enough to choose its modes.
constexpr std::size_t sampleSize = 16;

class StrokesWriter {
public:
    void add(const Stroke &stroke)
    {
        StrokeColumns c = columnsOf(stroke);
        addProperties(stroke);
        addNodes(c);
        addHandles(c);
        for (std::size_t a = 0; a < StrokeColumns::attributeCount; ++a)
            addAttribute(a, c.attribute[a]);
        for (const Microseconds t : c.born) {
            const std::uint64_t step = std::uint64_t(t) - m_bornBefore;
            m_born.push_back(zigzag64(step - m_bornStep));
            m_bornBefore = std::uint64_t(t);
            m_bornStep = step;
        }
        for (const Segment &s : stroke.segments)
            addRare(s);
        m_fills.add(stroke);
        m_pictures.add(stroke, [this](const QString &link) { return m_texts.place(link.toUtf8()); });
    }

    QByteArray bytes(Density &density) const
    {
        ColumnWriter out;
        out.putU32(std::uint32_t(m_count.size()));
        out.putU32(std::uint32_t(m_born.size()));
        out.putBlock(palettes(), density.blocks);
        out.put(m_id);
        out.put(m_count);
        out.put(m_flags);
        out.put(m_name);
        out.put(m_brush);
        out.put(m_group);
        out.put(m_style);
        out.put(m_mix);
        out.put(m_origin[0]);
        out.put(m_origin[1]);
        for (const auto &modes : m_modes)
            out.put(modes);
        out.put(m_node[0], density.segments);
        out.put(m_node[1]);
        for (const auto &axis : m_handle) {
            out.put(axis[0]);
            out.put(axis[1]);
        }
        for (const auto &attribute : m_attribute)
            out.put(attribute);
        out.put(m_born);
        out.put(m_ownStyle);
        out.put(m_nodeKind);
        m_plain.put(out);
        out.put(m_rewetCount);
        out.put(m_rewetTime, density.rewets);
        out.put(m_rewetExtra);
        if (m_marks.isUsed() || m_fills.isUsed() || m_pictures.isUsed() || m_later.isUsed()) {
            m_marks.put(out);
            out.put(m_start[0]);
            out.put(m_start[1]);
            if (m_fills.isUsed() || m_pictures.isUsed() || m_later.isUsed())
                m_fills.put(out);
            if (m_pictures.isUsed() || m_later.isUsed())
                m_pictures.put(out);
            m_later.putUsed(out);
        }
        return out.bytes();
    }

private:
    void addProperties(const Stroke &stroke)
    {
        m_id.push_back(stroke.id - m_idBefore - 1);
        m_idBefore = stroke.id;
        m_count.push_back(std::uint32_t(stroke.segments.size()));
        m_flags.push_back(std::uint8_t(stroke.visible | stroke.locked << 1));
        m_name.push_back(m_texts.place(stroke.name.toUtf8()));
        m_brush.push_back(m_texts.place(stroke.brush.toUtf8()));
        m_group.push_back(stroke.group);
        m_style.push_back(m_styles.place(bitsOf(stroke.style)));
        m_mix.push_back(m_mixes.place({std::uint32_t(stroke.mix.mode), std::bit_cast<std::uint32_t>(stroke.mix.beta)}));
        m_origin[0].push_back(std::bit_cast<std::uint64_t>(stroke.origin.x));
        m_origin[1].push_back(std::bit_cast<std::uint64_t>(stroke.origin.y));
    }

    void addNodes(StrokeColumns &c)
    {
        const std::size_t sample = std::min(c.node[0].size(), sampleSize);
        const int decimals = decimalsOf({c.node[0], c.node[1], c.startsAt[0], c.startsAt[1]});
        const ColumnMode mode = bestMode(decimals, 4, [&](int predictor, auto code) {
            for (auto &axis : c.node)
                walkSeries(std::span(axis).first(sample), 0, predictor, code);
        });
        m_modes[0].push_back(mode.toByte());
        for (std::size_t axis = 0; axis < 2; ++axis) {
            walkSeries(c.node[axis], 0, mode.predictor, [&](float value, double prediction) {
                m_node[axis].push_back(residual(value, prediction, mode.digits));
            });
            for (std::size_t k = 0; k < c.starts.size(); ++k)
                if (c.starts[k])
                    m_start[axis].push_back(residual(c.startsAt[axis][k], c.node[axis][k], mode.digits));
        }
    }

    void addHandles(StrokeColumns &c)
    {
        const std::size_t all = c.born.size(), sample = std::min(all, sampleSize);
        const auto walk = [&c](std::size_t count, std::size_t axis, int predictor, auto code) {
            walkHandles(c, axis, count, predictor, code);
        };
        const int decimals = decimalsOf({c.handle[0][0], c.handle[0][1], c.handle[1][0], c.handle[1][1]});
        const ColumnMode mode = bestMode(decimals, 4, [&](int predictor, auto code) {
            walk(sample, 0, predictor, code);
            walk(sample, 1, predictor, code);
        });
        m_modes[1].push_back(mode.toByte());
        for (std::size_t axis = 0; axis < 2; ++axis) {
            std::size_t which = 0;
            walk(all, axis, mode.predictor, [&](float value, double prediction) {
                m_handle[axis][which].push_back(residual(value, prediction, mode.digits));
                which ^= 1;
            });
        }
    }

    void addAttribute(std::size_t a, std::vector<float> &values)
    {
        float &carry = m_carry[a];
        const std::size_t sample = std::min(values.size(), sampleSize);
        const ColumnMode mode = bestMode(decimalsOf({values}), 3, [&](int predictor, auto code) {
            walkSeries(std::span(values).first(sample), carry, predictor, code);
        });
        m_modes[2 + a].push_back(mode.toByte());
        walkSeries(values, carry, mode.predictor, [&](float value, double prediction) {
            m_attribute[a].push_back(residual(value, prediction, mode.digits));
        });
        carry = values.empty() ? carry : values.back();
    }

    void addRare(const Segment &s)
    {
        m_ownStyle.push_back(s.style ? m_styles.place(bitsOf(*s.style)) + 1 : 0);
        m_nodeKind.push_back(std::uint8_t(s.node));
        m_plain.add(s);
        m_marks.add(s);
        m_later.add(s);
        m_rewetCount.push_back(std::uint32_t(s.rewet.size()));
        for (const Rewet &r : s.rewet) {
            m_rewetTime.push_back(zigzag64(std::uint64_t(r.time) - std::uint64_t(s.born)));
            m_rewetExtra.push_back(std::uint64_t(r.extra));
        }
    }

    QByteArray palettes() const
    {
        QByteArray out;
        appendVarint(out, m_texts.values().size());
        for (const QByteArray &text : m_texts.values()) {
            appendVarint(out, std::uint64_t(text.size()));
            out.append(text);
        }
        appendVarint(out, m_styles.values().size());
        for (const StyleBits &style : m_styles.values()) {
            for (const std::uint32_t word : style)
                appendU32(out, word);
        }
        appendVarint(out, m_mixes.values().size());
        for (const MixBits &mix : m_mixes.values()) {
            for (const std::uint32_t word : mix)
                appendU32(out, word);
        }
        return out;
    }

    template <typename T>
    using Column = std::vector<T>;

    Palette<QByteArray> m_texts;
    Palette<StyleBits> m_styles;
    Palette<MixBits> m_mixes;
    Column<std::uint64_t> m_id, m_group;
    std::array<Column<std::uint64_t>, 2> m_origin;
    Column<std::uint32_t> m_count, m_name, m_brush, m_style, m_mix;
    Column<std::uint8_t> m_flags, m_nodeKind;
    std::array<Column<std::uint8_t>, 2 + StrokeColumns::attributeCount> m_modes;
    std::array<Column<std::uint32_t>, 2> m_node;
    std::array<std::array<Column<std::uint32_t>, 2>, 2> m_handle; ///< [x, y][first, second]
    std::array<Column<std::uint32_t>, StrokeColumns::attributeCount> m_attribute;
    PlainColumns<Segment> m_plain;
    FlagColumn<Segment> m_marks;
    FillColumns m_fills;
    PictureColumns m_pictures;
    std::array<Column<std::uint32_t>, 2> m_start; ///< for the segments that begin another chain
    LaterColumns<Segment> m_later;
    Column<std::uint32_t> m_ownStyle, m_rewetCount;
    Column<std::uint64_t> m_born, m_rewetTime, m_rewetExtra;
    std::array<float, StrokeColumns::attributeCount> m_carry{};
    std::uint64_t m_idBefore = 0, m_bornBefore = 0, m_bornStep = 0;
};

} // namespace

QByteArray writeStrokes(std::span<const StrokePtr> strokes, Density &density)
{
    StrokesWriter writer;
    for (const StrokePtr &stroke : strokes)
        writer.add(*stroke);
    return writer.bytes(density);
}

} // namespace suffuse
